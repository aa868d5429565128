"""Programs of a single kernel: the type's letters are the entries of the pose that is put in.

The kernels see ring polynomials; here every letter is a generator of its own (t11, t12, ...), so
that any numbers can be tried, or a whole number.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.build import build_chain
from dhgen.paul.derivation import Derivation
from dhgen.paul.form import Length
from dhgen.paul.kind import Kind
from dhgen.paul.step import Step
from dhgen.program.interpret import Rows, interpret
from dhgen.program.lowering.checks import Checks
from dhgen.program.lowering.context import Lowering
from dhgen.program.lowering.types import KERNELS
from dhgen.robot.load import load
from dhgen.tolerances import TOLERANCES
from tests.derivation.stories import ROBOTS
from tests.derived import derived

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.pool import Pool
    from dhgen.program.ir import Program

ANGLE = AngleSum(((1, 1),))
PLACES = [f"t{row}{column}" for row in (1, 2, 3) for column in (1, 2, 3)]


@cache
def pool() -> Pool:
    """Of the Stanford arm: it has turning joints and a sliding one."""
    return derived(build_chain(load(ROBOTS / "stanford.yaml"))).pool


def slide() -> Length:
    """Its sliding joint."""
    ((joint, name),) = pool().problem.algebra.slides.items()
    return Length(joint, name)


def kernel_program(
    kind: Kind, letters: Mapping[str, int | str | None], *, slides: bool = False
) -> Program:
    """The program of one step: cosine and sine of joint 1, or the slide's length in front.

    Args:
        kind: The type.
        letters: Of the type; None for a number that the pose will hold, a number, or the name of
            an earlier letter, perhaps with a sign in front.
        slides: Whether the slide is unknown too, or alone for types 1 and 10.
    """
    algebra = pool().problem.algebra
    places = iter(PLACES)
    values: dict[str, Polynomial] = {}
    for letter, number in letters.items():
        if number is None:
            values[letter] = algebra.generator(next(places))
        elif isinstance(number, int):
            values[letter] = algebra.ring(number)
        else:
            values[letter] = values[number[-2:]] * (-1 if number[0] == "-" else 1)
    angles = () if kind in {Kind.LENGTH, Kind.SQUARED_LENGTH} else (ANGLE,)
    unknowns = (*angles, *((slide(),) if slides else ()))
    step = Step(kind, unknowns, (), tuple(values.items()), 0)
    context = Lowering(Derivation(pool(), (step,), ((),)), TOLERANCES, Checks(rows=False))
    context.step_number = 1
    KERNELS[kind](context, step)
    results = {"r": context.value(slide().name)} if slides else {}
    for angle in angles:
        results |= {"c": context.value(angle.cosine), "s": context.value(angle.sine)}
    return context.builder.finish("kernel", results, context.angles.free_joints())


def run(program: Program, numbers: FloatArray, seed: float = 0.0) -> Rows:
    """Runs it for rows of numbers, (N, letters), each in the place of its letter."""
    T = np.zeros((len(numbers), 16))
    T[:, 15] = 1.0
    columns = [0, 1, 2, 4, 5, 6, 8, 9, 10][: numbers.shape[1]]
    T[:, columns] = numbers
    seeds = np.full(pool().problem.algebra.chain.dof, seed)
    return interpret(program, T.reshape(-1, 4, 4), seeds)
