/* SPDX-License-Identifier: MIT
 *
 * Arms with an offset wrist: a polynomial of the sixth angle. */
#ifndef DHGEN_GENERAL_OFFSET_WRIST_H
#define DHGEN_GENERAL_OFFSET_WRIST_H

#include "closed_polynomial.h"

/* The ways, of four, to place the plane and the elbow are tried for which axis 4 is this nearly at
 * right angles to z5, as a cosine: another one may have its root close by. */
#define DHGEN_NEARLY_RIGHT 0.01
/* W is this close to axis 1, or to S [arm sizes]: the plane is not determined. */
#define DHGEN_BARELY 1e-12

/* The offset wrist: axes 1 and 2 meet at right angles in S, 2 and 3 are parallel, 4 and 5 meet at
 * right angles in W, axis 4 lies in the plane through S across axis 2. With q6 given, W and z5 are
 * known, and S, the elbow E and W form a triangle; axis 4 has to be at right angles to z5. The
 * signs of a way are those of the plane and of the elbow. */
typedef struct {
    const dhgen_loop *loop;
    double back[12]; /* from frame 6 to frame 5 */
} dhgen_wrist_setting;

/* What a sixth angle fixes: frame 5 before its own turn, W from S. */
DHGEN_INLINE void dhgen_wrist_at(
    const dhgen_wrist_setting *set, dhgen_lane c, dhgen_lane s, dhgen_rigid frame, dhgen_lane W[3])
{
    const dhgen_wrist *const wrist = set->loop->arm->wrist;
    dhgen_broadcast(frame, set->loop->link[5]);
    dhgen_turn(frame, c, -s);
    dhgen_multiply(frame, set->back);
    for (int i = 0; i < 3; i++) {
        W[i] = frame[i][3] + wrist->wrist_5 * frame[i][2];
    }
    W[2] -= wrist->shoulder;
}

/* The discriminant of the triangle of S, E and W, at the square w of the distance from S to W. */
DHGEN_INLINE dhgen_lane dhgen_triangle(const dhgen_wrist *wrist, dhgen_lane w)
{
    const dhgen_lane twice = w + wrist->upper_square - wrist->lower_square;
    return 4.0 * wrist->upper_square * w - twice * twice;
}

/* The polynomial of q6: of degree 8, or of degree 4 where axis 4 does not leave the lower arm. */
DHGEN_INLINE dhgen_lane dhgen_wrist_polynomial(
    const dhgen_wrist_setting *set, dhgen_lane c6, dhgen_lane s6)
{
    const dhgen_wrist *const wrist = set->loop->arm->wrist;
    dhgen_rigid frame;
    dhgen_lane W[3];
    dhgen_wrist_at(set, c6, s6, frame, W);
    const dhgen_lane z5[3] = { frame[0][2], frame[1][2], frame[2][2] };
    const dhgen_lane w = W[0] * W[0] + W[1] * W[1] + W[2] * W[2];
    const dhgen_lane along = W[0] * z5[0] + W[1] * z5[1] + W[2] * z5[2];
    const dhgen_lane m = z5[2] * w - W[2] * along, D = dhgen_triangle(wrist, w);
    const dhgen_lane part = w - wrist->upper_square + wrist->lower_square;
    const dhgen_lane first = along * along * (W[0] * W[0] + W[1] * W[1]), second = m * m;
    if (!wrist->bent) {
        return (first * part * part - second * D) / (w + DHGEN_TINY);
    }
    const double C = wrist->cosine, S = wrist->sine;
    const dhgen_lane U =
        first * (C * C * part * part + S * S * D) - second * (S * S * part * part + C * C * D);
    const dhgen_lane V = 2.0 * C * S * part * (first + second);
    return (U * U - V * V * D) / (w * w + DHGEN_TINY);
}

/* By how much each way at a root misses a right angle between axis 4 and z5, over what is nearly
 * none: below one it is a way. */
