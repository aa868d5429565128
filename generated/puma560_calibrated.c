/* puma560_calibrated: PUMA 560 with calibration noise of 1e-3
 *
 * Inverse kinematics, generated from robots/puma560_calibrated.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma560_calibrated.yaml. The formulas and where they come from:
 * puma560_calibrated.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: d20772f900d97103
 * SPDX-License-Identifier: MIT
 */
#include "puma560_calibrated.h"

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

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
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

const char *const puma560_calibrated_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const struct dhgen_joint joints[6] = {
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
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.5843514598369508, 0.5843514598369508, 0.5843514598369508, 0.5843514598369508,
    0.5843514598369508, 0.5843514598369508,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
/* How the loop counts the joints: which way, and from where. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = {
    0.0004277699642, 0.0006617156617, -0.0018179220006, 8.90468712e-05, 0.0009695294734,
    -0.0022050175347,
};

static const struct dhgen_numerical_arm descents = {
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
static const double table[6][4] = {
    { 0.0004277699642, 0.6712591624431, 0.0026544606897, 1.569187781842 },
    { 0.0006617156617, -0.000143425944, 0.4314454936115, 0.0010663588121 },
    { -0.0018179220006, 0.1490653237899, 0.0201858398555, -1.5690550529582 },
    { 8.90468712e-05, 0.432695688237, -0.001863305965, 1.5695574392497 },
    { 0.0009695294734, -0.00062817974, -6.29954602e-05, -1.5700654576903 },
    { -0.0022050175347, -0.0012011655652, -9.3840846e-05, -0.001546476069 },
};

void puma560_calibrated_frames(const double q[6], double frames[8][16])
{
    static const struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL,
        NULL };
    dhgen_frames(&links, q, frames);
}

void puma560_calibrated_fk(const double q[6], double T[16])
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
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma560_calibrated_jacobian(const double q[6], double J[36])
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

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints;
    (void)moved;
    double (*const nearby)[6] = NULL; /* no nearest arm is tried first */
    const int nearby_count = 0;

    /* all joints: the general 6R loop */
    double solution_roots[16][6];
    int solution_found[16], solution_chosen[16];
    dhgen_general_rows(&general, &descents, T, NULL, seed, nearby, nearby_count, solution_roots[0],
        solution_found, solution_chosen);

    for (int i1 = 0; i1 < 16; i1++) { /* root1 to root16 */
        const double q1 = solution_roots[i1][0];
        const double q2 = solution_roots[i1][1];
        const double q3 = solution_roots[i1][2];
        const double q4 = solution_roots[i1][3];
        const double q5 = solution_roots[i1][4];
        const double q6 = solution_roots[i1][5];
        const int found = solution_found[i1];
        const int chosen = solution_chosen[i1];
        /* all joints: the general 6R loop */
        if (!found) continue; /* out of reach */
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        q[row][5] = q6;
        status[row] = chosen ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

static const int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
static const struct dhgen_arm arm = {
    6, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.5844, 0.5844, 0.5844, 1.0, 1.0, 1.0 }, 0.5843514598369508, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* winds */
    0, /* follows seed */
    NULL, NULL,
    NULL, NULL,
    puma560_calibrated_fk, puma560_calibrated_jacobian, solve,
    NULL,
};

void puma560_calibrated_joint_velocities(const double q[6], const double twist[6], double
    velocities[6])
{
    dhgen_joint_velocities(&arm, q, twist, velocities);
}

int puma560_calibrated_ik(
    const double T[16], const double *q_seed, double q[16][6], unsigned char status[16])
{
    return dhgen_careful_ik(&arm, T, NULL, q_seed, &q[0][0], status);
}

int puma560_calibrated_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    return dhgen_ik_nearest(&arm, T, NULL, q_seed, q);
}

void puma560_calibrated_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_ik_each(&arm, 0, n, T, NULL, q, status);
}
