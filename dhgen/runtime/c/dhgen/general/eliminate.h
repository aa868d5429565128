/* SPDX-License-Identifier: MIT
 *
 * All solutions of a formulation: equations, roots of the determinant, candidates, certificate. */
#ifndef DHGEN_GENERAL_ELIMINATE_H
#define DHGEN_GENERAL_ELIMINATE_H

#include "equations.h"
#include "null_vectors.h"
#include "recover.h"
#include "roots.h"
#include "solutions.h"

/* The square of the sum of two unit vectors: roots closer than 1e-3 rad are also tried as a double
 * root. */
#define DHGEN_CLOSE_PAIR 3.999999

/* What a determinant is made of. */
typedef struct {
    const dhgen_general_arm *arm;
    const double *E; /* the equations */
} dhgen_elimination;

/* Adds candidates for roots that nearly meet: they may be one double root. */
DHGEN_FN void dhgen_close_pairs(const double *E, const dhgen_roots *roots, dhgen_candidates *out)
{
    for (int i = 0; i < roots->simple; i++) {
        for (int j = 0; j < i; j++) {
            const double c = roots->c[i] + roots->c[j], s = roots->s[i] + roots->s[j];
            const double square = c * c + s * s;
            if (square > DHGEN_CLOSE_PAIR) {
                const double factor = 1.0 / sqrt(square);
                dhgen_null_plane(E, c * factor, s * factor, out);
            }
        }
    }
}

/* Refines all candidates of a formulation; returns whether the solutions are certainly complete.
 * The certificate: a solution is found at every simple root and at the `beside` roots close to each
 * double one; there are at least as many different solutions as such roots, where a double root
 * that may be real counts twice at least, or once if the arm is singular there; and regular
 * solutions come in pairs. Where the determinant only comes near to zero there is no root; where it
 * nearly vanishes all around, rounding of the equations may lift it off a double root, which
 * nothing but they show. What an attempt before took for double roots is none then; whether the arm
 * is singular there is looked at. */
DHGEN_FN int dhgen_refine_candidates(const dhgen_formulation *form, const dhgen_loop *loop,
    double link[6][12], const dhgen_candidates *all, const dhgen_roots *roots, const int *beside,
    dhgen_found *found)
{
    double w[5], solve[2][5];
    dhgen_solution_set met = 0, of_group[DHGEN_CANDIDATES] = { 0 };
    const int simple = roots->simple, touching = roots->doubles + roots->unseen;
    const int doubted = found->doubles > 0;
    int complete = roots->complete, expected = simple, true_doubles = 0, certain = simple;
    for (int i = 0; i < touching; i++) {
        certain += beside[i];
    }
    dhgen_invariants(loop->arm, form->joint, link, w, solve);
    for (int from = 0; from < all->count; from += DHGEN_GENERAL_LANES) {
        const int count =
            all->count - from < DHGEN_GENERAL_LANES ? all->count - from : DHGEN_GENERAL_LANES;
        dhgen_lane n[6], c[6], s[6], tc[6], ts[6];
        int place[DHGEN_GENERAL_LANES];
        c[0] = DHGEN_LOAD_SOME(all->c + from, count);
        s[0] = DHGEN_LOAD_SOME(all->s + from, count);
        for (int i = 0; i < 6; i++) {
            n[i] = DHGEN_LOAD_SOME(all->n[i] + from, count);
        }
        if (dhgen_has(loop->arm, DHGEN_HIDDEN_SLIDE)) {
            s[0] = dhgen_hidden_length(c[0], s[0]);
            c[0] = dhgen_lane_all(1.0);
        }
        dhgen_partners(loop->arm, form->joint, n, c, s);
        dhgen_others(loop->arm, form->joint, link, w, solve, c, s);
        for (int i = 0; i < 6; i++) {
            tc[form->joint[i]] = c[i];
            ts[form->joint[i]] = form->sign * s[i];
        }
        met |= dhgen_refine_and_keep(
            loop, tc, ts, count, DHGEN_LOOP_STEPS, doubted || from + count > simple, found, place);
        for (int k = 0; k < count; k++) {
            if (from + k < certain) {
                complete &= place[k] >= 0;
            } else if (place[k] >= 0) {
                of_group[all->group[from + k]] |= (dhgen_solution_set)1 << place[k];
            }
        }
    }
    for (int k = 0; k < touching; k++) {
        const int i = all->groups - touching + k, most = beside[k] > 2 ? beside[k] : 2;
        if (of_group[i] || !all->regular[i]) {
            true_doubles++;
            expected += of_group[i] & found->singular ? 1 : most;
        } else {
            expected += beside[k];
        }
    }
    complete = complete && dhgen_count_bits(met) >= expected && dhgen_is_paired(found);
    found->doubles = complete ? true_doubles : found->doubles + roots->doubles;
    return complete;
}

/* Keeps the angles where the determinant may vanish: where f only comes near to zero it does
 * not. */
