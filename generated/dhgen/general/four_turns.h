/* SPDX-License-Identifier: MIT
 *
 * Arms with four turns and two slides: a polynomial of one turn. */
#ifndef DHGEN_GENERAL_FOUR_TURNS_H
#define DHGEN_GENERAL_FOUR_TURNS_H

#include "closed_polynomial.h"

/* At a root the better branch is taken, and the other one too where its determinant is this small:
 * a double root may be one of each. */
#define DHGEN_NEARLY_FLAT 0.01
/* Where the slides are parallel, and the translation is farther than this from being along them,
 * they would have to reach to infinity: such roots belong to no solution, and arms at right angles
 * have them always. Beside parallel slides a solution needs no longer ones than elsewhere. */
#define DHGEN_ALONG 1e-06
/* Times the sine between the slides: as far as they reach [arm sizes]. */
#define DHGEN_FARTHEST 10000.0
/* Rounding over the size of the determinants, which are small where the slides are nearly parallel
 * all around the circle: its root is how far a double root may be off. */
#define DHGEN_MOVED 1e-14
/* Where the third turn's axis is parallel to the second's or the fourth's, the entry zz does not
 * give the turn: the square of the product of the sines between these axes. */
#define DHGEN_NO_ANGLE 1e-18
/* Where the axes of the second and the fourth turn are parallel only the sum of their angles is
 * determined, and the third is a double root: the square of the sine between these axes. */
#define DHGEN_ALIGNED_AXES 1e-06
/* The square of what rounding leaves of the normal of slides that are parallel. */
#define DHGEN_PARALLEL 1e-30

DHGEN_TABLE double dhgen_nothing[12] = { 0.0 };

/* Four turns and two slides: J(phi1) L0 J(phi2) L1 ... J(phi6) L5 = 1 with phi1 a turn. Slides
 * leave directions alone, Rz(phi1) A Rz Rz B Rz C Rz D = 1 for the rotations between the turns:
 * with phi1 given, Rz N Rz = M = A' Rz(-phi1) D', N = B Rz C. Both have the same entry zz, which
 * gives the middle turn, a square root; what turns N's third column and row to those of M are the
 * others. The translation is linear in the slides' lengths: the determinant of it and of their
 * directions is zero. Numbers x + y sqrt(delta), with delta the discriminant, are pairs of x and y.
 */
typedef struct {
    const dhgen_general_arm *arm;
    const dhgen_formulation *form;
    double link[6][12];
    double between[4][12]; /* A, B, C, D; what is no rotation means nothing */
} dhgen_four_turns_setting;

typedef dhgen_lane dhgen_pair[2];

/* What the hidden turn fixes: delta, what the polynomial is multiplied by, cosines and sines of the
 * other turns, the directions of the slides, the translation and their determinant. */
typedef struct {
    dhgen_lane delta, w;
    dhgen_pair c[3], s[3], direction[2][3], translation[3], determinant;
} dhgen_both;

/* What a formulation makes of the loop. */
DHGEN_FN void dhgen_set_four_turns(dhgen_four_turns_setting *set, int which, const dhgen_loop *loop)
{
    int number = -1;
    set->arm = loop->arm;
    set->form = &loop->arm->formulation[which];
    dhgen_formulation_links(set->form, loop, set->link);
    for (int i = 0; i < 6; i++) {
        if (dhgen_is_slide(set->arm, set->form->joint[i])) {
            dhgen_append(set->between[number], set->link[i]);
        } else {
            dhgen_copy_link(set->link[i], set->between[++number]);
        }
    }
}

/* Whether every solution has a root. Where the third turn's axis is parallel to the one before or
 * behind it, the entry zz does not give this turn, and roots show nothing. */
DHGEN_FN int dhgen_roots_determine_all(const dhgen_four_turns_setting *set)
{
    const double *const B = set->between[1], *const C = set->between[2];
    return (B[8] * B[8] + B[9] * B[9]) * (C[2] * C[2] + C[6] * C[6]) > DHGEN_NO_ANGLE;
}

/* Adds sign a b to out. */
DHGEN_INLINE void dhgen_add_product(
    const dhgen_pair a, const dhgen_pair b, dhgen_lane delta, double sign, dhgen_pair out)
{
    out[0] += sign * (a[0] * b[0] + delta * a[1] * b[1]);
    out[1] += sign * (a[0] * b[1] + a[1] * b[0]);
}

/* The first two entries of R v; R's entries lie `row` apart from row to row, and `entry` in a row.
 */
DHGEN_INLINE void dhgen_rotated(
    const double *R, int row, int entry, dhgen_pair v[3], dhgen_pair out[2])
{
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            const double *const r = R + row * i;
            out[i][k] = r[0] * v[0][k] + r[entry] * v[1][k] + r[2 * entry] * v[2][k];
        }
    }
}

