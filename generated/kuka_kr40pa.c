/* kuka_kr40pa: KUKA KR 40 PA palletizer, serial equivalent
 *
 * Inverse kinematics, generated from robots/kuka_kr40pa.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_kr40pa.yaml. The formulas and where they come from:
 * kuka_kr40pa.md.
 */
#include "kuka_kr40pa.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.3; /* joint offset 1 [m] */
static const double a1 = 0.15; /* link length 1 [m] */
static const double a2 = 0.8; /* link length 2 [m] */
static const double a3 = 0.8; /* link length 3 [m] */
static const double a4 = 0.15; /* link length 4 [m] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double longest3 = 2.5600000000000005; /* square of the longest reach [m^2] */
static const double shortest3 = 0.0; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 2.5600000000007044;
static const double shortest3_reach = 0.0; /* the shortest, with what rounding adds [m^2] */
static const double longest3_apart = 2.55999999999993; /* the longest, where branches merge [m^2] */
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 4.839999999999999e-28;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 4.839999999999999e-24;
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 2.2e-05; /* a pose may be rounded by this [m] */
static const double k1 = 1.2800000000000002; /* 2 * a3 * a2 [m^2] */
static const double k2 = 0.7812499999999999; /* 1 / (2 * a3 * a2) [m^-2] */

const char *const kuka_kr40pa_branches[2] = {
    "down", "up",
};

