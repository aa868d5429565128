/* craig_417: Arm of exercise 4.17 in Craig, Introduction to Robotics
 *
 * Inverse kinematics, generated from robots/craig_417.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/craig_417.yaml. The formulas and where they come from:
 * craig_417.md.
 */
#include "craig_417.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double sqrt2 = 1.4142135623730951; /* square root of 2 */
static const double d4 = 1.0; /* joint offset 4 [m] */
static const double a3 = 1.0; /* link length 4 [m] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double free_limit_squared2 = 9e-24; /* square of a length that fixes no angle [m^2] */
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 3.0000000000000004e-05; /* a pose may be rounded by this [m] */
static const double k1 = 0.5; /* 1 / 2 */
static const double k2 = 0.7071067811865476; /* sqrt2 * 1 / 2 */
static const double k3 = 0.5000000000000001; /* (sqrt2 * 1 / 2)^2 */
/* reach_slack * (2 * sqrt2 * 1 / 2 + reach_slack) */
static const double k4 = 1.4142135623731953e-13;
/* merge_slack * (2 * sqrt2 * 1 / 2 + merge_slack) */
static const double k5 = 1.4142135623731051e-14;
static const double k6 = 2.0; /* d3 + d4 [m] */
static const double k7 = 2.8284271247461903; /* sqrt2 * (d3 + d4) [m] */
static const double f1 = 0.7071067811865476; /* 1 / 2 * sqrt2 */
static const double g1 = 0.7071067811865476; /* 1 / 2 * sqrt2 */

const char *const craig_417_branches[2] = {
    "left", "right",
};

