/* puma560_calibrated: PUMA 560 with calibration noise of 1e-3
 *
 * Inverse kinematics, generated from robots/puma560_calibrated.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma560_calibrated.yaml. The formulas and where they come from:
 * puma560_calibrated.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 4de49b258340e29c
 * SPDX-License-Identifier: MIT
 */
#include "puma560_calibrated.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PUMA560_CALIBRATED_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PUMA560_CALIBRATED_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef PUMA560_CALIBRATED_LANES
#define DHGEN_GENERAL_LANES PUMA560_CALIBRATED_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"
#include "dhgen/general/near.h"
#ifndef PUMA560_CALIBRATED_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.6712591624431, /* joint offset 1 [m] */
    a1 = 0.0026544606897, /* link length 1 [m] */
    ca1 = 0.0016085442592340678, /* cosine of twist 1 */
    sa1 = 0.9999987062918462, /* sine of twist 1 */
    d2 = -0.000143425944, /* joint offset 2 [m] */
    a2 = 0.4314454936115, /* link length 2 [m] */
    ca2 = 0.9999994314394958, /* cosine of twist 2 */
    sa2 = 0.001066358610003491, /* sine of twist 2 */
    d3 = 0.1490653237899, /* joint offset 3 [m] */
    a3 = 0.0201858398555, /* link length 3 [m] */
    ca3 = 0.0017412729567630927, /* cosine of twist 3 */
    sa3 = 0.9999984839830959, /* sine of twist 3 */
    d4 = 0.432695688237, /* joint offset 4 [m] */
    a4 = -0.001863305965, /* link length 4 [m] */
    ca4 = 0.001238887228280428, /* cosine of twist 4 */
    sa4 = 0.9999992325789233, /* sine of twist 4 */
    d5 = -0.00062817974, /* joint offset 5 [m] */
    a5 = -6.29954602e-05, /* link length 5 [m] */
    ca5 = 0.0007308690395286796, /* cosine of twist 5 */
    sa5 = 0.9999997329151878, /* sine of twist 5 */
    d6 = -0.0012011655652, /* joint offset 6 [m] */
    a6 = -9.3840846e-05, /* link length 6 [m] */
    ca6 = 0.9999988042061223, /* cosine of twist 6 */
    sa6 = 0.0015464754525777457, /* sine of twist 6 */
    offset1 = 0.0004277699642, /* offset of joint 1 [rad] */
    offset2 = 0.0006617156617, /* offset of joint 2 [rad] */
    offset3 = -0.0018179220006, /* offset of joint 3 [rad] */
    offset4 = 8.90468712e-05, /* offset of joint 4 [rad] */
    offset5 = 0.0009695294734, /* offset of joint 5 [rad] */
    offset6 = -0.0022050175347, /* offset of joint 6 [rad] */
    f1 = -2.3070697884642687e-07, /* d2 * ca1 [m] */
    f2 = 1.7152850204059354e-06, /* sa2 * ca1 */
    f3 = 0.0016085433446793326; /* ca2 * ca1 */

