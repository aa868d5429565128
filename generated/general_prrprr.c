/* general_prrprr: General arm with slides as joints 1 and 4
 *
 * Inverse kinematics, generated from robots/general_prrprr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_prrprr.yaml. The formulas and where they come from:
 * general_prrprr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 9a144b007677e152
 * SPDX-License-Identifier: MIT
 */
#include "general_prrprr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#define DHGEN_TRAITS 0x489u /* what the arm needs of it */
#ifdef GENERAL_PRRPRR_LANES
#define DHGEN_GENERAL_LANES GENERAL_PRRPRR_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

/* In formulas below, sat1 = 0.29552020666133955, a2 = 0.18 [m], a1 = 0.1 [m], d2 = 0.25 [m],
 * sa2 = 0.7833269096274834, ca2 = 0.6216099682706644, d3 = 0.11 [m], d5 = -0.16 [m],
 * d6 = 0.19 [m]. */
static const double
    cat1 = 0.955336489125606, /* cosine of the angle of joint 1 */
    ca1 = 0.9800665778412416, /* cosine of twist 1 */
    sa1 = 0.19866933079506122, /* sine of twist 1 */
    a3 = 0.32, /* link length 3 [m] */
    ca3 = 0.26749882862458735, /* cosine of twist 3 */
    sa3 = 0.963558185417193, /* sine of twist 3 */
    cat4 = 0.5403023058681398, /* cosine of the angle of joint 4 */
    sat4 = 0.8414709848078965, /* sine of the angle of joint 4 */
    a4 = 0.13, /* link length 4 [m] */
    ca4 = 0.8775825618903728, /* cosine of twist 4 */
    sa4 = 0.479425538604203, /* sine of twist 4 */
    a5 = 0.21, /* link length 5 [m] */
    ca5 = 0.029199522301288937, /* cosine of twist 5 */
    sa5 = 0.9995736030415051, /* sine of twist 5 */
    a6 = 0.1, /* link length 6 [m] */
    ca6 = 0.7648421872844885, /* cosine of twist 6 */
    sa6 = 0.644217687237691, /* sine of twist 6 */
    f1 = 0.28962947762551555, /* sat1 * ca1 */
    f2 = 0.05871080169382652, /* sat1 * sa1 */
    f3 = 0.052133305972592796, /* a2 * sat1 * ca1 [m] */
    f4 = 0.010567944304888773, /* a2 * sat1 * sa1 [m] */
    f5 = 0.32983280059673464, /* a1 + a2 * cat1 + sat1 * d2 * sa2 [m] */
    f6 = 0.1833559467502831, /* d2 * sa2 * cat1 * ca1 [m] */
    f7 = 0.03716809047647615, /* d2 * sa2 * cat1 * sa1 [m] */
    f8 = 0.030873709102968033, /* sa1 * d2 * ca2 [m] */
    f9 = 0.1523047885887582, /* d2 * ca2 * ca1 [m] */
    f10 = 0.18369830628609546, /* sat1 * ca2 */
    f11 = 0.42638625510015216, /* ca2 * cat1 * ca1 - sa1 * sa2 */
    f12 = 0.8856916470924222, /* ca2 * cat1 * sa1 + sa2 * ca1 */
    f13 = 0.10599140039589122, /* d3 * sa3 [m] */
    f14 = 0.006811531943972054, /* d3 * ca3 * sat1 * sa2 [m] */
    f15 = 0.02521472007885299, /* (sa2 * cat1 * ca1 + sa1 * ca2) * d3 * ca3 [m] */
    f16 = 0.013551530025764803, /* d3 * ca3 * (ca2 * ca1 - sa2 * cat1 * sa1) [m] */
    f17 = 0.2230530535435802, /* sa3 * sat1 * sa2 */
    f18 = 0.8256909538260336, /* (sa2 * cat1 * ca1 + sa1 * ca2) * sa3 */
    f19 = 0.44376363163199056, /* sa3 * (ca2 * ca1 - sa2 * cat1 * sa1) */
    f20 = 0.06192301767247322, /* ca3 * sat1 * sa2 */
    f21 = 0.22922472798957264, /* (sa2 * cat1 * ca1 + sa1 * ca2) * ca3 */
    f22 = 0.12319572750695275, /* ca3 * (ca2 * ca1 - sa2 * cat1 * sa1) */
    f23 = 0.7384602626041288, /* sat4 * ca4 */
    f24 = 0.4034226801113349, /* sat4 * sa4 */
    f25 = 0.4741598817790379, /* cat4 * ca4 */
    f26 = 0.2590347239999257, /* cat4 * sa4 */
    f27 = -0.1599317764866408, /* d5 * sa5 [m] */
    f28 = -0.00467192356820623, /* d5 * ca5 [m] */
    f29 = 0.1224013605751613, /* d6 * sa6 [m] */
    f30 = 0.1453200155840528, /* d6 * ca6 [m] */
    g13 = 0.23148893021650235, /* sat1 * sa2 */
    g14 = 0.8569186234130046, /* sa2 * cat1 * ca1 + sa1 * ca2 */
    g15 = 0.4605467924491282; /* ca2 * ca1 - sa2 * cat1 * sa1 */

