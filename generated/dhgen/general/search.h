/* SPDX-License-Identifier: MIT
 *
 * All solutions of a general arm. */
#ifndef DHGEN_GENERAL_SEARCH_H
#define DHGEN_GENERAL_SEARCH_H

#include "../general.h"
#include "closed_polynomial.h"
#include "correct.h"

#if DHGEN_MAY_LACK(DHGEN_FOUR_TURNS)
#include "eliminate.h"
#endif
#if DHGEN_MAY_HAVE(DHGEN_FOUR_TURNS)
#include "four_turns.h"
#endif
#if DHGEN_MAY_HAVE(DHGEN_OFFSET_WRIST)
#include "offset_wrist.h"
#endif

/* Newton steps of the search from anywhere. */
#define DHGEN_STEPS_FROM_AFAR 40
/* Starts, eight at once, where everything else fails. */
#define DHGEN_BATCHES 16
/* Singular solutions closer than this may be one, which their last digits show [rad, arm sizes]. */
#define DHGEN_SINGULAR_TOGETHER 0.001

/* From a pose to poses close by, where the formulations fail: where roots crowd, they come apart
 * only at some distance. */
#define DHGEN_NUDGES 10

DHGEN_TABLE double dhgen_nudge[DHGEN_NUDGES][12] = {
    { 0.9999995580001719, -0.000580303174204035, -0.00073976191215864, 0.0005300000000000001,
        0.0005796963744401407, 0.9999994956001963, -0.0008202142808546233, 0.00071,
        0.0007402375119735841, 0.0008197850810216249, 0.9999993900002373, -0.00047 },
    { 0.9999995580001719, 0.0005796963744401407, 0.0007402375119735841, -0.0005300000000000001,
        -0.000580303174204035, 0.9999994956001963, 0.0008197850810216249, -0.00071,
        -0.00073976191215864, -0.0008202142808546233, 0.9999993900002373, 0.00047 },
    { 0.9999949420151998, -0.0018617746051811336, 0.002578708850722032, -0.00183,
        0.0018582142158804597, 0.9999973180080597, 0.001382395245764047, 0.00087,
        -0.0025812756430085644, -0.0013775964601848774, 0.999995719612863, 0.00201 },
    { 0.9999949420151998, 0.0018582142158804597, -0.0025812756430085644, 0.00183,
        -0.0018617746051811336, 0.9999973180080597, -0.0013775964601848774, -0.00087,
        0.002578708850722032, 0.001382395245764047, 0.999995719612863, -0.00201 },
    { 0.9999377228865443, 0.009025321676340304, 0.00656459573098787, 0.0059, -0.008973844062327714,
        0.9999290832869896, -0.007829337110224942, -0.0043, -0.0066347924773686754,
        0.007769939863287338, 0.9999478024193579, 0.0031 },
    { 0.9999377228865443, -0.008973844062327714, -0.0066347924773686754, -0.0059,
        0.009025321676340304, 0.9999290832869896, 0.007769939863287338, 0.0043, 0.00656459573098787,
        -0.007829337110224942, 0.9999478024193579, -0.0031 },
    { 0.9996484117295773, 0.020763800426894047, 0.01648992172102878, 0.011099999999999999,
        -0.021220469326757335, 0.9993821115042827, 0.028019401970663643, 0.0183,
        -0.015897943517502292, -0.028359474555668215, 0.9994713580662733, 0.017099999999999997 },
    { 0.9996484117295773, -0.021220469326757335, -0.015897943517502292, -0.011099999999999999,
        0.020763800426894047, 0.9993821115042827, -0.028359474555668215, -0.0183,
        0.01648992172102878, 0.028019401970663643, 0.9994713580662733, -0.017099999999999997 },
    { 0.999472790696877, -0.013504055448103867, 0.029525940172180323, -0.0153, 0.014085964965612287,
        0.9997088653063301, -0.01959005408153817, -0.0201, -0.02925279897008453,
        0.019995627381619797, 0.9993720271440617, 0.012299999999999998 },
    { 0.999472790696877, 0.014085964965612287, -0.02925279897008453, 0.0153, -0.013504055448103867,
        0.9997088653063301, 0.019995627381619797, 0.0201, 0.029525940172180323,
        -0.01959005408153817, 0.9993720271440617, -0.012299999999999998 },
};

/* Adds the solutions that the methods find, one after the other, until that is certainly
 * everything; returns whether it is. */
