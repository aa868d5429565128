"""The cells of a file as expressions: lengths, angles and plain numbers, each with its snapping."""

from __future__ import annotations

import math
import re
from itertools import pairwise
from typing import TYPE_CHECKING, Literal

from dhgen.robot.angles import (
    LARGEST_ANGLE,
    LARGEST_LENGTH,
    SINGLE,
    SLIP,
    SNAP,
    exact_angle,
    has_all_digits,
    near_cosine,
    near_exact,
    near_right_angle,
    twelfths,
    unit_notice,
)
from dhgen.robot.arithmetic import parse
from dhgen.robot.cell_notes import ManyTurns, NearCell, PlainLimit, Taken, UsedNames, taken
from dhgen.robot.exact import canonical, rational
from dhgen.robot.expression import (
    ZERO,
    Expression,
    Name,
    evaluate,
)
from dhgen.robot.lengths import Length
from dhgen.robot.names import RESERVED
from dhgen.robot.source import quoted
from dhgen.robot.tokens import CellError, UnknownNameError, circle_through
from dhgen.robot.units import SaidUnits

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from fractions import Fraction

    from dhgen.robot.reader import Path
    from dhgen.robot.report import Report

# The value of a wrong cell: that is reported, and its value NaN entails no further mistakes.
INVALID = Name("?")


