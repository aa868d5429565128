/* cartesian: Cartesian arm
 *
 * Inverse kinematics, generated from robots/cartesian.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cartesian.yaml. The formulas and where they come from:
 * cartesian.md.
 */
#include "cartesian.h"

#include <math.h>


const char *const cartesian_branches[1] = {
    "only",
};

static const double lowest[3] = { 0.0, 0.0, 0.0 };
static const double highest[3] = { 0.8, 0.6, 1.2 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 1.0, 1.0, 1.0 };

void cartesian_fk(const double q[3], double T[16])
{
    T[0] = 0.0; T[1] = 0.0; T[2] = 1.0; T[3] = q[2];
    T[4] = 0.0; T[5] = -1.0; T[6] = 0.0; T[7] = q[1];
    T[8] = 1.0; T[9] = 0.0; T[10] = 0.0; T[11] = q[0];
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void cartesian_jacobian(const double q[3], double J[18])
{
    (void)q;
    J[0] = 0.0; J[1] = 0.0; J[2] = 1.0;
    J[3] = 0.0; J[4] = 1.0; J[5] = 0.0;
    J[6] = 1.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
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
    const double T[16], const double seed[3], double q[1][3], unsigned char status[1])
{
    (void)seed;
    const double T14 = T[3];
    const double T24 = T[7];
    const double T34 = T[11];

    const int row = 0;
    q[row][0] = T34;
    q[row][1] = T24;
    q[row][2] = T14;
    status[row] = CARTESIAN_OK;
}

static int inside(int joint, double value)
{
    return lowest[joint] - 1e-09 <= value && value <= highest[joint] + 1e-09;
}

int cartesian_ik(const double T[16], const double *q_seed, double q[1][3], unsigned char status[1])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 1; row++) {
        status[row] = valid ? CARTESIAN_UNREACHABLE : CARTESIAN_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -CARTESIAN_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 1; row++) {
        if (status[row] == CARTESIAN_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            if (!inside(i, q[row][i]))
                status[row] = CARTESIAN_OUT_OF_LIMITS;
        }
        count += status[row] != CARTESIAN_OUT_OF_LIMITS;
    }
    return count;
}

int cartesian_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[1][3], least = HUGE_VAL;
    unsigned char status[1];
    int result = -CARTESIAN_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (cartesian_ik(T, q_seed, all, status) < 0)
        return -CARTESIAN_INVALID_POSE;
    for (int row = 0; row < 1; row++) {
        double distance = 0.0;
        if (status[row] == CARTESIAN_OUT_OF_LIMITS && result < 0)
            result = -CARTESIAN_OUT_OF_LIMITS;
        if (status[row] != CARTESIAN_OK && status[row] != CARTESIAN_FREE_JOINT)
            continue;
        for (int i = 0; i < 3; i++) {
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

void cartesian_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)cartesian_ik(T + 16 * k, NULL, (double (*)[3])(q + 3 * k), status + 1 * k);
}
