/* olson_pprrrr: Olson PPRRRR arm
 *
 * Inverse kinematics, generated from robots/olson_pprrrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/olson_pprrrr.yaml. The formulas and where they come from:
 * olson_pprrrr.md.
 */
#include "olson_pprrrr.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d3 = 1.0; /* joint offset 3 [m] */
static const double a4 = 4.0; /* link length 5 [m] */
static const double d6 = 2.0; /* joint offset 6 [m] */
static const double free_limit = 1e-12; /* a length that fixes no angle */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 4.9e-23;
static const double reach_slack1 = 7e-13; /* rounding at the boundary of the workspace [m] */
static const double merge_slack1 = 7e-14; /* nearer to that boundary two branches are one [m] */

const char *const olson_pprrrr_branches[4] = {
    "noflip3-noflip5", "noflip3-flip5", "flip3-noflip5", "flip3-flip5",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 0, 0, 1, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 0.02040816326530612, 0.02040816326530612, 1.0, 1.0, 1.0, 1.0 };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void olson_pprrrr_fk(const double q[6], double T[16])
{
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = s3 * c4;
    const double v1 = c3 * c4;
    const double v2 = s3 * s4;
    const double y4_y = c3 * s4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5 - v2 * s5;
    const double x5_y = y4_y * s5 - v1 * c5;
    const double x5_z = s4 * c5 + c4 * s5;
    const double T13_ = v2 * c5 + x4_x * s5;
    const double y5_y = y4_y * c5 + v1 * s5;
    const double y5_z = c4 * c5 - s4 * s5;
    const double T14_ = q[1] + x4_x * a4 + T13_ * d6;
    const double T24_ = q[0] - v1 * a4 - y5_y * d6;
    const double T34_ = d3 + s4 * a4 - y5_z * d6;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 - c3 * s6;
    const double T21_ = x5_y * c6 - s3 * s6;
    const double T31_ = x5_z * c6;
    T[0] = T11_; T[1] = -(c3 * c6 + x5_x * s6); T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = -(s3 * c6 + x5_y * s6); T[6] = -y5_y; T[7] = T24_;
    T[8] = T31_; T[9] = -(x5_z * s6); T[10] = -y5_z; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void olson_pprrrr_jacobian(const double q[6], double J[36])
{
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = s3 * c4;
    const double v1 = c3 * c4;
    const double p5_x = q[1] + x4_x * a4;
    const double p5_y = q[0] - v1 * a4;
    const double p5_z = d3 + s4 * a4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J46 = s3 * s4 * c5 + x4_x * s5;
    const double y5_y = c3 * s4 * c5 + v1 * s5;
    const double y5_z = c4 * c5 - s4 * s5;
    const double p6_x = p5_x + J46 * d6;
    const double p6_y = p5_y - y5_y * d6;
    const double p6_z = p5_z - y5_z * d6;
    const double J23 = p6_x - q[1];
    const double v2 = p6_y - q[0];
    const double v3 = p6_z - d3;
    const double J24 = c3 * v3;
    const double J34 = s3 * J23 - c3 * v2;
    const double v4 = p6_z - p5_z;
    const double J25 = c3 * v4;
    const double J35 = s3 * (p6_x - p5_x) - c3 * (p6_y - p5_y);
    J[0] = 0.0; J[1] = 1.0; J[2] = -v2; J[3] = -(s3 * v3); J[4] = -(s3 * v4); J[5] = 0.0;
    J[6] = 1.0; J[7] = 0.0; J[8] = J23; J[9] = J24; J[10] = J25; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = J34; J[16] = J35; J[17] = 0.0;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = -c3; J[22] = -c3; J[23] = J46;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = -s3; J[28] = -s3; J[29] = -y5_y;
    J[30] = 0.0; J[31] = 0.0; J[32] = 1.0; J[33] = 0.0; J[34] = 0.0; J[35] = -y5_z;
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
    const double T[16], const double seed[6], double q[4][6], unsigned char status[4])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta3, type 2: U3[2, 3] */
    const double w3 = sqrt(T23 * T23 + T13 * T13);
    const int free3 = w3 <= free_limit;
    const double divisor3 = free3 ? 1.0 : w3;

    /* theta5, type 2: U0 (A5 A6)^-1 [3, 4] */
    const double X5 = T33 * a4;
    const double v1 = T33 * d6 + (d3 - T34);
    const double v2 = X5 * X5;
    const double v3 = v1 * v1;
    const double v4 = 2.0 * fabs(v1);
    const double v5 = merge_slack1 * (v4 + merge_slack1);
    const double v6 = X5 * v1;

    /* r2, type 1: U0 A6^-1 [1, 4] */
    const double wx = T14 - T13 * d6;

    /* r1, type 1: U0 A6^-1 [2, 4] */
    const double wy = T24 - T23 * d6;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip3, flip3 */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e1 < 0.0 && free3) continue; /* both signs give the same */
        const double factor3 = e1 / divisor3;
        const double c3 = free3 ? cos(seed[2]) : T23 * factor3;
        const double s3 = free3 ? sin(seed[2]) : -(T13 * factor3);
        const double q3 = atan2(s3, c3);
        const double root3 = w3 * e1;

        /* theta45, type 3: U3[3, 3] and U3[1, 3] */
        const double theta45 = atan2(-root3, -T33);

        /* theta6, type 3: U3[2, 2] and U3[2, 1] */
        const double Z1_6 = T12 * c3 + T22 * s3;
        const double Z2_6 = T11 * c3 + T21 * s3;
        const double q6 = atan2(-Z2_6, -Z1_6);

        /* theta5 */
        const double Y5 = a4 * (T32 * Z2_6 - T31 * Z1_6);
        const double N5 = v2 + Y5 * Y5;
        const double D5 = N5 - v3;
        const int free5 = N5 <= free_limit_squared2;
        const int apart5 = v5 < D5;
        if (!(-(reach_slack1 * (v4 + reach_slack1)) <= D5)) {
            if (free3) {
                status[2 * i1] = LOST + 3;
                q[2 * i1][0] = D5;
            }
            continue; /* out of reach */
        }
        const double w5 = sqrt(apart5 ? D5 : 0.0);
        const double inverse5 = 1.0 / (free5 ? 1.0 : N5);
        const double v7 = Y5 * v1;

        /* r2 */
        const double v9 = s3 * a4;

        /* r1 */
        const double v10 = c3 * a4;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip5, flip5 */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta5 */
            if (e2 < 0.0 && (free5 || !apart5)) continue; /* both signs give the same */
            const double root5 = w5 * e2;
            const double c5 = free5 ? cos(seed[4]) : -(inverse5 * (v7 + X5 * root5));
            const double s5 = free5 ? sin(seed[4]) : inverse5 * (Y5 * root5 - v6);
            const double q5 = atan2(s5, c5);

            /* r2 */
            const double v8 = T33 * c5 + root3 * s5;
            const double r2 = wx + v8 * v9;

            /* r1 */
            const double r1 = wy - v8 * v10;

            /* joint values */
            const double q4 = wrap(theta45 - q5);
            const int row = 2 * i1 + i2;
            q[row][0] = r1;
            q[row][1] = r2;
            q[row][2] = q3;
            q[row][3] = q4;
            q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free3 || free5) ? OLSON_PPRRRR_FREE_JOINT : OLSON_PPRRRR_OK;
        }
    }
}

