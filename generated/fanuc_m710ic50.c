/* fanuc_m710ic50: Fanuc M-710iC/50
 *
 * Inverse kinematics, generated from robots/fanuc_m710ic50.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/fanuc_m710ic50.yaml. The formulas and where they come from:
 * fanuc_m710ic50.md.
 */
#include "fanuc_m710ic50.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.565; /* joint offset 1 [m] */
static const double a1 = 0.15; /* link length 1 [m] */
static const double a2 = 0.87; /* link length 2 [m] */
static const double a3 = 0.17; /* link length 3 [m] */
static const double d4 = 1.016; /* joint offset 4 [m] */
static const double d6 = 0.175; /* z of the tool frame [m] */
static const double free_limit1 = 2.9459999999999998e-12; /* a length that fixes no angle [m] */
static const double longest3 = 3.61047221996678; /* square of the longest reach [m^2] */
static const double shortest3 = 0.025639780033220066; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 3.6104722199679;
/* the shortest, with what rounding adds [m^2] */
static const double shortest3_reach = 0.025639780033125722;
/* the longest, where branches merge [m^2] */
static const double longest3_apart = 3.610472219966668;
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 0.025639780033229496;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 8.678915999999998e-24;
static const double offset2 = -1.5707963267948966; /* offset of joint 2 [rad] */
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double offset5 = 3.141592653589793; /* offset of joint 5 [rad] */
static const double k1 = 1.76784; /* 2 * d4 * a2 [m^2] */
static const double k2 = 0.2958; /* 2 * a3 * a2 [m^2] */
static const double k3 = 1.8180560000000001; /* a2^2 + (a3^2 + d4^2) [m^2] */
static const double k4 = 0.31125925198890714; /* 1 / ((2 * d4 * a2)^2 + (2 * a3 * a2)^2) [m^-4] */

