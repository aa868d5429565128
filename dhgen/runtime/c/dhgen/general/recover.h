/* SPDX-License-Identifier: MIT
 *
 * The other joints of a formulation from its hidden angle and a null vector. */
#ifndef DHGEN_GENERAL_RECOVER_H
#define DHGEN_GENERAL_RECOVER_H

#include "motions.h"

/* The terms a c + b s + w of five invariants of B = Rz K Rz(phi5) M Rz: l_z, p_z, p.l, p.p / 2 and
 * (p x l)_z; and the 2x5 matrix that solves them for c and s by least squares. */
DHGEN_FN void dhgen_turning_invariants(
    const double K[12], const double M[12], double w[5], double solve[2][5])
{
    const double t[3] = { K[3], K[7], K[11] };
    const double e[3] = { M[2], M[6], M[10] }, u[3] = { M[3], M[7], M[11] };
    const double v[3] = { u[1] * e[2] - u[2] * e[1], u[2] * e[0] - u[0] * e[2],
        u[0] * e[1] - u[1] * e[0] };
    double foot[3], side[3], a[5], b[5], aa = 0.0, ab = 0.0, bb = 0.0, det;
    const double *const axis = K + 8;
    for (int j = 0; j < 3; j++) {
        foot[j] = K[j] * t[0] + K[4 + j] * t[1] + K[8 + j] * t[2];
        side[j] = K[4 + j] * t[0] - K[j] * t[1]; /* K' (z x t) */
    }
    const double *const left[5] = { axis, axis, foot, foot, axis };
    const double *const right[5] = { e, u, e, u, v };
    for (int i = 0; i < 5; i++) {
        a[i] = left[i][0] * right[i][0] + left[i][1] * right[i][1];
        b[i] = left[i][1] * right[i][0] - left[i][0] * right[i][1];
        w[i] = left[i][2] * right[i][2];
    }
    a[4] += side[0] * e[0] + side[1] * e[1];
    b[4] += side[1] * e[0] - side[0] * e[1];
    w[4] += side[2] * e[2];
    w[1] += t[2];
    w[2] += u[0] * e[0] + u[1] * e[1] + u[2] * e[2];
    w[3] +=
        0.5 * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    for (int i = 0; i < 5; i++) {
        aa += a[i] * a[i];
        ab += a[i] * b[i];
        bb += b[i] * b[i];
    }
    det = aa * bb - ab * ab + DHGEN_TINY;
    for (int i = 0; i < 5; i++) {
        solve[0][i] = (bb * a[i] - ab * b[i]) / det;
        solve[1][i] = (aa * b[i] - ab * a[i]) / det;
    }
}

/* With a slide on the right side the terms a c + b s + w of invariants of B = Rz K Rz(phi5) M Tz,
 * its third row; or, where phi5 is a length, the terms b d + w of the invariants of B = Rz K Tz(d)
 * M Rz that are linear in it, p_z, p.l and (p x l)_z; and the matrix that solves them for c and s
 * by least squares. */
DHGEN_FN void dhgen_sliding_invariants(const dhgen_general_arm *arm, const int joint[6],
    const double K[12], const double M[12], double w[5], double solve[2][5])
{
    const double e[3] = { M[2], M[6], M[10] }, u[3] = { M[3], M[7], M[11] };
    const double slope[3] = { K[10], e[2], K[9] * e[0] - K[8] * e[1] };
    const double square =
        slope[0] * slope[0] + slope[1] * slope[1] + slope[2] * slope[2] + DHGEN_TINY;
    const double across = K[8] * K[8] + K[9] * K[9] + DHGEN_TINY;
    double l[3], q[3];
    for (int i = 0; i < 3; i++) {
        l[i] = K[4 * i] * e[0] + K[4 * i + 1] * e[1] + K[4 * i + 2] * e[2];
        q[i] = K[4 * i] * u[0] + K[4 * i + 1] * u[1] + K[4 * i + 2] * u[2] + K[4 * i + 3];
    }
    if (dhgen_is_slide(arm, joint[4])) {
        w[0] = q[2];
        w[1] = q[0] * l[0] + q[1] * l[1] + q[2] * l[2];
        w[2] = q[0] * l[1] - q[1] * l[0];
    }
    for (int j = 0; j < 3; j++) {
        if (dhgen_is_slide(arm, joint[4])) {
            solve[0][j] = 0.0;
            solve[1][j] = slope[j] / square;
        } else {
            w[j] = K[10] * M[8 + j];
            solve[0][j] = (K[8] * M[j] + K[9] * M[4 + j]) / across;
            solve[1][j] = (K[9] * M[j] - K[8] * M[4 + j]) / across;
        }
    }
}