DHGEN_FN int dhgen_try_all(const dhgen_loop *loop, dhgen_found *found)
{
    const dhgen_general_arm *const arm = loop->arm;
    int complete = 0;
#if DHGEN_MAY_HAVE(DHGEN_OFFSET_WRIST)
    if (dhgen_has(arm, DHGEN_OFFSET_WRIST)) {
        complete = dhgen_solve_wrist(loop, found);
    }
#endif
#if DHGEN_MAY_HAVE(DHGEN_FOUR_TURNS)
    for (int i = 0; dhgen_has(arm, DHGEN_FOUR_TURNS) && i < arm->formulations && !complete; i++) {
        complete = dhgen_solve_four_turns(i, loop, found);
    }
#endif
#if DHGEN_MAY_LACK(DHGEN_FOUR_TURNS)
    for (int i = 0; !dhgen_has(arm, DHGEN_FOUR_TURNS) && i < arm->formulations && !complete; i++) {
        if (!(loop->useless >> i & 1u)) {
            complete = dhgen_eliminate(&arm->formulation[i], loop, found);
        }
    }
#endif
    return complete;
}

/* Adds the solutions that Newton's method finds from `count` rows of joint values, far from or near
 * to solutions; returns which these are, and counts in `lost` the starts from which it finds
 * none. */
DHGEN_FN dhgen_solution_set dhgen_refine_from(
    const dhgen_loop *loop, double (*start)[6], int count, dhgen_found *found, int *lost)
{
    dhgen_solution_set met = 0;
    for (int from = 0; from < count; from += DHGEN_GENERAL_LANES) {
        const int now = count - from < DHGEN_GENERAL_LANES ? count - from : DHGEN_GENERAL_LANES;
        DHGEN_ROWS_IN_ROOM(cosines, 6, DHGEN_STARTS_BOARD(0));
        DHGEN_ROWS_IN_ROOM(sines, 6, DHGEN_STARTS_BOARD(6));
        dhgen_lane c[6], s[6];
        int place[DHGEN_GENERAL_LANES];
        for (int i = 0; i < 6; i++) {
            for (int k = DHGEN_FIRST_LANE; k < DHGEN_END_LANE; k++) {
                const double angle = start[from + (k < now ? k : 0)][i];
                const double cosine = cos(angle),
                             sine = dhgen_is_slide(loop->arm, i) ? angle : sin(angle);
                cosines[i][k] = cosine * loop->arm->advance[0][i] + sine * loop->arm->advance[1][i];
                sines[i][k] = sine * loop->arm->advance[0][i] - cosine * loop->arm->advance[1][i];
            }
            DHGEN_MEET();
            c[i] = DHGEN_LOAD(cosines[i]);
            s[i] = DHGEN_LOAD(sines[i]);
        }
        met |= dhgen_refine_and_keep(loop, c, s, now, DHGEN_STEPS_FROM_AFAR, 1, found, place);
        for (int k = 0; k < now; k++) {
            *lost += place[k] < 0;
        }
    }
    return met;
}

/* Solves poses close by, and follows their solutions back; returns whether that is certainly
 * everything. Where two solutions meet they are on one side only: both sides have to have as many
 * as are found. Around a singular pose none of them has to have all solutions: then all are looked
 * at. */
DHGEN_FN int dhgen_search_nearby_poses(const dhgen_loop *loop, dhgen_found *found)
{
    int followed = 0, before = -1;
    for (int n = 0; n < DHGEN_NUDGES; n++) {
        dhgen_loop nearby = *loop;
        dhgen_found other;
        int complete, count = -1, lost = 0;
        dhgen_solution_set met;
        dhgen_append(nearby.link[5], dhgen_nudge[n]);
        dhgen_forget(&other);
        complete = dhgen_try_all(&nearby, &other);
        met = dhgen_refine_from(loop, other.q, other.count, found, &lost);
        if (complete && !lost && met) {
            count = dhgen_count_bits(met) == other.count ? other.count : -1;
            followed |= (met & found->singular) != 0;
        }
        if (n % 2 && before == found->count && count == found->count && !found->singular
            && dhgen_is_paired(found)) {
            return 1;
        }
        before = count;
    }
    return followed && dhgen_is_paired(found);
}

/* Adds the solutions that Newton's method finds from many starts, equal on every run and in both
 * languages. */
