/* planar_pr: Inclined slider with a revolute link
 *
 * Inverse kinematics, generated from robots/planar_pr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_pr.yaml. The formulas and where they come from:
 * planar_pr.md.
 */
#include "planar_pr.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double a = 0.3; /* x of the home pose [m] */
static const double k1 = 3.3333333333333335; /* 1 / a [m^-1] */
static const double k2 = 1.6666666666666667; /* 1 / 2 * 1 / a [m^-1] */
static const double k3 = 2.8867513459481287; /* sqrt3 * 1 / 2 * 1 / a [m^-1] */
/* (1 / 2 * 1 / a)^2 + (sqrt3 * 1 / 2 * 1 / a)^2 [m^-2] */
static const double k4 = 11.11111111111111;
/* 2 * ((1 / 2 * 1 / a)^2 + (sqrt3 * 1 / 2 * 1 / a)^2) * reach_slack [m^-2] */
static const double k5 = 2.2222222222222224e-12;
/* 2 * ((1 / 2 * 1 / a)^2 + (sqrt3 * 1 / 2 * 1 / a)^2) * merge_slack [m^-2] */
static const double k6 = 2.2222222222222222e-13;
static const double k7 = 0.09; /* 1 / ((1 / 2 * 1 / a)^2 + (sqrt3 * 1 / 2 * 1 / a)^2) [m^2] */
static const double f1 = 0.5; /* 1 / 2 */
static const double f2 = 0.8660254037844386; /* 1 / 2 * sqrt3 */
static const double f3 = 0.9999999999999999; /* (1 / 2)^2 + (1 / 2 * sqrt3)^2 */
static const double g1 = 0.5; /* 1 / 2 */
static const double g2 = 0.8660254037844386; /* 1 / 2 * sqrt3 */
static const double g3 = 0.9999999999999999; /* (1 / 2)^2 + (1 / 2 * sqrt3)^2 */

const char *const planar_pr_branches[2] = {
    "forward", "backward",
};

static const double lowest[2] = { -INFINITY, -INFINITY };
static const double highest[2] = { INFINITY, INFINITY };
static const int revolute[2] = { 0, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[2] = { 11.11111111111111, 1.0 };

void planar_pr_fk(const double q[2], double T[16])
{
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T11_ = f3 * c2;
    const double T21_ = f3 * s2;
    const double T14_ = f2 * q[0] + T11_ * a;
    const double T24_ = f1 * q[0] + T21_ * a;
    T[0] = T11_; T[1] = -T21_; T[2] = 0.0; T[3] = T14_;
    T[4] = T21_; T[5] = T11_; T[6] = 0.0; T[7] = T24_;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_pr_jacobian(const double q[2], double J[12])
{
    const double p1_x = g2 * q[0];
    const double p1_y = g1 * q[0];
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double J22 = p1_x + g3 * c2 * a - p1_x;
    const double J12 = p1_y - (p1_y + g3 * s2 * a);
    J[0] = g2; J[1] = J12;
    J[2] = g1; J[3] = J22;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 0.0; J[11] = 1.0;
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
    (void)seed;
    const double T14 = T[3];
    const double T24 = T[7];

    /* theta2, r1, type 5: U0[2, 4] and U0[1, 4] */
    const double V1_2 = T24 * k1;
    const double V2_2 = T14 * k1;
    const double v1 = V1_2 * k2 + V2_2 * k3;
    const double v2 = k2 * V2_2 - V1_2 * k3;
    const double D1 = k4 - v2 * v2;
    const int apart2 = k6 < D1;
    if (!(-k5 <= D1)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D1 : 0.0);

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2, r1 */
        if (e1 < 0.0 && !apart2) continue; /* both signs give the same */
        const double r1 = (v1 + w2 * e1) * k7;
        const double s2 = V1_2 - k2 * r1;
        const double c2 = V2_2 - k3 * r1;
        const double q2 = atan2(s2, c2);
        const int row = i1;
        q[row][0] = r1;
        q[row][1] = q2;
        status[row] = PLANAR_PR_OK;
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

int planar_pr_ik(const double T[16], const double *q_seed, double q[2][2], unsigned char status[2])
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
    if (planar_pr_ik(T, q_seed, all, status) < 0)
        return -PLANAR_PR_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == PLANAR_PR_OUT_OF_LIMITS && result < 0)
            result = -PLANAR_PR_OUT_OF_LIMITS;
        if (status[row] != PLANAR_PR_OK && status[row] != PLANAR_PR_FREE_JOINT)
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

void planar_pr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)planar_pr_ik(T + 16 * k, NULL, (double (*)[2])(q + 4 * k), status + 2 * k);
}
