/* cuspidal_3r: Cuspidal 3R arm
 *
 * Inverse kinematics, generated from robots/cuspidal_3r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cuspidal_3r.yaml. The formulas and where they come from:
 * cuspidal_3r.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 7c0913eb7097a9fe
 * SPDX-License-Identifier: MIT
 */
#include "cuspidal_3r.h"

#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/circle_roots.h"
#include "dhgen/refine.h"
#include "dhgen/retry.h"

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

enum { OK = DHGEN_OK, NONE = DHGEN_UNREACHABLE, FREE = DHGEN_FREE_JOINT, CLOSE = DHGEN_CLOSE };

static void take(const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
}

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[3] = { 0, 1, 2 };
static const int turning[3] = { 1, 1, 1 };
static const double unit[3] = { 1.0, 1.0, 1.0 };
static const double measure[3] = { 0.18181818181818182, 0.18181818181818182, 0.18181818181818182 };
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct descent {
    const double *T;
    double q[3], seed[3]; /* all joint values; the seed in units */
    double e[3], length; /* the miss [arm sizes, rad], and its length */
    double A[3][3]; /* how u moves the tool */
};

/* By how much u misses the pose, and the analytic Jacobian of that. */
static void look(struct descent *d, const double u[3])
{
    double P[16], J[18], square = 0.0;
    for (int j = 0; j < 3; j++)
        d->q[solved[j]] = unit[j] * u[j];
    cuspidal_3r_fk(d->q, P);
    cuspidal_3r_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 5.5;
        for (int j = 0; j < 3; j++)
            d->A[i][j] = measure[j] * J[3 * row + solved[j]];
    }
    for (int i = 0; i < 3; i++)
        square += d->e[i] * d->e[i];
    d->length = sqrt(square);
}

/* What is added from start to start, in parts of the range: a direction that is like no other. */
static const double stride[3] = { 0.8191725133961644, 0.6710436067037892, 0.5497004779019702 };

static void copy(const double from[3], double to[3])
{
    for (int j = 0; j < 3; j++)
        to[j] = from[j];
}

/* Moves angles by whole turns to (-pi, pi]. */
static void wrap_angles(double u[3])
{
    for (int j = 0; j < 3; j++)
        if (turning[j])
            u[j] -= 6.283185307179586 * ceil(u[j] / 6.283185307179586 - 0.5);
}

/* Makes a step no longer than it may be. */
static void shorten(double step[3])
{
    double longest = 2.0;
    for (int j = 0; j < 3; j++)
        longest = fmax(longest, fabs(step[j]));
    for (int j = 0; j < 3; j++)
        step[j] *= 2.0 / longest;
}

/* The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping. The rows of
 * A, each with its share of the damping's root behind it, are made orthonormal one after another
 * (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994):
 * A A' would lose half of the digits. */
static void damped_step(
    const struct descent *d, const double e[3], double length, double little,
    double step[3])
{
    const double damping = 0.1 * fmin(length * length, 1.0) + little;
    double rows[3][6], y[3], sum[6] = { 0.0 };
    for (int i = 0; i < 3; i++) {
        double square = 0.0;
        for (int j = 0; j < 6; j++)
            rows[i][j] = j < 3 ? d->A[i][j] : j == 3 + i ? sqrt(damping) : 0.0;
        y[i] = e[i];
        for (int k = 0; k < i; k++) {
            double along = 0.0;
            for (int j = 0; j < 6; j++)
                along += rows[k][j] * rows[i][j];
            for (int j = 0; j < 6; j++)
                rows[i][j] -= along * rows[k][j];
            y[i] -= along * y[k];
        }
        for (int j = 0; j < 6; j++)
            square += rows[i][j] * rows[i][j];
        const double inverse = 1.0 / sqrt(square);
        y[i] *= inverse;
        for (int j = 0; j < 6; j++)
            rows[i][j] *= inverse;
    }
    for (int i = 3 - 1; i >= 0; i--) {
        double missing = y[i];
        for (int j = 0; j < 6; j++)
            missing -= rows[i][j] * sum[j];
        for (int j = 0; j < 6; j++)
            sum[j] += missing * rows[i][j];
    }
    for (int j = 0; j < 3; j++)
        step[j] = sum[j];
}

