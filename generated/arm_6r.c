/* arm_6r: Arm with six revolute joints and a spherical wrist
 * Inverse kinematics, generated from robots/arm_6r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/arm_6r.yaml. The formulas and where they come from: arm_6r.md.
 */
#include "arm_6r.h"

#include <math.h>

static const double d6 = 0.1; /* joint offset 6 */
static const double free_tolerance1 = 1.25e-12; /* a vector this short fixes no angle [length] */
static const double d1 = 0.4; /* joint offset 1 */
static const double a2 = 0.4; /* link length 2 */
static const double d4 = 0.35; /* joint offset 4 */
static const double k2 = 0.27999999999999997; /* 2 * (d4 * a2) */
static const double k5 = 0.28250000000000003; /* (a2 * a2) + (d4 * d4) */
static const double longest2 = 0.5625; /* square of the longest reach */
static const double shortest2 = 0.0025000000000000044; /* square of the shortest reach */
static const double longest2_reach = 0.5625000000001875; /* the same, longest by rounding */
static const double shortest2_reach = 0.002499999999987505; /* the same, shortest by rounding */
static const double longest2_apart = 0.5624999999999812; /* the same, longest for merging */
static const double shortest2_apart = 0.0025000000000012543; /* the same, shortest for merging */
static const double k7 = 12.755102040816327; /* 1 / ((2 * (d4 * a2)) * (2 * (d4 * a2))) */
static const double free_square_tolerance2 = 1.5624999999999999e-24; /* the same, squared [length^2] */
static const double free_tolerance = 1e-12; /* a vector this short fixes no angle */

const char *const arm_6r_branches[8] = {
    "left-down-noflip",
    "left-down-flip",
    "left-up-noflip",
    "left-up-flip",
    "right-down-noflip",
    "right-down-flip",
    "right-up-noflip",
    "right-up-flip",
};

static const double lowest[6] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const double turn = 6.283185307179586;

