/* planar_rrr: Planar arm with three revolute joints
 * Inverse kinematics, generated from robots/planar_rrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rrr.yaml. The formulas and where they come from: planar_rrr.md.
 */
#include "planar_rrr.h"

#include <math.h>

static const double free_square_tolerance = 1e-24; /* the same, squared */
static const double a3 = 0.15; /* link length 3 */
static const double a1 = 0.4; /* link length 1 */
static const double a2 = 0.3; /* link length 2 */
static const double k5 = 0.25; /* (a1 * a1) + (a2 * a2) */
static const double longest2 = 0.48999999999999994; /* square of the longest reach */
static const double shortest2 = 0.010000000000000007; /* square of the shortest reach */
static const double longest2_reach = 0.490000000000119; /* the same, longest by rounding */
static const double shortest2_reach = 0.009999999999983007; /* the same, shortest by rounding */
static const double longest2_apart = 0.48999999999998795; /* the same, longest for merging */
static const double shortest2_apart = 0.010000000000001705; /* the same, shortest for merging */
static const double k7 = 4.166666666666667; /* 1 / (2 * (a2 * a1)) */
static const double free_square_tolerance2 = 7.224999999999999e-25; /* the same, squared [length^2] */
static const double k8 = 99999.99999999999; /* 1 / consistent_tolerance */
static const double k9 = 117647.05882352941; /* 1 / consistent_tolerance1 */

const char *const planar_rrr_branches[2] = {
    "down",
    "up",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const double turn = 6.283185307179586;
enum { LOST = 128 };

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void planar_rrr_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v11 = c1 * c2 - s1 * s2;
    const double v12 = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double T11 = v11 * c3 - v12 * s3;
    const double T21 = v12 * c3 + v11 * s3;
    const double T14 = c1 * a1 + v11 * a2 + T11 * a3;
    const double T24 = s1 * a1 + v12 * a2 + T21 * a3;
    T[0] = T11; T[1] = -T21; T[2] = 0.0; T[3] = T14;
    T[4] = T21; T[5] = T11; T[6] = 0.0; T[7] = T24;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_rrr_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double v12 = c1 * a1;
    const double v13 = s1 * a1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double v14 = c1 * c2 - s1 * s2;
    const double v15 = s1 * c2 + c1 * s2;
    const double v16 = v12 + v14 * a2;
    const double v17 = v13 + v15 * a2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double J21 = v16 + (v14 * c3 - v15 * s3) * a3;
    const double v18 = v17 + (v15 * c3 + v14 * s3) * a3;
    const double J22 = J21 - v12;
    const double J12 = v13 - v18;
    const double J23 = J21 - v16;
    const double J13 = v17 - v18;
    J[0] = -v18; J[1] = J12; J[2] = J13;
    J[3] = J21; J[4] = J22; J[5] = J23;
    J[6] = 0.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 1.0; J[16] = 1.0; J[17] = 1.0;
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
static void solve(const double T[16], const double seed[3],
    double q[2][3], unsigned char status[2])
{

    /* theta123: type 3 */
    const double w123 = sqrt(T[4] * T[4] + T[0] * T[0]);
    const int free123 = w123 <= free_square_tolerance;
    const double v22 = 1.0 / (free123 ? 1.0 : w123);
    const double v23 = seed[0] + seed[1] + seed[2];
    const double c123 = free123 ? cos(v23) : T[0] * v22;
    const double s123 = free123 ? sin(v23) : T[4] * v22;
    const double v24 = atan2(s123, c123);

    /* theta2: type 8 */
    const double v25 = c123 * a3;
    const double v26 = T[3] - v25;
    const double v27 = s123 * a3;
    const double v28 = T[7] - v27;
    const double N2 = v26 * v26 + v28 * v28;
    const double K2 = N2 - k5;
    const double D2 = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) {
        if (free123) {
            status[0] = LOST + 1;
            q[0][0] = D2;
        }
        if (free123) {
            status[0] = LOST + 2;
            q[0][0] = D2;
        }
        if (free123) {
            status[0] = LOST + 3;
            q[0][0] = D2;
        }
        return;
    }
    const double w2 = sqrt(apart2 ? D2 : 0.0);
    const double c2 = K2 * k7;

    /* theta1: type 3 */
    const double v29 = a1 + a2 * c2;
    const double v31 = v28 * v29;
    const double v33 = v26 * v29;

    /* is the pose one that the arm can take? */
    const double v36 = fmax(fmax(fabs(c123 - T[0]) * k8, k8 * fabs(-(T[1] + s123))), k8 *
        fabs(-T[2]));
    const double v37 = k8 * fabs(s123 - T[4]);
    const double v38 = k8 * fabs(c123 - T[5]);
    const double v39 = k8 * fabs(-T[6]);
    const double v40 = k8 * fabs(-T[8]);
    const double v41 = k8 * fabs(-T[9]);
    const double v42 = k8 * fabs(1.0 - T[10]);
    const double v43 = k9 * fabs(-T[11]);

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2: type 8 */
        if (e1 < 0.0 && !apart2) continue;
        const double s2 = w2 * e1 * k7;
        const double q2 = atan2(s2, c2);

        /* theta1: type 3 */
        const double v30 = a2 * s2;
        const double v32 = v31 - v26 * v30;
        const double v34 = v33 + v28 * v30;
        const double w1 = sqrt(v32 * v32 + v34 * v34);
        const int free1 = w1 <= free_square_tolerance2;
        const double v35 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : v34 * v35;
        const double s1 = free1 ? sin(seed[0]) : v32 * v35;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1;
        const double s12 = c2 * s1 + s2 * c1;
        if (!(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fmax(fmax(v36, fabs(a2 * c12 + (v25 + a1 * c1) - T[3]) * k9), v37), v38), v39), k9 * fabs(a2 * s12 + (v27 + a1 * s1) - T[7])), v40), v41), v42), v43) <= 1.0)) continue;

        /* joint values */
        const double q3 = wrap(v24 - (q2 + q1));
        const int free1_ = free123 || free1;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = q3;
        status[row] = free1_ || free123 || free123 ? PLANAR_RRR_FREE_JOINT : PLANAR_RRR_OK;
    }
}

