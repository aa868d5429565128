/* scara_ball_screw: SCARA with a ball screw spline
 *
 * Inverse kinematics, generated from robots/scara_ball_screw.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara_ball_screw.yaml. The formulas and where they come from:
 * scara_ball_screw.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 219eb12029b9e883
 * SPDX-License-Identifier: MIT
 */
#include "scara_ball_screw.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 4
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/coupled.h"

static const double
    L1 = 0.4, /* link length 1 [m] */
    L2 = 0.3, /* link length 2 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest2 = 0.48999999999999994, /* square of the longest reach [m^2] */
    shortest2 = 0.010000000000000007, /* square of the shortest reach [m^2] */
    longest2_reach = 0.490000000000098, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.009999999999986006, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.48999999999999017, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.010000000000001405, /* the shortest, where branches merge [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 7e-06, /* a pose may be rounded by this [m] */
    factor34 = 0.0025464790894703256, /* pitch/(2*pi): what q4 counts in joint 3 */
    k1 = 0.25, /* L1^2 + L2^2 [m^2] */
    k2 = 4.166666666666667; /* 1 / (2 * L2 * L1) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const scara_ball_screw_branches[2] = {
    "right", "left",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.2689280275926285, 2.2689280275926285, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.530727415391778, 2.530727415391778, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 7e-10, 2.0408163265306127, 0.7, 0.00625, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[4][4] = {
    { 0.0, 0.0, 0.4, 0.0 },
    { 0.0, 0.0, 0.3, 0.0 },
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE double drives[16] = {
    1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0025464790894703256, 0.0, 0.0, 0.0,
    1.0,
};
DHGEN_TABLE struct dhgen_links links = { 4, DHGEN_STANDARD, joints, &table[0][0], drives, NULL, NULL
    };
#define DHGEN_FRAMES 6

DHGEN_PUBLIC void scara_ball_screw_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_y = x2_y * c4 + x2_x * s4;
    T[0] = x2_x * c4 - x2_y * s4; T[1] = -x4_y; T[2] = 0.0; T[3] = c1 * L1 + x2_x * L2;
    T[4] = x4_y; T[5] = x2_x * c4 - x2_y * s4; T[6] = 0.0; T[7] = s1 * L1 + x2_y * L2;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = q[2] + factor34 * q[3];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void scara_ball_screw_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * L1, p1_y = s1 * L1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), p2_x = p1_x + (c1 * c2 - s1 * s2) * L2,
        p2_y = p1_y + (s1 * c2 + c1 * s2) * L2;
    J[0] = -p2_y; J[1] = p1_y - p2_y; J[2] = 0.0; J[3] = 0.0;
    J[4] = p2_x; J[5] = p2_x - p1_x; J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0; J[10] = 1.0; J[11] = factor34;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = 0.0;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = 0.0;
    J[20] = 1.0; J[21] = 1.0; J[22] = 0.0; J[23] = 1.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[4] = (double (*)[4])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta124, type 3: U0[2, 1] and U0[1, 1] */
    const double w124 = sqrt(T21 * T21 + T11 * T11);
    const int short124 = w124 <= free_limit;
    const double v1 = 1.0 / (short124 ? 1.0 : w124);
    const double c124 = T11 * v1, s124 = T21 * v1;
    const double theta124 = atan2(s124, c124);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double N2 = T14 * T14 + T24 * T24;
    const double K2 = N2 - k1;
    const double D2_squared = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D2_squared : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_1 = L1 + L2 * c2;
    const double v2 = T24 * X1_1, v3 = T14 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabs(T33 - 1.0) <= pose_slack && fabs(T31) <= pose_slack && fabs(T23) <= pose_slack &&
        fabs(T21 - s124) <= pose_slack && fabs(T11 - c124) <= pose_slack && fabs(T13) <=
        pose_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e2 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e2 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e2 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = L2 * s2;
        const double S1 = v2 - T14 * Y1_1;
        const double C1 = v3 + T24 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const double factor1 = 1.0 / w1;
        const double c1 = C1 * factor1, s1 = S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1, s12 = c2 * s1 + s2 * c1;
        if (!(fabs(T14 - (L2 * c12 + L1 * c1)) <= pose_slack1 && fabs(T24 - (L2 * s12 + L1 * s1)) <=
            pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = dhgen_wrap(theta124 - (q2 + q1));
        const double q3 = T34 - q4 * factor34;
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
        status[row] = DHGEN_OK;
    }
}

/* The drives whose whole turns hang together, and sums of drives that have limits. */
DHGEN_TABLE int coupled[1] = { 3 };
DHGEN_TABLE double coupled_moves[4] = { 0.0, 0.0, -0.016, 6.283185307179586 };
DHGEN_TABLE double coupled_lowest[4] = {
    -2.2689280285926285, -2.530727416391778, -0.2000000007, -6.283185308179586,
};
DHGEN_TABLE double coupled_highest[4] = {
    2.2689280285926285, 2.530727416391778, 7e-10, 6.283185308179586,
};
DHGEN_TABLE struct dhgen_coupling coupling = {
    1, coupled, coupled_moves, coupled_lowest, coupled_highest, 0, NULL, NULL, NULL, NULL,
};
DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    4, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.429, 1.429, 1.429, 1.0, 1.0, 1.0 }, 1.4285714285714286, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, &coupling, dhgen_coupled_beyond, scara_ball_screw_fk,
    scara_ball_screw_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) scara_ball_screw_##function
#include "dhgen/functions.h"
