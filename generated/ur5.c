/* ur5: Universal Robots UR5
 * Inverse kinematics, generated from robots/ur5.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/ur5.yaml. The formulas and where they come from: ur5.md.
 */
#include "ur5.h"

#include <math.h>

static const double d6 = 0.0823; /* joint offset 6 */
static const double d4 = 0.10915; /* joint offset 4 */
static const double k1 = 0.0119137225; /* d4 * d4 */
static const double free_square_tolerance2 = 1.4220777150809998e-24; /* the same, squared [length^2] */
static const double reach_tolerance1 = 1.192509e-13; /* rounding at the boundary of the workspace [length] */
static const double merge_tolerance1 = 1.192509e-14; /* two branches nearer than this are one [length] */
static const double free_tolerance = 1e-12; /* a vector this short fixes no angle */
static const double d1 = 0.089159; /* joint offset 1 */
static const double d5 = 0.09465; /* joint offset 5 */
static const double a2 = -0.425; /* link length 2 */
static const double a3 = -0.39225; /* link length 3 */
static const double k6 = 0.3344850625; /* (a2 * a2) + (a3 * a3) */
static const double longest5 = 0.6678975625000001; /* square of the longest reach */
static const double shortest5 = 0.0010725625000000002; /* square of the shortest reach */
static const double longest5_reach = 0.6678975625001949; /* the same, longest by rounding */
static const double shortest5_reach = 0.0010725624999921891; /* the same, shortest by rounding */
static const double longest5_apart = 0.6678975624999807; /* the same, longest for merging */
static const double shortest5_apart = 0.0010725625000007814; /* the same, shortest for merging */
static const double k8 = 2.99928766917857; /* 1 / (2 * (a3 * a2)) */

const char *const ur5_branches[8] = {
    "left-noflip-down",
    "left-noflip-up",
    "left-flip-down",
    "left-flip-up",
    "right-noflip-down",
    "right-noflip-up",
    "right-flip-down",
    "right-flip-up",
};

static const double lowest[6] = { -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586 };
static const double highest[6] = { 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586 };
static const double turn = 6.283185307179586;
enum { LOST = 128 };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void ur5_fk(const double q[6], double T[16])
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
    const double v31 = v25 * c4 - v28 * s4;
    const double v32 = v26 * c4 - v29 * s4;
    const double v33 = v27 * c4 + v30 * s4;
    const double v34 = v28 * c4 + v25 * s4;
    const double v35 = v29 * c4 + v26 * s4;
    const double v36 = v30 * c4;
    const double v37 = v27 * s4;
    const double v38 = v36 - v37;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double v39 = v31 * c5 + s1 * s5;
    const double v40 = v32 * c5 - c1 * s5;
    const double v41 = v33 * c5;
    const double T13 = s1 * c5 - v31 * s5;
    const double v42 = c1 * c5 + v32 * s5;
    const double v43 = v33 * s5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11 = v39 * c6 - v34 * s6;
    const double T21 = v40 * c6 - v35 * s6;
    const double T31 = v41 * c6 + v38 * s6;
    const double T32 = v38 * c6 - v41 * s6;
    const double T14 = v21 * a2 + v25 * a3 + s1 * d4 + v34 * d5 + T13 * d6;
    const double T24 = v22 * a2 + v26 * a3 - c1 * d4 + v35 * d5 - v42 * d6;
    const double T34 = d1 + s2 * a2 + v27 * a3 + (v37 - v36) * d5 - v43 * d6;
    T[0] = T11; T[1] = -(v34 * c6 + v39 * s6); T[2] = T13; T[3] = T14;
    T[4] = T21; T[5] = -(v35 * c6 + v40 * s6); T[6] = -v42; T[7] = T24;
    T[8] = T31; T[9] = T32; T[10] = -v43; T[11] = T34;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void ur5_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v27 = c1 * c2;
    const double v28 = s1 * c2;
    const double v29 = c1 * s2;
    const double v30 = s1 * s2;
    const double v31 = v27 * a2;
    const double v32 = v28 * a2;
    const double v33 = d1 + s2 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double v34 = v27 * c3 - v29 * s3;
    const double v35 = v28 * c3 - v30 * s3;
    const double v36 = s2 * c3 + c2 * s3;
    const double v37 = v29 * c3 + v27 * s3;
    const double v38 = v30 * c3 + v28 * s3;
    const double v39 = c2 * c3 - s2 * s3;
    const double v40 = v31 + v34 * a3;
    const double v41 = v32 + v35 * a3;
    const double v42 = v33 + v36 * a3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double J45 = v37 * c4 + v34 * s4;
    const double J55 = v38 * c4 + v35 * s4;
    const double v43 = v40 + s1 * d4;
    const double v44 = v41 - c1 * d4;
    const double J65 = v36 * s4 - v39 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J46 = s1 * c5 - (v34 * c4 - v37 * s4) * s5;
    const double v45 = c1 * c5 + (v35 * c4 - v38 * s4) * s5;
    const double v46 = (v36 * c4 + v39 * s4) * s5;
    const double v47 = v43 + J45 * d5;
    const double v48 = v44 + J55 * d5;
    const double v49 = v42 + J65 * d5;
    const double J21 = v47 + J46 * d6;
    const double v50 = v45 * d6;
    const double v51 = v48 - v50;
    const double v52 = v49 - v46 * d6;
    const double J11 = v50 - v48;
    const double v53 = v52 - d1;
    const double J32 = s1 * v51 + c1 * J21;
    const double v54 = v52 - v33;
    const double J33 = s1 * (v51 - v32) + c1 * (J21 - v31);
    const double v55 = v52 - v42;
    const double J34 = s1 * (v51 - v41) + c1 * (J21 - v40);
    const double v56 = J21 - v43;
    const double v57 = v51 - v44;
    const double J15 = J55 * v55 - J65 * v57;
    const double J25 = J65 * v56 - J45 * v55;
    const double J35 = J45 * v57 - J55 * v56;
    const double v58 = J21 - v47;
    const double v59 = v51 - v48;
    const double v60 = v52 - v49;
    const double J16 = v46 * v59 - v45 * v60;
    const double J36 = J46 * v59 + v45 * v58;
    J[0] = J11; J[1] = -(c1 * v53); J[2] = -(c1 * v54); J[3] = -(c1 * v55); J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = -(s1 * v53); J[8] = -(s1 * v54); J[9] = -(s1 * v55); J[10] = J25; J[11] =
    -(v46 * v58 + J46 * v60);
    J[12] = 0.0; J[13] = J32; J[14] = J33; J[15] = J34; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = s1; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -c1; J[28] = J55; J[29] = -v45;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = J65; J[35] = -v46;
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