DHGEN_FN int dhgen_keep_vanishing(const void *of, int count, double *cosine, double *sine)
{
    const double *const equations = ((const dhgen_elimination *)of)->E;
    int kept = 0;
    for (int from = 0; from < count; from += DHGEN_GENERAL_LANES) {
        dhgen_lane factor[6][6], x[2][6];
        DHGEN_LANES_IN_ROOM(regular, DHGEN_BOARD(0));
        DHGEN_LANES_IN_ROOM(apart, DHGEN_BOARD(1));
        const dhgen_lane c = dhgen_lane_from(cosine, from, count);
        const dhgen_lane s = dhgen_lane_from(sine, from, count);
        (void)dhgen_determinant(equations, c, s, factor);
        DHGEN_STORE(regular, dhgen_smallest_vectors(factor, x));
        DHGEN_STORE(apart, dhgen_independence(equations, c, s));
        for (int k = 0; k < DHGEN_GENERAL_LANES && from + k < count; k++) {
            if (regular[k] < 1.0 || !(apart[k] > DHGEN_INDEPENDENT)) {
                cosine[kept] = cosine[from + k];
                sine[kept++] = sine[from + k];
            }
        }
    }
    return kept;
}

/* The determinant at the sample angles, through a Moebius map. */
DHGEN_FN void dhgen_sample_determinant(
    const void *of, const dhgen_moebius *map, double samples[DHGEN_SAMPLES])
{
    const dhgen_general_arm *const arm = ((const dhgen_elimination *)of)->arm;
    const double *const equations = ((const dhgen_elimination *)of)->E;
    for (int k = 0; k < DHGEN_SAMPLES; k += DHGEN_GENERAL_LANES) {
        dhgen_lane factor[6][6];
        dhgen_lane c = DHGEN_LOAD_SOME(dhgen_sample_c + k, DHGEN_SAMPLES - k);
        dhgen_lane s = DHGEN_LOAD_SOME(dhgen_sample_s + k, DHGEN_SAMPLES - k);
        const dhgen_lane square = dhgen_apply_moebius(map, &c, &s);
        dhgen_lane determinant = dhgen_determinant(equations, c, s, factor);
        if (dhgen_has(arm, DHGEN_HIDDEN_SLIDE)) {
            const dhgen_lane nearness = dhgen_nearness(c, s);
            for (int i = 0; i < arm->infinite_order; i++) {
                determinant /= nearness; /* without its zero where the length is infinite */
            }
        }
        DHGEN_STORE_SOME(samples + k, dhgen_weighted(determinant, square), DHGEN_SAMPLES - k);
    }
}

/* Adds the solutions that a formulation finds; returns whether that is certainly everything. */
DHGEN_FN int dhgen_eliminate(
    const dhgen_formulation *form, const dhgen_loop *loop, dhgen_found *found)
{
    double link[6][12];
    DHGEN_IN_ROOM(E, 192, DHGEN_ROOM_E);
    DHGEN_TABLE_IN_ROOM(left, 15, 32, DHGEN_ROOM_LEFT);
    const dhgen_elimination elimination = { loop->arm, E };
    const dhgen_source source = { dhgen_sample_determinant, dhgen_keep_vanishing, &elimination };
    dhgen_roots roots, beside;
    dhgen_candidates all;
    int separate[2 * DHGEN_ROOTS];
    dhgen_formulation_links(form, loop, link);
    if (form->left) {
        dhgen_equations(loop->arm, form, link, form->left, E);
    } else {
        dhgen_left_side(loop->arm, form, link, left);
        dhgen_equations(loop->arm, form, link, (const double(*)[32])left, E);
    }
    if (!dhgen_real_roots(&source, &roots)) {
        return 0;
    }
    DHGEN_PLACE_ROWS(&all, n, 6, DHGEN_CANDIDATES_IN_LANES);
    beside.simple = all.count = all.groups = 0;
    for (int i = 0; i < roots.doubles + roots.unseen; i++) {
        separate[i] = dhgen_separate(E, roots.double_c[i], roots.double_s[i], &beside);
    }
    dhgen_null_vectors(E, &roots, &all);
    dhgen_null_vectors(E, &beside, &all);
    dhgen_close_pairs(E, &roots, &all);
    for (int i = 0; i < roots.doubles + roots.unseen; i++) {
        dhgen_null_plane(E, roots.double_c[i], roots.double_s[i], &all);
    }
    /* lanes behind the last candidate hold the first one */
    for (int k = all.count; DHGEN_LANES_BEHIND && k % DHGEN_GENERAL_LANES; k++) {
        all.c[k] = all.c[0];
        all.s[k] = all.s[0];
        for (int i = 0; i < 6; i++) {
            all.n[i][k] = all.n[i][0];
        }
    }
    return dhgen_refine_candidates(form, loop, link, &all, &roots, separate, found);
}

#endif
