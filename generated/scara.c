/* scara: SCARA
 * Inverse kinematics, generated from robots/scara.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara.yaml. The formulas and where they come from: scara.md.
 */
#include "scara.h"

#include <math.h>

static const double L4 = 0.1; /* x of the tool frame */
static const double free_square_tolerance = 1e-24; /* the same, squared */
static const double L1 = 0.4; /* link length 1 */
static const double L2 = 0.3; /* link length 2 */
static const double k5 = 0.25; /* (L1 * L1) + (L2 * L2) */
static const double longest3 = 0.48999999999999994; /* square of the longest reach */
static const double shortest3 = 0.010000000000000007; /* square of the shortest reach */
static const double longest3_reach = 0.490000000000112; /* the same, longest by rounding */
static const double shortest3_reach = 0.009999999999984006; /* the same, shortest by rounding */
static const double longest3_apart = 0.4899999999999887; /* the same, longest for merging */
static const double shortest3_apart = 0.010000000000001605; /* the same, shortest for merging */
static const double k7 = 4.166666666666667; /* 1 / (2 * (L2 * L1)) */
static const double free_square_tolerance2 = 6.399999999999998e-25; /* the same, squared [length^2] */
static const double k8 = 99999.99999999999; /* 1 / consistent_tolerance */
static const double k9 = 125000.0; /* 1 / consistent_tolerance1 */

const char *const scara_branches[2] = {
    "down",
    "up",
};

