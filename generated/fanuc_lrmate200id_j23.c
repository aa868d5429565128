/* fanuc_lrmate200id_j23: Fanuc LR Mate 200iD, as its pendant counts
 *
 * Inverse kinematics, generated from robots/fanuc_lrmate200id_j23.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/fanuc_lrmate200id_j23.yaml. The formulas and where they come from:
 * fanuc_lrmate200id_j23.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 1565c3ae04adb845
 * SPDX-License-Identifier: MIT
 */
#include "fanuc_lrmate200id_j23.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/coupled.h"

static const double
    d1 = 0.33, /* joint offset 1 [m] */
    a1 = 0.05, /* link length 1 [m] */
    a2 = 0.33, /* link length 2 [m] */
    a3 = 0.035, /* link length 3 [m] */
    d4 = 0.335, /* joint offset 4 [m] */
    d6 = 0.08, /* z of the tool frame [m] */
    free_limit1 = 1.1600000000000001e-12, /* a length that fixes no angle [m] */
    longest3 = 0.4446534412689106, /* square of the longest reach [m^2] */
    shortest3 = 4.655873108936529e-05, /* square of the shortest reach [m^2] */
    longest3_reach = 0.44465344126906536, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 4.655873108778226e-05, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.4446534412688952, /* the longest, where branches merge [m^2] */
    shortest3_apart = 4.655873108952359e-05, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    k1 = 0.22110000000000002, /* 2 * d4 * a2 [m^2] */
    k2 = 0.023100000000000002, /* 2 * a3 * a2 [m^2] */
    k3 = 0.22235000000000002, /* a2^2 + (a3^2 + d4^2) [m^2] */
    k4 = 20.235205939761407; /* 1 / (k1^2 + k2^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const fanuc_lrmate200id_j23_branches[8] = {
    "back-up-noflip", "back-up-flip", "back-down-noflip", "back-down-flip", "front-down-noflip",
    "front-down-flip", "front-up-noflip", "front-up-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.7453292519943295, 2.530727415391778, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.3161255787892263, 3.3161255787892263, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.181661564992912, 2.181661564992912, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.33, 0.05, -1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.33, 3.141592653589793 },
    { 0.0, 0.0, 0.035, -1.5707963267948966 },
    { 0.0, -0.335, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE double drives[36] = {
    1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
};
DHGEN_TABLE double tool[12] = { 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -0.08 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], drives, NULL, tool
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void fanuc_lrmate200id_j23_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, v2 = q[1] + q[2];
    const double c3 = cos(v2), s3 = sin(v2), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * s3 - s2 * c3, z3_x = y2_x * c3 - x2_x * s3,
        z3_y = y2_y * c3 - x2_y * s3, z3_z = c2 * c3 + s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        z4_y = x3_y * s4 - c1 * c4, v3 = q[4] + offset5;
    const double c5 = cos(v3), s5 = sin(v3), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, T11_ = z3_x * c5 - x4_x * s5,
        T21_ = z3_y * c5 - x4_y * s5, T31_ = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = T11_; T[1] = x5_x * s6 - z4_x * c6; T[2] = -(x5_x * c6 + z4_x * s6);
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 - z3_x * d4 - -T11_ * d6;
    T[4] = T21_; T[5] = x5_y * s6 - z4_y * c6; T[6] = -(x5_y * c6 + z4_y * s6);
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 - z3_y * d4 - -T21_ * d6;
    T[8] = T31_; T[9] = x5_z * s6 - z4_z * c6; T[10] = -(x5_z * c6 + z4_z * s6);
    T[11] = d1 - s2 * a2 + x3_z * a3 - z3_z * d4 - -T31_ * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void fanuc_lrmate200id_j23_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2,
        v2 = q[1] + q[2];
    const double c3 = cos(v2), s3 = sin(v2), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * s3 - s2 * c3, z3_x = y2_x * c3 - x2_x * s3,
        z3_y = y2_y * c3 - x2_y * s3, z3_z = c2 * c3 + s2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p3_x - z3_x * d4, p4_y = p3_y - z3_y * d4, p4_z = p3_z - z3_z * d4,
        z4_y = x3_y * s4 - c1 * c4, v3 = q[4] + offset5;
    const double c5 = cos(v3), s5 = sin(v3), z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        J21 = p4_x - z5_x * d6, v4 = p4_y - z5_y * d6, v5 = p4_z - z5_z * d6, v6 = v5 - d1,
        v7 = v5 - p2_z, v8 = c1 * v7, v9 = s1 * v7, J33 = s1 * (v4 - p2_y) + c1 * (J21 - p2_x),
        v10 = J21 - p3_x, v11 = v4 - p3_y, v12 = v5 - p3_z, v13 = J21 - p4_x, v14 = v4 - p4_y,
        v15 = v5 - p4_z;
    J[0] = -v4; J[1] = c1 * v6 - v8; J[2] = -v8; J[3] = z3_y * v12 - z3_z * v11;
    J[4] = z4_y * v15 - z4_z * v14; J[5] = z5_y * v15 - z5_z * v14;
    J[6] = J21; J[7] = s1 * v6 - v9; J[8] = -v9; J[9] = z3_z * v10 - z3_x * v12;
    J[10] = z4_z * v13 - z4_x * v15; J[11] = z5_z * v13 - z5_x * v15;
    J[12] = 0.0; J[13] = J33 - (s1 * (v4 - p1_y) + c1 * (J21 - p1_x)); J[14] = J33;
    J[15] = z3_x * v11 - z3_y * v10; J[16] = z4_x * v14 - z4_y * v13;
    J[17] = z5_x * v14 - z5_y * v13;
    J[18] = 0.0; J[19] = 0.0; J[20] = s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = -c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double t14 = T14 - d6 * T11;
    const double Y1 = d6 * T21 - T24;
    const double w1 = sqrt(t14 * t14 + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double t34 = T34 - d6 * T31;
    const double Z1_3 = t34 - d1;
    const double v2 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(t14 * factor1),
            s1 = free1 ? sin(seed[0]) : Y1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v1 = w1 * e1 + a1;
        const double N3 = v2 + v1 * v1;
        const double K3 = N3 - k3;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v3 = k1 * K3, v4 = k2 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v6 = T11 * c1 + T21 * s1;
        const double Y4 = T11 * s1 - T21 * c1;
        const double v7 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v8 = T22 * c1 - T12 * s1, v9 = T12 * c1 + T22 * s1, v11 = T23 * c1 - T13 * s1,
            v12 = T13 * c1 + T23 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double s3 = (v3 + k2 * D3) * k4, c3 = k4 * (v4 - k1 * D3);

            /* theta2, type 3: U1[1, 4] and U1[2, 4] */
            const double X1_2 = a3 * s3 - d4 * c3;
            const double Y1_2 = a2 + (a3 * c3 + d4 * s3);
            const double v5 = v1 * X1_2 + Z1_3 * Y1_2;
            const double C2 = Z1_3 * X1_2 - v1 * Y1_2;
            const double w2 = sqrt(v5 * v5 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = -(v5 * factor2);

            /* theta4 */
            const double c2m3 = c3 * c2 + s3 * s2;
            const double s2m3 = c3 * s2 - s3 * c2;
            const double X4 = c2m3 * v6 - T31 * s2m3;
            const double w4 = sqrt(X4 * X4 + v7);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T31 * c2m3 + s2m3 * v6;

            /* theta6 */
            const double v10 = T32 * s2m3 - c2m3 * v9, v13 = T33 * s2m3 - c2m3 * v12;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(atan2(s3, c3) - q2);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);
                const double s5 = w4 * e4;

                /* theta6 */
                const double c6 = c4 * v8 + s4 * v10, s6 = c4 * v11 + s4 * v13;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q5 = dhgen_wrap(atan2(s5, c5) - offset5);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

