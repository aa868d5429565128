/* adept: Adept SCARA
 * Inverse kinematics, generated from robots/adept.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/adept.yaml. The formulas and where they come from: adept.md.
 */
#include "adept.h"

#include <math.h>

static const double ez = 175.0; /* z of the tool frame */
static const double zz = 500.0; /* z of the base frame */
static const double d1 = 1075.0; /* joint offset 1 */
static const double free_square_tolerance = 1e-24; /* the same, squared */
static const double l1 = 600.0; /* link length 1 */
static const double l2 = 550.0; /* link length 2 */
static const double free_square_tolerance2 = 5.7599999999999994e-18; /* the same, squared [length^2] */
static const double k2 = 99999.99999999999; /* 1 / consistent_tolerance */
static const double k3 = 41.666666666666664; /* 1 / consistent_tolerance1 */

const char *const adept_branches[1] = {
    "only",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const double turn = 6.283185307179586;
static const int revolute[3] = { 1, 1, 0 };
static const double weight[3] = { 1.0, 1.0, 1.7361111111111112e-07 }; /* of squared differences: lengths by arm size */

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void adept_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double T22 = c1 * c2 - s1 * s2;
    const double T32 = s1 * c2 + c1 * s2;
    const double T24 = c1 * l1 + T22 * l2;
    const double T34 = zz + s1 * l1 + T32 * l2;
    const double T14 = d1 - q[2] - ez;
    T[0] = 0.0; T[1] = 0.0; T[2] = -1.0; T[3] = T14;
    T[4] = -T32; T[5] = T22; T[6] = 0.0; T[7] = T24;
    T[8] = T22; T[9] = T32; T[10] = 0.0; T[11] = T34;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void adept_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v9 = c1 * l1;
    const double v10 = zz + s1 * l1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double J31 = v9 + (c1 * c2 - s1 * s2) * l2;
    const double v11 = v10 + (s1 * c2 + c1 * s2) * l2;
    const double J21 = zz - v11;
    const double J32 = J31 - v9;
    const double J22 = v10 - v11;
    J[0] = 0.0; J[1] = 0.0; J[2] = -1.0;
    J[3] = J21; J[4] = J22; J[5] = 0.0;
    J[6] = J31; J[7] = J32; J[8] = 0.0;
    J[9] = 1.0; J[10] = 1.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
}

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
static double misfit(const double T[16])
{
    const double *a = T, *b = T + 4, *c = T + 8;
    const double aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - 1.0;
    const double bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2] - 1.0;
    const double ab = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const double x = a[1] * b[2] - a[2] * b[1] - c[0];
    const double y = a[2] * b[0] - a[0] * b[2] - c[1];
    const double z = a[0] * b[1] - a[1] * b[0] - c[2];
    return aa * aa + bb * bb + 2.0 * ab * ab + x * x + y * y + z * z;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(double T[16])
{
    double R[9], G[9];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[3 * i + j] = T[4 * i + j];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[3 * i + j] = (i == j ? 1.5 : 0.0)
                - 0.5 * (R[i] * R[j] + R[3 + i] * R[3 + j] + R[6 + i] * R[6 + j]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[4 * i + j] = R[3 * i] * G[j] + R[3 * i + 1] * G[3 + j] + R[3 * i + 2] * G[6 + j];
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one. Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!isfinite(T[3]))
        return 0;
    if (!isfinite(T[7]))
        return 0;
    if (!isfinite(T[11]))
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
static void solve(const double T[16], const double seed[3],
    double q[1][3], unsigned char status[1])
{

    /* r3: type 1 */
    const double t34 = T[3] - ez * T[2];
    const double r3 = d1 - t34;

    /* theta12: type 3 */
    const double w12 = sqrt(T[9] * T[9] + T[5] * T[5]);
    const int free12 = w12 <= free_square_tolerance;
    const double v16 = 1.0 / (free12 ? 1.0 : w12);
    const double v17 = seed[0] + seed[1];
    const double c12 = free12 ? cos(v17) : T[5] * v16;
    const double s12 = free12 ? sin(v17) : T[9] * v16;

    /* theta1: type 3 */
    const double t14 = T[7] - ez * T[6];
    const double v18 = c12 * l2;
    const double t24 = T[11] - ez * T[10] - zz;
    const double v19 = s12 * l2;
    const double v20 = l1 * (t24 - v19);
    const double v21 = l1 * (t14 - v18);
    const double w1 = sqrt(v20 * v20 + v21 * v21);
    const int free1 = w1 <= free_square_tolerance2;
    const double v22 = 1.0 / (free1 ? 1.0 : w1);
    const double c1 = free1 ? cos(seed[0]) : v21 * v22;
    const double s1 = free1 ? sin(seed[0]) : v20 * v22;
    const double q1 = atan2(s1, c1);

    /* is the pose one that the arm can take? */
    if (!(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fabs(c12 - T[5]) * k2, k2 * fabs(T[4] + s12)), k2 * fabs(-T[6])), fabs(v18 + l1 * c1 - t14) * k3), k2 * fabs(s12 - T[9])), k2 * fabs(T[8] - c12)), k2 * fabs(-T[10])), k3 * fabs(v19 + l1 * s1 - t24)), k2 * fabs(-T[1])), k2 * fabs(T[0])), k2 * fabs(-(1.0 + T[2]))), k3 * fabs(d1 - r3 - t34)) <= 1.0)) return;

    /* joint values */
    const double q2 = wrap(atan2(s12, c12) - q1);
    const int free1_ = free12 || free1;
    const int row = 0;
    q[row][0] = q1;
    q[row][1] = q2;
    q[row][2] = r3;
    status[row] = free1_ || free12 ? ADEPT_FREE_JOINT : ADEPT_OK;
}

/* A joint value moved by whole turns, near to another value but inside its limits. */
static double turned(int joint, double value, double towards)
{
    const double low = lowest[joint] - 1e-09, high = highest[joint] + 1e-09;
    if (!revolute[joint])
        return value;
    value += turn * floor((towards - value) / turn + 0.5);
    if (value > high)
        value -= turn * ceil((value - high) / turn);
    if (value < low)
        value += turn * ceil((low - value) / turn);
    return value;
}

static int inside(int joint, double value)
{
    return lowest[joint] - 1e-09 <= value && value <= highest[joint] + 1e-09;
}

int adept_ik(const double T[16], const double *q_seed,
    double q[1][3], unsigned char status[1])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 1; row++) {
        status[row] = valid ? ADEPT_UNREACHABLE : ADEPT_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -ADEPT_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 1; row++) {
        if (status[row] == ADEPT_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = ADEPT_OUT_OF_LIMITS;
        }
        count += status[row] != ADEPT_OUT_OF_LIMITS;
    }
    return count;
}

int adept_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[1][3], least = HUGE_VAL;
    unsigned char status[1];
    int result = -ADEPT_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (adept_ik(T, q_seed, all, status) == -ADEPT_INVALID_POSE)
        return -ADEPT_INVALID_POSE;
    for (int row = 0; row < 1; row++) {
        double distance = 0.0;
        if (status[row] == ADEPT_OUT_OF_LIMITS && result == -ADEPT_UNREACHABLE)
            result = -ADEPT_OUT_OF_LIMITS;
        if (status[row] != ADEPT_OK && status[row] != ADEPT_FREE_JOINT)
            continue;
        for (int i = 0; i < 3; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            distance += weight[i] * (all[row][i] - q_seed[i]) * (all[row][i] - q_seed[i]);
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

void adept_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)adept_ik(T + 16 * k, NULL, (double (*)[3])(q + 3 * k), status + 1 * k);
}