DHGEN_INLINE void dhgen_wrist_misses(
    const dhgen_wrist_setting *set, dhgen_lane c, dhgen_lane s, dhgen_lane miss[4])
{
    const dhgen_wrist *const wrist = set->loop->arm->wrist;
    dhgen_rigid frame;
    dhgen_lane W[3];
    dhgen_wrist_at(set, c, s, frame, W);
    const dhgen_lane rho = W[0] * W[0] + W[1] * W[1], w = rho + W[2] * W[2];
    const dhgen_lane along = W[0] * frame[0][2] + W[1] * frame[1][2] + W[2] * frame[2][2];
    const dhgen_lane m = frame[2][2] * w - W[2] * along, across = dhgen_lane_sqrt(rho);
    const dhgen_lane part = w - wrist->upper_square + wrist->lower_square;
    const dhgen_lane root =
        dhgen_lane_sqrt(dhgen_lane_max(dhgen_triangle(wrist, w), dhgen_lane_all(0.0)));
    const double C = wrist->cosine, S = wrist->sine, r = wrist->lower;
    const dhgen_lane nearly_right = 2.0 * w * r * across * DHGEN_NEARLY_RIGHT;
    for (int way = 0; way < 4; way++) {
        const double tau = way & 1 ? 1.0 : -1.0, elbow = way & 2 ? 1.0 : -1.0;
        const dhgen_lane one = along * across * (C * part + S * elbow * root);
        const dhgen_lane other = tau * m * (S * part - C * elbow * root);
        /* none where W is on axis 1 */
        miss[way] = dhgen_lane_select(
            across < DHGEN_BARELY, dhgen_lane_all(1.0), dhgen_lane_abs(one + other) / nearly_right);
    }
}

/* Turn from (x, y), a constant, to (u, v), as cosine and sine. */
DHGEN_INLINE void dhgen_turn_to(
    double x, double y, dhgen_lane u, dhgen_lane v, dhgen_lane *c, dhgen_lane *s)
{
    *c = x * u + y * v;
    *s = x * v - y * u;
    dhgen_normalize(c, s);
}

/* The cosines and sines of all joints, from q6 and the way. */
DHGEN_INLINE void dhgen_wrist_joints(const void *setting, dhgen_lane c6, dhgen_lane s6,
    dhgen_lane tau, dhgen_lane elbow, dhgen_lane c[6], dhgen_lane s[6])
{
    const dhgen_wrist_setting *const set = (const dhgen_wrist_setting *)setting;
    const dhgen_wrist *const wrist = set->loop->arm->wrist;
    dhgen_rigid frame, T;
    dhgen_lane W[3], target[4][3], x[2], up[3], w, rho, part, side;
    dhgen_wrist_at(set, c6, s6, frame, W);
    rho = W[0] * W[0] + W[1] * W[1];
    w = rho + W[2] * W[2];
    rho = dhgen_lane_sqrt(rho);
    x[0] = tau * W[0] / rho;
    x[1] = tau * W[1] / rho;
    part = 0.5 * (w - wrist->upper_square + wrist->lower_square) / w;
    side = dhgen_lane_sqrt(dhgen_lane_max(dhgen_triangle(wrist, w), dhgen_lane_all(0.0))) * elbow
        * 0.5 / w;
    up[0] = -W[2] * x[0]; /* W turned about axis 3 */
    up[1] = -W[2] * x[1];
    up[2] = tau * rho;
    target[0][0] = wrist->flip * x[1];
    target[0][1] = wrist->flip * -x[0];
    target[0][2] = dhgen_lane_all(0.0);
    for (int i = 0; i < 3; i++) {
        const dhgen_lane shoulder = dhgen_lane_all(i == 2 ? wrist->shoulder : 0.0);
        target[2][i] = W[i] + shoulder;
        target[1][i] = target[2][i] - part * W[i] + side * up[i];
        target[3][i] = frame[i][2];
    }
    dhgen_broadcast(T, dhgen_identity);
    for (int k = 0; k < 4; k++) {
        dhgen_lane v[3], local[2];
        for (int i = 0; i < 3; i++) {
            v[i] = k == 1 || k == 2 ? target[k][i] - T[i][3] : target[k][i];
        }
        for (int j = 0; j < 2; j++) {
            local[j] = T[0][j] * v[0] + T[1][j] * v[1] + T[2][j] * v[2];
        }
        dhgen_turn_to(
            wrist->sources[2 * k], wrist->sources[2 * k + 1], local[0], local[1], &c[k], &s[k]);
        dhgen_turn(T, c[k], s[k]);
        dhgen_multiply(T, set->loop->link[k]);
    }
    c[4] = s[4] = dhgen_lane_all(0.0);
    for (int i = 0; i < 3; i++) {
        c[4] += T[i][0] * frame[i][0] + T[i][1] * frame[i][1];
        s[4] += T[i][1] * frame[i][0] - T[i][0] * frame[i][1];
    }
    dhgen_normalize(&c[4], &s[4]);
    c[5] = c6;
    s[5] = s6;
}

