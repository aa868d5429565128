/* puma: PUMA in its reference position
 *
 * Inverse kinematics, generated from robots/puma.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma.yaml. The formulas and where they come from: puma.md.
 */
#include "puma.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double L2 = 0.4318; /* z of axis 3 [m] */
static const double D3 = 0.15005; /* x of axis 4 [m] */
static const double D4 = 0.4318; /* z of axis 5 [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 1.0274863225e-24;
static const double longest3 = 0.7458049600000001; /* square of the longest reach [m^2] */
static const double shortest3 = 0.0; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 0.7458049600001752;
static const double shortest3_reach = 0.0; /* the shortest, with what rounding adds [m^2] */
/* the longest, where branches merge [m^2] */
static const double longest3_apart = 0.7458049599999826;
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 1.0274863225e-28;
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double k1 = 0.8636; /* L2 + D4 [m] */
static const double k2 = 0.022515002499999996; /* D3^2 [m^2] */
static const double k3 = 3.041963650001027e-14; /* reach_slack1 * (2 * D3 + reach_slack1) [m^2] */
static const double k4 = 3.041963650000102e-15; /* merge_slack1 * (2 * D3 + merge_slack1) [m^2] */
static const double k5 = 0.37290248000000004; /* 2 * D4 * L2 [m^2] */
static const double k6 = 2.681666262986505; /* 1 / (2 * D4 * L2) [m^-2] */
static const double f1 = 0.8636; /* L2 + D4 [m] */
static const double g1 = 0.8636; /* L2 + D4 [m] */

const char *const puma_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };

