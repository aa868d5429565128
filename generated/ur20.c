/* ur20: Universal Robots UR20
 *
 * Inverse kinematics, generated from robots/ur20.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/ur20.yaml. The formulas and where they come from: ur20.md.
 */
#include "ur20.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.2363; /* joint offset 1 [m] */
static const double a2 = -0.862; /* link length 2 [m] */
static const double a3 = -0.7287; /* link length 3 [m] */
static const double d4 = 0.201; /* joint offset 4 [m] */
static const double d5 = 0.1593; /* joint offset 5 [m] */
static const double d6 = 0.1543; /* joint offset 6 [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 5.48309056e-24;
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double longest3 = 2.53032649; /* square of the longest reach [m^2] */
static const double shortest3 = 0.017768889999999992; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest3_reach = 2.5303264900007454;
/* the shortest, with what rounding adds [m^2] */
static const double shortest3_reach = 0.017768889999937563;
/* the longest, where branches merge [m^2] */
static const double longest3_apart = 2.530326489999926;
/* the shortest, where branches merge [m^2] */
static const double shortest3_apart = 0.017768890000006237;
static const double k1 = 0.040401000000000006; /* d4^2 [m^2] */
static const double k2 = 9.413232000005485e-14; /* reach_slack1 * (2 * d4 + reach_slack1) [m^2] */
static const double k3 = 9.413232000000549e-15; /* merge_slack1 * (2 * d4 + merge_slack1) [m^2] */
static const double k4 = 1.27404769; /* a2^2 + a3^2 [m^2] */
static const double k5 = 0.796001651862628; /* 1 / (2 * a3 * a2) [m^-2] */

const char *const ur20_branches[8] = {
    "left-noflip-down", "left-noflip-up", "left-flip-down", "left-flip-up", "right-noflip-down",
    "right-noflip-up", "right-flip-down", "right-flip-up",
};