/* The drives whose whole turns hang together, and sums of drives that have limits. */
DHGEN_TABLE int coupled[2] = { 1, 2 };
DHGEN_TABLE double coupled_moves[12] = {
    0.0, 6.283185307179586, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 6.283185307179586, 0.0, 0.0, 0.0,
};
DHGEN_TABLE double coupled_lowest[6] = {
    -2.9670597293903604, -1.7453292529943296, -HUGE_VAL, -3.3161255797892264, -2.181661565992912,
    -6.283185308179586,
};
DHGEN_TABLE double coupled_highest[6] = {
    2.9670597293903604, 2.530727416391778, HUGE_VAL, 3.3161255797892264, 2.181661565992912,
    6.283185308179586,
};
DHGEN_TABLE double sum_factors[6] = { 0.0, 1.0, 1.0, 0.0, 0.0, 0.0 };
DHGEN_TABLE double sum_lowest[1] = { -1.2217304773960307 };
DHGEN_TABLE double sum_highest[1] = { 3.5779249675883755 };
DHGEN_TABLE double sum_slacks[1] = { 1e-09 };
DHGEN_TABLE struct dhgen_coupling coupling = {
    2, coupled, coupled_moves, coupled_lowest, coupled_highest, 1, sum_factors, sum_lowest,
        sum_highest, sum_slacks,
};
DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[2] = { 3, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.8621, 0.8621, 0.8621, 1.0, 1.0, 1.0 }, 0.8620689655172413, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, &coupling, dhgen_coupled_beyond,
    fanuc_lrmate200id_j23_fk, fanuc_lrmate200id_j23_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) fanuc_lrmate200id_j23_##function
#include "dhgen/functions.h"
