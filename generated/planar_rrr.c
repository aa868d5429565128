/* planar_rrr: Planar arm with three revolute joints
 *
 * Inverse kinematics, generated from robots/planar_rrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rrr.yaml. The formulas and where they come from:
 * planar_rrr.md.
 */
#include "planar_rrr.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double a1 = 0.4; /* link length 1 [m] */
static const double a2 = 0.3; /* link length 2 [m] */
static const double a3 = 0.15; /* link length 3 [m] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double longest2 = 0.48999999999999994; /* square of the longest reach [m^2] */
static const double shortest2 = 0.010000000000000007; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest2_reach = 0.490000000000119;
/* the shortest, with what rounding adds [m^2] */
static const double shortest2_reach = 0.009999999999983007;
/* the longest, where branches merge [m^2] */
static const double longest2_apart = 0.48999999999998795;
/* the shortest, where branches merge [m^2] */
static const double shortest2_apart = 0.010000000000001705;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 7.224999999999999e-25;
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 8.5e-06; /* a pose may be rounded by this [m] */
static const double k1 = 0.25; /* a1^2 + a2^2 [m^2] */
static const double k2 = 4.166666666666667; /* 1 / (2 * a2 * a1) [m^-2] */

const char *const planar_rrr_branches[2] = {
    "down", "up",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void planar_rrr_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2 - s1 * s2;
    const double x2_y = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double T11_ = x2_x * c3 - x2_y * s3;
    const double T21_ = x2_y * c3 + x2_x * s3;
    const double T14_ = c1 * a1 + x2_x * a2 + T11_ * a3;
    const double T24_ = s1 * a1 + x2_y * a2 + T21_ * a3;
    T[0] = T11_; T[1] = -T21_; T[2] = 0.0; T[3] = T14_;
    T[4] = T21_; T[5] = T11_; T[6] = 0.0; T[7] = T24_;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_rrr_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double p1_x = c1 * a1;
    const double p1_y = s1 * a1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2 - s1 * s2;
    const double x2_y = s1 * c2 + c1 * s2;
    const double p2_x = p1_x + x2_x * a2;
    const double p2_y = p1_y + x2_y * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double J21 = p2_x + (x2_x * c3 - x2_y * s3) * a3;
    const double p3_y = p2_y + (x2_y * c3 + x2_x * s3) * a3;
    const double J22 = J21 - p1_x;
    const double J12 = p1_y - p3_y;
    const double J23 = J21 - p2_x;
    const double J13 = p2_y - p3_y;
    J[0] = -p3_y; J[1] = J12; J[2] = J13;
    J[3] = J21; J[4] = J22; J[5] = J23;
    J[6] = 0.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 1.0; J[16] = 1.0; J[17] = 1.0;
}

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
static double misfit(const double T[16])
{
    const double *x = T, *y = T + 4, *z = T + 8;
    const double xx = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1.0;
    const double yy = y[0] * y[0] + y[1] * y[1] + y[2] * y[2] - 1.0;
    const double xy = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    const double z0 = x[1] * y[2] - x[2] * y[1] - z[0];
    const double z1 = x[2] * y[0] - x[0] * y[2] - z[1];
    const double z2 = x[0] * y[1] - x[1] * y[0] - z[2];
    return xx * xx + yy * yy + 2.0 * xy * xy + z0 * z0 + z1 * z1 + z2 * z2;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(double T[16])
{
    double R[9], G[9];
    for (int i = 0; i < 9; i++)
        R[i] = T[4 * (i / 3) + i % 3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[3 * i + j] = (i == j ? 1.5 : 0.0)
                - 0.5 * (R[i] * R[j] + R[3 + i] * R[3 + j] + R[6 + i] * R[6 + j]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[4 * i + j] = R[3 * i] * G[j] + R[3 * i + 1] * G[3 + j] + R[3 * i + 2] * G[6 + j];
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    if (!(fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1.0) <= 1e-09))
        return 0;
    const double miss = misfit(T);
    if (!(miss <= 1e-09))
        return 0;
    if (miss > 1e-24) {
        straighten(T);
        straighten(T);
    }
    return 1;
}

enum { LOST = 128 }; /* LOST + j: the row was lost after joint j had been chosen freely */

/* Fills the rows of the branches that have a solution, and no others. The first value of a row that
 * is LOST says how far it is from a solution (negative). */
static void solve(
    const double T[16], const double seed[3], double q[2][3], unsigned char status[2])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta123, type 3: U0[1, 2] and U0[2, 2] */
    const double w123 = sqrt(T21 * T21 + T11 * T11);
    const int free123 = w123 <= free_limit_squared;
    const double v1 = 1.0 / (free123 ? 1.0 : w123);
    const double v2 = seed[0] + seed[1] + seed[2];
    const double c123 = free123 ? cos(v2) : T11 * v1;
    const double s123 = free123 ? sin(v2) : T21 * v1;
    const double theta123 = atan2(s123, c123);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double v3 = c123 * a3;
    const double Z1_2 = T14 - v3;
    const double v4 = s123 * a3;
    const double Z2_2 = T24 - v4;
    const double N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2;
    const double K2 = N2 - k1;
    const double D2 = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) {
        if (free123) {
            status[0] = LOST + 1;
            q[0][0] = D2;
        }
        if (free123) {
            status[0] = LOST + 2;
            q[0][0] = D2;
        }
        if (free123) {
            status[0] = LOST + 3;
            q[0][0] = D2;
        }
        return; /* out of reach */
    }
    const double w2 = sqrt(apart2 ? D2 : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_1 = a1 + a2 * c2;
    const double v5 = Z2_2 * X1_1;
    const double v6 = Z1_2 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabs(T34) <= pose_slack1 && (fabs(T33 - 1.0) <= pose_slack && (fabs(T32) <= pose_slack &&
        (fabs(T31) <= pose_slack && (fabs(T23) <= pose_slack && (fabs(T22 - c123) <= pose_slack &&
        (fabs(T21 - s123) <= pose_slack && (fabs(T13) <= pose_slack && (fabs(T11 - c123) <=
        pose_slack && fabs(T12 + s123) <= pose_slack))))))))))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e1 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e1 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v5 - Z1_2 * Y1_1;
        const double C1 = v6 + Z2_2 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const double factor1 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : C1 * factor1;
        const double s1 = free1 ? sin(seed[0]) : S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1;
        const double s12 = c2 * s1 + s2 * c1;
        if (!(fabs(T14 - (a2 * c12 + (v3 + a1 * c1))) <= pose_slack1 && fabs(T24 - (a2 * s12 + (v4 +
            a1 * s1))) <= pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q3 = wrap(theta123 - (q2 + q1));
        const int free1_ = free123 || free1;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = q3;
        status[row] = (free1_ || free123 || free123) ? PLANAR_RRR_FREE_JOINT : PLANAR_RRR_OK;
    }
}