/* Takes a row as far as steps help, and tells how long another one would be; returns by how much
 * the row misses the pose then. Beside a singular place a step that is right may be long, and what
 * it leaves, half of its square, far more than was missed. */
static double descended(struct descent *d, int steps, double exact, double q[3], double *ahead)
{
    double u[3], best[3], step[3], least = HUGE_VAL;
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    for (int i = 0; i < 3; i++)
        d->q[i] = q[i];
    for (int j = 0; j < 3; j++)
        best[j] = u[j] = q[solved[j]] / unit[j];
    *ahead = HUGE_VAL;
    for (int k = 0; k <= steps; k++) {
        look(d, u);
        damped_step(d, d->e, d->length, 1e-26, step);
        const int slow = !(d->length <= fmax(0.5 * last, left));
        if (d->length < least) {
            least = d->length;
            *ahead = 0.0;
            copy(u, best);
            for (int j = 0; j < 3; j++)
                *ahead = fmax(*ahead, fabs(step[j]));
        }
        if (slow || (least <= 0.001 * exact && *ahead <= 0.0001))
            break;
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 3; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = 0.5 * way * way;
    }
    wrap_angles(best);
    for (int j = 0; j < 3; j++)
        q[solved[j]] = unit[j] * best[j];
    return least;
}

/* The part of a generic direction that leaves the tool where it is, to first order, one long;
 * returns how long it was. */
static double sideways(const struct descent *d, double along[3])
{
    double moved[3], square = 0.0;
    for (int i = 0; i < 3; i++) {
        moved[i] = 0.0;
        for (int j = 0; j < 3; j++)
            moved[i] += d->A[i][j] * stride[j];
    }
    damped_step(d, moved, 0.0, 1e-13, along);
    for (int j = 0; j < 3; j++) {
        along[j] = stride[j] - along[j];
        square += along[j] * along[j];
    }
    const double length = sqrt(square);
    for (int j = 0; j < 3; j++)
        along[j] /= length;
    return length;
}

/* Takes a row as far as steps help, also from both sides of where they get slow: where many
 * solutions meet, joint values between them are singular. A root of four is missed by the fourth
 * power of the way to it. */
static double escaped(struct descent *d, double exact, double q[3])
{
    double ahead, least = descended(d, 72, exact, q, &ahead);
    for (int k = 0; k < 8 && least > exact; k++) {
        double u[3], along[3], end[2][3], miss[2];
        for (int j = 0; j < 3; j++)
            u[j] = q[solved[j]] / unit[j];
        look(d, u);
        if (sideways(d, along) <= 0.0001)
            break;
        double pace = sqrt(sqrt(least));
        for (int side = 0; side < 2; side++) {
            for (int i = 0; i < 3; i++)
                end[side][i] = q[i];
            for (int j = 0; j < 3; j++)
                end[side][solved[j]] += pace * unit[j] * along[j];
            pace = -pace;
            miss[side] = descended(d, 72, exact, end[side], &ahead);
        }
        const int other = miss[1] < miss[0];
        if (!(miss[other] < 0.9 * least))
            break;
        least = miss[other];
        for (int i = 0; i < 3; i++)
            q[i] = end[other][i];
    }
    return least;
}

/* Takes a row to where damped least squares lead, unless it is exact; returns by how much
 * it misses the pose then, `first` being what it misses before. */
static double tightened(struct descent *d, double exact, double first, double q[3], int *moved)
{
    double end[3];
    if (first <= exact)
        return first;
    for (int i = 0; i < 3; i++)
        end[i] = q[i];
    const double least = escaped(d, exact, end);
    for (int i = 0; i < 3; i++) {
        *moved = *moved || q[i] < end[i] || q[i] > end[i];
        q[i] = end[i];
    }
    return least;
}

/* By how much the joint values of two rows differ at most. */
static double gap_between(const double q[3], const double other[3])
{
    double gap[3], widest = 0.0;
    for (int j = 0; j < 3; j++)
        gap[j] = (q[solved[j]] - other[solved[j]]) / unit[j];
    wrap_angles(gap);
    for (int j = 0; j < 3; j++)
        widest = fmax(widest, fabs(gap[j]));
    return widest;
}

/* Whether a row that was moved came to lie on one that missed by less at first. */
static int repeats(double q[4][3], const double first[4], int row)
{
    for (int k = 0; k < 4; k++)
        if ((first[k] < first[row] || (k < row && first[k] <= first[row])) && !isnan(q[k][0])
                && gap_between(q[k], q[row]) < 1e-06)
            return 1;
    return 0;
}

