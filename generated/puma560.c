/* puma560: Unimation PUMA 560
 * Inverse kinematics, generated from robots/puma560.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma560.yaml. The formulas and where they come from: puma560.md.
 */
#include "puma560.h"

#include <math.h>

static const double d3 = 0.15005; /* joint offset 3 */
static const double k1 = 0.022515002499999996; /* d3 * d3 */
static const double free_square_tolerance2 = 2.9096854084e-24; /* the same, squared [length^2] */
static const double reach_tolerance1 = 1.7057800000000002e-13; /* rounding at the boundary of the workspace [length] */
static const double merge_tolerance1 = 1.70578e-14; /* two branches nearer than this are one [length] */
static const double d1 = 0.67183; /* joint offset 1 */
static const double a2 = 0.4318; /* link length 2 */
static const double d4 = 0.4318; /* joint offset 4 */
static const double k3 = 0.37290248000000004; /* 2 * (d4 * a2) */
static const double a3 = 0.0203; /* link length 3 */
static const double k5 = 0.01753108; /* 2 * (a3 * a2) */
static const double k8 = 0.37331457; /* (d4 * a2) + ((a3 * a3) + (d4 * a2)) */
static const double longest2 = 0.7466289125534531; /* square of the longest reach */
static const double shortest2 = 2.274465470660925e-07; /* square of the shortest reach */
static const double longest2_reach = 0.7466289125537477; /* the same, longest by rounding */
static const double shortest2_reach = 2.2744654690339056e-07; /* the same, shortest by rounding */
static const double longest2_apart = 0.7466289125534236; /* the same, longest for merging */
static const double shortest2_apart = 2.2744654708236271e-07; /* the same, shortest for merging */
static const double k12 = 7.175474885806929; /* 1 / (((2 * (d4 * a2)) * (2 * (d4 * a2))) + ((2 * (a3 * a2)) * (2 * (a3 * a2)))) */
static const double free_tolerance = 1e-12; /* a vector this short fixes no angle */

const char *const puma560_branches[8] = {
    "left-down-noflip",
    "left-down-flip",
    "left-up-noflip",
    "left-up-flip",
    "right-down-noflip",
    "right-down-flip",
    "right-up-noflip",
    "right-up-flip",
};

static const double lowest[6] = { -2.792526803190927, -1.9198621771937625, -2.356194490192345, -4.642575810304916, -1.7453292519943295, -4.642575810304916 };
static const double highest[6] = { 2.792526803190927, 1.9198621771937625, 2.356194490192345, 4.642575810304916, 1.7453292519943295, 4.642575810304916 };
static const double turn = 6.283185307179586;

