/* general_4r2p: General arm with four revolute joints and two slides
 *
 * Inverse kinematics, generated from robots/general_4r2p.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_4r2p.yaml. The formulas and where they come from:
 * general_4r2p.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 008cfb16c5fc4c47
 * SPDX-License-Identifier: MIT
 */
#include "general_4r2p.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#define DHGEN_TRAITS 0x494u /* what the arm needs of it */
#ifdef GENERAL_4R2P_LANES
#define DHGEN_GENERAL_LANES GENERAL_4R2P_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = 0.31, /* joint offset 1 [m] */
    a1 = 0.12, /* link length 1 [m] */
    ca1 = 0.3623577544766736, /* cosine of twist 1 */
    sa1 = 0.9320390859672263, /* sine of twist 1 */
    d2 = -0.14, /* joint offset 2 [m] */
    a2 = 0.27, /* link length 2 [m] */
    ca2 = 0.6967067093471654, /* cosine of twist 2 */
    sa2 = 0.7173560908995228, /* sine of twist 2 */
    cat3 = 0.9210609940028851, /* cosine of the angle of joint 3 */
    sat3 = 0.3894183423086505, /* sine of the angle of joint 3 */
    a3 = 0.09, /* link length 3 [m] */
    ca3 = 0.32328956686350346, /* cosine of twist 3 */
    sa3 = 0.9463000876874145, /* sine of twist 3 */
    d4 = 0.22, /* joint offset 4 [m] */
    a4 = -0.18, /* link length 4 [m] */
    ca4 = 0.7648421872844885, /* cosine of twist 4 */
    sa4 = 0.644217687237691, /* sine of twist 4 */
    cat5 = 0.6216099682706644, /* cosine of the angle of joint 5 */
    sat5 = 0.7833269096274834, /* sine of the angle of joint 5 */
    a5 = 0.15, /* link length 5 [m] */
    ca5 = 0.4535961214255773, /* cosine of twist 5 */
    sa5 = 0.8912073600614354, /* sine of twist 5 */
    d6 = 0.17, /* joint offset 6 [m] */
    a6 = 0.08, /* link length 6 [m] */
    ca6 = 0.8253356149096783, /* cosine of twist 6 */
    sa6 = 0.5646424733950354, /* sine of twist 6 */
    f1 = -0.05073008562673431, /* d2 * ca1 [m] */
    f2 = 0.2599395422585156, /* sa2 * ca1 */
    f3 = 0.2524570787278714; /* ca2 * ca1 */