/* What an exact row may miss: far away rounding is more. */
static double exactness(const double T[16])
{
    double distance = 1.0; /* arm sizes */
    for (int i = 0; i < 3; i++)
        distance = fmax(distance, fabs(T[4 * coordinate[i] + 3]) / 5.5);
    return 1e-12 * distance;
}

/* Tightens the rows; ends those that miss the pose then, and all but one of those that have become
 * the same. */
static void tighten(
    const struct dhgen_arm *arm, const double T[16], double q[4][3], unsigned char status[4])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    int moved[4] = { 0 };
    double first[4], miss[4];
    for (int row = 0; row < 4; row++) {
        first[row] = miss[row] = HUGE_VAL;
        if (status[row] == NONE)
            continue;
        first[row] = dhgen_missed_by(arm, T, q[row]);
        miss[row] = tightened(&d, exact, first[row], q[row], &moved[row]);
    }
    const double enough = 10.0 * exact;
    for (int row = 0; row < 4; row++)
        if (miss[row] > enough)
            q[row][0] = DHGEN_NAN;
    for (int row = 0; row < 4; row++) {
        if (!isnan(q[row][0]) && !(moved[row] && repeats(q, first, row)))
            continue;
        status[row] = NONE;
        for (int i = 0; i < 3; i++)
            q[row][i] = DHGEN_NAN;
    }
}


static const double
    a1 = 1.0, /* link length 1 [m] */
    d2 = 1.0, /* joint offset 2 [m] */
    a2 = 2.0, /* link length 2 [m] */
    a3 = 1.5, /* link length 3 [m] */
    free_limit6 = 2.7680640624999998e-08, /* a length that fixes no angle [m^6] */
    square_rounding = 1e-15, /* squares are rounded by this */
    free_limit_squared2 = 3.025e-23, /* square of a length that fixes no angle [m^2] */
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 3.025e-05,
    k1 = 3.0, /* a3 * a2 [m^2] */
    k2 = 6.0, /* 2 * a3 * a2 [m^2] */
    k3 = -6.25, /* a1^2 - (a1^2 + (a2^2 + a3^2)) [m^2] */
    k4 = 0.5, /* 1 / 2 */
    k5 = 12.0, /* 2 * 2 * a3 * a2 [m^2] */
    k6 = 36.0, /* k2^2 [m^4] */
    k7 = 81.0, /* (a3 * 2 * a3 * a2)^2 [m^6] */
    k8 = 0.1111111111111111; /* 1 / (a3 * 2 * a3 * a2) [m^-3] */

const char *const cuspidal_3r_branches[4] = {
    "root1", "root2", "root3", "root4",
};

static const struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