/* A row that was lost after a joint had been chosen, and what solving again needs. */
struct search {
    const double *T;
    double seed[3], start, q[2][3];
    unsigned char status[2];
    int joint, row;
};

/* Solves with the joint moved from the seed's value: 0 if the row is solved, else how far it is. */
static double attempt(struct search *lost, double moved)
{
    lost->seed[lost->joint] = lost->start + moved;
    for (int i = 0; i < 2; i++)
        lost->status[i] = PLANAR_RRR_UNREACHABLE;
    solve(lost->T, lost->seed, lost->q, lost->status);
    if (lost->status[lost->row] >= LOST)
        return lost->q[lost->row][0];
    return lost->status[lost->row] == PLANAR_RRR_UNREACHABLE ? -HUGE_VAL : 0.0;
}

/* Golden section for a move between low and high that serves; NaN if there is none. */
static double summit(struct search *lost, double low, double high)
{
    for (int k = 0; k < 52; k++) {
        const double third = 0.3819660112501051 * (high - low);
        const double left = attempt(lost, low + third), right = attempt(lost, high - third);
        if (left == 0.0 || right == 0.0)
            return left == 0.0 ? low + third : high - third;
        if (left >= right)
            high -= third;
        else
            low += third;
    }
    return NAN;
}

/* A free joint took the seed's value, and then the arm could not reach: takes the nearest value
 * that serves. A fan of values shows where the branch is solved or nearly so, golden section finds
 * what lies between two of them, bisection the end that is nearest to the seed. */
static void choose_again(struct search *lost, double q[3], unsigned char *status)
{
    const double step = turn / 64.0;
    double nearest = NAN, before, here = -HUGE_VAL, after = attempt(lost, -turn / 2.0);
    for (int k = -32; k <= 32; k++) {
        before = here;
        here = after;
        after = attempt(lost, (double)(k + 1) * step);
        double outer = (double)k * step, inner = k > 0 ? outer - step : k < 0 ? outer + step : 0.0;
        if (here < 0.0 && here >= before && here > after)
            outer = summit(lost, outer - step, outer + step);
        else if (here < 0.0 || (k > 0 ? before : after) == 0.0)
            continue;
        if (isnan(outer))
            continue;
        for (int i = 0; i < 52; i++) {
            const double middle = 0.5 * (inner + outer);
            if (attempt(lost, middle) == 0.0)
                outer = middle;
            else
                inner = middle;
        }
        if (!(fabs(outer) >= fabs(nearest)))
            nearest = outer;
    }
    *status = PLANAR_RRR_UNREACHABLE;
    if (isnan(nearest) || attempt(lost, nearest) != 0.0)
        nearest = NAN;
    else
        *status = lost->status[lost->row];
    for (int i = 0; i < 3; i++)
        q[i] = isnan(nearest) ? NAN : lost->q[lost->row][i];
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

int planar_rrr_ik(
    const double T[16], const double *q_seed, double q[2][3], unsigned char status[2])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? PLANAR_RRR_UNREACHABLE : PLANAR_RRR_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PLANAR_RRR_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] >= LOST) {
            struct search lost = { .T = pose, .joint = status[row] - LOST - 1, .row = row };
            lost.start = seed[lost.joint];
            for (int i = 0; i < 3; i++)
                lost.seed[i] = seed[i];
            choose_again(&lost, q[row], &status[row]);
        }
        if (status[row] == PLANAR_RRR_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PLANAR_RRR_OUT_OF_LIMITS;
        }
        count += status[row] != PLANAR_RRR_OUT_OF_LIMITS;
    }
    return count;
}

int planar_rrr_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[2][3], least = HUGE_VAL;
    unsigned char status[2];
    int result = -PLANAR_RRR_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (planar_rrr_ik(T, q_seed, all, status) < 0)
        return -PLANAR_RRR_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == PLANAR_RRR_OUT_OF_LIMITS && result < 0)
            result = -PLANAR_RRR_OUT_OF_LIMITS;
        if (status[row] != PLANAR_RRR_OK && status[row] != PLANAR_RRR_FREE_JOINT)
            continue;
        for (int i = 0; i < 3; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
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

void planar_rrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)planar_rrr_ik(T + 16 * k, NULL, (double (*)[3])(q + 6 * k), status + 2 * k);
}
