/* puma: PUMA in its reference position
 * Inverse kinematics, generated from robots/puma.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma.yaml. The formulas and where they come from: puma.md.
 */
#include "puma.h"

#include <math.h>

static const double D3 = 0.15005; /* x of axis 4 */
static const double L2 = 0.4318; /* z of axis 3 */
static const double D4 = 0.4318; /* z of axis 5 */
static const double k1 = 0.8636; /* L2 + D4 */
static const double k2 = 0.022515002499999996; /* D3 * D3 */
static const double free_square_tolerance2 = 1.0274863225e-24; /* the same, squared [length^2] */
static const double reach_tolerance1 = 1.0136499999999999e-13; /* rounding at the boundary of the workspace [length] */
static const double merge_tolerance1 = 1.0136499999999999e-14; /* two branches nearer than this are one [length] */
static const double k4 = 0.37290248000000004; /* 2 * (D4 * L2) */
static const double longest2 = 0.7458049600000001; /* square of the longest reach */
static const double shortest2 = 0.0; /* square of the shortest reach */
static const double longest2_reach = 0.7458049600001752; /* the same, longest by rounding */
static const double shortest2_reach = 0.0; /* the same, shortest by rounding */
static const double longest2_apart = 0.7458049599999826; /* the same, longest for merging */
static const double shortest2_apart = 1.0274863225e-28; /* the same, shortest for merging */
static const double k6 = 2.681666262986505; /* 1 / (2 * (D4 * L2)) */
static const double free_tolerance = 1e-12; /* a vector this short fixes no angle */
static const double f1 = 0.8636; /* L2 + D4 */
static const double g1 = 0.8636; /* L2 + D4 */

