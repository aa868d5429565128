/* prismatic_2_wrist: Slide as joint 2, spherical wrist
 *
 * Inverse kinematics, generated from robots/prismatic_2_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/prismatic_2_wrist.yaml. The formulas and where they come from:
 * prismatic_2_wrist.md.
 */
#include "prismatic_2_wrist.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double a1 = 0.1; /* link length 1 [m] */
static const double cat2 = 0.9800665778412416; /* cosine of the angle of joint 2 */
static const double sat2 = 0.19866933079506122; /* sine of the angle of joint 2 */
static const double a2 = 0.15; /* link length 2 [m] */
static const double d3 = 0.1; /* joint offset 3 [m] */
static const double a3 = 0.08; /* link length 3 [m] */
static const double d4 = 0.43; /* joint offset 4 [m] */
static const double d6 = 0.08; /* joint offset 6 [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 1.5375999999999999e-24;
static const double reach_slack1 = 1.24e-13; /* rounding at the boundary of the workspace [m] */
static const double merge_slack1 = 1.24e-14; /* nearer to that boundary two branches are one [m] */
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double k1 = 0.4138869064318786; /* d1 * cat2 + (a1 * sat2 + d3) [m] */
static const double k2 = 0.08542781224187632; /* d4 * sat2 [m] */
static const double k3 = 0.0158935464636049; /* a3 * sat2 [m] */
static const double k4 = 0.36820625816486496; /* d1 + (cat2 * d3 - a2 * sat2) [m] */
static const double k5 = 0.007550515923624042; /* (d4 * sat2)^2 + (a3 * sat2)^2 [m^2] */
static const double k6 = 132.4412808495909; /* 1 / ((d4 * sat2)^2 + (a3 * sat2)^2) [m^-2] */
static const double f1 = 0.2701996003807408; /* d1 - sat2 * a2 [m] */
static const double f2 = 0.09800665778412417; /* d3 * cat2 [m] */
static const double g1 = 0.2701996003807408; /* d1 - sat2 * a2 [m] */
static const double g2 = 0.09800665778412417; /* d3 * cat2 [m] */

const char *const prismatic_2_wrist_branches[8] = {
    "left-noflip3-noflip4", "left-noflip3-flip4", "left-flip3-noflip4", "left-flip3-flip4",
    "right-noflip3-noflip4", "right-noflip3-flip4", "right-flip3-noflip4", "right-flip3-flip4",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 1, 0, 1, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 0.6503642039542143, 1.0, 1.0, 1.0, 1.0 };