const char *const fanuc_m710ic50_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = { -3.1415, -1.5707, -2.7925, -6.283, -2.1816, -6.2831 };
static const double highest[6] = { 3.1415, 2.3561, 4.8869, 6.283, 2.1816, 6.2831 };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void fanuc_m710ic50_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v1 = q[1] + offset2;
    const double c2 = cos(v1);
    const double s2 = sin(v1);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double y2_x = c1 * s2;
    const double y2_y = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double x3_y = x2_y * c3 + y2_y * s3;
    const double x3_z = c2 * s3 - s2 * c3;
    const double z3_x = y2_x * c3 - x2_x * s3;
    const double z3_y = y2_y * c3 - x2_y * s3;
    const double z3_z = c2 * c3 + s2 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = x3_x * c4 - s1 * s4;
    const double x4_y = x3_y * c4 + c1 * s4;
    const double x4_z = x3_z * c4;
    const double z4_x = s1 * c4 + x3_x * s4;
    const double z4_z = x3_z * s4;
    const double z4_y = x3_y * s4 - c1 * c4;
    const double v2 = q[4] + offset5;
    const double c5 = cos(v2);
    const double s5 = sin(v2);
    const double x5_x = x4_x * c5 + z3_x * s5;
    const double x5_y = x4_y * c5 + z3_y * s5;
    const double x5_z = x4_z * c5 + z3_z * s5;
    const double T11_ = z3_x * c5 - x4_x * s5;
    const double T21_ = z3_y * c5 - x4_y * s5;
    const double T31_ = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T14_ = c1 * a1 + x2_x * a2 + x3_x * a3 - z3_x * d4 - -T11_ * d6;
    const double T24_ = s1 * a1 + x2_y * a2 + x3_y * a3 - z3_y * d4 - -T21_ * d6;
    const double T34_ = d1 - s2 * a2 + x3_z * a3 - z3_z * d4 - -T31_ * d6;
    const double T12_ = x5_x * s6 - z4_x * c6;
    const double T22_ = x5_y * s6 - z4_y * c6;
    const double T32_ = x5_z * s6 - z4_z * c6;
    T[0] = T11_; T[1] = T12_; T[2] = -(x5_x * c6 + z4_x * s6); T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = -(x5_y * c6 + z4_y * s6); T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = -(x5_z * c6 + z4_z * s6); T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void fanuc_m710ic50_jacobian(const double q[6], double J[36])
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
    const double y2_x = c1 * s2;
    const double y2_y = s1 * s2;
    const double p2_x = p1_x + x2_x * a2;
    const double p2_y = p1_y + x2_y * a2;
    const double p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double x3_y = x2_y * c3 + y2_y * s3;
    const double x3_z = c2 * s3 - s2 * c3;
    const double J44 = y2_x * c3 - x2_x * s3;
    const double J54 = y2_y * c3 - x2_y * s3;
    const double J64 = c2 * c3 + s2 * s3;
    const double p3_x = p2_x + x3_x * a3;
    const double p3_y = p2_y + x3_y * a3;
    const double p3_z = p2_z + x3_z * a3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = s1 * c4 + x3_x * s4;
    const double J65 = x3_z * s4;
    const double p4_x = p3_x - J44 * d4;
    const double p4_y = p3_y - J54 * d4;
    const double p4_z = p3_z - J64 * d4;
    const double J55 = x3_y * s4 - c1 * c4;
    const double v2 = q[4] + offset5;
    const double c5 = cos(v2);
    const double s5 = sin(v2);
    const double J46 = (x3_x * c4 - s1 * s4) * s5 - J44 * c5;
    const double J56 = (x3_y * c4 + c1 * s4) * s5 - J54 * c5;
    const double J66 = x3_z * c4 * s5 - J64 * c5;
    const double J21 = p4_x - J46 * d6;
    const double v3 = p4_y - J56 * d6;
    const double v4 = p4_z - J66 * d6;
    const double v5 = v4 - d1;
    const double J12 = c1 * v5;
    const double J22 = s1 * v5;
    const double v6 = v4 - p2_z;
    const double J33 = s1 * (v3 - p2_y) + c1 * (J21 - p2_x);
    const double v7 = J21 - p3_x;
    const double v8 = v3 - p3_y;
    const double v9 = v4 - p3_z;
    const double J14 = J54 * v9 - J64 * v8;
    const double J24 = J64 * v7 - J44 * v9;
    const double J34 = J44 * v8 - J54 * v7;
    const double v10 = J21 - p4_x;
    const double v11 = v3 - p4_y;
    const double v12 = v4 - p4_z;
    const double J15 = J55 * v12 - J65 * v11;
    const double J25 = J65 * v10 - J45 * v12;
    const double J35 = J45 * v11 - J55 * v10;
    const double J16 = J56 * v12 - J66 * v11;
    const double J26 = J66 * v10 - J46 * v12;
    const double J36 = J46 * v11 - J56 * v10;
    J[0] = -v3; J[1] = J12; J[2] = -(c1 * v6); J[3] = J14; J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = J22; J[8] = -(s1 * v6); J[9] = J24; J[10] = J25; J[11] = J26;
    J[12] = 0.0; J[13] = -(s1 * (v3 - p1_y) + c1 * (J21 - p1_x)); J[14] = J33; J[15] = J34;
    J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = -s1; J[20] = s1; J[21] = J44; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = c1; J[26] = -c1; J[27] = J54; J[28] = J55; J[29] = J56;
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
    const double t14 = T14 - d6 * T11;
    const double Y1 = d6 * T21 - T24;
    const double w1 = sqrt(t14 * t14 + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double t34 = T34 - d6 * T31;
    const double Z1_3 = t34 - d1;
    const double v2 = Z1_3 * Z1_3;

    /* theta2, type 3: U1[1, 4] and U1[2, 4] */
    const double v6 = seed[1] + offset2;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(t14 * factor1);
        const double s1 = free1 ? sin(seed[0]) : Y1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v1 = w1 * e1 + a1;
        const double N3 = v2 + v1 * v1;
        const double K3 = N3 - k3;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v3 = k1 * K3;
        const double v4 = k2 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v7 = T11 * c1 + T21 * s1;
        const double Y4 = T11 * s1 - T21 * c1;
        const double v8 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v9 = T22 * c1 - T12 * s1;
        const double v10 = T12 * c1 + T22 * s1;
        const double v12 = T23 * c1 - T13 * s1;
        const double v13 = T13 * c1 + T23 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double root3 = w3 * e2;
            const double s3 = (v3 + k2 * root3) * k4;
            const double c3 = k4 * (v4 - k1 * root3);
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double X1_2 = a3 * s3 - d4 * c3;
            const double Y1_2 = a2 + (a3 * c3 + d4 * s3);
            const double v5 = v1 * X1_2 + Z1_3 * Y1_2;
            const double C2 = Z1_3 * X1_2 - v1 * Y1_2;
            const double w2 = sqrt(v5 * v5 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v6) : C2 * factor2;
            const double s2 = free2 ? sin(v6) : -(v5 * factor2);

            /* theta4 */
            const double c2m3 = c3 * c2 + s3 * s2;
            const double s2m3 = c3 * s2 - s3 * c2;
            const double X4 = c2m3 * v7 - T31 * s2m3;
            const double w4 = sqrt(X4 * X4 + v8);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T31 * c2m3 + s2m3 * v7;

            /* theta6 */
            const double v11 = T32 * s2m3 - c2m3 * v10;
            const double v14 = T33 * s2m3 - c2m3 * v13;

            /* joint values */
            const double q2 = wrap(atan2(s2, c2) - offset2);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4);
                const double s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);
                const double s5 = w4 * e3;

                /* theta6 */
                const double c6 = c4 * v9 + s4 * v11;
                const double s6 = c4 * v12 + s4 * v14;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q5 = wrap(atan2(s5, c5) - offset5);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? FANUC_M710IC50_FREE_JOINT :
                    FANUC_M710IC50_OK;
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

int fanuc_m710ic50_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? FANUC_M710IC50_UNREACHABLE : FANUC_M710IC50_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -FANUC_M710IC50_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == FANUC_M710IC50_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = FANUC_M710IC50_OUT_OF_LIMITS;
        }
        count += status[row] != FANUC_M710IC50_OUT_OF_LIMITS;
    }
    return count;
}

int fanuc_m710ic50_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -FANUC_M710IC50_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (fanuc_m710ic50_ik(T, q_seed, all, status) < 0)
        return -FANUC_M710IC50_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == FANUC_M710IC50_OUT_OF_LIMITS && result < 0)
            result = -FANUC_M710IC50_OUT_OF_LIMITS;
        if (status[row] != FANUC_M710IC50_OK && status[row] != FANUC_M710IC50_FREE_JOINT)
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

void fanuc_m710ic50_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)fanuc_m710ic50_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
