/* katana_400: Neuronics Katana 400
 *
 * Inverse kinematics, generated from robots/katana_400.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/katana_400.yaml. The formulas and where they come from:
 * katana_400.md.
 */
#include "katana_400.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.2015; /* joint offset 1 [m] */
static const double a2 = 0.19; /* link length 2 [m] */
static const double a3 = 0.139; /* link length 3 [m] */
static const double d5 = 0.1473; /* joint offset 5 [m] */
static const double free_limit1 = 6.777999999999999e-13; /* a length that fixes no angle [m] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double offset4 = -1.5707963267948966; /* offset of joint 4 [rad] */
static const double longest3 = 0.108241; /* square of the longest reach [m^2] */
static const double shortest3 = 0.002600999999999999; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 0.10824100000004461;
/* the shortest, with what rounding adds [m^2] */
static const double shortest3_reach = 0.0026009999999930854;
/* the longest, where branches merge [m^2] */
static const double longest3_apart = 0.10824099999999555;
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 0.0026010000000006904;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 4.594128399999999e-25;
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 6.778e-06; /* a pose may be rounded by this [m] */
static const double k1 = 0.055421000000000005; /* a2^2 + a3^2 [m^2] */
static const double k2 = 18.932222642938278; /* 1 / (2 * a3 * a2) [m^-2] */

const char *const katana_400_branches[4] = {
    "left-down", "left-up", "right-down", "right-up",
};

