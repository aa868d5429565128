/* rail_5dof: Arm with four revolute joints on a rail
 *
 * Inverse kinematics, generated from robots/rail_5dof.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/rail_5dof.yaml. The formulas and where they come from:
 * rail_5dof.md.
 */
#include "rail_5dof.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = RAIL_5DOF_OK, NONE = RAIL_5DOF_UNREACHABLE, FREE = RAIL_5DOF_FREE_JOINT,
    OUT = RAIL_5DOF_OUT_OF_LIMITS, INVALID = RAIL_5DOF_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
#define MISFIT(name, number) \
static inline number misfit_##name(const number T[16]) \
{ \
    const number x0 = T[0], x1 = T[1], x2 = T[2]; \
    const number y0 = T[4], y1 = T[5], y2 = T[6]; \
    const number xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0; \
    const number yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0; \
    const number xy = x0 * y0 + x1 * y1 + x2 * y2; \
    const number zx = x1 * y2 - x2 * y1 - T[8]; \
    const number zy = x2 * y0 - x0 * y2 - T[9]; \
    const number zz = x0 * y1 - x1 * y0 - T[10]; \
    return xx * xx + yy * yy + 2.0 * xy * xy + zx * zx + zy * zy + zz * zz; \
}
MISFIT(one, double)

#ifdef __GNUC__
#define HELPER __attribute__((unused)) static inline
#define APART __attribute__((noinline)) static
#define INLINED __attribute__((always_inline))
#else
#define HELPER static inline
#define APART static
#endif

#define maximum_double(a, b) ((a) > (b) ? (a) : (b))
#define minimum_double(a, b) ((a) < (b) ? (a) : (b))

#ifndef RAIL_5DOF_LIBM
/* atan r = r + r^3 (odd[0] + odd[1] r^2 + ...) for |r| up to tan(pi/8) */
static const double odd[11] = {
    -0.3333333333333333, 0.19999999999995513, -0.14285714284665177, 0.11111111015146682,
    -0.0909090457366891, 0.07692183087347286, -0.0666450998991572, 0.05858136252639731,
    -0.050853834915688644, 0.039229744582632814, -0.01917454359469326,
};

/* The angle of y and x, not both zero and not infinite, in [-pi, pi], within 3 ulp: the multiple of
 * pi/4 next to it and a ratio of at most tan(pi/8), then a polynomial in this. In two steps: of
 * several angles all ratios come first. `added` is x + y where m holds, else x: for one pose, which
 * waits for its values, so that the sum doesn't wait for m. */