static const double lowest[4] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[4] = { INFINITY, INFINITY, INFINITY, INFINITY };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void kuka_kr40pa_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 - v1 * s3;
    const double x3_y = x2_y * c3 - v2 * s3;
    const double v3 = s2 * c3 + c2 * s3;
    const double v4 = v1 * c3 + x2_x * s3;
    const double v5 = v2 * c3 + x2_y * s3;
    const double y3_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double T11_ = x3_x * c4 - v4 * s4;
    const double T21_ = x3_y * c4 - v5 * s4;
    const double T31_ = y3_z * s4 - v3 * c4;
    const double T13_ = v4 * c4 + x3_x * s4;
    const double T23_ = v5 * c4 + x3_y * s4;
    const double T14_ = c1 * a1 + x2_x * a2 + x3_x * a3 + T11_ * a4;
    const double T24_ = s1 * a1 + x2_y * a2 + x3_y * a3 + T21_ * a4;
    const double T34_ = d1 - s2 * a2 - v3 * a3 + T31_ * a4;
    T[0] = T11_; T[1] = -s1; T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = c1; T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = 0.0; T[10] = -(y3_z * c4 + v3 * s4); T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kuka_kr40pa_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double p1_x = c1 * a1;
    const double p1_y = s1 * a1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double p2_x = p1_x + x2_x * a2;
    const double p2_y = p1_y + x2_y * a2;
    const double p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 - v1 * s3;
    const double x3_y = x2_y * c3 - v2 * s3;
    const double v3 = s2 * c3 + c2 * s3;
    const double p3_x = p2_x + x3_x * a3;
    const double p3_y = p2_y + x3_y * a3;
    const double p3_z = p2_z - v3 * a3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J21 = p3_x + (x3_x * c4 - (v1 * c3 + x2_x * s3) * s4) * a4;
    const double p4_y = p3_y + (x3_y * c4 - (v2 * c3 + x2_y * s3) * s4) * a4;
    const double p4_z = p3_z + ((s2 * s3 - c2 * c3) * s4 - v3 * c4) * a4;
    const double v4 = p4_z - d1;
    const double J12 = c1 * v4;
    const double J22 = s1 * v4;
    const double v5 = p4_z - p2_z;
    const double J13 = c1 * v5;
    const double J23 = s1 * v5;
    const double v6 = p4_z - p3_z;
    const double J14 = c1 * v6;
    const double J24 = s1 * v6;
    J[0] = -p4_y; J[1] = J12; J[2] = J13; J[3] = J14;
    J[4] = J21; J[5] = J22; J[6] = J23; J[7] = J24;
    J[8] = 0.0; J[9] = -(s1 * (p4_y - p1_y) + c1 * (J21 - p1_x));
    J[10] = -(s1 * (p4_y - p2_y) + c1 * (J21 - p2_x));
    J[11] = -(s1 * (p4_y - p3_y) + c1 * (J21 - p3_x));
    J[12] = 0.0; J[13] = -s1; J[14] = -s1; J[15] = -s1;
    J[16] = 0.0; J[17] = c1; J[18] = c1; J[19] = c1;
    J[20] = 1.0; J[21] = 0.0; J[22] = 0.0; J[23] = 0.0;
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
    const double T[16], const double seed[4], double q[2][4], unsigned char status[2])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta234, type 3: U0[3, 3] and U0[3, 1] */
    const double w234 = sqrt(T31 * T31 + T33 * T33);
    const int free234 = w234 <= free_limit_squared;
    const double factor234 = 1.0 / (free234 ? 1.0 : w234);
    const double v1 = seed[1] + seed[2] + seed[3];
    const double c234 = free234 ? cos(v1) : T33 * factor234;
    const double s234 = free234 ? sin(v1) : -(T31 * factor234);
    const double theta234 = atan2(s234, c234);

    /* theta1, type 3: U0[1, 2] and U0[2, 2] */
    const double w1 = sqrt(T12 * T12 + T22 * T22);
    const int free1 = w1 <= free_limit_squared;
    const double v2 = 1.0 / (free1 ? 1.0 : w1);
    const double c1 = free1 ? cos(seed[0]) : T22 * v2;
    const double s1 = free1 ? sin(seed[0]) : -(T12 * v2);
    const double q1 = atan2(s1, c1);

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v3 = s234 * a4;
    const double Z1_3 = v3 + (T34 - d1);
    const double v4 = a1 + c234 * a4;
    const double Z2_3 = c1 * T14 + s1 * T24 - v4;
    const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
    const double K3 = N3 - k1;
    const double D3 = (longest3 - N3) * (N3 - shortest3);
    const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
    if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
        if (free1) {
            status[0] = LOST + 1;
            q[0][0] = D3;
        }
        if (free234) {
            status[0] = LOST + 2;
            q[0][0] = D3;
        }
        if (free234) {
            status[0] = LOST + 3;
            q[0][0] = D3;
        }
        if (free234) {
            status[0] = LOST + 4;
            q[0][0] = D3;
        }
        return; /* out of reach */
    }
    const double w3 = sqrt(apart3 ? D3 : 0.0);
    const double c3 = K3 * k2;

    /* theta2, type 3: U1[1, 4] and U1[2, 4] */
    const double Y1_2 = a2 + a3 * c3;
    const double v6 = Z1_3 * Y1_2;
    const double v8 = Z2_3 * Y1_2;

    /* is the pose one that the arm can take? */
    const double v10 = v3 - d1;
    if (!(fabs(T33 - c234) <= pose_slack && (fabs(T32) <= pose_slack && (fabs(T31 + s234) <=
        pose_slack && (fabs(T23 - s234 * s1) <= pose_slack && (fabs(T22 - c1) <= pose_slack &&
        (fabs(T21 - c234 * s1) <= pose_slack && (fabs(T13 - s234 * c1) <= pose_slack && (fabs(T11 -
        c234 * c1) <= pose_slack && fabs(T12 + s1) <= pose_slack)))))))))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e1 < 0.0 && !apart3) continue; /* both signs give the same */
        const double s3 = w3 * e1 * k2;
        const double q3 = atan2(s3, c3);

        /* theta2 */
        const double v5 = a3 * s3;
        const double v7 = Z2_3 * v5 + v6;
        const double C2 = v8 - Z1_3 * v5;
        const double w2 = sqrt(v7 * v7 + C2 * C2);
        const int free2 = w2 <= free_limit_squared2;
        const double factor2 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : C2 * factor2;
        const double s2 = free2 ? sin(seed[1]) : -(v7 * factor2);
        const double q2 = atan2(s2, c2);

        /* is the pose one that the arm can take? */
        const double c23 = c3 * c2 - s3 * s2;
        const double s23 = c3 * s2 + s3 * c2;
        const double v9 = a3 * c23 + (v4 + a2 * c2);
        if (!(fabs(T34 + (a3 * s23 + (a2 * s2 + v10))) <= pose_slack1 && (fabs(T14 - c1 * v9) <=
            pose_slack1 && fabs(T24 - s1 * v9) <= pose_slack1)))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = wrap(theta234 - (q3 + q2));
        const int free2_ = free234 || free2;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = q3;
        q[row][3] = q4;
        status[row] = (free1 || free2_ || free234 || free234) ? KUKA_KR40PA_FREE_JOINT :
            KUKA_KR40PA_OK;
    }
}