DHGEN_FN void dhgen_search_everywhere(const dhgen_loop *loop, dhgen_found *found)
{
    unsigned long seed = 1;
    for (int batch = 0; batch < DHGEN_BATCHES; batch++) {
        double start[8][6];
        int lost = 0;
        for (int i = 0; i < 48; i++) {
            seed = (seed * 1103515245UL + 12345UL) & 0x7fffffffUL;
            start[i / 6][i % 6] = ((double)seed / 1073741824.0 - 1.0) * DHGEN_HALF_TURN;
        }
        (void)dhgen_refine_from(loop, start, 8, found, &lost);
    }
}

/* What comes first where there are more than there are rows: 0 for regular solutions, 1 for
 * singular ones or nearly so, 2 for those that lie together with one of these and may be the same,
 * which only its last digits show. */
DHGEN_FN void dhgen_rank(
    const dhgen_general_arm *arm, const dhgen_found *found, int rank[DHGEN_PLACES])
{
    for (int i = 0; i < found->count; i++) {
        rank[i] = (int)(found->nearly_singular >> i & 1);
        for (int j = 0; j < i && rank[i] == 1; j++) {
            if (rank[j] == 1
                && dhgen_is_close(arm, found->q[i], found->q[j], DHGEN_SINGULAR_TOGETHER)) {
                rank[i] = 2;
            }
        }
    }
}

/* The places of solutions in their order: by rank, then by the first angle, angles that agree to
 * rounding by the next. */
DHGEN_FN void dhgen_put_in_order(
    const dhgen_general_arm *arm, const dhgen_found *found, const int *rank, int *order)
{
    double value[DHGEN_PLACES] = { 0.0 };
    unsigned char first[DHGEN_PLACES] = { 0 };
    int ranked = 0, single = found->count < 2;
    for (int i = 0; i < found->count; i++) {
        order[i] = i;
        value[i] = rank[i];
        ranked |= rank[i];
    }
    if (ranked) {
        single = dhgen_order_blocks(value, 0.0, found->count, order, first);
    }
    for (int k = 0; k < 6 && !single; k++) {
        for (int i = 0; i < found->count; i++) {
            value[i] = dhgen_order_of(found->q[i][k], !dhgen_is_slide(arm, k));
        }
        single = dhgen_order_blocks(value, DHGEN_TIE, found->count, order, first);
    }
}

DHGEN_API int dhgen_general_correct(const dhgen_general_arm *arm, const double T[16],
    const double *free_joints, double (*angle)[6], int count)
{
    double residual[DHGEN_PLACES];
    dhgen_loop loop;
    dhgen_close_loop(arm, T, free_joints, &loop);
    dhgen_correct_angles(&loop, angle, count, residual);
    return dhgen_are_apart(arm, angle, count, residual);
}

DHGEN_API int dhgen_general_solutions(const dhgen_general_arm *arm, const double T[16],
    const double *free_joints, double (*q)[6], double *residual)
{
    dhgen_found found;
    dhgen_loop whole;
    const dhgen_loop *const loop = &whole;
    int rank[DHGEN_PLACES], order[DHGEN_PLACES], certified, members = 0, inexact = 0;
    dhgen_close_loop(arm, T, free_joints, &whole);
    dhgen_forget(&found);
    const double *const P = loop->link[5];
    if (P[3] * P[3] + P[7] * P[7] + P[11] * P[11] > arm->reach) {
        return 0;
    }
    certified = dhgen_try_all(loop, &found);
    if (!certified && !dhgen_search_nearby_poses(loop, &found)) {
        dhgen_search_everywhere(loop, &found);
    }
    dhgen_rank(arm, &found, rank);
    dhgen_put_in_order(arm, &found, rank, order);
    for (int i = 0; i < found.count; i++) {
        members += rank[i] < 2;
    }
    members = members > arm->most ? members : arm->most;
    certified = certified && found.count <= arm->most;
    found.count = found.count < members ? found.count : members;
    for (int i = 0; i < found.count; i++) {
        for (int j = 0; j < 6; j++) {
            q[i][j] =
                dhgen_is_slide(arm, j) ? found.q[order[i]][j] * arm->size : found.q[order[i]][j];
        }
        residual[i] = found.residual[order[i]];
        inexact |= residual[i] > DHGEN_LOOP_EXACT;
    }
    return certified && !found.singular && !found.doubles && !inexact ? found.count
                                                                      : -1 - found.count;
}

#endif
