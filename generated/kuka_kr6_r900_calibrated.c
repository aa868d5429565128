/* kuka_kr6_r900_calibrated: KUKA KR 6 R900 with calibration noise of 1e-4
 *
 * Inverse kinematics, generated from robots/kuka_kr6_r900_calibrated.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_kr6_r900_calibrated.yaml. The formulas and where they come
 * from: kuka_kr6_r900_calibrated.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 193c5bacd2d40f86
 * SPDX-License-Identifier: MIT
 */
#include "kuka_kr6_r900_calibrated.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KUKA_KR6_R900_CALIBRATED_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_KR6_R900_CALIBRATED_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef KUKA_KR6_R900_CALIBRATED_LANES
#define DHGEN_GENERAL_LANES KUKA_KR6_R900_CALIBRATED_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"
#include "dhgen/general/near.h"
#ifndef KUKA_KR6_R900_CALIBRATED_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.400051, /* joint offset 1 [m] */
    a1 = 0.024977, /* link length 1 [m] */
    ca1 = 3.1999999994631904e-05, /* cosine of twist 1 */
    sa1 = 0.999999999488, /* sine of twist 1 */
    d2 = -2.1e-05, /* joint offset 2 [m] */
    a2 = 0.455111, /* link length 2 [m] */
    ca2 = 0.999999999118, /* cosine of twist 2 */
    sa2 = 4.1999999987652e-05, /* sine of twist 2 */
    d3 = 2.5e-05, /* joint offset 3 [m] */
    a3 = 0.025039, /* link length 3 [m] */
    ca3 = 1.899999999890931e-05, /* cosine of twist 3 */
    sa3 = 0.9999999998195, /* sine of twist 3 */
    d4 = 0.420086, /* joint offset 4 [m] */
    a4 = 5.1e-05, /* link length 4 [m] */
    ca4 = 4.9999999979333415e-05, /* cosine of twist 4 */
    sa4 = 0.99999999875, /* sine of twist 4 */
    d5 = -0.000174, /* joint offset 5 [m] */
    a5 = -8.9e-05, /* link length 5 [m] */
    ca5 = 4.6999999982665624e-05, /* cosine of twist 5 */
    sa5 = 0.9999999988955, /* sine of twist 5 */
    d6 = 0.089995, /* joint offset 6 [m] */
    a6 = 5.2e-05, /* link length 6 [m] */
    ca6 = 0.999999997952, /* cosine of twist 6 */
    sa6 = 6.399999995630933e-05, /* sine of twist 6 */
    offset1 = -2.6e-05, /* offset of joint 1 [rad] */
    offset2 = -1.5708893267948965, /* offset of joint 2 [rad] */
    offset3 = -1.5706923267948965, /* offset of joint 3 [rad] */
    offset4 = -0.000167, /* offset of joint 4 [rad] */
    offset5 = 3.141423653589793, /* offset of joint 5 [rad] */
    offset6 = 3.1e-05, /* offset of joint 6 [rad] */
    f1 = -6.719999998872699e-10, /* ca1 * d2 [m] */
    f2 = 1.343999999379404e-09, /* ca1 * sa2 */
    f3 = 3.1999999966407905e-05; /* ca1 * ca2 */

