/* rpp: Cylindrical arm
 *
 * Inverse kinematics, generated from robots/rpp.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/rpp.yaml. The formulas and where they come from: rpp.md.
 */
#include "rpp.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.5; /* joint offset 1 [m] */
static const double free_limit1 = 5e-13; /* a length that fixes no angle [m] */

const char *const rpp_branches[2] = {
    "forward", "backward",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const int revolute[3] = { 1, 0, 0 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 1.0, 4.0, 4.0 };

void rpp_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double T24_ = c1 * q[1];
    const double T34_ = d1 + q[2];
    T[0] = c1; T[1] = -s1; T[2] = 0.0; T[3] = -(s1 * q[1]);
    T[4] = s1; T[5] = c1; T[6] = 0.0; T[7] = T24_;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void rpp_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    J[0] = -(c1 * q[1]); J[1] = -s1; J[2] = 0.0;
    J[3] = -(s1 * q[1]); J[4] = c1; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0; J[8] = 1.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
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
    const double T[16], const double seed[3], double q[2][3], unsigned char status[2])
{
    const double T14 = T[3];
    const double T24 = T[7];
    const double T34 = T[11];

    /* r3, type 1: U0[3, 4] */
    const double r3 = T34 - d1;

    /* theta1, r2, type 4: U0[1, 4] and U0[2, 4] */
    const double w2 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w2 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w2;

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1, r2 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : T24 * factor1;
        const double s1 = free1 ? sin(seed[0]) : -(T14 * factor1);
        const double q1 = atan2(s1, c1);
        const double r2 = w2 * e1;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = r2;
        q[row][2] = r3;
        status[row] = (free1) ? RPP_FREE_JOINT : RPP_OK;
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

int rpp_ik(const double T[16], const double *q_seed, double q[2][3], unsigned char status[2])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? RPP_UNREACHABLE : RPP_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -RPP_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == RPP_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = RPP_OUT_OF_LIMITS;
        }
        count += status[row] != RPP_OUT_OF_LIMITS;
    }
    return count;
}

int rpp_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[2][3], least = HUGE_VAL;
    unsigned char status[2];
    int result = -RPP_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (rpp_ik(T, q_seed, all, status) < 0)
        return -RPP_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == RPP_OUT_OF_LIMITS && result < 0)
            result = -RPP_OUT_OF_LIMITS;
        if (status[row] != RPP_OK && status[row] != RPP_FREE_JOINT)
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

void rpp_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)rpp_ik(T + 16 * k, NULL, (double (*)[3])(q + 6 * k), status + 2 * k);
}