/* Cosine and sine of the turn that takes the plane vector v to (x, y), both as long as sqrt(w). */
DHGEN_INLINE void dhgen_turn_between(
    dhgen_pair v[2], dhgen_lane x, dhgen_lane y, dhgen_lane w, dhgen_pair c, dhgen_pair s)
{
    for (int k = 0; k < 2; k++) {
        c[k] = (x * v[0][k] + y * v[1][k]) / w;
        s[k] = (y * v[0][k] - x * v[1][k]) / w;
    }
}

/* The cosines and sines of the other turns. */
DHGEN_INLINE void dhgen_linkage(
    const dhgen_four_turns_setting *set, dhgen_lane c, dhgen_lane s, dhgen_both *out)
{
    const double *const A = set->between[0], *const B = set->between[1], *const C = set->between[2];
    const double *const D = set->between[3];
    const double b = B[8] * C[2] + B[9] * C[6], a = B[9] * C[2] - B[8] * C[6];
    const double q = a * a + b * b + DHGEN_TINY;
    dhgen_lane M[3][3], k;
    dhgen_pair v[3], turned[2];
    for (int j = 0; j < 3; j++) {
        const dhgen_lane x = c * D[4 * j] + s * D[4 * j + 1], y = c * D[4 * j + 1] - s * D[4 * j];
        for (int i = 0; i < 3; i++) {
            M[i][j] = A[i] * x + A[4 + i] * y + A[8 + i] * D[4 * j + 2];
        }
    }
    k = M[2][2] - B[10] * C[10];
    out->delta = a * a + b * b - k * k;
    out->w = M[0][2] * M[0][2] + M[1][2] * M[1][2] + DHGEN_TINY;
    out->c[1][0] = b * k / q;
    out->c[1][1] = dhgen_lane_all(-a / q);
    out->s[1][0] = a * k / q;
    out->s[1][1] = dhgen_lane_all(b / q);
    v[2][1] = dhgen_lane_all(0.0);
    for (int i = 0; i < 2; i++) { /* the third column of B Rz C */
        v[0][i] = C[2] * out->c[1][i] - C[6] * out->s[1][i];
        v[1][i] = C[2] * out->s[1][i] + C[6] * out->c[1][i];
    }
    v[2][0] = dhgen_lane_all(C[10]);
    dhgen_rotated(B, 4, 1, v, turned);
    dhgen_turn_between(turned, M[0][2], M[1][2], out->w, out->c[0], out->s[0]);
    for (int i = 0; i < 2; i++) { /* its third row */
        v[0][i] = B[8] * out->c[1][i] + B[9] * out->s[1][i];
        v[1][i] = B[9] * out->c[1][i] - B[8] * out->s[1][i];
    }
    v[2][0] = dhgen_lane_all(B[10]);
    dhgen_rotated(C, 1, 4, v, turned);
    dhgen_turn_between(turned, M[2][0], M[2][1], out->w, out->c[2], out->s[2]);
    for (int i = 0; i < 2; i++) {
        out->s[2][i] = -out->s[2][i];
    }
}

/* T becomes T Rz for the turn with this cosine and sine. */
DHGEN_INLINE void dhgen_turn_pair(
    dhgen_rigid T[2], const dhgen_pair c, const dhgen_pair s, dhgen_lane delta)
{
    for (int i = 0; i < 3; i++) {
        const dhgen_pair x = { T[0][i][0], T[1][i][0] }, y = { T[0][i][1], T[1][i][1] };
        dhgen_pair first = { x[0] * 0.0, x[0] * 0.0 }, second = { x[0] * 0.0, x[0] * 0.0 };
        dhgen_add_product(x, c, delta, 1.0, first);
        dhgen_add_product(y, s, delta, 1.0, first);
        dhgen_add_product(y, c, delta, 1.0, second);
        dhgen_add_product(x, s, delta, -1.0, second);
        for (int k = 0; k < 2; k++) {
            T[k][i][0] = first[k];
            T[k][i][1] = second[k];
        }
    }
}

