/* general_6r: General arm with six revolute joints
 *
 * Inverse kinematics, generated from robots/general_6r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_6r.yaml. The formulas and where they come from:
 * general_6r.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 8f549a90cc09d617
 * SPDX-License-Identifier: MIT
 */
#include "general_6r.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef GENERAL_6R_LANES
#define DHGEN_GENERAL_LANES GENERAL_6R_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = -0.035, /* joint offset 1 [m] */
    a1 = 0.416, /* link length 1 [m] */
    ca1 = 0.21607853588096199, /* cosine of twist 1 */
    sa1 = 0.9763759861505914, /* sine of twist 1 */
    d2 = -0.257, /* joint offset 2 [m] */
    a2 = -0.339, /* link length 2 [m] */
    ca2 = 0.9781157489708037, /* cosine of twist 2 */
    sa2 = 0.20806148517994336, /* sine of twist 2 */
    d3 = -0.272, /* joint offset 3 [m] */
    a3 = 0.075, /* link length 3 [m] */
    ca3 = 0.8053132584046545, /* cosine of twist 3 */
    sa3 = 0.5928495220860671, /* sine of twist 3 */
    d4 = 0.262, /* joint offset 4 [m] */
    a4 = -0.28, /* link length 4 [m] */
    ca4 = 0.45217616214091205, /* cosine of twist 4 */
    sa4 = 0.8919286509533796, /* sine of twist 4 */
    d5 = -0.167, /* joint offset 5 [m] */
    a5 = -0.136, /* link length 5 [m] */
    ca5 = 0.9895059058723947, /* cosine of twist 5 */
    sa5 = 0.1444924297105264, /* sine of twist 5 */
    d6 = -0.477, /* joint offset 6 [m] */
    a6 = 0.175, /* link length 6 [m] */
    ca6 = 0.13835111738308337, /* cosine of twist 6 */
    sa6 = 0.9903832431533018, /* sine of twist 6 */
    offset1 = 2.137, /* offset of joint 1 [rad] */
    offset2 = -2.341, /* offset of joint 2 [rad] */
    offset3 = -1.611, /* offset of joint 3 [rad] */
    offset4 = 0.482, /* offset of joint 4 [rad] */
    offset5 = 0.126, /* offset of joint 5 [rad] */
    offset6 = 1.904, /* offset of joint 6 [rad] */
    f1 = -0.05553218372140723, /* d2 * ca1 [m] */
    f2 = 0.04495762109090063, /* sa2 * ca1 */
    f3 = 0.2113498189597218; /* ca2 * ca1 */

