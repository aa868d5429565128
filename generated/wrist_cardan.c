/* wrist_cardan: Spherical wrist, cardan axes
 *
 * Inverse kinematics, generated from robots/wrist_cardan.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/wrist_cardan.yaml. The formulas and where they come from:
 * wrist_cardan.md.
 */
#include "wrist_cardan.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double free_limit = 1e-12; /* a length that fixes no angle */

const char *const wrist_cardan_branches[2] = {
    "left", "right",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };

void wrist_cardan_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T11_ = c1 * c2;
    const double v1 = c1 * s2;
    const double y2_z = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double T13_ = s1 * c3 + v1 * s3;
    const double T33_ = c1 * c3 - y2_z * s3;
    const double T22_ = c2 * c3;
    const double T32_ = y2_z * c3 + c1 * s3;
    const double T12_ = s1 * s3 - v1 * c3;
    T[0] = T11_; T[1] = T12_; T[2] = T13_; T[3] = 0.0;
    T[4] = s2; T[5] = T22_; T[6] = -(c2 * s3); T[7] = 0.0;
    T[8] = -(s1 * c2); T[9] = T32_; T[10] = T33_; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void wrist_cardan_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double J43 = c1 * c2;
    J[0] = 0.0; J[1] = 0.0; J[2] = 0.0;
    J[3] = 0.0; J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = s1; J[11] = J43;
    J[12] = 1.0; J[13] = 0.0; J[14] = s2;
    J[15] = 0.0; J[16] = c1; J[17] = -(s1 * c2);
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
    const double T[16], const double seed[3], double q[2][3], unsigned char status[2])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2];
    const double T21 = T[4];
    const double T31 = T[8], T32 = T[9], T33 = T[10];

    /* theta1, type 2: U1[1, 3] */
    const double w1 = sqrt(T11 * T11 + T31 * T31);
    const int free1 = w1 <= free_limit;
    const double divisor1 = free1 ? 1.0 : w1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : T11 * factor1;
        const double s1 = free1 ? sin(seed[0]) : -(T31 * factor1);
        const double q1 = atan2(s1, c1);
        const double c2 = w1 * e1;

        /* theta2, type 3: U1[3, 3] and U1[2, 3] */
        const double q2 = atan2(T21, c2);

        /* theta3, type 3: U1[1, 2] and U1[1, 1] */
        const double s3 = T32 * c1 + T12 * s1;
        const double c3 = T33 * c1 + T13 * s1;
        const double q3 = atan2(s3, c3);
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = q3;
        status[row] = (free1) ? WRIST_CARDAN_FREE_JOINT : WRIST_CARDAN_OK;
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

int wrist_cardan_ik(
    const double T[16], const double *q_seed, double q[2][3], unsigned char status[2])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? WRIST_CARDAN_UNREACHABLE : WRIST_CARDAN_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -WRIST_CARDAN_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == WRIST_CARDAN_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = WRIST_CARDAN_OUT_OF_LIMITS;
        }
        count += status[row] != WRIST_CARDAN_OUT_OF_LIMITS;
    }
    return count;
}

int wrist_cardan_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[2][3], least = HUGE_VAL;
    unsigned char status[2];
    int result = -WRIST_CARDAN_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (wrist_cardan_ik(T, q_seed, all, status) < 0)
        return -WRIST_CARDAN_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == WRIST_CARDAN_OUT_OF_LIMITS && result < 0)
            result = -WRIST_CARDAN_OUT_OF_LIMITS;
        if (status[row] != WRIST_CARDAN_OK && status[row] != WRIST_CARDAN_FREE_JOINT)
            continue;
        for (int i = 0; i < 3; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
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

void wrist_cardan_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)wrist_cardan_ik(T + 16 * k, NULL, (double (*)[3])(q + 6 * k), status + 2 * k);
}