/* What the hidden turn fixes, once around the loop. */
DHGEN_INLINE void dhgen_around_once(
    const dhgen_four_turns_setting *set, dhgen_lane c, dhgen_lane s, dhgen_both *out)
{
    dhgen_rigid T[2];
    int angle = 0, slide = 0;
    dhgen_linkage(set, c, s, out);
    dhgen_broadcast(T[0], dhgen_identity);
    dhgen_broadcast(T[1], dhgen_nothing);
    dhgen_turn(T[0], c, s);
    dhgen_multiply(T[0], set->link[0]);
    for (int i = 1; i < 6; i++) {
        if (dhgen_is_slide(set->arm, set->form->joint[i])) {
            for (int j = 0; j < 3; j++) {
                out->direction[slide][j][0] = T[0][j][2];
                out->direction[slide][j][1] = T[1][j][2];
            }
            slide++;
        } else {
            dhgen_turn_pair(T, out->c[angle], out->s[angle], out->delta);
            angle++;
        }
        dhgen_multiply(T[0], set->link[i]);
        dhgen_multiply(T[1], set->link[i]);
    }
    out->determinant[0] = out->determinant[1] = dhgen_lane_all(0.0);
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        dhgen_pair normal = { dhgen_lane_all(0.0), dhgen_lane_all(0.0) };
        out->translation[i][0] = T[0][i][3];
        out->translation[i][1] = T[1][i][3];
        dhgen_add_product(out->direction[0][i1], out->direction[1][i2], out->delta, 1.0, normal);
        dhgen_add_product(out->direction[0][i2], out->direction[1][i1], out->delta, -1.0, normal);
        dhgen_add_product(normal, out->translation[i], out->delta, 1.0, out->determinant);
    }
}

/* The polynomial of the hidden turn, of degree 4: the product over both branches. */
DHGEN_INLINE dhgen_lane dhgen_four_turns_polynomial(
    const dhgen_four_turns_setting *set, dhgen_lane c, dhgen_lane s)
{
    dhgen_both at;
    dhgen_around_once(set, c, s, &at);
    return at.w
        * (at.determinant[0] * at.determinant[0]
            - at.determinant[1] * at.determinant[1] * at.delta);
}

/* The square root of the discriminant, of zero where it is negative. */
DHGEN_INLINE dhgen_lane dhgen_root(dhgen_lane delta)
{
    return dhgen_lane_sqrt(dhgen_lane_max(delta, dhgen_lane_all(0.0)));
}

/* The larger components of a x b, on one of the branches, in magnitude. */
DHGEN_INLINE double dhgen_across(dhgen_pair a[3], dhgen_pair b[3], double root, int lane)
{
    double most = 0.0, u[3], v[3];
    for (int i = 0; i < 3; i++) {
        DHGEN_ROWS_IN_ROOM(each, 4, DHGEN_BOARD(4));
        DHGEN_STORE(each[0], a[i][0]);
        DHGEN_STORE(each[1], a[i][1]);
        DHGEN_STORE(each[2], b[i][0]);
        DHGEN_STORE(each[3], b[i][1]);
        u[i] = each[0][lane] + root * each[1][lane];
        v[i] = each[2][lane] + root * each[3][lane];
    }
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        const double x = fabs(u[i1] * v[i2] - u[i2] * v[i1]);
        most = x > most ? x : most;
    }
    return most;
}

/* At every root the better branch, and the other one where its determinant is small, too: a double
 * root may be one of each. Where the slides are parallel and the translation is not along them,
 * they would have to reach too far. Where the second and the fourth turn are parallel the root does
 * not determine them. */
DHGEN_FN void dhgen_four_turns_ways(const dhgen_four_turns_setting *set, const double *c,
    const double *s, int count, int group, dhgen_ways *out)
{
    for (int from = 0; from < count; from += DHGEN_GENERAL_LANES) {
        DHGEN_LANES_IN_ROOM(U, DHGEN_BOARD(0));
        DHGEN_LANES_IN_ROOM(V, DHGEN_BOARD(1));
        DHGEN_LANES_IN_ROOM(root, DHGEN_BOARD(2));
        DHGEN_LANES_IN_ROOM(w, DHGEN_BOARD(3));
        dhgen_both at;
        dhgen_around_once(
            set, dhgen_lane_from(c, from, count), dhgen_lane_from(s, from, count), &at);
        DHGEN_STORE(U, at.determinant[0]);
        DHGEN_STORE(V, at.determinant[1] * dhgen_root(at.delta));
        DHGEN_STORE(root, dhgen_root(at.delta));
        DHGEN_STORE(w, at.w);
        for (int k = 0; k < DHGEN_GENERAL_LANES && from + k < count; k++) {
            out->aligned |= w[k] <= DHGEN_ALIGNED_AXES;
            const double better = (U[k] < 0.0) == (V[k] < 0.0) ? -1.0 : 1.0;
            const double moved = sqrt(DHGEN_MOVED / (fabs(U[k]) + fabs(V[k]) + DHGEN_TINY));
            const int ways = fabs(U[k] - better * V[k]) < DHGEN_NEARLY_FLAT ? 2 : 1;
            for (int way = 0; way < ways && out->count < DHGEN_CANDIDATES; way++) {
                const double x = (way ? -better : better) * root[k];
                const double across = dhgen_across(at.direction[0], at.translation, x, k);
                if (across > DHGEN_ALONG && across > moved
                    && across
                        > DHGEN_FARTHEST * dhgen_across(at.direction[0], at.direction[1], x, k)) {
                    out->far[group + from + k]++;
                    continue;
                }
                out->group[out->count] = group + from + k;
                out->c[out->count] = c[from + k];
                out->s[out->count] = s[from + k];
                out->sign[0][out->count] = way ? -better : better;
                out->sign[1][out->count] = 1.0;
                out->count++;
            }
        }
    }
}