#ifndef __CUDACC_RTC__
const char *const general_6r_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 5, 0, 1, 2, 3, 4 }, 1.0, 0 },
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.625797711755665, 0.1994571100439649,
        0.08310712918498539, -0.9763759861505914, -0.05692061104264318, 0.9012701410620845,
        0.3755292254425352, 0.21607853588096199, -4.005433883479374e-11 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, -0.5099649622239675, -0.863043307915415,
        -0.46028976422155465, -0.20806148517994336, 0.10646134679468323, 0.18358366339406768,
        0.09791128714350275, -0.9781157489708037, 0.05557591778869785 },
    { 0.28, -0.96, 0.0, 0.11282410668671844, -0.7731007280684683, -0.22548771235330328,
        0.5928495220860671, 0.13178733217844682, -0.5691355412026244, -0.1659978661840988,
        -0.8053132584046545, -0.07651018689267303 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, -0.4212099982970823, -0.3274379105158329,
        -0.31184562906269797, 0.8919286509533796, 0.06330373161268073, -0.6458793679317576,
        -0.6151232075540549, -0.45217616214091205, 0.1397447250289724 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, -0.20458771345858281, 0.9360191001495627,
        0.3209208343369929, -0.14449242971052642, -0.046066283414697685, 0.13668202810455202,
        0.04686240963584641, 0.9895059058723948, -0.0067268214344506985 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, 0.026626183228620606 },
    { 1.0, 0.0, 0.0, -0.175, 0.0, 0.1383511173830834, 0.990383243153302, 0.682307145579463, 0.0,
        -0.990383243153302, 0.1383511173830834, 0.09531457306246946 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.6647515517960572, 1.5043214224895793, /* the length that is one in the loop, and its inverse
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
DHGEN_TABLE int solved[6] = { 0, 1, 2, 3, 4, 5 };
DHGEN_TABLE int turning[6] = { 1, 1, 1, 1, 1, 1 };
DHGEN_TABLE double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[6] = {
    0.3459010722933242, 0.3459010722933242, 0.3459010722933242, 0.3459010722933242,
    0.3459010722933242, 0.3459010722933242,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
DHGEN_TABLE double span_width[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = { 2.137, -2.341, -1.611, 0.482, 0.126, 1.904 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 2.8909999999999996, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, facing, zero, 0, 0,
    general_6r_fk, general_6r_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 2.137, -0.035, 0.416, 1.353 },
    { -2.341, -0.257, -0.339, 2.932 },
    { -1.611, -0.272, 0.075, -2.507 },
    { 0.482, 0.262, -0.28, -2.04 },
    { 0.126, -0.167, -0.136, 0.145 },
    { 1.904, -0.477, 0.175, 1.432 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void general_6r_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v3 = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + y1_y * s2,
        x2_z = sa1 * s2, v5 = v2 * c2 + c1 * s2, v6 = y1_y * c2 - s1 * s2, v7 = sa1 * c2,
        y2_x = v5 * ca2 + z1_x * sa2, v8 = v6 * ca2 + v3 * sa2, y2_z = f2 - v7 * ca2,
        z2_x = v5 * sa2 - z1_x * ca2, z2_y = v3 * ca2 - v6 * sa2, v9 = v7 * sa2 + f3,
        v10 = q[2] + offset3;
    const double c3 = cos(v10), s3 = sin(v10), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 - v8 * s3, x3_z = x2_z * c3 + y2_z * s3, v11 = y2_x * c3 - x2_x * s3,
        v12 = v8 * c3 + x2_y * s3, v13 = y2_z * c3 - x2_z * s3, v14 = v11 * ca3 + z2_x * sa3,
        y3_y = v12 * ca3 - z2_y * sa3, y3_z = v9 * sa3 - v13 * ca3, z3_x = v11 * sa3 - z2_x * ca3,
        v15 = v12 * sa3 + z2_y * ca3, z3_z = v13 * sa3 + v9 * ca3, v16 = q[3] + offset4;
    const double c4 = cos(v16), s4 = sin(v16), x4_x = x3_x * c4 - v14 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v17 = v14 * c4 + x3_x * s4,
        v18 = y3_y * c4 - x3_y * s4, v19 = y3_z * c4 - x3_z * s4, y4_x = v17 * ca4 - z3_x * sa4,
        y4_y = v15 * sa4 - v18 * ca4, v20 = v19 * ca4 + z3_z * sa4, v21 = v17 * sa4 + z3_x * ca4,
        z4_y = v18 * sa4 + v15 * ca4, z4_z = v19 * sa4 - z3_z * ca4, v22 = q[4] + offset5;
    const double c5 = cos(v22), s5 = sin(v22), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v20 * s5, v23 = y4_x * c5 - x4_x * s5,
        v24 = y4_y * c5 - x4_y * s5, v25 = v20 * c5 + x4_z * s5, y5_x = v23 * ca5 - v21 * sa5,
        y5_y = v24 * ca5 + z4_y * sa5, y5_z = z4_z * sa5 - v25 * ca5, v26 = v23 * sa5 + v21 * ca5,
        z5_y = z4_y * ca5 - v24 * sa5, z5_z = v25 * sa5 + z4_z * ca5, v27 = q[5] + offset6;
    const double c6 = cos(v27), s6 = sin(v27), x6_x = x5_x * c6 + y5_x * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 + y5_z * s6, v28 = y5_x * c6 - x5_x * s6,
        v29 = y5_y * c6 - x5_y * s6, v30 = y5_z * c6 - x5_z * s6;
    T[0] = x6_x; T[1] = v28 * ca6 - v26 * sa6; T[2] = -(v28 * sa6 + v26 * ca6);
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x *
        a5 - v21 * d5 + x6_x * a6 - v26 * d6;
    T[4] = x6_y; T[5] = v29 * ca6 + z5_y * sa6; T[6] = z5_y * ca6 - v29 * sa6;
    T[7] = s1 * a1 + x2_y * a2 - v3 * d2 + x3_y * a3 + z2_y * d3 + x4_y * a4 - v15 * d4 + x5_y * a5
        + z4_y * d5 + x6_y * a6 + z5_y * d6;
    T[8] = x6_z; T[9] = v30 * ca6 + z5_z * sa6; T[10] = z5_z * ca6 - v30 * sa6;
    T[11] = d1 + x2_z * a2 + f1 + x3_z * a3 - v9 * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z *
        d5 + x6_z * a6 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void general_6r_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), p1_x = c1 * a1, p1_y = s1 * a1, v2 = s1 * ca1,
        y1_y = c1 * ca1, z1_x = s1 * sa1, v3 = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + y1_y * s2,
        x2_z = sa1 * s2, v5 = v2 * c2 + c1 * s2, v6 = y1_y * c2 - s1 * s2, v7 = sa1 * c2,
        p2_x = p1_x + x2_x * a2 + z1_x * d2, p2_y = p1_y + x2_y * a2 - v3 * d2,
        p2_z = d1 + x2_z * a2 + f1, y2_x = v5 * ca2 + z1_x * sa2, v8 = v6 * ca2 + v3 * sa2,
        y2_z = f2 - v7 * ca2, z2_x = v5 * sa2 - z1_x * ca2, z2_y = v3 * ca2 - v6 * sa2,
        v9 = v7 * sa2 + f3, v10 = q[2] + offset3;
    const double c3 = cos(v10), s3 = sin(v10), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 - v8 * s3, x3_z = x2_z * c3 + y2_z * s3, v11 = y2_x * c3 - x2_x * s3,
        v12 = v8 * c3 + x2_y * s3, v13 = y2_z * c3 - x2_z * s3, p3_x = p2_x + x3_x * a3 + z2_x * d3,
        p3_y = p2_y + x3_y * a3 + z2_y * d3, p3_z = p2_z + x3_z * a3 - v9 * d3,
        v14 = v11 * ca3 + z2_x * sa3, y3_y = v12 * ca3 - z2_y * sa3, y3_z = v9 * sa3 - v13 * ca3,
        z3_x = v11 * sa3 - z2_x * ca3, v15 = v12 * sa3 + z2_y * ca3, z3_z = v13 * sa3 + v9 * ca3,
        v16 = q[3] + offset4;
    const double c4 = cos(v16), s4 = sin(v16), x4_x = x3_x * c4 - v14 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v17 = v14 * c4 + x3_x * s4,
        v18 = y3_y * c4 - x3_y * s4, v19 = y3_z * c4 - x3_z * s4,
        p4_x = p3_x + x4_x * a4 + z3_x * d4, p4_y = p3_y + x4_y * a4 - v15 * d4,
        p4_z = p3_z + x4_z * a4 + z3_z * d4, y4_x = v17 * ca4 - z3_x * sa4,
        y4_y = v15 * sa4 - v18 * ca4, v20 = v19 * ca4 + z3_z * sa4, v21 = v17 * sa4 + z3_x * ca4,
        z4_y = v18 * sa4 + v15 * ca4, z4_z = v19 * sa4 - z3_z * ca4, v22 = q[4] + offset5;
    const double c5 = cos(v22), s5 = sin(v22), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v20 * s5, v23 = y4_x * c5 - x4_x * s5,
        v24 = y4_y * c5 - x4_y * s5, v25 = v20 * c5 + x4_z * s5, p5_x = p4_x + x5_x * a5 - v21 * d5,
        p5_y = p4_y + x5_y * a5 + z4_y * d5, p5_z = p4_z + x5_z * a5 + z4_z * d5,
        v26 = v23 * sa5 + v21 * ca5, z5_y = z4_y * ca5 - v24 * sa5, z5_z = v25 * sa5 + z4_z * ca5,
        v27 = q[5] + offset6;
    const double c6 = cos(v27), s6 = sin(v27),
        p6_x = p5_x + (x5_x * c6 + (v23 * ca5 - v21 * sa5) * s6) * a6 - v26 * d6,
        p6_y = p5_y + (x5_y * c6 + (v24 * ca5 + z4_y * sa5) * s6) * a6 + z5_y * d6,
        p6_z = p5_z + (x5_z * c6 + (z4_z * sa5 - v25 * ca5) * s6) * a6 + z5_z * d6,
        v28 = p6_x - p1_x, v29 = p6_y - p1_y, v30 = p6_z - d1, v31 = p6_x - p2_x, v32 = p6_y - p2_y,
        v33 = p6_z - p2_z, v34 = p6_x - p3_x, v35 = p6_y - p3_y, v36 = p6_z - p3_z,
        v37 = p6_x - p4_x, v38 = p6_y - p4_y, v39 = p6_z - p4_z, v40 = p6_x - p5_x,
        v41 = p6_y - p5_y, v42 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(v3 * v30 + ca1 * v29); J[2] = z2_y * v33 + v9 * v32;
    J[3] = -(v15 * v36 + z3_z * v35); J[4] = z4_y * v39 - z4_z * v38;
    J[5] = z5_y * v42 - z5_z * v41;
    J[6] = p6_x; J[7] = ca1 * v28 - z1_x * v30; J[8] = -(v9 * v31 + z2_x * v33);
    J[9] = z3_z * v34 - z3_x * v36; J[10] = z4_z * v37 + v21 * v39; J[11] = z5_z * v40 + v26 * v42;
    J[12] = 0.0; J[13] = z1_x * v29 + v3 * v28; J[14] = z2_x * v32 - z2_y * v31;
    J[15] = z3_x * v35 + v15 * v34; J[16] = -(v21 * v38 + z4_y * v37);
    J[17] = -(v26 * v41 + z5_y * v40);
    J[18] = 0.0; J[19] = z1_x; J[20] = z2_x; J[21] = z3_x; J[22] = -v21; J[23] = -v26;
    J[24] = 0.0; J[25] = -v3; J[26] = z2_y; J[27] = -v15; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = ca1; J[32] = -v9; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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
    6, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.3459, 0.3459, 0.3459, 1.0, 1.0, 1.0 }, 0.3459010722933242, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, general_6r_fk, general_6r_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) general_6r_##function
#include "dhgen/functions.h"
