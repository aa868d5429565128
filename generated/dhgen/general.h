/* SPDX-License-Identifier: MIT
 *
 * The general algorithm: all solutions, at most 16, of an arm without three concurrent or parallel
 * axes, with six joints of which two may slide. M. Raghavan and B. Roth (1993): six equations in a
 * hidden joint and two partners, a determinant of degree 8 in the hidden joint; here it is sampled
 * at 24 angles. An offset wrist, and four turns with two slides, have polynomials in closed form.
 *
 * Rooms, in reading order: arm (the table), loop, motions; monomials, equations, determinant;
 * circle_tables, circle_cosines, circle_sines, circle, circle_parts, circle_cells, moebius, roots
 * (of a polynomial on the circle); null_vectors, recover, refine, solutions, eliminate;
 * closed_polynomial, offset_wrist, four_turns; correct (from near all solutions to these), search,
 * rows; postures, near (the nearest arm with a structure). */
#ifndef DHGEN_GENERAL_H
#define DHGEN_GENERAL_H

#include "general/arm.h"
#include "interface.h"
#include "numerical/arm.h"

#if defined(__cplusplus) && defined(DHGEN_SHARED)
extern "C" {
#endif

/* All solutions of a rigid T = C0 J(q1) C1 ... J(q6) C6, at most arm->most, but that of
 * continua, where there may be any, several members are returned: DHGEN_PLACES at most.
 *
 * T: row by row. q, residual: room for DHGEN_PLACES rows. q: the angles, in (-pi, pi], or length,
 * rows in the order of q1, rows whose q1 agree to DHGEN_TIE in the order of q2, and so on, singular
 * ones and nearly singular ones last. residual: by how much the loop is open, in radians and arm
 * sizes. Returns how many; -1 - count when it is not certain that these are all: for want of a
 * certificate (where every polynomial vanishes identically there may be a continuum, which poses
 * close by do not have), or because roots met or the arm is singular at a solution, or nearly, so
 * that steps did not make it exact. */
DHGEN_API int dhgen_general_solutions(const dhgen_general_arm *arm, const double T[16],
    const double *free_joints, double (*q)[6], double *residual);

/* Takes angles that are near solutions to these, of an arm without slides. Returns whether all are
 * exact, and no two of them near one another; if not, nothing is known of them. */
DHGEN_API int dhgen_general_correct(const dhgen_general_arm *arm, const double T[16],
    const double *free_joints, double (*angle)[6], int count);

/* Fills rows with all solutions, by the first joint, then by the second and so on; other rows are
 * left as they are. Where it is not certain that these are all, the seed and evenly spread starts
 * are followed, too; singular solutions out of a continuum go to the seed. */
DHGEN_API void dhgen_general_rows(const dhgen_general_arm *general,
    const struct dhgen_numerical_arm *arm, const double *T, const double *free_joints,
    const double *seed, double *q, unsigned char *status);

#if defined(__cplusplus) && defined(DHGEN_SHARED)
}
#endif

#if !defined(DHGEN_SHARED) || defined(DHGEN_BODIES)
#include "general/rows.h"
#endif

#endif