/* A row that was lost after a joint had been chosen, and what solving again needs. */
struct search {
    const double *T;
    double seed[6], start, q[4][6];
    unsigned char status[4];
    int joint, row;
};

/* Solves with the joint moved from the seed's value: 0 if the row is solved, else how far it is. */
static double attempt(struct search *lost, double moved)
{
    lost->seed[lost->joint] = lost->start + moved;
    for (int i = 0; i < 4; i++)
        lost->status[i] = OLSON_PPRRRR_UNREACHABLE;
    solve(lost->T, lost->seed, lost->q, lost->status);
    if (lost->status[lost->row] >= LOST)
        return lost->q[lost->row][0];
    return lost->status[lost->row] == OLSON_PPRRRR_UNREACHABLE ? -HUGE_VAL : 0.0;
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
static void choose_again(struct search *lost, double q[6], unsigned char *status)
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
    *status = OLSON_PPRRRR_UNREACHABLE;
    if (isnan(nearest) || attempt(lost, nearest) != 0.0)
        nearest = NAN;
    else
        *status = lost->status[lost->row];
    for (int i = 0; i < 6; i++)
        q[i] = isnan(nearest) ? NAN : lost->q[lost->row][i];
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

int olson_pprrrr_ik(
    const double T[16], const double *q_seed, double q[4][6], unsigned char status[4])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? OLSON_PPRRRR_UNREACHABLE : OLSON_PPRRRR_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -OLSON_PPRRRR_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] >= LOST) {
            struct search lost = { .T = pose, .joint = status[row] - LOST - 1, .row = row };
            lost.start = seed[lost.joint];
            for (int i = 0; i < 6; i++)
                lost.seed[i] = seed[i];
            choose_again(&lost, q[row], &status[row]);
        }
        if (status[row] == OLSON_PPRRRR_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = OLSON_PPRRRR_OUT_OF_LIMITS;
        }
        count += status[row] != OLSON_PPRRRR_OUT_OF_LIMITS;
    }
    return count;
}

int olson_pprrrr_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[4][6], least = HUGE_VAL;
    unsigned char status[4];
    int result = -OLSON_PPRRRR_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (olson_pprrrr_ik(T, q_seed, all, status) < 0)
        return -OLSON_PPRRRR_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == OLSON_PPRRRR_OUT_OF_LIMITS && result < 0)
            result = -OLSON_PPRRRR_OUT_OF_LIMITS;
        if (status[row] != OLSON_PPRRRR_OK && status[row] != OLSON_PPRRRR_FREE_JOINT)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 6; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void olson_pprrrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)olson_pprrrr_ik(T + 16 * k, NULL, (double (*)[6])(q + 24 * k), status + 4 * k);
}