/* The cosines and sines of all turns and the lengths of the slides, on the branch with this sign.
 */
DHGEN_INLINE void dhgen_four_turns_joints(const void *setting, dhgen_lane c1, dhgen_lane s1,
    dhgen_lane sign, dhgen_lane unused, dhgen_lane c[6], dhgen_lane s[6])
{
    const dhgen_four_turns_setting *const set = (const dhgen_four_turns_setting *)setting;
    dhgen_both at;
    dhgen_lane root, u[3], v[3], p[3], square = dhgen_lane_all(DHGEN_PARALLEL), length[2];
    int angle = 0, slide = 0;
    (void)unused;
    dhgen_around_once(set, c1, s1, &at);
    root = sign * dhgen_root(at.delta);
    for (int i = 0; i < 3; i++) {
        u[i] = at.direction[0][i][0] + root * at.direction[0][i][1];
        v[i] = at.direction[1][i][0] + root * at.direction[1][i][1];
        p[i] = at.translation[i][0] + root * at.translation[i][1];
    }
    /* p + d u + e v = 0 times v and u; their scalar products would lose digits of the sine */
    length[0] = length[1] = dhgen_lane_all(0.0);
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        const dhgen_lane normal = u[i1] * v[i2] - u[i2] * v[i1];
        square += normal * normal;
        length[0] += normal * (v[i1] * p[i2] - v[i2] * p[i1]);
        length[1] += normal * (p[i1] * u[i2] - p[i2] * u[i1]);
    }
    square = 1.0 / square;
    c[set->form->joint[0]] = c1;
    s[set->form->joint[0]] = s1;
    for (int i = 1; i < 6; i++) {
        const int joint = set->form->joint[i];
        if (dhgen_is_slide(set->arm, joint)) {
            c[joint] = dhgen_lane_all(1.0);
            s[joint] = square * length[slide++];
        } else {
            c[joint] = at.c[angle][0] + root * at.c[angle][1];
            s[joint] = at.s[angle][0] + root * at.s[angle][1];
            dhgen_normalize(&c[joint], &s[joint]);
            angle++;
        }
    }
}

/* The polynomial at the sample angles, through a Moebius map. */
DHGEN_FN void dhgen_sample_four_turns(
    const void *setting, const dhgen_moebius *map, double samples[DHGEN_SAMPLES])
{
    for (int k = 0; k < DHGEN_SAMPLES; k += DHGEN_GENERAL_LANES) {
        dhgen_lane c = DHGEN_LOAD_SOME(dhgen_sample_c + k, DHGEN_SAMPLES - k);
        dhgen_lane s = DHGEN_LOAD_SOME(dhgen_sample_s + k, DHGEN_SAMPLES - k);
        const dhgen_lane square = dhgen_apply_moebius(map, &c, &s);
        const dhgen_lane f =
            dhgen_four_turns_polynomial((const dhgen_four_turns_setting *)setting, c, s);
        DHGEN_STORE_SOME(samples + k, dhgen_weighted(f, square), DHGEN_SAMPLES - k);
    }
}

/* Adds the solutions that a formulation of an arm with two slides finds; returns whether that is
 * certainly everything. */
DHGEN_FN int dhgen_solve_four_turns(int which, const dhgen_loop *loop, dhgen_found *found)
{
    dhgen_four_turns_setting set;
    const dhgen_source source = { dhgen_sample_four_turns, 0, &set };
    dhgen_roots roots;
    dhgen_ways ways;
    dhgen_set_four_turns(&set, which, loop);
    if (!dhgen_real_roots(&source, &roots)) {
        return 0;
    }
    DHGEN_PLACE_ROWS(&ways, sign, 2, DHGEN_CANDIDATES);
    dhgen_clear_ways(&ways);
    dhgen_four_turns_ways(&set, roots.c, roots.s, roots.simple, 0, &ways);
    dhgen_four_turns_ways(&set, roots.double_c, roots.double_s, roots.doubles, roots.simple, &ways);
    found->doubles += roots.doubles;
    return dhgen_refine_ways(
               loop, dhgen_four_turns_joints, &set, &ways, 1, roots.simple, roots.doubles, found)
        && roots.complete && dhgen_roots_determine_all(&set) && !ways.aligned;
}

#endif
