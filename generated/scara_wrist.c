/* scara_wrist: SCARA arm with a spherical wrist
 *
 * Inverse kinematics, generated from robots/scara_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara_wrist.yaml. The formulas and where they come from:
 * scara_wrist.md.
 */
#include "scara_wrist.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.5; /* joint offset 1 [m] */
static const double a1 = 0.4; /* link length 1 [m] */
static const double a2 = 0.3; /* link length 2 [m] */
static const double d6 = 0.1; /* joint offset 6 [m] */
static const double longest2 = 0.48999999999999994; /* square of the longest reach [m^2] */
static const double shortest2 = 0.010000000000000007; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest2_reach = 0.49000000000018196;
/* the shortest, with what rounding adds [m^2] */
static const double shortest2_reach = 0.009999999999974009;
/* the longest, where branches merge [m^2] */
static const double longest2_apart = 0.48999999999998173;
/* the shortest, where branches merge [m^2] */
static const double shortest2_apart = 0.010000000000002607;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 1.69e-24;
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double k1 = 0.25; /* a1^2 + a2^2 [m^2] */
static const double k2 = 4.166666666666667; /* 1 / (2 * a2 * a1) [m^-2] */

const char *const scara_wrist_branches[4] = {
    "down-left", "down-right", "up-left", "up-right",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 1, 1, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 1.0, 0.5917159763313609, 1.0, 1.0, 1.0 };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void scara_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2 - s1 * s2;
    const double x2_y = s1 * c2 + c1 * s2;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v1 = x2_y * s4;
    const double x4_x = x2_x * c4 + v1;
    const double v2 = x2_y * c4;
    const double x4_y = v2 + -x2_x * s4;
    const double y5_x = v2 - x2_x * s4;
    const double y5_y = -x2_x * c4 - v1;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5;
    const double x5_y = x4_y * c5;
    const double v3 = x4_x * s5;
    const double v4 = x4_y * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 + y5_x * s6;
    const double T21_ = x5_y * c6 + y5_y * s6;
    const double T12_ = y5_x * c6 - x5_x * s6;
    const double T22_ = y5_y * c6 - x5_y * s6;
    const double T32_ = s5 * s6;
    const double T14_ = c1 * a1 + x2_x * a2 - v3 * d6;
    const double T24_ = s1 * a1 + x2_y * a2 - v4 * d6;
    const double T34_ = d1 + q[2] - c5 * d6;
    T[0] = T11_; T[1] = T12_; T[2] = -v3; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = -v4; T[7] = T24_;
    T[8] = -(s5 * c6); T[9] = T32_; T[10] = -c5; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void scara_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double p1_x = c1 * a1;
    const double p1_y = s1 * a1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2 - s1 * s2;
    const double x2_y = s1 * c2 + c1 * s2;
    const double p2_x = p1_x + x2_x * a2;
    const double p2_y = p1_y + x2_y * a2;
    const double p3_z = d1 + q[2];
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v1 = x2_y * s4;
    const double v2 = x2_y * c4;
    const double J45 = x2_x * s4 - v2;
    const double J55 = v1 - -x2_x * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v3 = (x2_x * c4 + v1) * s5;
    const double v4 = (v2 + -x2_x * s4) * s5;
    const double J21 = p2_x - v3 * d6;
    const double p6_y = p2_y - v4 * d6;
    const double J22 = J21 - p1_x;
    const double J12 = p1_y - p6_y;
    const double v5 = J21 - p2_x;
    const double J14 = p6_y - p2_y;
    const double v6 = p3_z - c5 * d6 - p3_z;
    const double J15 = J55 * v6;
    const double J35 = J45 * J14 - J55 * v5;
    const double J16 = c5 * J14 - v4 * v6;
    const double J26 = v3 * v6 - c5 * v5;
    const double J36 = v4 * v5 - v3 * J14;
    J[0] = -p6_y; J[1] = J12; J[2] = 0.0; J[3] = J14; J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = J22; J[8] = 0.0; J[9] = -v5; J[10] = -(J45 * v6); J[11] = J26;
    J[12] = 0.0; J[13] = 0.0; J[14] = 1.0; J[15] = 0.0; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = 0.0; J[22] = J45; J[23] = -v3;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = 0.0; J[28] = J55; J[29] = -v4;
    J[30] = 1.0; J[31] = 1.0; J[32] = 0.0; J[33] = -1.0; J[34] = 0.0; J[35] = -c5;
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
    const double T33 = T[10], T34 = T[11];

    /* r3, type 1: U0 A6^-1 [3, 4] */
    const double wz = T34 - T33 * d6;
    const double r3 = wz - d1;

    /* theta2, type 8: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4] */
    const double wx = T14 - d6 * T13;
    const double wy = T24 - d6 * T23;
    const double N2 = wx * wx + wy * wy;
    const double K2 = N2 - k1;
    const double D2 = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D2 : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0 A6^-1 [2, 4] and U0 A6^-1 [1, 4] */
    const double X1_1 = a1 + a2 * c2;
    const double v1 = wy * X1_1;
    const double v2 = wx * X1_1;

    /* theta12m4, type 2: U4[3, 3] */
    const double w12m4 = sqrt(T13 * T13 + T23 * T23);
    const int free12m4 = w12m4 <= free_limit;
    const double divisor12m4 = free12m4 ? 1.0 : w12m4;

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e1 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e1 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v1 - wx * Y1_1;
        const double C1 = v2 + wy * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const double factor1 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : C1 * factor1;
        const double s1 = free1 ? sin(seed[0]) : S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta12m4 */
        const double v3 = q2 + q1;
        const double v4 = v3 - seed[3];

        for (int i2 = 0; i2 < 2; i2++) { /* left, right */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta12m4 */
            if (e2 < 0.0 && free12m4) continue; /* both signs give the same */
            const double factor12m4 = e2 / divisor12m4;
            const double c12m4 = free12m4 ? cos(v4) : -(T13 * factor12m4);
            const double s12m4 = free12m4 ? sin(v4) : -(T23 * factor12m4);
            const double s5 = w12m4 * e2;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double q5 = atan2(s5, -T33);

            /* theta6, type 3: U4[3, 2] and U4[3, 1] */
            const double c6 = T12 * s12m4 - T22 * c12m4;
            const double s6 = T11 * s12m4 - T21 * c12m4;
            const double q6 = atan2(s6, c6);

            /* joint values */
            const double q4 = wrap(v3 - atan2(s12m4, c12m4));
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = q2;
            q[row][2] = r3;
            q[row][3] = q4;
            q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free1 || free12m4) ? SCARA_WRIST_FREE_JOINT : SCARA_WRIST_OK;
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

int scara_wrist_ik(
    const double T[16], const double *q_seed, double q[4][6], unsigned char status[4])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? SCARA_WRIST_UNREACHABLE : SCARA_WRIST_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -SCARA_WRIST_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == SCARA_WRIST_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = SCARA_WRIST_OUT_OF_LIMITS;
        }
        count += status[row] != SCARA_WRIST_OUT_OF_LIMITS;
    }
    return count;
}

int scara_wrist_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[4][6], least = HUGE_VAL;
    unsigned char status[4];
    int result = -SCARA_WRIST_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (scara_wrist_ik(T, q_seed, all, status) < 0)
        return -SCARA_WRIST_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == SCARA_WRIST_OUT_OF_LIMITS && result < 0)
            result = -SCARA_WRIST_OUT_OF_LIMITS;
        if (status[row] != SCARA_WRIST_OK && status[row] != SCARA_WRIST_FREE_JOINT)
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

void scara_wrist_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)scara_wrist_ik(T + 16 * k, NULL, (double (*)[6])(q + 24 * k), status + 4 * k);
}