#ifndef __CUDACC_RTC__
const char *const puma560_calibrated_branches[16] = {
#ifdef PUMA560_CALIBRATED_PLAIN
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
#else
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip", "further1", "further2", "further3",
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
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.005748047346394125, 0.0014848100854468322,
        0.00061867086893618, -0.9999987062918463, -0.10776509798954229, 0.9230757288847813,
        0.38461488703532554, 0.001608544259234068, 1.4537379415938628e-09 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.934264777131646, 0.8823524395054374,
        0.4705879677362333, -0.001066358610003491, -0.0002301637995154427, 0.0009409046558854332,
        0.000501815816472231, 0.9999994314394958, 0.10776495868305999 },
    { 0.28, -0.96, 0.0, 0.04371101205844448, 0.001671622038492569, 0.00048755642789366597,
        0.9999984839830959, 0.4683915670885376, -0.959998544623772, -0.2799995755152669,
        0.0017412729567630927, 0.10776514306515093 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, -0.004034857607497308, 0.000897125234272034,
        0.0008544049850209848, -0.9999992325789233, 0.000970397312505304, 0.724137375315772,
        0.6896546431578782, 0.001238887228280428, 0.46857850599669737 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, -0.00013641222461592016, 0.0006913626049595618,
        0.0002370386074147069, 0.9999997329151878, 2.8495176635072937e-07, -0.9459456932981507,
        -0.32432423770222313, 0.0007308690395286796, -0.0003898806422463197 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.6713392129385739 },
    { 1.0, 0.0, 0.0, 9.3840846e-05, 0.0, 0.9999988042061223, -0.0015464754525777457,
        -1.8577765638974755e-06, 0.0, 0.0015464754525777457, 0.9999988042061223,
        0.0012012957200730212 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.46180216162714816, 2.1654294481353777, /* the length that is one in the loop, and its inverse
        */
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
    0.5843514598369508, 0.5843514598369508, 0.5843514598369508, 0.5843514598369508,
    0.5843514598369508, 0.5843514598369508,
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
    0.0004277699642, 0.0006617156617, -0.0018179220006, 8.90468712e-05, 0.0009695294734,
    -0.0022050175347,
};

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 1.7112988821471, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, facing, zero, 0, 0,
    puma560_calibrated_fk, puma560_calibrated_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0004277699642, 0.6712591624431, 0.0026544606897, 1.569187781842 },
    { 0.0006617156617, -0.000143425944, 0.4314454936115, 0.0010663588121 },
    { -0.0018179220006, 0.1490653237899, 0.0201858398555, -1.5690550529582 },
    { 8.90468712e-05, 0.432695688237, -0.001863305965, 1.5695574392497 },
    { 0.0009695294734, -0.00062817974, -6.29954602e-05, -1.5700654576903 },
    { -0.0022050175347, -0.0012011655652, -9.3840846e-05, -0.001546476069 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void puma560_calibrated_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v3 = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + y1_y * s2,
        x2_z = sa1 * s2, v5 = v2 * c2 + c1 * s2, v6 = y1_y * c2 - s1 * s2, v7 = sa1 * c2,
        y2_x = z1_x * sa2 - v5 * ca2, y2_y = v6 * ca2 - v3 * sa2, y2_z = v7 * ca2 + f2,
        z2_x = v5 * sa2 + z1_x * ca2, v8 = v6 * sa2 + v3 * ca2, z2_z = f3 - v7 * sa2,
        v9 = q[2] + offset3;
    const double c3 = cos(v9), s3 = sin(v9), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, v10 = y2_x * c3 - x2_x * s3,
        v11 = y2_y * c3 - x2_y * s3, v12 = y2_z * c3 - x2_z * s3, y3_x = v10 * ca3 - z2_x * sa3,
        y3_y = v11 * ca3 + v8 * sa3, y3_z = v12 * ca3 - z2_z * sa3, z3_x = v10 * sa3 + z2_x * ca3,
        z3_y = v11 * sa3 - v8 * ca3, z3_z = v12 * sa3 + z2_z * ca3, v13 = q[3] + offset4;
    const double c4 = cos(v13), s4 = sin(v13), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v14 = y3_x * c4 - x3_x * s4,
        v15 = y3_y * c4 - x3_y * s4, v16 = y3_z * c4 - x3_z * s4, y4_x = v14 * ca4 + z3_x * sa4,
        y4_y = v15 * ca4 + z3_y * sa4, y4_z = v16 * ca4 + z3_z * sa4, z4_x = z3_x * ca4 - v14 * sa4,
        z4_y = z3_y * ca4 - v15 * sa4, z4_z = z3_z * ca4 - v16 * sa4, v17 = q[4] + offset5;
    const double c5 = cos(v17), s5 = sin(v17), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v18 = y4_x * c5 - x4_x * s5,
        v19 = y4_y * c5 - x4_y * s5, v20 = y4_z * c5 - x4_z * s5, y5_x = v18 * ca5 - z4_x * sa5,
        y5_y = v19 * ca5 - z4_y * sa5, y5_z = v20 * ca5 - z4_z * sa5, z5_x = v18 * sa5 + z4_x * ca5,
        z5_y = v19 * sa5 + z4_y * ca5, z5_z = v20 * sa5 + z4_z * ca5, v21 = q[5] + offset6;
    const double c6 = cos(v21), s6 = sin(v21), x6_x = x5_x * c6 + y5_x * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 + y5_z * s6, v22 = y5_x * c6 - x5_x * s6,
        v23 = y5_y * c6 - x5_y * s6, v24 = y5_z * c6 - x5_z * s6;
    T[0] = x6_x; T[1] = v22 * ca6 - z5_x * sa6; T[2] = v22 * sa6 + z5_x * ca6;
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x *
        a5 + z4_x * d5 + x6_x * a6 + z5_x * d6;
    T[4] = x6_y; T[5] = v23 * ca6 - z5_y * sa6; T[6] = v23 * sa6 + z5_y * ca6;
    T[7] = s1 * a1 + x2_y * a2 - v3 * d2 + x3_y * a3 - v8 * d3 + x4_y * a4 + z3_y * d4 + x5_y * a5 +
        z4_y * d5 + x6_y * a6 + z5_y * d6;
    T[8] = x6_z; T[9] = v24 * ca6 - z5_z * sa6; T[10] = v24 * sa6 + z5_z * ca6;
    T[11] = d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z *
        d5 + x6_z * a6 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void puma560_calibrated_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), p1_x = c1 * a1, p1_y = s1 * a1, v2 = s1 * ca1,
        y1_y = c1 * ca1, z1_x = s1 * sa1, v3 = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + y1_y * s2,
        x2_z = sa1 * s2, v5 = v2 * c2 + c1 * s2, v6 = y1_y * c2 - s1 * s2, v7 = sa1 * c2,
        p2_x = p1_x + x2_x * a2 + z1_x * d2, p2_y = p1_y + x2_y * a2 - v3 * d2,
        p2_z = d1 + x2_z * a2 + f1, y2_x = z1_x * sa2 - v5 * ca2, y2_y = v6 * ca2 - v3 * sa2,
        y2_z = v7 * ca2 + f2, z2_x = v5 * sa2 + z1_x * ca2, v8 = v6 * sa2 + v3 * ca2,
        z2_z = f3 - v7 * sa2, v9 = q[2] + offset3;
    const double c3 = cos(v9), s3 = sin(v9), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, v10 = y2_x * c3 - x2_x * s3,
        v11 = y2_y * c3 - x2_y * s3, v12 = y2_z * c3 - x2_z * s3,
        p3_x = p2_x + x3_x * a3 + z2_x * d3, p3_y = p2_y + x3_y * a3 - v8 * d3,
        p3_z = p2_z + x3_z * a3 + z2_z * d3, y3_x = v10 * ca3 - z2_x * sa3,
        y3_y = v11 * ca3 + v8 * sa3, y3_z = v12 * ca3 - z2_z * sa3, z3_x = v10 * sa3 + z2_x * ca3,
        z3_y = v11 * sa3 - v8 * ca3, z3_z = v12 * sa3 + z2_z * ca3, v13 = q[3] + offset4;
    const double c4 = cos(v13), s4 = sin(v13), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v14 = y3_x * c4 - x3_x * s4,
        v15 = y3_y * c4 - x3_y * s4, v16 = y3_z * c4 - x3_z * s4,
        p4_x = p3_x + x4_x * a4 + z3_x * d4, p4_y = p3_y + x4_y * a4 + z3_y * d4,
        p4_z = p3_z + x4_z * a4 + z3_z * d4, y4_x = v14 * ca4 + z3_x * sa4,
        y4_y = v15 * ca4 + z3_y * sa4, y4_z = v16 * ca4 + z3_z * sa4, z4_x = z3_x * ca4 - v14 * sa4,
        z4_y = z3_y * ca4 - v15 * sa4, z4_z = z3_z * ca4 - v16 * sa4, v17 = q[4] + offset5;
    const double c5 = cos(v17), s5 = sin(v17), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v18 = y4_x * c5 - x4_x * s5,
        v19 = y4_y * c5 - x4_y * s5, v20 = y4_z * c5 - x4_z * s5,
        p5_x = p4_x + x5_x * a5 + z4_x * d5, p5_y = p4_y + x5_y * a5 + z4_y * d5,
        p5_z = p4_z + x5_z * a5 + z4_z * d5, z5_x = v18 * sa5 + z4_x * ca5,
        z5_y = v19 * sa5 + z4_y * ca5, z5_z = v20 * sa5 + z4_z * ca5, v21 = q[5] + offset6;
    const double c6 = cos(v21), s6 = sin(v21),
        p6_x = p5_x + (x5_x * c6 + (v18 * ca5 - z4_x * sa5) * s6) * a6 + z5_x * d6,
        p6_y = p5_y + (x5_y * c6 + (v19 * ca5 - z4_y * sa5) * s6) * a6 + z5_y * d6,
        p6_z = p5_z + (x5_z * c6 + (v20 * ca5 - z4_z * sa5) * s6) * a6 + z5_z * d6,
        v22 = p6_x - p1_x, v23 = p6_y - p1_y, v24 = p6_z - d1, v25 = p6_x - p2_x, v26 = p6_y - p2_y,
        v27 = p6_z - p2_z, v28 = p6_x - p3_x, v29 = p6_y - p3_y, v30 = p6_z - p3_z,
        v31 = p6_x - p4_x, v32 = p6_y - p4_y, v33 = p6_z - p4_z, v34 = p6_x - p5_x,
        v35 = p6_y - p5_y, v36 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(v3 * v24 + ca1 * v23); J[2] = -(v8 * v27 + z2_z * v26);
    J[3] = z3_y * v30 - z3_z * v29; J[4] = z4_y * v33 - z4_z * v32; J[5] = z5_y * v36 - z5_z * v35;
    J[6] = p6_x; J[7] = ca1 * v22 - z1_x * v24; J[8] = z2_z * v25 - z2_x * v27;
    J[9] = z3_z * v28 - z3_x * v30; J[10] = z4_z * v31 - z4_x * v33;
    J[11] = z5_z * v34 - z5_x * v36;
    J[12] = 0.0; J[13] = z1_x * v23 + v3 * v22; J[14] = z2_x * v26 + v8 * v25;
    J[15] = z3_x * v29 - z3_y * v28; J[16] = z4_x * v32 - z4_y * v31;
    J[17] = z5_x * v35 - z5_y * v34;
    J[18] = 0.0; J[19] = z1_x; J[20] = z2_x; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -v3; J[26] = -v8; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = ca1; J[32] = z2_z; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
}