static const double lowest[4] = { -2.2689280275926285, -2.530727415391778, -0.2, -6.283185307179586 };
static const double highest[4] = { 2.2689280275926285, 2.530727415391778, 0.0, 6.283185307179586 };
static const double turn = 6.283185307179586;
static const int revolute[4] = { 1, 1, 0, 1 };
static const double weight[4] = { 1.0, 1.0, 1.5625000000000002, 1.0 }; /* of squared differences: lengths by arm size */

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void scara_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v11 = c1 * c2 - s1 * s2;
    const double v12 = s1 * c2 + c1 * s2;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double T11 = v11 * c4 - v12 * s4;
    const double T21 = v12 * c4 + v11 * s4;
    const double T14 = c1 * L1 + v11 * L2 + T11 * L4;
    const double T24 = s1 * L1 + v12 * L2 + T21 * L4;
    T[0] = T11; T[1] = -T21; T[2] = 0.0; T[3] = T14;
    T[4] = T21; T[5] = T11; T[6] = 0.0; T[7] = T24;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = q[2];
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void scara_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v12 = c1 * L1;
    const double v13 = s1 * L1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v14 = c1 * c2 - s1 * s2;
    const double v15 = s1 * c2 + c1 * s2;
    const double v16 = v12 + v14 * L2;
    const double v17 = v13 + v15 * L2;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J21 = v16 + (v14 * c4 - v15 * s4) * L4;
    const double v18 = v17 + (v15 * c4 + v14 * s4) * L4;
    const double J22 = J21 - v12;
    const double J12 = v13 - v18;
    const double J24 = J21 - v16;
    const double J14 = v17 - v18;
    J[0] = -v18; J[1] = J12; J[2] = 0.0; J[3] = J14;
    J[4] = J21; J[5] = J22; J[6] = 0.0; J[7] = J24;
    J[8] = 0.0; J[9] = 0.0; J[10] = 1.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = 0.0;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = 0.0;
    J[20] = 1.0; J[21] = 1.0; J[22] = 0.0; J[23] = 1.0;
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
static void solve(const double T[16], const double seed[4],
    double q[2][4], unsigned char status[2])
{

    /* r3: type 1 */
    const double t34 = T[11] - L4 * T[8];

    /* theta124: type 3 */
    const double w124 = sqrt(T[4] * T[4] + T[0] * T[0]);
    const int free124 = w124 <= free_square_tolerance;
    const double v25 = 1.0 / (free124 ? 1.0 : w124);
    const double v26 = seed[0] + seed[1] + seed[3];
    const double c124 = free124 ? cos(v26) : T[0] * v25;
    const double s124 = free124 ? sin(v26) : T[4] * v25;
    const double v27 = atan2(s124, c124);

    /* theta2: type 8 */
    const double t14 = T[3] - L4 * T[0];
    const double t24 = T[7] - L4 * T[4];
    const double N2 = t14 * t14 + t24 * t24;
    const double K2 = N2 - k5;
    const double D2 = (longest3 - N2) * (N2 - shortest3);
    const int apart2 = shortest3_apart < N2 && N2 < longest3_apart;
    if (!(shortest3_reach <= N2 && N2 <= longest3_reach)) return;
    const double w2 = sqrt(apart2 ? D2 : 0.0);
    const double c2 = K2 * k7;

    /* theta1: type 3 */
    const double v28 = L1 + L2 * c2;
    const double v30 = t24 * v28;
    const double v32 = t14 * v28;

    /* is the pose one that the arm can take? */
    const double v35 = fmax(fmax(fabs(c124 - T[0]) * k8, k8 * fabs(-(T[1] + s124))), k8 *
        fabs(-T[2]));
    const double v36 = k8 * fabs(s124 - T[4]);
    const double v37 = k8 * fabs(c124 - T[5]);
    const double v38 = k8 * fabs(-T[6]);
    const double v39 = k8 * fabs(-T[8]);
    const double v40 = k8 * fabs(-T[9]);
    const double v41 = k8 * fabs(1.0 - T[10]);
    const double v42 = k9 * fabs(0.0);

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2: type 8 */
        if (e1 < 0.0 && !apart2) continue;
        const double s2 = w2 * e1 * k7;
        const double q2 = atan2(s2, c2);

        /* theta1: type 3 */
        const double v29 = L2 * s2;
        const double v31 = v30 - t14 * v29;
        const double v33 = v32 + t24 * v29;
        const double w1 = sqrt(v31 * v31 + v33 * v33);
        const int free1 = w1 <= free_square_tolerance2;
        const double v34 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : v33 * v34;
        const double s1 = free1 ? sin(seed[0]) : v31 * v34;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1;
        const double s12 = c2 * s1 + s2 * c1;
        if (!(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fmax(v35, fabs(L2 * c12 + L1 * c1 - t14) * k9), v36), v37), v38), k9 * fabs(L2 * s12 + L1 * s1 - t24)), v39), v40), v41), v42) <= 1.0)) continue;

        /* joint values */
        const double q4 = wrap(v27 - (q2 + q1));
        const int free1_ = free124 || free1;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = t34;
        q[row][3] = q4;
        status[row] = free1_ || free124 || free124 ? SCARA_FREE_JOINT : SCARA_OK;
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

int scara_ik(const double T[16], const double *q_seed,
    double q[2][4], unsigned char status[2])
{
    static const double zeros[4] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? SCARA_UNREACHABLE : SCARA_INVALID_POSE;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -SCARA_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == SCARA_UNREACHABLE)
            continue;
        for (int i = 0; i < 4; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = SCARA_OUT_OF_LIMITS;
        }
        count += status[row] != SCARA_OUT_OF_LIMITS;
    }
    return count;
}

int scara_ik_nearest(const double T[16], const double q_seed[4], double q[4])
{
    double all[2][4], least = HUGE_VAL;
    unsigned char status[2];
    int result = -SCARA_UNREACHABLE;
    for (int i = 0; i < 4; i++)
        q[i] = NAN;
    if (scara_ik(T, q_seed, all, status) == -SCARA_INVALID_POSE)
        return -SCARA_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == SCARA_OUT_OF_LIMITS && result == -SCARA_UNREACHABLE)
            result = -SCARA_OUT_OF_LIMITS;
        if (status[row] != SCARA_OK && status[row] != SCARA_FREE_JOINT)
            continue;
        for (int i = 0; i < 4; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            distance += weight[i] * (all[row][i] - q_seed[i]) * (all[row][i] - q_seed[i]);
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

void scara_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)scara_ik(T + 16 * k, NULL, (double (*)[4])(q + 8 * k), status + 2 * k);
}