void cuspidal_3r_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - s1 * s3,
        x3_y = x2_y * c3 + c1 * s3, v1 = s2 * c3;
    T[0] = x3_x; T[1] = -(s1 * c3 + x2_x * s3); T[2] = c1 * s2;
    T[3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3;
    T[4] = x3_y; T[5] = c1 * c3 - x2_y * s3; T[6] = s1 * s2;
    T[7] = s1 * a1 + x2_y * a2 + c1 * d2 + x3_y * a3;
    T[8] = -v1; T[9] = s2 * s3; T[10] = c2; T[11] = -(s2 * a2 + v1 * a3);
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void cuspidal_3r_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2, v1 = s2 * a2, p2_x = p1_x + x2_x * a2 - s1 * d2,
        p2_y = p1_y + x2_y * a2 + c1 * d2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), p3_x = p2_x + (x2_x * c3 - s1 * s3) * a3,
        p3_y = p2_y + (x2_y * c3 + c1 * s3) * a3, v2 = v1 + s2 * c3 * a3, v3 = p3_x - p2_x,
        v4 = p3_y - p2_y, v5 = v1 - v2;
    J[0] = -p3_y; J[1] = -(c1 * v2); J[2] = z2_y * v5 - c2 * v4;
    J[3] = p3_x; J[4] = -(s1 * v2); J[5] = c2 * v3 - z2_x * v5;
    J[6] = 0.0; J[7] = -(s1 * (p3_y - p1_y) + c1 * (p3_x - p1_x)); J[8] = z2_x * v4 - z2_y * v3;
    J[9] = 0.0; J[10] = -s1; J[11] = z2_x;
    J[12] = 0.0; J[13] = c1; J[14] = z2_y;
    J[15] = 1.0; J[16] = 0.0; J[17] = c2;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints;
    const double T14 = T[3];
    const double T24 = T[7];
    const double T34 = T[11];

    /* theta1, type 9: U1[3, 4] and the squared length of column 4 of U1 */
    const double v1 = T14 * T14 + (T24 * T24 + (T34 * T34 + k3));
    const double R2c1 = 2.0 * (T14 * a1);
    const double R2s1 = 2.0 * (T24 * a1);
    const double v2 = k1 + a3 * v1, v3 = a3 * R2c1 + k1 * T24, v4 = a3 * R2s1 - k1 * T14,
        v5 = k2 * T24, v6 = k2 * T14, v7 = v3 * v3, v8 = v4 * v4, v9 = 2.0 * v2, v10 = v5 * v5,
        v11 = v6 * v6, v12 = v2 * v2 + k4 * (v7 + v8) + (k6 + k4 * (v10 + v11)),
        v13 = v3 * v9 + v5 * k5, v14 = v6 * k5 - v4 * v9, v15 = k4 * (v7 - v8) + k4 * (v10 - v11),
        v16 = v3 * v4 - v5 * v6, v17 = v12 - k7;
    const int free1 = fabs(v17) + fabs(v13) + fabs(v14) + fabs(v15) + fabs(v16) <= free_limit6;
    double x1_roots[4];
    int x1_close[4];
    dhgen_circle_roots(free1 ? 1.0 : v17, free1 ? -1.0 : -v13, free1 ? 0.0 : v14, free1 ? 0.0 : v15,
        free1 ? 0.0 : v16, square_rounding * (v12 + k7), moved, x1_roots, x1_close);

    for (int i1 = 0; i1 < 4; i1++) { /* root1, root2, root3, root4 */
        const double x1 = x1_roots[i1];
        /* theta1 */
        if (!(x1 <= 4.0)) continue; /* out of reach */
        const double q1 = free1 ? seed[0] : x1;
        const double c1 = cos(q1), s1 = sin(q1);

        /* theta3, type 3: U1[3, 4] and the squared length of column 4 of U1 */
        const double v18 = d2 + (T14 * s1 - T24 * c1);
        const double c3 = (a3 * (v1 - (R2c1 * c1 + R2s1 * s1)) + k1 * v18) * k8;
        const double q3 = atan2(-(k2 * v18 * k8), c3);

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + a3 * c3;
        const double v19 = T34 * Y1_2;
        const double C2 = Y1_2 * (T14 * c1 + T24 * s1 - a1);
        const double w2 = sqrt(v19 * v19 + C2 * C2);
        const int free2 = w2 <= free_limit_squared2;
        const int near2 = w2 <= near_limit_squared2;
        const double factor2 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
            s2 = free2 ? sin(seed[1]) : -(v19 * factor2);
        const double q2 = atan2(s2, c2);
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
        status[row] = (free1 || free2) ? DHGEN_FREE_JOINT : (x1_close[i1] || near2) ? DHGEN_CLOSE :
            DHGEN_OK;
    }
}

/* Whether joint values are a solution. Beside a singular place they may miss the pose by next to
 * nothing and be far from any. */
static int solves(struct descent *d, int steps, double exact, double q[3])
{
    double ahead;
    return descended(d, steps, exact, q, &ahead) <= exact && ahead <= 0.0001;
}

/* Whether a solution is none of those. */
static int is_new(double known[8][3], int count, const double q[3])
{
    for (int k = 0; k < count; k++)
        if (gap_between(known[k], q) < 0.001)
            return 0;
    return 1;
}

/* Puts a solution behind those that are known, unless it is one of them; returns how many there
 * are. */
static int keep(double known[8][3], int count, const double q[3])
{
    if (!is_new(known, count, q))
        return count;
    take(q, known[count]);
    return count + 1;
}

