/* SPDX-License-Identifier: MIT
 *
 * What the runtime takes for rounding. dhgen/tolerances.py has the same numbers, which the
 * compiler decides by, and the reasons at length. Lengths are relative to the size of the arm; a
 * pose is rounded to a few 1e-16 of it, in single precision to a few 1e-8. */
#ifndef DHGEN_TOLERANCES_H
#define DHGEN_TOLERANCES_H

/* Seeds that are nearer to a value are beside it [rad, arm sizes]: a step may be longer than the
 * whole way. */
#define DHGEN_BESIDE_SEED 0.15

/* Of the tool's x axis, the length of what is seen from above, below which it has no yaw there: as
 * much as a pose of six digits rounds it by. */
#define DHGEN_NO_YAW 1e-6

#ifndef DHGEN_SINGLE_PRECISION

/* The last row of a pose may differ from 0 0 0 1 by this. */
#define DHGEN_LAST_ROW 1e-9
/* Sums of squares by which a rotation misses orthonormality: it is taken as it is up to the first,
 * which is rounding; replaced by the nearest rotation up to the second, as poses in single
 * precision or of six digits miss it by that. */
#define DHGEN_ORTHONORMAL 1e-24
#define DHGEN_ROUNDED 1e-9
/* A joint value may miss its limit by this [rad]: rounding of the angle itself. Searches end where
 * branches that meet are as near. */
#define DHGEN_LIMIT 1e-9
/* Fast code may be wrong by twice this [rad, arm sizes] where an arm is nearly singular twice over:
 * what is as far from this at most may be beyond a limit by rounding. */
#define DHGEN_NEAR_LIMIT 5e-7
/* A row that misses its pose by no more is exact [arm sizes, rad]. */
#define DHGEN_EXACT 1e-12
/* A row misses its pose by no more wherever it has a solution: a reason to refine it. */
#define DHGEN_PROMISED 1e-11
/* A vector that should fix an angle is no longer than this: the joint is free, and a row meets its
 * pose as exactly as this. */
#define DHGEN_FREE 1e-12
/* Half way between two rows that are one solution the pose is missed by no more. */
#define DHGEN_MERGE 1e-14
/* Joint values may be beyond limits by this before they are clamped to them [rad, arm sizes]: an
 * angle taken from a vector just longer than DHGEN_FREE is good to a tenth of it. */
#define DHGEN_DOUBTFUL 1e-2
/* About the square root of DHGEN_MERGE, because branches that meet separate like a square root:
 * joint values that differ by less are one solution [rad or length]. */
#define DHGEN_APART_BY 1e-6
/* An angle of the seed that is not below this has no copy of another near it that keeps digits. */
#define DHGEN_FAR_ANGLE 1e5
/* Always added to the damping of steps, a square: its root is so far above rounding of the miss
 * that this moves joints by 1e-3 rad at most. */
#define DHGEN_FINE 1e-26
/* Joint values that differ by less are next to one solution [rad, arm sizes]. */
#define DHGEN_TOGETHER 1e-3
/* Solutions are of one family if half way between them the pose is missed by less. */
#define DHGEN_FAMILY 1e-6

#else

#define DHGEN_LAST_ROW 1e-6
#define DHGEN_ORTHONORMAL 1e-12
#define DHGEN_ROUNDED 1e-9
#define DHGEN_LIMIT 2e-6
#define DHGEN_NEAR_LIMIT 5e-3
#define DHGEN_EXACT 5e-5
#define DHGEN_PROMISED 5e-5
#define DHGEN_FREE 2e-5
#define DHGEN_MERGE 1e-7
#define DHGEN_DOUBTFUL 1e-2
#define DHGEN_APART_BY 3e-3
#define DHGEN_FAR_ANGLE 1e2
#define DHGEN_FINE 1e-10
#define DHGEN_TOGETHER 3e-2
#define DHGEN_FAMILY 5e-4

#endif

#endif
