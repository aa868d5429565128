/* planar_pr: Inclined slider with a revolute link
 * Inverse kinematics, generated from robots/planar_pr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_pr.yaml. The formulas and where they come from: planar_pr.md.
 */
#include "planar_pr.h"

#include <math.h>

static const double k3 = 3.3333333333333335; /* 1 / a */
static const double k4 = 1.6666666666666667; /* (1 / 2) * (1 / a) */
static const double k5 = 2.8867513459481287; /* (sqrt3 * (1 / 2)) * (1 / a) */
static const double k8 = 11.11111111111111; /* (((1 / 2) * (1 / a)) * ((1 / 2) * (1 / a))) + (((sqrt3 * (1 / 2)) * (1 / a)) * ((sqrt3 * (1 / 2)) * (1 / a))) */
static const double k10 = 2.2222222222222224e-12; /* (2 * ((((1 / 2) * (1 / a)) * ((1 / 2) * (1 / a))) + (((sqrt3 * (1 / 2)) * (1 / a)) * ((sqrt3 * (1 / 2)) * (1 / a))))) * reach_tolerance */
static const double k11 = 2.2222222222222222e-13; /* (2 * ((((1 / 2) * (1 / a)) * ((1 / 2) * (1 / a))) + (((sqrt3 * (1 / 2)) * (1 / a)) * ((sqrt3 * (1 / 2)) * (1 / a))))) * merge_tolerance */
static const double k12 = 0.09; /* 1 / ((((1 / 2) * (1 / a)) * ((1 / 2) * (1 / a))) + (((sqrt3 * (1 / 2)) * (1 / a)) * ((sqrt3 * (1 / 2)) * (1 / a)))) */
static const double f1 = 0.5; /* 1 / 2 */
static const double f2 = 0.8660254037844386; /* (1 / 2) * sqrt3 */
static const double f6 = 0.9999999999999999; /* ((1 / 2) * (1 / 2)) + (((1 / 2) * sqrt3) * ((1 / 2) * sqrt3)) */
static const double a = 0.3; /* x of the home pose */
static const double g1 = 0.5; /* 1 / 2 */
static const double g2 = 0.8660254037844386; /* (1 / 2) * sqrt3 */
static const double g6 = 0.9999999999999999; /* ((1 / 2) * (1 / 2)) + (((1 / 2) * sqrt3) * ((1 / 2) * sqrt3)) */

const char *const planar_pr_branches[2] = {
    "forward",
    "backward",
};

static const double lowest[2] = { -INFINITY, -INFINITY };
static const double highest[2] = { INFINITY, INFINITY };
static const double turn = 6.283185307179586;
static const int revolute[2] = { 0, 1 };
static const double weight[2] = { 11.11111111111111, 1.0 }; /* of squared differences: lengths by arm size */

void planar_pr_fk(const double q[2], double T[16])
{
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T11 = f6 * c2;
    const double T21 = f6 * s2;
    const double T14 = f2 * q[0] + T11 * a;
    const double T24 = f1 * q[0] + T21 * a;
    T[0] = T11; T[1] = -T21; T[2] = 0.0; T[3] = T14;
    T[4] = T21; T[5] = T11; T[6] = 0.0; T[7] = T24;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_pr_jacobian(const double q[2], double J[12])
{
    const double v5 = g2 * q[0];
    const double v6 = g1 * q[0];
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double J22 = v5 + g6 * c2 * a - v5;
    const double J12 = v6 - (v6 + g6 * s2 * a);
    J[0] = g2; J[1] = J12;
    J[2] = g1; J[3] = J22;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 0.0; J[11] = 1.0;
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
    return 1;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(const double T[16], const double seed[2],
    double q[2][2], unsigned char status[2])
{
    (void)seed;

    /* theta2, r1: type 5 */
    const double v8 = T[7] * k3;
    const double v9 = T[3] * k3;
    const double v10 = v8 * k4 + v9 * k5;
    const double v11 = k4 * v9 - v8 * k5;
    const double D1 = k8 - v11 * v11;
    const int apart2 = k11 < D1;
    if (!(-k10 <= D1)) return;
    const double w2 = sqrt(apart2 ? D1 : 0.0);

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2, r1: type 5 */
        if (e1 < 0.0 && !apart2) continue;
        const double r1 = (v10 + w2 * e1) * k12;
        const double s2 = v8 - k4 * r1;
        const double c2 = v9 - k5 * r1;
        const double q2 = atan2(s2, c2);
        const int row = i1;
        q[row][0] = r1;
        q[row][1] = q2;
        status[row] = PLANAR_PR_OK;
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

int planar_pr_ik(const double T[16], const double *q_seed,
    double q[2][2], unsigned char status[2])
{
    static const double zeros[2] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? PLANAR_PR_UNREACHABLE : PLANAR_PR_INVALID_POSE;
        for (int i = 0; i < 2; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PLANAR_PR_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == PLANAR_PR_UNREACHABLE)
            continue;
        for (int i = 0; i < 2; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PLANAR_PR_OUT_OF_LIMITS;
        }
        count += status[row] != PLANAR_PR_OUT_OF_LIMITS;
    }
    return count;
}

int planar_pr_ik_nearest(const double T[16], const double q_seed[2], double q[2])
{
    double all[2][2], least = HUGE_VAL;
    unsigned char status[2];
    int result = -PLANAR_PR_UNREACHABLE;
    for (int i = 0; i < 2; i++)
        q[i] = NAN;
    if (planar_pr_ik(T, q_seed, all, status) == -PLANAR_PR_INVALID_POSE)
        return -PLANAR_PR_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == PLANAR_PR_OUT_OF_LIMITS && result == -PLANAR_PR_UNREACHABLE)
            result = -PLANAR_PR_OUT_OF_LIMITS;
        if (status[row] != PLANAR_PR_OK && status[row] != PLANAR_PR_FREE_JOINT)
            continue;
        for (int i = 0; i < 2; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            distance += weight[i] * (all[row][i] - q_seed[i]) * (all[row][i] - q_seed[i]);
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

void planar_pr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)planar_pr_ik(T + 16 * k, NULL, (double (*)[2])(q + 4 * k), status + 2 * k);
}