/* The terms of the invariants of a formulation, and the matrix that solves them. */
DHGEN_INLINE void dhgen_invariants(const dhgen_general_arm *arm, const int joint[6],
    double link[6][12], double w[5], double solve[2][5])
{
    if (dhgen_has(arm, DHGEN_RIGHT_SLIDE)) {
        dhgen_sliding_invariants(arm, joint, link[3], link[4], w, solve);
    } else {
        dhgen_turning_invariants(link[3], link[4], w, solve);
    }
}

/* phi_2 and phi_3 from the null vector */
DHGEN_INLINE void dhgen_partners(const dhgen_general_arm *arm, const int joint[6],
    const dhgen_lane n[6], dhgen_lane c[6], dhgen_lane s[6])
{
    const dhgen_lane up = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const dhgen_lane down = n[3] * n[3] + n[4] * n[4] + n[5] * n[5];
    dhgen_lane row[3], sign, top, bottom;
    for (int i = 0; i < 3; i++) {
        row[i] = dhgen_lane_select(up > down, n[i], n[3 + i]);
    }
    sign = dhgen_lane_with_sign(dhgen_lane_all(1.0), row[0] + row[2]);
    c[1] = sign * (row[2] - row[0]);
    s[1] = sign * 2.0 * row[1];
    top = n[0] * row[0] + n[1] * row[1] + n[2] * row[2];
    bottom = n[3] * row[0] + n[4] * row[1] + n[5] * row[2];
    c[2] = bottom * bottom - top * top;
    s[2] = 2.0 * top * bottom;
    dhgen_normalize(&c[1], &s[1]);
    dhgen_normalize(&c[2], &s[2]);
    if (dhgen_has(arm, DHGEN_LEFT_SLIDE)) {
        if (dhgen_is_slide(arm, joint[1])) { /* x^2 over x and x over 1, by least squares */
            s[1] = row[1] * (row[0] + row[2]) / (row[1] * row[1] + row[2] * row[2] + DHGEN_TINY);
        }
        if (dhgen_is_slide(arm, joint[2])) {
            s[2] = top * bottom / (bottom * bottom + DHGEN_TINY);
        }
    }
}

/* Without a slide on the right side phi_4, phi_5, phi_6 from phi_1, phi_2, phi_3; `w` and `solve`
 * belong to the invariants. */
DHGEN_INLINE void dhgen_turning_others(const dhgen_general_arm *arm, const int joint[6],
    double link[6][12], const double w[5], double solve[2][5], dhgen_lane c[6], dhgen_lane s[6])
{
    dhgen_rigid G, C;
    dhgen_lane l[3], q[3], value[5], x, y;
    dhgen_broadcast(G, link[5]);
    for (int i = 0; i < 3; i++) {
        dhgen_move(arm, G, joint[i], c[i], s[i]);
        dhgen_multiply(G, link[i]);
    }
    /* B is the inverse of G; l and q are its third and fourth column */
    for (int j = 0; j < 3; j++) {
        l[j] = G[2][j];
        q[j] = -(G[0][j] * G[0][3] + G[1][j] * G[1][3] + G[2][j] * G[2][3]);
    }
    value[0] = l[2];
    value[1] = q[2];
    value[2] = -G[2][3]; /* q.l */
    value[3] = 0.5 * (G[0][3] * G[0][3] + G[1][3] * G[1][3] + G[2][3] * G[2][3]);
    value[4] = q[0] * l[1] - q[1] * l[0];
    c[4] = s[4] = dhgen_lane_all(0.0);
    for (int i = 0; i < 5; i++) {
        c[4] += solve[0][i] * (value[i] - w[i]);
        s[4] += solve[1][i] * (value[i] - w[i]);
    }
    dhgen_normalize(&c[4], &s[4]);
    dhgen_broadcast(C, link[3]);
    dhgen_turn(C, c[4], s[4]);
    dhgen_multiply(C, link[4]);
    c[3] = C[0][2] * l[0] + C[1][2] * l[1] + C[0][3] * q[0] + C[1][3] * q[1];
    s[3] = C[0][2] * l[1] - C[1][2] * l[0] + C[0][3] * q[1] - C[1][3] * q[0];
    dhgen_normalize(&c[3], &s[3]);
    c[5] = s[5] = dhgen_lane_all(0.0);
    for (int i = 0; i < 2; i++) {
        /* columns of Rz(phi_4) C against columns of B */
        for (int j = 0; j < 2; j++) {
            x = c[3] * C[0][j] - s[3] * C[1][j];
            y = s[3] * C[0][j] + c[3] * C[1][j];
            value[0] = x * G[i][0] + y * G[i][1] + C[2][j] * G[i][2];
            if (i == j) {
                c[5] += value[0];
            } else {
                s[5] += i ? -value[0] : value[0];
            }
        }
    }
    dhgen_normalize(&c[5], &s[5]);
}

