"""Long formulas broken into lines: at relation signs first, then before plus and minus signs.

Widths are counted in the plain style, which is about what a formula takes on a page.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.text.formula import (
    Call,
    Listing,
    Minus,
    Product,
    Quotient,
    Relation,
    Sum,
    is_function,
)
from dhgen.targets.derivation.text.show import is_tall, show, show_factor, signed_terms
from dhgen.targets.derivation.text.style import PLAIN

if TYPE_CHECKING:
    from dhgen.targets.derivation.text.formula import Formula
    from dhgen.targets.derivation.text.style import Style

WIDTH = 100  # visible characters of a line
INDENT = 4
SHORT = 10  # visible characters that may follow a long side on its line
BREAKS_TALL = 75  # visible characters of a product from which even tall brackets are broken


def width(formula: Formula) -> int:
    """Visible characters of a formula in one line."""
    return len(show(formula, PLAIN))


def laid_out(formulas: tuple[Formula, ...], style: Style) -> list[tuple[str, str]]:
    """The lines of formulas one below the other, aligned when no first side is too long for it."""
    lines = [line for formula in formulas for line in broken(formula, style)]
    if not any(_is_long(formula) for formula in formulas):
        return lines
    return [("", f"{left} {right}" if left else right) for left, right in lines]


def _is_long(formula: Formula) -> bool:
    return isinstance(formula, Relation) and width(formula.sides[0]) + 3 > WIDTH // 2


def broken(formula: Formula, style: Style) -> list[tuple[str, str]]:
    """The lines of a formula, each as what stands left and right of the point of alignment."""
    if not isinstance(formula, Relation):
        return [("", line) for line in filled(formula, style, WIDTH)]
    first = formula.sides[0]
    left = show(first, style)
    start = width(first) + 3
    if _is_long(formula):
        head = filled(first, style, WIDTH)
        lines = [("", line) for line in head]
        start = INDENT
        rest = _joined(formula, start, style)
        if len(rest) == 1 and len(_joined(formula, start, PLAIN)[0]) <= SHORT:
            lines[-1] = ("", f"{lines[-1][1]} {rest[0]}")
            return lines
        return [*lines, *(("", line) for line in rest)]
    pending = _joined(formula, start, style)
    return [(left if place == 0 else "", line) for place, line in enumerate(pending)]


def _joined(formula: Relation, start: int, style: Style) -> list[str]:
    """The sides after the first: on one line as long as they fit, else one below the other."""
    rest = formula.sides[1:]
    if start + sum(width(side) + 3 for side in rest) <= WIDTH:
        parts = (
            f"{style.sign(sign)} {show(side, style)}"
            for sign, side in zip(formula.signs, rest, strict=True)
        )
        return [" ".join(parts)]
    lines: list[str] = []
    for sign, side in zip(formula.signs, rest, strict=True):
        pieces = filled(side, style, WIDTH - min(start, WIDTH // 2))
        lines.append(f"{style.sign(sign)} {pieces[0]}")
        lines += pieces[1:]
    return lines


def filled(formula: Formula, style: Style, room: int) -> list[str]:
    """A formula in as many lines as it needs; lines after the first are indented."""
    shown, plain = _pieces(formula, style), _pieces(formula, PLAIN)
    lines: list[str] = []
    used = 0
    for piece, visible in zip(shown, plain, strict=True):
        if lines and used + len(visible) <= room:
            lines[-1] += piece
            used += len(visible)
        else:
            indent = "" if not lines else r"\quad " if style is not PLAIN else " " * INDENT
            lines.append(indent + piece.lstrip() if lines else piece)
            used = len(visible) + (INDENT if len(lines) > 1 else 0)
    return lines


def _pieces(formula: Formula, style: Style) -> list[str]:
    """Parts between which a line may end; joined they are the formula."""
    match formula:
        case Sum(terms) if len(terms) > 1:
            return _sum_pieces(terms, style)
        case Minus(operand):
            first, *rest = _pieces(operand, style)
            if isinstance(operand, Sum):
                return _enclosed(f"{style.minus}(", [first, *rest], ")")
            return [style.minus + first, *rest]
        case Quotient(over, under) if width(over) > WIDTH:
            below = show(under, style)
            below = f"({below})" if isinstance(under, Sum | Product) else below
            return _enclosed("(", _pieces(over, style), f")/{below}")
        case Product(factors) if (place := _last_sum(factors)) is not None and (
            not is_tall(factors[place]) or width(formula) > BREAKS_TALL
        ):
            before = "".join(f"{show_factor(f, style)} " for f in factors[:place])
            after = "".join(f" {show(f, style)}" for f in factors[place + 1 :])
            return _enclosed(f"{before}(", _pieces(factors[place], style), f"){after}")
        case Call(function, arguments) if not any(map(is_tall, arguments)):
            parts: list[str] = []
            for argument in arguments:
                first, *rest = _pieces(argument, style)
                opening = f"{style.function(function)}(" if not parts else " "
                parts += [opening + first, *rest]
                parts[-1] += ","
            parts[-1] = parts[-1][:-1] + ")"
            return parts
        case Listing(items):
            shown = [show(item, style) for item in items]
            return [item + style.comma for item in shown[:-1]] + shown[-1:]
        case _:
            return [show(formula, style)]


def _last_sum(factors: tuple[Formula, ...]) -> int | None:
    """The place of the factor that is broken: a sum with nothing but functions behind it."""
    place = max((i for i, factor in enumerate(factors) if not is_function(factor)), default=0)
    return place if isinstance(factors[place], Sum) else None


def _sum_pieces(terms: tuple[Formula, ...], style: Style) -> list[str]:
    parts: list[str] = []
    for term, text in zip(terms, signed_terms(terms, style), strict=True):
        inner = term.operand if isinstance(term, Minus) else term
        pieces, whole = _pieces(inner, style), show(inner, style)
        if len(pieces) > 1 and text.endswith(whole):
            parts += [text[: -len(whole)] + pieces[0], *pieces[1:]]
        else:
            parts.append(text)
    return parts


def _enclosed(opening: str, pieces: list[str], closing: str) -> list[str]:
    first, *rest = pieces
    parts = [opening + first, *rest]
    parts[-1] += closing
    return parts
