/* kinova_gen3_7: Kinova Gen3 with 7 joints
 *
 * Inverse kinematics, generated from robots/kinova_gen3_7.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kinova_gen3_7.yaml. The formulas and where they come from:
 * kinova_gen3_7.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 75d679c0087310f8
 * SPDX-License-Identifier: MIT
 */
#include "kinova_gen3_7.h"

#define DHGEN_DOF 7
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef KINOVA_GEN3_7_LANES
#define DHGEN_GENERAL_LANES KINOVA_GEN3_7_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

static const double
    d1 = 0.28481, /* joint offset 1 [m] */
    d2 = 0.01175, /* joint offset 2 [m] */
    d3 = 0.42076, /* joint offset 3 [m] */
    d4 = 0.01275, /* joint offset 4 [m] */
    d5 = 0.31436, /* joint offset 5 [m] */
    d6 = 0.00035, /* joint offset 6 [m] */
    d7 = 0.10593, /* joint offset 7 [m] */
    offset2 = 3.141592653589793, /* offset of joint 2 [rad] */
    offset3 = 3.141592653589793, /* offset of joint 3 [rad] */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    offset6 = 3.141592653589793, /* offset of joint 6 [rad] */
    offset7 = 3.141592653589793; /* offset of joint 7 [rad] */