/* Fills the rows of the branches that have a solution, and no others. A row that was lost after joint j had
 * been chosen freely gets the status LOST + j and, as its first value, how far it is from a solution. */
static void solve(const double T[16], const double seed[6],
    double q[8][6], unsigned char status[8])
{

    /* theta1: type 2 */
    const double X1 = T[2] * d6 - T[3];
    const double wy = T[7] - d6 * T[6];
    const double N1 = X1 * X1 + wy * wy;
    const double D1 = N1 - k1;
    const int free1 = N1 <= free_square_tolerance2;
    const double v38 = 2.0 * fabs(-d4);
    const int apart1 = merge_tolerance1 * (v38 + merge_tolerance1) < D1;
    if (!(-(reach_tolerance1 * (v38 + reach_tolerance1)) <= D1)) return;
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double v40 = 1.0 / (free1 ? 1.0 : N1);
    const double v41 = X1 * d4;
    const double v42 = wy * d4;

    /* theta3: type 8 */
    const double v47 = T[11] - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1: type 2 */
        if (e1 < 0.0 && (free1 || !apart1)) continue;
        const double v39 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : -(v40 * (v42 + X1 * v39));
        const double s1 = free1 ? sin(seed[0]) : v40 * (wy * v39 - v41);
        const double q1 = atan2(s1, c1);

        /* theta6: type 2 */
        const double X6 = T[4] * c1 - T[0] * s1;
        const double Y6 = T[5] * c1 - T[1] * s1;
        const double w6 = sqrt(X6 * X6 + Y6 * Y6);
        const int free6 = w6 <= free_tolerance;
        const double v43 = free6 ? 1.0 : w6;

        /* theta5: type 3 */
        const double c5 = T[2] * s1 - T[6] * c1;

        /* theta3: type 8 */
        const double v49 = T[3] * c1 + T[7] * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta6: type 2 */
            if (e2 < 0.0 && free6) continue;
            const double v44 = e2 / v43;
            const double c6 = free6 ? cos(seed[5]) : -(X6 * v44);
            const double s6 = free6 ? sin(seed[5]) : Y6 * v44;
            const double q6 = atan2(s6, c6);
            const double s5 = w6 * e2;

            /* theta5: type 3 */
            const double q5 = atan2(s5, c5);

            /* theta234: type 3 */
            const double c234 = c6 * T[9] + s6 * T[8];
            const double s234 = c5 * (c6 * T[8] - s6 * T[9]) - s5 * T[10];
            const double v45 = atan2(s234, c234);

            /* theta3: type 8 */
            const double v46 = d6 * s5;
            const double v48 = c234 * d5 + s234 * v46 + v47;
            const double v50 = c234 * v46 - s234 * d5 + v49;
            const double N3 = v48 * v48 + v50 * v50;
            const double K3 = N3 - k6;
            const double D3 = (longest5 - N3) * (N3 - shortest5);
            const int apart3 = shortest5_apart < N3 && N3 < longest5_apart;
            if (!(shortest5_reach <= N3 && N3 <= longest5_reach)) {
                if (free1) {
                    status[4 * i1 + 2 * i2] = LOST + 1;
                    q[4 * i1 + 2 * i2][0] = D3;
                }
                if (free6) {
                    status[4 * i1 + 2 * i2] = LOST + 6;
                    q[4 * i1 + 2 * i2][0] = D3;
                }
                continue;
            }
            const double w3 = sqrt(apart3 ? D3 : 0.0);
            const double c3 = K3 * k8;

            /* theta2: type 3 */
            const double v51 = a2 + a3 * c3;
            const double v53 = v48 * v51;
            const double v55 = v50 * v51;

            for (int i3 = 0; i3 < 2; i3++) { /* down, up */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta3: type 8 */
                if (e3 < 0.0 && !apart3) continue;
                const double s3 = w3 * e3 * k8;
                const double q3 = atan2(s3, c3);

                /* theta2: type 3 */
                const double v52 = a3 * s3;
                const double v54 = v53 - v50 * v52;
                const double v56 = v55 + v48 * v52;
                const double w2 = sqrt(v54 * v54 + v56 * v56);
                const int free2 = w2 <= free_square_tolerance2;
                const double v57 = 1.0 / (free2 ? 1.0 : w2);
                const double c2 = free2 ? cos(seed[1]) : v56 * v57;
                const double s2 = free2 ? sin(seed[1]) : v54 * v57;
                const double q2 = atan2(s2, c2);

                /* joint values */
                const double q4 = wrap(v45 - (q3 + q2));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = q3;
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free1 || free2 || free6 ? UR5_FREE_JOINT : UR5_OK;
            }
        }
    }
}