void puma560_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v21 = c1 * c2;
    const double v22 = s1 * c2;
    const double v23 = c1 * s2;
    const double v24 = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double v25 = v21 * c3 - v23 * s3;
    const double v26 = v22 * c3 - v24 * s3;
    const double v27 = s2 * c3 + c2 * s3;
    const double v28 = v23 * c3 + v21 * s3;
    const double v29 = v24 * c3 + v22 * s3;
    const double v30 = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v31 = v25 * c4 - s1 * s4;
    const double v32 = v26 * c4 + c1 * s4;
    const double v33 = v27 * c4;
    const double v34 = s1 * c4 + v25 * s4;
    const double v35 = c1 * c4 - v26 * s4;
    const double v36 = v27 * s4;
    const double T14 = v21 * a2 + v25 * a3 + s1 * d3 - v28 * d4;
    const double T24 = v22 * a2 + v26 * a3 - c1 * d3 - v29 * d4;
    const double T34 = d1 + s2 * a2 + v27 * a3 + v30 * d4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v37 = v31 * c5 - v28 * s5;
    const double v38 = v32 * c5 - v29 * s5;
    const double v39 = v33 * c5 + v30 * s5;
    const double T33 = v30 * c5 - v33 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11 = v37 * c6 - v34 * s6;
    const double T21 = v38 * c6 + v35 * s6;
    const double T31 = v39 * c6 - v36 * s6;
    const double T22 = v35 * c6 - v38 * s6;
    T[0] = T11; T[1] = -(v34 * c6 + v37 * s6); T[2] = -(v28 * c5 + v31 * s5); T[3] = T14;
    T[4] = T21; T[5] = T22; T[6] = -(v29 * c5 + v32 * s5); T[7] = T24;
    T[8] = T31; T[9] = -(v36 * c6 + v39 * s6); T[10] = T33; T[11] = T34;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma560_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v24 = c1 * c2;
    const double v25 = s1 * c2;
    const double v26 = c1 * s2;
    const double v27 = s1 * s2;
    const double v28 = v24 * a2;
    const double v29 = v25 * a2;
    const double v30 = d1 + s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double v31 = v24 * c3 - v26 * s3;
    const double v32 = v25 * c3 - v27 * s3;
    const double v33 = s2 * c3 + c2 * s3;
    const double v34 = v26 * c3 + v24 * s3;
    const double v35 = v27 * c3 + v25 * s3;
    const double J64 = c2 * c3 - s2 * s3;
    const double v36 = v30 + v33 * a3;
    const double v37 = v28 + v31 * a3 + s1 * d3;
    const double v38 = v29 + v32 * a3 - c1 * d3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = s1 * c4 + v31 * s4;
    const double J65 = v33 * s4;
    const double J21 = v37 - v34 * d4;
    const double v39 = v35 * d4;
    const double v40 = v38 - v39;
    const double v41 = v36 + J64 * d4;
    const double J55 = v32 * s4 - c1 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J66 = J64 * c5 - v33 * c4 * s5;
    const double J11 = v39 - v38;
    const double v42 = v41 - d1;
    const double J32 = s1 * v40 + c1 * J21;
    const double v43 = v41 - v30;
    const double J33 = s1 * (v40 - v29) + c1 * (J21 - v28);
    const double v44 = J21 - v37;
    const double v45 = v40 - v38;
    const double v46 = v41 - v36;
    const double J24 = J64 * v44 + v34 * v46;
    const double J34 = v35 * v44 - v34 * v45;
    J[0] = J11; J[1] = -(c1 * v42); J[2] = -(c1 * v43); J[3] = -(v35 * v46 + J64 * v45); J[4] = 0.0;
    J[5] = 0.0;
    J[6] = J21; J[7] = -(s1 * v42); J[8] = -(s1 * v43); J[9] = J24; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = J32; J[14] = J33; J[15] = J34; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = -v34; J[22] = J45; J[23] = -(v34 * c5 + (v31 * c4 -
    s1 * s4) * s5);
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -v35; J[28] = J55; J[29] = -(v35 * c5 + (v32 * c4
    + c1 * s4) * s5);
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = J64; J[34] = J65; J[35] = J66;
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
    const double N1 = T[3] * T[3] + T[7] * T[7];
    const double D1 = N1 - k1;
    const int free1 = N1 <= free_square_tolerance2;
    const double v33 = 2.0 * fabs(-d3);
    const int apart1 = merge_tolerance1 * (v33 + merge_tolerance1) < D1;
    if (!(-(reach_tolerance1 * (v33 + reach_tolerance1)) <= D1)) return;
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double v35 = 1.0 / (free1 ? 1.0 : N1);
    const double v36 = T[3] * d3;
    const double v37 = T[7] * d3;

    /* theta3: type 6 */
    const double v38 = T[11] - d1;
    const double v39 = v38 * v38;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1: type 2 */
        if (e1 < 0.0 && (free1 || !apart1)) continue;
        const double v34 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : v35 * (T[3] * v34 - v37);
        const double s1 = free1 ? sin(seed[0]) : v35 * (v36 + T[7] * v34);
        const double q1 = atan2(s1, c1);

        /* theta3: type 6 */
        const double N3 = v39 + v34 * v34;
        const double K3 = N3 - k8;
        const double D3 = (longest2 - N3) * (N3 - shortest2);
        const int apart3 = shortest2_apart < N3 && N3 < longest2_apart;
        if (!(shortest2_reach <= N3 && N3 <= longest2_reach)) continue;
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v41 = k3 * K3;
        const double v42 = k5 * K3;

        /* theta4: type 2 */
        const double v48 = T[2] * c1 + T[6] * s1;
        const double Y4 = T[6] * c1 - T[2] * s1;
        const double v50 = Y4 * Y4;

        /* theta6: type 3 */
        const double v53 = T[1] * s1 - T[5] * c1;
        const double v54 = T[1] * c1 + T[5] * s1;
        const double v56 = T[0] * s1 - T[4] * c1;
        const double v57 = T[0] * c1 + T[4] * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3: type 6 */
            if (e2 < 0.0 && !apart3) continue;
            const double v40 = w3 * e2;
            const double s3 = (k5 * v40 - v41) * k12;
            const double c3 = k12 * (v42 + k3 * v40);
            const double q3 = atan2(s3, c3);

            /* theta2: type 3 */
            const double v43 = a2 + (a3 * c3 - d4 * s3);
            const double v44 = d4 * c3 + a3 * s3;
            const double v45 = v38 * v43 - v34 * v44;
            const double v46 = v34 * v43 + v38 * v44;
            const double w2 = sqrt(v45 * v45 + v46 * v46);
            const int free2 = w2 <= free_square_tolerance2;
            const double v47 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : v46 * v47;
            const double s2 = free2 ? sin(seed[1]) : v45 * v47;
            const double q2 = atan2(s2, c2);

            /* theta4: type 2 */
            const double c23 = c3 * c2 - s3 * s2;
            const double s23 = c3 * s2 + s3 * c2;
            const double v49 = c23 * v48 + T[10] * s23;
            const double w4 = sqrt(v49 * v49 + v50);
            const int free4 = w4 <= free_tolerance;
            const double v51 = free4 ? 1.0 : w4;

            /* theta5: type 3 */
            const double c5 = T[10] * c23 - s23 * v48;

            /* theta6: type 3 */
            const double v55 = c23 * v54 + T[9] * s23;
            const double v58 = c23 * v57 + T[8] * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4: type 2 */
                if (e3 < 0.0 && free4) continue;
                const double v52 = e3 / v51;
                const double c4 = free4 ? cos(seed[3]) : v49 * v52;
                const double s4 = free4 ? sin(seed[3]) : Y4 * v52;
                const double q4 = atan2(s4, c4);

                /* theta5: type 3 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6: type 3 */
                const double q6 = atan2(-(c4 * v56 + s4 * v58), -(c4 * v53 + s4 * v55));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free1 || free2 || free4 ? PUMA560_FREE_JOINT : PUMA560_OK;
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

int puma560_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? PUMA560_UNREACHABLE : PUMA560_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PUMA560_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == PUMA560_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PUMA560_OUT_OF_LIMITS;
        }
        count += status[row] != PUMA560_OUT_OF_LIMITS;
    }
    return count;
}

int puma560_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -PUMA560_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (puma560_ik(T, q_seed, all, status) == -PUMA560_INVALID_POSE)
        return -PUMA560_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == PUMA560_OUT_OF_LIMITS && result == -PUMA560_UNREACHABLE)
            result = -PUMA560_OUT_OF_LIMITS;
        if (status[row] != PUMA560_OK && status[row] != PUMA560_FREE_JOINT)
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

void puma560_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)puma560_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
