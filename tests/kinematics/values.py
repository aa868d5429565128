"""Ring elements as numbers: what every generator is worth in one configuration of an arm."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import build_algebra
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.product import product
from dhgen.robot.load import load_text

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform
    from dhgen.robot.robot import Robot


def table(*rows: str, **sections: str) -> Robot:
    """A robot of these rows (what stands between the braces)."""
    return load_text(_text("joints", rows, sections), "r.yaml")


def axes(*entries: str, **sections: str) -> Robot:
    """A robot of these axes."""
    return load_text(_text("axes", entries, sections), "r.yaml")


def _text(key: str, entries: Sequence[str], sections: Mapping[str, str]) -> str:
    head = "".join(f"{name}: {value}\n" for name, value in sections.items())
    return f"name: r\n{head}{key}:\n" + "".join(f"  - {{{entry}}}\n" for entry in entries)


def algebra_of(robot: Robot) -> Algebra:
    return build_algebra(build_chain(robot))


def constant_values(chain: Chain) -> dict[str, float]:
    return {constant.name: constant.value for constant in chain.constants}


def joint_values(algebra: Algebra, q: Sequence[float] | FloatArray) -> dict[str, float]:
    """Constants, cosines, sines and lengths where the joints are at q."""
    chain = algebra.chain
    angle = {j.number: j.sign * q[j.number - 1] + j.offset for j in chain.joints}
    values = constant_values(chain)
    for total in algebra.angles:
        turn = sum(sign * angle[joint] for joint, sign in total.terms)
        values[total.cosine], values[total.sine] = math.cos(turn), math.sin(turn)
    return values | {name: angle[joint] for joint, name in algebra.slides.items()}


def number(polynomial: Polynomial, values: Mapping[str, float]) -> float:
    """The value of a polynomial; only names that occur in it are looked up."""
    names = [symbol.name for symbol in polynomial.ring.symbols]
    total = 0.0
    for powers, coefficient in polynomial.items():
        factors = (
            values[name] ** power for name, power in zip(names, powers, strict=True) if power
        )
        total += int(coefficient.numerator) / int(coefficient.denominator) * math.prod(factors)
    return total


def matrix(transform: Transform, values: Mapping[str, float]) -> FloatArray:
    """A transform as a 4x4."""
    result = np.eye(4)
    for row in range(3):
        for column in range(4):
            result[row, column] = number(transform.entry(row, column), values)
    return result


def poses(algebra: Algebra, q: FloatArray) -> FloatArray:
    """Z A_1 ... A_n E of the exact chain for q (N, n), its symbols replaced by numbers."""
    chain = algebra.chain
    elements = algebra.lifted(tuple(element for link in chain.links for element in link))
    model, constants = product(elements, algebra), constant_values(chain)
    forward = np.array([matrix(model, joint_values(algebra, each)) for each in q])
    return np.asarray(matrix(chain.base, constants) @ forward @ matrix(chain.tool, constants))
