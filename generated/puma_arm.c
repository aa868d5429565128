/* puma_arm: PUMA 560 to its wrist centre
 *
 * Inverse kinematics, generated from robots/puma_arm.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma_arm.yaml. The formulas and where they come from: puma_arm.md.
 */
#include "puma_arm.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.67183; /* joint offset 1 [m] */
static const double a2 = 0.4318; /* link length 2 [m] */
static const double d3 = 0.15005; /* joint offset 3 [m] */
static const double a3 = 0.0203; /* link length 3 [m] */
static const double d4 = 0.4318; /* z of the tool frame [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 2.9096854084e-24;
static const double longest3 = 0.7466289125534531; /* square of the longest reach [m^2] */
static const double shortest3 = 2.274465470660925e-07; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 0.7466289125537477;
/* the shortest, with what rounding adds [m^2] */
static const double shortest3_reach = 2.2744654690339056e-07;
/* the longest, where branches merge [m^2] */
static const double longest3_apart = 0.7466289125534236;
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 2.2744654708236271e-07;
static const double k1 = 0.022515002499999996; /* d3^2 [m^2] */
static const double k2 = 5.11904578000291e-14; /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
static const double k3 = 5.1190457800002905e-15; /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
static const double k4 = 0.37290248000000004; /* 2 * d4 * a2 [m^2] */
static const double k5 = 0.01753108; /* 2 * a3 * a2 [m^2] */
static const double k6 = 0.37331457; /* d4 * a2 + (a3^2 + d4 * a2) [m^2] */
static const double k7 = 7.175474885806929; /* 1 / ((2 * d4 * a2)^2 + (2 * a3 * a2)^2) [m^-4] */

const char *const puma_arm_branches[4] = {
    "left-down", "left-up", "right-down", "right-up",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };

void puma_arm_fk(const double q[3], double T[16])
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
    const double T31_ = s2 * c3 + c2 * s3;
    const double v3 = v1 * c3 + x2_x * s3;
    const double v4 = v2 * c3 + x2_y * s3;
    const double T33_ = c2 * c3 - s2 * s3;
    const double T14_ = x2_x * a2 + T11_ * a3 + s1 * d3 - v3 * d4;
    const double T24_ = x2_y * a2 + T21_ * a3 - c1 * d3 - v4 * d4;
    const double T34_ = d1 + s2 * a2 + T31_ * a3 + T33_ * d4;
    T[0] = T11_; T[1] = -s1; T[2] = -v3; T[3] = T14_;
    T[4] = T21_; T[5] = c1; T[6] = -v4; T[7] = T24_;
    T[8] = T31_; T[9] = 0.0; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma_arm_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double p2_x = x2_x * a2;
    const double p2_y = x2_y * a2;
    const double p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double J21 = p2_x + (x2_x * c3 - v1 * s3) * a3 + s1 * d3 - (v1 * c3 + x2_x * s3) * d4;
    const double v3 = p2_y + (x2_y * c3 - v2 * s3) * a3 - c1 * d3 - (v2 * c3 + x2_y * s3) * d4;
    const double v4 = p2_z + (s2 * c3 + c2 * s3) * a3 + (c2 * c3 - s2 * s3) * d4;
    const double v5 = v4 - d1;
    const double J32 = s1 * v3 + c1 * J21;
    const double v6 = v4 - p2_z;
    const double J33 = s1 * (v3 - p2_y) + c1 * (J21 - p2_x);
    J[0] = -v3; J[1] = -(c1 * v5); J[2] = -(c1 * v6);
    J[3] = J21; J[4] = -(s1 * v5); J[5] = -(s1 * v6);
    J[6] = 0.0; J[7] = J32; J[8] = J33;
    J[9] = 0.0; J[10] = s1; J[11] = s1;
    J[12] = 0.0; J[13] = -c1; J[14] = -c1;
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
    const double N1 = T14 * T14 + T24 * T24;
    const double D1 = N1 - k1;
    const int free1 = N1 <= free_limit_squared2;
    const int apart1 = k3 < D1;
    if (!(-k2 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v1 = T14 * d3;
    const double v2 = T24 * d3;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - d1;
    const double v3 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (T14 * root1 - v2);
        const double s1 = free1 ? sin(seed[0]) : inverse1 * (v1 + T24 * root1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double N3 = v3 + root1 * root1;
        const double K3 = N3 - k6;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v4 = k4 * K3;
        const double v5 = k5 * K3;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double root3 = w3 * e2;
            const double s3 = (k5 * root3 - v4) * k7;
            const double c3 = k7 * (v5 + k4 * root3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + (a3 * c3 - d4 * s3);
            const double Y1_2 = d4 * c3 + a3 * s3;
            const double S2 = Z1_3 * X1_2 - root1 * Y1_2;
            const double C2 = root1 * X1_2 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2;
            const double s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = q2;
            q[row][2] = q3;
            status[row] = (free1 || free2) ? PUMA_ARM_FREE_JOINT : PUMA_ARM_OK;
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

int puma_arm_ik(const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? PUMA_ARM_UNREACHABLE : PUMA_ARM_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PUMA_ARM_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == PUMA_ARM_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PUMA_ARM_OUT_OF_LIMITS;
        }
        count += status[row] != PUMA_ARM_OUT_OF_LIMITS;
    }
    return count;
}

int puma_arm_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[4][3], least = HUGE_VAL;
    unsigned char status[4];
    int result = -PUMA_ARM_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (puma_arm_ik(T, q_seed, all, status) < 0)
        return -PUMA_ARM_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == PUMA_ARM_OUT_OF_LIMITS && result < 0)
            result = -PUMA_ARM_OUT_OF_LIMITS;
        if (status[row] != PUMA_ARM_OK && status[row] != PUMA_ARM_FREE_JOINT)
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

void puma_arm_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)puma_arm_ik(T + 16 * k, NULL, (double (*)[3])(q + 12 * k), status + 4 * k);
}