const char *const puma_branches[8] = {
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

void puma_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v24 = s1 * s2;
    const double v25 = c1 * s2;
    const double v26 = s1 * c2;
    const double v27 = c1 * c2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double v28 = v24 * c3 + v26 * s3;
    const double v29 = v25 * c3 + v27 * s3;
    const double v30 = c2 * c3 - s2 * s3;
    const double v31 = s2 * c3 + c2 * s3;
    const double v32 = v24 * s3 - v26 * c3;
    const double v33 = v27 * c3 - v25 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double v34 = c1 * c4 + v32 * s4;
    const double v35 = s1 * c4 + v33 * s4;
    const double v36 = v31 * s4;
    const double v37 = v31 * c4;
    const double v38 = c1 * s4 - v32 * c4;
    const double v39 = s1 * s4 - v33 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double T13 = v28 * c5 + v38 * s5;
    const double T23 = v39 * s5 - v29 * c5;
    const double T33 = v30 * c5 - v37 * s5;
    const double v40 = v39 * c5 + v29 * s5;
    const double v41 = v37 * c5 + v30 * s5;
    const double v42 = v28 * s5 - v38 * c5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11 = v34 * c6 + v42 * s6;
    const double T21 = v35 * c6 - v40 * s6;
    const double T31 = v36 * c6 + v41 * s6;
    const double T12 = v42 * c6 - v34 * s6;
    const double T32 = v41 * c6 - v36 * s6;
    const double T14 = v24 * L2 + c1 * D3 + v28 * D4 - D3 * T11 - T13 * f1;
    const double T24 = s1 * D3 - v25 * L2 - v29 * D4 - D3 * T21 - T23 * f1;
    const double T34 = c2 * L2 + v30 * D4 - D3 * T31 - T33 * f1;
    T[0] = T11; T[1] = T12; T[2] = T13; T[3] = T14;
    T[4] = T21; T[5] = -(v40 * c6 + v35 * s6); T[6] = T23; T[7] = T24;
    T[8] = T31; T[9] = T32; T[10] = T33; T[11] = T34;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v35 = s1 * s2;
    const double v36 = c1 * s2;
    const double v37 = s1 * c2;
    const double v38 = c1 * c2;
    const double v39 = v35 * L2;
    const double v40 = v36 * L2;
    const double v41 = c2 * L2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double J44 = v35 * c3 + v37 * s3;
    const double v42 = v36 * c3 + v38 * s3;
    const double J64 = c2 * c3 - s2 * s3;
    const double v43 = s2 * c3 + c2 * s3;
    const double v44 = v39 + c1 * D3;
    const double v45 = s1 * D3 - v40;
    const double v46 = v35 * s3 - v37 * c3;
    const double v47 = v38 * c3 - v36 * s3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = c1 * c4 + v46 * s4;
    const double J55 = s1 * c4 + v47 * s4;
    const double J65 = v43 * s4;
    const double v48 = v43 * c4;
    const double v49 = v44 + J44 * D4;
    const double v50 = v45 - v42 * D4;
    const double v51 = v41 + J64 * D4;
    const double v52 = c1 * s4 - v46 * c4;
    const double v53 = s1 * s4 - v47 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J46 = J44 * c5 + v52 * s5;
    const double J56 = v53 * s5 - v42 * c5;
    const double J66 = J64 * c5 - v48 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double v54 = v50 - D3 * (J55 * c6 - (v53 * c5 + v42 * s5) * s6);
    const double J21 = v49 - D3 * (J45 * c6 + (J44 * s5 - v52 * c5) * s6) - J46 * g1;
    const double v55 = J56 * g1;
    const double v56 = v54 - v55;
    const double v57 = v51 - D3 * (J65 * c6 + (v48 * c5 + J64 * s5) * s6) - J66 * g1;
    const double J11 = v55 - v54;
    const double J12 = s1 * v57;
    const double J32 = c1 * v56 - s1 * J21;
    const double v58 = v57 - v41;
    const double J13 = s1 * v58;
    const double J33 = c1 * (v40 + v56) - s1 * (J21 - v39);
    const double v59 = J21 - v44;
    const double v60 = v56 - v45;
    const double J24 = J64 * v59 - J44 * v58;
    const double J34 = J44 * v60 + v42 * v59;
    const double v61 = J21 - v49;
    const double v62 = v56 - v50;
    const double v63 = v57 - v51;
    const double J15 = J55 * v63 - J65 * v62;
    const double J25 = J65 * v61 - J45 * v63;
    const double J35 = J45 * v62 - J55 * v61;
    const double J16 = J56 * v63 - J66 * v62;
    const double J26 = J66 * v61 - J46 * v63;
    const double J36 = J46 * v62 - J56 * v61;
    J[0] = J11; J[1] = J12; J[2] = J13; J[3] = -(v42 * v58 + J64 * v60); J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = -(c1 * v57); J[8] = -(c1 * v58); J[9] = J24; J[10] = J25; J[11] = J26;
    J[12] = 0.0; J[13] = J32; J[14] = J33; J[15] = J34; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = c1; J[20] = c1; J[21] = J44; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = s1; J[26] = s1; J[27] = -v42; J[28] = J55; J[29] = J56;
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
    const double t24 = T[7] + D3 * T[4] + k1 * T[6];
    const double t14 = T[3] + D3 * T[0] + k1 * T[2];
    const double N1 = t24 * t24 + t14 * t14;
    const double D1 = N1 - k2;
    const int free1 = N1 <= free_square_tolerance2;
    const double v37 = 2.0 * fabs(-D3);
    const int apart1 = merge_tolerance1 * (v37 + merge_tolerance1) < D1;
    if (!(-(reach_tolerance1 * (v37 + reach_tolerance1)) <= D1)) return;
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double v39 = 1.0 / (free1 ? 1.0 : N1);
    const double v40 = D3 * t24;
    const double v41 = D3 * t14;

    /* theta3: type 8 */
    const double t34 = T[11] + D3 * T[8] + k1 * T[10];
    const double v42 = t34 * t34;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1: type 2 */
        if (e1 < 0.0 && (free1 || !apart1)) continue;
        const double v38 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : v39 * (v41 + t24 * v38);
        const double s1 = free1 ? sin(seed[0]) : v39 * (v40 - t14 * v38);
        const double q1 = atan2(s1, c1);

        /* theta3: type 8 */
        const double N3 = v42 + v38 * v38;
        const double K3 = N3 - k4;
        const double D3_ = (longest2 - N3) * (N3 - shortest2);
        const int apart3 = shortest2_apart < N3 && N3 < longest2_apart;
        if (!(shortest2_reach <= N3 && N3 <= longest2_reach)) continue;
        const double w3 = sqrt(apart3 ? D3_ : 0.0);
        const double c3 = K3 * k6;

        /* theta2: type 3 */
        const double v44 = L2 + D4 * c3;
        const double v45 = v38 * v44;
        const double v47 = t34 * v44;

        /* theta4: type 2 */
        const double v50 = T[2] * s1 - T[6] * c1;
        const double v51 = T[2] * c1 + T[6] * s1;
        const double v52 = v51 * v51;

        /* theta6: type 3 */
        const double v55 = T[1] * c1 + T[5] * s1;
        const double v56 = T[1] * s1 - T[5] * c1;
        const double v58 = T[0] * c1 + T[4] * s1;
        const double v59 = T[0] * s1 - T[4] * c1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3: type 8 */
            if (e2 < 0.0 && !apart3) continue;
            const double s3 = w3 * e2 * k6;
            const double q3 = atan2(s3, c3);

            /* theta2: type 3 */
            const double v43 = D4 * s3;
            const double v46 = t34 * v43 + v45;
            const double v48 = v47 - v38 * v43;
            const double w2 = sqrt(v46 * v46 + v48 * v48);
            const int free2 = w2 <= free_square_tolerance2;
            const double v49 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : v48 * v49;
            const double s2 = free2 ? sin(seed[1]) : -(v46 * v49);
            const double q2 = atan2(s2, c2);

            /* theta4: type 2 */
            const double c23 = c3 * c2 - s3 * s2;
            const double s23 = c3 * s2 + s3 * c2;
            const double X4 = c23 * v50 - T[10] * s23;
            const double w4 = sqrt(X4 * X4 + v52);
            const int free4 = w4 <= free_tolerance;
            const double v53 = free4 ? 1.0 : w4;

            /* theta5: type 3 */
            const double c5 = T[10] * c23 + s23 * v50;

            /* theta6: type 3 */
            const double v57 = T[9] * s23 - c23 * v56;
            const double v60 = T[8] * s23 - c23 * v59;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4: type 2 */
                if (e3 < 0.0 && free4) continue;
                const double v54 = e3 / v53;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * v54);
                const double s4 = free4 ? sin(seed[3]) : -(v51 * v54);
                const double q4 = atan2(s4, c4);

                /* theta5: type 3 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6: type 3 */
                const double c6 = c4 * v58 + s4 * v60;
                const double q6 = atan2(-(c4 * v55 + s4 * v57), c6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free1 || free2 || free4 ? PUMA_FREE_JOINT : PUMA_OK;
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

int puma_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? PUMA_UNREACHABLE : PUMA_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PUMA_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == PUMA_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PUMA_OUT_OF_LIMITS;
        }
        count += status[row] != PUMA_OUT_OF_LIMITS;
    }
    return count;
}

int puma_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -PUMA_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (puma_ik(T, q_seed, all, status) == -PUMA_INVALID_POSE)
        return -PUMA_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == PUMA_OUT_OF_LIMITS && result == -PUMA_UNREACHABLE)
            result = -PUMA_OUT_OF_LIMITS;
        if (status[row] != PUMA_OK && status[row] != PUMA_FREE_JOINT)
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

void puma_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)puma_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
