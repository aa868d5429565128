/* puma560: Unimation PUMA 560
 *
 * Inverse kinematics, generated from robots/puma560.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma560.yaml. The formulas and where they come from: puma560.md.
 */
#include "puma560.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.67183; /* joint offset 1 [m] */
static const double a2 = 0.4318; /* link length 2 [m] */
static const double d3 = 0.15005; /* joint offset 3 [m] */
static const double a3 = 0.0203; /* link length 3 [m] */
static const double d4 = 0.4318; /* joint offset 4 [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 2.9096854084e-24;
static const double longest3 = 0.7466289125534531; /* square of the longest reach [m^2] */
static const double shortest3 = 2.274465470660925e-07; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 0.7466289125537477;
/* the shortest, with what rounding adds [m^2] */
static const double shortest3_reach = 2.2744654690339056e-07;
/* the longest, where branches merge [m^2] */
static const double longest3_apart = 0.7466289125534236;
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 2.2744654708236271e-07;
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double k1 = 0.022515002499999996; /* d3^2 [m^2] */
static const double k2 = 5.11904578000291e-14; /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
static const double k3 = 5.1190457800002905e-15; /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
static const double k4 = 0.37290248000000004; /* 2 * d4 * a2 [m^2] */
static const double k5 = 0.01753108; /* 2 * a3 * a2 [m^2] */
static const double k6 = 0.37331457; /* d4 * a2 + (a3^2 + d4 * a2) [m^2] */
static const double k7 = 7.175474885806929; /* 1 / ((2 * d4 * a2)^2 + (2 * a3 * a2)^2) [m^-4] */

const char *const puma560_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -2.792526803190927, -1.9198621771937625, -2.356194490192345, -4.642575810304916,
    -1.7453292519943295, -4.642575810304916,
};
static const double highest[6] = {
    2.792526803190927, 1.9198621771937625, 2.356194490192345, 4.642575810304916, 1.7453292519943295,
    4.642575810304916,
};

