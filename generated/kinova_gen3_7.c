/* kinova_gen3_7: Kinova Gen3 with 7 joints
 *
 * Inverse kinematics, generated from robots/kinova_gen3_7.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kinova_gen3_7.yaml. The formulas and where they come from:
 * kinova_gen3_7.md.
 */
#include "kinova_gen3_7.h"

#define DHGEN_DOF 7
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the general algorithm has to do for the arm */
#ifdef KINOVA_GEN3_7_LANES
#define DHGEN_GENERAL_LANES KINOVA_GEN3_7_LANES
#endif
#include "dhgen/general.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = KINOVA_GEN3_7_OK, NONE = KINOVA_GEN3_7_UNREACHABLE, FREE = KINOVA_GEN3_7_FREE_JOINT,
    OUT = KINOVA_GEN3_7_OUT_OF_LIMITS, INVALID = KINOVA_GEN3_7_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
#define MISFIT(name, number) \
static inline number misfit_##name(const number T[16]) \
{ \
    const number x0 = T[0], x1 = T[1], x2 = T[2]; \
    const number y0 = T[4], y1 = T[5], y2 = T[6]; \
    const number xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0; \
    const number yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0; \
    const number xy = x0 * y0 + x1 * y1 + x2 * y2; \
    const number zx = x1 * y2 - x2 * y1 - T[8]; \
    const number zy = x2 * y0 - x0 * y2 - T[9]; \
    const number zz = x0 * y1 - x1 * y0 - T[10]; \
    return xx * xx + yy * yy + 2.0 * xy * xy + zx * zx + zy * zy + zz * zz; \
}
MISFIT(one, double)

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation kinova_gen3_7_formulations[4] = {
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
    { { 0, 5, 4, 3, 2, 1 }, -1.0, 0 },
    { { 4, 3, 2, 1, 0, 5 }, -1.0, 0 },
    { { 1, 2, 3, 4, 5, 0 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double kinova_gen3_7_constants[8][12] = {
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
DHGEN_TABLE dhgen_given_joint kinova_gen3_7_given[1] = {
    { 0, 1.0, 3.141592653589793 },
};

DHGEN_TABLE dhgen_given_motion kinova_gen3_7_motions[1] = {
    { 0, 1.0 },
};

/* Their values at which formulations vanish. */
DHGEN_TABLE dhgen_special_value kinova_gen3_7_special[2] = {
    { 0, 1, 1.0, 1e-12, 0x3 },
    { 0, 1, -1.0, 1e-12, 0x3 },
};

DHGEN_TABLE dhgen_general_arm kinova_gen3_7_general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.3707388051002349, 2.6973167800161484, /* the length that is one in the loop, and its inverse
        */
    4.062224539232323, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    4, kinova_gen3_7_formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 1 }, { 3, 1, 0 }, { 4, 1, 0 }, { 5, 1, 0 }, { 6, 1, 0 }, { 7, 1, 0 } },
        /* links */
    kinova_gen3_7_constants,
    kinova_gen3_7_motions,
    1, 2,
    kinova_gen3_7_given, kinova_gen3_7_special, 0,
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
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
/* How the loop counts the joints: from where, and which way. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = {
    0.0, 3.141592653589793, 3.141592653589793, 3.141592653589793, 3.141592653589793,
    3.141592653589793,
};
static const int given_joints[1] = { 2 };

static const struct dhgen_numerical_arm kinova_gen3_7_descents = {
    7, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_WHOLE_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.1507100000000001, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero,
    1, given_joints,
    kinova_gen3_7_fk, kinova_gen3_7_jacobian, 0,
};

static void all_joints(
    const double T[16], const double free_joints[1],
    const double seed[7], double q[16][7], int found[16],
    int chosen[16])
{
    dhgen_general_rows(&kinova_gen3_7_general, &kinova_gen3_7_descents, T, free_joints, seed, q[0],
        found, chosen);
}

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

static const double lowest[7] = { -INFINITY, -2.24, -INFINITY, -2.57, -INFINITY, -2.09, -INFINITY };
static const double highest[7] = { INFINITY, 2.24, INFINITY, 2.57, INFINITY, 2.09, INFINITY };
#define slack(joint) 1e-09 /* of limits */

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

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(double T[16])
{
    double G[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[i][j] = (i == j ? 1.5 : 0.0)
                - 0.5 * (T[i] * T[j] + T[4 + i] * T[4 + j] + T[8 + i] * T[8 + j]);
    for (double *row = T; row < T + 12; row += 4) {
        const double x = row[0], y = row[1], z = row[2];
        for (int j = 0; j < 3; j++)
            row[j] = x * G[0][j] + y * G[1][j] + z * G[2][j];
    }
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose, and 2 for what was rounded. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    if (!(fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1.0) <= 1e-09))
        return 0;
    const double miss = misfit_one(T);
    if (!(miss <= 1e-09))
        return 0;
    if (miss <= 1e-24)
        return 1;
    straighten(T);
    straighten(T);
    return 2;
}

/* How far a joint value is beyond its limits, whole turns aside; negative below. */
static double overshoot(int joint, double value)
{
    const double low = lowest[joint], high = highest[joint];
    if (low <= value && value <= high)
        return 0.0;
    const double gap = turn - (high - low), over = value - high;
    const double rest = over - turn * floor(over / turn);
    const double off = rest >= gap ? 0.0 : rest <= gap - rest ? rest : rest - gap;
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of a row. */
static double beyond_limits(const double values[7])
{
    double sum = 0.0;
    for (int i = 0; i < 7; i++)
        sum += fabs(overshoot(i, values[i]));
    return sum;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double free_joints[1], const double seed[7], double q[16][7],
    unsigned char status[16])
{

    /* all joints: the general 6R loop */
    double solution_roots[16][7];
    int solution_found[16], solution_chosen[16];
    all_joints(T, free_joints, seed, solution_roots, solution_found, solution_chosen);

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
        status[row] = (chosen) ? FREE : OK;
    }
}

static void take(const double from[7], double to[7])
{
    for (int i = 0; i < 7; i++)
        to[i] = from[i];
}

/* A joint value moved by whole turns, near to another but inside its limits. */
static double turned(int joint, double given, double towards)
{
    const double low = lowest[joint] - 1e-09, high = highest[joint] + 1e-09;
    double value = given;
    if (fabs(towards) < 100000.0)
        value += turn * floor((towards - given) / turn + 0.5);
    value -= turn * ceil(fmax(value - high, 0.0) / turn);
    value += turn * ceil(fmax(low - value, 0.0) / turn);
    return value <= high ? value : given;
}

/* How far joint values are from others, whole turns aside [rad, arm sizes]; half is the middle. */
static double half_way(const double x[7], const double q[7], double half[7])
{
    double most = 0.0;
    for (int i = 0; i < 7; i++) {
        double off = q[i] - x[i];
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.869, 0.869, 0.869, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[7] = { 1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[7], double e[6])
{
    double P[16], square = 0.0;
    kinova_gen3_7_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    for (int i = 0; i < 9; i++) {
        const int j = (i / 3 + 1) % 3 * 4 + i % 3, k = (i / 3 + 2) % 3 * 4 + i % 3;
        e[3 + i / 3] += 0.5 * (P[j] * T[k] - P[k] * T[j]);
        square += 0.5 * (P[j] - T[j]) * (P[j] - T[j]);
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[7], double damping, double e[6], double x[7])
{
    double A[6][13] = { { 0.0 } }, square[6] = { 0.0 }, J[42];
    kinova_gen3_7_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 7; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[7 * i + j];
        A[i][7 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 13; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 13; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 13; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 7; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[7])
{
    double x[7], half[7], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[7] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 7 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? overshoot(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 7; i++)
                held[i] = i == worst || (held[i] && moves != 2);
            last = HUGE_VAL;
            x[worst] -= past;
            miss = off_pose(T, x, e);
        }
        if (miss < enough) {
            take(x, q);
            settled = 1;
            enough = 0.5 * miss;
        } else if (settled || (miss > fmax(0.7 * last, 100.0 * enough) && ++lost == 4)) {
            break;
        }
        last = miss;
        add_step(held, (lost == 0 && miss > 100.0 * enough ? 0.003 : 0.1 * miss) * miss, e, x);
        if (!(half_way(x, q, half) <= most))
            break; /* another solution */
    }
    return settled;
}

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const double T[16], int row, int far, double rows[16][7], const unsigned char status[16])
{
    double x[7], half[7], to[7], *q = rows[row];
    const double beyond = beyond_limits(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!settle(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 16; k++)
        if (status[k] != NONE && beyond_limits(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

int kinova_gen3_7_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[16][7],
    unsigned char status[16])
{
    const double zeros[7] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = isfinite(free_joints[0]) ? read_pose(T, pose) : 0;
    for (int i = 0; i < 7; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 16; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 7; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, free_joints, seed, q, status);
    for (int row = 0; row < 16; row++) {
        if (status[row] == NONE)
            continue;
        (void)stand(pose, row, 0, q, status);
        for (int i = 0; i < 7; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, pace[i] > 0.0 ? 0.0 : *value);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int kinova_gen3_7_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    double all[16][7], found[7], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = kinova_gen3_7_ik(T, free_joints, q_seed, all, status) >= 0;
    for (int i = 0; i < 7; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 16 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 7; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
        }
        if (distance < least || result < 0) {
            least = distance;
            result = status[row];
            take(all[row], found);
        }
    }
    take(found, q);
    return valid ? result : -INVALID;
}

void kinova_gen3_7_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)kinova_gen3_7_ik(
            T + 16 * k, free_joints + k, NULL, (double (*)[7])(q + 112 * k), status + 16 * k);
}
