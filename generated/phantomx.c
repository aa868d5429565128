/* phantomx: Interbotix PhantomX Pincher
 *
 * Inverse kinematics, generated from robots/phantomx.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/phantomx.yaml. The formulas and where they come from: phantomx.md.
 */
#include "phantomx.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 40.0; /* joint offset 1 [mm] */
static const double a2 = 105.0; /* link length 2 [mm] */
static const double a3 = 105.0; /* link length 3 [mm] */
static const double a4 = 105.0; /* link length 4 [mm] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double offset2 = 1.5707963267948966; /* offset of joint 2 [rad] */
static const double longest3 = 44100.0; /* square of the longest reach [mm^2] */
static const double shortest3 = 0.0; /* square of the shortest reach [mm^2] */
/* the longest, with what rounding adds [mm^2] */
static const double longest3_reach = 44100.00000001491;
static const double shortest3_reach = 0.0; /* the shortest, with what rounding adds [mm^2] */
/* the longest, where branches merge [mm^2] */
static const double longest3_apart = 44099.99999999851;
static const double shortest3_apart = 1.26025e-23; /* the shortest, where branches merge [mm^2] */
/* square of a length that fixes no angle [mm^2] */
static const double free_limit_squared2 = 1.26025e-19;
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 0.00355; /* a pose may be rounded by this [mm] */
static const double k1 = 22050.0; /* 2 * a3 * a2 [mm^2] */
static const double k2 = 4.5351473922902495e-05; /* 1 / (2 * a3 * a2) [mm^-2] */

const char *const phantomx_branches[2] = {
    "down", "up",
};

static const double lowest[4] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[4] = { INFINITY, INFINITY, INFINITY, INFINITY };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void phantomx_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v1 = q[1] + offset2;
    const double c2 = cos(v1);
    const double s2 = sin(v1);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double y2_x = c1 * s2;
    const double y2_y = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double x3_y = x2_y * c3 + y2_y * s3;
    const double x3_z = c2 * s3 - s2 * c3;
    const double y3_x = y2_x * c3 - x2_x * s3;
    const double y3_y = y2_y * c3 - x2_y * s3;
    const double y3_z = c2 * c3 + s2 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = x3_x * c4 + y3_x * s4;
    const double x4_y = x3_y * c4 + y3_y * s4;
    const double x4_z = x3_z * c4 + y3_z * s4;
    const double T34_ = d1 + s2 * a2 - x3_z * a3 - x4_z * a4;
    const double T11_ = x3_x * s4 - y3_x * c4;
    const double T21_ = x3_y * s4 - y3_y * c4;
    const double T31_ = x3_z * s4 - y3_z * c4;
    T[0] = T11_; T[1] = s1; T[2] = -x4_x; T[3] = -(x2_x * a2 + x3_x * a3 + x4_x * a4);
    T[4] = T21_; T[5] = -c1; T[6] = -x4_y; T[7] = -(x2_y * a2 + x3_y * a3 + x4_y * a4);
    T[8] = T31_; T[9] = 0.0; T[10] = -x4_z; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void phantomx_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v1 = q[1] + offset2;
    const double c2 = cos(v1);
    const double s2 = sin(v1);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double y2_x = c1 * s2;
    const double y2_y = s1 * s2;
    const double v2 = x2_x * a2;
    const double v3 = x2_y * a2;
    const double p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double x3_y = x2_y * c3 + y2_y * s3;
    const double x3_z = c2 * s3 - s2 * c3;
    const double v4 = v2 + x3_x * a3;
    const double v5 = v3 + x3_y * a3;
    const double p3_z = p2_z - x3_z * a3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v6 = v4 + (x3_x * c4 + (y2_x * c3 - x2_x * s3) * s4) * a4;
    const double J11 = v5 + (x3_y * c4 + (y2_y * c3 - x2_y * s3) * s4) * a4;
    const double p4_z = p3_z - (x3_z * c4 + (c2 * c3 + s2 * s3) * s4) * a4;
    const double v7 = p4_z - d1;
    const double J12 = c1 * v7;
    const double J22 = s1 * v7;
    const double J32 = s1 * J11 + c1 * v6;
    const double v8 = p4_z - p2_z;
    const double J33 = s1 * (v3 - J11) + c1 * (v2 - v6);
    const double v9 = p4_z - p3_z;
    const double J34 = s1 * (v5 - J11) + c1 * (v4 - v6);
    J[0] = J11; J[1] = J12; J[2] = -(c1 * v8); J[3] = -(c1 * v9);
    J[4] = -v6; J[5] = J22; J[6] = -(s1 * v8); J[7] = -(s1 * v9);
    J[8] = 0.0; J[9] = J32; J[10] = J33; J[11] = J34;
    J[12] = 0.0; J[13] = -s1; J[14] = s1; J[15] = s1;
    J[16] = 0.0; J[17] = c1; J[18] = -c1; J[19] = -c1;
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

    /* theta1, type 3: U0[1, 3] and U0[2, 3] */
    const double w1 = sqrt(T12 * T12 + T22 * T22);
    const int free1 = w1 <= free_limit_squared;
    const double v1 = 1.0 / (free1 ? 1.0 : w1);
    const double c1 = free1 ? cos(seed[0]) : -(T22 * v1);
    const double s1 = free1 ? sin(seed[0]) : T12 * v1;
    const double q1 = atan2(s1, c1);

    /* theta2m3m4, type 3: U0[3, 2] and U0[3, 1] */
    const double w2m3m4 = sqrt(T33 * T33 + T31 * T31);
    const int free2m3m4 = w2m3m4 <= free_limit_squared;
    const double factor2m3m4 = 1.0 / (free2m3m4 ? 1.0 : w2m3m4);
    const double v2 = seed[1] + offset2;
    const double v3 = v2 - seed[2] - seed[3];
    const double c2m3m4 = free2m3m4 ? cos(v3) : -(T31 * factor2m3m4);
    const double s2m3m4 = free2m3m4 ? sin(v3) : T33 * factor2m3m4;
    const double theta2m3m4 = atan2(s2m3m4, c2m3m4);

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v4 = s2m3m4 * a4;
    const double Z1_3 = T34 - d1 - v4;
    const double v5 = c2m3m4 * a4;
    const double Z2_3 = v5 + (c1 * T14 + s1 * T24);
    const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
    const double K3 = N3 - k1;
    const double D3 = (longest3 - N3) * (N3 - shortest3);
    const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
    if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
        if (free1) {
            status[0] = LOST + 1;
            q[0][0] = D3;
        }
        if (free2m3m4) {
            status[0] = LOST + 2;
            q[0][0] = D3;
        }
        if (free2m3m4) {
            status[0] = LOST + 3;
            q[0][0] = D3;
        }
        if (free2m3m4) {
            status[0] = LOST + 4;
            q[0][0] = D3;
        }
        return; /* out of reach */
    }
    const double w3 = sqrt(apart3 ? D3 : 0.0);
    const double c3 = K3 * k2;

    /* theta2, type 3: U1[1, 4] and U1[2, 4] */
    const double X2_2 = a2 + a3 * c3;
    const double v7 = Z1_3 * X2_2;
    const double v8 = Z2_3 * X2_2;

    /* is the pose one that the arm can take? */
    const double v11 = d1 + v4;
    if (!(fabs(T32) <= pose_slack && (fabs(T31 + c2m3m4) <= pose_slack && (fabs(s2m3m4 - T33) <=
        pose_slack && (fabs(T22 + c1) <= pose_slack && (fabs(T21 + s1 * s2m3m4) <= pose_slack &&
        (fabs(T23 + s1 * c2m3m4) <= pose_slack && (fabs(T12 - s1) <= pose_slack && (fabs(T13 + c1 *
        c2m3m4) <= pose_slack && fabs(T11 + c1 * s2m3m4) <= pose_slack)))))))))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e1 < 0.0 && !apart3) continue; /* both signs give the same */
        const double s3 = w3 * e1 * k2;
        const double q3 = atan2(s3, c3);

        /* theta2 */
        const double v6 = a3 * s3;
        const double S2 = v7 - Z2_3 * v6;
        const double v9 = Z1_3 * v6 + v8;
        const double w2 = sqrt(S2 * S2 + v9 * v9);
        const int free2 = w2 <= free_limit_squared2;
        const double factor2 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(v2) : -(v9 * factor2);
        const double s2 = free2 ? sin(v2) : S2 * factor2;
        const double theta2 = atan2(s2, c2);

        /* is the pose one that the arm can take? */
        const double c2m3 = c3 * c2 + s3 * s2;
        const double s2m3 = c3 * s2 - s3 * c2;
        const double v10 = a3 * c2m3 + (v5 + a2 * c2);
        if (!(fabs(T34 - (a3 * s2m3 + (a2 * s2 + v11))) <= pose_slack1 && (fabs(T14 + c1 * v10) <=
            pose_slack1 && fabs(T24 + s1 * v10) <= pose_slack1)))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q2 = wrap(theta2 - offset2);
        const double q4 = wrap(theta2 - q3 - theta2m3m4);
        const int free2_ = free2m3m4 || free2;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = q3;
        q[row][3] = q4;
        status[row] = (free1 || free2_ || free2m3m4 || free2m3m4) ? PHANTOMX_FREE_JOINT :
            PHANTOMX_OK;
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
        lost->status[i] = PHANTOMX_UNREACHABLE;
    solve(lost->T, lost->seed, lost->q, lost->status);
    if (lost->status[lost->row] >= LOST)
        return lost->q[lost->row][0];
    return lost->status[lost->row] == PHANTOMX_UNREACHABLE ? -HUGE_VAL : 0.0;
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
    *status = PHANTOMX_UNREACHABLE;
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

