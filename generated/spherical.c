/* spherical: Spherical arm
 * Inverse kinematics, generated from robots/spherical.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical.yaml. The formulas and where they come from: spherical.md.
 */
#include "spherical.h"

#include <math.h>

static const double free_tolerance1 = 5e-13; /* a vector this short fixes no angle [length] */
static const double d1 = 0.5; /* joint offset 1 */

const char *const spherical_branches[4] = {
    "left-forward",
    "left-backward",
    "right-forward",
    "right-backward",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const double turn = 6.283185307179586;
static const int revolute[3] = { 1, 1, 0 };
static const double weight[3] = { 1.0, 1.0, 4.0 }; /* of squared differences: lengths by arm size */

void spherical_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T11 = c1 * c2;
    const double T21 = s1 * c2;
    const double v8 = c1 * s2;
    const double v9 = s1 * s2;
    const double T34 = d1 + c2 * q[2];
    T[0] = T11; T[1] = -s1; T[2] = -v8; T[3] = -(v8 * q[2]);
    T[4] = T21; T[5] = c1; T[6] = -v9; T[7] = -(v9 * q[2]);
    T[8] = s2; T[9] = 0.0; T[10] = c2; T[11] = T34;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void spherical_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v6 = c1 * s2;
    const double v7 = s1 * s2;
    const double v8 = v6 * q[2];
    const double J11 = v7 * q[2];
    const double v9 = d1 + c2 * q[2] - d1;
    J[0] = J11; J[1] = -(c1 * v9); J[2] = -v6;
    J[3] = -v8; J[4] = -(s1 * v9); J[5] = -v7;
    J[6] = 0.0; J[7] = -(s1 * J11 + c1 * v8); J[8] = c2;
    J[9] = 0.0; J[10] = s1; J[11] = 0.0;
    J[12] = 0.0; J[13] = -c1; J[14] = 0.0;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one. Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!isfinite(T[3]))
        return 0;
    if (!isfinite(T[7]))
        return 0;
    if (!isfinite(T[11]))
        return 0;
    return 1;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(const double T[16], const double seed[3],
    double q[4][3], unsigned char status[4])
{

    /* theta1: type 2 */
    const double w1 = sqrt(T[3] * T[3] + T[7] * T[7]);
    const int free1 = w1 <= free_tolerance1;
    const double v12 = free1 ? 1.0 : w1;

    /* theta2, r3: type 4 */
    const double v15 = T[11] - d1;
    const double v16 = v15 * v15;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1: type 2 */
        if (e1 < 0.0 && free1) continue;
        const double v13 = e1 / v12;
        const double c1 = free1 ? cos(seed[0]) : T[3] * v13;
        const double s1 = free1 ? sin(seed[0]) : T[7] * v13;
        const double q1 = atan2(s1, c1);
        const double v14 = w1 * e1;

        /* theta2, r3: type 4 */
        const double w3 = sqrt(v14 * v14 + v16);
        const int free2 = w3 <= free_tolerance1;
        const double v17 = free2 ? 1.0 : w3;

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3: type 4 */
            if (e2 < 0.0 && free2) continue;
            const double v18 = e2 / v17;
            const double c2 = free2 ? cos(seed[1]) : v15 * v18;
            const double s2 = free2 ? sin(seed[1]) : -(v14 * v18);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = q2;
            q[row][2] = r3;
            status[row] = free1 || free2 ? SPHERICAL_FREE_JOINT : SPHERICAL_OK;
        }
    }
}

/* A joint value moved by whole turns, near to another value but inside its limits. */
static double turned(int joint, double value, double towards)
{
    const double low = lowest[joint] - 1e-09, high = highest[joint] + 1e-09;
    if (!revolute[joint])
        return value;
    value += turn * floor((towards - value) / turn + 0.5);
    if (value > high)
        value -= turn * ceil((value - high) / turn);
    if (value < low)
        value += turn * ceil((low - value) / turn);
    return value;
}

static int inside(int joint, double value)
{
    return lowest[joint] - 1e-09 <= value && value <= highest[joint] + 1e-09;
}

int spherical_ik(const double T[16], const double *q_seed,
    double q[4][3], unsigned char status[4])
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
    if (spherical_ik(T, q_seed, all, status) == -SPHERICAL_INVALID_POSE)
        return -SPHERICAL_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == SPHERICAL_OUT_OF_LIMITS && result == -SPHERICAL_UNREACHABLE)
            result = -SPHERICAL_OUT_OF_LIMITS;
        if (status[row] != SPHERICAL_OK && status[row] != SPHERICAL_FREE_JOINT)
            continue;
        for (int i = 0; i < 3; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            distance += weight[i] * (all[row][i] - q_seed[i]) * (all[row][i] - q_seed[i]);
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
