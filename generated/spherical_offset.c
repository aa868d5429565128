/* spherical_offset: Spherical arm with a shoulder offset
 *
 * Inverse kinematics, generated from robots/spherical_offset.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical_offset.yaml. The formulas and where they come from:
 * spherical_offset.md.
 */
#include "spherical_offset.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d2 = 0.15; /* joint offset 2 [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 2.2499999999999997e-26;
static const double free_limit1 = 1.5e-13; /* a length that fixes no angle [m] */
static const double k1 = 0.0225; /* d2^2 [m^2] */
static const double k2 = 4.5000000000002246e-15; /* reach_slack1 * (2 * d2 + reach_slack1) [m^2] */
static const double k3 = 4.500000000000022e-16; /* merge_slack1 * (2 * d2 + merge_slack1) [m^2] */

const char *const spherical_offset_branches[4] = {
    "left-forward", "left-backward", "right-forward", "right-backward",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const int revolute[3] = { 1, 1, 0 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 1.0, 1.0, 44.44444444444444 };

void spherical_offset_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T11_ = c1 * c2;
    const double T21_ = s1 * c2;
    const double T13_ = c1 * s2;
    const double T23_ = s1 * s2;
    const double T14_ = T13_ * q[2] - s1 * d2;
    const double T24_ = c1 * d2 + T23_ * q[2];
    const double T34_ = c2 * q[2];
    T[0] = T11_; T[1] = -s1; T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = c1; T[6] = T23_; T[7] = T24_;
    T[8] = -s2; T[9] = 0.0; T[10] = c2; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void spherical_offset_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double J13 = c1 * s2;
    const double J23 = s1 * s2;
    const double J21 = J13 * q[2] - s1 * d2;
    const double p3_y = c1 * d2 + J23 * q[2];
    const double p3_z = c2 * q[2];
    const double J12 = c1 * p3_z;
    const double J22 = s1 * p3_z;
    J[0] = -p3_y; J[1] = J12; J[2] = J13;
    J[3] = J21; J[4] = J22; J[5] = J23;
    J[6] = 0.0; J[7] = -(s1 * p3_y + c1 * J21); J[8] = c2;
    J[9] = 0.0; J[10] = -s1; J[11] = 0.0;
    J[12] = 0.0; J[13] = c1; J[14] = 0.0;
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
    const double v1 = T14 * d2;
    const double v2 = T24 * d2;

    /* theta2, r3, type 4: U1[1, 4] and U1[2, 4] */
    const double v3 = T34 * T34;

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

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : T34 * factor2;
            const double s2 = free2 ? sin(seed[1]) : -(root1 * factor2);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = q2;
            q[row][2] = r3;
            status[row] = (free1 || free2) ? SPHERICAL_OFFSET_FREE_JOINT : SPHERICAL_OFFSET_OK;
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

int spherical_offset_ik(
    const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? SPHERICAL_OFFSET_UNREACHABLE : SPHERICAL_OFFSET_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -SPHERICAL_OFFSET_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == SPHERICAL_OFFSET_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = SPHERICAL_OFFSET_OUT_OF_LIMITS;
        }
        count += status[row] != SPHERICAL_OFFSET_OUT_OF_LIMITS;
    }
    return count;
}

int spherical_offset_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[4][3], least = HUGE_VAL;
    unsigned char status[4];
    int result = -SPHERICAL_OFFSET_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (spherical_offset_ik(T, q_seed, all, status) < 0)
        return -SPHERICAL_OFFSET_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == SPHERICAL_OFFSET_OUT_OF_LIMITS && result < 0)
            result = -SPHERICAL_OFFSET_OUT_OF_LIMITS;
        if (status[row] != SPHERICAL_OFFSET_OK && status[row] != SPHERICAL_OFFSET_FREE_JOINT)
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

void spherical_offset_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)spherical_offset_ik(T + 16 * k, NULL, (double (*)[3])(q + 12 * k), status + 4 * k);
}
