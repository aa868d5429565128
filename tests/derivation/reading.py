"""A reader of the printed formulas: LaTeX as text, and what a formula is worth.

It knows nothing of the objects that the texts are made from: letters, numbers, signs, what stands
above and below, and how people read products.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

Value = Any  # a number or a matrix
Lookup = Callable[[str], Value]  # KeyError for what has no value
Node = tuple[Any, ...]
Nodes = list[Node]

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "theta": "θ", "varepsilon": "ε",
    "lambda": "λ", "mu": "μ", "pi": "π", "varphi": "φ", "psi": "ψ", "rho": "ρ", "sigma": "σ",
    "tau": "τ", "eta": "η", "Delta": "Δ", "ell": "ℓ", "circ": "°",
}  # fmt: skip
SIGNS = {"times": "×", "cdot": "·", "lVert": "‖", "rVert": "‖", "cdots": "…", "sum": "∑"}
SIGNS |= {"ne": "≠", "le": "≤", "ge": "≥", "approx": "≈", "pm": "±", "mp": "∓"}
TOKENS = re.compile(
    r"\\begin\{(?:b|p)matrix\}|\\end\{(?:b|p)matrix\}|\\(?:mathrm|mathit|mathbf|text)\{([^}]*)\}"
    r"|\\([a-zA-Z]+)|\\\\|\\(.)|(\d+(?:(?:\.|\{,\})\d+)?)|(\S)"
)
PLUS, MINUS = ("op", "+"), ("op", "-")
ACCENTS = {"hat": "^", "dot": "˙", "vec": "→"}


def of_latex(text: str) -> Nodes:
    """A formula's nodes."""
    nodes, rest = _row(list(TOKENS.finditer(text)), 0, "")
    assert rest == len(list(TOKENS.finditer(text))), text
    return nodes


def _row(tokens: list[re.Match[str]], at: int, end: str) -> tuple[Nodes, int]:
    """Nodes up to a token, which is passed."""
    nodes: Nodes = []
    while at < len(tokens) and tokens[at][0] != end:
        node, at = _unit(tokens, at)
        if node[0] in {"sub", "sup"} and nodes:
            node = (node[0], nodes.pop(), node[1])
        if node == ("op", "'"):
            node = primed(nodes.pop())
        if node[0] != "skip":
            nodes.append(node)
    return grouped(nodes), at + bool(end)


def grouped(nodes: Nodes) -> Nodes:
    """Nodes in which a power of parentheses is one of all that is in them."""
    found: Nodes = []
    for node in nodes:
        if node[0] != "sup" or node[1] != ("op", ")"):
            found.append(node)
            continue
        depth, start = 1, len(found)
        while depth:
            start -= 1
            depth += (found[start] == ("op", ")")) - (found[start] == ("op", "("))
        found[start:] = [("sup", ("row", found[start + 1 :]), node[2])]
    return found


def primed(node: Node) -> Node:
    """A letter with a prime."""
    return ("sub", primed(node[1]), node[2]) if node[0] == "sub" else ("id", f"{node[1]}′")


def _unit(tokens: list[re.Match[str]], at: int) -> tuple[Node, int]:
    token = tokens[at]
    named, command, escaped, number, sign = token.groups()
    if named is not None:
        return ("id", named), at + 1
    if number is not None:
        return ("num", float(number.replace("{,}", "."))), at + 1
    if token[0].endswith("matrix}"):
        return _matrix(tokens, at + 1)
    if sign == "{":
        inside, at = _row(tokens, at + 1, "}")
        return ("row", inside), at
    if sign in {"_", "^"}:
        inside, at = _argument(tokens, at + 1)
        return ("sub" if sign == "_" else "sup", inside), at
    if command is not None:
        return _command(command, tokens, at + 1)
    if escaped is not None or sign is None:
        return ("skip",), at + 1
    return (("id", sign) if sign.isalpha() else ("op", sign)), at + 1