void puma560_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 - v1 * s3;
    const double x3_y = x2_y * c3 - v2 * s3;
    const double x3_z = s2 * c3 + c2 * s3;
    const double v3 = v1 * c3 + x2_x * s3;
    const double v4 = v2 * c3 + x2_y * s3;
    const double z3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = x3_x * c4 - s1 * s4;
    const double x4_y = x3_y * c4 + c1 * s4;
    const double x4_z = x3_z * c4;
    const double z4_x = s1 * c4 + x3_x * s4;
    const double y5_y = c1 * c4 - x3_y * s4;
    const double z4_z = x3_z * s4;
    const double T14_ = x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4;
    const double T24_ = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4;
    const double T34_ = d1 + s2 * a2 + x3_z * a3 + z3_z * d4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5 - v3 * s5;
    const double x5_y = x4_y * c5 - v4 * s5;
    const double x5_z = x4_z * c5 + z3_z * s5;
    const double T33_ = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 - z4_x * s6;
    const double T21_ = x5_y * c6 + y5_y * s6;
    const double T31_ = x5_z * c6 - z4_z * s6;
    const double T22_ = y5_y * c6 - x5_y * s6;
    T[0] = T11_; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = -(v3 * c5 + x4_x * s5); T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = -(v4 * c5 + x4_y * s5); T[7] = T24_;
    T[8] = T31_; T[9] = -(z4_z * c6 + x5_z * s6); T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma560_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double p2_x = x2_x * a2;
    const double p2_y = x2_y * a2;
    const double p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 - v1 * s3;
    const double x3_y = x2_y * c3 - v2 * s3;
    const double x3_z = s2 * c3 + c2 * s3;
    const double v3 = v1 * c3 + x2_x * s3;
    const double v4 = v2 * c3 + x2_y * s3;
    const double J64 = c2 * c3 - s2 * s3;
    const double p3_z = p2_z + x3_z * a3;
    const double p3_x = p2_x + x3_x * a3 + s1 * d3;
    const double p3_y = p2_y + x3_y * a3 - c1 * d3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = s1 * c4 + x3_x * s4;
    const double J65 = x3_z * s4;
    const double J21 = p3_x - v3 * d4;
    const double p4_y = p3_y - v4 * d4;
    const double p4_z = p3_z + J64 * d4;
    const double J55 = x3_y * s4 - c1 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J66 = J64 * c5 - x3_z * c4 * s5;
    const double v5 = p4_z - d1;
    const double J32 = s1 * p4_y + c1 * J21;
    const double v6 = p4_z - p2_z;
    const double J33 = s1 * (p4_y - p2_y) + c1 * (J21 - p2_x);
    const double v7 = J21 - p3_x;
    const double v8 = p4_y - p3_y;
    const double v9 = p4_z - p3_z;
    const double J24 = J64 * v7 + v3 * v9;
    const double J34 = v4 * v7 - v3 * v8;
    J[0] = -p4_y; J[1] = -(c1 * v5); J[2] = -(c1 * v6); J[3] = -(v4 * v9 + J64 * v8); J[4] = 0.0;
    J[5] = 0.0;
    J[6] = J21; J[7] = -(s1 * v5); J[8] = -(s1 * v6); J[9] = J24; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = J32; J[14] = J33; J[15] = J34; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = -v3; J[22] = J45;
    J[23] = -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5);
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -v4; J[28] = J55;
    J[29] = -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5);
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

    /* theta1, type 2: U1[3, 4] */
    const double N1 = T14 * T14 + T24 * T24;
    const double D1 = N1 - k1;
    const int free1 = N1 <= free_limit_squared2;
    const int apart1 = k3 < D1;
    if (!(-k2 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v1 = T14 * d3;
    const double v2 = T24 * d3;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - d1;
    const double v3 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (T14 * root1 - v2);
        const double s1 = free1 ? sin(seed[0]) : inverse1 * (v1 + T24 * root1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double N3 = v3 + root1 * root1;
        const double K3 = N3 - k6;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v4 = k4 * K3;
        const double v5 = k5 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v6 = T13 * c1 + T23 * s1;
        const double Y4 = T23 * c1 - T13 * s1;
        const double v8 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v9 = T12 * s1 - T22 * c1;
        const double v10 = T12 * c1 + T22 * s1;
        const double v12 = T11 * s1 - T21 * c1;
        const double v13 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double root3 = w3 * e2;
            const double s3 = (k5 * root3 - v4) * k7;
            const double c3 = k7 * (v5 + k4 * root3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + (a3 * c3 - d4 * s3);
            const double Y1_2 = d4 * c3 + a3 * s3;
            const double S2 = Z1_3 * X1_2 - root1 * Y1_2;
            const double C2 = root1 * X1_2 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2;
            const double s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2;
            const double s23 = c3 * s2 + s3 * c2;
            const double v7 = c23 * v6 + T33 * s23;
            const double w4 = sqrt(v7 * v7 + v8);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c23 - s23 * v6;

            /* theta6 */
            const double v11 = c23 * v10 + T32 * s23;
            const double v14 = c23 * v13 + T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : v7 * factor4;
                const double s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v12 + s4 * v14), -(c4 * v9 + s4 * v11));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? PUMA560_FREE_JOINT : PUMA560_OK;
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

int puma560_ik(const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? PUMA560_UNREACHABLE : PUMA560_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PUMA560_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == PUMA560_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PUMA560_OUT_OF_LIMITS;
        }
        count += status[row] != PUMA560_OUT_OF_LIMITS;
    }
    return count;
}

int puma560_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -PUMA560_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (puma560_ik(T, q_seed, all, status) < 0)
        return -PUMA560_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == PUMA560_OUT_OF_LIMITS && result < 0)
            result = -PUMA560_OUT_OF_LIMITS;
        if (status[row] != PUMA560_OK && status[row] != PUMA560_FREE_JOINT)
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

void puma560_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)puma560_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