#ifndef __CUDACC_RTC__
const char *const kuka_kr6_r900_calibrated_branches[16] = {
#ifdef KUKA_KR6_R900_CALIBRATED_PLAIN
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
#else
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip", "further1", "further2", "further3",
    "further4", "further5", "further6", "further7", "further8",
#endif
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
    { { 5, 4, 3, 2, 1, 0 }, -1.0, 0 },
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.055394309350457506, -2.9538461533506374e-05,
        -1.2307692305627655e-05, 0.999999999488, 5.907378613838845e-06, -0.9230769226043077,
        -0.38461538441846155, -3.1999999994631904e-05, 8.872383044631429e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 1.0093509838169543, 0.8823529403982353,
        0.4705882348790589, -4.1999999987652006e-05, -2.4523306599316377e-09, 3.705882351851647e-05,
        1.976470587654212e-05, 0.9999999991180001, 5.907378588330026e-06 },
    { 0.28, -0.96, 0.0, 0.05553181374168657, 1.8239999998952937e-05, 5.319999999694607e-06,
        0.9999999998195, 0.46583605016172774, -0.95999999982672, -0.27999999994946007,
        1.899999999890931e-05, 5.907378744506423e-06 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.00011310845084971505, -3.620689653675868e-05,
        -3.448275860643684e-05, -0.99999999875, 0.00018130380869483623, 0.7241379301293104,
        0.6896551715517242, -4.9999999979333415e-05, 0.46583605065572053 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, -0.00019738533579656157, 4.445945944306208e-05,
        1.5243243237621286e-05, -0.9999999988955001, -9.615993722573778e-09, 0.9459459449011487,
        0.32432432396610816, 4.699999998266563e-05, -0.000204595611172669 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.40005099951471357 },
    { 1.0, 0.0, 0.0, -5.2e-05, 0.0, 0.999999997952, -6.399999995630933e-05, 5.759679718576826e-06,
        0.0, 6.399999995630933e-05, 0.999999997952, -0.08999499547988973 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.4508946910409257, 2.217812761759119, /* the length that is one in the loop, and its inverse */
    4.0000000039999986, /* the square of what is out of reach for all links in line */
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
    0.7063788125913435, 0.7063788125913435, 0.7063788125913435, 0.7063788125913435,
    0.7063788125913435, 0.7063788125913435,
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
DHGEN_TABLE double zero[6] = {
    -2.6e-05, -1.5708893267948965, -1.5706923267948965, -0.000167, 3.141423653589793, 3.1e-05,
};

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 1.4156710000000001, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, facing, zero, 0, 0,
    kuka_kr6_r900_calibrated_fk, kuka_kr6_r900_calibrated_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { -2.6e-05, 0.400051, 0.024977, -1.5708283267948966 },
    { -1.5708893267948965, -2.1e-05, 0.455111, 4.2e-05 },
    { -1.5706923267948965, 2.5e-05, 0.025039, -1.5707773267948966 },
    { -0.000167, 0.420086, 5.1e-05, 1.5708463267948967 },
    { 3.141423653589793, -0.000174, -8.9e-05, 1.5707493267948966 },
    { 3.1e-05, 0.089995, 5.2e-05, -6.4e-05 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void kuka_kr6_r900_calibrated_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), y1_x = s1 * ca1, v2 = c1 * ca1, v3 = s1 * sa1,
        z1_y = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 + y1_x * s2, x2_y = s1 * c2 - v2 * s2,
        v5 = sa1 * s2, v6 = y1_x * c2 - c1 * s2, v7 = v2 * c2 + s1 * s2, v8 = sa1 * c2,
        y2_x = v6 * ca2 - v3 * sa2, y2_y = z1_y * sa2 - v7 * ca2, v9 = v8 * ca2 + f2,
        v10 = v6 * sa2 + v3 * ca2, z2_y = v7 * sa2 + z1_y * ca2, z2_z = v8 * sa2 - f3,
        v11 = q[2] + offset3;
    const double c3 = cos(v11), s3 = sin(v11), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, v12 = v5 * c3 + v9 * s3, v13 = y2_x * c3 - x2_x * s3,
        v14 = y2_y * c3 - x2_y * s3, v15 = v5 * s3 - v9 * c3, y3_x = v13 * ca3 + v10 * sa3,
        y3_y = v14 * ca3 - z2_y * sa3, y3_z = v15 * ca3 - z2_z * sa3, z3_x = v13 * sa3 - v10 * ca3,
        z3_y = v14 * sa3 + z2_y * ca3, z3_z = v15 * sa3 + z2_z * ca3, v16 = q[3] + offset4;
    const double c4 = cos(v16), s4 = sin(v16), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = y3_z * s4 - v12 * c4, v17 = y3_x * c4 - x3_x * s4,
        v18 = y3_y * c4 - x3_y * s4, v19 = y3_z * c4 + v12 * s4, y4_x = z3_x * sa4 - v17 * ca4,
        y4_y = z3_y * sa4 - v18 * ca4, y4_z = z3_z * sa4 - v19 * ca4, v20 = v17 * sa4 + z3_x * ca4,
        v21 = v18 * sa4 + z3_y * ca4, v22 = v19 * sa4 + z3_z * ca4, v23 = q[4] + offset5;
    const double c5 = cos(v23), s5 = sin(v23), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v24 = y4_x * c5 - x4_x * s5,
        v25 = y4_y * c5 - x4_y * s5, v26 = y4_z * c5 - x4_z * s5, y5_x = v24 * ca5 - v20 * sa5,
        y5_y = v25 * ca5 - v21 * sa5, y5_z = v26 * ca5 - v22 * sa5, v27 = v24 * sa5 + v20 * ca5,
        v28 = v25 * sa5 + v21 * ca5, v29 = v26 * sa5 + v22 * ca5, v30 = q[5] + offset6;
    const double c6 = cos(v30), s6 = sin(v30), x6_x = x5_x * c6 + y5_x * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 + y5_z * s6, v31 = y5_x * c6 - x5_x * s6,
        v32 = y5_y * c6 - x5_y * s6, v33 = y5_z * c6 - x5_z * s6;
    T[0] = x6_x; T[1] = v31 * ca6 + v27 * sa6; T[2] = v31 * sa6 - v27 * ca6;
    T[3] = c1 * a1 + x2_x * a2 - v3 * d2 + x3_x * a3 - v10 * d3 + x4_x * a4 + z3_x * d4 + x5_x * a5
        - v20 * d5 + x6_x * a6 - v27 * d6;
    T[4] = x6_y; T[5] = v32 * ca6 + v28 * sa6; T[6] = v32 * sa6 - v28 * ca6;
    T[7] = s1 * a1 + x2_y * a2 + z1_y * d2 + x3_y * a3 + z2_y * d3 + x4_y * a4 + z3_y * d4 + x5_y *
        a5 - v21 * d5 + x6_y * a6 - v28 * d6;
    T[8] = x6_z; T[9] = v33 * ca6 + v29 * sa6; T[10] = v33 * sa6 - v29 * ca6;
    T[11] = d1 - v5 * a2 - f1 - v12 * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 - v22 * d5
        + x6_z * a6 - v29 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kuka_kr6_r900_calibrated_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), p1_x = c1 * a1, p1_y = s1 * a1, y1_x = s1 * ca1,
        v2 = c1 * ca1, v3 = s1 * sa1, z1_y = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 + y1_x * s2, x2_y = s1 * c2 - v2 * s2,
        v5 = sa1 * s2, v6 = y1_x * c2 - c1 * s2, v7 = v2 * c2 + s1 * s2, v8 = sa1 * c2,
        p2_x = p1_x + x2_x * a2 - v3 * d2, p2_y = p1_y + x2_y * a2 + z1_y * d2,
        p2_z = d1 - v5 * a2 - f1, y2_x = v6 * ca2 - v3 * sa2, y2_y = z1_y * sa2 - v7 * ca2,
        v9 = v8 * ca2 + f2, v10 = v6 * sa2 + v3 * ca2, z2_y = v7 * sa2 + z1_y * ca2,
        z2_z = v8 * sa2 - f3, v11 = q[2] + offset3;
    const double c3 = cos(v11), s3 = sin(v11), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, v12 = v5 * c3 + v9 * s3, v13 = y2_x * c3 - x2_x * s3,
        v14 = y2_y * c3 - x2_y * s3, v15 = v5 * s3 - v9 * c3, p3_x = p2_x + x3_x * a3 - v10 * d3,
        p3_y = p2_y + x3_y * a3 + z2_y * d3, p3_z = p2_z - v12 * a3 + z2_z * d3,
        y3_x = v13 * ca3 + v10 * sa3, y3_y = v14 * ca3 - z2_y * sa3, y3_z = v15 * ca3 - z2_z * sa3,
        z3_x = v13 * sa3 - v10 * ca3, z3_y = v14 * sa3 + z2_y * ca3, z3_z = v15 * sa3 + z2_z * ca3,
        v16 = q[3] + offset4;
    const double c4 = cos(v16), s4 = sin(v16), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = y3_z * s4 - v12 * c4, v17 = y3_x * c4 - x3_x * s4,
        v18 = y3_y * c4 - x3_y * s4, v19 = y3_z * c4 + v12 * s4,
        p4_x = p3_x + x4_x * a4 + z3_x * d4, p4_y = p3_y + x4_y * a4 + z3_y * d4,
        p4_z = p3_z + x4_z * a4 + z3_z * d4, y4_x = z3_x * sa4 - v17 * ca4,
        y4_y = z3_y * sa4 - v18 * ca4, y4_z = z3_z * sa4 - v19 * ca4, v20 = v17 * sa4 + z3_x * ca4,
        v21 = v18 * sa4 + z3_y * ca4, v22 = v19 * sa4 + z3_z * ca4, v23 = q[4] + offset5;
    const double c5 = cos(v23), s5 = sin(v23), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v24 = y4_x * c5 - x4_x * s5,
        v25 = y4_y * c5 - x4_y * s5, v26 = y4_z * c5 - x4_z * s5,
        p5_x = p4_x + x5_x * a5 - v20 * d5, p5_y = p4_y + x5_y * a5 - v21 * d5,
        p5_z = p4_z + x5_z * a5 - v22 * d5, v27 = v24 * sa5 + v20 * ca5,
        v28 = v25 * sa5 + v21 * ca5, v29 = v26 * sa5 + v22 * ca5, v30 = q[5] + offset6;
    const double c6 = cos(v30), s6 = sin(v30),
        p6_x = p5_x + (x5_x * c6 + (v24 * ca5 - v20 * sa5) * s6) * a6 - v27 * d6,
        p6_y = p5_y + (x5_y * c6 + (v25 * ca5 - v21 * sa5) * s6) * a6 - v28 * d6,
        p6_z = p5_z + (x5_z * c6 + (v26 * ca5 - v22 * sa5) * s6) * a6 - v29 * d6, v31 = p6_x - p1_x,
        v32 = p6_y - p1_y, v33 = p6_z - d1, v34 = p6_x - p2_x, v35 = p6_y - p2_y, v36 = p6_z - p2_z,
        v37 = p6_x - p3_x, v38 = p6_y - p3_y, v39 = p6_z - p3_z, v40 = p6_x - p4_x,
        v41 = p6_y - p4_y, v42 = p6_z - p4_z, v43 = p6_x - p5_x, v44 = p6_y - p5_y,
        v45 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = z1_y * v33 + ca1 * v32; J[2] = z2_y * v36 - z2_z * v35;
    J[3] = z3_y * v39 - z3_z * v38; J[4] = v22 * v41 - v21 * v42; J[5] = v29 * v44 - v28 * v45;
    J[6] = p6_x; J[7] = v3 * v33 - ca1 * v31; J[8] = z2_z * v34 + v10 * v36;
    J[9] = z3_z * v37 - z3_x * v39; J[10] = v20 * v42 - v22 * v40; J[11] = v27 * v45 - v29 * v43;
    J[12] = 0.0; J[13] = -(v3 * v32 + z1_y * v31); J[14] = -(v10 * v35 + z2_y * v34);
    J[15] = z3_x * v38 - z3_y * v37; J[16] = v21 * v40 - v20 * v41; J[17] = v28 * v43 - v27 * v44;
    J[18] = 0.0; J[19] = -v3; J[20] = -v10; J[21] = z3_x; J[22] = -v20; J[23] = -v27;
    J[24] = 0.0; J[25] = z1_y; J[26] = z2_y; J[27] = z3_y; J[28] = -v21; J[29] = -v28;
    J[30] = 1.0; J[31] = -ca1; J[32] = z2_z; J[33] = z3_z; J[34] = -v22; J[35] = -v29;
}