int phantomx_ik(const double T[16], const double *q_seed, double q[2][4], unsigned char status[2])
{
    static const double zeros[4] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? PHANTOMX_UNREACHABLE : PHANTOMX_INVALID_POSE;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PHANTOMX_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] >= LOST) {
            struct search lost = { .T = pose, .joint = status[row] - LOST - 1, .row = row };
            lost.start = seed[lost.joint];
            for (int i = 0; i < 4; i++)
                lost.seed[i] = seed[i];
            choose_again(&lost, q[row], &status[row]);
        }
        if (status[row] == PHANTOMX_UNREACHABLE)
            continue;
        for (int i = 0; i < 4; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PHANTOMX_OUT_OF_LIMITS;
        }
        count += status[row] != PHANTOMX_OUT_OF_LIMITS;
    }
    return count;
}

int phantomx_ik_nearest(const double T[16], const double q_seed[4], double q[4])
{
    double all[2][4], least = HUGE_VAL;
    unsigned char status[2];
    int result = -PHANTOMX_UNREACHABLE;
    for (int i = 0; i < 4; i++)
        q[i] = NAN;
    if (phantomx_ik(T, q_seed, all, status) < 0)
        return -PHANTOMX_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == PHANTOMX_OUT_OF_LIMITS && result < 0)
            result = -PHANTOMX_OUT_OF_LIMITS;
        if (status[row] != PHANTOMX_OK && status[row] != PHANTOMX_FREE_JOINT)
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

void phantomx_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)phantomx_ik(T + 16 * k, NULL, (double (*)[4])(q + 8 * k), status + 2 * k);
}
