/* arm_3r: Arm with three revolute joints, to its wrist centre
 *
 * Inverse kinematics, generated from robots/arm_3r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/arm_3r.yaml. The formulas and where they come from: arm_3r.md.
 */
#include "arm_3r.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.4; /* joint offset 1 [m] */
static const double a2 = 0.4; /* link length 2 [m] */
static const double d4 = 0.35; /* z of the tool frame [m] */
static const double free_limit1 = 1.15e-12; /* a length that fixes no angle [m] */
static const double longest3 = 0.5625; /* square of the longest reach [m^2] */
static const double shortest3 = 0.0025000000000000044; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 0.5625000000001725;
/* the shortest, with what rounding adds [m^2] */
static const double shortest3_reach = 0.0024999999999885045;
/* the longest, where branches merge [m^2] */
static const double longest3_apart = 0.5624999999999827;
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 0.002500000000001154;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 1.3224999999999997e-24;
static const double k1 = 0.27999999999999997; /* 2 * d4 * a2 [m^2] */
static const double k2 = 0.28250000000000003; /* a2^2 + d4^2 [m^2] */
static const double k3 = 12.755102040816327; /* 1 / ((2 * d4 * a2)^2) [m^-4] */

const char *const arm_3r_branches[4] = {
    "left-down", "left-up", "right-down", "right-up",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };

void arm_3r_fk(const double q[3], double T[16])
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
    const double T11_ = x2_x * c3 - v1 * s3;
    const double T21_ = x2_y * c3 - v2 * s3;
    const double v3 = v1 * c3 + x2_x * s3;
    const double v4 = v2 * c3 + x2_y * s3;
    const double T33_ = s2 * s3 - c2 * c3;
    const double T14_ = x2_x * a2 - v3 * d4;
    const double T24_ = x2_y * a2 - v4 * d4;
    const double T34_ = d1 - s2 * a2 + T33_ * d4;
    T[0] = T11_; T[1] = s1; T[2] = -v3; T[3] = T14_;
    T[4] = T21_; T[5] = -c1; T[6] = -v4; T[7] = T24_;
    T[8] = -(s2 * c3 + c2 * s3); T[9] = 0.0; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void arm_3r_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double p2_x = x2_x * a2;
    const double p2_y = x2_y * a2;
    const double p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double J21 = p2_x - (c1 * s2 * c3 + x2_x * s3) * d4;
    const double v1 = p2_y - (s1 * s2 * c3 + x2_y * s3) * d4;
    const double v2 = p2_z + (s2 * s3 - c2 * c3) * d4;
    const double v3 = v2 - d1;
    const double J12 = c1 * v3;
    const double J22 = s1 * v3;
    const double v4 = v2 - p2_z;
    const double J13 = c1 * v4;
    const double J23 = s1 * v4;
    J[0] = -v1; J[1] = J12; J[2] = J13;
    J[3] = J21; J[4] = J22; J[5] = J23;
    J[6] = 0.0; J[7] = -(s1 * v1 + c1 * J21); J[8] = -(s1 * (v1 - p2_y) + c1 * (J21 - p2_x));
    J[9] = 0.0; J[10] = -s1; J[11] = -s1;
    J[12] = 0.0; J[13] = c1; J[14] = c1;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    return 1;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[3], double q[4][3], unsigned char status[4])
{
    const double T14 = T[3];
    const double T24 = T[7];
    const double T34 = T[11];

    /* theta1, type 2: U1[3, 4] */
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - d1;
    const double v1 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(T14 * factor1);
        const double s1 = free1 ? sin(seed[0]) : -(T24 * factor1);
        const double q1 = atan2(s1, c1);
        const double root1 = w1 * e1;

        /* theta3 */
        const double N3 = v1 + root1 * root1;
        const double K3 = N3 - k2;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v2 = k1 * K3 * k3;

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + d4 * v2;
        const double v4 = Z1_3 * Y1_2;
        const double v5 = root1 * Y1_2;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double c3 = k3 * (k1 * (w3 * e2));
            const double q3 = atan2(-v2, c3);

            /* theta2 */
            const double v3 = d4 * c3;
            const double S2 = root1 * v3 - v4;
            const double v6 = Z1_3 * v3 + v5;
            const double w2 = sqrt(S2 * S2 + v6 * v6);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : -(v6 * factor2);
            const double s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = q2;
            q[row][2] = q3;
            status[row] = (free1 || free2) ? ARM_3R_FREE_JOINT : ARM_3R_OK;
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

int arm_3r_ik(const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? ARM_3R_UNREACHABLE : ARM_3R_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -ARM_3R_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == ARM_3R_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = ARM_3R_OUT_OF_LIMITS;
        }
        count += status[row] != ARM_3R_OUT_OF_LIMITS;
    }
    return count;
}

int arm_3r_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[4][3], least = HUGE_VAL;
    unsigned char status[4];
    int result = -ARM_3R_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (arm_3r_ik(T, q_seed, all, status) < 0)
        return -ARM_3R_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == ARM_3R_OUT_OF_LIMITS && result < 0)
            result = -ARM_3R_OUT_OF_LIMITS;
        if (status[row] != ARM_3R_OK && status[row] != ARM_3R_FREE_JOINT)
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

void arm_3r_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)arm_3r_ik(T + 16 * k, NULL, (double (*)[3])(q + 12 * k), status + 4 * k);
}