#ifndef KUKA_KR6_R900_CALIBRATED_PLAIN
/* The nearest arm with a structure: what follows is its closed form. A pose at which one of its
 * branches may end by what the two arms differ is left to the general algorithm. */
/* In formulas below, near_a2 = 0.45511099999999993 [m], near_a3 = -0.025039000000000033 [m],
 * near_d4 = 0.42008600000000007 [m], near_k1 = 2 * near_d4 * near_a2 = 0.382371519092 [m^2],
 * near_k2 = 2 * near_a3 * near_a2 = -0.022791048658000027 [m^2],
 * near_doubt_limit1 = 9.25213e-05 [m], near_longest3_apart = 0.7672753622269346 [m^2],
 * near_k4 = 1 / ((2 * near_d4 * near_a2)^2 + (2 * near_a3 * near_a2)^2) = 6.815359151455662 [m^-4],
 * near_doubt_limit = 9.999999999999999e-05. */
static const double
    near_a1 = -0.024977, /* link length 1 [m] */
    near_longest3 = 0.7672753622269508, /* square of the longest reach [m^2] */
    near_shortest3 = 0.001175080249049243, /* square of the shortest reach [m^2] */
    near_k3 = 0.384225221238, /* near_a2^2 + (near_a3^2 + near_d4^2) [m^2] */
    near_turn1 = -1.6303303533892188, /* atan2(-near_k1, near_k2) [rad] */
    near_m1 = 8.560190953689999e-09, /* near_doubt_limit1^2 [m^2] */
    near_m2 = 0.5, /* 1 / 2 */
    /* 1000 * (near_longest3 - near_longest3_apart) * (near_longest3_apart - near_shortest3)
     * [m^4] */
    near_m3 = 1.2417915714465629e-11,
    near_m4 = 1.0986330807209672, /* near_k4 * (near_d4 * near_k1 + near_a3 * near_k2) [m^-1] */
    /* near_a2 - near_d4 * near_k1 * near_k3 * near_k4 - near_a3 * near_k2 * near_k3 * near_k4
     * [m] */
    near_m5 = 0.032988461500600814,
    near_m6 = 1.1860189164290886, /* near_a2 * near_k1 * near_k4 [m^-1] */
    near_m7 = 0.07069201936857687, /* -near_a2 * near_k2 * near_k4 [m^-1] */
    /* near_k2 * near_k4 * (near_d4 * near_k1 * near_k3^2 * near_k4 + near_a3 * near_k2 * near_k3^2
     * * near_k4 - near_a2 * near_k3 - near_d4 * near_longest3 * near_shortest3 * near_k1 * near_k4
     * - near_a3 * near_longest3 * near_shortest3 * near_k2 * near_k4) [m] */
    near_m8 = 0.0021226567816523957,
    /* near_k1 * near_k4 * (near_a2 * near_k3 + near_d4 * near_longest3 * near_shortest3 * near_k1 *
     * near_k4 + near_a3 * near_longest3 * near_shortest3 * near_k2 * near_k4 - near_d4 * near_k1 *
     * near_k3^2 * near_k4 - near_a3 * near_k2 * near_k3^2 * near_k4) [m] */
    near_m9 = 0.03561238055741952,
    near_m10 = 9.999999999999999e-09, /* near_doubt_limit^2 */
    near1 = 0.5; /* 1 / 2 */

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    /* theta1 */ \
    const dhgen_##number v1 = T14 * T14 + T24 * T24, w1 = dhgen_sqrt_##number(v1), \
        v2 = DHGEN_QUOTIENT(1.0, v1); \
    /* theta3 */ \
    const dhgen_##number v4 = T34 * T34; \
    /* theta4 */ \
    const dhgen_##number v10 = near_m7 * T34, v17 = near_m6 * T34, v22 = T14 * T13 + T24 * T23, \
        v23 = v2 * v22, v24 = w1 * v23, v25 = T24 * T13 - T14 * T23, Y4 = w1 * (v2 * v25), \
        v26 = Y4 * Y4; \
    /* theta6 */ \
    const dhgen_##number v30 = w1 * (v2 * (T14 * T22 - T24 * T12)), \
        v31 = w1 * (v2 * (T14 * T12 + T24 * T22)), v32 = w1 * (v2 * (T14 * T21 - T24 * T11)), \
        v33 = w1 * (v2 * (T14 * T11 + T24 * T21)); \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v35 = T34 * free_joints[1], v36 = dhgen_abs_##number(T34), \
        v37 = dhgen_abs_##number(free_joints[1]), v38 = v35 + v35, v39 = v37 * v37, \
        v40 = T14 * free_joints[1], v41 = v40 + v40, v42 = T24 * free_joints[1], v43 = v42 + v42, \
        v44 = v39 + v39, v45 = DHGEN_QUOTIENT(near1, w1), v46 = v41 * v45, v47 = v43 * v45, \
        v48 = v44 * dhgen_abs_##number(v45), \
        v51 = v48 + dhgen_sqrt_##number(v46 * v46 + v47 * v47), v61 = v38 * v38, v69 = w1 * v2, \
        v70 = T33 * free_joints[0], v71 = T23 * free_joints[0], \
        v72 = near1 * (free_joints[0] * free_joints[0]), v73 = T24 * v70, \
        v74 = v72 * dhgen_abs_##number(T24), v75 = T13 * free_joints[1], v76 = v70 * v70, \
        v77 = v71 * v71, v78 = v37 * (v72 + dhgen_sqrt_##number(v76 + v77)), \
        v79 = T13 * free_joints[0], v80 = T14 * v70, v81 = v72 * dhgen_abs_##number(T14), \
        v82 = T23 * free_joints[1], v83 = v79 * v79, \
        v84 = v37 * (v72 + dhgen_sqrt_##number(v76 + v83)), v85 = T24 * v71 + T14 * v79, \
        v86 = v74 + v78 + (v81 + v84), v87 = dhgen_abs_##number(v2), v88 = v2 * (v2 * v41), \
        v89 = v2 * (v2 * v43), v90 = v87 * (v44 * v87), v91 = w1 - dhgen_sqrt_##number(v44), \
        v92 = v90 + (v90 + (dhgen_abs_##number(v88) + dhgen_abs_##number(v89))) * \
            DHGEN_QUOTIENT(v44 + dhgen_sqrt_##number(v41 * v41 + v43 * v43), v91 * v91), \
        v93 = dhgen_abs_##number(w1), v94 = v92 + dhgen_sqrt_##number(v88 * v88 + v89 * v89), \
        v95 = v2 * v46 - w1 * v88, v96 = v2 * v47 - w1 * v89, \
        v97 = v92 * v93 + v48 * v87 + v51 * v94, v98 = v69 * v80, v99 = v69 * v73, \
        v100 = v69 * v85, v101 = v80 * v80 + v73 * v73, \
        v102 = dhgen_sqrt_##number(v82 * v82 + v75 * v75), v103 = v25 * v95 - v69 * v82, \
        v104 = v25 * v96 + v69 * v75, \
        v105 = v97 * dhgen_abs_##number(v25) + v86 * dhgen_abs_##number(v69) + (v86 + (v102 + \
            dhgen_sqrt_##number(v101 + v85 * v85))) * (v97 + dhgen_sqrt_##number(v95 * v95 + v96 * \
            v96)) + (dhgen_sqrt_##number(v98 * v98 + v99 * v99 + v100 * v100) + \
            dhgen_sqrt_##number(v103 * v103 + v104 * v104)), v135 = near_m6 * free_joints[1], \
        v138 = near_m7 * v48, v154 = dhgen_abs_##number(T33), \
        v155 = v72 + dhgen_sqrt_##number(v77 + v83), v160 = near_m7 * free_joints[1], \
        v163 = near_m6 * v48, v177 = T24 * v79 - T14 * v71, v178 = v78 + v81 + (v74 + v84), \
        v179 = v2 * v73, v180 = v2 * v80, v181 = v2 * v177, v182 = v2 * v75 - v22 * v88, \
        v183 = v2 * v82 - v22 * v89, \
        v184 = v87 * v178 + v92 * dhgen_abs_##number(v22) + v94 * (v178 + (v102 + \
            dhgen_sqrt_##number(v101 + v177 * v177))), v185 = w1 * v179, v186 = w1 * v180, \
        v187 = w1 * v181, v188 = w1 * v182 + v23 * v46, v189 = w1 * v183 + v23 * v47, \
        v190 = v93 * v184 + v48 * dhgen_abs_##number(v23) + v51 * (v184 + \
            (dhgen_sqrt_##number(v179 * v179 + v180 * v180 + v181 * v181) + \
            dhgen_sqrt_##number(v182 * v182 + v183 * v183))), v191 = dhgen_abs_##number(v24), \
        v192 = v190 + (dhgen_sqrt_##number(v185 * v185 + v186 * v186 + v187 * v187) + \
            dhgen_sqrt_##number(v188 * v188 + v189 * v189)), v200 = v105 * v105
#define SIGNED(number, signs) \
    /* theta3 */ \
    const dhgen_##number Z2_3 = e1 * w1 - near_a1, N3 = v4 + Z2_3 * Z2_3, v5 = near_longest3 - N3, \
        v6 = N3 - near_shortest3, D3_squared = v5 * v6, w3 = dhgen_sqrt_##number(D3_squared); \
    /* theta2 */ \
    const dhgen_##number X1_2 = near_m5 + near_m4 * N3, v7 = T34 * X1_2, v8 = Z2_3 * X1_2, \
        factor2 = DHGEN_QUOTIENT(1.0, N3); \
    /* theta4 */ \
    const dhgen_##number v11 = v10 - near_m6 * Z2_3, v12 = near_m8 * factor2 - near_m7, \
        v13 = near_m9 * factor2 - near_m6, v14 = Z2_3 * v12 + T34 * v13, \
        v18 = v17 + near_m7 * Z2_3, v19 = Z2_3 * -v13 + T34 * v12, v28 = e1 * Y4, \
        v29 = dhgen_signed_##number(DHGEN_HALF_TURN, v28); \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v49 = e1 * v46, v50 = e1 * v47, v52 = Z2_3 * v49, v53 = Z2_3 * v50, \
        v54 = dhgen_abs_##number(Z2_3), v55 = v48 * v54, \
        v56 = v48 + dhgen_sqrt_##number(v49 * v49 + v50 * v50), v57 = v52 + v52, v58 = v53 + v53, \
        v59 = v56 * v56, v60 = v39 + (v59 + (v55 + v55)), \
        v62 = v60 + dhgen_sqrt_##number(v61 + (v57 * v57 + v58 * v58)), v63 = v5 * v57 - v6 * v57, \
        v64 = v5 * v58 - v6 * v58, v65 = v5 * v38 - v6 * v38, \
        v66 = v60 * dhgen_abs_##number(v5) + v60 * dhgen_abs_##number(v6) + v62 * v62, \
        v67 = v66 + dhgen_sqrt_##number(v63 * v63 + v64 * v64 + v65 * v65), v68 = v39 + v59, \
        v106 = dhgen_abs_##number(factor2), v107 = factor2 * (factor2 * v57), \
        v108 = factor2 * (factor2 * v58), v109 = factor2 * (factor2 * v38), \
        v110 = v106 * (v60 * v106), v111 = dhgen_sqrt_##number(N3) - dhgen_sqrt_##number(v68), \
        v112 = v110 + (v110 + (dhgen_abs_##number(v109) + (dhgen_abs_##number(v107) + \
            dhgen_abs_##number(v108)))) * DHGEN_QUOTIENT(v62, v111 * v111), v113 = near_m9 * v107, \
        v114 = near_m9 * v108, v115 = near_m9 * v109, v116 = near_m9 * v112, \
        v117 = v112 + dhgen_sqrt_##number(v107 * v107 + v108 * v108 + v109 * v109), \
        v118 = v116 + dhgen_sqrt_##number(v113 * v113 + v114 * v114 + v115 * v115), \
        v119 = near_m8 * v107, v120 = near_m8 * v108, v121 = near_m8 * v109, \
        v122 = near_m8 * v112, \
        v123 = v122 + dhgen_sqrt_##number(v119 * v119 + v120 * v120 + v121 * v121), \
        v124 = Z2_3 * v113 - v13 * v49 - T34 * v119, v125 = Z2_3 * v114 - v13 * v50 - T34 * v120, \
        v126 = Z2_3 * v115 + (v12 * free_joints[1] - T34 * v121), \
        v127 = v54 * v116 + v48 * dhgen_abs_##number(-v13) + v56 * v118 + (v36 * v122 + v37 * \
            v123), v128 = DHGEN_QUOTIENT(near1, w3), v129 = v63 * v128, v130 = v64 * v128, \
        v131 = v65 * v128, v132 = v67 * v128, v133 = DHGEN_QUOTIENT(v132 * v132, w3), \
        v134 = v133 + (v133 + v66 * dhgen_abs_##number(v128)), v136 = near_m7 * v49, \
        v137 = near_m7 * v50, v146 = v106 * v138 + v112 * dhgen_abs_##number(v18), \
        v148 = dhgen_abs_##number(w3), \
        v149 = v134 + dhgen_sqrt_##number(v129 * v129 + v130 * v130 + v131 * v131), \
        v156 = v12 * v49 - Z2_3 * v119 - T34 * v113, v157 = v12 * v50 - Z2_3 * v120 - T34 * v114, \
        v158 = v13 * free_joints[1] - T34 * v115 - Z2_3 * v121, \
        v159 = v54 * v122 + v48 * dhgen_abs_##number(v12) + v56 * v123 + (v36 * v116 + v37 * \
            v118), v161 = near_m6 * v49, v162 = near_m6 * v50, \
        v171 = v106 * v163 + v112 * dhgen_abs_##number(v11)
#define SIGNED_TWICE(number, signs) \
    /* theta2 */ \
    const dhgen_##number v9 = near_m4 * (e3 * T34); \
    /* theta4 */ \
    const dhgen_##number v15 = e3 * v11, v16 = factor2 * v15, c23 = v14 + w3 * v16, \
        v20 = e3 * v18, v21 = factor2 * v20, s23 = v19 - w3 * v21, \
        c4 = s23 * T33 + e1 * (c23 * v24), v27 = v26 + c4 * c4; \
    /* theta6 */ \
    const dhgen_##number v34 = e1 * (c4 * v32 + Y4 * (s23 * T31 + e1 * (c23 * v33))); \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v139 = e3 * v136, v140 = e3 * v137, v141 = e3 * v135, v142 = v141 * v141, \
        v143 = factor2 * v139 - v20 * v107, v144 = factor2 * v140 - v20 * v108, \
        v145 = factor2 * v141 - v20 * v109, \
        v147 = v146 + v117 * (v138 + dhgen_sqrt_##number(v142 + (v139 * v139 + v140 * v140))), \
        v150 = v124 - (w3 * v143 + v21 * v129), v151 = v125 - (w3 * v144 + v21 * v130), \
        v152 = v126 - (w3 * v145 + v21 * v131), \
        v153 = v127 + (v147 * v148 + v134 * dhgen_abs_##number(v21) + v149 * (v147 + \
            dhgen_sqrt_##number(v143 * v143 + v144 * v144 + v145 * v145))), v164 = e3 * v161, \
        v165 = e3 * v162, v166 = e3 * v160, v167 = v166 * v166, \
        v168 = factor2 * v164 + v15 * v107, v169 = factor2 * v165 + v15 * v108, \
        v170 = factor2 * v166 - v15 * v109, \
        v172 = v171 + v117 * (v163 + dhgen_sqrt_##number(v167 + (v164 * v164 + v165 * v165))), \
        v173 = v156 + (v16 * v129 - w3 * v168), v174 = v157 + (v16 * v130 - w3 * v169), \
        v175 = v158 + (w3 * v170 + v16 * v131), \
        v176 = v159 + (v148 * v172 + v134 * dhgen_abs_##number(v16) + v149 * (v172 + \
            dhgen_sqrt_##number(v168 * v168 + v169 * v169 + v170 * v170))), \
        v193 = e1 * (c23 * v187), v194 = s23 * v71 - e1 * (c23 * v185), \
        v195 = e1 * (c23 * v186) - s23 * v79, v196 = T33 * v150 + e1 * (c23 * v188 + v24 * v173), \
        v197 = T33 * v151 + e1 * (c23 * v189 + v24 * v174), v198 = T33 * v152 + e1 * (v24 * v175), \
        v199 = v72 * dhgen_abs_##number(s23) + v153 * v154 + v155 * (v153 + \
            dhgen_sqrt_##number(v150 * v150 + v151 * v151 + v152 * v152)) + (v190 * \
            dhgen_abs_##number(c23) + v176 * v191 + v192 * (v176 + dhgen_sqrt_##number(v173 * v173 \
            + v174 * v174 + v175 * v175))) + (dhgen_sqrt_##number(v194 * v194 + v195 * v195 + v193 \
            * v193) + dhgen_sqrt_##number(v196 * v196 + v197 * v197 + v198 * v198))

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_ENTRIES(dhgen_wide);
    dhgen_wide_mask left = (dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL) == 0;
    KNOWN(wide);

    /* theta1 */
    const dhgen_wide angle1 = dhgen_atan2_wide(T24, T14),
        v3 = dhgen_signed_wide(DHGEN_HALF_TURN, T24);
    left |= (v1 <= near_m1) | (dhgen_abs_wide(v1) <= v44);

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* theta3 */
        const dhgen_wide angle2 = dhgen_atan2_wide(w3, N3 - near_k3);

        /* joint values */
        const dhgen_wide q1_p = angle1 + v3 * (near_m2 * (e1 - 1.0)) + (w3 - w3);
        left |= (dhgen_abs_wide(v67 + (D3_squared + D3_squared)) <= v67) | (dhgen_abs_wide(N3) <=
            v68) | (dhgen_abs_wide(D3_squared) <= near_m3);

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            SIGNED_TWICE(wide, double);

            /* theta3 */
            const dhgen_wide q3_ = e3 * angle2 - near_turn1;

            /* theta2 */
            const dhgen_wide angle3 = dhgen_atan2_wide(v7 - w3 * (near_m4 * (e3 * Z2_3)), v8 + w3 *
                v9);

            /* theta4 */
            const dhgen_wide angle4 = dhgen_atan2_wide(v28, c4);

            /* theta5 */
            const dhgen_wide angle5 = dhgen_atan2_wide(dhgen_sqrt_wide(v27), c23 * T33 - e1 * (s23 *
                v24));

            /* theta6 */
            const dhgen_wide angle6 = dhgen_atan2_wide(v34, e1 * (c4 * v30 + Y4 * (s23 * T32 + e1 *
                (c23 * v31))));

            /* joint values */
            const dhgen_wide q3_p = dhgen_lowered_wide(q3_);
            const int row = 4 * i1 + 2 * i2;
            q[6 * row] = q1_p; q[6 * row + 1] = angle3; q[6 * row + 2] = q3_p;
            q[6 * row + 3] = angle4; q[6 * row + 4] = angle5; q[6 * row + 5] = angle6;
            kind[row] = dhgen_kind_wide(q[6 * row]);
            q[6 * row + 6] = q1_p; q[6 * row + 7] = angle3; q[6 * row + 8] = q3_p;
            q[6 * row + 9] = angle4 - v29; q[6 * row + 10] = -angle5;
            q[6 * row + 11] = angle6 - dhgen_signed_wide(DHGEN_HALF_TURN, v34);
            kind[row + 1] = dhgen_kind_wide(q[6 * row + 6]);
            left |= (v27 <= near_m10) | (dhgen_abs_wide(v27) <= v200 + v199 * v199);
        }
    }
    return left;
}

#if DHGEN_LANES > 1
/* One regular pose, two signs in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e3 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);
    KNOWN(double);
    SIGNED(four, four);
    SIGNED_TWICE(four, four);

    /* theta1 */
    const double v3 = copysign(DHGEN_HALF_TURN, T24);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) |
        ((dhgen_abs_four(v67 + (D3_squared + D3_squared)) <= v67) | (dhgen_abs_four(N3) <= v68) |
        (dhgen_abs_four(D3_squared) <= near_m3)) | ((v27 <= near_m10) | (dhgen_abs_four(v27) <= v200
        + v199 * v199))) | (unsigned)((v1 <= near_m1) | (fabs(v1) <= v44)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(w3, dhgen_all_four(T24), 0,
        5, 2, 3), dhgen_shuffle(N3 - near_k3, dhgen_all_four(T14), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(v7 - w3 * (near_m4 * (e3 * Z2_3)), v8 + w3 * v9),
        ratio3 = dhgen_ratio_four(v28, c4),
        ratio4 = dhgen_ratio_four(v34, e1 * (c4 * v30 + Y4 * (s23 * T32 + e1 * (c23 * v31)))),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v27), c23 * T33 - e1 * (s23 * v24));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle2 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle6 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5);
    const dhgen_four q3_ = e3 * angle2 - near_turn1, q4_m = angle4 - v29,
        q6_m = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, v34), q3_p = dhgen_lowered_four(q3_),
        q1_p = angle1 + v3 * (near_m2 * (e1 - 1.0)) + (w3 - w3);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle3, q3_p, angle4);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle5, angle6);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle3, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle5, q6_m);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~none1);
}
#endif
#define DHGEN_REGULAR_ROWS 8
#include "dhgen/one_pose.h"

