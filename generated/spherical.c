/* spherical: Spherical arm
 *
 * Inverse kinematics, generated from robots/spherical.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical.yaml. The formulas and where they come from:
 * spherical.md.
 */
#include "spherical.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.5; /* joint offset 1 [m] */
static const double free_limit1 = 5e-13; /* a length that fixes no angle [m] */

const char *const spherical_branches[4] = {
    "left-forward", "left-backward", "right-forward", "right-backward",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const int revolute[3] = { 1, 1, 0 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 1.0, 1.0, 4.0 };

void spherical_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T11_ = c1 * c2;
    const double T21_ = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double T34_ = d1 + c2 * q[2];
    T[0] = T11_; T[1] = -s1; T[2] = -v1; T[3] = -(v1 * q[2]);
    T[4] = T21_; T[5] = c1; T[6] = -v2; T[7] = -(v2 * q[2]);
    T[8] = s2; T[9] = 0.0; T[10] = c2; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void spherical_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double v3 = v1 * q[2];
    const double J11 = v2 * q[2];
    const double v4 = d1 + c2 * q[2] - d1;
    J[0] = J11; J[1] = -(c1 * v4); J[2] = -v1;
    J[3] = -v3; J[4] = -(s1 * v4); J[5] = -v2;
    J[6] = 0.0; J[7] = -(s1 * J11 + c1 * v3); J[8] = c2;
    J[9] = 0.0; J[10] = s1; J[11] = 0.0;
    J[12] = 0.0; J[13] = -c1; J[14] = 0.0;
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

    /* theta2, r3, type 4: U1[1, 4] and U1[2, 4] */
    const double Y2_2 = T34 - d1;
    const double v1 = Y2_2 * Y2_2;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : T14 * factor1;
        const double s1 = free1 ? sin(seed[0]) : T24 * factor1;
        const double q1 = atan2(s1, c1);
        const double root1 = w1 * e1;

        /* theta2, r3 */
        const double w3 = sqrt(root1 * root1 + v1);
        const int free2 = w3 <= free_limit1;
        const double divisor2 = free2 ? 1.0 : w3;

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : Y2_2 * factor2;
            const double s2 = free2 ? sin(seed[1]) : -(root1 * factor2);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = q2;
            q[row][2] = r3;
            status[row] = (free1 || free2) ? SPHERICAL_FREE_JOINT : SPHERICAL_OK;
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

int spherical_ik(const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? SPHERICAL_UNREACHABLE : SPHERICAL_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -SPHERICAL_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == SPHERICAL_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = SPHERICAL_OUT_OF_LIMITS;
        }
        count += status[row] != SPHERICAL_OUT_OF_LIMITS;
    }
    return count;
}

int spherical_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[4][3], least = HUGE_VAL;
    unsigned char status[4];
    int result = -SPHERICAL_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (spherical_ik(T, q_seed, all, status) < 0)
        return -SPHERICAL_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == SPHERICAL_OUT_OF_LIMITS && result < 0)
            result = -SPHERICAL_OUT_OF_LIMITS;
        if (status[row] != SPHERICAL_OK && status[row] != SPHERICAL_FREE_JOINT)
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

void spherical_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)spherical_ik(T + 16 * k, NULL, (double (*)[3])(q + 12 * k), status + 4 * k);
}