/* A row that was lost after a joint had been chosen, and what solving again needs. */
struct search {
    const double *T;
    double seed[4], start, q[2][4];
    unsigned char status[2];
    int joint, row;
};

/* Solves with the joint moved from the seed's value: 0 if the row is solved, else how far it is. */
static double attempt(struct search *lost, double moved)
{
    lost->seed[lost->joint] = lost->start + moved;
    for (int i = 0; i < 2; i++)
        lost->status[i] = KUKA_KR40PA_UNREACHABLE;
    solve(lost->T, lost->seed, lost->q, lost->status);
    if (lost->status[lost->row] >= LOST)
        return lost->q[lost->row][0];
    return lost->status[lost->row] == KUKA_KR40PA_UNREACHABLE ? -HUGE_VAL : 0.0;
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
static void choose_again(struct search *lost, double q[4], unsigned char *status)
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
    *status = KUKA_KR40PA_UNREACHABLE;
    if (isnan(nearest) || attempt(lost, nearest) != 0.0)
        nearest = NAN;
    else
        *status = lost->status[lost->row];
    for (int i = 0; i < 4; i++)
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

int kuka_kr40pa_ik(
    const double T[16], const double *q_seed, double q[2][4], unsigned char status[2])
{
    static const double zeros[4] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? KUKA_KR40PA_UNREACHABLE : KUKA_KR40PA_INVALID_POSE;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -KUKA_KR40PA_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] >= LOST) {
            struct search lost = { .T = pose, .joint = status[row] - LOST - 1, .row = row };
            lost.start = seed[lost.joint];
            for (int i = 0; i < 4; i++)
                lost.seed[i] = seed[i];
            choose_again(&lost, q[row], &status[row]);
        }
        if (status[row] == KUKA_KR40PA_UNREACHABLE)
            continue;
        for (int i = 0; i < 4; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = KUKA_KR40PA_OUT_OF_LIMITS;
        }
        count += status[row] != KUKA_KR40PA_OUT_OF_LIMITS;
    }
    return count;
}

int kuka_kr40pa_ik_nearest(const double T[16], const double q_seed[4], double q[4])
{
    double all[2][4], least = HUGE_VAL;
    unsigned char status[2];
    int result = -KUKA_KR40PA_UNREACHABLE;
    for (int i = 0; i < 4; i++)
        q[i] = NAN;
    if (kuka_kr40pa_ik(T, q_seed, all, status) < 0)
        return -KUKA_KR40PA_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == KUKA_KR40PA_OUT_OF_LIMITS && result < 0)
            result = -KUKA_KR40PA_OUT_OF_LIMITS;
        if (status[row] != KUKA_KR40PA_OK && status[row] != KUKA_KR40PA_FREE_JOINT)
            continue;
        for (int i = 0; i < 4; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 4; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void kuka_kr40pa_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)kuka_kr40pa_ik(T + 16 * k, NULL, (double (*)[4])(q + 8 * k), status + 2 * k);
}