/* Solves with another seed for one joint. Returns 0 if the row is then solved, else how far it is from that. */
static double attempt(const double T[16], double seed[6], int joint, double angle, int row,
    double q[8][6], unsigned char status[8])
{
    const double kept = seed[joint];
    seed[joint] = angle;
    for (int i = 0; i < 8; i++)
        status[i] = UR5_UNREACHABLE;
    solve(T, seed, q, status);
    seed[joint] = kept;
    if (status[row] >= LOST)
        return q[row][0];
    return status[row] == UR5_UNREACHABLE ? -HUGE_VAL : 0.0;
}

/* A free joint took the seed's value, and then the arm could not reach: takes the value nearest to the
 * seed's from which it can. A fan of angles finds where the branch is solved, bisection the nearest
 * such angle; where no angle of the fan serves, golden section goes for the best of them. */
static void choose_again(const double T[16], const double given[6], int row,
    double q[8][6], unsigned char status[8])
{
    enum { FAN = 32, HALVINGS = 52 };
    const double step = turn / (2.0 * FAN), ratio = 0.6180339887498949;
    const int joint = status[row] - LOST - 1;
    const double start = given[joint];
    double seed[6], trial[8][6], best = -HUGE_VAL, peak = 0.0, outer = 0.0;
    unsigned char result[8];
    int found = 0;
    for (int i = 0; i < 6; i++)
        seed[i] = given[i];
    for (int k = 1; k <= 2 * FAN && !found; k++) {
        outer = (k % 2 ? step : -step) * ((k + 1) / 2);
        const double reach = attempt(T, seed, joint, start + outer, row, trial, result);
        found = reach == 0.0;
        if (reach > best) {
            best = reach;
            peak = outer;
        }
    }
    double inner = outer > 0.0 ? outer - step : outer + step;
    if (!found) {
        double low = peak - step, high = peak + step;
        for (int k = 0; k < HALVINGS && !found; k++) {
            const double a = high - ratio * (high - low), b = low + ratio * (high - low);
            const double at_a = attempt(T, seed, joint, start + a, row, trial, result);
            const double at_b = attempt(T, seed, joint, start + b, row, trial, result);
            found = at_a == 0.0 || at_b == 0.0;
            outer = at_a >= at_b ? a : b;
            low = at_a >= at_b ? low : a;
            high = at_a >= at_b ? b : high;
        }
        inner = outer > 0.0 ? peak - step : peak + step;
    }
    status[row] = UR5_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[row][i] = NAN;
    if (!found)
        return;
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (inner + outer);
        if (attempt(T, seed, joint, start + middle, row, trial, result) == 0.0)
            outer = middle;
        else
            inner = middle;
    }
    (void)attempt(T, seed, joint, start + outer, row, trial, result);
    status[row] = result[row];
    for (int i = 0; i < 6; i++)
        q[row][i] = trial[row][i];
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

int ur5_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? UR5_UNREACHABLE : UR5_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -UR5_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] >= LOST)
            choose_again(pose, seed, row, q, status);
        if (status[row] == UR5_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = UR5_OUT_OF_LIMITS;
        }
        count += status[row] != UR5_OUT_OF_LIMITS;
    }
    return count;
}

int ur5_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -UR5_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    if (ur5_ik(T, q_seed, all, status) == -UR5_INVALID_POSE)
        return -UR5_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == UR5_OUT_OF_LIMITS && result == -UR5_UNREACHABLE)
            result = -UR5_OUT_OF_LIMITS;
        if (status[row] != UR5_OK && status[row] != UR5_FREE_JOINT)
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

void ur5_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)ur5_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
