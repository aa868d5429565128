/* SPDX-License-Identifier: MIT
 *
 * Reading poses: refuses what is no pose, and replaces a rotation that is only rounded by the
 * nearest one. */
#ifndef DHGEN_POSE_READING_H
#define DHGEN_POSE_READING_H

#include "arm.h"
#include "tolerances.h"

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
DHGEN_SMALL double dhgen_misfit(const double *T)
{
    const double x0 = T[0], x1 = T[1], x2 = T[2];
    const double y0 = T[4], y1 = T[5], y2 = T[6];
    const double xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0;
    const double yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0;
    const double xy = x0 * y0 + x1 * y1 + x2 * y2;
    const double zx = x1 * y2 - x2 * y1 - T[8];
    const double zy = x2 * y0 - x0 * y2 - T[9];
    const double zz = x0 * y1 - x1 * y0 - T[10];
    return xx * xx + yy * yy + 2.0 * xy * xy + zx * zx + zy * zy + zz * zz;
}

/* Takes one step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, N. J.
 * Higham, Computing the polar decomposition, 1986). */
DHGEN_SMALL void dhgen_straighten(double *T)
{
    double G[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[i][j] = (i == j ? 1.5 : 0.0)
                - 0.5 * (T[i] * T[j] + T[4 + i] * T[4 + j] + T[8 + i] * T[8 + j]);
    for (double *row = T; row < T + 12; row += 4) {
        const double x = row[0], y = row[1], z = row[2];
        for (int j = 0; j < 3; j++)
            row[j] = x * G[0][j] + y * G[1][j] + z * G[2][j];
    }
}

/* Whether a number may be used: it is finite, and where a joint slides so are its square and sums
 * of those, as its cube is. */
DHGEN_SMALL int dhgen_usable(const struct dhgen_arm *arm, double number)
{
    return isfinite(arm->slides ? number * number * number : number) != 0;
}

/* Makes three entries one long: a column or a row. Returns 0 where they are none, 1 where they
 * were, 2 where they are now. */
DHGEN_SMALL int dhgen_read_unit(double *x, double *y, double *z)
{
    const double square = *x * *x + *y * *y + *z * *z;
    const double miss = (square - 1.0) * (square - 1.0);
    if (!(miss <= DHGEN_ROUNDED))
        return 0;
    if (miss <= DHGEN_ORTHONORMAL)
        return 1;
    const double length = sqrt(square);
    *x /= length;
    *y /= length;
    *z /= length;
    return 2;
}

/* Makes the tool's x axis level, or zero where it is too steep to have a yaw, which is free then.
 * Returns 0 where it is no direction, 1 where it was level, 2 where it is now. */
DHGEN_SMALL int dhgen_read_yaw(double *T)
{
    const double square = T[0] * T[0] + T[4] * T[4];
    T[8] = 0.0;
    if ((square - 1.0) * (square - 1.0) <= DHGEN_ORTHONORMAL)
        return 1;
    if (!isfinite(square))
        return 0;
    const double length = sqrt(square);
    T[0] = length < DHGEN_NO_YAW ? 0.0 : T[0] / length;
    T[4] = length < DHGEN_NO_YAW ? 0.0 : T[4] / length;
    return 2;
}

/* Makes the sine of the pitch one at most. Returns 0 where it is none, 1 where it was, 2 where it
 * is now. */
DHGEN_SMALL int dhgen_read_pitch(double *T)
{
    const double over = fabs(T[8]) - 1.0;
    if (over <= 0.0)
        return 1;
    if (!(over * over <= DHGEN_ROUNDED))
        return 0;
    if (over * over <= DHGEN_ORTHONORMAL)
        return 1;
    T[8] = T[8] < 0.0 ? -1.0 : 1.0;
    return 2;
}

/* Makes the rotation one. Returns 0 where it is none, 1 where it was, 2 where it is now. */
DHGEN_SMALL int dhgen_read_rotation(double *T)
{
    const double miss = dhgen_misfit(T);
    if (!(miss <= DHGEN_ROUNDED))
        return 0;
    if (miss <= DHGEN_ORTHONORMAL)
        return 1;
    dhgen_straighten(T);
    dhgen_straighten(T);
    return 2;
}

/* Copies a pose; directions that are only rounded are put right. Returns 0 for what is no pose, 1
 * for what was one, 2 for what was rounded. */
DHGEN_SMALL int dhgen_read_pose(const struct dhgen_arm *arm, const double *given, double *T)
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    for (int i = 0; i < 3; i++)
        if (arm->miss_weights[i] > 0.0 && !dhgen_usable(arm, T[4 * i + 3]))
            return 0;
    if (arm->task == DHGEN_POSE
        && !(fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1.0) <= DHGEN_LAST_ROW))
        return 0;
    switch (arm->task) {
    case DHGEN_COORDINATES:
        return 1;
    case DHGEN_POINTING:
        return dhgen_read_unit(T + 2, T + 6, T + 10);
    case DHGEN_YAW:
        return dhgen_read_yaw(T);
    case DHGEN_PITCH:
        return dhgen_read_pitch(T);
    case DHGEN_TILT:
        return dhgen_read_unit(T + 8, T + 9, T + 10);
    default:
        return dhgen_read_rotation(T);
    }
}

#endif
