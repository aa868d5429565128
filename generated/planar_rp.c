/* planar_rp: Planar arm with a revolute and a prismatic joint
 *
 * Inverse kinematics, generated from robots/planar_rp.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rp.yaml. The formulas and where they come from:
 * planar_rp.md.
 */
#include "planar_rp.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double free_limit1 = 1e-12; /* a length that fixes no angle [m] */
static const double offset1 = 1.5707963267948966; /* offset of joint 1 [rad] */

const char *const planar_rp_branches[2] = {
    "forward", "backward",
};

static const double lowest[2] = { -INFINITY, 0.0 };
static const double highest[2] = { INFINITY, 1.0 };
static const int revolute[2] = { 1, 0 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[2] = { 1.0, 1.0 };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void planar_rp_fk(const double q[2], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1);
    const double s1 = sin(v1);
    const double T14_ = s1 * q[1];
    T[0] = c1; T[1] = 0.0; T[2] = s1; T[3] = T14_;
    T[4] = s1; T[5] = 0.0; T[6] = -c1; T[7] = -(c1 * q[1]);
    T[8] = 0.0; T[9] = 1.0; T[10] = 0.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_rp_jacobian(const double q[2], double J[12])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1);
    const double s1 = sin(v1);
    const double J21 = s1 * q[1];
    const double J11 = c1 * q[1];
    J[0] = J11; J[1] = s1;
    J[2] = J21; J[3] = -c1;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 1.0; J[11] = 0.0;
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7])))
        return 0;
    return 1;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[2], double q[2][2], unsigned char status[2])
{
    const double T14 = T[3];
    const double T24 = T[7];

    /* theta1, r2, type 4: U0[1, 4] and U0[2, 4] */
    const double w2 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w2 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w2;
    const double v1 = seed[0] + offset1;

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1, r2 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(v1) : -(T24 * factor1);
        const double s1 = free1 ? sin(v1) : T14 * factor1;
        const double r2 = w2 * e1;

        /* joint values */
        const double q1 = wrap(atan2(s1, c1) - offset1);
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = r2;
        status[row] = (free1) ? PLANAR_RP_FREE_JOINT : PLANAR_RP_OK;
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

int planar_rp_ik(const double T[16], const double *q_seed, double q[2][2], unsigned char status[2])
{
    static const double zeros[2] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? PLANAR_RP_UNREACHABLE : PLANAR_RP_INVALID_POSE;
        for (int i = 0; i < 2; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PLANAR_RP_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == PLANAR_RP_UNREACHABLE)
            continue;
        for (int i = 0; i < 2; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PLANAR_RP_OUT_OF_LIMITS;
        }
        count += status[row] != PLANAR_RP_OUT_OF_LIMITS;
    }
    return count;
}

int planar_rp_ik_nearest(const double T[16], const double q_seed[2], double q[2])
{
    double all[2][2], least = HUGE_VAL;
    unsigned char status[2];
    int result = -PLANAR_RP_UNREACHABLE;
    for (int i = 0; i < 2; i++)
        q[i] = NAN;
    if (planar_rp_ik(T, q_seed, all, status) < 0)
        return -PLANAR_RP_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == PLANAR_RP_OUT_OF_LIMITS && result < 0)
            result = -PLANAR_RP_OUT_OF_LIMITS;
        if (status[row] != PLANAR_RP_OK && status[row] != PLANAR_RP_FREE_JOINT)
            continue;
        for (int i = 0; i < 2; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 2; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void planar_rp_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)planar_rp_ik(T + 16 * k, NULL, (double (*)[2])(q + 4 * k), status + 2 * k);
}
