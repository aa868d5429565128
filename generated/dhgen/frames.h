/* SPDX-License-Identifier: MIT
 *
 * Where the links of an arm are: the frames of its table, or of its axes, from base to tool. */
#ifndef DHGEN_FRAMES_H
#define DHGEN_FRAMES_H

#include "arm.h"

/* What the rows of a table are. */
enum { DHGEN_STANDARD, DHGEN_MODIFIED, DHGEN_AXES };

/* An arm as its robot file has it. */
struct dhgen_links {
    int dof, kind; /* joints; DHGEN_STANDARD ... */
    const struct dhgen_joint *joints;
    const double *table; /* of each at q = 0 theta, d, a, alpha; of an axis unit vector and point */
    const double *drives; /* what angles and lengths are of joint values, rows by joints; or NULL */
    const double *base;   /* the base in the caller's frame, three rows of a matrix; or NULL */
    const double *tool;   /* the tool in the last frame, with axes at q = 0; or NULL */
};

/* T = A B; T may be A. */
DHGEN_FN void dhgen_chain_frames(const double *A, const double *B, double *T)
{
    double product[16] = { 0.0 };
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 4; k++)
                product[4 * i + j] += A[4 * i + k] * B[4 * k + j];
    for (int i = 0; i < 16; i++)
        T[i] = product[i];
}

/* A matrix of three rows, or the identity for NULL. */
DHGEN_FN void dhgen_whole_frame(const double *rows, double *T)
{
    for (int i = 0; i < 16; i++)
        T[i] = rows && i < 12 ? rows[i] : i % 5 == 0 ? 1.0 : 0.0;
}

/* Moves a frame along one of its axes, 0 for x or 2 for z, and turns it about that axis. */
DHGEN_FN void dhgen_screw_frame(int axis, double angle, double length, double *T)
{
    const double c = cos(angle), s = sin(angle);
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    double motion[16];
    dhgen_whole_frame(NULL, motion);
    motion[5 * j] = motion[5 * k] = c;
    motion[4 * j + k] = -s;
    motion[4 * k + j] = s;
    motion[4 * axis + 3] = length;
    dhgen_chain_frames(T, motion, T);
}

/* Turns a frame about an axis through a point, or moves it along (O. Rodrigues, 1840). */
DHGEN_FN void dhgen_move_frame(const double *axis, double x, int revolute, double *T)
{
    const double *const u = axis, *const p = axis + 3;
    const double s = revolute ? sin(x) : 0.0, h = revolute ? sin(0.5 * x) : 0.0;
    const double v = 2.0 * h * h,
                 cross[9] = { 0.0, -u[2], u[1], u[2], 0.0, -u[0], -u[1], u[0], 0.0 };
    double motion[16];
    dhgen_whole_frame(NULL, motion);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            motion[4 * i + j] += s * cross[3 * i + j] + v * (u[i] * u[j] - (i == j ? 1.0 : 0.0));
        for (int j = 0; j < 3; j++)
            motion[4 * i + 3] += ((i == j ? 1.0 : 0.0) - motion[4 * i + j]) * p[j];
        motion[4 * i + 3] += revolute ? 0.0 : x * u[i];
    }
    dhgen_chain_frames(T, motion, T);
}

/* Moves a frame by a joint's row. */
DHGEN_FN void dhgen_row_frame(const struct dhgen_links *links, int joint, double x, double *T)
{
    const int revolute = links->joints[joint].revolute;
    const double *const row = links->table + (links->kind == DHGEN_AXES ? 6 : 4) * joint;
    if (links->kind == DHGEN_AXES) {
        dhgen_move_frame(row, x, revolute, T);
        return;
    }
    if (links->kind == DHGEN_MODIFIED)
        dhgen_screw_frame(0, row[3], row[2], T);
    dhgen_screw_frame(2, row[0] + (revolute ? x : 0.0), row[1] + (revolute ? 0.0 : x), T);
    if (links->kind == DHGEN_STANDARD)
        dhgen_screw_frame(0, row[3], row[2], T);
}

/* The frames of the base, of every link and of the tool. Those of the links are the table's own;
 * with axes they are at their points, parallel to the base's frame at q = 0. */
DHGEN_FN void dhgen_frames(const struct dhgen_links *links, const double *q, double (*frames)[16])
{
    double T[16], at[16];
    dhgen_whole_frame(links->base, T);
    dhgen_whole_frame(links->base, frames[0]);
    for (int i = 0; i < links->dof; i++) {
        double x = links->drives ? 0.0 : q[i];
        for (int j = 0; j < links->dof && links->drives; j++)
            x += links->drives[links->dof * i + j] * q[j];
        dhgen_row_frame(links, i, x, T);
        dhgen_whole_frame(NULL, at);
        for (int k = 0; k < 3 && links->kind == DHGEN_AXES; k++)
            at[4 * k + 3] = links->table[6 * i + 3 + k];
        dhgen_chain_frames(T, at, frames[i + 1]);
    }
    dhgen_whole_frame(links->tool, at);
    dhgen_chain_frames(T, at, frames[links->dof + 1]);
}

#endif