/* Its links, and its angles as factors of joint values and what is added. */
DHGEN_TABLE double nearest_links[7][12] = {
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
    { 1.0, -0.0, 0.0, -0.024977, 0.0, 6.123233995736766e-17, -1.0, -0.0, 0.0, 1.0,
        6.123233995736766e-17, 0.0 },
    { -1.0, -1.9000002796713848e-09, 0.0, -0.45511099999999993, 1.9000002796713848e-09, -1.0, 0.0,
        8.647110272815235e-10, 0.0, 0.0, 1.0, 0.0 },
    { -1.0, 1.1634146304393186e-25, -1.9000002796713848e-09, 0.025039000000000033,
        -1.9000002796713848e-09, -6.123233995736766e-17, 1.0, 4.757410700269187e-11, 0.0, 1.0,
        6.123233995736766e-17, 0.0 },
    { -1.0, 7.960204103208153e-26, -1.2999999850978024e-09, -0.0, -1.2999999850978024e-09,
        -6.123233995736766e-17, 1.0, -0.0, 0.0, 1.0, 6.123233995736766e-17, 0.42008600000000007 },
    { 1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0, 6.123233995736766e-17,
        0.0 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
};
DHGEN_TABLE double nearest_angles[6][7] = {
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -2.6e-05 },
    { 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.5708893267948965 },
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.5706923267948965 },
    { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.000167 },
    { 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 3.141423653589793 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.1e-05 },
};
DHGEN_TABLE dhgen_nearest_arm nearest_arm = {
    8, 0, /* rows; values that the caller gives */
    0.0002205921, 0.000348204, /* the two arms' tools differ by no more */
    { -0.9999999999999449, -3.321999999999817e-07, 0.0, -0.0, 3.321999999999817e-07,
        -0.9999999999999449, 0.0, -0.0, 0.0, 0.0, 1.0, -0.400051 },
    { 1.0, -0.0, 0.0, -5.2e-05, 0.0, 0.9999999979520001, -6.3999999996928e-05,
        5.759779999723332e-06, 0.0, 6.3999999996928e-05, 0.9999999979520001, -0.08999499981568386 },
    { 0.0, 3.141592651689793, -3.141592651689793, 3.1415926548897932, 0.0, 0.0 },
    { 0, 1, 2, 3, 4, 5 },
    nearest_links, nearest_angles[0],
};
#endif