static const double lowest[5] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[5] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void katana_400_fk(const double q[5], double T[16])
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
    const double x3_z = s2 * c3 + c2 * s3;
    const double v3 = v1 * c3 + x2_x * s3;
    const double v4 = v2 * c3 + x2_y * s3;
    const double y3_z = c2 * c3 - s2 * s3;
    const double v5 = q[3] + offset4;
    const double c4 = cos(v5);
    const double s4 = sin(v5);
    const double x4_x = x3_x * c4 - v3 * s4;
    const double x4_y = x3_y * c4 - v4 * s4;
    const double x4_z = x3_z * c4 + y3_z * s4;
    const double v6 = v3 * c4 + x3_x * s4;
    const double v7 = v4 * c4 + x3_y * s4;
    const double T33_ = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double T11_ = x4_x * c5 - s1 * s5;
    const double T21_ = x4_y * c5 + c1 * s5;
    const double T31_ = x4_z * c5;
    const double T22_ = c1 * c5 - x4_y * s5;
    const double T14_ = x2_x * a2 + x3_x * a3 - v6 * d5;
    const double T24_ = x2_y * a2 + x3_y * a3 - v7 * d5;
    const double T34_ = d1 + s2 * a2 + x3_z * a3 + T33_ * d5;
    T[0] = T11_; T[1] = -(s1 * c5 + x4_x * s5); T[2] = -v6; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = -v7; T[7] = T24_;
    T[8] = T31_; T[9] = -(x4_z * s5); T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void katana_400_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double p2_x = x2_x * a2;
    const double p2_y = x2_y * a2;
    const double p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 - v1 * s3;
    const double x3_y = x2_y * c3 - v2 * s3;
    const double x3_z = s2 * c3 + c2 * s3;
    const double p3_x = p2_x + x3_x * a3;
    const double p3_y = p2_y + x3_y * a3;
    const double p3_z = p2_z + x3_z * a3;
    const double v3 = q[3] + offset4;
    const double c4 = cos(v3);
    const double s4 = sin(v3);
    const double v4 = (v1 * c3 + x2_x * s3) * c4 + x3_x * s4;
    const double v5 = (v2 * c3 + x2_y * s3) * c4 + x3_y * s4;
    const double J65 = (c2 * c3 - s2 * s3) * c4 - x3_z * s4;
    const double J21 = p3_x - v4 * d5;
    const double p5_y = p3_y - v5 * d5;
    const double p5_z = p3_z + J65 * d5;
    const double v6 = p5_z - d1;
    const double J32 = s1 * p5_y + c1 * J21;
    const double v7 = p5_z - p2_z;
    const double J33 = s1 * (p5_y - p2_y) + c1 * (J21 - p2_x);
    const double v8 = J21 - p3_x;
    const double v9 = p5_y - p3_y;
    const double v10 = p5_z - p3_z;
    const double J34 = s1 * v9 + c1 * v8;
    const double J25 = J65 * v8 + v4 * v10;
    const double J35 = v5 * v8 - v4 * v9;
    J[0] = -p5_y; J[1] = -(c1 * v6); J[2] = -(c1 * v7); J[3] = -(c1 * v10);
    J[4] = -(v5 * v10 + J65 * v9);
    J[5] = J21; J[6] = -(s1 * v6); J[7] = -(s1 * v7); J[8] = -(s1 * v10); J[9] = J25;
    J[10] = 0.0; J[11] = J32; J[12] = J33; J[13] = J34; J[14] = J35;
    J[15] = 0.0; J[16] = s1; J[17] = s1; J[18] = s1; J[19] = -v4;
    J[20] = 0.0; J[21] = -c1; J[22] = -c1; J[23] = -c1; J[24] = -v5;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = J65;
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
    const double T[16], const double seed[5], double q[4][5], unsigned char status[4])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta1, type 2: U1[3, 4] */
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta234, type 3: U1[2, 3] and U1[1, 3] */
    const double v1 = T33 * T33;
    const double v2 = seed[1] + seed[2] + (seed[3] + offset4);

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v5 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : T14 * factor1;
        const double s1 = free1 ? sin(seed[0]) : T24 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta234 */
        const double Z2_234 = T13 * c1 + T23 * s1;
        const double w234 = sqrt(Z2_234 * Z2_234 + v1);
        const int free234 = w234 <= free_limit_squared;
        const double factor234 = 1.0 / (free234 ? 1.0 : w234);
        const double c234 = free234 ? cos(v2) : T33 * factor234;
        const double s234 = free234 ? sin(v2) : -(Z2_234 * factor234);
        const double theta234 = atan2(s234, c234);

        /* theta5, type 3: U1[3, 2] and U1[3, 1] */
        const double Z1_5 = T12 * s1 - T22 * c1;
        const double Z2_5 = T11 * s1 - T21 * c1;
        const double w5 = sqrt(Z2_5 * Z2_5 + Z1_5 * Z1_5);
        const int free5 = w5 <= free_limit_squared;
        const double v3 = 1.0 / (free5 ? 1.0 : w5);
        const double c5 = free5 ? cos(seed[4]) : -(Z1_5 * v3);
        const double s5 = free5 ? sin(seed[4]) : -(Z2_5 * v3);
        const double q5 = atan2(s5, c5);

        /* theta3 */
        const double v4 = c234 * d5;
        const double Z1_3 = v5 - v4;
        const double v6 = s234 * d5;
        const double Z2_3 = w1 * e1 + v6;
        const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
        const double K3 = N3 - k1;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
            if (free1) {
                status[2 * i1] = LOST + 1;
                q[2 * i1][0] = D3;
            }
            if (free234) {
                status[2 * i1] = LOST + 2;
                q[2 * i1][0] = D3;
            }
            if (free234) {
                status[2 * i1] = LOST + 3;
                q[2 * i1][0] = D3;
            }
            if (free234) {
                status[2 * i1] = LOST + 4;
                q[2 * i1][0] = D3;
            }
            continue; /* out of reach */
        }
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double c3 = K3 * k2;

        /* theta2, type 3: U1[2, 4] and U1[1, 4] */
        const double X1_2 = a2 + a3 * c3;
        const double v7 = Z1_3 * X1_2;
        const double v8 = Z2_3 * X1_2;

        /* is the pose one that the arm can take? */
        const double v9 = c1 * c234;
        const double v11 = s1 * c234;
        const double v12 = d1 + v4;
        if (!(fabs(T33 - c234) <= pose_slack && (fabs(T32 + s234 * s5) <= pose_slack && (fabs(T31 -
            s234 * c5) <= pose_slack && (fabs(T23 + s1 * s234) <= pose_slack && (fabs(T22 - (c1 * c5
            - s5 * v11)) <= pose_slack && (fabs(T21 - (c5 * v11 + c1 * s5)) <= pose_slack &&
            (fabs(T13 + c1 * s234) <= pose_slack && (fabs(T11 - (c5 * v9 - s1 * s5)) <= pose_slack
            && fabs(T12 + (s1 * c5 + s5 * v9)) <= pose_slack)))))))))
            continue; /* the arm can't take this pose */

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e2 * k2;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double Y1_2 = a3 * s3;
            const double S2 = v7 - Z2_3 * Y1_2;
            const double C2 = v8 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2;
            const double s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* is the pose one that the arm can take? */
            const double c23 = c3 * c2 - s3 * s2;
            const double s23 = c3 * s2 + s3 * c2;
            const double v10 = a3 * c23 + (a2 * c2 - v6);
            if (!(fabs(T34 - (a3 * s23 + (a2 * s2 + v12))) <= pose_slack1 && (fabs(T14 - c1 * v10)
                <= pose_slack1 && fabs(T24 - s1 * v10) <= pose_slack1)))
                continue; /* the arm can't take this pose */

            /* joint values */
            const double q4 = wrap(theta234 - (q3 + q2) - offset4);
            const int free2_ = free234 || free2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = q2;
            q[row][2] = q3;
            q[row][3] = q4;
            q[row][4] = q5;
            status[row] = (free1 || free2_ || free234 || free234 || free5) ? KATANA_400_FREE_JOINT :
                KATANA_400_OK;
        }
    }
}