/* With a slide on the right side phi_4, phi_5, phi_6 from phi_1, phi_2, phi_3; `w` and `solve`
 * belong to the invariants. */
DHGEN_INLINE void dhgen_sliding_others(const dhgen_general_arm *arm, const int joint[6],
    double link[6][12], const double w[5], double solve[2][5], dhgen_lane c[6], dhgen_lane s[6])
{
    dhgen_rigid G, C;
    dhgen_lane l[3], q[3], value[3], x, y;
    dhgen_broadcast(G, link[5]);
    for (int i = 0; i < 3; i++) {
        dhgen_move(arm, G, joint[i], c[i], s[i]);
        dhgen_multiply(G, link[i]);
    }
    /* B is the inverse of G; l and q are its third and fourth column */
    for (int j = 0; j < 3; j++) {
        l[j] = G[2][j];
        q[j] = -(G[0][j] * G[0][3] + G[1][j] * G[1][3] + G[2][j] * G[2][3]);
    }
    value[0] = G[0][2];
    value[1] = G[1][2];
    value[2] = G[2][2];
    if (dhgen_is_slide(arm, joint[4])) {
        value[0] = q[2];
        value[1] = -G[2][3]; /* q.l */
        value[2] = q[0] * l[1] - q[1] * l[0];
    }
    c[4] = s[4] = dhgen_lane_all(0.0);
    for (int i = 0; i < 3; i++) {
        c[4] += solve[0][i] * (value[i] - w[i]);
        s[4] += solve[1][i] * (value[i] - w[i]);
    }
    if (!dhgen_is_slide(arm, joint[4])) {
        dhgen_normalize(&c[4], &s[4]);
    }
    dhgen_broadcast(C, link[3]);
    dhgen_move(arm, C, joint[4], c[4], s[4]);
    dhgen_multiply(C, link[4]);
    c[3] = C[0][2] * l[0] + C[1][2] * l[1];
    s[3] = C[0][2] * l[1] - C[1][2] * l[0];
    if (dhgen_is_slide(arm, joint[4])) {
        c[3] += C[0][3] * q[0] + C[1][3] * q[1];
        s[3] += C[0][3] * q[1] - C[1][3] * q[0];
    } else {
        for (int j = 0; j < 2; j++) {
            c[3] += C[0][j] * G[j][0] + C[1][j] * G[j][1];
            s[3] += C[0][j] * G[j][1] - C[1][j] * G[j][0];
        }
    }
    dhgen_normalize(&c[3], &s[3]);
    if (dhgen_is_slide(arm, joint[5])) { /* along the third column of B */
        x = c[3] * C[0][3] - s[3] * C[1][3];
        y = s[3] * C[0][3] + c[3] * C[1][3];
        c[5] = dhgen_lane_all(1.0);
        s[5] = -G[2][3] - x * l[0] - y * l[1] - C[2][3] * l[2];
        return;
    }
    c[5] = s[5] = dhgen_lane_all(0.0);
    for (int i = 0; i < 2; i++) {
        /* columns of Rz(phi_4) C against columns of B */
        for (int j = 0; j < 2; j++) {
            x = c[3] * C[0][j] - s[3] * C[1][j];
            y = s[3] * C[0][j] + c[3] * C[1][j];
            value[0] = x * G[i][0] + y * G[i][1] + C[2][j] * G[i][2];
            if (i == j) {
                c[5] += value[0];
            } else {
                s[5] += i ? -value[0] : value[0];
            }
        }
    }
    dhgen_normalize(&c[5], &s[5]);
}

/* phi_4, phi_5, phi_6 from phi_1, phi_2, phi_3; `w` and `solve` belong to the invariants. */
DHGEN_INLINE void dhgen_others(const dhgen_general_arm *arm, const int joint[6], double link[6][12],
    const double w[5], double solve[2][5], dhgen_lane c[6], dhgen_lane s[6])
{
    if (dhgen_has(arm, DHGEN_RIGHT_SLIDE)) {
        dhgen_sliding_others(arm, joint, link, w, solve, c, s);
    } else {
        dhgen_turning_others(arm, joint, link, w, solve, c, s);
    }
}

#endif