#ifndef __CUDACC_RTC__
const char *const general_4r2p_branches[8] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.6, 0.6, 1.73e-09, 0.33412409368839596, 1.73, 0.0375, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.5, 0.5, 1.73e-09, 0.33412409368839596, 1.73, 0.03125, 0 },
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
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.2653189862537723, 0.33448408105539107,
        0.13936836710641293, -0.9320390859672263, 0.14673636817971505, 0.8603437716620551,
        0.35847657152585627, 0.3623577544766736, 6.28359350727957e-10 },
    { 0.9210609940028851, -0.3894183423086505, 0.0, 0.5969677190709878, 0.2713103718292879,
        0.6417093742397794, 0.7173560908995228, 0.015793558142548212, -0.2793516197631058,
        -0.6607287141379384, 0.6967067093471654, -0.136764030406117 },
    { 0.28, -0.96, 0.0, 0.19898923969032925, -0.3103579841889633, -0.09052107872178097,
        -0.9463000876874145, -0.18129993832765687, 0.9084480841799178, 0.2649640245524761,
        -0.32328956686350346, -0.08395481242875238 },
    { 0.6216099682706644, 0.7833269096274834, 0.0, -0.3979784793806585, -0.5991214669182833,
        0.47543352776997644, -0.644217687237691, 0.08096418764476625, -0.5046330500712651,
        0.4004521361232219, 0.7648421872844885, 0.19870586267497078 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.3316487328172154, 0.4290774121593299,
        0.14711225559748453, 0.8912073600614354, -0.050805229179742194, -0.8430339892473038,
        -0.28904022488478986, 0.4535961214255773, 0.0998200647953078 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.28419795539003395 },
    { 1.0, 0.0, 0.0, -0.08, 0.0, 0.8253356149096783, 0.5646424733950354, -0.11054770303682969, 0.0,
        -0.5646424733950354, 0.8253356149096783, -0.16158712948772755 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    8, /* solutions at most */
    0.4522857624867539, 2.2109915521147694, /* the length that is one in the loop, and its inverse
        */
    HUGE_VAL, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, formulations,
    { { 0.6, 0.38461538461538464, 1.0, 0.28, 1.0, 0.32432432432432434 }, /* cosines and sines of
        what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.0, 0.96, 0.0, 0.9459459459459459 } },
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
DHGEN_TABLE int turning[6] = { 1, 1, 0, 1, 0, 1 };
DHGEN_TABLE double unit[6] = { 1.0, 1.0, 1.7299999999999998, 1.0, 1.7299999999999998, 1.0 };
DHGEN_TABLE double measure[6] = {
    0.5780346820809249, 0.5780346820809249, 1.0, 0.5780346820809249, 1.0, 0.5780346820809249,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -0.34682080924855496, -3.141592653589793,
    -0.28901734104046245, -3.141592653589793,
};
DHGEN_TABLE double span_width[6] = {
    6.283185307179586, 6.283185307179586, 0.6936416184971099, 6.283185307179586, 0.5780346820809249,
    6.283185307179586,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
DHGEN_TABLE double least_u[6] = {
    -HUGE_VAL, -HUGE_VAL, -0.34682080924855496, -HUGE_VAL, -0.28901734104046245, -HUGE_VAL,
};
DHGEN_TABLE double most_u[6] = {
    HUGE_VAL, HUGE_VAL, 0.34682080924855496, HUGE_VAL, 0.28901734104046245, HUGE_VAL,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 8, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.7299999999999998, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    general_4r2p_fk, general_4r2p_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.31, 0.12, 1.2 },
    { 0.0, -0.14, 0.27, -0.8 },
    { 0.4, 0.0, 0.09, 1.9 },
    { 0.0, 0.22, -0.18, 0.7 },
    { -0.9, 0.0, 0.15, -1.1 },
    { 0.0, 0.17, 0.08, 0.6 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void general_4r2p_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = sa1 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = sa1 * c2, v6 = v3 * ca2 + z1_x * sa2,
        y2_y = v4 * ca2 + v2 * sa2, y2_z = v5 * ca2 - f2, z2_x = z1_x * ca2 - v3 * sa2,
        z2_y = v4 * sa2 - v2 * ca2, z2_z = v5 * sa2 + f3, x3_x = x2_x * cat3 - v6 * sat3,
        x3_y = x2_y * cat3 + y2_y * sat3, x3_z = x2_z * cat3 + y2_z * sat3,
        v7 = x2_x * sat3 + v6 * cat3, v8 = y2_y * cat3 - x2_y * sat3,
        v9 = y2_z * cat3 - x2_z * sat3, y3_x = v7 * ca3 + z2_x * sa3, y3_y = z2_y * sa3 - v8 * ca3,
        y3_z = z2_z * sa3 - v9 * ca3, z3_x = v7 * sa3 - z2_x * ca3, v10 = v8 * sa3 + z2_y * ca3,
        v11 = v9 * sa3 + z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v12 = y3_x * c4 - x3_x * s4,
        v13 = y3_y * c4 - x3_y * s4, v14 = y3_z * c4 - x3_z * s4, y4_x = v12 * ca4 + z3_x * sa4,
        y4_y = v13 * ca4 - v10 * sa4, y4_z = v14 * ca4 - v11 * sa4, z4_x = z3_x * ca4 - v12 * sa4,
        v15 = v13 * sa4 + v10 * ca4, v16 = v14 * sa4 + v11 * ca4, x5_x = x4_x * cat5 - y4_x * sat5,
        x5_y = x4_y * cat5 - y4_y * sat5, x5_z = x4_z * cat5 - y4_z * sat5,
        v17 = x4_x * sat5 + y4_x * cat5, v18 = x4_y * sat5 + y4_y * cat5,
        v19 = x4_z * sat5 + y4_z * cat5, y5_x = v17 * ca5 - z4_x * sa5,
        y5_y = v18 * ca5 + v15 * sa5, y5_z = v19 * ca5 + v16 * sa5, z5_x = v17 * sa5 + z4_x * ca5,
        z5_y = v18 * sa5 - v15 * ca5, z5_z = v19 * sa5 - v16 * ca5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 + y5_x * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 + y5_z * s6, v20 = y5_x * c6 - x5_x * s6,
        v21 = y5_y * c6 - x5_y * s6, v22 = y5_z * c6 - x5_z * s6;
    T[0] = x6_x; T[1] = v20 * ca6 + z5_x * sa6; T[2] = z5_x * ca6 - v20 * sa6;
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3 + x4_x * a4 + z3_x * d4 + z4_x
        * q[4] + x5_x * a5 + x6_x * a6 + z5_x * d6;
    T[4] = x6_y; T[5] = v21 * ca6 + z5_y * sa6; T[6] = z5_y * ca6 - v21 * sa6;
    T[7] = s1 * a1 + x2_y * a2 - v2 * d2 + z2_y * q[2] + x3_y * a3 + x4_y * a4 - v10 * d4 - v15 *
        q[4] + x5_y * a5 + x6_y * a6 + z5_y * d6;
    T[8] = x6_z; T[9] = v22 * ca6 + z5_z * sa6; T[10] = z5_z * ca6 - v22 * sa6;
    T[11] = d1 + x2_z * a2 + f1 + z2_z * q[2] + x3_z * a3 + x4_z * a4 - v11 * d4 - v16 * q[4] + x5_z
        * a5 + x6_z * a6 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void general_4r2p_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1, v1 = s1 * ca1,
        y1_y = c1 * ca1, z1_x = s1 * sa1, v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = sa1 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = sa1 * c2, v6 = v3 * ca2 + z1_x * sa2,
        y2_y = v4 * ca2 + v2 * sa2, y2_z = v5 * ca2 - f2, z2_x = z1_x * ca2 - v3 * sa2,
        z2_y = v4 * sa2 - v2 * ca2, z2_z = v5 * sa2 + f3, x3_x = x2_x * cat3 - v6 * sat3,
        x3_y = x2_y * cat3 + y2_y * sat3, x3_z = x2_z * cat3 + y2_z * sat3,
        v7 = x2_x * sat3 + v6 * cat3, v8 = y2_y * cat3 - x2_y * sat3,
        v9 = y2_z * cat3 - x2_z * sat3,
        p3_x = p1_x + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3,
        p3_y = p1_y + x2_y * a2 - v2 * d2 + z2_y * q[2] + x3_y * a3,
        p3_z = d1 + x2_z * a2 + f1 + z2_z * q[2] + x3_z * a3, y3_x = v7 * ca3 + z2_x * sa3,
        y3_y = z2_y * sa3 - v8 * ca3, y3_z = z2_z * sa3 - v9 * ca3, z3_x = v7 * sa3 - z2_x * ca3,
        v10 = v8 * sa3 + z2_y * ca3, v11 = v9 * sa3 + z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v12 = y3_x * c4 - x3_x * s4,
        v13 = y3_y * c4 - x3_y * s4, v14 = y3_z * c4 - x3_z * s4, y4_x = v12 * ca4 + z3_x * sa4,
        y4_y = v13 * ca4 - v10 * sa4, y4_z = v14 * ca4 - v11 * sa4, z4_x = z3_x * ca4 - v12 * sa4,
        v15 = v13 * sa4 + v10 * ca4, v16 = v14 * sa4 + v11 * ca4, x5_x = x4_x * cat5 - y4_x * sat5,
        x5_y = x4_y * cat5 - y4_y * sat5, x5_z = x4_z * cat5 - y4_z * sat5,
        v17 = x4_x * sat5 + y4_x * cat5, v18 = x4_y * sat5 + y4_y * cat5,
        v19 = x4_z * sat5 + y4_z * cat5,
        p5_x = p3_x + x4_x * a4 + z3_x * d4 + z4_x * q[4] + x5_x * a5,
        p5_y = p3_y + x4_y * a4 - v10 * d4 - v15 * q[4] + x5_y * a5,
        p5_z = p3_z + x4_z * a4 - v11 * d4 - v16 * q[4] + x5_z * a5, z5_x = v17 * sa5 + z4_x * ca5,
        z5_y = v18 * sa5 - v15 * ca5, z5_z = v19 * sa5 - v16 * ca5;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        p6_x = p5_x + (x5_x * c6 + (v17 * ca5 - z4_x * sa5) * s6) * a6 + z5_x * d6,
        p6_y = p5_y + (x5_y * c6 + (v18 * ca5 + v15 * sa5) * s6) * a6 + z5_y * d6,
        p6_z = p5_z + (x5_z * c6 + (v19 * ca5 + v16 * sa5) * s6) * a6 + z5_z * d6,
        v20 = p6_x - p1_x, v21 = p6_y - p1_y, v22 = p6_z - d1, v23 = p6_x - p3_x, v24 = p6_y - p3_y,
        v25 = p6_z - p3_z, v26 = p6_x - p5_x, v27 = p6_y - p5_y, v28 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(v2 * v22 + ca1 * v21); J[2] = z2_x; J[3] = v11 * v24 - v10 * v25;
    J[4] = z4_x; J[5] = z5_y * v28 - z5_z * v27;
    J[6] = p6_x; J[7] = ca1 * v20 - z1_x * v22; J[8] = z2_y; J[9] = -(v11 * v23 + z3_x * v25);
    J[10] = -v15; J[11] = z5_z * v26 - z5_x * v28;
    J[12] = 0.0; J[13] = z1_x * v21 + v2 * v20; J[14] = z2_z; J[15] = z3_x * v24 + v10 * v23;
    J[16] = -v16; J[17] = z5_x * v27 - z5_y * v26;
    J[18] = 0.0; J[19] = z1_x; J[20] = 0.0; J[21] = z3_x; J[22] = 0.0; J[23] = z5_x;
    J[24] = 0.0; J[25] = -v2; J[26] = 0.0; J[27] = -v10; J[28] = 0.0; J[29] = z5_y;
    J[30] = 1.0; J[31] = ca1; J[32] = 0.0; J[33] = -v11; J[34] = 0.0; J[35] = z5_z;
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
    { 0.578, 0.578, 0.578, 1.0, 1.0, 1.0 }, 0.5780346820809249, { 1e-14, 1e-10 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, general_4r2p_fk, general_4r2p_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) general_4r2p_##function
#include "dhgen/functions.h"