#ifndef PUMA560_CALIBRATED_PLAIN
/* The nearest arm with a structure: what follows is its closed form. A pose at which one of its
 * branches may end by what the two arms differ is left to the general algorithm. */
/* In formulas below, near_arm_size1 = 1.0332489194603163 [m], near_a2 = 0.4314454936115 [m],
 * near_a3 = -0.020185839855499987 [m], near_d4 = 0.4326956882369999 [m],
 * near_k5 = 2 * near_d4 * near_a2 = 0.3733692095899602 [m^2],
 * near_k6 = 2 * near_a3 * near_a2 = -0.01741817928083776 [m^2],
 * near_k3 = 3.0774677988139795e-15 [m^2], near_longest3_apart = 0.7475535203061898 [m^2],
 * near_k8 = 1 / ((2 * near_d4 * near_a2)^2 + (2 * near_a3 * near_a2)^2) = 7.157788307709011 [m^-4],
 * near_doubt_limit = 9.999999999999999e-05. */
static const double
    near_d3 = 0.14892189775631642, /* joint offset 3 [m] */
    near_longest3 = 0.7475535203062076, /* square of the longest reach [m^2] */
    near_shortest3 = 2.961108259928867e-06, /* square of the shortest reach [m^2] */
    near_k1 = 0.022177731631342762, /* near_d3^2 [m^2] */
    near_k4 = 0.9678209975988334, /* 1 / near_arm_size1 [m^-1] */
    near_k7 = 0.37377824070723376, /* near_a2^2 + (near_a3^2 + near_d4^2) [m^2] */
    near_turn1 = -1.6174138820106556, /* atan2(-near_k5, near_k6) [rad] */
    near_m1 = 3.0774677988139795e-12, /* 1000 * near_k3 [m^2] */
    /* 1000 * (near_longest3 - near_longest3_apart) * (near_longest3_apart - near_shortest3)
     * [m^4] */
    near_m2 = 1.3279165486287245e-11,
    near_m3 = 0.12467563999795989, /* -near_k6 * near_k8 [m^-2] */
    near_m4 = 0.9989215120964166, /* near_k5 * near_k7 * near_k8 */
    near_m5 = 2.6724977628615725, /* near_k5 * near_k8 [m^-2] */
    near_m6 = 0.04660104137748587, /* -near_k6 * near_k7 * near_k8 */
    near_m7 = 1.1588949413161114, /* near_k8 * (near_d4 * near_k5 + near_a3 * near_k6) [m^-1] */
    /* near_d4 * near_k5 * near_k7 * near_k8 + near_a3 * near_k6 * near_k7 * near_k8 - near_a2
     * [m] */
    near_m8 = 0.0017242187181490598,
    near_m9 = 9.999999999999999e-09, /* near_doubt_limit^2 */
    near1 = 0.5; /* 1 / 2 */

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    /* theta1 */ \
    const dhgen_##number N1 = T14 * T14 + T24 * T24, D1_squared = N1 - near_k1, \
        w1 = dhgen_sqrt_##number(D1_squared), v1 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1), \
        v2 = near_d3 * T24, v3 = inverse1 * v2, v6 = near_d3 * T14, v7 = inverse1 * v6; \
    /* theta3 */ \
    const dhgen_##number N3 = D1_squared + T34 * T34, v10 = near_longest3 - N3, \
        v11 = N3 - near_shortest3, D3_squared = v10 * v11, w3 = dhgen_sqrt_##number(D3_squared), \
        v12 = w3 - w3, v13 = near_m5 * N3 - near_m4, v15 = near_m6 - near_m3 * N3; \
    /* theta2 */ \
    const dhgen_##number X1_2 = near_m7 * N3 - near_m8, v17 = T34 * X1_2, \
        factor2 = DHGEN_QUOTIENT(1.0, N3); \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v33 = T14 * free_joints[1], v34 = dhgen_abs_##number(free_joints[1]), \
        v35 = v33 + v33, v36 = v34 * v34, v37 = T24 * free_joints[1], v38 = v37 + v37, \
        v39 = v36 + v36, v40 = v35 * v35 + v38 * v38, v41 = v39 + dhgen_sqrt_##number(v40), \
        v42 = T34 * free_joints[1], v43 = v42 + v42, v44 = v36 + v39, \
        v45 = v44 + dhgen_sqrt_##number(v40 + v43 * v43), v46 = v10 * v35 - v11 * v35, \
        v47 = v10 * v38 - v11 * v38, v48 = v10 * v43 - v11 * v43, \
        v49 = v44 * dhgen_abs_##number(v10) + v44 * dhgen_abs_##number(v11) + v45 * v45, \
        v50 = v49 + dhgen_sqrt_##number(v46 * v46 + v47 * v47 + v48 * v48), \
        v51 = dhgen_abs_##number(N3), v52 = dhgen_abs_##number(inverse1), \
        v53 = inverse1 * (inverse1 * v35), v54 = inverse1 * (inverse1 * v38), \
        v55 = v52 * (v39 * v52), v56 = dhgen_sqrt_##number(N1) - dhgen_sqrt_##number(v39), \
        v57 = v55 + (v55 + (dhgen_abs_##number(v53) + dhgen_abs_##number(v54))) * \
            DHGEN_QUOTIENT(v41, v56 * v56), v58 = near_d3 * free_joints[1], v59 = inverse1 * v58, \
        v60 = v6 * v54, v61 = v57 + dhgen_sqrt_##number(v53 * v53 + v54 * v54), \
        v62 = v59 - v6 * v53, v63 = v61 * dhgen_abs_##number(v58), \
        v64 = v63 + v57 * dhgen_abs_##number(v6), v65 = DHGEN_QUOTIENT(near1, w1), \
        v66 = v35 * v65, v67 = v38 * v65, v68 = v41 * v65, v69 = DHGEN_QUOTIENT(v68 * v68, w1), \
        v70 = v69 + (v69 + v39 * dhgen_abs_##number(v65)), v74 = v34 * v61, \
        v75 = v74 + v57 * dhgen_abs_##number(T24), v76 = dhgen_abs_##number(w1), v77 = v75 * v76, \
        v78 = v70 + dhgen_sqrt_##number(v66 * v66 + v67 * v67), v82 = T33 * free_joints[0], \
        v83 = T23 * free_joints[0], v84 = near1 * (free_joints[0] * free_joints[0]), \
        v87 = dhgen_abs_##number(T13), v89 = v82 * v82, v90 = v83 * v83, \
        v91 = v84 + dhgen_sqrt_##number(v89 + v90), v94 = v74 + v57 * dhgen_abs_##number(T14), \
        v95 = v76 * v94, v96 = v2 * v53, v97 = v63 + v57 * dhgen_abs_##number(v2), \
        v99 = v2 * v54 - v59, v102 = T13 * free_joints[0], v105 = dhgen_abs_##number(T23), \
        v107 = v102 * v102, v108 = v84 + dhgen_sqrt_##number(v89 + v107), \
        v114 = dhgen_abs_##number(factor2), v115 = factor2 * (factor2 * v35), \
        v116 = factor2 * (factor2 * v38), v117 = factor2 * (factor2 * v43), \
        v118 = v114 * (v44 * v114), \
        v119 = v118 + (v118 + (dhgen_abs_##number(v117) + (dhgen_abs_##number(v115) + \
            dhgen_abs_##number(v116)))) * DHGEN_QUOTIENT(v45, v51 - v45), v120 = near_m3 * v35, \
        v121 = near_m3 * v38, v122 = near_m3 * v43, v123 = DHGEN_QUOTIENT(near1, w3), \
        v124 = v46 * v123, v125 = v47 * v123, v126 = v48 * v123, v127 = v50 * v123, \
        v128 = DHGEN_QUOTIENT(v127 * v127, w3), \
        v129 = v128 + (v128 + v49 * dhgen_abs_##number(v123)), \
        v130 = v129 + dhgen_sqrt_##number(v124 * v124 + v125 * v125 + v126 * v126), \
        v134 = near_m3 * v44 + near_m5 * v129, v136 = dhgen_abs_##number(w3), \
        v141 = near_m7 * v35, v142 = near_m7 * v38, v143 = near_m7 * v43, v144 = near_m7 * v44, \
        v151 = v76 * v144 + v70 * dhgen_abs_##number(X1_2), v161 = near_m5 * v35, \
        v162 = near_m5 * v38, v163 = near_m5 * v43, v167 = near_m5 * v44 + near_m3 * v129, \
        v168 = T34 * v141, v169 = T34 * v142, v170 = T34 * v143 + X1_2 * free_joints[1], \
        v171 = v144 * dhgen_abs_##number(T34) + v34 * (v144 + dhgen_sqrt_##number(v141 * v141 + \
            v142 * v142 + v143 * v143)), v199 = dhgen_abs_##number(T33), \
        v200 = v84 + dhgen_sqrt_##number(v90 + v107), \
        v210 = v119 + dhgen_sqrt_##number(v115 * v115 + v116 * v116 + v117 * v117)
#define SIGNED(number, signs) \
    /* theta1 */ \
    const dhgen_##number v4 = e1 * T14, v5 = inverse1 * v4, c1 = w1 * v5 - v3, v8 = e1 * T24, \
        v9 = inverse1 * v8, s1 = v7 + w1 * v9; \
    /* theta2 */ \
    const dhgen_##number v22 = e1 * X1_2, v23 = w1 * v22; \
    /* theta4 */ \
    const dhgen_##number v24 = c1 * T13 + s1 * T23, Y4 = s1 * T13 - c1 * T23, v25 = Y4 * Y4, \
        v28 = dhgen_signed_##number(DHGEN_HALF_TURN, Y4); \
    /* theta6 */ \
    const dhgen_##number v29 = c1 * T22 - s1 * T12, v30 = c1 * T12 + s1 * T22, \
        v31 = c1 * T21 - s1 * T11, v32 = c1 * T11 + s1 * T21; \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v71 = inverse1 * (e1 * free_joints[1]), v72 = v8 * v53, \
        v73 = v71 - v8 * v54, v79 = v62 + (v9 * v66 - w1 * v72), v80 = w1 * v73 + v9 * v67 - v60, \
        v81 = v64 + (v77 + v70 * dhgen_abs_##number(v9) + v78 * (v75 + dhgen_sqrt_##number(v72 * \
            v72 + v73 * v73))), v85 = s1 * v82, v86 = v84 * dhgen_abs_##number(s1), \
        v88 = v81 + dhgen_sqrt_##number(v79 * v79 + v80 * v80), v92 = v4 * v54, \
        v93 = v71 - v4 * v53, v98 = v96 + (w1 * v93 + v5 * v66), \
        v100 = v99 + (v5 * v67 - w1 * v92), \
        v101 = v97 + (v95 + v70 * dhgen_abs_##number(v5) + v78 * (v94 + dhgen_sqrt_##number(v93 * \
            v93 + v92 * v92))), v103 = c1 * v82, v104 = v84 * dhgen_abs_##number(c1), \
        v106 = v101 + dhgen_sqrt_##number(v98 * v98 + v100 * v100), v109 = s1 * v83 + c1 * v102, \
        v110 = T13 * v79 - T23 * v98, v111 = T13 * v80 - T23 * v100, \
        v112 = v103 * v103 + v85 * v85, \
        v113 = v86 + v81 * v87 + v88 * v91 + (v104 + v101 * v105 + v106 * v108) + \
            (dhgen_sqrt_##number(v112 + v109 * v109) + dhgen_sqrt_##number(v110 * v110 + v111 * \
            v111)), v145 = e1 * v141, v146 = e1 * v142, v147 = e1 * v143, v148 = w1 * v147, \
        v149 = w1 * v145 + v22 * v66, v150 = w1 * v146 + v22 * v67, \
        v152 = v151 + v78 * (v144 + dhgen_sqrt_##number(v145 * v145 + v146 * v146 + v147 * v147)), \
        v188 = s1 * v102 - c1 * v83, v189 = T13 * v98 + T23 * v79, v190 = T13 * v100 + T23 * v80, \
        v191 = v104 + v87 * v101 + v91 * v106 + (v86 + v81 * v105 + v88 * v108), \
        v193 = dhgen_abs_##number(v24), \
        v194 = v191 + (dhgen_sqrt_##number(v112 + v188 * v188) + dhgen_sqrt_##number(v189 * v189 + \
            v190 * v190)), v215 = v113 * v113