void arm_6r_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v22 = c1 * c2;
    const double v23 = s1 * c2;
    const double v24 = c1 * s2;
    const double v25 = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double v26 = v22 * c3 - v24 * s3;
    const double v27 = v23 * c3 - v25 * s3;
    const double v28 = s2 * c3 + c2 * s3;
    const double v29 = v24 * c3 + v22 * s3;
    const double v30 = v25 * c3 + v23 * s3;
    const double v31 = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v32 = v26 * c4 + s1 * s4;
    const double v33 = v27 * c4 - c1 * s4;
    const double v34 = v28 * c4;
    const double v35 = s1 * c4 - v26 * s4;
    const double v36 = c1 * c4 + v27 * s4;
    const double v37 = v28 * s4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v38 = v32 * c5 - v29 * s5;
    const double v39 = v33 * c5 - v30 * s5;
    const double v40 = v31 * s5 - v34 * c5;
    const double v41 = v29 * c5 + v32 * s5;
    const double v42 = v30 * c5 + v33 * s5;
    const double T33 = v31 * c5 + v34 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11 = v38 * c6 + v35 * s6;
    const double T21 = v39 * c6 - v36 * s6;
    const double T31 = v40 * c6 + v37 * s6;
    const double T12 = v35 * c6 - v38 * s6;
    const double T32 = v37 * c6 - v40 * s6;
    const double T14 = v22 * a2 - v29 * d4 - v41 * d6;
    const double T24 = v23 * a2 - v30 * d4 - v42 * d6;
    const double T34 = d1 - s2 * a2 + v31 * d4 + T33 * d6;
    T[0] = T11; T[1] = T12; T[2] = -v41; T[3] = T14;
    T[4] = T21; T[5] = -(v36 * c6 + v39 * s6); T[6] = -v42; T[7] = T24;
    T[8] = T31; T[9] = T32; T[10] = T33; T[11] = T34;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void arm_6r_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v29 = c1 * c2;
    const double v30 = s1 * c2;
    const double v31 = c1 * s2;
    const double v32 = s1 * s2;
    const double v33 = v29 * a2;
    const double v34 = v30 * a2;
    const double v35 = d1 - s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double v36 = v29 * c3 - v31 * s3;
    const double v37 = v30 * c3 - v32 * s3;
    const double v38 = s2 * c3 + c2 * s3;
    const double v39 = v31 * c3 + v29 * s3;
    const double v40 = v32 * c3 + v30 * s3;
    const double J64 = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J55 = c1 * c4 + v37 * s4;
    const double v41 = v38 * s4;
    const double v42 = v33 - v39 * d4;
    const double v43 = v34 - v40 * d4;
    const double v44 = v35 + J64 * d4;
    const double J45 = v36 * s4 - s1 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v45 = v39 * c5 + (v36 * c4 + s1 * s4) * s5;
    const double v46 = v40 * c5 + (v37 * c4 - c1 * s4) * s5;
    const double J66 = J64 * c5 + v38 * c4 * s5;
    const double J21 = v42 - v45 * d6;
    const double v47 = v46 * d6;
    const double v48 = v43 - v47;
    const double v49 = v44 + J66 * d6;
    const double J11 = v47 - v43;
    const double v50 = v49 - d1;
    const double J12 = c1 * v50;
    const double J22 = s1 * v50;
    const double v51 = J21 - v33;
    const double v52 = v48 - v34;
    const double v53 = v49 - v35;
    const double J13 = c1 * v53;
    const double J23 = s1 * v53;
    const double J24 = J64 * v51 + v39 * v53;
    const double J34 = v40 * v51 - v39 * v52;
    const double v54 = J21 - v42;
    const double v55 = v48 - v43;
    const double v56 = v49 - v44;
    const double J15 = J55 * v56 + v41 * v55;
    const double J35 = J45 * v55 - J55 * v54;
    const double J26 = J66 * v54 + v45 * v56;
    const double J36 = v46 * v54 - v45 * v55;
    J[0] = J11; J[1] = J12; J[2] = J13; J[3] = -(v40 * v53 + J64 * v52); J[4] = J15; J[5] = -(v46 *
    v56 + J66 * v55);
    J[6] = J21; J[7] = J22; J[8] = J23; J[9] = J24; J[10] = -(v41 * v54 + J45 * v56); J[11] = J26;
    J[12] = 0.0; J[13] = -(s1 * v48 + c1 * J21); J[14] = -(s1 * v52 + c1 * v51); J[15] = J34; J[16]
    = J35; J[17] = J36;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = -v39; J[22] = J45; J[23] = -v45;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = -v40; J[28] = J55; J[29] = -v46;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = J64; J[34] = -v41; J[35] = J66;
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
    double q[8][6], unsigned char status[8])
{

    /* theta1: type 2 */
    const double wx = T[3] - T[2] * d6;
    const double Y1 = d6 * T[6] - T[7];
    const double w1 = sqrt(wx * wx + Y1 * Y1);
    const int free1 = w1 <= free_tolerance1;
    const double v33 = free1 ? 1.0 : w1;

    /* theta3: type 8 */
    const double wz = T[11] - d6 * T[10];
    const double v36 = wz - d1;
    const double v37 = v36 * v36;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1: type 2 */
        if (e1 < 0.0 && free1) continue;
        const double v34 = e1 / v33;
        const double c1 = free1 ? cos(seed[0]) : -(wx * v34);
        const double s1 = free1 ? sin(seed[0]) : Y1 * v34;
        const double q1 = atan2(s1, c1);
        const double v35 = w1 * e1;

        /* theta3: type 8 */
        const double N3 = v37 + v35 * v35;
        const double K3 = N3 - k5;
        const double D3 = (longest2 - N3) * (N3 - shortest2);
        const int apart3 = shortest2_apart < N3 && N3 < longest2_apart;
        if (!(shortest2_reach <= N3 && N3 <= longest2_reach)) continue;
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v38 = k2 * K3 * k7;

        /* theta2: type 3 */
        const double v40 = a2 + d4 * v38;
        const double v41 = v36 * v40;
        const double v43 = v35 * v40;

        /* theta4: type 2 */
        const double v46 = T[2] * c1 + T[6] * s1;
        const double Y4 = T[2] * s1 - T[6] * c1;
        const double v47 = Y4 * Y4;

        /* theta6: type 3 */
        const double v50 = T[5] * c1 - T[1] * s1;
        const double v51 = T[1] * c1 + T[5] * s1;
        const double v53 = T[4] * c1 - T[0] * s1;
        const double v54 = T[0] * c1 + T[4] * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3: type 8 */
            if (e2 < 0.0 && !apart3) continue;
            const double c3 = k7 * (k2 * (w3 * e2));
            const double q3 = atan2(-v38, c3);

            /* theta2: type 3 */
            const double v39 = d4 * c3;
            const double v42 = v35 * v39 - v41;
            const double v44 = v36 * v39 + v43;
            const double w2 = sqrt(v42 * v42 + v44 * v44);
            const int free2 = w2 <= free_square_tolerance2;
            const double v45 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : -(v44 * v45);
            const double s2 = free2 ? sin(seed[1]) : v42 * v45;
            const double q2 = atan2(s2, c2);

            /* theta4: type 2 */
            const double c23 = c3 * c2 + v38 * s2;
            const double s23 = c3 * s2 - v38 * c2;
            const double X4 = T[10] * s23 - c23 * v46;
            const double w4 = sqrt(X4 * X4 + v47);
            const int free4 = w4 <= free_tolerance;
            const double v48 = free4 ? 1.0 : w4;

            /* theta6: type 3 */
            const double v52 = c23 * v51 - T[9] * s23;
            const double v55 = c23 * v54 - T[8] * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4: type 2 */
                if (e3 < 0.0 && free4) continue;
                const double v49 = e3 / v48;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * v49);
                const double s4 = free4 ? sin(seed[3]) : Y4 * v49;
                const double q4 = atan2(s4, c4);

                /* theta5: type 3 */
                const double q5 = atan2(-(w4 * e3), -(T[10] * c23 + s23 * v46));

                /* theta6: type 3 */
                const double q6 = atan2(-(c4 * v53 + s4 * v55), -(c4 * v50 + s4 * v52));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free1 || free2 || free4 ? ARM_6R_FREE_JOINT : ARM_6R_OK;
            }
        }
    }
}

/* A joint value moved by whole turns, near to another value but inside its limits. */
static double turned(int joint, double value, double towards)
{
    const double low = lowest[joint] - 1e-09, high = highest[joint] + 1e-09;
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

int arm_6r_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? ARM_6R_UNREACHABLE : ARM_6R_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -ARM_6R_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == ARM_6R_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = ARM_6R_OUT_OF_LIMITS;
        }
        count += status[row] != ARM_6R_OUT_OF_LIMITS;
    }
    return count;
}

int arm_6r_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -ARM_6R_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (arm_6r_ik(T, q_seed, all, status) == -ARM_6R_INVALID_POSE)
        return -ARM_6R_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == ARM_6R_OUT_OF_LIMITS && result == -ARM_6R_UNREACHABLE)
            result = -ARM_6R_OUT_OF_LIMITS;
        if (status[row] != ARM_6R_OK && status[row] != ARM_6R_FREE_JOINT)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            distance += (all[row][i] - q_seed[i]) * (all[row][i] - q_seed[i]);
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

void arm_6r_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)arm_6r_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