def _command(command: str, tokens: list[re.Match[str]], at: int) -> tuple[Node, int]:
    if command == "frac":
        above, at = _argument(tokens, at)
        below, at = _argument(tokens, at)
        return ("frac", above, below), at
    if command == "sqrt":
        inside, at = _argument(tokens, at)
        return ("sqrt", inside), at
    if command in ACCENTS:
        inside, at = _argument(tokens, at)
        return ("id", spelt(inside) + ACCENTS[command]), at
    if command in {"left", "right", "thinspace"}:
        return ("skip",), at
    if command in {"quad", "qquad"}:
        return ("space",), at
    if command in SIGNS:
        return ("op", SIGNS[command]), at
    return ("id", GREEK.get(command, command)), at


def _argument(tokens: list[re.Match[str]], at: int) -> tuple[Nodes, int]:
    node, at = _unit(tokens, at)
    return (node[1] if node[0] == "row" else [node]), at


def _matrix(tokens: list[re.Match[str]], at: int) -> tuple[Node, int]:
    rows: list[list[Nodes]] = [[[]]]
    while not tokens[at][0].endswith("matrix}"):
        if tokens[at][0] in {"&", "\\\\"}:
            rows[-1].append([]) if tokens[at][0] == "&" else rows.append([[]])
            at += 1
            continue
        node, at = _unit(tokens, at)
        if node[0] in {"sub", "sup"}:
            node = (node[0], rows[-1][-1].pop(), node[1])
        rows[-1][-1].append(node)
    return ("matrix", rows), at + 1


def spelt(nodes: Nodes) -> str:
    """An index, or the name of a letter, as it is read."""
    return "".join(_spelt_one(node) for node in nodes)


def _spelt_one(node: Node) -> str:
    match node:
        case ("num", value):
            return f"{value:g}"
        case ("id" | "op", text):
            return str(text).replace("−", "-")
        case ("sub", base, index):
            return f"{_spelt_one(base)}_{spelt(index)}"
        case ("sup", base, index):
            return f"{_spelt_one(base)}^{spelt(index)}"
        case ("row", inside):
            return spelt(inside)
        case _:
            return ""


def relations_in(nodes: Nodes) -> Iterator[tuple[list[Nodes], list[str]]]:
    """Equations and inequalities that stand beside each other: their sides, and the signs."""
    for listed in _split(nodes, lambda node: node == ("space",)):
        body = listed[:-1] if listed and listed[-1] == ("op", ",") else listed
        signs = [node[1] for node in body if node[0] == "op" and node[1] in "=<>≠≤≥≈"]
        sides = list(_split(body, lambda n: n[0] == "op" and n[1] in "=<>≠≤≥≈"))
        if signs and all(sides):
            yield sides, signs


def _split(nodes: Nodes, separates: Callable[[Node], bool]) -> Iterator[Nodes]:
    part: Nodes = []
    for node in nodes:
        if separates(node):
            yield part
            part = []
        else:
            part.append(node)
    yield part


def name_of(side: Nodes) -> str | None:
    """The letter that a side consists of."""
    if len(side) == 1 and side[0][0] in {"id", "sub"}:
        return _spelt_one(side[0])
    return None


def worth(nodes: Nodes, letters: Lookup) -> Value:
    """The value of a side; KeyError where a letter has none."""
    value, rest = _sum(nodes, 0, letters)
    if rest != len(nodes):
        raise KeyError(spelt(nodes[rest:]))
    return value


def _sum(nodes: Nodes, at: int, letters: Lookup) -> tuple[Value, int]:
    total: Value = None
    while at < len(nodes):
        sign = 1.0
        if nodes[at] in (PLUS, MINUS):
            sign = -1.0 if nodes[at] == MINUS else 1.0
            at += 1
        elif total is not None:
            break
        value, at = _product(nodes, at, letters)
        total = sign * value if total is None else total + sign * value
        if at < len(nodes) and nodes[at][0] == "op" and nodes[at][1] in "),]|‖":
            break
    return total, at


