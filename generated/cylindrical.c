/* cylindrical: Cylindrical arm, vertical slide first
 *
 * Inverse kinematics, generated from robots/cylindrical.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cylindrical.yaml. The formulas and where they come from:
 * cylindrical.md.
 */
#include "cylindrical.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.3; /* joint offset 1 [m] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 3e-06; /* a pose may be rounded by this [m] */

const char *const cylindrical_branches[1] = {
    "only",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const int revolute[3] = { 1, 0, 0 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 1.0, 11.11111111111111, 11.11111111111111 };

void cylindrical_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double T34_ = d1 + q[1];
    const double T24_ = c1 * q[2];
    T[0] = c1; T[1] = 0.0; T[2] = -s1; T[3] = -(s1 * q[2]);
    T[4] = s1; T[5] = 0.0; T[6] = c1; T[7] = T24_;
    T[8] = 0.0; T[9] = -1.0; T[10] = 0.0; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void cylindrical_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    J[0] = -(c1 * q[2]); J[1] = 0.0; J[2] = -s1;
    J[3] = -(s1 * q[2]); J[4] = 0.0; J[5] = c1;
    J[6] = 0.0; J[7] = 1.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
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

    /* r2, type 1: U0[3, 4] */
    const double r2 = T34 - d1;

    /* theta1, type 3: U0[1, 3] and U0[2, 3] */
    const double w1 = sqrt(T21 * T21 + T11 * T11);
    const int free1 = w1 <= free_limit_squared;
    const double v1 = 1.0 / (free1 ? 1.0 : w1);
    const double c1 = free1 ? cos(seed[0]) : T11 * v1;
    const double s1 = free1 ? sin(seed[0]) : T21 * v1;
    const double q1 = atan2(s1, c1);

    /* r3, type 1: U1[2, 4] */
    const double r3 = c1 * T24 - s1 * T14;

    /* is the pose one that the arm can take? */
    if (!(fabs(T34 - (d1 + r2)) <= pose_slack1 && (fabs(T33) <= pose_slack && (fabs(1.0 + T32) <=
        pose_slack && (fabs(T31) <= pose_slack && (fabs(T24 - c1 * r3) <= pose_slack1 && (fabs(T23 -
        c1) <= pose_slack && (fabs(T22) <= pose_slack && (fabs(T21 - s1) <= pose_slack && (fabs(T14
        + s1 * r3) <= pose_slack1 && (fabs(T13 + s1) <= pose_slack && (fabs(T11 - c1) <= pose_slack
        && fabs(T12) <= pose_slack))))))))))))
        return; /* the arm can't take this pose */
    const int row = 0;
    q[row][0] = q1;
    q[row][1] = r2;
    q[row][2] = r3;
    status[row] = (free1) ? CYLINDRICAL_FREE_JOINT : CYLINDRICAL_OK;
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

int cylindrical_ik(
    const double T[16], const double *q_seed, double q[1][3], unsigned char status[1])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 1; row++) {
        status[row] = valid ? CYLINDRICAL_UNREACHABLE : CYLINDRICAL_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -CYLINDRICAL_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 1; row++) {
        if (status[row] == CYLINDRICAL_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = CYLINDRICAL_OUT_OF_LIMITS;
        }
        count += status[row] != CYLINDRICAL_OUT_OF_LIMITS;
    }
    return count;
}

int cylindrical_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[1][3], least = HUGE_VAL;
    unsigned char status[1];
    int result = -CYLINDRICAL_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (cylindrical_ik(T, q_seed, all, status) < 0)
        return -CYLINDRICAL_INVALID_POSE;
    for (int row = 0; row < 1; row++) {
        double distance = 0.0;
        if (status[row] == CYLINDRICAL_OUT_OF_LIMITS && result < 0)
            result = -CYLINDRICAL_OUT_OF_LIMITS;
        if (status[row] != CYLINDRICAL_OK && status[row] != CYLINDRICAL_FREE_JOINT)
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

void cylindrical_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)cylindrical_ik(T + 16 * k, NULL, (double (*)[3])(q + 3 * k), status + 1 * k);
}