static const double lowest[4] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[4] = { INFINITY, INFINITY, INFINITY, INFINITY };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void craig_417_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2 * f1;
    const double v2 = s1 * s2 * f1;
    const double T33_ = c2 * f1;
    const double v3 = s1 * f1;
    const double T13_ = v1 - v3;
    const double v4 = c1 * f1;
    const double T23_ = v2 + v4;
    const double v5 = v1 + v3;
    const double v6 = v4 - v2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 - v5 * s3;
    const double x3_y = x2_y * c3 + v6 * s3;
    const double v7 = s2 * c3 + T33_ * s3;
    const double v8 = v5 * c3 + x2_x * s3;
    const double y3_y = v6 * c3 - x2_y * s3;
    const double y3_z = s2 * s3 - T33_ * c3;
    const double T14_ = T13_ + x3_x * a3 + T13_ * d4;
    const double T24_ = T23_ + x3_y * a3 + T23_ * d4;
    const double T34_ = T33_ - v7 * a3 + T33_ * d4;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double T11_ = x3_x * c4 - v8 * s4;
    const double T21_ = x3_y * c4 + y3_y * s4;
    const double T31_ = y3_z * s4 - v7 * c4;
    const double T22_ = y3_y * c4 - x3_y * s4;
    const double T32_ = y3_z * c4 + v7 * s4;
    T[0] = T11_; T[1] = -(v8 * c4 + x3_x * s4); T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void craig_417_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v1 = c1 * s2 * g1;
    const double v2 = s1 * s2 * g1;
    const double J63 = c2 * g1;
    const double v3 = s1 * g1;
    const double J43 = v1 - v3;
    const double v4 = c1 * g1;
    const double J53 = v2 + v4;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double J21 = J43 + (c1 * c2 * c3 - (v1 + v3) * s3) * a3 + J43 * d4;
    const double p4_y = J53 + (s1 * c2 * c3 + (v4 - v2) * s3) * a3 + J53 * d4;
    const double p4_z = J63 - (s2 * c3 + J63 * s3) * a3 + J63 * d4;
    const double J12 = c1 * p4_z;
    const double J22 = s1 * p4_z;
    const double v5 = J21 - J43;
    const double v6 = p4_y - J53;
    const double v7 = p4_z - J63;
    const double J13 = J53 * v7 - J63 * v6;
    const double J23 = J63 * v5 - J43 * v7;
    const double J33 = J43 * v6 - J53 * v5;
    J[0] = -p4_y; J[1] = J12; J[2] = J13; J[3] = 0.0;
    J[4] = J21; J[5] = J22; J[6] = J23; J[7] = 0.0;
    J[8] = 0.0; J[9] = -(s1 * p4_y + c1 * J21); J[10] = J33; J[11] = 0.0;
    J[12] = 0.0; J[13] = -s1; J[14] = J43; J[15] = J43;
    J[16] = 0.0; J[17] = c1; J[18] = J53; J[19] = J53;
    J[20] = 1.0; J[21] = 0.0; J[22] = J63; J[23] = J63;
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
    const double T[16], const double seed[4], double q[2][4], unsigned char status[2])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta1, type 2: U1[2, 3] */
    const double N1 = T13 * T13 + T23 * T23;
    const double D1 = N1 - k3;
    const int free1 = N1 <= free_limit_squared;
    const int apart1 = k5 < D1;
    if (!(-k4 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v1 = T13 * k2;
    const double v2 = T23 * k2;

    /* theta2, type 3: U1[3, 3] and U1[1, 3] */
    const double v3 = k2 * T33;
    const double v4 = v3 * v3;

    /* theta34, type 3: U1[2, 2] and U1[2, 1] */
    const double v9 = seed[2] + seed[3];

    /* theta3, type 3: U2[3, 4] and U2[1, 4] */
    const double v10 = 2.0 * T24;
    const double v11 = 2.0 * T14;
    const double v13 = k2 < 0.0 ? -1.0 : 1.0;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v2 - T13 * root1);
        const double s1 = free1 ? sin(seed[0]) : -(inverse1 * (v1 + T23 * root1));
        const double q1 = atan2(s1, c1);

        /* theta2 */
        const double S2 = k2 * root1;
        const double w2 = sqrt(S2 * S2 + v4);
        const int free2 = w2 <= free_limit_squared;
        const double v5 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : v3 * v5;
        const double s2 = free2 ? sin(seed[1]) : -(S2 * v5);
        const double q2 = atan2(s2, c2);

        /* theta34 */
        const double v6 = k2 * (T21 * c1 - T11 * s1);
        const double v7 = k2 * (T22 * c1 - T12 * s1);
        const double w34 = sqrt(v6 * v6 + v7 * v7);
        const int free34 = w34 <= free_limit_squared;
        const double v8 = 1.0 / (free34 ? 1.0 : w34);
        const double c34 = free34 ? cos(v9) : v7 * v8;
        const double s34 = free34 ? sin(v9) : v6 * v8;

        /* theta3 */
        const double v12 = a3 * (k1 * (s1 * v11 - c1 * v10 + k7));
        const double C3 = k2 * (c2 * (c1 * T14 + s1 * T24) - s2 * T34);
        const double w3 = sqrt(v12 * v12 + C3 * C3);
        const int free3 = w3 <= free_limit_squared2;
        const double factor3 = v13 / (free3 ? 1.0 : w3);
        const double c3 = free3 ? cos(seed[2]) : C3 * factor3;
        const double s3 = free3 ? sin(seed[2]) : -(v12 * factor3);
        const double q3 = atan2(s3, c3);

        /* is the pose one that the arm can take? */
        const double v14 = c1 * c2;
        const double v15 = 2.0 * v14;
        const double v16 = c1 * s2;
        const double v17 = sqrt2 * (s1 + v16);
        const double v18 = c1 * k6;
        const double v19 = s1 * k6;
        const double v20 = s1 * c2;
        const double v21 = 2.0 * v20;
        const double v22 = s1 * s2;
        const double v23 = sqrt2 * (c1 - v22);
        const double v24 = 2.0 * s2;
        const double v25 = sqrt2 * c2;
        if (!(fabs(T34 - k1 * (sqrt2 * (c2 * k6) - (c3 * (2.0 * (s2 * a3)) + s3 * (a3 * v25)))) <=
            pose_slack1 && (fabs(T33 - k1 * v25) <= pose_slack && (fabs(T32 - k1 * (s34 * v24 - c34
            * v25)) <= pose_slack && (fabs(T31 + k1 * (c34 * v24 + s34 * v25)) <= pose_slack &&
            (fabs(T24 - k1 * (c3 * (2.0 * (a3 * v20)) + s3 * (a3 * v23) + sqrt2 * (v18 + s2 * v19)))
            <= pose_slack1 && (fabs(T23 - k1 * (sqrt2 * (c1 + v22))) <= pose_slack && (fabs(T22 - k1
            * (c34 * v23 - s34 * v21)) <= pose_slack && (fabs(T21 - k1 * (c34 * v21 + s34 * v23)) <=
            pose_slack && (fabs(T14 - k1 * (c3 * (2.0 * (a3 * v14)) - s3 * (a3 * v17) + sqrt2 * (s2
            * v18 - v19))) <= pose_slack1 && (fabs(T13 - k1 * (sqrt2 * (v16 - s1))) <= pose_slack &&
            (fabs(T11 - k1 * (c34 * v15 - s34 * v17)) <= pose_slack && fabs(T12 + k1 * (c34 * v17 +
            s34 * v15)) <= pose_slack))))))))))))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = wrap(atan2(s34, c34) - q3);
        const int free3_ = free34 || free3;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = q3;
        q[row][3] = q4;
        status[row] = (free1 || free2 || free3_ || free34) ? CRAIG_417_FREE_JOINT : CRAIG_417_OK;
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

int craig_417_ik(const double T[16], const double *q_seed, double q[2][4], unsigned char status[2])
{
    static const double zeros[4] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? CRAIG_417_UNREACHABLE : CRAIG_417_INVALID_POSE;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -CRAIG_417_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == CRAIG_417_UNREACHABLE)
            continue;
        for (int i = 0; i < 4; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = CRAIG_417_OUT_OF_LIMITS;
        }
        count += status[row] != CRAIG_417_OUT_OF_LIMITS;
    }
    return count;
}

int craig_417_ik_nearest(const double T[16], const double q_seed[4], double q[4])
{
    double all[2][4], least = HUGE_VAL;
    unsigned char status[2];
    int result = -CRAIG_417_UNREACHABLE;
    for (int i = 0; i < 4; i++)
        q[i] = NAN;
    if (craig_417_ik(T, q_seed, all, status) < 0)
        return -CRAIG_417_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == CRAIG_417_OUT_OF_LIMITS && result < 0)
            result = -CRAIG_417_OUT_OF_LIMITS;
        if (status[row] != CRAIG_417_OK && status[row] != CRAIG_417_FREE_JOINT)
            continue;
        for (int i = 0; i < 4; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 4; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void craig_417_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)craig_417_ik(T + 16 * k, NULL, (double (*)[4])(q + 8 * k), status + 2 * k);
}
