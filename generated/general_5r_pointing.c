/* general_5r_pointing: Five revolute joints without structure, for a tool that points
 *
 * Inverse kinematics, generated from robots/general_5r_pointing.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_5r_pointing.yaml. The formulas and where they come from:
 * general_5r_pointing.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 82d1215b192f66ab
 * SPDX-License-Identifier: MIT
 */
#include "general_5r_pointing.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 5
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef GENERAL_5R_POINTING_LANES
#define DHGEN_GENERAL_LANES GENERAL_5R_POINTING_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

/* In formulas below, sqrt2 = 1.4142135623730951, sqrt3 = 1.7320508075688772. */
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

#ifndef __CUDACC_RTC__
const char *const general_5r_pointing_branches[16] = {
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

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.47596750867033544, 2.100983747385622, /* the length that is one in the loop, and its inverse
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
DHGEN_TABLE int solved[5] = { 0, 1, 2, 3, 4 };
DHGEN_TABLE int turning[5] = { 1, 1, 1, 1, 1 };
DHGEN_TABLE double unit[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[5] = {
    0.5649717514124294, 0.5649717514124294, 0.5649717514124294, 0.5649717514124294,
    0.5649717514124294,
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
    3, DHGEN_POINTING, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.77, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    general_5r_pointing_fk, general_5r_pointing_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.35, 0.1, 1.3089969389957472 },
    { 0.0, 0.08, 0.4, 0.3490658503988659 },
    { 0.0, -0.05, 0.3, -1.1344640137963142 },
    { 0.0, 0.12, 0.06, 1.3962634015954636 },
    { 0.0, 0.09, 0.05, -1.2217304763960306 },
};
DHGEN_TABLE double tool[12] = {
    0.9210609940028851, 0.0, 0.3894183423086505, 0.02, 0.0, 1.0, 0.0, 0.0, -0.3894183423086505, 0.0,
    0.9210609940028851, 0.15,
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void general_5r_pointing_fk(const double q[5], double T[16])
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
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void general_5r_pointing_jacobian(const double q[5], double J[30])
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

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    (void)free_joints; (void)moved;
    dhgen_general_rows(&general, &descents, T, NULL, seed, rows, status);
}

DHGEN_TABLE int entries[6] = { 2, 3, 6, 7, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    5, 16, 0, DHGEN_POINTING, joints, NULL, 0,
    { 0.565, 0.565, 0.565, 1.0, 1.0, 1.0 }, 0.5649717514124294, { 1e-14, 1e-10 }, entries, 6,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 1, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, general_5r_pointing_fk,
    general_5r_pointing_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) general_5r_pointing_##function
#include "dhgen/functions.h"