/* A row that was lost after a joint had been chosen, and what solving again needs. */
struct search {
    const double *T;
    double seed[5], start, q[4][5];
    unsigned char status[4];
    int joint, row;
};

/* Solves with the joint moved from the seed's value: 0 if the row is solved, else how far it is. */
static double attempt(struct search *lost, double moved)
{
    lost->seed[lost->joint] = lost->start + moved;
    for (int i = 0; i < 4; i++)
        lost->status[i] = KATANA_400_UNREACHABLE;
    solve(lost->T, lost->seed, lost->q, lost->status);
    if (lost->status[lost->row] >= LOST)
        return lost->q[lost->row][0];
    return lost->status[lost->row] == KATANA_400_UNREACHABLE ? -HUGE_VAL : 0.0;
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
static void choose_again(struct search *lost, double q[5], unsigned char *status)
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
    *status = KATANA_400_UNREACHABLE;
    if (isnan(nearest) || attempt(lost, nearest) != 0.0)
        nearest = NAN;
    else
        *status = lost->status[lost->row];
    for (int i = 0; i < 5; i++)
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

int katana_400_ik(
    const double T[16], const double *q_seed, double q[4][5], unsigned char status[4])
{
    static const double zeros[5] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? KATANA_400_UNREACHABLE : KATANA_400_INVALID_POSE;
        for (int i = 0; i < 5; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -KATANA_400_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] >= LOST) {
            struct search lost = { .T = pose, .joint = status[row] - LOST - 1, .row = row };
            lost.start = seed[lost.joint];
            for (int i = 0; i < 5; i++)
                lost.seed[i] = seed[i];
            choose_again(&lost, q[row], &status[row]);
        }
        if (status[row] == KATANA_400_UNREACHABLE)
            continue;
        for (int i = 0; i < 5; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = KATANA_400_OUT_OF_LIMITS;
        }
        count += status[row] != KATANA_400_OUT_OF_LIMITS;
    }
    return count;
}

int katana_400_ik_nearest(const double T[16], const double q_seed[5], double q[5])
{
    double all[4][5], least = HUGE_VAL;
    unsigned char status[4];
    int result = -KATANA_400_UNREACHABLE;
    for (int i = 0; i < 5; i++)
        q[i] = NAN;
    if (katana_400_ik(T, q_seed, all, status) < 0)
        return -KATANA_400_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == KATANA_400_OUT_OF_LIMITS && result < 0)
            result = -KATANA_400_OUT_OF_LIMITS;
        if (status[row] != KATANA_400_OK && status[row] != KATANA_400_FREE_JOINT)
            continue;
        for (int i = 0; i < 5; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 5; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void katana_400_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)katana_400_ik(T + 16 * k, NULL, (double (*)[5])(q + 20 * k), status + 4 * k);
}