static const double lowest[6] = {
    -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586,
    -6.283185307179586, -6.283185307179586,
};
static const double highest[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void ur20_fk(const double q[6], double T[16])
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
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = x3_x * c4 - v3 * s4;
    const double x4_y = x3_y * c4 - v4 * s4;
    const double x4_z = x3_z * c4 + y3_z * s4;
    const double z4_x = v3 * c4 + x3_x * s4;
    const double z4_y = v4 * c4 + x3_y * s4;
    const double y5_z = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5 + s1 * s5;
    const double x5_y = x4_y * c5 - c1 * s5;
    const double x5_z = x4_z * c5;
    const double T13_ = s1 * c5 - x4_x * s5;
    const double v5 = c1 * c5 + x4_y * s5;
    const double v6 = x4_z * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 - z4_x * s6;
    const double T21_ = x5_y * c6 - z4_y * s6;
    const double T31_ = x5_z * c6 + y5_z * s6;
    const double T32_ = y5_z * c6 - x5_z * s6;
    const double T14_ = x2_x * a2 + x3_x * a3 + s1 * d4 + z4_x * d5 + T13_ * d6;
    const double T24_ = x2_y * a2 + x3_y * a3 - c1 * d4 + z4_y * d5 - v5 * d6;
    const double T34_ = d1 + s2 * a2 + x3_z * a3 + -y5_z * d5 - v6 * d6;
    T[0] = T11_; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = -v5; T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = -v6; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void ur20_jacobian(const double q[6], double J[36])
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
    const double v3 = v1 * c3 + x2_x * s3;
    const double v4 = v2 * c3 + x2_y * s3;
    const double y3_z = c2 * c3 - s2 * s3;
    const double p3_x = p2_x + x3_x * a3;
    const double p3_y = p2_y + x3_y * a3;
    const double p3_z = p2_z + x3_z * a3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = v3 * c4 + x3_x * s4;
    const double J55 = v4 * c4 + x3_y * s4;
    const double p4_x = p3_x + s1 * d4;
    const double p4_y = p3_y - c1 * d4;
    const double J65 = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J46 = s1 * c5 - (x3_x * c4 - v3 * s4) * s5;
    const double v5 = c1 * c5 + (x3_y * c4 - v4 * s4) * s5;
    const double v6 = (x3_z * c4 + y3_z * s4) * s5;
    const double p5_x = p4_x + J45 * d5;
    const double p5_y = p4_y + J55 * d5;
    const double p5_z = p3_z + J65 * d5;
    const double J21 = p5_x + J46 * d6;
    const double p6_y = p5_y - v5 * d6;
    const double p6_z = p5_z - v6 * d6;
    const double v7 = p6_z - d1;
    const double J32 = s1 * p6_y + c1 * J21;
    const double v8 = p6_z - p2_z;
    const double J33 = s1 * (p6_y - p2_y) + c1 * (J21 - p2_x);
    const double v9 = p6_z - p3_z;
    const double J34 = s1 * (p6_y - p3_y) + c1 * (J21 - p3_x);
    const double v10 = J21 - p4_x;
    const double v11 = p6_y - p4_y;
    const double J15 = J55 * v9 - J65 * v11;
    const double J25 = J65 * v10 - J45 * v9;
    const double J35 = J45 * v11 - J55 * v10;
    const double v12 = J21 - p5_x;
    const double v13 = p6_y - p5_y;
    const double v14 = p6_z - p5_z;
    const double J16 = v6 * v13 - v5 * v14;
    const double J36 = J46 * v13 + v5 * v12;
    J[0] = -p6_y; J[1] = -(c1 * v7); J[2] = -(c1 * v8); J[3] = -(c1 * v9); J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = -(s1 * v7); J[8] = -(s1 * v8); J[9] = -(s1 * v9); J[10] = J25;
    J[11] = -(v6 * v12 + J46 * v14);
    J[12] = 0.0; J[13] = J32; J[14] = J33; J[15] = J34; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = s1; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -c1; J[28] = J55; J[29] = -v5;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = J65; J[35] = -v6;
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
    const double T[16], const double seed[6], double q[8][6], unsigned char status[8])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const double X1 = T13 * d6 - T14;
    const double wy = T24 - d6 * T23;
    const double N1 = X1 * X1 + wy * wy;
    const double D1 = N1 - k1;
    const int free1 = N1 <= free_limit_squared2;
    const int apart1 = k3 < D1;
    if (!(-k2 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v1 = X1 * d4;
    const double v2 = wy * d4;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v4 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : -(inverse1 * (v2 + X1 * root1));
        const double s1 = free1 ? sin(seed[0]) : inverse1 * (wy * root1 - v1);
        const double q1 = atan2(s1, c1);

        /* theta6, type 2: U1 A6^-1 [3, 2] */
        const double X6 = T21 * c1 - T11 * s1;
        const double Y6 = T22 * c1 - T12 * s1;
        const double w6 = sqrt(X6 * X6 + Y6 * Y6);
        const int free6 = w6 <= free_limit;
        const double divisor6 = free6 ? 1.0 : w6;

        /* theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1] */
        const double c5 = T13 * s1 - T23 * c1;

        /* theta3 */
        const double v5 = T14 * c1 + T24 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta6 */
            if (e2 < 0.0 && free6) continue; /* both signs give the same */
            const double factor6 = e2 / divisor6;
            const double c6 = free6 ? cos(seed[5]) : -(X6 * factor6);
            const double s6 = free6 ? sin(seed[5]) : Y6 * factor6;
            const double q6 = atan2(s6, c6);
            const double s5 = w6 * e2;

            /* theta5 */
            const double q5 = atan2(s5, c5);

            /* theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1] */
            const double c234 = c6 * T32 + s6 * T31;
            const double s234 = c5 * (c6 * T31 - s6 * T32) - s5 * T33;
            const double theta234 = atan2(s234, c234);

            /* theta3 */
            const double v3 = d6 * s5;
            const double Z1_3 = c234 * d5 + s234 * v3 + v4;
            const double Z2_3 = c234 * v3 - s234 * d5 + v5;
            const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
            const double K3 = N3 - k4;
            const double D3 = (longest3 - N3) * (N3 - shortest3);
            const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
            if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
                if (free1) {
                    status[4 * i1 + 2 * i2] = LOST + 1;
                    q[4 * i1 + 2 * i2][0] = D3;
                }
                if (free6) {
                    status[4 * i1 + 2 * i2] = LOST + 6;
                    q[4 * i1 + 2 * i2][0] = D3;
                }
                continue; /* out of reach */
            }
            const double w3 = sqrt(apart3 ? D3 : 0.0);
            const double c3 = K3 * k5;

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + a3 * c3;
            const double v6 = Z1_3 * X1_2;
            const double v7 = Z2_3 * X1_2;

            for (int i3 = 0; i3 < 2; i3++) { /* down, up */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta3 */
                if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
                const double s3 = w3 * e3 * k5;
                const double q3 = atan2(s3, c3);

                /* theta2 */
                const double Y1_2 = a3 * s3;
                const double S2 = v6 - Z2_3 * Y1_2;
                const double C2 = v7 + Z1_3 * Y1_2;
                const double w2 = sqrt(S2 * S2 + C2 * C2);
                const int free2 = w2 <= free_limit_squared2;
                const double factor2 = 1.0 / (free2 ? 1.0 : w2);
                const double c2 = free2 ? cos(seed[1]) : C2 * factor2;
                const double s2 = free2 ? sin(seed[1]) : S2 * factor2;
                const double q2 = atan2(s2, c2);

                /* joint values */
                const double q4 = wrap(theta234 - (q3 + q2));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free6) ? UR20_FREE_JOINT : UR20_OK;
            }
        }
    }
}

/* A row that was lost after a joint had been chosen, and what solving again needs. */
struct search {
    const double *T;
    double seed[6], start, q[8][6];
    unsigned char status[8];
    int joint, row;
};

/* Solves with the joint moved from the seed's value: 0 if the row is solved, else how far it is. */
static double attempt(struct search *lost, double moved)
{
    lost->seed[lost->joint] = lost->start + moved;
    for (int i = 0; i < 8; i++)
        lost->status[i] = UR20_UNREACHABLE;
    solve(lost->T, lost->seed, lost->q, lost->status);
    if (lost->status[lost->row] >= LOST)
        return lost->q[lost->row][0];
    return lost->status[lost->row] == UR20_UNREACHABLE ? -HUGE_VAL : 0.0;
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
    *status = UR20_UNREACHABLE;
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

int ur20_ik(const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? UR20_UNREACHABLE : UR20_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -UR20_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] >= LOST) {
            struct search lost = { .T = pose, .joint = status[row] - LOST - 1, .row = row };
            lost.start = seed[lost.joint];
            for (int i = 0; i < 6; i++)
                lost.seed[i] = seed[i];
            choose_again(&lost, q[row], &status[row]);
        }
        if (status[row] == UR20_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = UR20_OUT_OF_LIMITS;
        }
        count += status[row] != UR20_OUT_OF_LIMITS;
    }
    return count;
}

int ur20_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -UR20_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (ur20_ik(T, q_seed, all, status) < 0)
        return -UR20_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == UR20_OUT_OF_LIMITS && result < 0)
            result = -UR20_OUT_OF_LIMITS;
        if (status[row] != UR20_OK && status[row] != UR20_FREE_JOINT)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
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

void ur20_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)ur20_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
