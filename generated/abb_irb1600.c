/* abb_irb1600: ABB IRB 1600
 *
 * Inverse kinematics, generated from robots/abb_irb1600.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/abb_irb1600.yaml. The formulas and where they come from:
 * abb_irb1600.md.
 */
#include "abb_irb1600.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.4865; /* joint offset 1 [m] */
static const double a1 = 0.15; /* link length 1 [m] */
static const double a2 = 0.7; /* link length 2 [m] */
static const double d4 = 0.6; /* joint offset 4 [m] */
static const double d6 = 0.065; /* joint offset 6 [m] */
static const double free_limit1 = 2.0015e-12; /* a length that fixes no angle [m] */
static const double longest3 = 1.6899999999999995; /* square of the longest reach [m^2] */
static const double shortest3 = 0.009999999999999995; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 1.6900000000005198;
/* the shortest, with what rounding adds [m^2] */
static const double shortest3_reach = 0.009999999999959966;
/* the longest, where branches merge [m^2] */
static const double longest3_apart = 1.6899999999999475;
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 0.010000000000003999;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 4.00600225e-24;
static const double offset2 = -1.5707963267948966; /* offset of joint 2 [rad] */
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double offset4 = 3.141592653589793; /* offset of joint 4 [rad] */
static const double offset3 = 1.5707963267948966; /* offset of joint 3 [rad] */
static const double offset5 = 3.141592653589793; /* offset of joint 5 [rad] */
static const double k1 = 0.84; /* 2 * d4 * a2 [m^2] */
static const double k2 = 0.8499999999999999; /* a2^2 + d4^2 [m^2] */
static const double k3 = 1.4172335600907033; /* 1 / ((2 * d4 * a2)^2) [m^-4] */