/* Solves with another seed for one joint. Returns 0 if the row is then solved, else how far it is from that. */
static double attempt(const double T[16], double seed[3], int joint, double angle, int row,
    double q[2][3], unsigned char status[2])
{
    const double kept = seed[joint];
    seed[joint] = angle;
    for (int i = 0; i < 2; i++)
        status[i] = PLANAR_RRR_UNREACHABLE;
    solve(T, seed, q, status);
    seed[joint] = kept;
    if (status[row] >= LOST)
        return q[row][0];
    return status[row] == PLANAR_RRR_UNREACHABLE ? -HUGE_VAL : 0.0;
}

/* A free joint took the seed's value, and then the arm could not reach: takes the value nearest to the
 * seed's from which it can. A fan of angles finds where the branch is solved, bisection the nearest
 * such angle; where no angle of the fan serves, golden section goes for the best of them. */
static void choose_again(const double T[16], const double given[3], int row,
    double q[2][3], unsigned char status[2])
{
    enum { FAN = 32, HALVINGS = 52 };
    const double step = turn / (2.0 * FAN), ratio = 0.6180339887498949;
    const int joint = status[row] - LOST - 1;
    const double start = given[joint];
    double seed[3], trial[2][3], best = -HUGE_VAL, peak = 0.0, outer = 0.0;
    unsigned char result[2];
    int found = 0;
    for (int i = 0; i < 3; i++)
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
    status[row] = PLANAR_RRR_UNREACHABLE;
    for (int i = 0; i < 3; i++)
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
    for (int i = 0; i < 3; i++)
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

int planar_rrr_ik(const double T[16], const double *q_seed,
    double q[2][3], unsigned char status[2])
{
    static const double zeros[3] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? PLANAR_RRR_UNREACHABLE : PLANAR_RRR_INVALID_POSE;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PLANAR_RRR_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] >= LOST)
            choose_again(pose, seed, row, q, status);
        if (status[row] == PLANAR_RRR_UNREACHABLE)
            continue;
        for (int i = 0; i < 3; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PLANAR_RRR_OUT_OF_LIMITS;
        }
        count += status[row] != PLANAR_RRR_OUT_OF_LIMITS;
    }
    return count;
}

int planar_rrr_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[2][3], least = HUGE_VAL;
    unsigned char status[2];
    int result = -PLANAR_RRR_UNREACHABLE;
    for (int i = 0; i < 3; i++)
        q[i] = NAN;
    if (planar_rrr_ik(T, q_seed, all, status) == -PLANAR_RRR_INVALID_POSE)
        return -PLANAR_RRR_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        double distance = 0.0;
        if (status[row] == PLANAR_RRR_OUT_OF_LIMITS && result == -PLANAR_RRR_UNREACHABLE)
            result = -PLANAR_RRR_OUT_OF_LIMITS;
        if (status[row] != PLANAR_RRR_OK && status[row] != PLANAR_RRR_FREE_JOINT)
            continue;
        for (int i = 0; i < 3; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            distance += (all[row][i] - q_seed[i]) * (all[row][i] - q_seed[i]);
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

void planar_rrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)planar_rrr_ik(T + 16 * k, NULL, (double (*)[3])(q + 6 * k), status + 2 * k);
}
