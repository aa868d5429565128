/* adept: Adept SCARA
 *
 * Inverse kinematics, generated from robots/adept.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/adept.yaml. The formulas and where they come from: adept.md.
 */
#include "adept.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 1075.0; /* joint offset 1 [mm] */
static const double l1 = 600.0; /* link length 1 [mm] */
static const double l2 = 550.0; /* link length 2 [mm] */
static const double zz = 500.0; /* z of the base frame [mm] */
static const double ez = 175.0; /* z of the tool frame [mm] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
/* square of a length that fixes no angle [mm^2] */
static const double free_limit_squared2 = 5.7599999999999994e-18;
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 0.024; /* a pose may be rounded by this [mm] */

const char *const adept_branches[1] = {
    "only",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const int revolute[3] = { 1, 1, 0 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 1.0, 1.0, 1.7361111111111112e-07 };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void adept_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T22_ = c1 * c2 - s1 * s2;
    const double T32_ = s1 * c2 + c1 * s2;
    const double T24_ = c1 * l1 + T22_ * l2;
    const double T34_ = zz + s1 * l1 + T32_ * l2;
    const double T14_ = d1 - q[2] - ez;
    T[0] = 0.0; T[1] = 0.0; T[2] = -1.0; T[3] = T14_;
    T[4] = -T32_; T[5] = T22_; T[6] = 0.0; T[7] = T24_;
    T[8] = T22_; T[9] = T32_; T[10] = 0.0; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void adept_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double p1_y = c1 * l1;
    const double p1_z = zz + s1 * l1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double J31 = p1_y + (c1 * c2 - s1 * s2) * l2;
    const double p2_z = p1_z + (s1 * c2 + c1 * s2) * l2;
    const double J21 = zz - p2_z;
    const double J32 = J31 - p1_y;
    const double J22 = p1_z - p2_z;
    J[0] = 0.0; J[1] = 0.0; J[2] = -1.0;
    J[3] = J21; J[4] = J22; J[5] = 0.0;
    J[6] = J31; J[7] = J32; J[8] = 0.0;
    J[9] = 1.0; J[10] = 1.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
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
    const double T[16], const double seed[3], double q[1][3], unsigned char status[1])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* r3, type 1: U0[3, 4] */
    const double t34 = T14 - ez * T13;
    const double r3 = d1 - t34;

    /* theta12, type 3: U0[1, 2] and U0[2, 2] */
    const double w12 = sqrt(T32 * T32 + T22 * T22);
    const int free12 = w12 <= free_limit_squared;
    const double v1 = 1.0 / (free12 ? 1.0 : w12);
    const double v2 = seed[0] + seed[1];
    const double c12 = free12 ? cos(v2) : T22 * v1;
    const double s12 = free12 ? sin(v2) : T32 * v1;

    /* theta1, type 3: U0[1, 4] and U0[2, 4] */
    const double t14 = T24 - ez * T23;
    const double v3 = c12 * l2;
    const double t24 = T34 - ez * T33 - zz;
    const double v4 = s12 * l2;
    const double v5 = l1 * (t24 - v4);
    const double v6 = l1 * (t14 - v3);
    const double w1 = sqrt(v5 * v5 + v6 * v6);
    const int free1 = w1 <= free_limit_squared2;
    const double v7 = 1.0 / (free1 ? 1.0 : w1);
    const double c1 = free1 ? cos(seed[0]) : v6 * v7;
    const double s1 = free1 ? sin(seed[0]) : v5 * v7;
    const double q1 = atan2(s1, c1);

    /* is the pose one that the arm can take? */
    if (!(fabs(t34 - (d1 - r3)) <= pose_slack1 && (fabs(1.0 + T13) <= pose_slack && (fabs(T11) <=
        pose_slack && (fabs(T12) <= pose_slack && (fabs(t24 - (v4 + l1 * s1)) <= pose_slack1 &&
        (fabs(T33) <= pose_slack && (fabs(c12 - T31) <= pose_slack && (fabs(T32 - s12) <= pose_slack
        && (fabs(t14 - (v3 + l1 * c1)) <= pose_slack1 && (fabs(T23) <= pose_slack && (fabs(T22 -
        c12) <= pose_slack && fabs(T21 + s12) <= pose_slack))))))))))))
        return; /* the arm can't take this pose */

    /* joint values */
    const double q2 = wrap(atan2(s12, c12) - q1);
    const int free1_ = free12 || free1;
    const int row = 0;
    q[row][0] = q1;
    q[row][1] = q2;
    q[row][2] = r3;
    status[row] = (free1_ || free12) ? ADEPT_FREE_JOINT : ADEPT_OK;
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

int adept_ik(const double T[16], const double *q_seed, double q[1][3], unsigned char status[1])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 1; row++) {
        status[row] = valid ? ADEPT_UNREACHABLE : ADEPT_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -ADEPT_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 1; row++) {
        if (status[row] == ADEPT_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = ADEPT_OUT_OF_LIMITS;
        }
        count += status[row] != ADEPT_OUT_OF_LIMITS;
    }
    return count;
}

int adept_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[1][3], least = HUGE_VAL;
    unsigned char status[1];
    int result = -ADEPT_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (adept_ik(T, q_seed, all, status) < 0)
        return -ADEPT_INVALID_POSE;
    for (int row = 0; row < 1; row++) {
        double distance = 0.0;
        if (status[row] == ADEPT_OUT_OF_LIMITS && result < 0)
            result = -ADEPT_OUT_OF_LIMITS;
        if (status[row] != ADEPT_OK && status[row] != ADEPT_FREE_JOINT)
            continue;
        for (int i = 0; i < 3; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 3; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void adept_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)adept_ik(T + 16 * k, NULL, (double (*)[3])(q + 3 * k), status + 1 * k);
}