/* Whether the row of a root that is moved leads to a solution, and to which. */
static int leads(
    struct descent *d, const double *free_joints, const double seed[3], double angle, int row,
        double exact,
    double end[3])
{
    double q[4][3];
    unsigned char kind[4];
    for (int k = 0; k < 4; k++)
        kind[k] = NONE;
    solve(d->T, free_joints, seed, angle, &q[0][0], kind);
    if (kind[row] == NONE || kind[row] > CLOSE /* lost */)
        return 0;
    take(q[row], end);
    return solves(d, 72, exact, end);
}

/* How far roots are moved: where steps from a row lead nowhere, and to the other solution, as parts
 * of the way to the one that is known. */
static const double beside[18] = { 3.0517578125e-05, -3.0517578125e-05, 3.814697265625e-06,
    -3.814697265625e-06, 4.76837158203125e-07, -4.76837158203125e-07, 5.960464477539063e-08,
    -5.960464477539063e-08, 7.450580596923828e-09, -7.450580596923828e-09, 9.313225746154785e-10,
    -9.313225746154785e-10, 1.1641532182693481e-10, -1.1641532182693481e-10, 1.4551915228366852e-11,
    -1.4551915228366852e-11, 1.8189894035458565e-12, -1.8189894035458565e-12 };
static const double across[5] = { 0.0, -1.0, -2.0, -0.5, -4.0 };

/* Roots that nearly meet: a row of them may stand between two solutions that differ by anything in
 * a joint that is nearly free. Steps from it lead to one; the root of the other is as far from it
 * on the other side. A row may have taken the seed's value for its root, which is one of the two
 * and hides the middle: the roots' own rows have a seed that is turned away. */
static void both_sides(
const double T[16], const double *free_joints, const double seed[3], double q[4][3],
    unsigned char status[4])
{
    struct descent d = { .T = T };
    double known[8][3], own[4][3], away[3];
    unsigned char kind[4];
    int doubtful[4], any = 0, count = 0;
    const double exact = exactness(T);
    for (int row = 0; row < 4; row++) {
        any |= status[row] == CLOSE;
        kind[row] = NONE;
    }
    if (!any)
        return;
    any = 0;
    take(seed, away);
    away[0] += 2.0;
    solve(T, free_joints, away, 0.0, &own[0][0], kind);
    for (int row = 0; row < 4; row++) {
        const int close = status[row] == CLOSE;
        double here[3];
        if (kind[row] == NONE || kind[row] > CLOSE /* lost */)
            take(q[row], own[row]);
        take(own[row], here);
        doubtful[row] = close && !solves(&d, 0, exact, here);
        if (close)
            status[row] = OK;
        any += doubtful[row];
        if (status[row] == NONE || doubtful[row])
            continue;
        take(q[row], known[count]);
        count++;
    }
    if (!any)
        return;
    const int others = count;
    int next = count;
    for (int row = 0; row < 4; row++) {
        if (!doubtful[row])
            continue;
        double end[3], other[3], off = 0.0;
        take(q[row], end);
        /* long steps may lead to solutions of other roots, which are known */
        int found = solves(&d, 72, exact, end) && is_new(known, others, end);
        for (int k = 0; k < 18 && !found; k++)
            found = leads(&d, free_joints, away, beside[k], row, exact, end)
                && is_new(known, others, end);
        if (!found)
            continue;
        status[row] = NONE;
        count = keep(known, count, end);
        off += end[0] - own[row][0];
        off -= 6.283185307179586 * ceil(off / 6.283185307179586 - 0.5);
        for (int k = 0; k < 5; k++) {
            if (!leads(&d, free_joints, away, across[k] * off, row, exact, other)
                    || !is_new(known, others, other) || gap_between(end, other) < 0.001)
                continue;
            count = keep(known, count, other);
            break;
        }
    }
    for (; next < count; next++) { /* whichever roots rounding told apart: the row that was nearest
        */
        int place = -1;
        double least = HUGE_VAL;
        for (int row = 4 - 1; row >= 0; row--) {
            const double gap = isnan(q[row][0]) ? HUGE_VAL : gap_between(q[row], known[next]);
            if (status[row] == NONE && gap <= least) {
                least = gap;
                place = row;
            }
        }
        if (place < 0)
            break;
        take(known[next], q[place]);
        status[place] = OK;
    }
    for (int row = 0; row < 4; row++)
        for (int i = 0; i < 3 && status[row] == NONE; i++)
            q[row][i] = DHGEN_NAN;
}