def _product(nodes: Nodes, at: int, letters: Lookup) -> tuple[Value, int]:
    result: Value = None
    while at < len(nodes) and not (nodes[at][0] == "op" and nodes[at][1] in "+-),]|=‖"):
        if nodes[at] == ("op", "·"):
            at += 1
            continue
        if result is not None and nodes[at] == ("op", "/"):
            value, at = _factor(nodes, at + 1, letters)
            result = result / value
            continue
        value, at = _factor(nodes, at, letters)
        matrices = isinstance(result, np.ndarray) and isinstance(value, np.ndarray)
        result = value if result is None else result @ value if matrices else result * value
    if result is None:
        raise KeyError(spelt(nodes[at:]))
    return result, at


def _factor(nodes: Nodes, at: int, letters: Lookup) -> tuple[Value, int]:
    value, at = _plain_factor(nodes, at, letters)
    if at < len(nodes) and nodes[at] == ("op", "["):  # an element of a matrix
        end = nodes.index(("op", "]"), at)
        row, column = (int(part[0][1]) for part in _split(nodes[at + 1 : end], _is_comma))
        return value[row - 1, column - 1], end + 1
    return value, at


def _is_comma(node: Node) -> bool:
    return node == ("op", ",")


FUNCTIONS: dict[str, Callable[..., float]] = {
    "atan2": math.atan2,
    "sgn": lambda x: math.copysign(1.0, x),
}
CIRCULAR = {"cos": math.cos, "sin": math.sin, "tan": math.tan}


def _plain_factor(nodes: Nodes, at: int, letters: Lookup) -> tuple[Value, int]:
    match nodes[at]:
        case ("num", value):
            return value, at + 1
        case ("op", "("):
            value, at = _sum(nodes, at + 1, letters)
            _demand(nodes, at, ")")
            return value, at + 1
        case ("op", "|"):
            value, at = _sum(nodes, at + 1, letters)
            _demand(nodes, at, "|")
            return abs(value), at + 1
        case ("op", "["):  # round what MathML has as a table
            value, at = _plain_factor(nodes, at + 1, letters)
            _demand(nodes, at, "]")
            return value, at + 1
        case ("id", name) if name in FUNCTIONS:
            _demand(nodes, at + 1, "(")
            given, at = [], at + 1
            while nodes[at] != ("op", ")"):
                value, at = _sum(nodes, at + 1, letters)
                given.append(value)
            return FUNCTIONS[name](*given), at + 1
        case ("id", name) if name in CIRCULAR:
            value, at = _plain_factor(nodes, at + 1, letters)
            return CIRCULAR[name](value), at
        case ("sup", ("id", name), index) if name in CIRCULAR:
            value, at = _plain_factor(nodes, at + 1, letters)
            return CIRCULAR[name](value) ** int(spelt(index)), at
        case node:
            return _alone(node, letters), at + 1


def _demand(nodes: Nodes, at: int, sign: str) -> None:
    if at >= len(nodes) or nodes[at] != ("op", sign):
        raise KeyError(sign)


def _alone(node: Node, letters: Lookup) -> Value:
    match node:
        case ("id", _) | ("sub", _, _):
            return letters(_spelt_one(node))
        case ("frac", above, below):
            return worth(above, letters) / worth(below, letters)
        case ("sqrt", inside):
            return math.sqrt(max(worth(inside, letters), 0.0))
        case ("row", inside):
            return worth(inside, letters)
        case ("matrix", rows):
            return np.array([[worth(cell, letters) for cell in row] for row in rows])
        case ("sup", base, index):
            return _power(base, spelt(index), letters)
        case _:
            raise KeyError(_spelt_one(node))


def _power(base: Node, index: str, letters: Lookup) -> Value:
    try:
        return letters(f"{_spelt_one(base)}^{index}")  # T_1^0
    except KeyError:
        pass
    if index == "°":
        return math.radians(_alone_or_number(base, letters))
    value = _alone_or_number(base, letters)
    if index == "-1" and isinstance(value, np.ndarray):
        return np.linalg.inv(value)
    if not re.fullmatch(r"-?\d+", index):
        raise KeyError(index)
    return value ** int(index)


def _alone_or_number(node: Node, letters: Lookup) -> Value:
    return node[1] if node[0] == "num" else _alone(node, letters)
