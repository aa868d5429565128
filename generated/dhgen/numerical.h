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

/* The solutions that are found, sorted by the first joint, then by the second and so on: rows of
 * joint values, which of them there are, and which were chosen from a continuum. */
DHGEN_API void dhgen_numerical_rows(const struct dhgen_numerical_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *q, int *found, int *chosen);

#if defined(__cplusplus) && defined(DHGEN_SHARED)
}
#endif

#if !defined(DHGEN_SHARED) || defined(DHGEN_BODIES)
#include "numerical/search.h"
#endif

#endif
