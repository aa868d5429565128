/* cylindrical_wrist: Cylindrical arm with a spherical wrist
 *
 * Inverse kinematics, generated from robots/cylindrical_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cylindrical_wrist.yaml. The formulas and where they come from:
 * cylindrical_wrist.md.
 */
#include "cylindrical_wrist.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.3; /* joint offset 1 [m] */
static const double d6 = 0.1; /* joint offset 6 [m] */
static const double free_limit1 = 4e-13; /* a length that fixes no angle [m] */
static const double free_limit = 1e-12; /* a length that fixes no angle */

const char *const cylindrical_wrist_branches[4] = {
    "forward-noflip", "forward-flip", "backward-noflip", "backward-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 1, 0, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 6.249999999999999, 6.249999999999999, 1.0, 1.0, 1.0 };

void cylindrical_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = c1 * c4;
    const double x4_y = s1 * c4;
    const double v1 = c1 * s4;
    const double v2 = s1 * s4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5 + s1 * s5;
    const double x5_y = x4_y * c5 - c1 * s5;
    const double v3 = s4 * c5;
    const double T23_ = c1 * c5 + x4_y * s5;
    const double v4 = s4 * s5;
    const double T13_ = x4_x * s5 - s1 * c5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 - v1 * s6;
    const double T21_ = x5_y * c6 - v2 * s6;
    const double T32_ = v3 * s6 - c4 * c6;
    const double T14_ = T13_ * d6 - s1 * q[2];
    const double T24_ = c1 * q[2] + T23_ * d6;
    const double T34_ = d1 + q[1] - v4 * d6;
    T[0] = T11_; T[1] = -(v1 * c6 + x5_x * s6); T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = -(v2 * c6 + x5_y * s6); T[6] = T23_; T[7] = T24_;
    T[8] = -(v3 * c6 + c4 * s6); T[9] = T32_; T[10] = -v4; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void cylindrical_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double p2_z = d1 + q[1];
    const double v1 = s1 * q[2];
    const double p3_y = c1 * q[2];
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v2 = c1 * s4;
    const double v3 = s1 * s4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J56 = c1 * c5 + s1 * c4 * s5;
    const double v4 = s4 * s5;
    const double J46 = c1 * c4 * s5 - s1 * c5;
    const double J21 = J46 * d6 - v1;
    const double p6_y = p3_y + J56 * d6;
    const double v5 = v1 + J21;
    const double v6 = p6_y - p3_y;
    const double v7 = p2_z - v4 * d6 - p2_z;
    const double J14 = c1 * v7;
    const double J24 = s1 * v7;
    const double J15 = c4 * v6 - v3 * v7;
    const double J25 = v2 * v7 - c4 * v5;
    const double J35 = v3 * v5 - v2 * v6;
    const double J16 = J56 * v7 + v4 * v6;
    const double J36 = J46 * v6 - J56 * v5;
    J[0] = -p6_y; J[1] = 0.0; J[2] = -s1; J[3] = J14; J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = 0.0; J[8] = c1; J[9] = J24; J[10] = J25; J[11] = -(v4 * v5 + J46 * v7);
    J[12] = 0.0; J[13] = 1.0; J[14] = 0.0; J[15] = -(s1 * v6 + c1 * v5); J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = -s1; J[22] = -v2; J[23] = J46;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = c1; J[28] = -v3; J[29] = J56;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = -c4; J[35] = -v4;
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
    const double T[16], const double seed[6], double q[4][6], unsigned char status[4])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* r2, type 1: U0 A6^-1 [3, 4] */
    const double wz = T34 - T33 * d6;
    const double r2 = wz - d1;

    /* theta1, r3, type 4: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4] */
    const double wy = T24 - d6 * T23;
    const double v1 = d6 * T13 - T14;
    const double w3 = sqrt(v1 * v1 + wy * wy);
    const int free1 = w3 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w3;

    /* theta4, type 2: U4[3, 3] */
    const double v2 = T33 * T33;

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1, r3 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : wy * factor1;
        const double s1 = free1 ? sin(seed[0]) : v1 * factor1;
        const double q1 = atan2(s1, c1);
        const double r3 = w3 * e1;

        /* theta4 */
        const double X4 = T13 * c1 + T23 * s1;
        const double w4 = sqrt(X4 * X4 + v2);
        const int free4 = w4 <= free_limit;
        const double divisor4 = free4 ? 1.0 : w4;

        /* theta5, type 3: U4[2, 3] and U4[1, 3] */
        const double c5 = T23 * c1 - T13 * s1;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v3 = T12 * c1 + T22 * s1;
        const double v4 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta4 */
            if (e2 < 0.0 && free4) continue; /* both signs give the same */
            const double factor4 = e2 / divisor4;
            const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4);
            const double s4 = free4 ? sin(seed[3]) : T33 * factor4;
            const double q4 = atan2(s4, c4);

            /* theta5 */
            const double q5 = atan2(-(w4 * e2), c5);

            /* theta6 */
            const double q6 = atan2(-(T31 * c4 + s4 * v4), -(T32 * c4 + s4 * v3));
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = r2;
            q[row][2] = r3;
            q[row][3] = q4;
            q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free1 || free4) ? CYLINDRICAL_WRIST_FREE_JOINT : CYLINDRICAL_WRIST_OK;
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

int cylindrical_wrist_ik(
    const double T[16], const double *q_seed, double q[4][6], unsigned char status[4])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? CYLINDRICAL_WRIST_UNREACHABLE : CYLINDRICAL_WRIST_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -CYLINDRICAL_WRIST_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == CYLINDRICAL_WRIST_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = CYLINDRICAL_WRIST_OUT_OF_LIMITS;
        }
        count += status[row] != CYLINDRICAL_WRIST_OUT_OF_LIMITS;
    }
    return count;
}

int cylindrical_wrist_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[4][6], least = HUGE_VAL;
    unsigned char status[4];
    int result = -CYLINDRICAL_WRIST_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (cylindrical_wrist_ik(T, q_seed, all, status) < 0)
        return -CYLINDRICAL_WRIST_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == CYLINDRICAL_WRIST_OUT_OF_LIMITS && result < 0)
            result = -CYLINDRICAL_WRIST_OUT_OF_LIMITS;
        if (status[row] != CYLINDRICAL_WRIST_OK && status[row] != CYLINDRICAL_WRIST_FREE_JOINT)
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

void cylindrical_wrist_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)cylindrical_wrist_ik(T + 16 * k, NULL, (double (*)[6])(q + 24 * k), status + 4 * k);
}
