/* kuka_kr6_r900: KUKA KR 6 R900
 * Inverse kinematics, generated from robots/kuka_kr6_r900.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_kr6_r900.yaml. The formulas and where they come from: kuka_kr6_r900.md.
 */
#include "kuka_kr6_r900.h"

#include <math.h>

static const double d6 = 0.09; /* joint offset 6 */
static const double free_tolerance1 = 1.4150000000000001e-12; /* a vector this short fixes no angle [length] */
static const double d1 = 0.4; /* joint offset 1 */
static const double a1 = 0.025; /* link length 1 */
static const double a2 = 0.455; /* link length 2 */
static const double d4 = 0.42; /* joint offset 4 */
static const double k2 = 0.3822; /* 2 * (d4 * a2) */
static const double a3 = 0.025; /* link length 3 */
static const double k4 = 0.022750000000000003; /* 2 * (a3 * a2) */
static const double k9 = 0.38405; /* (a2 * a2) + ((a3 * a3) + (d4 * d4)) */
static const double longest2 = 0.766926484652688; /* square of the longest reach */
static const double shortest2 = 0.0011735153473120417; /* square of the shortest reach */
static const double longest2_reach = 0.7669264846529359; /* the same, longest by rounding */
static const double shortest2_reach = 0.0011735153473023472; /* the same, shortest by rounding */
static const double longest2_apart = 0.7669264846526632; /* the same, longest for merging */
static const double shortest2_apart = 0.001173515347313011; /* the same, shortest for merging */
static const double k13 = 6.821542862115762; /* 1 / (((2 * (d4 * a2)) * (2 * (d4 * a2))) + ((2 * (a3 * a2)) * (2 * (a3 * a2)))) */
static const double free_square_tolerance2 = 2.0022250000000003e-24; /* the same, squared [length^2] */
static const double offset2 = -1.5707963267948966; /* offset of joint 2 */
static const double free_tolerance = 1e-12; /* a vector this short fixes no angle */
static const double offset3 = -1.5707963267948966; /* offset of joint 3 */
static const double offset5 = 3.141592653589793; /* offset of joint 5 */