#define SIGNED_TWICE(number, signs) \
    /* theta3 */ \
    const dhgen_##signs v14 = near_m3 * e3; \
    const dhgen_##number s3 = v13 - w3 * v14; \
    const dhgen_##signs v16 = near_m5 * e3; \
    const dhgen_##number c3 = v15 - w3 * v16; \
    /* theta2 */ \
    const dhgen_##signs v18 = e1 * e3; \
    const dhgen_##number v19 = near_m7 * (w1 * v18), S2 = v17 - w3 * v19, \
        v20 = near_m7 * (e3 * T34), v21 = w3 * v20, C2 = v21 + v23; \
    /* theta4 */ \
    const dhgen_##number c23 = c3 * C2 - s3 * S2, s23 = c3 * S2 + s3 * C2, \
        c4 = c23 * v24 + s23 * T33, v26 = factor2 * c4, v27 = v25 + factor2 * (c4 * v26); \
    /* theta6 */ \
    const dhgen_##number s6 = c4 * v31 + Y4 * (c23 * v32 + s23 * T31); \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v131 = v120 + v16 * v124, v132 = v121 + v16 * v125, \
        v133 = v122 + v16 * v126, v135 = near_m7 * (e3 * free_joints[1]), v137 = v20 * v124, \
        v138 = v20 * v125, v139 = w3 * v135 + v20 * v126, \
        v140 = v129 * dhgen_abs_##number(v20) + v130 * dhgen_abs_##number(v135), \
        v153 = v137 + v149, v154 = v138 + v150, v155 = v139 + v148, v156 = v140 + v152, \
        v157 = dhgen_abs_##number(c3), v158 = dhgen_abs_##number(C2), \
        v159 = v134 + dhgen_sqrt_##number(v131 * v131 + v132 * v132 + v133 * v133), \
        v160 = v156 + dhgen_sqrt_##number(v153 * v153 + v154 * v154 + v155 * v155), \
        v164 = v161 - v14 * v124, v165 = v162 - v14 * v125, v166 = v163 - v14 * v126, \
        v172 = near_m7 * (v18 * v66), v173 = near_m7 * (v18 * v67), \
        v176 = v168 - (w3 * v172 + v19 * v124), v177 = v169 - (w3 * v173 + v19 * v125), \
        v178 = v170 - v19 * v126, v180 = dhgen_abs_##number(s3), v181 = dhgen_abs_##number(S2), \
        v182 = v167 + dhgen_sqrt_##number(v164 * v164 + v165 * v165 + v166 * v166), \
        v184 = c3 * v153 - C2 * v131 - (s3 * v176 + S2 * v164), \
        v185 = c3 * v154 - C2 * v132 - (s3 * v177 + S2 * v165), \
        v186 = c3 * v155 - C2 * v133 - (s3 * v178 + S2 * v166), v192 = c23 * v188, \
        v195 = c3 * v176 - S2 * v131 + (s3 * v153 + C2 * v164), \
        v196 = c3 * v177 - S2 * v132 + (s3 * v154 + C2 * v165), \
        v197 = c3 * v178 - S2 * v133 + (s3 * v155 + C2 * v166), v201 = s23 * v83 - c23 * v85, \
        v202 = c23 * v103 - s23 * v102, v203 = c23 * v189 + v24 * v184 + T33 * v195, \
        v204 = c23 * v190 + v24 * v185 + T33 * v196, v205 = v24 * v186 + T33 * v197, \
        v207 = factor2 * v201, v208 = factor2 * v202, v209 = factor2 * v192, \
        v211 = factor2 * v203 - c4 * v115, v212 = factor2 * v204 - c4 * v116, \
        v213 = factor2 * v205 - c4 * v117

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_ENTRIES(dhgen_wide);
    dhgen_wide_mask left = (dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL) == 0;
    KNOWN(wide);

    /* theta3 */
    const dhgen_wide angle1 = dhgen_atan2_wide(w3, N3 - near_k7);
    left |= (dhgen_abs_wide(v50 + (D3_squared + D3_squared)) <= v50) | (dhgen_abs_wide(v41 +
        (D1_squared + D1_squared)) <= v41) | (dhgen_abs_wide(N1) <= v39) | (v51 <= v45) |
        (dhgen_abs_wide(D3_squared * (near_k4 * w1)) <= near_m2) | (dhgen_abs_wide(D1_squared) <=
        near_m1);

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* joint values */
        const dhgen_wide angle6 = dhgen_atan2_wide(s1, c1), q1_p = v12 + angle6;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            SIGNED_TWICE(wide, double);

            /* theta3 */
            const dhgen_wide q3_ = e3 * angle1 - near_turn1;

            /* theta2 */
            const dhgen_wide angle2 = dhgen_atan2_wide(S2, C2);

            /* theta4 */
            const dhgen_wide angle3 = dhgen_atan2_wide(Y4, v26);

            /* theta5 */
            const dhgen_wide angle4 = dhgen_atan2_wide(dhgen_sqrt_wide(v27), factor2 * (c23 * T33 -
                s23 * v24));

            /* theta6 */
            const dhgen_wide angle5 = dhgen_atan2_wide(s6, c4 * v29 + Y4 * (c23 * v30 + s23 * T32));

            /* joint values */
            const dhgen_wide q3_p = v1 + dhgen_lowered_wide(q3_);

            /* by how much these differ at poses so near: slopes and rests */
            const dhgen_wide v174 = near_m7 * (v70 * fabs(e3)), v175 = v136 * v174,
                v179 = v171 + (v175 + v129 * dhgen_abs_wide(v19) + v130 * (v174 +
                    dhgen_sqrt_wide(v172 * v172 + v173 * v173))),
                v183 = v179 + dhgen_sqrt_wide(v176 * v176 + v177 * v177 + v178 * v178),
                v187 = v156 * v157 + v134 * v158 + v159 * v160 + (v179 * v180 + v167 * v181 + v182 *
                    v183),
                v198 = v157 * v179 + v134 * v181 + v159 * v183 + (v156 * v180 + v158 * v167 + v160 *
                    v182),
                v206 = v191 * dhgen_abs_wide(c23) + v187 * v193 + v194 * (v187 +
                    dhgen_sqrt_wide(v184 * v184 + v185 * v185 + v186 * v186)) + (v84 *
                    dhgen_abs_wide(s23) + v198 * v199 + v200 * (v198 + dhgen_sqrt_wide(v195 * v195 +
                    v196 * v196 + v197 * v197))),
                v214 = v114 * v206 + v119 * dhgen_abs_wide(c4) + v210 * (v206 +
                    (dhgen_sqrt_wide(v201 * v201 + v202 * v202 + v192 * v192) + dhgen_sqrt_wide(v203
                    * v203 + v204 * v204 + v205 * v205))) + (dhgen_sqrt_wide(v207 * v207 + v208 *
                    v208 + v209 * v209) + dhgen_sqrt_wide(v211 * v211 + v212 * v212 + v213 * v213));
            const int row = 4 * i1 + 2 * i2;
            q[6 * row] = q1_p; q[6 * row + 1] = angle2; q[6 * row + 2] = q3_p;
            q[6 * row + 3] = angle3; q[6 * row + 4] = angle4; q[6 * row + 5] = angle5;
            kind[row] = dhgen_kind_wide(q[6 * row]);
            q[6 * row + 6] = q1_p; q[6 * row + 7] = angle2; q[6 * row + 8] = q3_p;
            q[6 * row + 9] = angle3 - v28; q[6 * row + 10] = -angle4;
            q[6 * row + 11] = angle5 - dhgen_signed_wide(DHGEN_HALF_TURN, s6);
            kind[row + 1] = dhgen_kind_wide(q[6 * row + 6]);
            left |= (v27 <= near_m9) | (dhgen_abs_wide(v27) <= v215 + v214 * v214);
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

    /* by how much these differ at poses so near: slopes and rests */
    const dhgen_four v174 = near_m7 * (v70 * dhgen_abs_four(e3)), v175 = v136 * v174,
        v179 = v171 + (v175 + v129 * dhgen_abs_four(v19) + v130 * (v174 + dhgen_sqrt_four(v172 *
            v172 + v173 * v173))),
        v183 = v179 + dhgen_sqrt_four(v176 * v176 + v177 * v177 + v178 * v178),
        v187 = v156 * v157 + v134 * v158 + v159 * v160 + (v179 * v180 + v167 * v181 + v182 * v183),
        v198 = v157 * v179 + v134 * v181 + v159 * v183 + (v156 * v180 + v158 * v167 + v160 * v182),
        v206 = v191 * dhgen_abs_four(c23) + v187 * v193 + v194 * (v187 + dhgen_sqrt_four(v184 * v184
            + v185 * v185 + v186 * v186)) + (v84 * dhgen_abs_four(s23) + v198 * v199 + v200 * (v198
            + dhgen_sqrt_four(v195 * v195 + v196 * v196 + v197 * v197))),
        v214 = v114 * v206 + v119 * dhgen_abs_four(c4) + v210 * (v206 + (dhgen_sqrt_four(v201 * v201
            + v202 * v202 + v192 * v192) + dhgen_sqrt_four(v203 * v203 + v204 * v204 + v205 *
            v205))) + (dhgen_sqrt_four(v207 * v207 + v208 * v208 + v209 * v209) +
            dhgen_sqrt_four(v211 * v211 + v212 * v212 + v213 * v213));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v27 <= near_m9)
        | (dhgen_abs_four(v27) <= v215 + v214 * v214))) | (unsigned)((fabs(v50 + (D3_squared +
        D3_squared)) <= v50) | (fabs(v41 + (D1_squared + D1_squared)) <= v41) | (fabs(N1) <= v39) |
        (v51 <= v45) | (fabs(D3_squared * (near_k4 * w1)) <= near_m2) | (fabs(D1_squared) <=
        near_m1)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, dhgen_all_four(w3), 0, 5,
        2, 3), dhgen_shuffle(c1, dhgen_all_four(N3 - near_k7), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(S2, C2), ratio3 = dhgen_ratio_four(Y4, v26),
        ratio4 = dhgen_ratio_four(s6, c4 * v29 + Y4 * (c23 * v30 + s23 * T32)),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v27), factor2 * (c23 * T33 - s23 * v24));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle6 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_angle_four(ratio3), angle5 = dhgen_angle_four(ratio4),
        angle4 = dhgen_angle_four(ratio5);
    const dhgen_four q3_ = e3 * angle1 - near_turn1, q4_m = angle3 - v28,
        q6_m = angle5 - dhgen_signed_four(DHGEN_HALF_TURN, s6), q1_p = v12 + angle6,
        q3_p = v1 + dhgen_lowered_four(q3_);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle2, q3_p, angle3);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle4, angle5);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle2, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle4, q6_m);
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
    { 1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0, 6.123233995736766e-17,
        0.0 },
    { 0.9999999999999372, 3.5450000001824165e-07, -0.0, 0.4314454936114729, -3.5450000001824165e-07,
        0.9999999999999372, -0.0, -1.5294742749314702e-07, 0.0, 0.0, 1.0, 0.0 },
    { -0.9999999999999372, 2.1706864523706184e-23, -3.545000001440309e-07, 0.020185839855498718,
        -3.545000001440309e-07, -6.123233995736381e-17, 0.9999999999999372, 7.15588023168213e-09,
        0.0, 1.0, 6.123233995736766e-17, 0.14892189775631642 },
    { -0.9999999999999127, -2.558287163739808e-23, 4.1780000005242117e-07, -0.0,
        4.1780000005242117e-07, -6.123233995736231e-17, 0.9999999999999127, 0.0, 0.0, 1.0,
        6.123233995736766e-17, 0.4326956882369999 },
    { -1.0, 1.8369696008327342e-26, -2.9999990235743137e-10, -0.0, -2.9999990235743137e-10,
        -6.123233995736766e-17, 1.0, -0.0, 0.0, 1.0, 6.123233995736766e-17, 0.0 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
};
DHGEN_TABLE double nearest_angles[6][7] = {
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0004277699642 },
    { 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0006617156617 },
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -0.0018179220006 },
    { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 8.90468712e-05 },
    { 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0009695294734 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, -0.0022050175347 },
};
DHGEN_TABLE dhgen_nearest_arm nearest_arm = {
    8, 0, /* rows; values that the caller gives */
    0.0063859344, 0.0076985885, /* the two arms' tools differ by no more */
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.6712591624 },
    { -1.0, 0.0, 0.0, 9.38408e-05, -0.0, -0.999998804206049, -0.0015464755000093547,
        -1.8575731718540364e-06, 0.0, -0.0015464755000093547, 0.999998804206049,
        0.0012011641636534413 },
    { 0.0, -3.5450000001824906e-07, -3.141592299089793, 3.141592235789793, 3.141592653889793, 0.0 },
    { 0, 1, 2, 3, 4, 5 },
    nearest_links, nearest_angles[0],
};
#endif

