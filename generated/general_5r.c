/* general_5r: Five revolute joints without structure, for whole poses
 *
 * Inverse kinematics, generated from robots/general_5r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_5r.yaml. The formulas and where they come from:
 * general_5r.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 18f2b87bcd3b3853
 * SPDX-License-Identifier: MIT
 */
#include "general_5r.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 5
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef GENERAL_5R_LANES
#define DHGEN_GENERAL_LANES GENERAL_5R_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = 0.32, /* joint offset 1 [m] */
    a1 = 0.09, /* link length 1 [m] */
    ca1 = 0.3420201433256688, /* cosine of twist 1 */
    sa1 = 0.9396926207859083, /* sine of twist 1 */
    d2 = 0.11, /* joint offset 2 [m] */
    a2 = 0.38, /* link length 2 [m] */
    ca2 = 0.9063077870366499, /* cosine of twist 2 */
    sa2 = 0.42261826174069944, /* sine of twist 2 */
    d3 = -0.07, /* joint offset 3 [m] */
    a3 = 0.29, /* link length 3 [m] */
    ca3 = 0.5735764363510462, /* cosine of twist 3 */
    sa3 = 0.8191520442889918, /* sine of twist 3 */
    d4 = 0.14, /* joint offset 4 [m] */
    a4 = 0.05, /* link length 4 [m] */
    ca4 = 0.08715574274765814, /* cosine of twist 4 */
    sa4 = 0.9961946980917455, /* sine of twist 4 */
    d5 = 0.1, /* joint offset 5 [m] */
    a5 = 0.04, /* link length 5 [m] */
    ca5 = 0.766044443118978, /* cosine of twist 5 */
    sa5 = 0.6427876096865393, /* sine of twist 5 */
    cae11 = 0.955336489125606, /* cosine of tool frame, entry 1,1 */
    sae11 = 0.29552020666133955, /* sine of tool frame, entry 1,1 */
    ex = 0.03, /* x of the tool frame [m] */
    ez = 0.14, /* z of the tool frame [m] */
    f1 = 0.03762221576582357, /* d2 * ca1 [m] */
    f2 = 0.14454395845259904, /* sa2 * ca1 */
    f3 = 0.3099755192194448; /* ca2 * ca1 */

#ifndef __CUDACC_RTC__
const char *const general_5r_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[5] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.443460952792061, 2.443460952792061, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 4, 5, 0, 1, 2, 3 }, 1.0, 0 },
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.10538972740096156, 0.3157109015313867,
        0.13154620897141112, -0.9396926207859084, -0.038553998126521535, 0.8674085730331463,
        0.36142023876381096, 0.3420201433256689, 3.8875152434369215e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.44497884902628215, 0.7996833415029264,
        0.4264977821348941, -0.42261826174069944, 0.02403930282003971, 0.3728984662417936,
        0.19887918199562327, 0.9063077870366499, 0.03622890771527519 },
    { 0.28, -0.96, 0.0, 0.33958912162532057, 0.5506333788970043, 0.16060140217829294,
        0.8191520442889918, 0.06821269656711591, -0.7863859625174321, -0.22936257240091773,
        0.5735764363510462, 0.022675092750040773 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.05854984855608976, 0.06311277923106279,
        0.060107408791488376, -0.9961946980917455, 0.13470065795828057, 0.7213823675836778,
        0.6870308262701694, 0.08715574274765814, 0.06888246881618784 },
    { 0.4980694980694982, -0.13127413127413126, 0.8571428571428572, 0.37800838000338793,
        0.5482625482625483, -0.7181467181467182, -0.4285714285714286, 0.8414731445854858,
        0.6718146718146719, 0.6833976833976835, -0.28571428571428575, -0.12818457869075675 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.33198338483131545 },
    { 0.20715392159351406, 0.16111519143074884, 0.9649503343999947, 0.21994807102450414,
        0.9320899268247839, -0.3320909674116114, -0.14465115856912225, 0.7593411359264012,
        0.2971457909515084, 0.9293855413410805, -0.2189677932161469, 0.14443884746120278 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.8539731738520357, 1.1709969711217951, /* the length that is one in the loop, and its inverse
        */
    4.000000004, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, 0,
};


