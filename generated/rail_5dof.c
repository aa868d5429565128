/* rail_5dof: Arm with four revolute joints on a rail
 *
 * Inverse kinematics, generated from robots/rail_5dof.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/rail_5dof.yaml. The formulas and where they come from:
 * rail_5dof.md.
 */
#include "rail_5dof.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double a1 = 2.0; /* link length 2 [m] */
static const double d3 = 1.0; /* joint offset 3 [m] */
static const double d5 = 3.0; /* joint offset 5 [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 3.6e-23;
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 6.000000000000001e-05; /* a pose may be rounded by this [m] */

const char *const rail_5dof_branches[2] = {
    "noflip", "flip",
};

static const double lowest[5] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[5] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[5] = { 0, 1, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[5] = { 0.027777777777777776, 1.0, 1.0, 1.0, 1.0 };

void rail_5dof_fk(const double q[5], double T[16])
{
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = c2 * c3;
    const double x3_y = s2 * c3;
    const double z4_x = c2 * s3;
    const double z4_y = s2 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = x3_x * c4 + s2 * s4;
    const double x4_y = x3_y * c4 - c2 * s4;
    const double x4_z = s3 * c4;
    const double T13_ = s2 * c4 - x3_x * s4;
    const double v1 = c2 * c4 + x3_y * s4;
    const double v2 = s3 * s4;
    const double T14_ = a1 + s2 * d3 + T13_ * d5;
    const double T34_ = q[0] - v2 * d5;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double T11_ = x4_x * c5 - z4_x * s5;
    const double T21_ = x4_y * c5 - z4_y * s5;
    const double T31_ = x4_z * c5 + c3 * s5;
    const double T32_ = c3 * c5 - x4_z * s5;
    T[0] = T11_; T[1] = -(z4_x * c5 + x4_x * s5); T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = -(z4_y * c5 + x4_y * s5); T[6] = -v1; T[7] = -(c2 * d3 + v1 * d5);
    T[8] = T31_; T[9] = T32_; T[10] = -v2; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void rail_5dof_jacobian(const double q[5], double J[30])
{
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double p3_x = a1 + s2 * d3;
    const double v1 = c2 * d3;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double J44 = c2 * s3;
    const double J54 = s2 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = s2 * c4 - c2 * c3 * s4;
    const double v2 = c2 * c4 + s2 * c3 * s4;
    const double v3 = s3 * s4;
    const double p5_x = p3_x + J45 * d5;
    const double J12 = v1 + v2 * d5;
    const double J22 = p5_x - a1;
    const double v4 = q[0] - v3 * d5 - q[0];
    const double v5 = p5_x - p3_x;
    const double v6 = v1 - J12;
    const double J33 = s2 * v6 + c2 * v5;
    const double J14 = J54 * v4 + c3 * v6;
    const double J34 = J44 * v6 - J54 * v5;
    J[0] = 0.0; J[1] = J12; J[2] = -(c2 * v4); J[3] = J14; J[4] = 0.0;
    J[5] = 0.0; J[6] = J22; J[7] = -(s2 * v4); J[8] = -(c3 * v5 + J44 * v4); J[9] = 0.0;
    J[10] = 1.0; J[11] = 0.0; J[12] = J33; J[13] = J34; J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = s2; J[18] = J44; J[19] = J45;
    J[20] = 0.0; J[21] = 0.0; J[22] = -c2; J[23] = J54; J[24] = -v2;
    J[25] = 0.0; J[26] = 1.0; J[27] = 0.0; J[28] = -c3; J[29] = -v3;
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
    const double T[16], const double seed[5], double q[2][5], unsigned char status[2])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* r1, type 1: U0 A5^-1 [3, 4] */
    const double wz = T34 - T33 * d5;

    /* theta2, type 3: U0 A5^-1 [1, 4] and U0 A5^-1 [2, 4] */
    const double wx = T14 - d5 * T13;
    const double wy = T24 - d5 * T23;
    const double v1 = d3 * (wx - a1);
    const double C2 = d3 * wy;
    const double w2 = sqrt(v1 * v1 + C2 * C2);
    const int free2 = w2 <= free_limit_squared2;
    const double v2 = 1.0 / (free2 ? 1.0 : w2);
    const double c2 = free2 ? cos(seed[1]) : -(C2 * v2);
    const double s2 = free2 ? sin(seed[1]) : v1 * v2;
    const double q2 = atan2(s2, c2);

    /* theta3, type 2: U3[2, 3] */
    const double X3 = T13 * c2 + T23 * s2;
    const double w3 = sqrt(X3 * X3 + T33 * T33);
    const int free3 = w3 <= free_limit;
    const double divisor3 = free3 ? 1.0 : w3;

    /* theta4, type 3: U3[3, 3] and U3[1, 3] */
    const double Z1_4 = T23 * c2 - T13 * s2;
    const double v3 = Z1_4 * Z1_4;

    /* theta5, type 3: U3[2, 2] and U3[2, 1] */
    const double v5 = T12 * c2 + T22 * s2;
    const double v6 = T11 * c2 + T21 * s2;

    /* is the pose one that the arm can take? */
    const double v11 = d5 * s2;
    const double v12 = a1 + d3 * s2;
    const double v16 = d5 * c2;
    const double v17 = d3 * c2;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip, flip */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e1 < 0.0 && free3) continue; /* both signs give the same */
        const double factor3 = e1 / divisor3;
        const double c3 = free3 ? cos(seed[2]) : -(X3 * factor3);
        const double s3 = free3 ? sin(seed[2]) : -(T33 * factor3);
        const double q3 = atan2(s3, c3);
        const double root3 = w3 * e1;

        /* theta4 */
        const double w4 = sqrt(root3 * root3 + v3);
        const int free4 = w4 <= free_limit_squared;
        const double v4 = 1.0 / (free4 ? 1.0 : w4);
        const double c4 = free4 ? cos(seed[3]) : -(Z1_4 * v4);
        const double s4 = free4 ? sin(seed[3]) : root3 * v4;
        const double q4 = atan2(s4, c4);

        /* theta5 */
        const double C5 = s3 * v5 - T32 * c3;
        const double S5 = s3 * v6 - T31 * c3;
        const double w5 = sqrt(S5 * S5 + C5 * C5);
        const int free5 = w5 <= free_limit_squared;
        const double v7 = 1.0 / (free5 ? 1.0 : w5);
        const double c5 = free5 ? cos(seed[4]) : -(C5 * v7);
        const double s5 = free5 ? sin(seed[4]) : -(S5 * v7);
        const double q5 = atan2(s5, c5);

        /* is the pose one that the arm can take? */
        const double v8 = c2 * c3;
        const double v9 = c4 * v8 + s2 * s4;
        const double v10 = c2 * s3;
        const double v13 = s2 * c3;
        const double v14 = c2 * s4 - c4 * v13;
        const double v15 = s2 * s3;
        const double v18 = s3 * c4;
        if (!(fabs(T34 + (s4 * (d5 * s3) + -wz)) <= pose_slack1 && (fabs(T33 + s3 * s4) <=
            pose_slack && (fabs(T32 - (c3 * c5 - s5 * v18)) <= pose_slack && (fabs(T31 - (c5 * v18 +
            c3 * s5)) <= pose_slack && (fabs(T24 + (c4 * v16 + s4 * (d5 * v13) + v17)) <=
            pose_slack1 && (fabs(T23 + (c2 * c4 + s4 * v13)) <= pose_slack && (fabs(T22 - (s5 * v14
            - c5 * v15)) <= pose_slack && (fabs(T21 + (c5 * v14 + s5 * v15)) <= pose_slack &&
            (fabs(T14 - (v12 - (s4 * (d5 * v8) - c4 * v11))) <= pose_slack1 && (fabs(T13 - (s2 * c4
            - s4 * v8)) <= pose_slack && (fabs(T11 - (c5 * v9 - s5 * v10)) <= pose_slack && fabs(T12
            + (c5 * v10 + s5 * v9)) <= pose_slack))))))))))))
            continue; /* the arm can't take this pose */
        const int row = i1;
        q[row][0] = wz;
        q[row][1] = q2;
        q[row][2] = q3;
        q[row][3] = q4;
        q[row][4] = q5;
        status[row] = (free2 || free3 || free4 || free5) ? RAIL_5DOF_FREE_JOINT : RAIL_5DOF_OK;
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

int rail_5dof_ik(const double T[16], const double *q_seed, double q[2][5], unsigned char status[2])
{
    static const double zeros[5] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? RAIL_5DOF_UNREACHABLE : RAIL_5DOF_INVALID_POSE;
        for (int i = 0; i < 5; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -RAIL_5DOF_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == RAIL_5DOF_UNREACHABLE)
            continue;
        for (int i = 0; i < 5; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = RAIL_5DOF_OUT_OF_LIMITS;
        }
        count += status[row] != RAIL_5DOF_OUT_OF_LIMITS;
    }
    return count;
}

int rail_5dof_ik_nearest(const double T[16], const double q_seed[5], double q[5])
{
    double all[2][5], least = HUGE_VAL;
    unsigned char status[2];
    int result = -RAIL_5DOF_UNREACHABLE;
    for (int i = 0; i < 5; i++)
        q[i] = NAN;
    if (rail_5dof_ik(T, q_seed, all, status) < 0)
        return -RAIL_5DOF_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == RAIL_5DOF_OUT_OF_LIMITS && result < 0)
            result = -RAIL_5DOF_OUT_OF_LIMITS;
        if (status[row] != RAIL_5DOF_OK && status[row] != RAIL_5DOF_FREE_JOINT)
            continue;
        for (int i = 0; i < 5; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
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

void rail_5dof_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)rail_5dof_ik(T + 16 * k, NULL, (double (*)[5])(q + 10 * k), status + 2 * k);
}