const char *const kuka_kr6_r900_branches[8] = {
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

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void kuka_kr6_r900_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v23 = q[1] + offset2;
    const double c2 = cos(v23);
    const double s2 = sin(v23);
    const double v24 = c1 * c2;
    const double v25 = s1 * c2;
    const double v26 = c1 * s2;
    const double v27 = s1 * s2;
    const double v28 = q[2] + offset3;
    const double c3 = cos(v28);
    const double s3 = sin(v28);
    const double v29 = v24 * c3 - v26 * s3;
    const double v30 = v25 * c3 - v27 * s3;
    const double v31 = s2 * c3 + c2 * s3;
    const double v32 = v26 * c3 + v24 * s3;
    const double v33 = v27 * c3 + v25 * s3;
    const double v34 = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v35 = v29 * c4 + s1 * s4;
    const double v36 = v30 * c4 - c1 * s4;
    const double v37 = v31 * c4;
    const double v38 = c1 * c4 + v30 * s4;
    const double v39 = v31 * s4;
    const double v40 = v29 * s4 - s1 * c4;
    const double v41 = q[4] + offset5;
    const double c5 = cos(v41);
    const double s5 = sin(v41);
    const double v42 = v35 * c5 - v32 * s5;
    const double v43 = v36 * c5 - v33 * s5;
    const double v44 = v34 * s5 - v37 * c5;
    const double T13 = v32 * c5 + v35 * s5;
    const double T23 = v33 * c5 + v36 * s5;
    const double v45 = v34 * c5 + v37 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11 = v42 * c6 + v40 * s6;
    const double T21 = v43 * c6 + v38 * s6;
    const double T31 = v44 * c6 - v39 * s6;
    const double T12 = v40 * c6 - v42 * s6;
    const double T22 = v38 * c6 - v43 * s6;
    const double T14 = c1 * a1 + v24 * a2 + v29 * a3 - v32 * d4 + T13 * d6;
    const double T24 = s1 * a1 + v25 * a2 + v30 * a3 - v33 * d4 + T23 * d6;
    const double T34 = d1 - s2 * a2 - v31 * a3 + v34 * d4 - v45 * d6;
    T[0] = T11; T[1] = T12; T[2] = T13; T[3] = T14;
    T[4] = T21; T[5] = T22; T[6] = T23; T[7] = T24;
    T[8] = T31; T[9] = -(v39 * c6 + v44 * s6); T[10] = -v45; T[11] = T34;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kuka_kr6_r900_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v29 = c1 * a1;
    const double v30 = s1 * a1;
    const double v31 = q[1] + offset2;
    const double c2 = cos(v31);
    const double s2 = sin(v31);
    const double v32 = c1 * c2;
    const double v33 = s1 * c2;
    const double v34 = c1 * s2;
    const double v35 = s1 * s2;
    const double v36 = v29 + v32 * a2;
    const double v37 = v30 + v33 * a2;
    const double v38 = d1 - s2 * a2;
    const double v39 = q[2] + offset3;
    const double c3 = cos(v39);
    const double s3 = sin(v39);
    const double v40 = v32 * c3 - v34 * s3;
    const double v41 = v33 * c3 - v35 * s3;
    const double v42 = s2 * c3 + c2 * s3;
    const double v43 = v34 * c3 + v32 * s3;
    const double v44 = v35 * c3 + v33 * s3;
    const double J64 = s2 * s3 - c2 * c3;
    const double v45 = v36 + v40 * a3;
    const double v46 = v37 + v41 * a3;
    const double v47 = v38 - v42 * a3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J55 = c1 * c4 + v41 * s4;
    const double v48 = v42 * s4;
    const double v49 = v45 - v43 * d4;
    const double v50 = v46 - v44 * d4;
    const double v51 = v47 + J64 * d4;
    const double J45 = v40 * s4 - s1 * c4;
    const double v52 = q[4] + offset5;
    const double c5 = cos(v52);
    const double s5 = sin(v52);
    const double J46 = v43 * c5 + (v40 * c4 + s1 * s4) * s5;
    const double J56 = v44 * c5 + (v41 * c4 - c1 * s4) * s5;
    const double v53 = J64 * c5 + v42 * c4 * s5;
    const double J21 = v49 + J46 * d6;
    const double v54 = v50 + J56 * d6;
    const double v55 = v51 - v53 * d6;
    const double v56 = v55 - d1;
    const double J12 = c1 * v56;
    const double J22 = s1 * v56;
    const double v57 = v55 - v38;
    const double J13 = c1 * v57;
    const double J23 = s1 * v57;
    const double v58 = J21 - v45;
    const double v59 = v54 - v46;
    const double v60 = v55 - v47;
    const double J24 = J64 * v58 + v43 * v60;
    const double J34 = v44 * v58 - v43 * v59;
    const double v61 = J21 - v49;
    const double v62 = v54 - v50;
    const double v63 = v55 - v51;
    const double J15 = J55 * v63 + v48 * v62;
    const double J35 = J45 * v62 - J55 * v61;
    const double J16 = J56 * v63 + v53 * v62;
    const double J36 = J46 * v62 - J56 * v61;
    J[0] = -v54; J[1] = J12; J[2] = J13; J[3] = -(v44 * v60 + J64 * v59); J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = J22; J[8] = J23; J[9] = J24; J[10] = -(v48 * v61 + J45 * v63); J[11] = -(v53
    * v61 + J46 * v63);
    J[12] = 0.0; J[13] = -(s1 * (v54 - v30) + c1 * (J21 - v29)); J[14] = -(s1 * (v54 - v37) + c1 *
    (J21 - v36)); J[15] = J34; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = -v43; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = -v44; J[28] = J55; J[29] = J56;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = J64; J[34] = -v48; J[35] = -v53;
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
    const double v38 = free1 ? 1.0 : w1;

    /* theta3: type 6 */
    const double wz = T[11] - d6 * T[10];
    const double v40 = wz - d1;
    const double v42 = v40 * v40;

    /* theta2: type 3 */
    const double v51 = seed[1] + offset2;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1: type 2 */
        if (e1 < 0.0 && free1) continue;
        const double v39 = e1 / v38;
        const double c1 = free1 ? cos(seed[0]) : -(wx * v39);
        const double s1 = free1 ? sin(seed[0]) : Y1 * v39;
        const double q1 = atan2(s1, c1);

        /* theta3: type 6 */
        const double v41 = w1 * e1 + a1;
        const double N3 = v42 + v41 * v41;
        const double K3 = N3 - k9;
        const double D3 = (longest2 - N3) * (N3 - shortest2);
        const int apart3 = shortest2_apart < N3 && N3 < longest2_apart;
        if (!(shortest2_reach <= N3 && N3 <= longest2_reach)) continue;
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v44 = k2 * K3;
        const double v45 = k4 * K3;

        /* theta4: type 2 */
        const double v52 = T[2] * c1 + T[6] * s1;
        const double Y4 = T[2] * s1 - T[6] * c1;
        const double v53 = Y4 * Y4;

        /* theta6: type 3 */
        const double v56 = T[5] * c1 - T[1] * s1;
        const double v57 = T[1] * c1 + T[5] * s1;
        const double v59 = T[4] * c1 - T[0] * s1;
        const double v60 = T[0] * c1 + T[4] * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3: type 6 */
            if (e2 < 0.0 && !apart3) continue;
            const double v43 = w3 * e2;
            const double s3 = (k4 * v43 - v44) * k13;
            const double c3 = k13 * (v45 + k2 * v43);

            /* theta2: type 3 */
            const double v46 = d4 * c3 + a3 * s3;
            const double v47 = a2 + (a3 * c3 - d4 * s3);
            const double v48 = v41 * v46 - v40 * v47;
            const double v49 = v40 * v46 + v41 * v47;
            const double w2 = sqrt(v48 * v48 + v49 * v49);
            const int free2 = w2 <= free_square_tolerance2;
            const double v50 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v51) : -(v49 * v50);
            const double s2 = free2 ? sin(v51) : v48 * v50;

            /* theta4: type 2 */
            const double c23 = c3 * c2 - s3 * s2;
            const double s23 = c3 * s2 + s3 * c2;
            const double X4 = T[10] * s23 - c23 * v52;
            const double w4 = sqrt(X4 * X4 + v53);
            const int free4 = w4 <= free_tolerance;
            const double v54 = free4 ? 1.0 : w4;

            /* theta5: type 3 */
            const double c5 = T[10] * c23 + s23 * v52;

            /* theta6: type 3 */
            const double v58 = c23 * v57 - T[9] * s23;
            const double v61 = c23 * v60 - T[8] * s23;

            /* joint values */
            const double q2 = wrap(atan2(s2, c2) - offset2);
            const double q3 = wrap(atan2(s3, c3) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4: type 2 */
                if (e3 < 0.0 && free4) continue;
                const double v55 = e3 / v54;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * v55);
                const double s4 = free4 ? sin(seed[3]) : Y4 * v55;
                const double q4 = atan2(s4, c4);
                const double s5 = w4 * e3;

                /* theta6: type 3 */
                const double c6 = c4 * v56 + s4 * v58;
                const double s6 = c4 * v59 + s4 * v61;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q5 = wrap(atan2(s5, c5) - offset5);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free1 || free2 || free4 ? KUKA_KR6_R900_FREE_JOINT : KUKA_KR6_R900_OK;
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

int kuka_kr6_r900_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? KUKA_KR6_R900_UNREACHABLE : KUKA_KR6_R900_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -KUKA_KR6_R900_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == KUKA_KR6_R900_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = KUKA_KR6_R900_OUT_OF_LIMITS;
        }
        count += status[row] != KUKA_KR6_R900_OUT_OF_LIMITS;
    }
    return count;
}

int kuka_kr6_r900_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -KUKA_KR6_R900_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (kuka_kr6_r900_ik(T, q_seed, all, status) == -KUKA_KR6_R900_INVALID_POSE)
        return -KUKA_KR6_R900_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == KUKA_KR6_R900_OUT_OF_LIMITS && result == -KUKA_KR6_R900_UNREACHABLE)
            result = -KUKA_KR6_R900_OUT_OF_LIMITS;
        if (status[row] != KUKA_KR6_R900_OK && status[row] != KUKA_KR6_R900_FREE_JOINT)
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

void kuka_kr6_r900_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)kuka_kr6_r900_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