#ifndef KUKA_KR6_R900_CALIBRATED_PLAIN
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status);
#endif

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    (void)free_joints; (void)moved;
#ifndef KUKA_KR6_R900_CALIBRATED_PLAIN
    if (dhgen_solve_from_nearest(&general, &descents, &nearest_arm, solve_regular, T, NULL, rows,
        status))
        return;
#endif
    dhgen_general_rows(&general, &descents, T, NULL, seed, rows, status);
#ifndef KUKA_KR6_R900_CALIBRATED_PLAIN
    dhgen_to_nearest_rows(&nearest_arm, solve_wide, NULL, rows, status);
#endif
}

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.7064, 0.7064, 0.7064, 1.0, 1.0, 1.0 }, 0.7063788125913435, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, kuka_kr6_r900_calibrated_fk,
    kuka_kr6_r900_calibrated_jacobian, solve,
#ifdef KUKA_KR6_R900_CALIBRATED_PLAIN
    NULL,
#else
    solve_certain,
#endif
};

#ifndef KUKA_KR6_R900_CALIBRATED_PLAIN
/* Poses all of whose solutions lie next to the nearest arm's rows. Returns how many rows are OK, or
 * -1 if the pose has to be left to `solve`. */
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_near_rows(&arm, &general, &descents, &nearest_arm, solve_regular, T, free_joints,
        q, status);
}
#endif

#define DHGEN_NAME(function) kuka_kr6_r900_calibrated_##function
#include "dhgen/functions.h"
