"""C of regular poses with one lane a pose: branches written out, or in loops where that is long."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from dhgen.program.ir import Heading, Let, Variable
from dhgen.program.regular.flatten import MINUS
from dhgen.program.walk import names_in
from dhgen.targets.c.declared import dense
from dhgen.targets.c.irregular import irregularity_wide
from dhgen.targets.c.lanes import LaneText
from dhgen.targets.c.language import C
from dhgen.targets.c.shared import NOTHING_SHARED, depth_of
from dhgen.targets.layout import INDENT, packed, wrapped

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.program.ir import Expression, Statement
    from dhgen.program.regular.flatten import Flat
    from dhgen.targets.c.declared import Declaration
    from dhgen.targets.c.shared import Shared
    from dhgen.targets.module import SolverModule


def wide_lines(
    module: SolverModule,
    flat: Flat,
    entries: Sequence[str],
    shared: Shared = NOTHING_SHARED,
    *,
    unrolled: bool = False,
    stride: int | None = None,
) -> list[str]:
    """The body of the function, its lanes' signs in loops.

    Args:
        module: The robot.
        flat: Its program for regular poses.
        entries: Lines that name the pose's entries.
        shared: What it computes as other functions do.
        unrolled: Whether compilers are asked to unroll the loops.
        stride: How many values there is room for in a row; as many as it has if it is not given.
    """
    written = _Wide(module, flat, shared, "DHGEN_UNROLLED " if unrolled else "")
    written.stride = stride or flat.joints
    return written.lines(entries)


def row_of(module: SolverModule, signs: dict[int, int]) -> int:
    """The number of the row where the axes have these signs."""
    row = 0
    for axis in range(len(module.solver.axes)):
        row = 2 * row + (signs.get(axis) == MINUS)
    return row


def lets(statements: Iterable[Statement], text: LaneText, indent: str = INDENT) -> list[str]:
    """Values under their headings."""
    sections: list[tuple[str, list[Declaration]]] = [("", [])]
    for statement in statements:
        if isinstance(statement, Heading):
            sections.append((C().comment(statement.text, indent), []))
        elif isinstance(statement, Let):
            sections[-1][1].append(text.let(statement))
    lines: list[str] = []
    for heading, values in sections:
        if heading and values:
            lines += ["", heading]
        lines += dense(values, indent)
    return lines


class _Wide:
    """The function's text, with each value in the innermost loop that it needs."""

    def __init__(self, module: SolverModule, flat: Flat, shared: Shared, unrolled: str) -> None:
        self._module = module
        self._unrolled = unrolled
        self._flat = flat
        self.stride = flat.joints
        self._text = LaneText("wide", flat.program, wide=True)
        for axis in flat.program.axes:
            self._text.declare(axis.name, lanes=False)
        needed = _needed_once(flat).items()
        self._at_once = {each: let for each, let in needed if let.name not in shared.names}
        self._shared = shared
        for name in shared.names:
            self._text.declare(name, lanes=name not in shared.signs)

    def lines(self, entries: Sequence[str]) -> list[str]:
        irregular = f"{irregularity_wide(self._module)} <= DHGEN_ORTHONORMAL"
        if not self._flat.lanes:
            lines = [*entries, *self._body(0, INDENT), "", *self._rows(INDENT)]
            lines += wrapped(f"{INDENT}const dhgen_wide_mask exact = {irregular};", INDENT)
            doubts = [f"({self._text.text(doubt).text})" for doubt in self._flat.doubts]
            left = " | ".join(["(exact == 0)", *doubts])
            return [*lines, *wrapped(f"{INDENT}return {left};", INDENT)]
        begin = wrapped(f"{INDENT}dhgen_wide_mask left = ({irregular}) == 0;", INDENT)
        end = f"{INDENT}return left;"
        if self._flat.fits:
            begin.append(f"{INDENT}dhgen_wide_mask exact = left ^ left, near = exact;")
            end = f"{INDENT}return left | (near & (exact == 0));"
        return [*entries, *begin, *self._loops(0, INDENT), end]

    def _loops(self, depth: int, indent: str) -> list[str]:
        """What is in so many loops."""
        flat = self._flat
        lines = self._body(depth, indent)
        if depth == len(flat.lanes):
            lines += [f"{indent}const int row = {self._row()};", *self._rows(indent)]
        for doubt in flat.doubts:
            if self._depth(names_in(doubt)) == depth:
                text = self._text.mask(doubt)
                lines += wrapped(f"{indent}left |= {text};", indent)
        for fit, name in zip(flat.fits, ("exact", "near"), strict=False):
            if self._depth(names_in(fit)) == depth:
                lines += wrapped(f"{indent}{name} |= {self._text.mask(fit)};", indent)
        if depth < len(flat.lanes):
            i, axis = f"i{depth + 1}", flat.program.axes[depth]
            meaning = ", ".join(axis.words)
            lines += [
                "",
                f"{indent}{self._unrolled}for (int {i} = 0; {i} < 2; {i}++) {{ /* {meaning} */",
                f"{indent}    const double {axis.name} = {i} == 0 ? 1.0 : -1.0;",
                *self._loops(depth + 1, indent + INDENT),
                f"{indent}}}",
            ]
        return lines

    def _row(self) -> str:
        """The first row of the signs at hand."""
        strides = (row_of(self._module, {axis: MINUS}) for axis in self._flat.lanes)
        places = ((stride, f"i{place + 1}") for place, stride in enumerate(strides))
        return " + ".join(i if stride == 1 else f"{stride} * {i}" for stride, i in places)

    def _body(self, depth: int, indent: str) -> list[str]:
        """The values of a depth."""
        elsewhere = self._shared.names | {let.name for let in self._at_once.values()}
        body = [
            each
            for each in self._flat.program.body
            if not isinstance(each, Let) or (each.name not in elsewhere and depth_of(each) == depth)
        ]
        return [
            *self._shared.stated(depth, "wide", "double", indent),
            *lets(body, self._text, indent),
        ]

    def _depth(self, names: set[str]) -> int:
        """The loop that values and signs need."""
        program = self._flat.program
        lets = (each for each in program.body if isinstance(each, Let) and each.name in names)
        signs = (k + 1 for k, axis in enumerate(program.axes) if axis.name in names)
        return max([*map(depth_of, lets), *signs], default=0)

    def _rows(self, indent: str) -> list[str]:
        """Joint values, and what they are."""
        flat, text, size = self._flat, self._text, self.stride
        lines: list[str] = []
        for place, (choice, group) in enumerate(zip(flat.choices, flat.groups, strict=True)):
            row = row_of(self._module, dict(zip(flat.unrolled, choice, strict=True)))
            q = [self._place("q", size, size * row + k) for k in range(flat.joints)]
            values = map(text.vector, map(self._written, group))
            pieces = [f"{q[k]} = {value};" for k, value in enumerate(values)]
            lines += packed(pieces, indent)
            kind = f"dhgen_kind_wide({q[0]})"
            if flat.limited:
                outside = text.mask(self._written(flat.outside[place]))
                kind = f"dhgen_kind_within_wide({q[0]}, {outside})"
            lines += wrapped(f"{indent}{self._place('kind', 1, row)} = {kind};", indent)
        return lines

    def _place(self, array: str, size: int, first: int) -> str:
        """An entry of an array that has so many for a row."""
        if not self._flat.lanes:
            return f"{array}[{first}]"
        row = "row" if size == 1 else f"{size} * row"
        return f"{array}[{row} + {first}]" if first else f"{array}[{row}]"

    def _written(self, expression: Expression) -> Expression:
        let = self._at_once.get(expression)
        return expression if let is None else let.expression


def _needed_once(flat: Flat) -> dict[Expression, Let]:
    """What only one row needs: it is written where it belongs as soon as it is known."""
    lets = [statement for statement in flat.program.body if isinstance(statement, Let)]
    outputs = flat.program.outputs
    composed = [output for output in outputs if not isinstance(output, Variable)]
    elsewhere = names_in(*composed, *(let.expression for let in lets))
    needed = Counter(outputs)
    written = [*(each for group in flat.groups for each in group), *flat.outside]
    joints = {each for each in written if needed[each] == 1}
    return {
        Variable(let.name): let
        for let in lets
        if Variable(let.name) in joints and let.name not in elsewhere
    }
