/* SPDX-License-Identifier: MIT
 *
 * One regular pose where lanes are single numbers. */
#ifndef DHGEN_ONE_POSE_H
#define DHGEN_ONE_POSE_H

#if DHGEN_LANES == 1

#ifndef DHGEN_REGULAR_ROWS
#define DHGEN_REGULAR_ROWS DHGEN_ROWS
#endif

DHGEN_FN int DHGEN_SOLVE_REGULAR(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_solve_branches(solve_wide, DHGEN_REGULAR_ROWS, T, free_joints, q, status);
}

#endif

#endif
