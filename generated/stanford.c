/* stanford: Stanford arm
 *
 * Inverse kinematics, generated from robots/stanford.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/stanford.yaml. The formulas and where they come from: stanford.md.
 */
#include "stanford.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.412; /* joint offset 1 [m] */
static const double d2 = 0.154; /* joint offset 2 [m] */
static const double a3 = 0.0203; /* link length 3 [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 3.4374768999999993e-25;
static const double free_limit1 = 5.862999999999999e-13; /* a length that fixes no angle [m] */
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double k1 = 0.13369999999999999; /* d2 - a3 [m] */
static const double k2 = 0.01787569; /* (d2 - a3)^2 [m^2] */
/* reach_slack1 * (2 * (d2 - a3) + reach_slack1) [m^2] */
static const double k3 = 1.5677662000003437e-14;
/* merge_slack1 * (2 * (d2 - a3) + merge_slack1) [m^2] */
static const double k4 = 1.5677662000000342e-15;

const char *const stanford_branches[8] = {
    "left-forward-noflip", "left-forward-flip", "left-backward-noflip", "left-backward-flip",
    "right-forward-noflip", "right-forward-flip", "right-backward-noflip", "right-backward-flip",
};

static const double lowest[6] = {
    -2.9670597283903604, -2.9670597283903604, 0.3048, -2.9670597283903604, -1.5707963267948966,
    -2.9670597283903604,
};
static const double highest[6] = {
    2.9670597283903604, 2.9670597283903604, 1.27, 2.9670597283903604, 1.5707963267948966,
    2.9670597283903604,
};
static const int revolute[6] = { 1, 1, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 1.0, 2.9091104583131893, 1.0, 1.0, 1.0 };

void stanford_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double z2_x = c1 * s2;
    const double z2_y = s1 * s2;
    const double T34_ = d1 + c2 * q[2];
    const double T14_ = z2_x * q[2] - s1 * d2 + s1 * a3;
    const double T24_ = c1 * d2 + z2_y * q[2] - c1 * a3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = s1 * c4 + x2_x * s4;
    const double x4_y = x2_y * s4 - c1 * c4;
    const double v1 = s2 * s4;
    const double z4_x = x2_x * c4 - s1 * s4;
    const double z4_y = x2_y * c4 + c1 * s4;
    const double v2 = s2 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5 - z2_x * s5;
    const double x5_y = x4_y * c5 - z2_y * s5;
    const double v3 = v1 * c5 + c2 * s5;
    const double T13_ = z2_x * c5 + x4_x * s5;
    const double T23_ = z2_y * c5 + x4_y * s5;
    const double T33_ = c2 * c5 - v1 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 + z4_x * s6;
    const double T21_ = x5_y * c6 + z4_y * s6;
    const double T12_ = z4_x * c6 - x5_x * s6;
    const double T22_ = z4_y * c6 - x5_y * s6;
    const double T32_ = v3 * s6 - v2 * c6;
    T[0] = T11_; T[1] = T12_; T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = T23_; T[7] = T24_;
    T[8] = -(v3 * c6 + v2 * s6); T[9] = T32_; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void stanford_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double J13 = c1 * s2;
    const double J23 = s1 * s2;
    const double J21 = J13 * q[2] - s1 * d2 + s1 * a3;
    const double p3_y = c1 * d2 + J23 * q[2] - c1 * a3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = x2_x * c4 - s1 * s4;
    const double J55 = x2_y * c4 + c1 * s4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J46 = J13 * c5 + (s1 * c4 + x2_x * s4) * s5;
    const double J56 = J23 * c5 + (x2_y * s4 - c1 * c4) * s5;
    const double J66 = c2 * c5 - s2 * s4 * s5;
    const double v1 = d1 + c2 * q[2] - d1;
    const double J12 = c1 * v1;
    const double J22 = s1 * v1;
    J[0] = -p3_y; J[1] = J12; J[2] = J13; J[3] = 0.0; J[4] = 0.0; J[5] = 0.0;
    J[6] = J21; J[7] = J22; J[8] = J23; J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = -(s1 * p3_y + c1 * J21); J[14] = c2; J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = -s1; J[20] = 0.0; J[21] = J13; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = c1; J[26] = 0.0; J[27] = J23; J[28] = J55; J[29] = J56;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = c2; J[34] = -(s2 * c4); J[35] = J66;
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
    const double D1 = N1 - k2;
    const int free1 = N1 <= free_limit_squared2;
    const int apart1 = k4 < D1;
    if (!(-k3 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v1 = T14 * k1;
    const double v2 = T24 * k1;

    /* theta2, r3, type 4: U1[1, 4] and U1[2, 4] */
    const double Y2_2 = T34 - d1;
    const double v3 = Y2_2 * Y2_2;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v2 - T14 * root1);
        const double s1 = free1 ? sin(seed[0]) : -(inverse1 * (v1 + T24 * root1));
        const double q1 = atan2(s1, c1);

        /* theta2, r3 */
        const double w3 = sqrt(root1 * root1 + v3);
        const int free2 = w3 <= free_limit1;
        const double divisor2 = free2 ? 1.0 : w3;

        /* theta4, type 2: U4[3, 3] */
        const double X4 = T13 * s1 - T23 * c1;
        const double v4 = T13 * c1 + T23 * s1;
        const double v5 = X4 * X4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v6 = T12 * c1 + T22 * s1;
        const double v8 = T22 * c1 - T12 * s1;
        const double v9 = T11 * c1 + T21 * s1;
        const double v11 = T21 * c1 - T11 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : Y2_2 * factor2;
            const double s2 = free2 ? sin(seed[1]) : -(root1 * factor2);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;

            /* theta4 */
            const double Y4 = T33 * s2 - c2 * v4;
            const double w4 = sqrt(v5 + Y4 * Y4);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c2 + s2 * v4;

            /* theta6 */
            const double v7 = c2 * v6 - T32 * s2;
            const double v10 = c2 * v9 - T31 * s2;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4);
                const double s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6 */
                const double c6 = c4 * v7 + s4 * v8;
                const double s6 = c4 * v10 + s4 * v11;
                const double q6 = atan2(s6, c6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = r3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? STANFORD_FREE_JOINT : STANFORD_OK;
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

int stanford_ik(const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? STANFORD_UNREACHABLE : STANFORD_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -STANFORD_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == STANFORD_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = STANFORD_OUT_OF_LIMITS;
        }
        count += status[row] != STANFORD_OUT_OF_LIMITS;
    }
    return count;
}

int stanford_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -STANFORD_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (stanford_ik(T, q_seed, all, status) < 0)
        return -STANFORD_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == STANFORD_OUT_OF_LIMITS && result < 0)
            result = -STANFORD_OUT_OF_LIMITS;
        if (status[row] != STANFORD_OK && status[row] != STANFORD_FREE_JOINT)
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

void stanford_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)stanford_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