/* Between which values starts lie. */
static const double span_low[3] = { -3.141592653589793, -3.141592653589793, -3.141592653589793 };
static const double span_width[3] = { 6.283185307179586, 6.283185307179586, 6.283185307179586 };

/* Start number k; number 0 is the seed. */
static void start_of(const struct descent *d, int k, double u[3])
{
    for (int j = 0; j < 3; j++)
        u[j] = k == 0 ? d->seed[j] : span_low[j] + span_width[j] * fmod(0.5 + k * stride[j], 1.0);
}

/* Takes u to where damped least squares lead; returns by how much that misses the pose. Near to it
 * less damping than usual leads further, where joints hardly move the tool: there a step that is
 * right may be long, and what it leaves, half of its square, far more than was missed. */
static double descend(struct descent *d, double u[3])
{
    double least = HUGE_VAL, little = 1e-13, best[3], step[3];
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    copy(u, best); /* compilers don't know that some miss is finite */
    for (int k = 0; k <= 40; k++) {
        look(d, u);
        const int slow = d->length >= fmax(0.5 * last, left);
        const int stalled = slow && least <= (little < 1e-13 ? 1e-10 : 1e-12);
        if (slow && least <= 1e-06)
            little = 1e-26;
        if (d->length < least) {
            least = d->length;
            copy(u, best);
        }
        if (stalled)
            break;
        damped_step(d, d->e, d->length, little, step);
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 3; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = little < 1e-13 ? 0.5 * way * way : 0.0;
    }
    copy(best, u);
    return least;
}

/* A pose was left without a row after a joint had been chosen: several joints may be free, and few
 * of their values serve. Steps from the seed and from evenly spread starts lead to some that do.
 * What is wrong with values: 1 is that they are beyond limits, 2 that they are not exact, 4 that
 * there are none. */
static void seek(
const double T[16], const double *free_joints, const double seed[3], int begun, double q[4][3],
    unsigned char status[4])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    double found[3] = { 0.0 };
    (void)free_joints;
    int before = 4, chosen = -1;
    for (int row = 4 - 1; row >= 0; row--) {
        int fault = 0, is_open = status[row] == FREE;
        if (status[row] == NONE)
            continue;
        before = fault < before ? fault : before;
        chosen = is_open ? row : chosen;
    }
    if (before == 0 || (before < 4 && chosen < 0))
        return;
    int least = before;
    take(seed, d.q);
    for (int j = 0; j < 3; j++)
        d.seed[j] = seed[solved[j]] / unit[j];
    for (int k = 0; k < 12 && least; k++) {
        double u[3], end[3];
        start_of(&d, k, u);
        if (descend(&d, u) > 0.01)
            continue;
        take(d.q, end);
        for (int j = 0; j < 3; j++)
            end[solved[j]] = unit[j] * u[j];
        const double miss = escaped(&d, exact, end);
        if (miss > 10.0 * exact)
            continue;
        const int fault = 2 * (miss > exact);
        if (fault >= least)
            continue;
        least = fault;
        take(end, found);
    }
    if (least == before)
        return;
    for (int row = 0; row < 4; row++) {
        status[row] = row == begun ? FREE : NONE;
        for (int i = 0; i < 3; i++)
            q[row][i] = row == begun ? found[i] : DHGEN_NAN;
    }
}


/* What follows where roots nearly meet, and where rows miss the pose. */
static void complete(
    const struct dhgen_arm *arm, const double *T, const double *free_joints, const double *seed,
    int begun, double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    both_sides(T, free_joints, seed, q, status);
    tighten(arm, T, q, status);
    if (begun >= 0)
        seek(T, free_joints, seed, begun, q, status);
}

static const int entries[3] = { 3, 7, 11 };
static const int choosable[2] = { 1, 0 };
static const struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 0.1818, 0.1818, 0.1818, 0.0, 0.0, 0.0 }, 0.18181818181818182, entries, 3,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* winds */
    1, /* follows seed */
    cuspidal_3r_fk, cuspidal_3r_jacobian, solve, complete, NULL,
};

int cuspidal_3r_ik(
    const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    return dhgen_careful_ik(&arm, T, NULL, q_seed, &q[0][0], status);
}

int cuspidal_3r_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    return dhgen_ik_nearest(&arm, T, NULL, q_seed, q);
}

void cuspidal_3r_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_ik_each(&arm, 0, n, T, NULL, q, status);
}
