# SPDX-License-Identifier: MIT
"""What the runtime takes for rounding around closed forms.

dhgen/tolerances.py has the same numbers, which the compiler decides by, and the reasons at length.
Lengths are relative to the size of the arm; a pose is rounded to a few 1e-16 of it.
"""

from __future__ import annotations

# Seeds that are nearer to a value are beside it [rad, arm sizes]: a step may be longer than the
# whole way.
BESIDE_SEED = 0.15
# A joint value may miss its limit by this [rad]: rounding of the angle itself. Searches end where
# branches that meet are as near.
LIMIT = 1e-9
# A row that misses its pose by no more is exact [arm sizes, rad].
EXACT = 1e-12
# A row misses its pose by no more wherever it has a solution: a reason to refine it.
PROMISED = 1e-11
# A vector that should fix an angle is no longer than this: the joint is free, and a row meets its
# pose as exactly as this.
FREE = 1e-12
# Half way between two rows that are one solution the pose is missed by no more.
MERGE = 1e-14
# Joint values may be beyond limits by this before they are clamped to them [rad, arm sizes]: an
# angle taken from a vector just longer than FREE is good to a tenth of it.
DOUBTFUL = 1e-2
# About the square root of MERGE, because branches that meet separate like a square root: joint
# values that differ by less are one solution [rad or length].
APART_BY = 1e-6
# A seed's angle that is not below this has no copy of another angle near to it that keeps its
# digits: angles are not moved there [rad].
FAR_ANGLE = 1e5
# Always added to the damping of steps, a square: its root is so far above rounding of the miss
# that this moves joints by 1e-3 rad at most.
FINE = 1e-26
# Joint values that differ by less are next to one solution [rad, arm sizes].
TOGETHER = 1e-3
# Solutions are of one family if half way between them the pose is missed by less [rad, arm sizes].
FAMILY = 1e-6
# An extremum of a polynomial this near to zero, relative to its coefficients, is a double root:
# rounding of the coefficients may move it either way.
DOUBLE_ROOT = 1e-13
# Where a polynomial's slope is above this, relative to its coefficients, a Newton step improves a
# root; below, it may leap away.
SIMPLE_ROOT = 1e-4
