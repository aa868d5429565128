/* SPDX-License-Identifier: MIT
 *
 * The numerical solver: descents from the seed and from evenly spread starts.
 *
 * Rooms, in reading order: arm (the table), descent, pull, solutions, family, keep, search. */
#ifndef DHGEN_NUMERICAL_H
#define DHGEN_NUMERICAL_H

#include "interface.h"
#include "numerical/arm.h"

#if defined(__cplusplus) && defined(DHGEN_SHARED)
extern "C" {
#endif

/* Fills rows with the solutions that are found, by the first joint, then by the second and so on;
 * other rows are left as they are. */
DHGEN_API void dhgen_numerical_rows(const struct dhgen_numerical_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *q, unsigned char *status);

#if defined(__cplusplus) && defined(DHGEN_SHARED)
}
#endif

#if !defined(DHGEN_SHARED) || defined(DHGEN_BODIES)
#include "numerical/search.h"
#endif

#endif