const char *const kinova_gen3_7_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const struct dhgen_joint joints[7] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.24, 2.24, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 0.0, 0.09817477042468103, 1 },
    { -2.57, 2.57, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.09, 2.09, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[4] = {
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
    { { 0, 5, 4, 3, 2, 1 }, -1.0, 0 },
    { { 4, 3, 2, 1, 0, 5 }, -1.0, 0 },
    { { 1, 2, 3, 4, 5, 0 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[8][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.01584673608061403,
        0.9230769230769231, 0.38461538461538464, 0.0, -1.9205566660481306e-10 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.015846736084575715 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.0, 0.0, 0.0, -1.0, 0.017195394470453523,
        0.8823529411764706, 0.47058823529411764, 0.0, -1.1349230083595947 },
    { 0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.4239642514299426, 0.96, 0.28, 0.0,
        -0.01719539447475237 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0004720304364438222,
        0.7241379310344828, 0.6896551724137931, 0.0, -0.4239642515359337 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9459459459459459,
        0.32432432432432434, 0.0, -0.0004720304365618298 },
    { 0.6, -0.8, 0.0, -0.0, -0.8, -0.6, 0.0, -0.0, 0.0, 0.0, -1.0, 0.2848099999287975 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, 0.10593 },
};

/* The joints whose values are given, and where they are in the links. */
DHGEN_TABLE dhgen_given_joint given[1] = {
    { 0, 1.0, 3.141592653589793 },
};

DHGEN_TABLE dhgen_given_motion motions[1] = {
    { 0, 1.0 },
};

/* Their values at which formulations vanish. */
DHGEN_TABLE dhgen_special_value special[2] = {
    { 0, 1, 1.0, 1e-12, 0x3 },
    { 0, 1, -1.0, 1e-12, 0x3 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.3707388051002349, 2.6973167800161484, /* the length that is one in the loop, and its inverse
        */
    4.062224539232323, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    4, formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 1 }, { 3, 1, 0 }, { 4, 1, 0 }, { 5, 1, 0 }, { 6, 1, 0 }, { 7, 1, 0 } },
        /* links */
    constants,
    motions,
    1, 2,
    given, special, 0,
};


/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
static const int solved[6] = { 0, 1, 3, 4, 5, 6 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.8690286866369458, 0.8690286866369458, 0.8690286866369458, 0.8690286866369458,
    0.8690286866369458, 0.8690286866369458,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[6] = {
    -3.141592653589793, -2.24, -2.57, -3.141592653589793, -2.09, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 4.48, 5.14, 6.283185307179586, 4.18, 6.283185307179586,
};
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
static const double least_u[6] = { -HUGE_VAL, -2.24, -2.57, -HUGE_VAL, -2.09, -HUGE_VAL };
static const double most_u[6] = { HUGE_VAL, 2.24, 2.57, HUGE_VAL, 2.09, HUGE_VAL };
/* How the loop counts the joints: which way, and from where. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = {
    0.0, 3.141592653589793, 3.141592653589793, 3.141592653589793, 3.141592653589793,
    3.141592653589793,
};
static const int given_places[1] = { 2 };

static const struct dhgen_numerical_arm descents = {
    7, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.1507100000000001, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 1, given_places,
    kinova_gen3_7_fk, kinova_gen3_7_jacobian, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
static const double table[7][4] = {
    { 0.0, -0.28481, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.01175, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.42076, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.01275, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.31436, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.00035, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.10593, 0.0, 0.0 },
};

void kinova_gen3_7_frames(const double q[7], double frames[9][16])
{
    static const double base[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 };
    static const struct dhgen_links links = { 7, DHGEN_STANDARD, joints, &table[0][0], NULL, base,
        NULL };
    dhgen_frames(&links, q, frames);
}

void kinova_gen3_7_fk(const double q[7], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, v2 = s1 * c2, z2_x = c1 * s2,
        v3 = s1 * s2, v4 = q[2] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), x3_x = x2_x * c3 + s1 * s3, x3_y = c1 * s3 - v2 * c3,
        v5 = s2 * c3, v6 = c1 * c3 + v2 * s3, v7 = s2 * s3, z3_x = x2_x * s3 - s1 * c3,
        v8 = q[3] + offset4;
    const double c4 = cos(v8), s4 = sin(v8), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 - v3 * s4, x4_z = c2 * s4 - v5 * c4, z4_y = v3 * c4 + x3_y * s4,
        v9 = c2 * c4 + v5 * s4, z4_x = x3_x * s4 - z2_x * c4, v10 = q[4] + offset5;
    const double c5 = cos(v10), s5 = sin(v10), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 - v6 * s5, x5_z = x4_z * c5 - v7 * s5, z5_y = v6 * c5 + x4_y * s5,
        z5_z = v7 * c5 + x4_z * s5, z5_x = x4_x * s5 - z3_x * c5, v11 = q[5] + offset6;
    const double c6 = cos(v11), s6 = sin(v11), x6_x = x5_x * c6 + z4_x * s6,
        x6_y = x5_y * c6 + z4_y * s6, x6_z = x5_z * c6 - v9 * s6, z6_z = v9 * c6 + x5_z * s6,
        z6_x = x5_x * s6 - z4_x * c6, z6_y = x5_y * s6 - z4_y * c6, v12 = q[6] + offset7;
    const double c7 = cos(v12), s7 = sin(v12);
    T[0] = x6_x * c7 + z5_x * s7; T[1] = z5_x * c7 - x6_x * s7; T[2] = z6_x;
    T[3] = -(s1 * d2 + z2_x * d3 + z3_x * d4 + z4_x * d5 + z5_x * d6 + z6_x * d7);
    T[4] = x6_y * c7 + z5_y * s7; T[5] = z5_y * c7 - x6_y * s7; T[6] = z6_y;
    T[7] = v3 * d3 - c1 * d2 + v6 * d4 - z4_y * d5 - z5_y * d6 - z6_y * d7;
    T[8] = x6_z * c7 + z5_z * s7; T[9] = z5_z * c7 - x6_z * s7; T[10] = z6_z;
    T[11] = d1 - c2 * d3 + v7 * d4 + v9 * d5 - z5_z * d6 - z6_z * d7;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kinova_gen3_7_jacobian(const double q[7], double J[42])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, v2 = s1 * c2, z2_x = c1 * s2,
        v3 = s1 * s2, v4 = s1 * d2, v5 = c1 * d2, v6 = q[2] + offset3;
    const double c3 = cos(v6), s3 = sin(v6), x3_x = x2_x * c3 + s1 * s3, x3_y = c1 * s3 - v2 * c3,
        v7 = s2 * c3, v8 = c1 * c3 + v2 * s3, v9 = s2 * s3, v10 = v4 + z2_x * d3,
        p3_y = v3 * d3 - v5, p3_z = d1 - c2 * d3, z3_x = x2_x * s3 - s1 * c3, v11 = q[3] + offset4;
    const double c4 = cos(v11), s4 = sin(v11), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 - v3 * s4, x4_z = c2 * s4 - v7 * c4, z4_y = v3 * c4 + x3_y * s4,
        v12 = c2 * c4 + v7 * s4, v13 = v10 + z3_x * d4, p4_y = p3_y + v8 * d4,
        p4_z = p3_z + v9 * d4, z4_x = x3_x * s4 - z2_x * c4, v14 = q[4] + offset5;
    const double c5 = cos(v14), s5 = sin(v14), z5_y = v8 * c5 + x4_y * s5,
        z5_z = v9 * c5 + x4_z * s5, v15 = v13 + z4_x * d5, p5_y = p4_y - z4_y * d5,
        p5_z = p4_z + v12 * d5, z5_x = x4_x * s5 - z3_x * c5, v16 = q[5] + offset6;
    const double c6 = cos(v16), s6 = sin(v16), z6_z = v12 * c6 + (x4_z * c5 - v9 * s5) * s6,
        v17 = v15 + z5_x * d6, p6_y = p5_y - z5_y * d6, p6_z = p5_z - z5_z * d6,
        z6_x = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6,
        z6_y = (x4_y * c5 - v8 * s5) * s6 - z4_y * c6, J21 = v17 + z6_x * d7,
        p7_y = p6_y - z6_y * d7, p7_z = p6_z - z6_z * d7, v18 = p7_z - d1, v19 = v4 - J21,
        v20 = v5 + p7_y, v21 = v10 - J21, v22 = p7_y - p3_y, v23 = p7_z - p3_z, v24 = v13 - J21,
        v25 = p7_y - p4_y, v26 = p7_z - p4_z, v27 = v15 - J21, v28 = p7_y - p5_y, v29 = p7_z - p5_z,
        v30 = v17 - J21, v31 = p7_y - p6_y, v32 = p7_z - p6_z;
    J[0] = p7_y; J[1] = c1 * v18; J[2] = -(v3 * v18 + c2 * v20); J[3] = v9 * v22 - v8 * v23;
    J[4] = z4_y * v26 + v12 * v25; J[5] = z5_y * v29 - z5_z * v28; J[6] = z6_y * v32 - z6_z * v31;
    J[7] = J21; J[8] = -(s1 * v18); J[9] = c2 * v19 - z2_x * v18; J[10] = -(v9 * v21 + z3_x * v23);
    J[11] = -(v12 * v24 + z4_x * v26); J[12] = z5_z * v27 - z5_x * v29;
    J[13] = z6_z * v30 - z6_x * v32;
    J[14] = 0.0; J[15] = s1 * p7_y + c1 * J21; J[16] = z2_x * v20 + v3 * v19;
    J[17] = z3_x * v22 + v8 * v21; J[18] = z4_x * v25 - z4_y * v24; J[19] = z5_x * v28 - z5_y * v27;
    J[20] = z6_x * v31 - z6_y * v30;
    J[21] = 0.0; J[22] = s1; J[23] = z2_x; J[24] = z3_x; J[25] = z4_x; J[26] = z5_x; J[27] = z6_x;
    J[28] = 0.0; J[29] = c1; J[30] = -v3; J[31] = -v8; J[32] = z4_y; J[33] = z5_y; J[34] = z6_y;
    J[35] = -1.0; J[36] = 0.0; J[37] = c2; J[38] = -v9; J[39] = -v12; J[40] = z5_z; J[41] = z6_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    double (*const q)[7] = (double (*)[7])rows;
    (void)moved;
    double (*const nearby)[6] = NULL; /* no nearest arm is tried first */
    const int nearby_count = 0;

    /* all joints: the general 6R loop */
    double solution_roots[16][7];
    int solution_found[16], solution_chosen[16];
    dhgen_general_rows(&general, &descents, T, free_joints, seed, nearby, nearby_count,
        solution_roots[0], solution_found, solution_chosen);

    for (int i1 = 0; i1 < 16; i1++) { /* root1 to root16 */
        const double q1 = solution_roots[i1][0];
        const double q2 = solution_roots[i1][1];
        const double q3 = solution_roots[i1][2];
        const double q4 = solution_roots[i1][3];
        const double q5 = solution_roots[i1][4];
        const double q6 = solution_roots[i1][5];
        const double q7 = solution_roots[i1][6];
        const int found = solution_found[i1];
        const int chosen = solution_chosen[i1];
        /* all joints: the general 6R loop */
        if (!found) continue; /* out of reach */
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        q[row][5] = q6; q[row][6] = q7;
        status[row] = chosen ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

static const int given_joints[1] = { 2 };
static const int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
static const struct dhgen_arm arm = {
    7, 16, 1, DHGEN_POSE, joints, given_joints, 1,
    { 0.869, 0.869, 0.869, 1.0, 1.0, 1.0 }, 0.8690286866369458, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* winds */
    0, /* follows seed */
    NULL, NULL,
    kinova_gen3_7_fk, kinova_gen3_7_jacobian, solve,
    NULL,
};

void kinova_gen3_7_joint_velocities(const double q[7], const double twist[6], double velocities[7])
{
    dhgen_joint_velocities(&arm, q, twist, velocities);
}

int kinova_gen3_7_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[16][7],
    unsigned char status[16])
{
    return dhgen_careful_ik(&arm, T, free_joints, q_seed, &q[0][0], status);
}

int kinova_gen3_7_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    return dhgen_ik_nearest(&arm, T, free_joints, q_seed, q);
}

void kinova_gen3_7_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    dhgen_ik_each(&arm, 0, n, T, free_joints, q, status);
}
