/* scara_wrist: SCARA arm with a spherical wrist
 * Inverse kinematics, generated from robots/scara_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara_wrist.yaml. The formulas and where they come from: scara_wrist.md.
 */
#include "scara_wrist.h"

#include <math.h>

static const double d6 = 0.1; /* joint offset 6 */
static const double d1 = 0.5; /* joint offset 1 */
static const double a1 = 0.4; /* link length 1 */
static const double a2 = 0.3; /* link length 2 */
static const double k5 = 0.25; /* (a1 * a1) + (a2 * a2) */
static const double longest2 = 0.48999999999999994; /* square of the longest reach */
static const double shortest2 = 0.010000000000000007; /* square of the shortest reach */
static const double longest2_reach = 0.49000000000018196; /* the same, longest by rounding */
static const double shortest2_reach = 0.009999999999974009; /* the same, shortest by rounding */
static const double longest2_apart = 0.48999999999998173; /* the same, longest for merging */
static const double shortest2_apart = 0.010000000000002607; /* the same, shortest for merging */
static const double k7 = 4.166666666666667; /* 1 / (2 * (a2 * a1)) */
static const double free_square_tolerance2 = 1.69e-24; /* the same, squared [length^2] */
static const double free_tolerance = 1e-12; /* a vector this short fixes no angle */

const char *const scara_wrist_branches[4] = {
    "down-left",
    "down-right",
    "up-left",
    "up-right",
};

