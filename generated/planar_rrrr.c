/* planar_rrrr: Planar arm with four links, one joint too many twice over
 *
 * Inverse kinematics, generated from robots/planar_rrrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rrrr.yaml. The formulas and where they come from:
 * planar_rrrr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: c20903e6caa02128
 * SPDX-License-Identifier: MIT
 */
#include "planar_rrrr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 4
#define DHGEN_ROWS 1
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/numerical.h"

static const double
    a = 0.25; /* link length 1 [m] */

#ifndef __CUDACC_RTC__
const char *const planar_rrrr_branches[1] = {
    "nearest",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[4] = { 0, 1, 2, 3 };
DHGEN_TABLE int turning[4] = { 1, 1, 1, 1 };
DHGEN_TABLE double unit[4] = { 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[4] = { 1.0, 1.0, 1.0, 1.0 };
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[2] = { 0, 1 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[4] = {
    -2.0943951023931953, -2.0943951023931953, -2.0943951023931953, -2.0943951023931953,
};
DHGEN_TABLE double span_width[4] = {
    4.1887902047863905, 4.1887902047863905, 4.1887902047863905, 4.1887902047863905,
};
DHGEN_TABLE double stride[4] = {
    0.8566748838545029, 0.733891856627126, 0.6287067210378086, 0.53859725722361,
};
DHGEN_TABLE double least_u[4] = {
    -2.0943951023931953, -2.0943951023931953, -2.0943951023931953, -2.0943951023931953,
};
DHGEN_TABLE double most_u[4] = {
    2.0943951023931953, 2.0943951023931953, 2.0943951023931953, 2.0943951023931953,
};

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    4, 1, /* joints; solutions that are kept */
    4, 2, /* joints that are solved for; equations */
    2, DHGEN_COORDINATES, 0, /* coordinates, directions, arm angle */
    1, 1, 0, /* families of solutions, limits, more entries than joints */
    24, 1.0, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, 0, 0, 0, 0,
    planar_rrrr_fk, planar_rrrr_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[4][4] = {
    { 0.0, 0.0, 0.25, 0.0 },
    { 0.0, 0.0, 0.25, 0.0 },
    { 0.0, 0.0, 0.25, 0.0 },
    { 0.0, 0.0, 0.25, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 4, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 6

DHGEN_PUBLIC void planar_rrrr_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - x2_y * s3,
        x3_y = x2_y * c3 + x2_x * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - x3_y * s4,
        x4_y = x3_y * c4 + x3_x * s4;
    T[0] = x4_x; T[1] = -x4_y; T[2] = 0.0; T[3] = c1 * a + a * x2_x + a * x3_x + a * x4_x;
    T[4] = x4_y; T[5] = x4_x; T[6] = 0.0; T[7] = s1 * a + a * x2_y + a * x3_y + a * x4_y;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void planar_rrrr_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a, p1_y = s1 * a;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2,
        p2_x = p1_x + a * x2_x, p2_y = p1_y + a * x2_y;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - x2_y * s3,
        x3_y = x2_y * c3 + x2_x * s3, p3_x = p2_x + a * x3_x, p3_y = p2_y + a * x3_y;
    const double c4 = cos(q[3]), s4 = sin(q[3]), p4_x = p3_x + a * (x3_x * c4 - x3_y * s4),
        p4_y = p3_y + a * (x3_y * c4 + x3_x * s4);
    J[0] = -p4_y; J[1] = p1_y - p4_y; J[2] = p2_y - p4_y; J[3] = p3_y - p4_y;
    J[4] = p4_x; J[5] = p4_x - p1_x; J[6] = p4_x - p2_x; J[7] = p4_x - p3_x;
    J[8] = 0.0; J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = 0.0;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = 0.0;
    J[20] = 1.0; J[21] = 1.0; J[22] = 1.0; J[23] = 1.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    (void)free_joints; (void)moved;
    dhgen_numerical_rows(&descents, T, NULL, seed, rows, status);
}

DHGEN_TABLE int entries[2] = { 3, 7 };
DHGEN_TABLE struct dhgen_arm arm = {
    4, 1, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 1.0, 1.0, 0.0, 0.0, 0.0, 0.0 }, 1.0, { 1e-14, 1e-10 }, entries, 2,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, planar_rrrr_fk, planar_rrrr_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) planar_rrrr_##function
#include "dhgen/functions.h"
