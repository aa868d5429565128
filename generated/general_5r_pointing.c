/* general_5r_pointing: Five revolute joints without structure, for a tool that points
 *
 * Inverse kinematics, generated from robots/general_5r_pointing.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_5r_pointing.yaml. The formulas and where they come from:
 * general_5r_pointing.md.
 */
#include "general_5r_pointing.h"

#define DHGEN_DOF 5
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the general algorithm has to do for the arm */
#ifdef GENERAL_5R_POINTING_LANES
#define DHGEN_GENERAL_LANES GENERAL_5R_POINTING_LANES
#endif
#include "dhgen/general.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = GENERAL_5R_POINTING_OK, NONE = GENERAL_5R_POINTING_UNREACHABLE, FREE =
        GENERAL_5R_POINTING_FREE_JOINT,
    OUT = GENERAL_5R_POINTING_OUT_OF_LIMITS, INVALID = GENERAL_5R_POINTING_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation general_5r_pointing_formulations[2] = {
    { { 4, 5, 0, 1, 2, 3 }, 1.0, 0 },
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double general_5r_pointing_constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.21009837473856222, 0.23890988778694228,
        0.09954578657789262, -0.9659258262890684, -0.04660356600545808, 0.8916238396514479,
        0.37150993318810327, 0.2588190451025208, 7.478317479849794e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.8403934989542489, 0.8291405477522721,
        0.44220829213454516, -0.3420201433256687, 0.027230633165473302, 0.3017824794050018,
        0.16095065568266761, 0.9396926207859084, 0.045015588243639895 },
    { 0.28, -0.96, 0.0, 0.6302951242156866, 0.40571353127107146, 0.11833311328739586,
        0.9063077870366499, 0.12528109336044682, -0.8700554755551839, -0.253766180370262,
        0.42261826174069944, 0.03298739095516433 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.12605902484313733, 0.12574523210363928,
        0.1197573639082279, -0.9848077530122081, -0.07712175856800875, 0.7131366487329783,
        0.6791777606980747, 0.17364817766693044, 0.12748430444410336 },
    { 0.29872248454147626, -0.8712739132459724, 0.3894183423086505, -0.0018597364116695418,
        0.20485141903797224, 0.45707880306005993, 0.8655142193582449, -0.03486419238383276,
        -0.9320948306623617, -0.17877565799132936, 0.31502141318054977, 0.09808752298987687 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.355943590540993 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.18202833920561123 },
};