void puma_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = s1 * s2;
    const double v1 = c1 * s2;
    const double y2_x = s1 * c2;
    const double v2 = c1 * c2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double v3 = v1 * c3 + v2 * s3;
    const double x3_z = c2 * c3 - s2 * s3;
    const double v4 = s2 * c3 + c2 * s3;
    const double v5 = x2_x * s3 - y2_x * c3;
    const double v6 = v2 * c3 - v1 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = c1 * c4 + v5 * s4;
    const double x4_y = s1 * c4 + v6 * s4;
    const double x4_z = v4 * s4;
    const double y4_z = v4 * c4;
    const double v7 = c1 * s4 - v5 * c4;
    const double v8 = s1 * s4 - v6 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double T13_ = x3_x * c5 + v7 * s5;
    const double T23_ = v8 * s5 - v3 * c5;
    const double T33_ = x3_z * c5 - y4_z * s5;
    const double y5_y = v8 * c5 + v3 * s5;
    const double v9 = y4_z * c5 + x3_z * s5;
    const double v10 = x3_x * s5 - v7 * c5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x4_x * c6 + v10 * s6;
    const double T21_ = x4_y * c6 - y5_y * s6;
    const double T31_ = x4_z * c6 + v9 * s6;
    const double T12_ = v10 * c6 - x4_x * s6;
    const double T32_ = v9 * c6 - x4_z * s6;
    const double T14_ = x2_x * L2 + c1 * D3 + x3_x * D4 - D3 * T11_ - T13_ * f1;
    const double T24_ = s1 * D3 - v1 * L2 - v3 * D4 - D3 * T21_ - T23_ * f1;
    const double T34_ = c2 * L2 + x3_z * D4 - D3 * T31_ - T33_ * f1;
    T[0] = T11_; T[1] = T12_; T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = -(y5_y * c6 + x4_y * s6); T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = s1 * s2;
    const double v1 = c1 * s2;
    const double y2_x = s1 * c2;
    const double v2 = c1 * c2;
    const double p3_x = x2_x * L2;
    const double v3 = v1 * L2;
    const double p3_z = c2 * L2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double J44 = x2_x * c3 + y2_x * s3;
    const double v4 = v1 * c3 + v2 * s3;
    const double J64 = c2 * c3 - s2 * s3;
    const double v5 = s2 * c3 + c2 * s3;
    const double p4_x = p3_x + c1 * D3;
    const double p4_y = s1 * D3 - v3;
    const double v6 = x2_x * s3 - y2_x * c3;
    const double v7 = v2 * c3 - v1 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = c1 * c4 + v6 * s4;
    const double J55 = s1 * c4 + v7 * s4;
    const double J65 = v5 * s4;
    const double y4_z = v5 * c4;
    const double p5_x = p4_x + J44 * D4;
    const double p5_y = p4_y - v4 * D4;
    const double p5_z = p3_z + J64 * D4;
    const double v8 = c1 * s4 - v6 * c4;
    const double v9 = s1 * s4 - v7 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J46 = J44 * c5 + v8 * s5;
    const double J56 = v9 * s5 - v4 * c5;
    const double J66 = J64 * c5 - y4_z * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double J21 = p5_x - D3 * (J45 * c6 + (J44 * s5 - v8 * c5) * s6) - J46 * g1;
    const double v10 = p5_y - D3 * (J55 * c6 - (v9 * c5 + v4 * s5) * s6) - J56 * g1;
    const double v11 = p5_z - D3 * (J65 * c6 + (y4_z * c5 + J64 * s5) * s6) - J66 * g1;
    const double J12 = s1 * v11;
    const double J32 = c1 * v10 - s1 * J21;
    const double v12 = v11 - p3_z;
    const double J13 = s1 * v12;
    const double J33 = c1 * (v3 + v10) - s1 * (J21 - p3_x);
    const double v13 = J21 - p4_x;
    const double v14 = v10 - p4_y;
    const double J24 = J64 * v13 - J44 * v12;
    const double J34 = J44 * v14 + v4 * v13;
    const double v15 = J21 - p5_x;
    const double v16 = v10 - p5_y;
    const double v17 = v11 - p5_z;
    const double J15 = J55 * v17 - J65 * v16;
    const double J25 = J65 * v15 - J45 * v17;
    const double J35 = J45 * v16 - J55 * v15;
    const double J16 = J56 * v17 - J66 * v16;
    const double J26 = J66 * v15 - J46 * v17;
    const double J36 = J46 * v16 - J56 * v15;
    J[0] = -v10; J[1] = J12; J[2] = J13; J[3] = -(v4 * v12 + J64 * v14); J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = -(c1 * v11); J[8] = -(c1 * v12); J[9] = J24; J[10] = J25; J[11] = J26;
    J[12] = 0.0; J[13] = J32; J[14] = J33; J[15] = J34; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = c1; J[20] = c1; J[21] = J44; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = s1; J[26] = s1; J[27] = -v4; J[28] = J55; J[29] = J56;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = J64; J[34] = J65; J[35] = J66;
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

    /* theta1, type 2: U1[1, 4] */
    const double t24 = T24 + D3 * T21 + k1 * T23;
    const double t14 = T14 + D3 * T11 + k1 * T13;
    const double N1 = t24 * t24 + t14 * t14;
    const double D1 = N1 - k2;
    const int free1 = N1 <= free_limit_squared2;
    const int apart1 = k4 < D1;
    if (!(-k3 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v1 = D3 * t24;
    const double v2 = D3 * t14;

    /* theta3, type 8: U1[3, 4] and U1[2, 4] */
    const double t34 = T34 + D3 * T31 + k1 * T33;
    const double v3 = t34 * t34;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v2 + t24 * root1);
        const double s1 = free1 ? sin(seed[0]) : inverse1 * (v1 - t14 * root1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double N3 = v3 + root1 * root1;
        const double K3 = N3 - k5;
        const double D3_ = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_ : 0.0);
        const double c3 = K3 * k6;

        /* theta2, type 3: U1[3, 4] and U1[2, 4] */
        const double Y1_2 = L2 + D4 * c3;
        const double v5 = root1 * Y1_2;
        const double v7 = t34 * Y1_2;

        /* theta4, type 2: U4[1, 3] */
        const double v8 = T13 * s1 - T23 * c1;
        const double v9 = T13 * c1 + T23 * s1;
        const double v10 = v9 * v9;

        /* theta6, type 3: U4[1, 2] and U4[1, 1] */
        const double v11 = T12 * c1 + T22 * s1;
        const double v12 = T12 * s1 - T22 * c1;
        const double v14 = T11 * c1 + T21 * s1;
        const double v15 = T11 * s1 - T21 * c1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e2 * k6;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double v4 = D4 * s3;
            const double v6 = t34 * v4 + v5;
            const double C2 = v7 - root1 * v4;
            const double w2 = sqrt(v6 * v6 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2;
            const double s2 = free2 ? sin(seed[1]) : -(v6 * factor2);
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2;
            const double s23 = c3 * s2 + s3 * c2;
            const double X4 = c23 * v8 - T33 * s23;
            const double w4 = sqrt(X4 * X4 + v10);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[3, 3] and U4[2, 3] */
            const double c5 = T33 * c23 + s23 * v8;

            /* theta6 */
            const double v13 = T32 * s23 - c23 * v12;
            const double v16 = T31 * s23 - c23 * v15;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4);
                const double s4 = free4 ? sin(seed[3]) : -(v9 * factor4);
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6 */
                const double c6 = c4 * v14 + s4 * v16;
                const double q6 = atan2(-(c4 * v11 + s4 * v13), c6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? PUMA_FREE_JOINT : PUMA_OK;
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

int puma_ik(const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? PUMA_UNREACHABLE : PUMA_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PUMA_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == PUMA_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PUMA_OUT_OF_LIMITS;
        }
        count += status[row] != PUMA_OUT_OF_LIMITS;
    }
    return count;
}

int puma_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -PUMA_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (puma_ik(T, q_seed, all, status) < 0)
        return -PUMA_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == PUMA_OUT_OF_LIMITS && result < 0)
            result = -PUMA_OUT_OF_LIMITS;
        if (status[row] != PUMA_OK && status[row] != PUMA_FREE_JOINT)
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

void puma_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)puma_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
