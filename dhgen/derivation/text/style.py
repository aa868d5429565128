"""How the parts of a formula look: as LaTeX for GitHub, and as plain text for a terminal."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from dhgen.derivation.text.formula import Symbol

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_LATEX_SIGNS = {
    "=": "=", "<": "<", ">": ">", "<=": r"\le", ">=": r"\ge", "!=": r"\ne", "->": r"\to",
    "in": r"\in",
}  # fmt: skip
_PLAIN_SIGNS = {"<=": "≤", ">=": "≥", "!=": "≠", "->": "→", "in": "∈"}


class Style(Protocol):
    """How the parts of a formula look; all operands are printed already."""

    @property
    def minus(self) -> str:
        """The sign."""
        ...

    def between(self, separator: str) -> str:
        """What is between formulas side by side: a comma, or a semicolon behind a space."""
        ...

    @property
    def room(self) -> str:
        """The space between factors of which one is a name of several letters."""
        ...

    @property
    def any_entry(self) -> str:
        """The sign for an entry of a matrix that does not matter."""
        ...

    @property
    def slanted(self) -> bool:
        """Whether a fraction is in one line, so that its parts need parentheses."""
        ...

    def symbol(self, symbol: Symbol) -> str:
        """A letter with its index."""
        ...

    def sign(self, sign: str) -> str:
        """A relation sign."""
        ...

    def power(self, base: str, exponent: int) -> str:
        """A power."""
        ...

    def quotient(self, above: str, below: str) -> str:
        """A fraction; both parts are enclosed already where the style needs it."""
        ...

    def root(self, operand: str) -> str:
        """A square root."""
        ...

    def size(self, operand: str) -> str:
        """An absolute value."""
        ...

    def function(self, name: str) -> str:
        """The name of a function."""
        ...

    def enclosed(self, operand: str, *, tall: bool) -> str:
        """Parentheses."""
        ...

    def matrix(self, rows: list[list[str]], separator: str) -> str:
        """A matrix in one line; what is between entries matters where nothing aligns them."""
        ...


@dataclass(frozen=True, slots=True)
class Latex:
    """LaTeX as GitHub's MathJax reads it."""

    minus: str = "-"
    room: str = r" \thinspace "
    any_entry: str = r"\cdot"
    slanted: bool = False

    def between(self, separator: str) -> str:
        """What is between formulas side by side; a space has to be written as one."""
        return separator.replace(" ", r" \thinspace ") + r"\quad "

    def symbol(self, symbol: Symbol) -> str:
        """A letter with its index."""
        return symbol.latex

    def sign(self, sign: str) -> str:
        """A relation sign."""
        return _LATEX_SIGNS[sign]

    def power(self, base: str, exponent: int) -> str:
        """A power."""
        return f"{base}^{exponent}" if 0 <= exponent <= 9 else f"{base}^{{{exponent}}}"

    def quotient(self, above: str, below: str) -> str:
        """A fraction."""
        return rf"\frac{{{above}}}{{{below}}}"

    def root(self, operand: str) -> str:
        """A square root."""
        return rf"\sqrt{{{operand}}}"

    def size(self, operand: str) -> str:
        """An absolute value; a bare stroke would end a cell of a table."""
        return rf"\lvert {operand} \rvert"

    def function(self, name: str) -> str:
        """The name of a function; GitHub refuses formulas with operatorname in them."""
        return rf"\mathrm{{{name}}}"

    def enclosed(self, operand: str, *, tall: bool) -> str:
        """Parentheses."""
        return rf"\left({operand}\right)" if tall else f"({operand})"

    def matrix(self, rows: list[list[str]], separator: str) -> str:
        """A matrix in one line, which LaTeX sets in columns."""
        del separator
        body = r" \\ ".join(" & ".join(row) for row in rows)
        return rf"\begin{{bmatrix}} {body} \end{{bmatrix}}"


@dataclass(frozen=True, slots=True)
class Plain:
    """Unicode for a terminal."""

    minus: str = "−"
    room: str = " "
    any_entry: str = "·"
    slanted: bool = True

    def between(self, separator: str) -> str:
        """What is between formulas side by side."""
        return f"{separator} "

    def symbol(self, symbol: Symbol) -> str:
        """A letter with its index."""
        return symbol.text

    def sign(self, sign: str) -> str:
        """A relation sign."""
        return _PLAIN_SIGNS.get(sign, sign)

    def power(self, base: str, exponent: int) -> str:
        """A power."""
        return base + str(exponent).translate(_SUPERSCRIPTS)

    def quotient(self, above: str, below: str) -> str:
        """A fraction."""
        return f"{above}/{below}"

    def root(self, operand: str) -> str:
        """A square root."""
        return f"√({operand})" if len(operand) > 1 else f"√{operand}"

    def size(self, operand: str) -> str:
        """An absolute value."""
        return f"|{operand}|"

    def function(self, name: str) -> str:
        """The name of a function."""
        return name

    def enclosed(self, operand: str, *, tall: bool) -> str:
        """Parentheses."""
        del tall
        return f"({operand})"

    def matrix(self, rows: list[list[str]], separator: str) -> str:
        """A matrix in one line: rows are between semicolons, or two where entries have one."""
        between = "; " if separator == "," else f"{separator}; "
        return "[" + between.join(self.between(separator).join(row) for row in rows) + "]"


LATEX: Style = Latex()
PLAIN: Style = Plain()
