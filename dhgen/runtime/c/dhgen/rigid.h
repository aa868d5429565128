/* SPDX-License-Identifier: MIT
 *
 * Rigid transforms, three rows of four. */
#ifndef DHGEN_RIGID_H
#define DHGEN_RIGID_H

#include "interface.h"

/* C = A B for rigid transforms, three rows of four. */
DHGEN_INLINE void dhgen_compose(const double A[12], const double B[12], double C[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            C[4 * i + j] = A[4 * i] * B[j] + A[4 * i + 1] * B[4 + j] + A[4 * i + 2] * B[8 + j]
                + (j == 3 ? A[4 * i + 3] : 0.0);
        }
    }
}

/* The length of what a transform moves by. */
DHGEN_INLINE double dhgen_length_of(const double C[12])
{
    return sqrt(C[3] * C[3] + C[7] * C[7] + C[11] * C[11]);
}

/* B becomes the inverse of the rigid transform A. */
DHGEN_INLINE void dhgen_invert(const double A[12], double B[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            B[4 * i + j] = A[4 * j + i];
        }
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11]);
    }
}

/* T, three rows of four, becomes T Rz. */
DHGEN_INLINE void dhgen_append_turn(double T[12], double c, double s)
{
    for (int i = 0; i < 12; i += 4) {
        const double x = T[i];
        T[i] = x * c + T[i + 1] * s;
        T[i + 1] = T[i + 1] * c - x * s;
    }
}

/* T, three rows of four, becomes T Tz. */
DHGEN_INLINE void dhgen_append_slide(double T[12], double d)
{
    for (int i = 0; i < 12; i += 4) {
        T[i + 3] += T[i + 2] * d;
    }
}

/* B becomes A. */
DHGEN_INLINE void dhgen_copy_link(const double A[12], double B[12])
{
    for (int i = 0; i < 12; i++) {
        B[i] = A[i];
    }
}

/* A becomes A B. */
DHGEN_INLINE void dhgen_append(double A[12], const double B[12])
{
    double C[12];
    dhgen_compose(A, B, C);
    dhgen_copy_link(C, A);
}

/* T = C0 Rz(angle 1) C1 ... Rz(angle n) Cn, row by row. */
DHGEN_FN void dhgen_pose_of_links(
    const double (*link)[12], const double *angle, int count, double T[16])
{
    dhgen_copy_link(link[0], T);
    for (int i = 0; i < count; i++) {
        dhgen_append_turn(T, cos(angle[i]), sin(angle[i]));
        dhgen_append(T, link[i + 1]);
    }
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

#endif
