/* SPDX-License-Identifier: MIT
 *
 * Rows whose joints are beyond their limits, onto them. Beside a singular pose a joint is known
 * from the pose to rounding over what is left of the least singular value: if it is beyond a limit
 * by no more than that, it may as well be on it. */
#ifndef DHGEN_CLAMP_H
#define DHGEN_CLAMP_H

#include "arm.h"
#include "refine.h"
#include "tolerances.h"

/* A joint that moves by more on its way to a limit reaches another solution [rad, arm sizes]: a
 * nearly straight wrist turns far for next to nothing. */
#define DHGEN_MOST_CLAMPED 1.5
/* Steps from half way to the same solution go no farther than so many times the whole way. */
#define DHGEN_HALF_WAY_ASIDE 0.25

/* Clamps the joints of a row that exceed their limits, by little, or as an arm may `again`. Returns
 * whether it can: the result must be the same solution, so the middle must also solve the pose, and
 * no row with a smaller violation may lie closer. */
DHGEN_FN int dhgen_clamp_to_limits(const struct dhgen_arm *arm, const double *T, int row, int again,
    double *rows, const unsigned char *status)
{
    double x[DHGEN_JOINTS], half[DHGEN_JOINTS], to[DHGEN_JOINTS];
    double *const q = rows + dhgen_dof(arm) * row;
    const double beyond = dhgen_past_ends(arm, q);
    const int far = again && arm->clamps_far;
    if (!(0.0 < beyond && (far || beyond < DHGEN_DOUBTFUL)))
        return 0;
    dhgen_copy_row(arm, q, x);
    const double most = far ? HUGE_VAL : DHGEN_MOST_CLAMPED;
    if (!dhgen_refine_inside(arm, T, arm->clamped[again], most, x))
        return 0;
    const double off = dhgen_half_way(arm, q, x, half);
    for (int k = 0; k < dhgen_rows(arm); k++) {
        const double *const other = rows + dhgen_dof(arm) * k;
        if (status[k] != DHGEN_UNREACHABLE && dhgen_past_ends(arm, other) < beyond
            && dhgen_half_way(arm, other, x, to) < off)
            return 0;
    }
    if (off >= DHGEN_TOGETHER
        && !dhgen_refine(arm, T, DHGEN_EXACT, DHGEN_HALF_WAY_ASIDE * off, half))
        return 0;
    dhgen_copy_row(arm, x, q);
    return 1;
}

#endif