void prismatic_2_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double x2_x = c1 * cat2;
    const double x2_y = s1 * cat2;
    const double z2_x = c1 * sat2;
    const double z2_y = s1 * sat2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 - s1 * s3;
    const double x3_y = x2_y * c3 + c1 * s3;
    const double v1 = sat2 * c3;
    const double v2 = s1 * c3 + x2_x * s3;
    const double z3_y = c1 * c3 - x2_y * s3;
    const double z3_z = sat2 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = x3_x * c4 - z2_x * s4;
    const double x4_y = x3_y * c4 - z2_y * s4;
    const double v3 = v1 * c4 + cat2 * s4;
    const double z4_x = z2_x * c4 + x3_x * s4;
    const double z4_y = z2_y * c4 + x3_y * s4;
    const double y5_z = v1 * s4 - cat2 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5 - v2 * s5;
    const double x5_y = x4_y * c5 + z3_y * s5;
    const double x5_z = z3_z * s5 - v3 * c5;
    const double v4 = v2 * c5 + x4_x * s5;
    const double T23_ = z3_y * c5 - x4_y * s5;
    const double T33_ = z3_z * c5 + v3 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 - z4_x * s6;
    const double T21_ = x5_y * c6 - z4_y * s6;
    const double T31_ = x5_z * c6 + y5_z * s6;
    const double T32_ = y5_z * c6 - x5_z * s6;
    const double T14_ = c1 * a1 - s1 * q[1] + x2_x * a2 + x3_x * a3 + z2_x * d3 - v2 * d4 - v4 * d6;
    const double T24_ = s1 * a1 + c1 * q[1] + x2_y * a2 + x3_y * a3 + z2_y * d3 + z3_y * d4 + T23_ *
        d6;
    const double T34_ = f1 - v1 * a3 + f2 + z3_z * d4 + T33_ * d6;
    T[0] = T11_; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = -v4; T[3] = T14_;
    T[4] = T21_; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void prismatic_2_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double x2_x = c1 * cat2;
    const double x2_y = s1 * cat2;
    const double J43 = c1 * sat2;
    const double J53 = s1 * sat2;
    const double p2_x = c1 * a1 - s1 * q[1] + x2_x * a2;
    const double p2_y = s1 * a1 + c1 * q[1] + x2_y * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 - s1 * s3;
    const double x3_y = x2_y * c3 + c1 * s3;
    const double v1 = sat2 * c3;
    const double v2 = s1 * c3 + x2_x * s3;
    const double J54 = c1 * c3 - x2_y * s3;
    const double J64 = sat2 * s3;
    const double p3_x = p2_x + x3_x * a3 + J43 * d3;
    const double p3_y = p2_y + x3_y * a3 + J53 * d3;
    const double p3_z = g1 - v1 * a3 + g2;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = J43 * c4 + x3_x * s4;
    const double J55 = J53 * c4 + x3_y * s4;
    const double p4_x = p3_x - v2 * d4;
    const double p4_y = p3_y + J54 * d4;
    const double p4_z = p3_z + J64 * d4;
    const double J65 = cat2 * c4 - v1 * s4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v3 = v2 * c5 + (x3_x * c4 - J43 * s4) * s5;
    const double J56 = J54 * c5 - (x3_y * c4 - J53 * s4) * s5;
    const double J66 = J64 * c5 + (v1 * c4 + cat2 * s4) * s5;
    const double J21 = p4_x - v3 * d6;
    const double p6_y = p4_y + J56 * d6;
    const double p6_z = p4_z + J66 * d6;
    const double v4 = J21 - p2_x;
    const double v5 = p6_y - p2_y;
    const double v6 = p6_z - g1;
    const double J13 = J53 * v6 - cat2 * v5;
    const double J23 = cat2 * v4 - J43 * v6;
    const double J33 = J43 * v5 - J53 * v4;
    const double v7 = J21 - p3_x;
    const double v8 = p6_y - p3_y;
    const double v9 = p6_z - p3_z;
    const double J14 = J54 * v9 - J64 * v8;
    const double J24 = J64 * v7 + v2 * v9;
    const double v10 = J21 - p4_x;
    const double v11 = p6_y - p4_y;
    const double v12 = p6_z - p4_z;
    const double J15 = J55 * v12 - J65 * v11;
    const double J25 = J65 * v10 - J45 * v12;
    const double J35 = J45 * v11 - J55 * v10;
    const double J16 = J56 * v12 - J66 * v11;
    const double J26 = J66 * v10 + v3 * v12;
    J[0] = -p6_y; J[1] = -s1; J[2] = J13; J[3] = J14; J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = c1; J[8] = J23; J[9] = J24; J[10] = J25; J[11] = J26;
    J[12] = 0.0; J[13] = 0.0; J[14] = J33; J[15] = -(v2 * v8 + J54 * v7); J[16] = J35;
    J[17] = -(v3 * v11 + J56 * v10);
    J[18] = 0.0; J[19] = 0.0; J[20] = J43; J[21] = -v2; J[22] = J45; J[23] = -v3;
    J[24] = 0.0; J[25] = 0.0; J[26] = J53; J[27] = J54; J[28] = J55; J[29] = J56;
    J[30] = 1.0; J[31] = 0.0; J[32] = cat2; J[33] = J64; J[34] = J65; J[35] = J66;
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

    /* theta1, type 2: U2 A6^-1 [3, 4] */
    const double wy = T24 - T23 * d6;
    const double v1 = wy * sat2;
    const double wx = T14 - d6 * T13;
    const double v2 = sat2 * wx;
    const double wz = T34 - d6 * T33;
    const double Z1 = wz * cat2 - k1;
    const double N1 = v1 * v1 + v2 * v2;
    const double D1 = N1 - Z1 * Z1;
    const int free1 = N1 <= free_limit_squared2;
    const double v3 = 2.0 * fabs(Z1);
    const int apart1 = merge_slack1 * (v3 + merge_slack1) < D1;
    if (!(-(reach_slack1 * (v3 + reach_slack1)) <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v4 = v1 * Z1;
    const double v5 = v2 * Z1;

    /* theta3, type 2: U0 A6^-1 [3, 4] */
    const double Z3 = wz - k4;
    const double D3 = k5 - Z3 * Z3;
    const double v6 = 2.0 * fabs(Z3);
    const int apart3 = merge_slack1 * (merge_slack1 + v6) < D3;
    if (!(-(reach_slack1 * (reach_slack1 + v6)) <= D3)) return; /* out of reach */
    const double w3 = sqrt(apart3 ? D3 : 0.0);
    const double v7 = k2 * Z3;
    const double v8 = k3 * Z3;

    /* theta4, type 2: U4[3, 3] */
    const double v12 = T13 * cat2;
    const double v13 = T23 * cat2;
    const double v14 = sat2 * T33;
    const double v17 = sat2 * T13;
    const double v18 = T23 * sat2;
    const double v19 = T33 * cat2;

    /* theta6, type 3: U4[3, 2] and U4[3, 1] */
    const double v22 = sat2 * T12;
    const double v23 = T22 * sat2;
    const double v24 = T32 * cat2;
    const double v26 = T12 * cat2;
    const double v27 = T22 * cat2;
    const double v28 = sat2 * T32;
    const double v32 = sat2 * T11;
    const double v33 = T21 * sat2;
    const double v34 = T31 * cat2;
    const double v36 = T11 * cat2;
    const double v37 = T21 * cat2;
    const double v38 = sat2 * T31;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v1 * root1 - v5);
        const double s1 = free1 ? sin(seed[0]) : -(inverse1 * (v4 + v2 * root1));
        const double q1 = atan2(s1, c1);

        /* r2, type 1: U1 A6^-1 [3, 4] */
        const double v11 = c1 * -wy + wx * s1;

        /* theta4 */
        const double v15 = c1 * v12 + s1 * v13 - v14;
        const double v16 = T13 * s1 - T23 * c1;
        const double v20 = c1 * v17 + s1 * v18 + v19;
        const double v21 = v20 * v20;

        /* theta6 */
        const double v25 = c1 * v22 + s1 * v23 + v24;
        const double v29 = c1 * v26 + s1 * v27 - v28;
        const double v30 = T22 * c1 - T12 * s1;
        const double v35 = c1 * v32 + s1 * v33 + v34;
        const double v39 = c1 * v36 + s1 * v37 - v38;
        const double v40 = T21 * c1 - T11 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip3, flip3 */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double root3 = w3 * e2;
            const double v9 = k6 * (v8 + k2 * root3);
            const double s3 = k6 * (v7 - k3 * root3);
            const double q3 = atan2(s3, -v9);

            /* r2 */
            const double v10 = a3 * s3 - d4 * v9;

            /* theta4 */
            const double X4 = v9 * v15 - s3 * -v16;
            const double w4 = sqrt(X4 * X4 + v21);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = v9 * v16 - s3 * v15;

            /* theta6 */
            const double v31 = s3 * v30 - v9 * v29;
            const double v41 = s3 * v40 - v9 * v39;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip4, flip4 */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4);
                const double s4 = free4 ? sin(seed[3]) : -(v20 * factor4);
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v35 + s4 * v41), -(c4 * v25 + s4 * v31));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = -(v10 + v11);
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? PRISMATIC_2_WRIST_FREE_JOINT :
                    PRISMATIC_2_WRIST_OK;
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
    if (!revolute[joint])
        return value;
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

int prismatic_2_wrist_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? PRISMATIC_2_WRIST_UNREACHABLE : PRISMATIC_2_WRIST_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PRISMATIC_2_WRIST_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == PRISMATIC_2_WRIST_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PRISMATIC_2_WRIST_OUT_OF_LIMITS;
        }
        count += status[row] != PRISMATIC_2_WRIST_OUT_OF_LIMITS;
    }
    return count;
}

int prismatic_2_wrist_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -PRISMATIC_2_WRIST_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (prismatic_2_wrist_ik(T, q_seed, all, status) < 0)
        return -PRISMATIC_2_WRIST_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == PRISMATIC_2_WRIST_OUT_OF_LIMITS && result < 0)
            result = -PRISMATIC_2_WRIST_OUT_OF_LIMITS;
        if (status[row] != PRISMATIC_2_WRIST_OK && status[row] != PRISMATIC_2_WRIST_FREE_JOINT)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
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

void prismatic_2_wrist_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)prismatic_2_wrist_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