DHGEN_TABLE dhgen_general_arm general_5r_pointing_general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.47596750867033544, 2.100983747385622, /* the length that is one in the loop, and its inverse
        */
    4.0000000039999986, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, general_5r_pointing_formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    general_5r_pointing_constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, 0,
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[5] = { 0, 1, 2, 3, 4 };
static const int turning[5] = { 1, 1, 1, 1, 1 };
static const double unit[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[5] = {
    0.5649717514124294, 0.5649717514124294, 0.5649717514124294, 0.5649717514124294,
    0.5649717514124294,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[5] = {
    -2.9670597283903604, -2.0943951023931953, -2.443460952792061, -3.141592653589793,
    -3.141592653589793,
};
static const double span_width[5] = {
    5.934119456780721, 4.1887902047863905, 4.886921905584122, 6.283185307179586, 6.283185307179586,
};
static const double stride[5] = {
    0.8812714616335696, 0.7766393890897682, 0.6844301295853426, 0.6031687406857283,
    0.5315553977157914,
};
static const double least_u[5] = {
    -2.9670597283903604, -2.0943951023931953, -2.443460952792061, -3.141592653589793,
    -3.141592653589793,
};
static const double most_u[5] = {
    2.9670597283903604, 2.0943951023931953, 2.443460952792061, 3.141592653589793, 3.141592653589793,
};
/* How the loop counts the joints: from where, and which way. */
static const double facing[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };

static const struct dhgen_numerical_arm general_5r_pointing_descents = {
    5, 16, /* joints; solutions that are kept */
    5, 6, /* joints that are solved for; equations */
    3, DHGEN_TOOL_AXIS, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.77, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero,
    0, 0,
    general_5r_pointing_fk, general_5r_pointing_jacobian, 0,
};

static void all_joints(
    const double T[16],
    const double seed[5], double q[16][5], int found[16],
    int chosen[16])
{
    dhgen_general_rows(&general_5r_pointing_general, &general_5r_pointing_descents, T, 0, seed,
        q[0], found, chosen);
}

static const double
    d1 = 0.35, /* joint offset 1 [m] */
    a1 = 0.1, /* link length 1 [m] */
    d2 = 0.08, /* joint offset 2 [m] */
    a2 = 0.4, /* link length 2 [m] */
    ca2 = 0.9396926207859084, /* cosine of twist 2 */
    sa2 = 0.3420201433256687, /* sine of twist 2 */
    d3 = -0.05, /* joint offset 3 [m] */
    a3 = 0.3, /* link length 3 [m] */
    ca3 = 0.42261826174069944, /* cosine of twist 3 */
    sa3 = 0.9063077870366499, /* sine of twist 3 */
    d4 = 0.12, /* joint offset 4 [m] */
    a4 = 0.06, /* link length 4 [m] */
    ca4 = 0.17364817766693041, /* cosine of twist 4 */
    sa4 = 0.984807753012208, /* sine of twist 4 */
    d5 = 0.09, /* joint offset 5 [m] */
    a5 = 0.05, /* link length 5 [m] */
    ca5 = 0.3420201433256688, /* cosine of twist 5 */
    sa5 = 0.9396926207859083, /* sine of twist 5 */
    cae11 = 0.9210609940028851, /* cosine of tool frame, entry 1,1 */
    sae11 = 0.3894183423086505, /* sine of tool frame, entry 1,1 */
    ex = 0.02, /* x of the tool frame [m] */
    ez = 0.15, /* z of the tool frame [m] */
    f1 = 0.25881904510252074, /* 1 / 4 * sqrt2 * sqrt3 - 1 / 4 * sqrt2 */
    f2 = 0.9659258262890683, /* 1 / 4 * sqrt2 * sqrt3 + 1 / 4 * sqrt2 */
    f3 = 0.02070552360820166, /* d2 * f1 [m] */
    f4 = 0.08852132690137686, /* sa2 * f1 */
    f5 = 0.24321034680169396; /* ca2 * f1 */

const char *const general_5r_pointing_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[5] = {
    -2.9670597283903604, -2.0943951023931953, -2.443460952792061, -3.141592653589793,
    -3.141592653589793,
};
static const double highest[5] = {
    2.9670597283903604, 2.0943951023931953, 2.443460952792061, 3.141592653589793, 3.141592653589793,
};
#define slack(joint) 1e-09 /* of limits */

void general_5r_pointing_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * f1, y1_y = c1 * f1, z1_x = s1 * f2,
        v2 = c1 * f2;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = f2 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = f2 * c2, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, y2_z = v5 * ca2 + f4, z2_x = v3 * sa2 + z1_x * ca2,
        v6 = v4 * sa2 + v2 * ca2, z2_z = f5 - v5 * sa2;
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
    T[11] = d1 + x2_z * a2 + f3 + x3_z * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z *
        d5 + x5_z * ex + z5_z * ez;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void general_5r_pointing_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1, v1 = s1 * f1,
        y1_y = c1 * f1, z1_x = s1 * f2, v2 = c1 * f2;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = f2 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = f2 * c2, p2_x = p1_x + x2_x * a2 + z1_x * d2,
        p2_y = p1_y + x2_y * a2 - v2 * d2, p2_z = d1 + x2_z * a2 + f3, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, y2_z = v5 * ca2 + f4, z2_x = v3 * sa2 + z1_x * ca2,
        v6 = v4 * sa2 + v2 * ca2, z2_z = f5 - v5 * sa2;
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
    J[0] = -v13; J[1] = -(v2 * v17 + f1 * v16); J[2] = -(v6 * v20 + z2_z * v19);
    J[3] = z3_y * v23 - z3_z * v22; J[4] = z4_y * v26 - z4_z * v25;
    J[5] = J21; J[6] = f1 * v15 - z1_x * v17; J[7] = z2_z * v18 - z2_x * v20;
    J[8] = z3_z * v21 - z3_x * v23; J[9] = z4_z * v24 - z4_x * v26;
    J[10] = 0.0; J[11] = z1_x * v16 + v2 * v15; J[12] = z2_x * v19 + v6 * v18;
    J[13] = z3_x * v22 - z3_y * v21; J[14] = z4_x * v25 - z4_y * v24;
    J[15] = 0.0; J[16] = z1_x; J[17] = z2_x; J[18] = z3_x; J[19] = z4_x;
    J[20] = 0.0; J[21] = -v2; J[22] = -v6; J[23] = z3_y; J[24] = z4_y;
    J[25] = 1.0; J[26] = f1; J[27] = z2_z; J[28] = z3_z; J[29] = z4_z;
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose, and 2 for what was rounded. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    const double square = T[2] * T[2] + T[6] * T[6] + T[10] * T[10];
    const double miss = (square - 1.0) * (square - 1.0);
    if (!(miss <= 1e-09))
        return 0;
    if (miss <= 1e-24)
        return 1;
    const double length = sqrt(square);
    T[2] /= length;
    T[6] /= length;
    T[10] /= length;
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


/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[5], double q[16][5], unsigned char status[16])
{

    /* all joints: the general 6R loop */
    double solution_roots[16][5];
    int solution_found[16], solution_chosen[16];
    all_joints(T, seed, solution_roots, solution_found, solution_chosen);

    for (int i1 = 0; i1 < 16; i1++) { /* root1 to root16 */
        const double q1 = solution_roots[i1][0];
        const double q2 = solution_roots[i1][1];
        const double q3 = solution_roots[i1][2];
        const double q4 = solution_roots[i1][3];
        const double q5 = solution_roots[i1][4];
        const int found = solution_found[i1];
        const int chosen = solution_chosen[i1];
        /* all joints: the general 6R loop */
        if (!found) continue; /* out of reach */
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        status[row] = (chosen) ? FREE : OK;
    }
}

static void take(const double from[5], double to[5])
{
    for (int i = 0; i < 5; i++)
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
static double half_way(const double x[5], const double q[5], double half[5])
{
    double most = 0.0;
    for (int i = 0; i < 5; i++) {
        double off = q[i] - x[i];
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.565, 0.565, 0.565, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[5], double e[6])
{
    double P[16], square = 0.0;
    general_5r_pointing_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3 * 4 + 2, k = (i + 2) % 3 * 4 + 2;
        e[3 + i] = P[j] * T[k] - P[k] * T[j];
        square += (P[j] - T[j]) * (P[j] - T[j]);
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[5], double damping, double e[6], double x[5])
{
    double A[6][11] = { { 0.0 } }, square[6] = { 0.0 }, J[30];
    general_5r_pointing_jacobian(x, J);
    double P[16];
    general_5r_pointing_fk(x, P);
    for (int j = 0; j < 5; j++) { /* turning about z changes nothing */
        double *spin = J + 15 + j;
        const double along = P[2] * spin[0] + P[6] * spin[5] + P[10] * spin[10];
        for (int i = 0; i < 3; i++)
            spin[5 * i] -= along * P[4 * i + 2];
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 5; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[5 * i + j];
        A[i][5 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 11; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 11; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 11; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 5; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* The same of a value as it stands: it might be turned. */
static double past_an_end(int joint, double value)
{
    const double low = lowest[joint], high = highest[joint];
    if (high - low < 6.183185307179587)
        return overshoot(joint, value);
    const double off = value - fmin(fmax(value, low), high);
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of all joints. */
static double past_ends(const double values[5])
{
    double sum = 0.0;
    for (int i = 0; i < 5; i++)
        sum += fabs(past_an_end(i, values[i]));
    return sum;
}

/* A joint value turned inside its limits, or next to the end that it and the seed are at. */
static double at_an_end(int joint, double value, double seed)
{
    const double near = value + turn * floor((seed - value) / turn + 0.5);
    const double past = fabs(past_an_end(joint, near));
    if (0.0 < past && past < 0.01 && fabs(near - seed) < 0.15)
        return near;
    const double off = overshoot(joint, value);
    if (off == 0.0 || fabs(off) > 0.01)
        return turned(joint, value, value);
    return off + (off > 0.0 ? highest : lowest)[joint];
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[5])
{
    double x[5], half[5], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[5] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 5 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? past_an_end(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 5; i++)
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

/* Takes joint values onto ends that they are past or, as two may not stand there, inside. */
static int lead_inside(const double T[16], double enough, double most, double q[5])
{
    double x[5], e[6];
    if (settle(T, enough, most, q))
        return 1;
    int past = 0;
    for (int i = 0; i < 5; i++)
        past += fabs(past_an_end(i, q[i])) > 0.0;
    enough = off_pose(T, q, e) + 1e-14;
    for (double farther = 2.0; past > 1 && farther <= 16.0; farther *= 2.0) {
        for (int i = 0; i < 5; i++)
            x[i] = q[i] - farther * past_an_end(i, q[i]);
        if (!settle(T, enough, most, x) || past_ends(x) > 0.0)
            continue;
        take(x, q);
        return 1;
    }
    return 0;
}

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const double T[16], int row, int far, double rows[16][5], const unsigned char status[16])
{
    double x[5], half[5], to[5], *q = rows[row];
    const double beyond = past_ends(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!lead_inside(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 16; k++)
        if (status[k] != NONE && past_ends(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

int general_5r_pointing_ik(
    const double T[16], const double *q_seed, double q[16][5], unsigned char status[16])
{
    const double zeros[5] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 5; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 16; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 5; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 16; row++)
        for (int i = 0; i < 5; i++)
            q[row][i] = at_an_end(i, q[row][i], seed[i]);
    for (int row = 0; row < 16; row++) {
        if (status[row] == NONE)
            continue;
        (void)stand(pose, row, 0, q, status);
        for (int i = 0; i < 5; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int general_5r_pointing_ik_nearest(const double T[16], const double q_seed[5], double q[5])
{
    double all[16][5], found[5], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = general_5r_pointing_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 5; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 16 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 5; i++) {
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

void general_5r_pointing_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)general_5r_pointing_ik(
            T + 16 * k, NULL, (double (*)[5])(q + 80 * k), status + 16 * k);
}
