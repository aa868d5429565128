/* planar_rr: Planar arm with two revolute joints
 *
 * Inverse kinematics, generated from robots/planar_rr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rr.yaml. The formulas and where they come from:
 * planar_rr.md.
 */
#include "planar_rr.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double a1 = 0.4; /* link length 1 [m] */
static const double a2 = 0.3; /* link length 2 [m] */
static const double longest2 = 0.48999999999999994; /* square of the longest reach [m^2] */
static const double shortest2 = 0.010000000000000007; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest2_reach = 0.490000000000098;
/* the shortest, with what rounding adds [m^2] */
static const double shortest2_reach = 0.009999999999986006;
/* the longest, where branches merge [m^2] */
static const double longest2_apart = 0.48999999999999017;
/* the shortest, where branches merge [m^2] */
static const double shortest2_apart = 0.010000000000001405;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 4.899999999999999e-25;
static const double k1 = 0.25; /* a1^2 + a2^2 [m^2] */
static const double k2 = 4.166666666666667; /* 1 / (2 * a2 * a1) [m^-2] */

const char *const planar_rr_branches[2] = {
    "down", "up",
};

static const double lowest[2] = { -INFINITY, -INFINITY };
static const double highest[2] = { INFINITY, INFINITY };

void planar_rr_fk(const double q[2], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T11_ = c1 * c2 - s1 * s2;
    const double T21_ = s1 * c2 + c1 * s2;
    const double T14_ = c1 * a1 + T11_ * a2;
    const double T24_ = s1 * a1 + T21_ * a2;
    T[0] = T11_; T[1] = -T21_; T[2] = 0.0; T[3] = T14_;
    T[4] = T21_; T[5] = T11_; T[6] = 0.0; T[7] = T24_;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_rr_jacobian(const double q[2], double J[12])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double p1_x = c1 * a1;
    const double p1_y = s1 * a1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double J21 = p1_x + (c1 * c2 - s1 * s2) * a2;
    const double p2_y = p1_y + (s1 * c2 + c1 * s2) * a2;
    const double J22 = J21 - p1_x;
    const double J12 = p1_y - p2_y;
    J[0] = -p2_y; J[1] = J12;
    J[2] = J21; J[3] = J22;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 1.0; J[11] = 1.0;
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

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double N2 = T14 * T14 + T24 * T24;
    const double K2 = N2 - k1;
    const double D2 = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D2 : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_1 = a1 + a2 * c2;
    const double v1 = T24 * X1_1;
    const double v2 = T14 * X1_1;

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e1 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e1 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v1 - T14 * Y1_1;
        const double C1 = v2 + T24 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const double factor1 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : C1 * factor1;
        const double s1 = free1 ? sin(seed[0]) : S1 * factor1;
        const double q1 = atan2(s1, c1);
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        status[row] = (free1) ? PLANAR_RR_FREE_JOINT : PLANAR_RR_OK;
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

int planar_rr_ik(const double T[16], const double *q_seed, double q[2][2], unsigned char status[2])
{
    static const double zeros[2] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? PLANAR_RR_UNREACHABLE : PLANAR_RR_INVALID_POSE;
        for (int i = 0; i < 2; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PLANAR_RR_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == PLANAR_RR_UNREACHABLE)
            continue;
        for (int i = 0; i < 2; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PLANAR_RR_OUT_OF_LIMITS;
        }
        count += status[row] != PLANAR_RR_OUT_OF_LIMITS;
    }
    return count;
}

int planar_rr_ik_nearest(const double T[16], const double q_seed[2], double q[2])
{
    double all[2][2], least = HUGE_VAL;
    unsigned char status[2];
    int result = -PLANAR_RR_UNREACHABLE;
    for (int i = 0; i < 2; i++)
        q[i] = NAN;
    if (planar_rr_ik(T, q_seed, all, status) < 0)
        return -PLANAR_RR_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == PLANAR_RR_OUT_OF_LIMITS && result < 0)
            result = -PLANAR_RR_OUT_OF_LIMITS;
        if (status[row] != PLANAR_RR_OK && status[row] != PLANAR_RR_FREE_JOINT)
            continue;
        for (int i = 0; i < 2; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
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

void planar_rr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)planar_rr_ik(T + 16 * k, NULL, (double (*)[2])(q + 4 * k), status + 2 * k);
}
