/* rpr: Arm with a revolute, a prismatic and a revolute joint
 *
 * Inverse kinematics, generated from robots/rpr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/rpr.yaml. The formulas and where they come from: rpr.md.
 */
#include "rpr.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.5; /* joint offset 1 [m] */
static const double a3 = 0.3; /* link length 3 [m] */
static const double free_limit1 = 8e-13; /* a length that fixes no angle [m] */
/* rounding at the boundary of the workspace [m] */
static const double reach_slack1 = 8.000000000000001e-14;
static const double merge_slack1 = 8e-15; /* nearer to that boundary two branches are one [m] */
static const double k1 = 0.09; /* a3^2 [m^2] */
static const double k2 = 11.111111111111112; /* 1 / (a3^2) [m^-2] */

const char *const rpr_branches[4] = {
    "left-noflip", "left-flip", "right-noflip", "right-flip",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const int revolute[3] = { 1, 0, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 1.0, 1.5624999999999998, 1.0 };

void rpr_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double v1 = s1 * s3;
    const double T21_ = c1 * s3;
    const double T22_ = c1 * c3;
    const double T24_ = c1 * q[1] + T21_ * a3;
    const double T34_ = d1 - c3 * a3;
    T[0] = -v1; T[1] = -(s1 * c3); T[2] = c1; T[3] = -(s1 * q[1] + v1 * a3);
    T[4] = T21_; T[5] = T22_; T[6] = s1; T[7] = T24_;
    T[8] = -c3; T[9] = s3; T[10] = 0.0; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void rpr_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v1 = s1 * q[1];
    const double p2_y = c1 * q[1];
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double v2 = v1 + s1 * s3 * a3;
    const double p3_y = p2_y + c1 * s3 * a3;
    const double v3 = d1 - c3 * a3 - d1;
    const double J13 = s1 * v3;
    const double J33 = c1 * (p3_y - p2_y) - s1 * (v1 - v2);
    J[0] = -p3_y; J[1] = -s1; J[2] = J13;
    J[3] = -v2; J[4] = c1; J[5] = -(c1 * v3);
    J[6] = 0.0; J[7] = 0.0; J[8] = J33;
    J[9] = 0.0; J[10] = 0.0; J[11] = c1;
    J[12] = 0.0; J[13] = 0.0; J[14] = s1;
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

    /* theta1, type 2: U1[1, 4] */
    const double w1 = sqrt(T24 * T24 + T14 * T14);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 2: U0[3, 4] */
    const double Z3 = T34 - d1;
    const double D3 = k1 - Z3 * Z3;
    const double v1 = 2.0 * fabs(Z3);
    const int apart3 = merge_slack1 * (v1 + merge_slack1) < D3;
    if (!(-(reach_slack1 * (v1 + reach_slack1)) <= D3)) return; /* out of reach */
    const double w3 = sqrt(apart3 ? D3 : 0.0);

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : T24 * factor1;
        const double s1 = free1 ? sin(seed[0]) : -(T14 * factor1);
        const double q1 = atan2(s1, c1);
        const double root1 = w1 * e1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double v2 = k2 * (a3 * (w3 * e2));
            const double q3 = atan2(-v2, -(k2 * (a3 * Z3)));

            /* r2, type 1: U1[3, 4] */
            const double v3 = a3 * v2;
            const double r2 = root1 + v3;
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = r2;
            q[row][2] = q3;
            status[row] = (free1) ? RPR_FREE_JOINT : RPR_OK;
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

int rpr_ik(const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? RPR_UNREACHABLE : RPR_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -RPR_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == RPR_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = RPR_OUT_OF_LIMITS;
        }
        count += status[row] != RPR_OUT_OF_LIMITS;
    }
    return count;
}

int rpr_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[4][3], least = HUGE_VAL;
    unsigned char status[4];
    int result = -RPR_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (rpr_ik(T, q_seed, all, status) < 0)
        return -RPR_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == RPR_OUT_OF_LIMITS && result < 0)
            result = -RPR_OUT_OF_LIMITS;
        if (status[row] != RPR_OK && status[row] != RPR_FREE_JOINT)
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

void rpr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)rpr_ik(T + 16 * k, NULL, (double (*)[3])(q + 12 * k), status + 4 * k);
}