class Cells:
    """Reads cells, with the parameters of the file and its unit of angles."""

    def __init__(self, report: Report) -> None:
        self.report = report
        self._values: dict[str, float] = {INVALID.name: math.nan}
        self._later: dict[str, str] = {}
        self._circles: set[frozenset[str]] = set()
        self.units = SaidUnits(self.value)
        self.ratios: dict[str, Fraction] = {}
        self.used = UsedNames()
        self.lengths: list[Length] = []
        self.taken: list[Taken] = []
        self.snapped: list[NearCell] = []
        self.slips: list[NearCell] = []
        self.many_turns: list[ManyTurns] = []
        self.limits_in_degrees: list[PlainLimit] = []

    def announce(self, parameters: Mapping[str, str]) -> None:
        """Which parameters there will be, for the messages about cells that use them too early."""
        self._later.update(parameters)

    def define(self, name: str, expression: Expression) -> float:
        """Make a parameter known to all cells that are read from now on."""
        value = self.value(expression)
        if name not in RESERVED:  # has its own meaning all the same
            self._values[name] = value
        self.units.define(name, expression)
        if (ratio := rational(expression, self.ratios)) is not None:
            self.ratios[name] = ratio
        return value

    def knows(self, name: str) -> bool:
        """Whether a parameter of this name has been read."""
        return name in self._values

    def value(self, expression: Expression) -> float:
        """The value of an expression that `parse` accepted; NaN for INVALID."""
        return evaluate(expression, self._values)

    def parse(
        self, path: Path, text: str, *, more: Mapping[str, float] | None = None
    ) -> Expression:
        """A cell as written; INVALID after a mistake, which is reported.

        Args:
            path: The place of the cell.
            text: Its text.
            more: Further names that may occur, with their values.
        """
        known = {name: value for name, value in self._values.items() if name != INVALID.name}
        try:
            expression = parse(text, {**known, **(more or {})})
        except CellError as error:
            message: str | None = error.message
            if isinstance(error, UnknownNameError) and error.name in self._later:
                message = self._too_early(path, error.name)
            if message is not None:
                self.report.error(path, message, part=error.span)
            return INVALID
        self.used.note(path, expression)
        for notice in self.units.argument_notices(expression):
            self.report.notice(path, notice)
        return expression

    def _too_early(self, path: Path, name: str) -> str | None:
        """The mistake of a cell that uses a parameter before it is known; of a circle once."""
        if path[-1] == name:
            return f"the parameter '{name}' is defined by itself"
        circle = circle_through(str(path[-1]), name, self._later)
        if not circle:
            return f"the parameter '{name}' is defined further down: move it up"
        if frozenset(circle) in self._circles:
            return None
        self._circles.add(frozenset(circle))
        links = ", ".join(f"{a} by {b}" for a, b in pairwise((*circle, circle[0])))
        return f"these parameters are defined by each other: {links}; give one of them a number"

    def length(self, path: Path, text: str) -> Expression:
        """A length; next to nothing is 0."""
        return self.snap_length(path, text, self.parse(path, text))

    def angle(self, path: Path, text: str) -> Expression:
        """An angle in radians; a multiple of pi/12 is exact."""
        return self.snap_angle(path, text, self.radians(self.parse(path, text)))

    def ratio(self, path: Path, text: str) -> Expression:
        """An entry of a rotation or of a direction; the cosine of an exact angle is exact."""
        return self.snap_ratio(path, text, self.parse(path, text))

    def radians(self, expression: Expression) -> Expression:
        """A cell's angle in radians, whatever the unit of the file."""
        return expression if expression == INVALID else self.units.radians(expression)

    def note_unit(self, path: Path, text: str, angle: Expression) -> bool:
        """Whether there is a notice now that an angle as written looks like the other unit.

        Only plain numbers do: what holds pi names its unit, but for what is added to it. Those of
        many turns are counted first.
        """
        if self.units.speaks_of_pi(angle):
            notice = self.units.mixed_notice(angle)
        else:
            value = self.value(self.radians(angle))
            notice = unit_notice(value, "" if self.units.degrees else "pi")
        if notice is None:
            return False
        return self._notice_unit(path, quoted(text.strip()), notice, angle)

    def _notice_unit(self, path: Path, what: str, notice: str, angle: Expression) -> bool:
        """Reports an angle that looks like the other unit; many turns together with other cells'.

        Returns:
            Whether it is reported at once.
        """
        at_once = self.units.degrees or self.units.speaks_of_pi(angle)
        if at_once:
            self.report.notice(path, f"{what} {notice}")
        else:
            self.many_turns.append(ManyTurns(path, f"{what} {notice}", self.value(angle)))
        return at_once

    def note_mixture(self, path: Path, text: str, angle: Expression) -> None:
        """Reports a plain number that is added to what holds pi."""
        if notice := self.units.mixture_notice(angle):
            self.report.notice(path, f"{quoted(text.strip())} {notice}")

    def refuse_degrees(self, path: Path, text: str, expression: Expression) -> None:
        """Report a length that is an angle."""
        if self.units.is_in_degrees(expression):
            message = (
                "is an angle, but a length belongs here: leave out deg, or take its sin or cos"
            )
            self.report.error(path, f"{quoted(text.strip())} {message}")

    def snap_length(
        self, path: Path, text: str, expression: Expression, variable: str = ""
    ) -> Expression:
        """The exact form of a length; `variable` is what a joint moves by in the cell."""
        self.refuse_degrees(path, text, expression)
        value = self.value(expression)
        if abs(value) > LARGEST_LENGTH:
            self.report.error(path, f"the length {value:.6g} is beyond {LARGEST_LENGTH:.0e}")
        self.lengths.append(Length(abs(value), path, text.strip()))
        if not abs(value) <= SNAP:
            return expression
        return self._snapped(path, text, value, ZERO, variable)

    def snap_angle(
        self, path: Path, text: str, expression: Expression, variable: str = ""
    ) -> Expression:
        """The exact form of an angle, or a notice when it looks like a slip.

        Args:
            path: The place of the cell.
            text: Its text.
            expression: The angle, or the offset in it.
            variable: What the joint moves by, with the sign: q, -q, q - q2.
        """
        value = self.value(expression)
        if abs(value) > LARGEST_ANGLE:
            self.report.error(path, f"the angle {value:.6g} rad is beyond {LARGEST_ANGLE:.0e}")
        elif (k := twelfths(value)) is not None:
            return self._snapped(path, text, value, exact_angle(k), variable)
        else:
            self._look_at_angle(path, text, expression, variable)
        return expression

    def _look_at_angle(self, path: Path, text: str, angle: Expression, variable: str) -> None:
        """Looks for slips: the other unit, and what is nearly a right angle.

        What has all its digits is so as it was measured, in a calibration, unless it is a right
        angle in single precision.
        """
        unit, value = self._unit(text), self.value(angle)
        if notice := self.units.mixed_notice(angle) or unit_notice(value, unit):
            part = "the offset of " if variable else ""
            self._notice_unit(path, part + quoted(text.strip()), notice, angle)
            return
        within = SINGLE if has_all_digits(text) else SLIP
        if near := near_right_angle(value, unit, variable, within):
            self.slips.append(NearCell(path, text.strip(), near, is_offset=bool(variable)))

    def snap_ratio(self, path: Path, text: str, expression: Expression) -> Expression:
        """The exact form of a number that may be a cosine."""
        value = self.value(expression)
        if abs(value) > LARGEST_LENGTH:
            self.report.error(path, f"the value {value:.6g} is beyond {LARGEST_LENGTH:.0e}")
        exact = _exact_ratio(expression, value)
        return expression if exact is None else self._snapped(path, text, value, exact)

    def exact_ratios(self, expressions: Iterable[Expression]) -> tuple[Expression, ...]:
        """Computed entries of a rotation, made exact where they are so but for rounding."""
        return tuple(_exact_ratio(e, self.value(e)) or e for e in expressions)

    def _unit(self, text: str) -> Literal["pi", "deg", ""]:
        if re.search(r"\bdeg\b", text):
            return "deg"
        return "" if self.units.degrees and not re.search(r"\bpi\b", text) else "pi"

    def _snapped(
        self, path: Path, text: str, value: float, exact: Expression, variable: str = ""
    ) -> Expression:
        if near := near_exact(value, self.value(exact), exact):
            self.snapped.append(NearCell(path, text.strip(), near))
            self.taken.append(taken(path, text.strip(), variable, exact))
        return exact


def _exact_ratio(expression: Expression, value: float) -> Expression | None:
    """The exact number that an entry of a rotation is; None where there is none."""
    if not abs(value) <= 1 + SNAP:
        return None
    return near_cosine(value) or canonical(expression)
