/* SPDX-License-Identifier: MIT
 *
 * Solutions at the roots of a polynomial that is known in closed form. */
#ifndef DHGEN_GENERAL_CLOSED_POLYNOMIAL_H
#define DHGEN_GENERAL_CLOSED_POLYNOMIAL_H

#include "null_vectors.h"
#include "roots.h"
#include "solutions.h"

/* Ways to solve at roots of the hidden angle, by its cosine and sine: two signs that choose among
 * square roots; `group` is the number of the root, and `far` how many more ways it has whose
 * solution is at infinity. */
typedef struct {
    int count, group[DHGEN_CANDIDATES], far[2 * DHGEN_ROOTS];
    DHGEN_MEMBER(c, DHGEN_CANDIDATES);
    DHGEN_MEMBER(s, DHGEN_CANDIDATES);
    DHGEN_MEMBER_ROWS(sign, 2, DHGEN_CANDIDATES);
    int aligned; /* whether a root does not determine all turns */
} dhgen_ways;

/* The cosines and sines of all joints at a root of the hidden angle, on the way with these signs.
 */
typedef void dhgen_way_solver(const void *setting, dhgen_lane c, dhgen_lane s, dhgen_lane first,
    dhgen_lane second, dhgen_lane joint_c[6], dhgen_lane joint_s[6]);

/* No ways yet. */
DHGEN_INLINE void dhgen_clear_ways(dhgen_ways *ways)
{
    ways->count = 0;
    ways->aligned = 0;
    for (int i = 0; i < 2 * DHGEN_ROOTS; i++) {
        ways->far[i] = 0;
    }
}

/* Refines the ways; returns whether the solutions are certainly complete. The certificate is that
 * of the formulations, with `per_root` solutions a root. */
DHGEN_FN int dhgen_refine_ways(const dhgen_loop *loop, dhgen_way_solver *joints,
    const void *setting, const dhgen_ways *ways, int per_root, int simple, int doubles,
    dhgen_found *found)
{
    dhgen_solution_set met = 0, of_group[2 * DHGEN_ROOTS] = { 0 };
    int complete = 1, expected = 0;
    for (int from = 0; from < ways->count; from += DHGEN_GENERAL_LANES) {
        const int count =
            ways->count - from < DHGEN_GENERAL_LANES ? ways->count - from : DHGEN_GENERAL_LANES;
        dhgen_lane c[6], s[6];
        int place[DHGEN_GENERAL_LANES];
        joints(setting, dhgen_lane_from(ways->c, from, ways->count),
            dhgen_lane_from(ways->s, from, ways->count),
            dhgen_lane_from(ways->sign[0], from, ways->count),
            dhgen_lane_from(ways->sign[1], from, ways->count), c, s);
        met |=
            dhgen_refine_and_keep(loop, c, s, count, DHGEN_LOOP_STEPS, doubles > 0, found, place);
        for (int k = 0; k < count; k++) {
            if (place[k] >= 0) {
                of_group[ways->group[from + k]] |= (dhgen_solution_set)1 << place[k];
            }
        }
    }
    for (int i = 0; i < simple + doubles; i++) {
        if (ways->far[i] && !of_group[i]) {
            continue;
        }
        complete &= dhgen_count_bits(of_group[i]) >= per_root;
        expected += i < simple || of_group[i] & found->singular ? per_root : 2 * per_root;
        expected -= ways->far[i];
    }
    return complete && dhgen_count_bits(met) >= expected && dhgen_is_paired(found);
}

#endif
