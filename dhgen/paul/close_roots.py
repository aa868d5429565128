"""Whether roots of an arm's quartics are often close: then they take long, and some are lost.

Where three axes nearly meet, or are nearly parallel, a quartic has its roots in pairs. Each pair
has to be split by least squares, in a hundred times the time that the rest takes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.paul.common_zeros import PoseValues, values_at
from dhgen.paul.kind import Kind
from dhgen.paul.samples import Sums
from dhgen.paul.types.circle import SLOPE, TURNS, Ratio, polynomial

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.paul.pool import Pool
    from dhgen.paul.step import Step

TRIED = 2000  # joint values, of which each is a root of its own pose
# A slope that is less, of the size of the polynomial: nearer to a double root rows are seldom exact
# before they are split.
CLOSE = 1e-5
# A general algorithm takes twice as long as a quartic without close roots. Both take as long where
# three axes of an iiwa miss a point by a millimetre or two, and 4 to 6 % of its roots are close;
# where they miss it by 0.4 mm a tenth is, and the quartic takes five times as long. No arm that is
# meant to have a quartic has one root in a hundred close.
OFTEN = 0.03
NAMES = [f"{letter}{n}{part}" for letter in "RPQ" for n in (1, 2) for part in ("", "c", "s")]


def has_close_roots(pool: Pool, steps: Sequence[Step]) -> bool:
    """Whether of the roots that random joint values are many are close to another.

    Args:
        pool: The equations.
        steps: All steps of an arm.
    """
    quartics = [step for step in steps if step.kind is Kind.CIRCLE]
    return any(close_share(pool, step) > OFTEN for step in quartics)


def close_share(pool: Pool, step: Step) -> float:
    """How many of the true roots have a slope that is small for the size of the polynomial.

    Args:
        pool: The equations.
        step: Of type 9.
    """
    algebra = pool.problem.algebra
    q = np.random.default_rng(37).uniform(-np.pi, np.pi, (algebra.chain.dof, TRIED))
    values = values_at(algebra, q)
    PoseValues(pool).fill(values)
    letters = Sums(map(step.coefficient, NAMES))(values).reshape(3, 2, 3, 1, TRIED)
    cosine, sine = values[[algebra.index[step.angle.cosine], algebra.index[step.angle.sine]]]
    c = np.outer(np.cos(TURNS), cosine) - np.outer(np.sin(TURNS), sine)
    s = np.outer(np.cos(TURNS), sine) + np.outer(np.sin(TURNS), cosine)
    around = letters[:, :, 0] + letters[:, :, 1] * c + letters[:, :, 2] * s
    found, _ = polynomial(around[:, 0], around[:, 1], _ratio_on(step, values))
    slopes = np.abs(SLOPE @ found)
    return float(np.mean(slopes <= CLOSE * np.abs(found).max(axis=0)))


def _ratio_on(step: Step, values: FloatArray) -> Ratio | None:
    """V1 and V2 of a step where every generator has a value, if it has them."""
    if not step.has("V1x"):
        return None
    x1, y1, x2, y2 = parts = [step.coefficient(name) for name in ("V1x", "V1y", "V2x", "V2y")]
    a, b, c, d = Sums(parts)(values)
    return Ratio((x1, y1, x2, y2), (a + 1j * b, c + 1j * d))
