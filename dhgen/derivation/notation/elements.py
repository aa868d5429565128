"""What the place of an equation is called on paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import left_name
from dhgen.derivation.text.formula import Element, Formula, Symbol
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import LATEX, PLAIN
from dhgen.paul.equation import MOMENT

if TYPE_CHECKING:
    from dhgen.paul.equation import Origin


def element_of(origin: Origin) -> Formula:
    """U_1[2,4], the squared length of a column 4, or an element of column 3 x column 4."""
    name = left_name(origin.matrix, origin.dof)
    latex, plain = show(name, LATEX), show(name, PLAIN)
    if origin.row == 0:
        return Symbol(rf"\lVert {latex}[\cdot,4] \rVert^2", f"‖{plain}[·,4]‖²")
    if origin.column == MOMENT:
        return Symbol(
            rf"({latex}[\cdot,3] \times {latex}[\cdot,4])[{origin.row}]",
            f"({plain}[·,3] × {plain}[·,4])[{origin.row}]",
        )
    return Element(name, origin.row, origin.column)
