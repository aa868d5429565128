/* SPDX-License-Identifier: MIT
 *
 * Monomials of a point and a direction, and what joints make of them. */
#ifndef DHGEN_GENERAL_MONOMIALS_H
#define DHGEN_GENERAL_MONOMIALS_H

#include "motions.h"

/* The length of a hidden slide at a quarter of a turn [arm sizes], about how far slides go, and its
 * square. */
#define DHGEN_HIDDEN_UNIT 2.5
#define DHGEN_HIDDEN_SQUARE 6.25
/* Cosine and sine of half of the way from one sample angle to the next, nearly: no sample is an
 * infinite length. */
#define DHGEN_HIDDEN_COSINE 0.9911504424778761
#define DHGEN_HIDDEN_SINE 0.13274336283185842

/* Applies a rigid motion to the monomials of a point and a direction, at once for several columns:
 * 1, l, p, p.p, p.l, p x l and (p.p) l - 2 (p.l) p. */
DHGEN_INLINE void dhgen_act(const double K[12], dhgen_lane x[15])
{
    const double t[3] = { K[3], K[7], K[11] };
    const double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    dhgen_lane u[3], q[3], v[3], w[3], along;
    DHGEN_UNROLL
    for (int i = 0; i < 3; i++) {
        const double *const row = K + 4 * i;
        u[i] = row[0] * x[1] + row[1] * x[2] + row[2] * x[3];
        q[i] = row[0] * x[4] + row[1] * x[5] + row[2] * x[6];
        v[i] = row[0] * x[9] + row[1] * x[10] + row[2] * x[11];
        w[i] = row[0] * x[12] + row[1] * x[13] + row[2] * x[14];
    }
    along = t[0] * u[0] + t[1] * u[1] + t[2] * u[2];
    x[7] += 2.0 * (t[0] * q[0] + t[1] * q[1] + t[2] * q[2]) + square * x[0];
    x[8] += along;
    DHGEN_UNROLL
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        x[1 + i] = u[i];
        x[4 + i] = q[i] + t[i] * x[0];
        x[9 + i] = v[i] + (t[i1] * u[i2] - t[i2] * u[i1]);
        x[12 + i] = w[i] - 2.0 * (t[i] * x[8] + (t[i1] * v[i2] - t[i2] * v[i1])) + square * u[i];
    }
}

/* What a joint that turns makes of monomials: the coefficients of 1, cos and sin of its angle. */
DHGEN_INLINE void dhgen_cosines(const dhgen_lane x[15], dhgen_lane part[3][15])
{
    const dhgen_lane zero = { 0 };
    for (int i = 0; i < 15; i++) {
        part[0][i] = x[i];
        part[1][i] = part[2][i] = zero;
    }
    for (int i = 0; i < 4; i++) {
        const int at = 1 + 3 * i + 2 * (i / 2);
        part[0][at] = part[0][at + 1] = zero;
        part[1][at] = part[2][at + 1] = x[at];
        part[1][at + 1] = x[at + 1];
        part[2][at] = -x[at + 1];
    }
}

/* What a joint that turns makes of monomials: the coefficients of x^2, x and 1 for x = tan(phi/2),
 * times 1 + x^2. */
DHGEN_INLINE void dhgen_tangents(const dhgen_lane x[15], dhgen_lane part[3][15])
{
    dhgen_cosines(x, part);
    for (int i = 0; i < 15; i++) {
        const dhgen_lane one = part[0][i], cosine = part[1][i];
        part[0][i] = one - cosine;
        part[1][i] = 2.0 * part[2][i];
        part[2][i] = one + cosine;
    }
}

/* What a joint that slides makes of monomials: the coefficients of 1, d and d^2 in the places
 * `one`, 1 and `square`. */
DHGEN_INLINE void dhgen_lengths(int one, int square, const dhgen_lane x[15], dhgen_lane part[3][15])
{
    const dhgen_lane zero = { 0 };
    for (int i = 0; i < 15; i++) {
        part[one][i] = x[i];
        part[1][i] = part[square][i] = zero;
    }
    part[1][6] = part[square][7] = x[0];
    part[1][7] = 2.0 * x[6];
    part[1][8] = x[3];
    part[1][9] = -x[2];
    part[1][10] = x[1];
    part[1][12] = 2.0 * x[10];
    part[1][13] = -2.0 * x[9];
    part[1][14] = -2.0 * x[8];
    part[square][12] = x[1];
    part[square][13] = x[2];
    part[square][14] = -x[3];
}

/* The coefficients of 1, d and d^2, in place of 1, cos and sin. */
DHGEN_INLINE void dhgen_rising_lengths(const dhgen_lane x[15], dhgen_lane part[3][15])
{
    dhgen_lengths(0, 2, x, part);
}

/* The coefficients of d^2, d and 1, in place of a half-angle tangent's. */
DHGEN_INLINE void dhgen_falling_lengths(const dhgen_lane x[15], dhgen_lane part[3][15])
{
    dhgen_lengths(2, 0, x, part);
}
/* What a joint that slides makes of monomials: the coefficients of 1, cos and sin of psi, where d
 * = 2.5 tan(psi'/2), times 1 + cos psi'; psi' is psi and an advance, with which no sampled angle is
 * an infinite length. */
DHGEN_INLINE void dhgen_on_circle(const dhgen_lane x[15], dhgen_lane part[3][15])
{
    dhgen_rising_lengths(x, part);
    for (int i = 0; i < 15; i++) {
        const dhgen_lane one = part[0][i], square = DHGEN_HIDDEN_SQUARE * part[2][i];
        const dhgen_lane cosine = one - square, sine = DHGEN_HIDDEN_UNIT * part[1][i];
        part[0][i] = one + square;
        part[1][i] = DHGEN_HIDDEN_COSINE * cosine + DHGEN_HIDDEN_SINE * sine;
        part[2][i] = DHGEN_HIDDEN_COSINE * sine - DHGEN_HIDDEN_SINE * cosine;
    }
}

/* 1 + cos psi', which vanishes where the length is infinite. */
DHGEN_INLINE dhgen_lane dhgen_nearness(dhgen_lane c, dhgen_lane s)
{
    return 1.0 + DHGEN_HIDDEN_COSINE * c - DHGEN_HIDDEN_SINE * s;
}

/* The length from cosine and sine of psi. */
DHGEN_INLINE dhgen_lane dhgen_hidden_length(dhgen_lane c, dhgen_lane s)
{
    const dhgen_lane above = dhgen_nearness(c, s);
    const dhgen_lane sine = DHGEN_HIDDEN_SINE * c + DHGEN_HIDDEN_COSINE * s;
    return DHGEN_HIDDEN_UNIT * sine * above / (above * above + DHGEN_TINY);
}

#endif
