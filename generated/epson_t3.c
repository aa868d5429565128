/* epson_t3: Epson T3
 *
 * Inverse kinematics, generated from robots/epson_t3.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/epson_t3.yaml. The formulas and where they come from: epson_t3.md.
 */
#include "epson_t3.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double a1 = 0.225; /* link length 1 [m] */
static const double a2 = 0.175; /* link length 2 [m] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double longest2 = 0.16000000000000003; /* square of the longest reach [m^2] */
static const double shortest2 = 0.002500000000000002; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const double longest2_reach = 0.16000000000003203;
/* the shortest, with what rounding adds [m^2] */
static const double shortest2_reach = 0.0024999999999960015;
/* the longest, where branches merge [m^2] */
static const double longest2_apart = 0.1599999999999968;
/* the shortest, where branches merge [m^2] */
static const double shortest2_apart = 0.002500000000000401;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 1.6000000000000003e-25;
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 4.000000000000001e-06; /* a pose may be rounded by this [m] */
static const double k1 = 0.08125; /* a1^2 + a2^2 [m^2] */
static const double k2 = 12.6984126984127; /* 1 / (2 * a2 * a1) [m^-2] */

const char *const epson_t3_branches[2] = {
    "down", "up",
};

static const double lowest[4] = {
    -2.303834612632515, -2.4609142453120048, -0.15, -6.283185307179586,
};
static const double highest[4] = { 2.303834612632515, 2.4609142453120048, 0.0, 6.283185307179586 };
static const int revolute[4] = { 1, 1, 0, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[4] = { 1.0, 1.0, 6.249999999999999, 1.0 };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void epson_t3_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2 - s1 * s2;
    const double x2_y = s1 * c2 + c1 * s2;
    const double T14_ = c1 * a1 + x2_x * a2;
    const double T24_ = s1 * a1 + x2_y * a2;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v1 = x2_y * s4;
    const double T11_ = x2_x * c4 + v1;
    const double v2 = x2_y * c4;
    const double T21_ = v2 + -x2_x * s4;
    const double T12_ = v2 - x2_x * s4;
    const double T22_ = -x2_x * c4 - v1;
    T[0] = T11_; T[1] = T12_; T[2] = 0.0; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = 0.0; T[7] = T24_;
    T[8] = 0.0; T[9] = 0.0; T[10] = -1.0; T[11] = q[2];
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void epson_t3_jacobian(const double q[4], double J[24])
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
    J[0] = -p2_y; J[1] = J12; J[2] = 0.0; J[3] = 0.0;
    J[4] = J21; J[5] = J22; J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0; J[10] = 1.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = 0.0;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = 0.0;
    J[20] = 1.0; J[21] = 1.0; J[22] = 0.0; J[23] = -1.0;
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

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[4], double q[2][4], unsigned char status[2])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta12m4, type 3: U0[1, 2] and U0[2, 2] */
    const double w12m4 = sqrt(T21 * T21 + T11 * T11);
    const int free12m4 = w12m4 <= free_limit_squared;
    const double v1 = 1.0 / (free12m4 ? 1.0 : w12m4);
    const double v2 = seed[0] + seed[1] - seed[3];
    const double c12m4 = free12m4 ? cos(v2) : T11 * v1;
    const double s12m4 = free12m4 ? sin(v2) : T21 * v1;
    const double theta12m4 = atan2(s12m4, c12m4);

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
    const double v3 = T24 * X1_1;
    const double v4 = T14 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabs(1.0 + T33) <= pose_slack && (fabs(T32) <= pose_slack && (fabs(T31) <= pose_slack &&
        (fabs(T23) <= pose_slack && (fabs(T22 + c12m4) <= pose_slack && (fabs(T21 - s12m4) <=
        pose_slack && (fabs(T13) <= pose_slack && (fabs(T11 - c12m4) <= pose_slack && fabs(T12 -
        s12m4) <= pose_slack)))))))))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e1 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e1 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v3 - T14 * Y1_1;
        const double C1 = v4 + T24 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const double factor1 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : C1 * factor1;
        const double s1 = free1 ? sin(seed[0]) : S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1;
        const double s12 = c2 * s1 + s2 * c1;
        if (!(fabs(T14 - (a2 * c12 + a1 * c1)) <= pose_slack1 && fabs(T24 - (a2 * s12 + a1 * s1)) <=
            pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = wrap(q2 + q1 - theta12m4);
        const int free1_ = free12m4 || free1;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = T34;
        q[row][3] = q4;
        status[row] = (free1_ || free12m4 || free12m4) ? EPSON_T3_FREE_JOINT : EPSON_T3_OK;
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

int epson_t3_ik(const double T[16], const double *q_seed, double q[2][4], unsigned char status[2])
{
    static const double zeros[4] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? EPSON_T3_UNREACHABLE : EPSON_T3_INVALID_POSE;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -EPSON_T3_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == EPSON_T3_UNREACHABLE)
            continue;
        for (int i = 0; i < 4; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = EPSON_T3_OUT_OF_LIMITS;
        }
        count += status[row] != EPSON_T3_OUT_OF_LIMITS;
    }
    return count;
}

int epson_t3_ik_nearest(const double T[16], const double q_seed[4], double q[4])
{
    double all[2][4], least = HUGE_VAL;
    unsigned char status[2];
    int result = -EPSON_T3_UNREACHABLE;
    for (int i = 0; i < 4; i++)
        q[i] = NAN;
    if (epson_t3_ik(T, q_seed, all, status) < 0)
        return -EPSON_T3_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == EPSON_T3_OUT_OF_LIMITS && result < 0)
            result = -EPSON_T3_OUT_OF_LIMITS;
        if (status[row] != EPSON_T3_OK && status[row] != EPSON_T3_FREE_JOINT)
            continue;
        for (int i = 0; i < 4; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
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

void epson_t3_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)epson_t3_ik(T + 16 * k, NULL, (double (*)[4])(q + 8 * k), status + 2 * k);
}