const char *const abb_irb1600_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void abb_irb1600_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v1 = q[1] + offset2;
    const double c2 = cos(v1);
    const double s2 = sin(v1);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v2 = c1 * s2;
    const double v3 = s1 * s2;
    const double v4 = q[2] + offset3;
    const double c3 = cos(v4);
    const double s3 = sin(v4);
    const double x3_x = x2_x * c3 - v2 * s3;
    const double x3_y = x2_y * c3 - v3 * s3;
    const double v5 = s2 * c3 + c2 * s3;
    const double z3_x = v2 * c3 + x2_x * s3;
    const double z3_y = v3 * c3 + x2_y * s3;
    const double z3_z = c2 * c3 - s2 * s3;
    const double v6 = q[3] + offset4;
    const double c4 = cos(v6);
    const double s4 = sin(v6);
    const double x4_x = x3_x * c4 - s1 * s4;
    const double x4_y = x3_y * c4 + c1 * s4;
    const double v7 = v5 * c4;
    const double z4_x = s1 * c4 + x3_x * s4;
    const double v8 = v5 * s4;
    const double z4_y = x3_y * s4 - c1 * c4;
    const double v9 = q[4] + offset5;
    const double c5 = cos(v9);
    const double s5 = sin(v9);
    const double x5_x = x4_x * c5 + z3_x * s5;
    const double x5_y = x4_y * c5 + z3_y * s5;
    const double x5_z = z3_z * s5 - v7 * c5;
    const double v10 = z3_z * c5 + v7 * s5;
    const double T13_ = x4_x * s5 - z3_x * c5;
    const double T23_ = x4_y * s5 - z3_y * c5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 + z4_x * s6;
    const double T21_ = x5_y * c6 + z4_y * s6;
    const double T31_ = x5_z * c6 - v8 * s6;
    const double T12_ = z4_x * c6 - x5_x * s6;
    const double T22_ = z4_y * c6 - x5_y * s6;
    const double T14_ = c1 * a1 + x2_x * a2 + z3_x * d4 + T13_ * d6;
    const double T24_ = s1 * a1 + x2_y * a2 + z3_y * d4 + T23_ * d6;
    const double T34_ = d1 - s2 * a2 + z3_z * d4 - v10 * d6;
    T[0] = T11_; T[1] = T12_; T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = -(v8 * c6 + x5_z * s6); T[10] = -v10; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void abb_irb1600_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double p1_x = c1 * a1;
    const double p1_y = s1 * a1;
    const double v1 = q[1] + offset2;
    const double c2 = cos(v1);
    const double s2 = sin(v1);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v2 = c1 * s2;
    const double v3 = s1 * s2;
    const double p2_x = p1_x + x2_x * a2;
    const double p2_y = p1_y + x2_y * a2;
    const double p2_z = d1 - s2 * a2;
    const double v4 = q[2] + offset3;
    const double c3 = cos(v4);
    const double s3 = sin(v4);
    const double x3_x = x2_x * c3 - v2 * s3;
    const double x3_y = x2_y * c3 - v3 * s3;
    const double v5 = s2 * c3 + c2 * s3;
    const double J44 = v2 * c3 + x2_x * s3;
    const double J54 = v3 * c3 + x2_y * s3;
    const double J64 = c2 * c3 - s2 * s3;
    const double v6 = q[3] + offset4;
    const double c4 = cos(v6);
    const double s4 = sin(v6);
    const double J45 = s1 * c4 + x3_x * s4;
    const double v7 = v5 * s4;
    const double p4_x = p2_x + J44 * d4;
    const double p4_y = p2_y + J54 * d4;
    const double p4_z = p2_z + J64 * d4;
    const double J55 = x3_y * s4 - c1 * c4;
    const double v8 = q[4] + offset5;
    const double c5 = cos(v8);
    const double s5 = sin(v8);
    const double v9 = J64 * c5 + v5 * c4 * s5;
    const double J46 = (x3_x * c4 - s1 * s4) * s5 - J44 * c5;
    const double J56 = (x3_y * c4 + c1 * s4) * s5 - J54 * c5;
    const double J21 = p4_x + J46 * d6;
    const double p6_y = p4_y + J56 * d6;
    const double p6_z = p4_z - v9 * d6;
    const double v10 = p6_z - d1;
    const double J12 = c1 * v10;
    const double J22 = s1 * v10;
    const double v11 = J21 - p2_x;
    const double v12 = p6_y - p2_y;
    const double v13 = p6_z - p2_z;
    const double J13 = c1 * v13;
    const double J23 = s1 * v13;
    const double J14 = J54 * v13 - J64 * v12;
    const double J24 = J64 * v11 - J44 * v13;
    const double J34 = J44 * v12 - J54 * v11;
    const double v14 = J21 - p4_x;
    const double v15 = p6_y - p4_y;
    const double v16 = p6_z - p4_z;
    const double J15 = J55 * v16 + v7 * v15;
    const double J35 = J45 * v15 - J55 * v14;
    const double J16 = J56 * v16 + v9 * v15;
    const double J36 = J46 * v15 - J56 * v14;
    J[0] = -p6_y; J[1] = J12; J[2] = J13; J[3] = J14; J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = J22; J[8] = J23; J[9] = J24; J[10] = -(v7 * v14 + J45 * v16);
    J[11] = -(v9 * v14 + J46 * v16);
    J[12] = 0.0; J[13] = -(s1 * (p6_y - p1_y) + c1 * (J21 - p1_x)); J[14] = -(s1 * v12 + c1 * v11);
    J[15] = J34; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = J44; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = J54; J[28] = J55; J[29] = J56;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = J64; J[34] = -v7; J[35] = -v9;
}

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
static double misfit(const double T[16])
{
    const double *x = T, *y = T + 4, *z = T + 8;
    const double xx = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1.0;
    const double yy = y[0] * y[0] + y[1] * y[1] + y[2] * y[2] - 1.0;
    const double xy = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    const double z0 = x[1] * y[2] - x[2] * y[1] - z[0];
    const double z1 = x[2] * y[0] - x[0] * y[2] - z[1];
    const double z2 = x[0] * y[1] - x[1] * y[0] - z[2];
    return xx * xx + yy * yy + 2.0 * xy * xy + z0 * z0 + z1 * z1 + z2 * z2;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(double T[16])
{
    double R[9], G[9];
    for (int i = 0; i < 9; i++)
        R[i] = T[4 * (i / 3) + i % 3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[3 * i + j] = (i == j ? 1.5 : 0.0)
                - 0.5 * (R[i] * R[j] + R[3 + i] * R[3 + j] + R[6 + i] * R[6 + j]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[4 * i + j] = R[3 * i] * G[j] + R[3 * i + 1] * G[3 + j] + R[3 * i + 2] * G[6 + j];
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    if (!(fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1.0) <= 1e-09))
        return 0;
    const double miss = misfit(T);
    if (!(miss <= 1e-09))
        return 0;
    if (miss > 1e-24) {
        straighten(T);
        straighten(T);
    }
    return 1;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[6], double q[8][6], unsigned char status[8])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const double wx = T14 - T13 * d6;
    const double Y1 = d6 * T23 - T24;
    const double w1 = sqrt(wx * wx + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v2 = Z1_3 * Z1_3;

    /* theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4] */
    const double v8 = seed[1] + offset2;

    /* theta4, type 2: U4[3, 3] */
    const double v12 = seed[3] + offset4;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(wx * factor1);
        const double s1 = free1 ? sin(seed[0]) : Y1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v1 = w1 * e1 + a1;
        const double N3 = v2 + v1 * v1;
        const double K3 = N3 - k2;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double s3 = k1 * K3 * k3;

        /* theta2 */
        const double Y1_2 = a2 + d4 * s3;
        const double v5 = Z1_3 * Y1_2;
        const double v6 = v1 * Y1_2;

        /* theta4 */
        const double v10 = T13 * c1 + T23 * s1;
        const double Y4 = T23 * c1 - T13 * s1;
        const double v11 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v13 = T12 * s1 - T22 * c1;
        const double v14 = T12 * c1 + T22 * s1;
        const double v16 = T11 * s1 - T21 * c1;
        const double v17 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double v3 = k3 * (k1 * (w3 * e2));

            /* theta2 */
            const double v4 = d4 * v3;
            const double S2 = v1 * v4 - v5;
            const double v7 = Z1_3 * v4 + v6;
            const double w2 = sqrt(S2 * S2 + v7 * v7);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v8) : -(v7 * factor2);
            const double s2 = free2 ? sin(v8) : S2 * factor2;

            /* theta4 */
            const double v9 = v3 * c2 + s3 * s2;
            const double s23 = s3 * c2 - v3 * s2;
            const double X4 = v9 * v10 + T33 * s23;
            const double w4 = sqrt(X4 * X4 + v11);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * v9 - s23 * v10;

            /* theta6 */
            const double v15 = v9 * v14 + T32 * s23;
            const double v18 = v9 * v17 + T31 * s23;

            /* joint values */
            const double q2 = wrap(atan2(s2, c2) - offset2);
            const double q3 = wrap(atan2(s3, -v3) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(v12) : -(X4 * factor4);
                const double s4 = free4 ? sin(v12) : Y4 * factor4;
                const double s5 = w4 * e3;

                /* theta6 */
                const double c6 = c4 * v13 - s4 * v15;
                const double s6 = c4 * v16 - s4 * v18;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q4 = wrap(atan2(s4, c4) - offset4);
                const double q5 = wrap(atan2(s5, c5) - offset5);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? ABB_IRB1600_FREE_JOINT : ABB_IRB1600_OK;
            }
        }
    }
}