#define added_four(x, m, y) pick_four(m, (x) + (y), x)
#define added_wide(x, m, y) ((x) + only_wide(m, 1.0) * (y))
#define ARCTANGENT(v) \
typedef struct { v r, known, y; } v##_ratio; \
HELPER v##_ratio ratio_##v(v y, v x) \
{ \
    const v ax = abs_##v(x), ay = abs_##v(y); \
    const v##_mask steep = ay > ax; \
    const v most = maximum_##v(ay, ax), least = minimum_##v(ax, ay); \
    const v##_mask turned = least > most * 0.41421356237309515; \
    const v ahead = all_##v(0.7853981633974483), half = all_##v(1.5707963267948966); \
    const v part = negated_##v(pick_##v(steep, -ahead, ahead), x); \
    const v whole = pick_##v(steep, half, half - 2.0 * part); \
    const v up = added_##v(least, turned, -most), down = added_##v(most, turned, least); \
    return (v##_ratio){ negated_##v(up, part) / down, added_##v(whole, turned, part), y }; \
} \
HELPER v angle_##v(v##_ratio of) \
{ \
    const v r = of.r, u = r * r, u2 = u * u, u4 = u2 * u2; \
    const v p0 = (odd[0] + odd[1] * u) + (odd[2] + odd[3] * u) * u2; \
    const v p4 = (odd[4] + odd[5] * u) + (odd[6] + odd[7] * u) * u2; \
    const v p8 = (odd[8] + odd[9] * u) + odd[10] * u2; \
    const v p = p0 + (p4 + p8 * u4) * u4; \
    return negated_##v((of.known + r) + r * u * p, of.y); \
} \
HELPER v atan2_##v(v y, v x) { return angle_##v(ratio_##v(y, x)); }
#endif

/* Lanes: GNU vectors where compiler and machine have them, plain doubles otherwise and with
 * -DRAIL_5DOF_SCALAR. With -DRAIL_5DOF_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(RAIL_5DOF_SCALAR) && !defined(RAIL_5DOF_LIBM)
#include <immintrin.h>
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define LANES 8
#define pick_wide(m, yes, no) _mm512_mask_blend_pd(_mm512_movepi64_mask((__m512i)(m)), no, yes)
#define maximum_wide _mm512_max_pd
#define minimum_wide _mm512_min_pd
#define sqrt_wide _mm512_sqrt_pd
#define bits_wide(m) ((unsigned)_mm512_movepi64_mask((__m512i)(m)))
#else
#define LANES 4
#define pick_wide pick_four
#define maximum_wide maximum_four
#define minimum_wide minimum_four
#define sqrt_wide sqrt_four
#define bits_wide bits_four
#endif
#define pick_four(m, yes, no) _mm256_blendv_pd(no, yes, (__m256d)(m))
#define maximum_four _mm256_max_pd
#define minimum_four _mm256_min_pd
#define sqrt_four _mm256_sqrt_pd
#define bits_four(m) ((unsigned)_mm256_movemask_pd((__m256d)(m)))
#define where_four(truth) ((four_mask)_mm256_set1_epi64x(-(long long)(truth)))
#define shuffle __builtin_shufflevector
#define where_all(mask) (mask)

#define VECTOR(v, lanes) \
typedef double v __attribute__((vector_size(8 * lanes))); \
typedef v v##_at __attribute__((aligned(8), may_alias)); /* in memory */ \
typedef __typeof__((v){ 0 } < (v){ 0 }) v##_mask; \
HELPER v all_##v(double x) { return x - (v){ 0 }; } \
HELPER v only_##v(v##_mask m, double x) { return (v)(m & (v##_mask)all_##v(x)); } \
HELPER v copysign_##v(v x, v y) \
{ \
    const v##_mask sign = (v##_mask)all_##v(-0.0); \
    return (v)((sign & (v##_mask)y) | (~sign & (v##_mask)x)); \
} \
HELPER v signed_##v(double x, v y) { return copysign_##v(all_##v(x), y); } \
HELPER v negated_##v(v x, v where) { return (v)((v##_mask)x ^ (v##_mask)signed_##v(0.0, where)); } \
HELPER v abs_##v(v x) { return copysign_##v(x, all_##v(0.0)); }

VECTOR(four, 4)
VECTOR(wide, LANES)
ARCTANGENT(four)
#else
#define LANES 1
typedef double wide;
typedef int wide_mask;
#define all_wide(x) (x)
#define where_all(truth) (-(truth))
#define pick_wide(m, yes, no) ((m) ? (yes) : (no))
#define only_wide(m, x) ((m) ? (x) : 0.0)
#define copysign_wide copysign
#define signed_wide copysign
#define negated_wide(x, where) ((x) * copysign(1.0, where))
#define abs_wide fabs
#define sqrt_wide sqrt
#define maximum_wide maximum_double
#define minimum_wide minimum_double
#endif
#ifdef RAIL_5DOF_LIBM /* half the time of atan2 */
HELPER double atan2_wide(double y, double x)
{
    return atan(y / x) + copysign(1.5707963267948966 - copysign(1.5707963267948966, x), y);
}
#else
ARCTANGENT(wide)
#endif

MISFIT(wide, wide)

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16])
{
    const wide w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0;
    return misfit_wide(T) + w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3 + 0.0 * (T[3] * T[3] * T[3] + T[7]
        * T[7] * T[7] + T[11] * T[11] * T[11]);
}

#if LANES > 1
/* Writes joint values of four rows. */
HELPER void store_4(
    double *r0, double *r1, double *r2, double *r3, four a, four b, four c, four d)
{
    const four ab0 = shuffle(a, b, 0, 4, 2, 6), ab1 = shuffle(a, b, 1, 5, 3, 7);
    const four cd0 = shuffle(c, d, 0, 4, 2, 6), cd1 = shuffle(c, d, 1, 5, 3, 7);
    *(four_at *)r0 = shuffle(ab0, cd0, 0, 1, 4, 5);
    *(four_at *)r1 = shuffle(ab1, cd1, 0, 1, 4, 5);
    *(four_at *)r2 = shuffle(ab0, cd0, 2, 3, 6, 7);
    *(four_at *)r3 = shuffle(ab1, cd1, 2, 3, 6, 7);
}

HELPER void store_1(double *r0, double *r1, double *r2, double *r3, four a)
{
    *r0 = a[0];
    *r1 = a[1];
    *r2 = a[2];
    *r3 = a[3];
}

HELPER four irregularity_four(const double T[16])
{
    const four x = *(const four_at *)T, y = *(const four_at *)(T + 4),
        z = *(const four_at *)(T + 8), x1 = shuffle(x, x, 1, 2, 0, 3),
        y1 = shuffle(y, y, 1, 2, 0, 3), z1 = shuffle(z, z, 1, 2, 0, 3),
        x2 = shuffle(x, x, 2, 0, 1, 3), y2 = shuffle(y, y, 2, 0, 1, 3),
        lengths = x * x + y * y + z * z - 1.0, angles = x * x1 + y * y1 + z * z1,
        mirror = x1 * y2 - x2 * y1 - z,
        last = *(const four_at *)(T + 12) - (four){ 0.0, 0.0, 0.0, 1.0 };
    return (lengths * lengths + 2.0 * angles * angles + mirror * mirror) * (four){ 1.0, 1.0, 1.0,
        0.0 } + last * last;
}

/* Rows to columns. */
HELPER void transpose(wide x[LANES])
{
#if LANES == 8
    wide y[8];
    for (int k = 0; k < 8; k += 2) {
        y[k] = shuffle(x[k], x[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        y[k + 1] = shuffle(x[k], x[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int i = 0; i < 4; i++) {
        const int k = i + (i & 2); /* 0, 1, 4, 5 */
        x[k] = shuffle(y[k], y[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        x[k + 2] = shuffle(y[k], y[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
    for (int k = 0; k < 4; k++) {
        y[k] = x[k];
        x[k] = shuffle(y[k], x[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        x[k + 4] = shuffle(y[k], x[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
#else
    double y[16];
    store_4(y, y + 4, y + 8, y + 12, x[0], x[1], x[2], x[3]);
    for (int k = 0; k < 4; k++)
        x[k] = *(const wide_at *)(y + 4 * k);
#endif
}
#endif


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))

/* By how much joint values miss the entries that count: the root of the sum of squares. */
static double missed_by(const double *pose, const double *q)
{
    static const int named[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
    double reached[16], sum = 0.0;
    rail_5dof_fk(q, reached);
    for (int k = 0; k < 9; k++) {
        const int i = named[k];
        const double off = (reached[i] - pose[i]) * (i % 4 == 3 ? 0.16666666666666666 : 1.0);
        sum += off * off;
    }
    return sqrt(sum);
}

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[5] = { 0, 1, 2, 3, 4 };
static const int turning[5] = { 0, 1, 1, 1, 1 };
static const double unit[5] = { 6.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[5] = {
    1.0, 0.16666666666666666, 0.16666666666666666, 0.16666666666666666, 0.16666666666666666,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct descent {
    const double *T;
    double q[5], seed[5]; /* all joint values; the seed in units */
    double e[6], length; /* the miss [arm sizes, rad], and its length */
    double A[6][5]; /* how u moves the tool */
};

/* The rotation vector of an axis times the sine, and the cosine. */
static void turn_vector(const double axis[3], double cosine, double vector[3])
{
    const double sine = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double scale = sine < 1e-09 ? 1.0 : atan2(sine, cosine) / sine;
    const int opposite = sine < 1e-09 && cosine < 0.0; /* any axis will do */
    vector[0] = opposite ? 1.5079644737231006 : scale * axis[0];
    vector[1] = opposite ? 1.8849555921538759 : scale * axis[1];
    vector[2] = opposite ? 2.0106192982974678 : scale * axis[2];
}

/* By how much u misses the pose, and the analytic Jacobian of that. */
static void look(struct descent *d, const double u[5])
{
    double P[16], J[30], square = 0.0;
    for (int j = 0; j < 5; j++)
        d->q[solved[j]] = unit[j] * u[j];
    rail_5dof_fk(d->q, P);
    rail_5dof_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 6.0;
        for (int j = 0; j < 5; j++)
            d->A[i][j] = measure[j] * J[5 * row + solved[j]];
    }
    double R[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[i][j] = d->T[4 * i] * P[4 * j] + d->T[4 * i + 1] * P[4 * j + 1]
                + d->T[4 * i + 2] * P[4 * j + 2];
    const double axis[3] = { 0.5 * (R[2][1] - R[1][2]), 0.5 * (R[0][2] - R[2][0]),
        0.5 * (R[1][0] - R[0][1]) };
    turn_vector(axis, 0.5 * (R[0][0] + R[1][1] + R[2][2] - 1.0), d->e + 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 5; j++)
            d->A[3 + i][j] = J[5 * (3 + i) + solved[j]];
    for (int i = 0; i < 6; i++)
        square += d->e[i] * d->e[i];
    d->length = sqrt(square);
}

/* What is added from start to start, in parts of the range: a direction that is like no other. */
static const double stride[5] = {
    0.8812714616335696, 0.7766393890897682, 0.6844301295853426, 0.6031687406857283,
    0.5315553977157914,
};

static void copy(const double from[5], double to[5])
{
    for (int j = 0; j < 5; j++)
        to[j] = from[j];
}

/* Moves angles by whole turns to (-pi, pi]. */
static void wrap_angles(double u[5])
{
    for (int j = 0; j < 5; j++)
        if (turning[j])
            u[j] -= 6.283185307179586 * ceil(u[j] / 6.283185307179586 - 0.5);
}

/* Makes a step no longer than it may be. */
static void shorten(double step[5])
{
    double longest = 2.0;
    for (int j = 0; j < 5; j++)
        longest = fmax(longest, fabs(step[j]));
    for (int j = 0; j < 5; j++)
        step[j] *= 2.0 / longest;
}

/* The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping. The rows of
 * A, each with its share of the damping's root behind it, are made orthonormal one after another
 * (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994):
 * A A' would lose half of the digits. */
static void damped_step(
    const struct descent *d, const double e[6], double length, double little,
    double step[5])
{
    const double damping = 0.1 * fmin(length * length, 1.0) + little;
    double rows[6][11], y[6], sum[11] = { 0.0 };
    for (int i = 0; i < 6; i++) {
        double square = 0.0;
        for (int j = 0; j < 11; j++)
            rows[i][j] = j < 5 ? d->A[i][j] : j == 5 + i ? sqrt(damping) : 0.0;
        y[i] = e[i];
        for (int k = 0; k < i; k++) {
            double along = 0.0;
            for (int j = 0; j < 11; j++)
                along += rows[k][j] * rows[i][j];
            for (int j = 0; j < 11; j++)
                rows[i][j] -= along * rows[k][j];
            y[i] -= along * y[k];
        }
        for (int j = 0; j < 11; j++)
            square += rows[i][j] * rows[i][j];
        const double inverse = 1.0 / sqrt(square);
        y[i] *= inverse;
        for (int j = 0; j < 11; j++)
            rows[i][j] *= inverse;
    }
    for (int i = 6 - 1; i >= 0; i--) {
        double missing = y[i];
        for (int j = 0; j < 11; j++)
            missing -= rows[i][j] * sum[j];
        for (int j = 0; j < 11; j++)
            sum[j] += missing * rows[i][j];
    }
    for (int j = 0; j < 5; j++)
        step[j] = sum[j];
}

/* Takes a row as far as steps help, and tells how long another one would be; returns by how much
 * the row misses the pose then. Beside a singular place a step that is right may be long, and what
 * it leaves, half of its square, far more than was missed. */
static double descended(struct descent *d, int steps, double exact, double q[5], double *ahead)
{
    double u[5], best[5], step[5], least = HUGE_VAL;
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    for (int i = 0; i < 5; i++)
        d->q[i] = q[i];
    for (int j = 0; j < 5; j++)
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
            for (int j = 0; j < 5; j++)
                *ahead = fmax(*ahead, fabs(step[j]));
        }
        if (slow || (least <= 0.001 * exact && *ahead <= 0.0001))
            break;
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 5; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = 0.5 * way * way;
    }
    wrap_angles(best);
    for (int j = 0; j < 5; j++)
        q[solved[j]] = unit[j] * best[j];
    return least;
}

/* Takes a row to where damped least squares lead, unless it is exact or can't be; returns by how
 * much it misses the pose then, `first` being what it misses before. */
static double tightened(struct descent *d, double exact, double first, double q[5], int *moved)
{
    double end[5];
    if (first <= exact)
        return first;
    for (int i = 0; i < 5; i++)
        end[i] = q[i];
    double ahead;
    const double least = descended(d, 72, exact, end, &ahead);
    if (least > exact) /* the pose is rounded, or this is no solution */
        return first;
    for (int i = 0; i < 5; i++) {
        *moved = *moved || q[i] < end[i] || q[i] > end[i];
        q[i] = end[i];
    }
    return least;
}

/* By how much the joint values of two rows differ at most. */
static double gap_between(const double q[5], const double other[5])
{
    double gap[5], widest = 0.0;
    for (int j = 0; j < 5; j++)
        gap[j] = (q[solved[j]] - other[solved[j]]) / unit[j];
    wrap_angles(gap);
    for (int j = 0; j < 5; j++)
        widest = fmax(widest, fabs(gap[j]));
    return widest;
}

/* Whether a row that was moved came to lie on one that missed by less at first. */
static int repeats(double q[2][5], const double first[2], int row)
{
    for (int k = 0; k < 2; k++)
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
        distance = fmax(distance, fabs(T[4 * coordinate[i] + 3]) / 6.0);
    return 1e-12 * distance;
}

/* Tightens the rows; ends those that do not fit, and all but one of those that have become the
 * same. Where one is exact the pose has not been rounded: then all have to be exact. */
static void tighten(const double T[16], double q[2][5], unsigned char status[2])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    int moved[2] = { 0 };
    double first[2], miss[2];
    for (int row = 0; row < 2; row++) {
        first[row] = miss[row] = HUGE_VAL;
        if (status[row] == NONE)
            continue;
        first[row] = missed_by(T, q[row]);
        miss[row] = tightened(&d, exact, first[row], q[row], &moved[row]);
    }
    double least = HUGE_VAL;
    for (int row = 0; row < 2; row++)
        least = fmin(least, miss[row]);
    const double enough = least <= exact ? exact : 1e-05;
    for (int row = 0; row < 2; row++)
        if (miss[row] > enough)
            q[row][0] = NAN;
    for (int row = 0; row < 2; row++) {
        if (!isnan(q[row][0]) && !(moved[row] && repeats(q, first, row)))
            continue;
        status[row] = NONE;
        for (int i = 0; i < 5; i++)
            q[row][i] = NAN;
    }
}

static const double
    a1 = 2.0, /* link length 2 [m] */
    d3 = 1.0, /* joint offset 3 [m] */
    d5 = 3.0, /* joint offset 5 [m] */
    free_limit_squared2 = 3.6e-23, /* square of a length that fixes no angle [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    doubtful_slack = 0.01, /* a row may miss the pose by this before it is tightened */
    doubtful_slack1 = 0.06, /* a row may miss the pose by this before it is tightened [m] */
    m1 = 1.296e-13, /* doubt_limit_squared2^2 [m^4] */
    m2 = 9.999999999999999e-09, /* doubt_limit^2 */
    m4 = 9.999999999999997e-17, /* doubt_limit_squared^2 */
    m5 = 3.6000000000000004e-23, /* exact_slack1^2 [m^2] */
    m6 = 1e-24; /* exact_slack^2 */

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const rail_5dof_branches[2] = {
    "noflip", "flip",
};

static const double lowest[5] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[5] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[5] = { 0, 1, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[5] = { 0.027777777777777776, 1.0, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 6e-09) /* of limits */

void rail_5dof_fk(const double q[5], double T[16])
{
    const double c2 = cos(q[1]), s2 = sin(q[1]);
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = c2 * c3, x3_y = s2 * c3, z4_x = c2 * s3,
        z4_y = s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + s2 * s4,
        x4_y = x3_y * c4 - c2 * s4, x4_z = s3 * c4, y4_x = s2 * c4 - x3_x * s4,
        v1 = c2 * c4 + x3_y * s4, v2 = s3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x4_x * c5 - z4_x * s5; T[1] = -(z4_x * c5 + x4_x * s5); T[2] = y4_x;
    T[3] = a1 + s2 * d3 + y4_x * d5;
    T[4] = x4_y * c5 - z4_y * s5; T[5] = -(z4_y * c5 + x4_y * s5); T[6] = -v1;
    T[7] = -(c2 * d3 + v1 * d5);
    T[8] = x4_z * c5 + c3 * s5; T[9] = c3 * c5 - x4_z * s5; T[10] = -v2; T[11] = q[0] - v2 * d5;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void rail_5dof_jacobian(const double q[5], double J[30])
{
    const double c2 = cos(q[1]), s2 = sin(q[1]), p3_x = a1 + s2 * d3, v1 = c2 * d3;
    const double c3 = cos(q[2]), s3 = sin(q[2]), z4_x = c2 * s3, z4_y = s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), y4_x = s2 * c4 - c2 * c3 * s4,
        v2 = c2 * c4 + s2 * c3 * s4, v3 = s3 * s4, p5_x = p3_x + y4_x * d5, J12 = v1 + v2 * d5,
        v4 = q[0] - v3 * d5 - q[0], v5 = p5_x - p3_x, v6 = v1 - J12;
    J[0] = 0.0; J[1] = J12; J[2] = -(c2 * v4); J[3] = z4_y * v4 + c3 * v6; J[4] = 0.0;
    J[5] = 0.0; J[6] = p5_x - a1; J[7] = -(s2 * v4); J[8] = -(c3 * v5 + z4_x * v4); J[9] = 0.0;
    J[10] = 1.0; J[11] = 0.0; J[12] = s2 * v6 + c2 * v5; J[13] = z4_x * v6 - z4_y * v5; J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = s2; J[18] = z4_x; J[19] = y4_x;
    J[20] = 0.0; J[21] = 0.0; J[22] = -c2; J[23] = z4_y; J[24] = -v2;
    J[25] = 0.0; J[26] = 1.0; J[27] = 0.0; J[28] = -c3; J[29] = -v3;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(double T[16])
{
    double G[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[i][j] = (i == j ? 1.5 : 0.0)
                - 0.5 * (T[i] * T[j] + T[4 + i] * T[4 + j] + T[8 + i] * T[8 + j]);
    for (double *row = T; row < T + 12; row += 4) {
        const double x = row[0], y = row[1], z = row[2];
        for (int j = 0; j < 3; j++)
            row[j] = x * G[0][j] + y * G[1][j] + z * G[2][j];
    }
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose, and 2 for what was rounded. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3] * T[3] * T[3]) && isfinite(T[7] * T[7] * T[7]) && isfinite(T[11] * T[11] *
        T[11])))
        return 0;
    if (!(fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1.0) <= 1e-09))
        return 0;
    const double miss = misfit_one(T);
    if (!(miss <= 1e-09))
        return 0;
    if (miss <= 1e-24)
        return 1;
    straighten(T);
    straighten(T);
    return 2;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[10], wide_mask kind[2])
{
    ENTRIES(wide);

    /* r1 */
    const wide q1_p = T34 - d5 * T33;

    /* theta2 */
    const wide wy = T24 - d5 * T23, v1 = T14 - d5 * T13 - a1, s2 = d3 * v1, C2 = d3 * wy,
        v2 = s2 * s2 + C2 * C2, v3 = sqrt_wide(v2) * (1.0 / v2), angle1 = atan2_wide(v1, -wy);

    /* theta3 */
    const wide X3 = T23 * s2 - T13 * C2, v4 = T33 * T33 + v3 * (X3 * (v3 * X3)), w3 = sqrt_wide(v4),
        v5 = 1.0 / v4, factor3 = w3 * v5, v6 = X3 * factor3, v7 = T33 * factor3, v8 = v3 * v6,
        angle2 = atan2_wide(-v7, -v8);

    /* theta4 */
    const wide v9 = T23 * C2 + T13 * s2, v10 = v4 + v3 * (v9 * (v3 * v9)),
        v11 = sqrt_wide(v10) * (1.0 / v10), c4 = v9 * v11, s4 = w3 * v11,
        angle3 = atan2_wide(s4, v3 * c4);

    /* theta5 */
    const wide C5 = w3 * (v5 * (X3 * T32 - T33 * (s2 * T22 - C2 * T12))), v12 = s2 * T21 - C2 * T11,
        S5 = w3 * (v5 * (X3 * T31 - T33 * v12)), v13 = v3 * (S5 * (v3 * S5) + C5 * (v3 * C5)),
        v14 = sqrt_wide(v13) * (1.0 / v13), v15 = C5 * v14, v16 = S5 * v14,
        angle4 = atan2_wide(-v16, -v15);

    /* is the pose one that the arm can take? */
    const wide v17 = v7 * s4, v18 = v6 * s4, v19 = T14 - a1, v20 = T34 - q1_p - d5 * v17,
        v21 = T33 - v17, v22 = v3 * v15, v23 = T31 - v3 * (v22 * (v7 * c4) + v8 * v16),
        v24 = d3 + v3 * (d5 * c4) - v3 * (T24 * C2 + s2 * v19), v25 = v3 * (c4 - v9),
        v26 = v3 * (C2 * T21 + s2 * T11 + s4 * v15), v27 = v3 * (T24 * s2 - C2 * v19 - d5 * v18),
        v28 = v3 * (v12 - (v22 * (v8 * c4) - v7 * v16)), v29 = v3 * (X3 - v18);

    q[0] = q1_p; q[1] = angle1; q[2] = angle2; q[3] = angle3; q[4] = angle4;
    kind[0] = kind_of(q[0], 0);
    q[5] = q1_p; q[6] = angle1; q[7] = angle2 - signed_wide(half_turn, -v7); q[8] = -angle3;
    q[9] = angle4 - signed_wide(half_turn, -v16);
    kind[1] = kind_of(q[5], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v4 <= m2) | (v2 <= m1) | (v10 <= m4) | (v13 <= m4) | (m6 < v21 * v21 +
        v23 * v23 + v25 * v25 + v26 * v26 + v28 * v28 + v29 * v29) | (m5 < v20 * v20 + v24 * v24 +
        v27 * v27));
}

#if LANES > 1
static const double
    m3 = 0.5; /* 1 / 2 */
/* One regular pose, 1 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[2][5], unsigned char status[2])
{
    const four e1 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* r1 */
    const double q1 = T34 - d5 * T33;

    /* theta2 */
    const double wy = T24 - d5 * T23, v1 = T14 - d5 * T13 - a1, s2 = d3 * v1, C2 = d3 * wy,
        v2 = s2 * s2 + C2 * C2, v3 = sqrt(v2) * (1.0 / v2);

    /* theta3 */
    const double X3 = T23 * s2 - T13 * C2, v4 = T33 * T33 + v3 * (X3 * (v3 * X3)), w3 = sqrt(v4),
        v5 = 1.0 / v4, factor3 = w3 * v5, v6 = X3 * factor3, v7 = T33 * factor3, v8 = v3 * v6,
        v9 = copysign(half_turn, -v7);
    const four v10 = m3 * (e1 - 1.0);

    /* theta4 */
    const double v11 = T23 * C2 + T13 * s2, v12 = v4 + v3 * (v11 * (v3 * v11)),
        v13 = sqrt(v12) * (1.0 / v12), c4 = v11 * v13, s4 = w3 * v13;

    /* theta5 */
    const double C5 = w3 * (v5 * (X3 * T32 - T33 * (s2 * T22 - C2 * T12))),
        v14 = s2 * T21 - C2 * T11, S5 = w3 * (v5 * (X3 * T31 - T33 * v14)),
        v15 = v3 * (S5 * (v3 * S5) + C5 * (v3 * C5)), v16 = sqrt(v15) * (1.0 / v15), v17 = C5 * v16,
        v18 = S5 * v16, v19 = copysign(half_turn, -v18);

    /* is the pose one that the arm can take? */
    const double v20 = v7 * s4, v21 = v6 * s4, v22 = T14 - a1, v23 = T34 - q1 - d5 * v20,
        v24 = T33 - v20, v25 = v3 * v17, v26 = T31 - v3 * (v25 * (v7 * c4) + v8 * v18),
        v27 = d3 + v3 * (d5 * c4) - v3 * (T24 * C2 + s2 * v22), v28 = v3 * (c4 - v11),
        v29 = v3 * (C2 * T21 + s2 * T11 + s4 * v17), v30 = v3 * (T24 * s2 - C2 * v22 - d5 * v21),
        v31 = v3 * (v14 - (v25 * (v8 * c4) - v7 * v18)), v32 = v3 * (X3 - v21);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0)) | (unsigned)((v4 <= m2) | (v2 <= m1) |
        (v12 <= m4) | (v15 <= m4) | (m6 < v24 * v24 + v26 * v26 + v28 * v28 + v29 * v29 + v31 * v31
        + v32 * v32) | (m5 < v23 * v23 + v27 * v27 + v30 * v30)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ v1, -v7, s4, -v18 }, (four){ -wy, -v8, v3 * c4,
        -v17 });
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = shuffle(packed1, packed1, 2, 2, 2, 2),
        angle4 = shuffle(packed1, packed1, 3, 3, 3, 3);
    const four q3 = angle2 + v9 * v10, q5 = angle4 + v10 * v19, q4 = e1 * angle3;

    store_4(&q[0][0], &q[1][0], &q[0][0], &q[1][0], all_four(q1), angle1, q3, q4);
    store_1(&q[0][4], &q[1][4], &q[0][4], &q[1][4], q5);
    const unsigned long long none1 = (bits_four(all_four(q1) != all_four(q1)) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[10], x[LANES];
    wide_mask kind[2];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 10; i += LANES) {
        const int from = i + LANES <= 10 ? i : 10 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 10 * k + from) = x[k];
    }
    for (int i = 1; i < 2; i++)
        kind[0] |= kind[i] << 8 * i;
    for (int k = 0; k < LANES; k++) {
        const long long word = kind[0][k];
        __builtin_memcpy(status + 2 * k, &word, 2);
    }
    return bits_wide(left);
}
#else
HELPER int solve_regular(const double T[16], double q[2][5], unsigned char status[2])
{
    wide_mask kind[2];
    int count = 0;
    if (solve_wide(T, &q[0][0], kind))
        return -1;
    for (int row = 0; row < 2; row++) {
        status[row] = (unsigned char)kind[row];
        count += kind[row] == 0;
    }
    return count;
}
#endif

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[5], double q[2][5], unsigned char status[2])
{
    ENTRIES(double);

    /* r1, type 1: U0 A5^-1 [3, 4] */
    const double wz = T34 - T33 * d5;

    /* theta2, type 3: U0 A5^-1 [1, 4] and U0 A5^-1 [2, 4] */
    const double wx = T14 - d5 * T13;
    const double wy = T24 - d5 * T23;
    const double v1 = d3 * (wx - a1);
    const double C2 = d3 * wy;
    const double w2 = sqrt(v1 * v1 + C2 * C2);
    const int free2 = w2 <= free_limit_squared2;
    const double v2 = 1.0 / (free2 ? 1.0 : w2);
    const double c2 = free2 ? cos(seed[1]) : -(C2 * v2), s2 = free2 ? sin(seed[1]) : v1 * v2;
    const double q2 = atan2(s2, c2);

    /* theta3, type 2: U3[2, 3] */
    const double X3 = T13 * c2 + T23 * s2;
    const double w3 = sqrt(X3 * X3 + T33 * T33);
    const int free3 = w3 <= free_limit;
    const double divisor3 = free3 ? 1.0 : w3;

    /* theta4, type 3: U3[3, 3] and U3[1, 3] */
    const double Z1_4 = T23 * c2 - T13 * s2;
    const double v3 = Z1_4 * Z1_4;

    /* theta5, type 3: U3[2, 2] and U3[2, 1] */
    const double v5 = T12 * c2 + T22 * s2, v6 = T11 * c2 + T21 * s2;

    /* is the pose one that the arm can take? */
    const double v9 = T34 - wz, v11 = T14 - a1, v12 = c2 * v11 + T24 * s2,
        v13 = T21 * c2 - T11 * s2, v14 = T24 * c2 - s2 * v11;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip, flip */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e1 < 0.0 && free3) continue; /* both signs give the same */
        const double factor3 = e1 / divisor3;
        const double c3 = free3 ? cos(seed[2]) : -(X3 * factor3),
            s3 = free3 ? sin(seed[2]) : -(T33 * factor3);
        const double q3 = atan2(s3, c3);
        const double root3 = w3 * e1;

        /* theta4 */
        const double w4 = sqrt(root3 * root3 + v3);
        const int free4 = w4 <= free_limit_squared;
        const double v4 = 1.0 / (free4 ? 1.0 : w4);
        const double c4 = free4 ? cos(seed[3]) : -(Z1_4 * v4),
            s4 = free4 ? sin(seed[3]) : root3 * v4;
        const double q4 = atan2(s4, c4);

        /* theta5 */
        const double C5 = s3 * v5 - T32 * c3;
        const double S5 = s3 * v6 - T31 * c3;
        const double w5 = sqrt(S5 * S5 + C5 * C5);
        const int free5 = w5 <= free_limit_squared;
        const double v7 = 1.0 / (free5 ? 1.0 : w5);
        const double c5 = free5 ? cos(seed[4]) : -(C5 * v7), s5 = free5 ? sin(seed[4]) : -(S5 * v7);
        const double q5 = atan2(s5, c5);

        /* is the pose one that the arm can take? */
        const double v8 = s3 * s4, v10 = c3 * s4;
        if (!(fabs(v9 + d5 * v8) <= doubtful_slack1 && fabs(T33 + v8) <= doubtful_slack && fabs(T31
            - (c5 * (s3 * c4) + c3 * s5)) <= doubtful_slack && fabs(v14 + (d3 + d5 * c4)) <=
            doubtful_slack1 && fabs(Z1_4 + c4) <= doubtful_slack && fabs(v13 + s4 * c5) <=
            doubtful_slack && fabs(v12 + d5 * v10) <= doubtful_slack1 && fabs(v6 - (c5 * (c3 * c4) -
            s3 * s5)) <= doubtful_slack && fabs(X3 + v10) <= doubtful_slack))
            continue; /* the arm can't take this pose */
        const int row = i1;
        q[row][0] = wz; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        status[row] = (free2 || free3 || free4 || free5) ? FREE : OK;
    }
}

static void take(const double from[5], double to[5])
{
    for (int i = 0; i < 5; i++)
        to[i] = from[i];
}

/* Between which values starts lie. */
static const double span_low[5] = {
    -1.0, -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
};
static const double span_width[5] = {
    2.0, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
};

/* Start number k; number 0 is the seed. */
static void start_of(const struct descent *d, int k, double u[5])
{
    for (int j = 0; j < 5; j++)
        u[j] = k == 0 ? d->seed[j] : span_low[j] + span_width[j] * fmod(0.5 + k * stride[j], 1.0);
}

/* Takes u to where damped least squares lead; returns by how much that misses the pose. Near to it
 * less damping than usual leads further, where joints hardly move the tool: there a step that is
 * right may be long, and what it leaves, half of its square, far more than was missed. */
static double descend(struct descent *d, double u[5])
{
    double least = HUGE_VAL, little = 1e-13, best[5], step[5];
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
        for (int j = 0; j < 5; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = little < 1e-13 ? 0.5 * way * way : 0.0;
    }
    copy(best, u);
    return least;
}

/* A pose was left without a row after a joint had been chosen, or with such as fit it if it is
 * rounded: several joints may be free, and few of their values serve. Steps
 * from the seed and from evenly spread starts lead to some that do. What is wrong with values: 1 is
 * that they are beyond limits, 2 that they are not exact, 4 that there are none. */
static void seek(
    const double T[16], const double seed[5], int begun, double q[2][5],
    unsigned char status[2])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    double found[5] = { 0.0 };
    int before = 4, chosen = -1;
    for (int row = 2 - 1; row >= 0; row--) {
        int fault = 0, is_open = status[row] == FREE;
        if (status[row] == NONE)
            continue;
        double here[5], ahead;
        take(q[row], here);
        fault += 2 * (descended(&d, 0, exact, here, &ahead) > exact);
        is_open |= ahead > 0.0001; /* a joint is nearly free */
        before = fault < before ? fault : before;
        chosen = is_open ? row : chosen;
    }
    if (before == 0 || (before < 4 && chosen < 0))
        return;
    int least = before;
    take(seed, d.q);
    for (int j = 0; j < 5; j++)
        d.seed[j] = seed[solved[j]] / unit[j];
    for (int k = 0; k < 12 && least; k++) {
        double u[5], end[5], ahead;
        start_of(&d, k, u);
        if (descend(&d, u) > 1e-05)
            continue;
        take(d.q, end);
        for (int j = 0; j < 5; j++)
            end[solved[j]] = unit[j] * u[j];
        const double miss = descended(&d, 72, exact, end, &ahead);
        if (miss > 1e-05)
            continue;
        const int fault = 2 * (miss > exact);
        if (fault >= least)
            continue;
        least = fault;
        take(end, found);
    }
    if (least == before)
        return;
    for (int row = 0; row < 2; row++) {
        status[row] = row == begun ? FREE : NONE;
        for (int i = 0; i < 5; i++)
            q[row][i] = row == begun ? found[i] : (double)NAN;
    }
}


/* A joint value moved by whole turns, near to another but inside its limits. */
static double turned(int joint, double given, double towards)
{
    const double low = lowest[joint] - 1e-09, high = highest[joint] + 1e-09;
    if (!revolute[joint])
        return given;
    double value = given;
    if (fabs(towards) < 100000.0)
        value += turn * floor((towards - given) / turn + 0.5);
    value -= turn * ceil(fmax(value - high, 0.0) / turn);
    value += turn * ceil(fmax(low - value, 0.0) / turn);
    return value <= high ? value : given;
}

/* How far joint values are from others, whole turns aside [rad, arm sizes]; half is the middle. */
static double half_way(const double x[5], const double q[5], double half[5])
{
    double most = 0.0;
    for (int i = 0; i < 5; i++) {
        double off = q[i] - x[i];
        off -= revolute[i] ? turn * floor(off / turn + 0.5) : 0.0;
        most = fmax(most, fabs(off) * sqrt(weight[i]));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.1667, 0.1667, 0.1667, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[5] = { 6.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[5], double e[6])
{
    double P[16], square = 0.0;
    rail_5dof_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    for (int i = 0; i < 9; i++) {
        const int j = (i / 3 + 1) % 3 * 4 + i % 3, k = (i / 3 + 2) % 3 * 4 + i % 3;
        e[3 + i / 3] += 0.5 * (P[j] * T[k] - P[k] * T[j]);
        square += 0.5 * (P[j] - T[j]) * (P[j] - T[j]);
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[5], double damping, double e[6], double x[5])
{
    double A[6][11] = { { 0.0 } }, square[6] = { 0.0 }, J[30];
    rail_5dof_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 5; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[5 * i + j];
        A[i][5 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 11; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 11; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 11; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 5; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[5])
{
    double x[5], half[5], e[6], last = HUGE_VAL;
    int settled = 0, lost = 0, held[5] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e);
        if (miss < enough) {
            take(x, q);
            settled = 1;
            enough = 0.5 * miss;
        } else if (settled || (miss > fmax(0.7 * last, 100.0 * enough) && ++lost == 4)) {
            break;
        }
        last = miss;
        add_step(held, (lost == 0 && miss > 100.0 * enough ? 0.003 : 0.1 * miss) * miss, e, x);
        if (!(half_way(x, q, half) <= most))
            break; /* another solution */
    }
    return settled;
}

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const double T[16], const double seed[5], double q[2][5],
    unsigned char status[2])
{
    double x[5], half[5], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    take(seed, x);
    if (!settle(T, 1e-12, 0.15, x))
        return;
    for (int row = 2 - 1; row >= 0; row--) {
        double between = 1e-06;
        if (status[row] != NONE) {
            const double off = half_way(x, q[row], half);
            between = fmax(off_pose(T, half, e), 1e-12);
            if (off < nearest) {
                nearest = off;
                place = row;
                least = -1.0; /* its own */
            }
        }
        if (between <= 2.0 * least)
            place = row;
        least = fmin(least, between);
    }
    if (least >= 0.0)
        status[place] = FREE;
    if (nearest > 1e-06)
        take(x, q[place]);
}

/* A pose that is rounded, singular or none; regular ones need no stack for it. */
APART int ik_carefully(
    const double T[16], const double *q_seed, double q[2][5], unsigned char status[2])
{
    const double zeros[5] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 5; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    if (valid == 2 && (count = solve_regular(pose, q, status)) >= 0)
        return count;
    count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 5; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    int begun = 0; /* the first row that was not out of reach: here equations may have ended all */
    for (int row = 2 - 1; row >= 0; row--)
        begun = status[row] == NONE ? begun : row;
    tighten(pose, q, status);
    seek(pose, seed, begun, q, status);
    stay(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == NONE)
            continue;
        for (int i = 0; i < 5; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int rail_5dof_ik(const double T[16], const double *q_seed, double q[2][5], unsigned char status[2])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int rail_5dof_ik_nearest(const double T[16], const double q_seed[5], double q[5])
{
    double all[2][5], found[5], least = HUGE_VAL;
    unsigned char status[2];
    int result = -NONE;
    int valid = rail_5dof_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 5; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 2 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 5; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
        }
        if (distance < least || result < 0) {
            least = distance;
            result = status[row];
            take(all[row], found);
        }
    }
    take(found, q);
    return valid ? result : -INVALID;
}

void rail_5dof_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 10 * k, status + 2 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)rail_5dof_ik(T + 16 * i, NULL, (double (*)[5])(q + 10 * i), status + 2 * i);
    }
#endif
    for (; k < n; k++)
        (void)rail_5dof_ik(T + 16 * k, NULL, (double (*)[5])(q + 10 * k), status + 2 * k);
}
