/* gantry_wrist: Gantry with a spherical wrist
 *
 * Inverse kinematics, generated from robots/gantry_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/gantry_wrist.yaml. The formulas and where they come from:
 * gantry_wrist.md.
 */
#include "gantry_wrist.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d4 = 0.1; /* joint offset 4 [m] */
static const double d6 = 0.12; /* joint offset 6 [m] */
static const double free_limit = 1e-12; /* a length that fixes no angle */

const char *const gantry_wrist_branches[2] = {
    "noflip", "flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 0, 0, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = {
    20.66115702479339, 20.66115702479339, 20.66115702479339, 1.0, 1.0, 1.0,
};

void gantry_wrist_fk(const double q[6], double T[16])
{
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v1 = s4 * c5;
    const double x5_z = c4 * c5;
    const double v2 = s4 * s5;
    const double T33_ = c4 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T31_ = x5_z * c6 - s4 * s6;
    const double T12_ = s5 * s6;
    const double T22_ = v1 * s6 - c4 * c6;
    const double T14_ = q[2] + d4 + c5 * d6;
    const double T24_ = q[1] - v2 * d6;
    const double T34_ = q[0] + T33_ * d6;
    T[0] = -(s5 * c6); T[1] = T12_; T[2] = c5; T[3] = T14_;
    T[4] = -(v1 * c6 + c4 * s6); T[5] = T22_; T[6] = -v2; T[7] = T24_;
    T[8] = T31_; T[9] = -(s4 * c6 + x5_z * s6); T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void gantry_wrist_jacobian(const double q[6], double J[36])
{
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double p4_x = q[2] + d4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v1 = s4 * s5;
    const double J66 = c4 * s5;
    const double J34 = q[1] - v1 * d6 - q[1];
    const double v2 = q[0] + J66 * d6 - q[0];
    const double v3 = p4_x + c5 * d6 - p4_x;
    const double J15 = s4 * J34 - c4 * v2;
    const double J35 = c4 * v3;
    const double J26 = J66 * v3 - c5 * v2;
    const double J36 = c5 * J34 + v1 * v3;
    J[0] = 0.0; J[1] = 0.0; J[2] = 1.0; J[3] = 0.0; J[4] = J15; J[5] = -(v1 * v2 + J66 * J34);
    J[6] = 0.0; J[7] = 1.0; J[8] = 0.0; J[9] = -v2; J[10] = -(s4 * v3); J[11] = J26;
    J[12] = 1.0; J[13] = 0.0; J[14] = 0.0; J[15] = J34; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = 1.0; J[22] = 0.0; J[23] = c5;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = 0.0; J[28] = -c4; J[29] = -v1;
    J[30] = 0.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = -s4; J[35] = J66;
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
    const double T[16], const double seed[6], double q[2][6], unsigned char status[2])
{
    const double T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* r2, type 1: U0 A6^-1 [2, 4] */
    const double wy = T24 - T23 * d6;

    /* r1, type 1: U0 A6^-1 [3, 4] */
    const double wz = T34 - d6 * T33;

    /* r3, type 1: U0 A6^-1 [1, 4] */
    const double wx = T14 - d6 * T13;
    const double r3 = wx - d4;

    /* theta4, type 2: U4[3, 3] */
    const double w4 = sqrt(T33 * T33 + T23 * T23);
    const int free4 = w4 <= free_limit;
    const double divisor4 = free4 ? 1.0 : w4;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip, flip */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e1 < 0.0 && free4) continue; /* both signs give the same */
        const double factor4 = e1 / divisor4;
        const double c4 = free4 ? cos(seed[3]) : -(T33 * factor4);
        const double s4 = free4 ? sin(seed[3]) : T23 * factor4;
        const double q4 = atan2(s4, c4);

        /* theta5, type 3: U4[2, 3] and U4[1, 3] */
        const double q5 = atan2(-(w4 * e1), T13);

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double q6 = atan2(-(T21 * c4 + T31 * s4), -(T22 * c4 + T32 * s4));
        const int row = i1;
        q[row][0] = wz;
        q[row][1] = wy;
        q[row][2] = r3;
        q[row][3] = q4;
        q[row][4] = q5;
        q[row][5] = q6;
        status[row] = (free4) ? GANTRY_WRIST_FREE_JOINT : GANTRY_WRIST_OK;
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

int gantry_wrist_ik(
    const double T[16], const double *q_seed, double q[2][6], unsigned char status[2])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? GANTRY_WRIST_UNREACHABLE : GANTRY_WRIST_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -GANTRY_WRIST_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == GANTRY_WRIST_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = GANTRY_WRIST_OUT_OF_LIMITS;
        }
        count += status[row] != GANTRY_WRIST_OUT_OF_LIMITS;
    }
    return count;
}

int gantry_wrist_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[2][6], least = HUGE_VAL;
    unsigned char status[2];
    int result = -GANTRY_WRIST_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (gantry_wrist_ik(T, q_seed, all, status) < 0)
        return -GANTRY_WRIST_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == GANTRY_WRIST_OUT_OF_LIMITS && result < 0)
            result = -GANTRY_WRIST_OUT_OF_LIMITS;
        if (status[row] != GANTRY_WRIST_OK && status[row] != GANTRY_WRIST_FREE_JOINT)
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

void gantry_wrist_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)gantry_wrist_ik(T + 16 * k, NULL, (double (*)[6])(q + 12 * k), status + 2 * k);
}