/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[5] = { 0, 1, 2, 3, 4 };
DHGEN_TABLE int turning[5] = { 1, 1, 1, 1, 1 };
DHGEN_TABLE double unit[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[5] = {
    0.5681818181818181, 0.5681818181818181, 0.5681818181818181, 0.5681818181818181,
    0.5681818181818181,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[5] = {
    -2.9670597283903604, -2.0943951023931953, -2.443460952792061, -3.141592653589793,
    -3.141592653589793,
};
DHGEN_TABLE double span_width[5] = {
    5.934119456780721, 4.1887902047863905, 4.886921905584122, 6.283185307179586, 6.283185307179586,
};
DHGEN_TABLE double stride[5] = {
    0.8812714616335696, 0.7766393890897682, 0.6844301295853426, 0.6031687406857283,
    0.5315553977157914,
};
DHGEN_TABLE double least_u[5] = {
    -2.9670597283903604, -2.0943951023931953, -2.443460952792061, -3.141592653589793,
    -3.141592653589793,
};
DHGEN_TABLE double most_u[5] = {
    2.9670597283903604, 2.0943951023931953, 2.443460952792061, 3.141592653589793, 3.141592653589793,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    5, 16, /* joints; solutions that are kept */
    5, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 1, /* families of solutions, limits, more entries than joints */
    48, 1.7600000000000002, 1e-05, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    general_5r_fk, general_5r_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.32, 0.09, 1.2217304763960306 },
    { 0.0, 0.11, 0.38, 0.4363323129985824 },
    { 0.0, -0.07, 0.29, -0.9599310885968813 },
    { 0.0, 0.14, 0.05, 1.4835298641951802 },
    { 0.0, 0.1, 0.04, -0.6981317007977318 },
};
DHGEN_TABLE double tool[12] = {
    0.955336489125606, 0.0, 0.29552020666133955, 0.03, 0.0, 1.0, 0.0, 0.0, -0.29552020666133955,
    0.0, 0.955336489125606, 0.14,
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void general_5r_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = sa1 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = sa1 * c2, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2,
        v6 = v4 * sa2 + v2 * ca2, z2_z = f3 - v5 * sa2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, v7 = y2_x * c3 - x2_x * s3,
        v8 = y2_y * c3 - x2_y * s3, v9 = y2_z * c3 - x2_z * s3, y3_x = v7 * ca3 - z2_x * sa3,
        y3_y = v8 * ca3 + v6 * sa3, y3_z = v9 * ca3 - z2_z * sa3, z3_x = v7 * sa3 + z2_x * ca3,
        z3_y = v8 * sa3 - v6 * ca3, z3_z = v9 * sa3 + z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v10 = y3_x * c4 - x3_x * s4,
        v11 = y3_y * c4 - x3_y * s4, v12 = y3_z * c4 - x3_z * s4, y4_x = v10 * ca4 + z3_x * sa4,
        y4_y = v11 * ca4 + z3_y * sa4, y4_z = v12 * ca4 + z3_z * sa4, z4_x = z3_x * ca4 - v10 * sa4,
        z4_y = z3_y * ca4 - v11 * sa4, z4_z = z3_z * ca4 - v12 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v13 = y4_x * c5 - x4_x * s5,
        v14 = y4_y * c5 - x4_y * s5, v15 = y4_z * c5 - x4_z * s5, z5_x = v13 * sa5 + z4_x * ca5,
        z5_y = v14 * sa5 + z4_y * ca5, z5_z = v15 * sa5 + z4_z * ca5;
    T[0] = x5_x * cae11 - z5_x * sae11; T[1] = v13 * ca5 - z4_x * sa5;
    T[2] = x5_x * sae11 + z5_x * cae11;
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x *
        a5 + z4_x * d5 + x5_x * ex + z5_x * ez;
    T[4] = x5_y * cae11 - z5_y * sae11; T[5] = v14 * ca5 - z4_y * sa5;
    T[6] = x5_y * sae11 + z5_y * cae11;
    T[7] = s1 * a1 + x2_y * a2 - v2 * d2 + x3_y * a3 - v6 * d3 + x4_y * a4 + z3_y * d4 + x5_y * a5 +
        z4_y * d5 + x5_y * ex + z5_y * ez;
    T[8] = x5_z * cae11 - z5_z * sae11; T[9] = v15 * ca5 - z4_z * sa5;
    T[10] = x5_z * sae11 + z5_z * cae11;
    T[11] = d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z *
        d5 + x5_z * ex + z5_z * ez;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void general_5r_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1, v1 = s1 * ca1,
        y1_y = c1 * ca1, z1_x = s1 * sa1, v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = sa1 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = sa1 * c2, p2_x = p1_x + x2_x * a2 + z1_x * d2,
        p2_y = p1_y + x2_y * a2 - v2 * d2, p2_z = d1 + x2_z * a2 + f1, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2,
        v6 = v4 * sa2 + v2 * ca2, z2_z = f3 - v5 * sa2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, v7 = y2_x * c3 - x2_x * s3,
        v8 = y2_y * c3 - x2_y * s3, v9 = y2_z * c3 - x2_z * s3, p3_x = p2_x + x3_x * a3 + z2_x * d3,
        p3_y = p2_y + x3_y * a3 - v6 * d3, p3_z = p2_z + x3_z * a3 + z2_z * d3,
        y3_x = v7 * ca3 - z2_x * sa3, y3_y = v8 * ca3 + v6 * sa3, y3_z = v9 * ca3 - z2_z * sa3,
        z3_x = v7 * sa3 + z2_x * ca3, z3_y = v8 * sa3 - v6 * ca3, z3_z = v9 * sa3 + z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v10 = y3_x * c4 - x3_x * s4,
        v11 = y3_y * c4 - x3_y * s4, v12 = y3_z * c4 - x3_z * s4,
        p4_x = p3_x + x4_x * a4 + z3_x * d4, p4_y = p3_y + x4_y * a4 + z3_y * d4,
        p4_z = p3_z + x4_z * a4 + z3_z * d4, y4_x = v10 * ca4 + z3_x * sa4,
        y4_y = v11 * ca4 + z3_y * sa4, y4_z = v12 * ca4 + z3_z * sa4, z4_x = z3_x * ca4 - v10 * sa4,
        z4_y = z3_y * ca4 - v11 * sa4, z4_z = z3_z * ca4 - v12 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5,
        J21 = p4_x + x5_x * a5 + z4_x * d5 + x5_x * ex + ((y4_x * c5 - x4_x * s5) * sa5 + z4_x *
            ca5) * ez,
        v13 = p4_y + x5_y * a5 + z4_y * d5 + x5_y * ex + ((y4_y * c5 - x4_y * s5) * sa5 + z4_y *
            ca5) * ez,
        v14 = p4_z + x5_z * a5 + z4_z * d5 + x5_z * ex + ((y4_z * c5 - x4_z * s5) * sa5 + z4_z *
            ca5) * ez, v15 = J21 - p1_x, v16 = v13 - p1_y, v17 = v14 - d1, v18 = J21 - p2_x,
        v19 = v13 - p2_y, v20 = v14 - p2_z, v21 = J21 - p3_x, v22 = v13 - p3_y, v23 = v14 - p3_z,
        v24 = J21 - p4_x, v25 = v13 - p4_y, v26 = v14 - p4_z;
    J[0] = -v13; J[1] = -(v2 * v17 + ca1 * v16); J[2] = -(v6 * v20 + z2_z * v19);
    J[3] = z3_y * v23 - z3_z * v22; J[4] = z4_y * v26 - z4_z * v25;
    J[5] = J21; J[6] = ca1 * v15 - z1_x * v17; J[7] = z2_z * v18 - z2_x * v20;
    J[8] = z3_z * v21 - z3_x * v23; J[9] = z4_z * v24 - z4_x * v26;
    J[10] = 0.0; J[11] = z1_x * v16 + v2 * v15; J[12] = z2_x * v19 + v6 * v18;
    J[13] = z3_x * v22 - z3_y * v21; J[14] = z4_x * v25 - z4_y * v24;
    J[15] = 0.0; J[16] = z1_x; J[17] = z2_x; J[18] = z3_x; J[19] = z4_x;
    J[20] = 0.0; J[21] = -v2; J[22] = -v6; J[23] = z3_y; J[24] = z4_y;
    J[25] = 1.0; J[26] = ca1; J[27] = z2_z; J[28] = z3_z; J[29] = z4_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    (void)free_joints; (void)moved;
    dhgen_general_rows(&general, &descents, T, NULL, seed, rows, status);
}

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    5, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.5682, 0.5682, 0.5682, 1.0, 1.0, 1.0 }, 0.5681818181818181, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 1, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, general_5r_fk, general_5r_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) general_5r_##function
#include "dhgen/functions.h"