/* A joint value moved by whole turns, near to another value but inside its limits. */
static double turned(int joint, double given, double towards)
{
    const double low = lowest[joint] - 1e-09;
    const double high = highest[joint] + 1e-09;
    double value = given;
    value += turn * floor((towards - value) / turn + 0.5);
    if (value > high)
        value -= turn * ceil((value - high) / turn);
    if (value < low)
        value += turn * ceil((low - value) / turn);
    return value <= high ? value : given;
}

static int inside(int joint, double value)
{
    return lowest[joint] - 1e-09 <= value && value <= highest[joint] + 1e-09;
}

int abb_irb1600_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? ABB_IRB1600_UNREACHABLE : ABB_IRB1600_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -ABB_IRB1600_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == ABB_IRB1600_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = ABB_IRB1600_OUT_OF_LIMITS;
        }
        count += status[row] != ABB_IRB1600_OUT_OF_LIMITS;
    }
    return count;
}

int abb_irb1600_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -ABB_IRB1600_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (abb_irb1600_ik(T, q_seed, all, status) < 0)
        return -ABB_IRB1600_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == ABB_IRB1600_OUT_OF_LIMITS && result < 0)
            result = -ABB_IRB1600_OUT_OF_LIMITS;
        if (status[row] != ABB_IRB1600_OK && status[row] != ABB_IRB1600_FREE_JOINT)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 6; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void abb_irb1600_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)abb_irb1600_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
