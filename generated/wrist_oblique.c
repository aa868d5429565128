/* wrist_oblique: Oblique spherical wrist
 *
 * Inverse kinematics, generated from robots/wrist_oblique.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/wrist_oblique.yaml. The formulas and where they come from:
 * wrist_oblique.md.
 */
#include "wrist_oblique.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double sqrt3 = 1.7320508075688772; /* square root of 3 */
static const double ca2 = 0.6427876096865394; /* cosine of twist 2 */
static const double sa2 = 0.766044443118978; /* sine of twist 2 */
static const double d3 = 0.1; /* joint offset 3 [m] */
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 1.0000000000000002e-26;
/* rounding at the boundary of the workspace [m] */
static const double reach_slack1 = 1.0000000000000002e-14;
static const double merge_slack1 = 1e-15; /* nearer to that boundary two branches are one [m] */
static const double free_limit_squared = 1e-24; /* square of a length that fixes no angle */
static const double pose_slack = 1e-05; /* a pose may be rounded by this */
static const double pose_slack1 = 1.0000000000000002e-06; /* a pose may be rounded by this [m] */
static const double k1 = 0.5; /* 1 / 2 */
static const double k2 = 0.12855752193730788; /* 2 * d3 * ca2 [m] */
static const double k3 = 1.3268278963378768; /* sa2 * sqrt3 */
static const double k4 = 0.6634139481689384; /* sa2 * sqrt3 / 2 */
static const double k5 = 0.8660254037844386; /* sqrt3 / 2 */
static const double k6 = 0.5745333323392334; /* sqrt3 / 2 * sa2 * sqrt3 / 2 */
static const double f1 = 0.5; /* 1 / 2 */
static const double f2 = 0.8660254037844386; /* 1 / 2 * sqrt3 */
static const double f3 = 0.383022221559489; /* sa2 * 1 / 2 */
static const double f4 = 0.3213938048432697; /* ca2 * 1 / 2 */
static const double g1 = 0.5; /* 1 / 2 */
static const double g2 = 0.8660254037844386; /* 1 / 2 * sqrt3 */
static const double g3 = 0.3213938048432697; /* ca2 * 1 / 2 */

const char *const wrist_oblique_branches[2] = {
    "left", "right",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };

void wrist_oblique_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v1 = s1 * f1;
    const double y1_y = c1 * f1;
    const double z1_x = s1 * f2;
    const double v2 = c1 * f2;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2 - v1 * s2;
    const double x2_y = s1 * c2 + y1_y * s2;
    const double x2_z = f2 * s2;
    const double v3 = v1 * c2 + c1 * s2;
    const double v4 = y1_y * c2 - s1 * s2;
    const double v5 = f2 * c2;
    const double v6 = v3 * ca2 + z1_x * sa2;
    const double y2_y = v4 * ca2 + v2 * sa2;
    const double y2_z = v5 * ca2 - f3;
    const double T13_ = z1_x * ca2 - v3 * sa2;
    const double T23_ = v4 * sa2 - v2 * ca2;
    const double T33_ = v5 * sa2 + f4;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double T11_ = x2_x * c3 - v6 * s3;
    const double T21_ = x2_y * c3 + y2_y * s3;
    const double T31_ = x2_z * c3 + y2_z * s3;
    const double T22_ = y2_y * c3 - x2_y * s3;
    const double T32_ = y2_z * c3 - x2_z * s3;
    const double T14_ = T13_ * d3;
    const double T24_ = T23_ * d3;
    const double T34_ = T33_ * d3;
    T[0] = T11_; T[1] = -(v6 * c3 + x2_x * s3); T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void wrist_oblique_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double J42 = s1 * g2;
    const double v1 = c1 * g2;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double J43 = J42 * ca2 - (s1 * g1 * c2 + c1 * s2) * sa2;
    const double J53 = (c1 * g1 * c2 - s1 * s2) * sa2 - v1 * ca2;
    const double J63 = g2 * c2 * sa2 + g3;
    const double J21 = J43 * d3;
    const double p3_y = J53 * d3;
    const double p3_z = J63 * d3;
    const double J22 = g1 * J21 - J42 * p3_z;
    const double J32 = J42 * p3_y + v1 * J21;
    const double J13 = J53 * p3_z - J63 * p3_y;
    const double J23 = J63 * J21 - J43 * p3_z;
    const double J33 = J43 * p3_y - J53 * J21;
    J[0] = -p3_y; J[1] = -(v1 * p3_z + g1 * p3_y); J[2] = J13;
    J[3] = J21; J[4] = J22; J[5] = J23;
    J[6] = 0.0; J[7] = J32; J[8] = J33;
    J[9] = 0.0; J[10] = J42; J[11] = J43;
    J[12] = 0.0; J[13] = -v1; J[14] = J53;
    J[15] = 1.0; J[16] = g1; J[17] = J63;
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
    const double T[16], const double seed[3], double q[2][3], unsigned char status[2])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta1, type 2: U1[3, 4] */
    const double v1 = T14 * sqrt3 * k1;
    const double Y1 = k1 * (sqrt3 * T24);
    const double Z1 = k1 * (T34 - k2);
    const double N1 = v1 * v1 + Y1 * Y1;
    const double D1 = N1 - Z1 * Z1;
    const int free1 = N1 <= free_limit_squared2;
    const double v2 = 2.0 * fabs(Z1);
    const int apart1 = merge_slack1 * (v2 + merge_slack1) < D1;
    if (!(-(reach_slack1 * (v2 + reach_slack1)) <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v3 = v1 * Z1;
    const double v4 = Y1 * Z1;

    /* theta3, type 3: U1[3, 2] and U1[3, 1] */
    const double v5 = sqrt3 * T22;
    const double v6 = T12 * sqrt3;
    const double v7 = sqrt3 * T21;
    const double v8 = T11 * sqrt3;

    /* theta2, type 3: U0 A3^-1 [3, 3] and U0 A3^-1 [3, 1] */
    const double v11 = k1 * (2.0 * T33 - ca2) * k5;
    const double v12 = -k6 < 0.0 ? -1.0 : 1.0;
    const double v13 = v11 * v11;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v4 + v1 * root1);
        const double s1 = free1 ? sin(seed[0]) : inverse1 * (Y1 * root1 - v3);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double S3 = sa2 * (k1 * (T31 + (s1 * v8 - c1 * v7)));
        const double C3 = sa2 * (k1 * (T32 + (s1 * v6 - c1 * v5)));
        const double w3 = sqrt(S3 * S3 + C3 * C3);
        const int free3 = w3 <= free_limit_squared;
        const double v9 = 1.0 / (free3 ? 1.0 : w3);
        const double c3 = free3 ? cos(seed[2]) : -(C3 * v9);
        const double s3 = free3 ? sin(seed[2]) : -(S3 * v9);
        const double q3 = atan2(s3, c3);

        /* theta2 */
        const double v10 = k4 * (T31 * c3 - T32 * s3);
        const double w2 = sqrt(v10 * v10 + v13);
        const int free2 = w2 <= free_limit_squared;
        const double factor2 = v12 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : -(v11 * factor2);
        const double s2 = free2 ? sin(seed[1]) : -(v10 * factor2);
        const double q2 = atan2(s2, c2);

        /* is the pose one that the arm can take? */
        const double v14 = 2.0 * c1;
        const double v15 = ca2 * s1;
        const double v16 = s1 * c3;
        const double v17 = ca2 * c1;
        const double v18 = 2.0 * v17;
        const double v19 = s1 * s3;
        const double v20 = s1 * sa2;
        const double v21 = c1 * sa2;
        const double v22 = c2 * v20 + s2 * (2.0 * v21) - ca2 * (sqrt3 * s1);
        const double v23 = 2.0 * s1;
        const double v24 = c1 * c3;
        const double v25 = 2.0 * v15;
        const double v26 = c1 * s3;
        const double v27 = c2 * v21 - s2 * (2.0 * v20) - ca2 * (sqrt3 * c1);
        const double v28 = sqrt3 * s3;
        const double v29 = sqrt3 * c3;
        const double v30 = ca2 + k3 * c2;
        if (!(fabs(T34 - k1 * (d3 * v30)) <= pose_slack1 && (fabs(T33 - k1 * v30) <= pose_slack &&
            (fabs(T32 - k1 * (c2 * (ca2 * v29) - s2 * v28 - sa2 * c3)) <= pose_slack && (fabs(T31 -
            k1 * (c2 * (ca2 * v28) + s2 * v29 - sa2 * s3)) <= pose_slack && (fabs(T24 - k1 * (d3 *
            v27)) <= pose_slack1 && (fabs(T23 - k1 * v27) <= pose_slack && (fabs(T22 - k1 * (c2 *
            (c3 * v17 - s3 * v23) - s2 * (v26 + c3 * v25) + sa2 * (sqrt3 * v24))) <= pose_slack &&
            (fabs(T21 - k1 * (c2 * (c3 * v23 + s3 * v17) + s2 * (v24 - s3 * v25) + sa2 * (sqrt3 *
            v26))) <= pose_slack && (fabs(T14 + k1 * (d3 * v22)) <= pose_slack1 && (fabs(T13 - k1 *
            -v22) <= pose_slack && (fabs(T11 - k1 * (c2 * (c3 * v14 - s3 * v15) - s2 * (v16 + s3 *
            v18) - sa2 * (sqrt3 * v19))) <= pose_slack && fabs(T12 + k1 * (c2 * (c3 * v15 + s3 *
            v14) + s2 * (c3 * v18 - v19) + sa2 * (sqrt3 * v16))) <= pose_slack))))))))))))
            continue; /* the arm can't take this pose */
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = q3;
        status[row] = (free1 || free2 || free3) ? WRIST_OBLIQUE_FREE_JOINT : WRIST_OBLIQUE_OK;
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

int wrist_oblique_ik(
    const double T[16], const double *q_seed, double q[2][3], unsigned char status[2])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? WRIST_OBLIQUE_UNREACHABLE : WRIST_OBLIQUE_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -WRIST_OBLIQUE_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == WRIST_OBLIQUE_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = WRIST_OBLIQUE_OUT_OF_LIMITS;
        }
        count += status[row] != WRIST_OBLIQUE_OUT_OF_LIMITS;
    }
    return count;
}

int wrist_oblique_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[2][3], least = HUGE_VAL;
    unsigned char status[2];
    int result = -WRIST_OBLIQUE_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (wrist_oblique_ik(T, q_seed, all, status) < 0)
        return -WRIST_OBLIQUE_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == WRIST_OBLIQUE_OUT_OF_LIMITS && result < 0)
            result = -WRIST_OBLIQUE_OUT_OF_LIMITS;
        if (status[row] != WRIST_OBLIQUE_OK && status[row] != WRIST_OBLIQUE_FREE_JOINT)
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

void wrist_oblique_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)wrist_oblique_ik(T + 16 * k, NULL, (double (*)[3])(q + 6 * k), status + 2 * k);
}