#ifndef PUMA560_CALIBRATED_PLAIN
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status);
#endif

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    (void)free_joints; (void)moved;
#ifndef PUMA560_CALIBRATED_PLAIN
    if (dhgen_solve_from_nearest(&general, &descents, &nearest_arm, solve_regular, T, NULL, rows,
        status))
        return;
#endif
    dhgen_general_rows(&general, &descents, T, NULL, seed, rows, status);
#ifndef PUMA560_CALIBRATED_PLAIN
    dhgen_to_nearest_rows(&nearest_arm, solve_wide, NULL, rows, status);
#endif
}

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.5844, 0.5844, 0.5844, 1.0, 1.0, 1.0 }, 0.5843514598369508, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, puma560_calibrated_fk,
    puma560_calibrated_jacobian, solve,
#ifdef PUMA560_CALIBRATED_PLAIN
    NULL,
#else
    solve_certain,
#endif
};

#ifndef PUMA560_CALIBRATED_PLAIN
/* Poses all of whose solutions lie next to the nearest arm's rows. Returns how many rows are OK, or
 * -1 if the pose has to be left to `solve`. */
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_near_rows(&arm, &general, &descents, &nearest_arm, solve_regular, T, free_joints,
        q, status);
}
#endif

#define DHGEN_NAME(function) puma560_calibrated_##function
#include "dhgen/functions.h"
