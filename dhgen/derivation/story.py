"""What every section draws from: the arm, its steps, and how polynomials are written."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from dhgen.derivation.example import find_example
from dhgen.derivation.geometry import wrist_joints
from dhgen.derivation.known_side import find_known_side
from dhgen.derivation.notation.matrices import form_of, known_matrix, left_name
from dhgen.derivation.notation.names import (
    branch_sign,
    inverse,
    joint_index,
    letter,
    link,
    single,
    symbols,
)
from dhgen.derivation.notation.polynomial import Alphabet, Writer, alphabet
from dhgen.derivation.quotes import quotes_of
from dhgen.derivation.text.formula import ONE, times
from dhgen.kinematics.ring import content, primitive
from dhgen.nominal.rows import row_names
from dhgen.paul.arm_plane import SHOULDER
from dhgen.paul.kind import Kind
from dhgen.paul.knowledge import initial_knowledge
from dhgen.paul.mixed_forms import right_inverse
from dhgen.paul.step import learn

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.derivation.example import Example
    from dhgen.derivation.known_side import KnownSide
    from dhgen.derivation.notation.matrices import Form
    from dhgen.derivation.quotes import Quote
    from dhgen.derivation.text.formula import Formula, Symbol
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.nominal.nominal import Nominal
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.equation import Matrix
    from dhgen.paul.knowledge import Knowledge
    from dhgen.paul.pool import Point
    from dhgen.paul.step import Step
    from dhgen.program.ir import Axis, Program
    from dhgen.robot.robot import Robot


COURSE_TEXT = re.compile(r"[Dd]ocument (\d{3})\b")


@dataclass(frozen=True, slots=True)
class Remembered:
    """After X s + Y c = Z the form Y s - X c is known too: the signed root.

    Attributes:
        step: The number of the step, from 1.
        form: Y s - X c.
        letter: What it is called.
    """

    step: int
    form: Polynomial
    letter: Symbol


@dataclass(frozen=True, eq=False)  # itself and no other: what is worked out of it is remembered
class Story:
    """A derivation with what its prints need.

    Attributes:
        robot: As the user wrote it.
        derivation: The steps.
        program: What computes them; its axes are the branch signs.
        nominal: The nearest arm with a structure, where its rows are tried first.
    """

    robot: Robot
    derivation: Derivation
    program: Program
    nominal: Nominal | None = None

    @property
    def algebra(self) -> Algebra:
        """The arm's ring."""
        return self.derivation.problem.algebra

    @property
    def dof(self) -> int:
        """The number of joints."""
        return self.algebra.chain.dof

    @property
    def steps(self) -> tuple[Step, ...]:
        """The steps, in order."""
        return self.derivation.steps

    @property
    def cites_courses(self) -> bool:
        """Whether the reader has the course texts at hand: the arm is one of theirs."""
        return COURSE_TEXT.search(self.robot.source) is not None

    @cached_property
    def example(self) -> Example | None:
        """A pose to work through; None for arms without steps, or where none is regular."""
        return find_example(self) if self.steps else None

    @cached_property
    def letters(self) -> dict[str, Symbol]:
        """The letter of every generator."""
        return symbols(self.algebra)

    @cached_property
    def knowledge(self) -> tuple[Knowledge, ...]:
        """What is known before the first step and after each."""
        states = [initial_knowledge(self.algebra)]
        for step in self.steps:
            states.append(learn(states[-1], step))
        return tuple(states)

    def is_known(self, joint: int, after: int) -> bool:
        """Whether a joint's angle or length is known after a step; 0 is before the first."""
        state = self.knowledge[after]
        if joint in self.algebra.slides:
            return joint in state.slides
        return state.knows(single(joint))

    @cached_property
    def solved_after(self) -> dict[str, int]:
        """For every generator that moves, the number of the step after which it is known."""
        ranks: dict[str, int] = {}
        for number, state in enumerate(self.knowledge):
            for angle in self.algebra.angles:
                if state.knows(angle):
                    ranks.setdefault(angle.cosine, number)
                    ranks.setdefault(angle.sine, number)
            for joint, name in self.algebra.slides.items():
                if joint in state.slides:
                    ranks.setdefault(name, number)
        return ranks

    def write(self, polynomial: Polynomial, step: int = 0) -> Formula:
        """A polynomial nested by the order of solving; what has a letter before `step` by it."""
        earlier = [each for each in self.remembered if each.step < step] if step else []
        forms = {each.form: each.letter for each in earlier}
        return self.written_with(polynomial, {**self._entries_before(step), **forms})

    def write_quoted(self, polynomial: Polynomial, step: int) -> Formula:
        """The form as it is in the matrices: its only letters are the entries' letters."""
        return self.written_with(polynomial, self._entries_before(step))

    def written_with(self, polynomial: Polynomial, known: Mapping[Polynomial, Formula]) -> Formula:
        """A polynomial nested by the order of solving, some forms by name."""
        rank = self.solved_after
        last = len(self.steps) + 1
        writer = Writer(self._alphabet, lambda name: rank.get(name, last), known)
        return writer.write(polynomial)

    def _entries_before(self, step: int) -> Mapping[Polynomial, Formula]:
        side = self.known_side
        return side.letters if side is not None and step > side.after else {}

    def left_name(self, place: Matrix) -> Formula:
        """The side with U_0 of a form; M A_3^-1 where it is a known matrix and one joint."""
        side = self.known_side
        if side is None or not side.is_one_joint_before(place):
            return left_name(place, self.dof)
        return times(side.symbol, inverse(link(place[1] + 1)))

    def moved_right(self, place: Matrix) -> tuple[Sequence[int], Formula]:
        """The joints moved from the right in a form, and to the side of which matrix."""
        side, k = self.known_side, place[1]
        if side is not None and side.is_one_joint_before(place):
            return (k + 1,), side.symbol
        return range(k + 1, (SHOULDER if place[3] else self.dof) + 1), known_matrix(place)

    @cached_property
    def known_side(self) -> KnownSide | None:
        """The matrix whose entries have letters in the steps that need no more of the pose."""
        return find_known_side(self)

    def write_forward(self, polynomial: Polynomial) -> Formula:
        """A polynomial nested from the base to the tool."""
        if polynomial not in self._written_forward:
            first = {a.cosine: -a.terms[0][0] for a in self.algebra.angles}
            first |= {a.sine: -a.terms[0][0] for a in self.algebra.angles}
            first |= {name: -joint for joint, name in self.algebra.slides.items()}
            writer = Writer(self._alphabet, lambda name: first.get(name, 0))
            self._written_forward[polynomial] = writer.write(polynomial)
        return self._written_forward[polynomial]

    @cached_property
    def _written_forward(self) -> dict[Polynomial, Formula]:
        return {}

    @cached_property
    def _alphabet(self) -> Alphabet:
        return alphabet(self.algebra, self.letters)

    @cached_property
    def quotes(self) -> tuple[tuple[Quote, ...], ...]:
        """The equations of every step as they are in the matrices."""
        return tuple(quotes_of(self.derivation, step) for step in self.steps)

    @cached_property
    def remembered(self) -> tuple[Remembered, ...]:
        """The forms Y s - X c of all steps of type 2 that later polynomials may hold."""
        found = []
        for number, step in enumerate(self.steps, start=1):
            if step.kind is Kind.ANGLE and step.fallback is None:
                each = self.combination(number)
                factor, inner = primitive(each.form)
                if abs(factor) == 1 and not any(content(inner)[0]) and len(inner) > 1:
                    found.append(each)
        return tuple(found)

    def combination(self, number: int) -> Remembered:
        """Y s - X c of a step of type 2."""
        step = self.steps[number - 1]
        angle = step.angle
        s, c = self.algebra.generator(angle.sine), self.algebra.generator(angle.cosine)
        form = step.coefficient("Y") * s - step.coefficient("X") * c
        used = {self.letters[constant.name].text[0] for constant in self.algebra.chain.constants}
        base = next(each for each in "DFGHM" if each not in used)
        return Remembered(number, form, letter(base, base, joint_index(angle)))

    def sign_of(self, step: int) -> Formula:
        """The branch sign that a step brings in; 1 when it has one value."""
        return next((self.sign(axis) for axis in self.program.axes if axis.step == step), ONE)

    def sign(self, axis: Axis) -> Symbol:
        """The branch sign that an axis of the program is."""
        return branch_sign(self.steps[axis.step - 1])

    def frame_of(self, point: Point) -> int:
        """The first frame whose origin a named point is."""
        problem = self.derivation.problem
        frames = range(self.dof)
        return min(k for k in frames if right_inverse(problem, k).translation == point.in_tool)

    def is_wrist_frame(self, frame: int) -> bool:
        """Whether the origin of a frame is the wrist centre."""
        return self.wrist is not None and frame >= self.wrist[0] - 1

    def form(self, place: Matrix) -> Form:
        """Both sides of a mixed form."""
        if place not in self._forms:
            self._forms[place] = form_of(self.derivation.pool, place)
        return self._forms[place]

    @cached_property
    def _forms(self) -> dict[Matrix, Form]:
        return {}

    @cached_property
    def wrist(self) -> tuple[int, int, int] | None:
        """The last three joints when their axes meet in one point."""
        return wrist_joints(self.algebra.chain)

    @property
    def branch_names(self) -> tuple[str, ...]:
        """A name for every row."""
        if self.nominal is not None:
            return row_names(self.nominal.solver.branches, self.program.rows)
        return self.program.branches

    @property
    def has_named_rows(self) -> bool:
        """Whether rows have names in words: those of steps' signs, or of postures."""
        return self.nominal is not None or (bool(self.steps) and self.has_branch_words)

    @property
    def has_branch_words(self) -> bool:
        """Whether the branches have names in words."""
        return any(axis.meaning != ("+", "-") for axis in self.program.axes)