#ifndef __CUDACC_RTC__
const char *const general_prrprr_branches[8] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { 0.0, 1.2, 1.75e-09, 0.32653061224489793, 1.75, 0.0375, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.4, 0.4, 1.75e-09, 0.32653061224489793, 1.75, 0.025, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 4, 5, 0, 1, 2, 3 }, 1.0, 0 },
    { { 5, 0, 1, 2, 3, 4 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.3468966650378003, 0.5737938168652287,
        0.23908075702717863, -0.7833269096274834, -0.24071198299688865, 0.7230709935022924,
        0.30127958062595517, 0.6216099682706644, 1.910172966735487e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.6167051822894228, 0.2360283781981653,
        0.12588180170568816, 0.963558185417193, 0.05060832613278151, -0.8501983988975231,
        -0.453439146078679, 0.26749882862458735, 0.18855617369548777 },
    { 0.5403023058681398, -0.8414709848078966, 0.0, 0.250536480305078, 0.7384602626041288,
        0.4741598817790379, -0.479425538604203, 0.032924257305286767, 0.4034226801113349,
        0.2590347239999257, 0.8775825618903728, 0.09920262232951157 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.4047127758774337, -0.021144481666450613,
        -0.02013760158709582, -0.9995736030415052, 0.08898300940260505, 0.723829160823159,
        0.6893611055458657, -0.02919952230128894, 0.07127376158977099 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.19272036946544463, 0.7234993663501919,
        0.24805692560578008, 0.644217687237691, 0.10807014469215119, -0.6093951095491672,
        -0.20893546613114305, 0.7648421872844885, -0.0910262268897436 },
    { 0.955336489125606, 0.28962947762551555, 0.058710801693826524, -0.09553364891256061,
        -0.29552020666133955, 0.9362933635841992, 0.18979606097868743, 0.029552020666133955, 0.0,
        -0.19866933079506122, 0.9800665778412416, -0.09911628477331971 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.10295467142321668 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    8, /* solutions at most */
    0.5188865104263425, 1.9272036946544462, /* the length that is one in the loop, and its inverse
        */
    HUGE_VAL, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, formulations,
    { { 1.0, 0.38461538461538464, 0.47058823529411764, 1.0, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.0, 0.9230769230769231, 0.8823529411764706, 0.0, 0.7241379310344828, 0.9459459459459459 }
            },
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
DHGEN_TABLE int turning[6] = { 0, 1, 1, 0, 1, 1 };
DHGEN_TABLE double unit[6] = { 1.75, 1.0, 1.0, 1.75, 1.0, 1.0 };
DHGEN_TABLE double measure[6] = {
    1.0, 0.5714285714285714, 0.5714285714285714, 1.0, 0.5714285714285714, 0.5714285714285714,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    0.0, -3.141592653589793, -3.141592653589793, -0.2285714285714286, -3.141592653589793,
    -3.141592653589793,
};
DHGEN_TABLE double span_width[6] = {
    0.6857142857142857, 6.283185307179586, 6.283185307179586, 0.4571428571428572, 6.283185307179586,
    6.283185307179586,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
DHGEN_TABLE double least_u[6] = {
    0.0, -HUGE_VAL, -HUGE_VAL, -0.2285714285714286, -HUGE_VAL, -HUGE_VAL,
};
DHGEN_TABLE double most_u[6] = {
    0.6857142857142857, HUGE_VAL, HUGE_VAL, 0.2285714285714286, HUGE_VAL, HUGE_VAL,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 8, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.75, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    general_prrprr_fk, general_prrprr_jacobian, 0, 0,
};


/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.3, 0.0, 0.1, 0.2 },
    { 0.0, 0.25, 0.18, 0.9 },
    { 0.0, 0.11, 0.32, -1.3 },
    { 1.0, 0.0, 0.13, 0.5 },
    { 0.0, -0.16, 0.21, 1.6 },
    { 0.0, 0.19, 0.1, -0.7 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void general_prrprr_fk(const double q[6], double T[16])
{
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = cat1 * c2 - f10 * s2,
        x2_y = f1 * c2 + f11 * s2, x2_z = f2 * c2 + f12 * s2, v1 = f10 * c2 + cat1 * s2,
        y2_y = f11 * c2 - f1 * s2, y2_z = f12 * c2 - f2 * s2, v2 = v1 * ca3 + f17,
        v3 = y2_y * ca3 + f18, v4 = y2_z * ca3 - f19, z3_x = f20 - v1 * sa3,
        z3_y = y2_y * sa3 - f21, z3_z = y2_z * sa3 + f22;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 + v3 * s3, x3_z = x2_z * c3 + v4 * s3, v5 = v2 * c3 + x2_x * s3,
        y3_y = v3 * c3 - x2_y * s3, y3_z = v4 * c3 - x2_z * s3,
        x4_x = x3_x * cat4 - v5 * f23 + z3_x * f24, x4_y = x3_y * cat4 + y3_y * f23 + z3_y * f24,
        x4_z = x3_z * cat4 + y3_z * f23 + z3_z * f24, y4_x = z3_x * f26 - (x3_x * sat4 + v5 * f25),
        y4_y = y3_y * f25 - x3_y * sat4 + z3_y * f26, y4_z = y3_z * f25 - x3_z * sat4 + z3_z * f26,
        z4_x = v5 * sa4 + z3_x * ca4, z4_y = z3_y * ca4 - y3_y * sa4,
        z4_z = z3_z * ca4 - y3_z * sa4, v6 = z4_x * sa5 - y4_x * ca5, v7 = z4_y * sa5 - y4_y * ca5,
        v8 = z4_z * sa5 - y4_z * ca5, v9 = y4_x * sa5 + z4_x * ca5, v10 = y4_y * sa5 + z4_y * ca5,
        v11 = y4_z * sa5 + z4_z * ca5;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + v6 * s5,
        x5_y = x4_y * c5 + v7 * s5, x5_z = x4_z * c5 + v8 * s5, y5_x = v6 * c5 - x4_x * s5,
        y5_y = v7 * c5 - x4_y * s5, y5_z = v8 * c5 - x4_z * s5, v12 = y5_x * ca6 + v9 * sa6,
        v13 = y5_y * ca6 + v10 * sa6, v14 = y5_z * ca6 + v11 * sa6;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + v12 * s6; T[1] = v12 * c6 - x5_x * s6; T[2] = y5_x * sa6 - v9 * ca6;
    T[3] = f5 + x2_x * a3 - v1 * f13 + f14 + x3_x * a4 + z4_x * q[3] + x4_x * a5 - y4_x * f27 - z4_x
        * f28 + x5_x * a6 + y5_x * f29 - v9 * f30;
    T[4] = x5_y * c6 + v13 * s6; T[5] = v13 * c6 - x5_y * s6; T[6] = y5_y * sa6 - v10 * ca6;
    T[7] = f3 - sa1 * q[0] - f6 - f8 + x2_y * a3 + y2_y * f13 - f15 + x3_y * a4 + z4_y * q[3] + x4_y
        * a5 - y4_y * f27 - z4_y * f28 + x5_y * a6 + y5_y * f29 - v10 * f30;
    T[8] = x5_z * c6 + v14 * s6; T[9] = v14 * c6 - x5_z * s6; T[10] = y5_z * sa6 - v11 * ca6;
    T[11] = ca1 * q[0] + f4 - f7 + f9 + x2_z * a3 + y2_z * f13 + f16 + x3_z * a4 + z4_z * q[3] +
        x4_z * a5 - y4_z * f27 - z4_z * f28 + x5_z * a6 + y5_z * f29 - v11 * f30;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void general_prrprr_jacobian(const double q[6], double J[36])
{
    const double p2_y = f3 - sa1 * q[0] - f6 - f8, p2_z = ca1 * q[0] + f4 - f7 + f9;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = cat1 * c2 - f10 * s2,
        x2_y = f1 * c2 + f11 * s2, x2_z = f2 * c2 + f12 * s2, v1 = f10 * c2 + cat1 * s2,
        y2_y = f11 * c2 - f1 * s2, y2_z = f12 * c2 - f2 * s2,
        p3_x = f5 + x2_x * a3 - v1 * f13 + f14, p3_y = p2_y + x2_y * a3 + y2_y * f13 - f15,
        p3_z = p2_z + x2_z * a3 + y2_z * f13 + f16, v2 = v1 * ca3 + f17, v3 = y2_y * ca3 + f18,
        v4 = y2_z * ca3 - f19, z3_x = f20 - v1 * sa3, z3_y = y2_y * sa3 - f21,
        z3_z = y2_z * sa3 + f22;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 + v3 * s3, x3_z = x2_z * c3 + v4 * s3, v5 = v2 * c3 + x2_x * s3,
        y3_y = v3 * c3 - x2_y * s3, y3_z = v4 * c3 - x2_z * s3,
        x4_x = x3_x * cat4 - v5 * f23 + z3_x * f24, x4_y = x3_y * cat4 + y3_y * f23 + z3_y * f24,
        x4_z = x3_z * cat4 + y3_z * f23 + z3_z * f24, y4_x = z3_x * f26 - (x3_x * sat4 + v5 * f25),
        y4_y = y3_y * f25 - x3_y * sat4 + z3_y * f26, y4_z = y3_z * f25 - x3_z * sat4 + z3_z * f26,
        z4_x = v5 * sa4 + z3_x * ca4, z4_y = z3_y * ca4 - y3_y * sa4,
        z4_z = z3_z * ca4 - y3_z * sa4,
        p5_x = p3_x + x3_x * a4 + z4_x * q[3] + x4_x * a5 - y4_x * f27 - z4_x * f28,
        p5_y = p3_y + x3_y * a4 + z4_y * q[3] + x4_y * a5 - y4_y * f27 - z4_y * f28,
        p5_z = p3_z + x3_z * a4 + z4_z * q[3] + x4_z * a5 - y4_z * f27 - z4_z * f28,
        v6 = z4_x * sa5 - y4_x * ca5, v7 = z4_y * sa5 - y4_y * ca5, v8 = z4_z * sa5 - y4_z * ca5,
        v9 = y4_x * sa5 + z4_x * ca5, v10 = y4_y * sa5 + z4_y * ca5, v11 = y4_z * sa5 + z4_z * ca5;
    const double c5 = cos(q[4]), s5 = sin(q[4]), y5_x = v6 * c5 - x4_x * s5,
        y5_y = v7 * c5 - x4_y * s5, y5_z = v8 * c5 - x4_z * s5,
        p6_x = p5_x + (x4_x * c5 + v6 * s5) * a6 + y5_x * f29 - v9 * f30,
        p6_y = p5_y + (x4_y * c5 + v7 * s5) * a6 + y5_y * f29 - v10 * f30,
        p6_z = p5_z + (x4_z * c5 + v8 * s5) * a6 + y5_z * f29 - v11 * f30, v12 = p6_x - f5,
        v13 = p6_y - p2_y, v14 = p6_z - p2_z, v15 = p6_x - p3_x, v16 = p6_y - p3_y,
        v17 = p6_z - p3_z, v18 = p6_x - p5_x, v19 = p6_y - p5_y, v20 = p6_z - p5_z;
    J[0] = 0.0; J[1] = -(g14 * v14 + g15 * v13); J[2] = z3_y * v17 - z3_z * v16; J[3] = z4_x;
    J[4] = v11 * v19 - v10 * v20; J[5] = 0.0;
    J[6] = -sa1; J[7] = g15 * v12 - g13 * v14; J[8] = z3_z * v15 - z3_x * v17; J[9] = z4_y;
    J[10] = v9 * v20 - v11 * v18; J[11] = 0.0;
    J[12] = ca1; J[13] = g13 * v13 + g14 * v12; J[14] = z3_x * v16 - z3_y * v15; J[15] = z4_z;
    J[16] = v10 * v18 - v9 * v19; J[17] = 0.0;
    J[18] = 0.0; J[19] = g13; J[20] = z3_x; J[21] = 0.0; J[22] = -v9; J[23] = y5_x * sa6 - v9 * ca6;
    J[24] = 0.0; J[25] = -g14; J[26] = z3_y; J[27] = 0.0; J[28] = -v10;
    J[29] = y5_y * sa6 - v10 * ca6;
    J[30] = 0.0; J[31] = g15; J[32] = z3_z; J[33] = 0.0; J[34] = -v11;
    J[35] = y5_z * sa6 - v11 * ca6;
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
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.5714, 0.5714, 0.5714, 1.0, 1.0, 1.0 }, 0.5714285714285714, { 1e-14, 1e-10 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, general_prrprr_fk, general_prrprr_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) general_prrprr_##function
#include "dhgen/functions.h"