/* Adds the ways at every root. */
DHGEN_FN void dhgen_wrist_ways(const dhgen_wrist_setting *set, const double *c, const double *s,
    int count, int group, dhgen_ways *out)
{
    for (int from = 0; from < count; from += DHGEN_GENERAL_LANES) {
        DHGEN_ROWS_IN_ROOM(misses, 4, DHGEN_BOARD(0));
        dhgen_lane miss[4];
        dhgen_wrist_misses(
            set, dhgen_lane_from(c, from, count), dhgen_lane_from(s, from, count), miss);
        for (int way = 0; way < 4; way++) {
            DHGEN_STORE(misses[way], miss[way]);
        }
        for (int k = 0; k < 4 * DHGEN_GENERAL_LANES && from + k / 4 < count; k++) {
            if (misses[k % 4][k / 4] < 1.0 && out->count < DHGEN_CANDIDATES) {
                out->group[out->count] = group + from + k / 4;
                out->c[out->count] = c[from + k / 4];
                out->s[out->count] = s[from + k / 4];
                out->sign[0][out->count] = k & 1 ? 1.0 : -1.0;
                out->sign[1][out->count] = k & 2 ? 1.0 : -1.0;
                out->count++;
            }
        }
    }
}

/* The polynomial at the sample angles, through a Moebius map. */
DHGEN_FN void dhgen_sample_wrist(
    const void *setting, const dhgen_moebius *map, double samples[DHGEN_SAMPLES])
{
    for (int k = 0; k < DHGEN_SAMPLES; k += DHGEN_GENERAL_LANES) {
        dhgen_lane c = DHGEN_LOAD_SOME(dhgen_sample_c + k, DHGEN_SAMPLES - k);
        dhgen_lane s = DHGEN_LOAD_SOME(dhgen_sample_s + k, DHGEN_SAMPLES - k);
        const dhgen_lane square = dhgen_apply_moebius(map, &c, &s);
        const dhgen_lane f = dhgen_wrist_polynomial((const dhgen_wrist_setting *)setting, c, s);
        DHGEN_STORE_SOME(samples + k, dhgen_weighted(f, square), DHGEN_SAMPLES - k);
    }
}

/* Adds the solutions of an arm with an offset wrist; returns whether that is certainly everything.
 */
DHGEN_FN int dhgen_solve_wrist(const dhgen_loop *loop, dhgen_found *found)
{
    dhgen_wrist_setting set;
    const dhgen_source source = { dhgen_sample_wrist, 0, &set };
    dhgen_roots roots;
    dhgen_ways ways;
    set.loop = loop;
    dhgen_invert(loop->link[4], set.back);
    if (!dhgen_real_roots(&source, &roots)) {
        return 0;
    }
    DHGEN_PLACE_ROWS(&ways, sign, 2, DHGEN_CANDIDATES);
    dhgen_clear_ways(&ways);
    dhgen_wrist_ways(&set, roots.c, roots.s, roots.simple, 0, &ways);
    dhgen_wrist_ways(&set, roots.double_c, roots.double_s, roots.doubles, roots.simple, &ways);
    found->doubles += roots.doubles;
    return dhgen_refine_ways(loop, dhgen_wrist_joints, &set, &ways, loop->arm->wrist->per_root,
               roots.simple, roots.doubles, found)
        && roots.complete;
}

#endif