static const double lowest[6] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const double turn = 6.283185307179586;
static const int revolute[6] = { 1, 1, 0, 1, 1, 1 };
static const double weight[6] = { 1.0, 1.0, 0.5917159763313609, 1.0, 1.0, 1.0 }; /* of squared differences: lengths by arm size */

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void scara_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v19 = c1 * c2;
    const double v20 = s1 * s2;
    const double v21 = v19 - v20;
    const double v22 = s1 * c2 + c1 * s2;
    const double v23 = v20 - v19;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v24 = v22 * s4;
    const double v25 = v21 * c4 + v24;
    const double v26 = v22 * c4;
    const double v27 = v26 + v23 * s4;
    const double v28 = v26 - v21 * s4;
    const double v29 = v23 * c4 - v24;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v30 = v25 * c5;
    const double v31 = v27 * c5;
    const double v32 = v25 * s5;
    const double v33 = v27 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11 = v30 * c6 + v28 * s6;
    const double T21 = v31 * c6 + v29 * s6;
    const double T12 = v28 * c6 - v30 * s6;
    const double T22 = v29 * c6 - v31 * s6;
    const double T32 = s5 * s6;
    const double T14 = c1 * a1 + v21 * a2 - v32 * d6;
    const double T24 = s1 * a1 + v22 * a2 - v33 * d6;
    const double T34 = d1 + q[2] - c5 * d6;
    T[0] = T11; T[1] = T12; T[2] = -v32; T[3] = T14;
    T[4] = T21; T[5] = T22; T[6] = -v33; T[7] = T24;
    T[8] = -(s5 * c6); T[9] = T32; T[10] = -c5; T[11] = T34;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void scara_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v24 = c1 * a1;
    const double v25 = s1 * a1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v26 = c1 * c2;
    const double v27 = s1 * s2;
    const double v28 = v26 - v27;
    const double v29 = s1 * c2 + c1 * s2;
    const double v30 = v24 + v28 * a2;
    const double v31 = v25 + v29 * a2;
    const double v32 = d1 + q[2];
    const double v33 = v27 - v26;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v34 = v29 * s4;
    const double v35 = v29 * c4;
    const double J45 = v28 * s4 - v35;
    const double J55 = v34 - v33 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v36 = (v28 * c4 + v34) * s5;
    const double v37 = (v35 + v33 * s4) * s5;
    const double J21 = v30 - v36 * d6;
    const double v38 = v37 * d6;
    const double v39 = v31 - v38;
    const double J11 = v38 - v31;
    const double J22 = J21 - v24;
    const double J12 = v25 - v39;
    const double v40 = J21 - v30;
    const double J14 = v39 - v31;
    const double v41 = v32 - c5 * d6 - v32;
    const double J24 = v30 - J21;
    const double J15 = J55 * v41;
    const double J35 = J45 * J14 - J55 * v40;
    const double J16 = c5 * J14 - v37 * v41;
    const double J26 = v36 * v41 - c5 * v40;
    const double J36 = v37 * v40 - v36 * J14;
    J[0] = J11; J[1] = J12; J[2] = 0.0; J[3] = J14; J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = J22; J[8] = 0.0; J[9] = J24; J[10] = -(J45 * v41); J[11] = J26;
    J[12] = 0.0; J[13] = 0.0; J[14] = 1.0; J[15] = 0.0; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = 0.0; J[22] = J45; J[23] = -v36;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = 0.0; J[28] = J55; J[29] = -v37;
    J[30] = 1.0; J[31] = 1.0; J[32] = 0.0; J[33] = -1.0; J[34] = 0.0; J[35] = -c5;
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
static void solve(const double T[16], const double seed[6],
    double q[4][6], unsigned char status[4])
{

    /* r3: type 1 */
    const double wz = T[11] - T[10] * d6;
    const double r3 = wz - d1;

    /* theta2: type 8 */
    const double wx = T[3] - d6 * T[2];
    const double wy = T[7] - d6 * T[6];
    const double N2 = wx * wx + wy * wy;
    const double K2 = N2 - k5;
    const double D2 = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return;
    const double w2 = sqrt(apart2 ? D2 : 0.0);
    const double c2 = K2 * k7;

    /* theta1: type 3 */
    const double v28 = a1 + a2 * c2;
    const double v30 = wy * v28;
    const double v32 = wx * v28;

    /* theta12m4: type 2 */
    const double w12m4 = sqrt(T[2] * T[2] + T[6] * T[6]);
    const int free12m4 = w12m4 <= free_tolerance;
    const double v35 = free12m4 ? 1.0 : w12m4;

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2: type 8 */
        if (e1 < 0.0 && !apart2) continue;
        const double s2 = w2 * e1 * k7;
        const double q2 = atan2(s2, c2);

        /* theta1: type 3 */
        const double v29 = a2 * s2;
        const double v31 = v30 - wx * v29;
        const double v33 = v32 + wy * v29;
        const double w1 = sqrt(v31 * v31 + v33 * v33);
        const int free1 = w1 <= free_square_tolerance2;
        const double v34 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : v33 * v34;
        const double s1 = free1 ? sin(seed[0]) : v31 * v34;
        const double q1 = atan2(s1, c1);

        /* theta12m4: type 2 */
        const double v37 = q2 + q1;
        const double v38 = v37 - seed[3];

        for (int i2 = 0; i2 < 2; i2++) { /* left, right */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta12m4: type 2 */
            if (e2 < 0.0 && free12m4) continue;
            const double v36 = e2 / v35;
            const double c12m4 = free12m4 ? cos(v38) : -(T[2] * v36);
            const double s12m4 = free12m4 ? sin(v38) : -(T[6] * v36);
            const double s5 = w12m4 * e2;

            /* theta5: type 3 */
            const double q5 = atan2(s5, -T[10]);

            /* theta6: type 3 */
            const double c6 = T[1] * s12m4 - T[5] * c12m4;
            const double s6 = T[0] * s12m4 - T[4] * c12m4;
            const double q6 = atan2(s6, c6);

            /* joint values */
            const double q4 = wrap(v37 - atan2(s12m4, c12m4));
            const int row = 2 * i1 + i2;
            q[row][0] = q1;
            q[row][1] = q2;
            q[row][2] = r3;
            q[row][3] = q4;
            q[row][4] = q5;
            q[row][5] = q6;
            status[row] = free1 || free12m4 ? SCARA_WRIST_FREE_JOINT : SCARA_WRIST_OK;
        }
    }
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

int scara_wrist_ik(const double T[16], const double *q_seed,
    double q[4][6], unsigned char status[4])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? SCARA_WRIST_UNREACHABLE : SCARA_WRIST_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -SCARA_WRIST_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == SCARA_WRIST_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = SCARA_WRIST_OUT_OF_LIMITS;
        }
        count += status[row] != SCARA_WRIST_OUT_OF_LIMITS;
    }
    return count;
}

int scara_wrist_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[4][6], least = HUGE_VAL;
    unsigned char status[4];
    int result = -SCARA_WRIST_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (scara_wrist_ik(T, q_seed, all, status) == -SCARA_WRIST_INVALID_POSE)
        return -SCARA_WRIST_INVALID_POSE;
    for (int row = 0; row < 4; row++) {
        double distance = 0.0;
        if (status[row] == SCARA_WRIST_OUT_OF_LIMITS && result == -SCARA_WRIST_UNREACHABLE)
            result = -SCARA_WRIST_OUT_OF_LIMITS;
        if (status[row] != SCARA_WRIST_OK && status[row] != SCARA_WRIST_FREE_JOINT)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            distance += weight[i] * (all[row][i] - q_seed[i]) * (all[row][i] - q_seed[i]);
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

void scara_wrist_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)scara_wrist_ik(T + 16 * k, NULL, (double (*)[6])(q + 24 * k), status + 4 * k);
}
