/* scorbot_pointing: Scorbot (tool axis only)
 *
 * Inverse kinematics, generated from robots/scorbot_pointing.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scorbot_pointing.yaml. The formulas and where they come from:
 * scorbot_pointing.md.
 */
#include "scorbot_pointing.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = SCORBOT_POINTING_OK, NONE = SCORBOT_POINTING_UNREACHABLE, FREE =
        SCORBOT_POINTING_FREE_JOINT,
    OUT = SCORBOT_POINTING_OUT_OF_LIMITS, INVALID = SCORBOT_POINTING_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

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

#ifndef SCORBOT_POINTING_LIBM
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
 * -DSCORBOT_POINTING_SCALAR. With -DSCORBOT_POINTING_LIBM the arctangents are those of <math.h>,
 * too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(SCORBOT_POINTING_SCALAR) && !defined(SCORBOT_POINTING_LIBM)
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
#ifdef SCORBOT_POINTING_LIBM /* half the time of atan2 */
HELPER double atan2_wide(double y, double x)
{
    return atan(y / x) + copysign(1.5707963267948966 - copysign(1.5707963267948966, x), y);
}
#else
ARCTANGENT(wide)
#endif

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16], const wide free_joints[1])
{
    const wide zz = T[2] * T[2] + T[6] * T[6] + T[10] * T[10] - 1.0;
    return zz * zz + 0.0 * (T[3] + T[7] + T[11] + free_joints[0]);
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

HELPER four irregularity_four(const double T[16], const double free_joints[1])
{
    const double zz = T[2] * T[2] + T[6] * T[6] + T[10] * T[10] - 1.0;
    return all_four(zz * zz + 0.0 * (T[3] + T[7] + T[11] + free_joints[0]));
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

/* An angle moved by a whole turn to (-pi, pi] if it is below, above, or either. */
#define TURNS(v) \
HELPER v raised_##v(v x) { return x + only_##v(x <= -half_turn, turn); } \
HELPER v centred_##v(v x) \
{ \
    return x + pick_##v(x <= -half_turn, all_##v(turn), only_##v(half_turn < x, -turn)); \
}

TURNS(wide)
#if LANES > 1
TURNS(four)
#endif


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))

/* By how much joint values miss the entries that count: the root of the sum of squares. */
static double missed_by(const double *pose, const double *q)
{
    static const int named[6] = { 2, 3, 6, 7, 10, 11 };
    double reached[16], sum = 0.0;
    scorbot_pointing_fk(q, reached);
    for (int k = 0; k < 6; k++) {
        const int i = named[k];
        const double off = (reached[i] - pose[i]) * (i % 4 == 3 ? 1.050420168067227 : 1.0);
        sum += off * off;
    }
    return sqrt(sum);
}

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[4] = { 0, 1, 2, 3 };
static const int turning[4] = { 1, 1, 1, 1 };
static const double unit[4] = { 1.0, 1.0, 1.0, 1.0 };
static const double measure[4] = {
    1.050420168067227, 1.050420168067227, 1.050420168067227, 1.050420168067227,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct descent {
    const double *T;
    double q[5], seed[4]; /* all joint values; the seed in units */
    double e[6], length; /* the miss [arm sizes, rad], and its length */
    double A[6][4]; /* how u moves the tool */
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
static void look(struct descent *d, const double u[4])
{
    double P[16], J[30], square = 0.0;
    for (int j = 0; j < 4; j++)
        d->q[solved[j]] = unit[j] * u[j];
    scorbot_pointing_fk(d->q, P);
    scorbot_pointing_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 0.952;
        for (int j = 0; j < 4; j++)
            d->A[i][j] = measure[j] * J[5 * row + solved[j]];
    }
    const double z[3] = { P[2], P[6], P[10] }, w[3] = { d->T[2], d->T[6], d->T[10] };
    const double axis[3] = { z[1] * w[2] - z[2] * w[1], z[2] * w[0] - z[0] * w[2],
        z[0] * w[1] - z[1] * w[0] };
    turn_vector(axis, z[0] * w[0] + z[1] * w[1] + z[2] * w[2], d->e + 3);
    for (int j = 0; j < 4; j++) {
        const double *spin = J + 15 + solved[j]; /* turning about z changes nothing */
        const double along = z[0] * spin[0] + z[1] * spin[5] + z[2] * spin[10];
        for (int i = 0; i < 3; i++)
            d->A[3 + i][j] = spin[5 * i] - along * z[i];
    }
    for (int i = 0; i < 6; i++)
        square += d->e[i] * d->e[i];
    d->length = sqrt(square);
}

/* What is added from start to start, in parts of the range: a direction that is like no other. */
static const double stride[4] = {
    0.8566748838545029, 0.733891856627126, 0.6287067210378086, 0.53859725722361,
};

static void copy(const double from[4], double to[4])
{
    for (int j = 0; j < 4; j++)
        to[j] = from[j];
}

/* Moves angles by whole turns to (-pi, pi]. */
static void wrap_angles(double u[4])
{
    for (int j = 0; j < 4; j++)
        if (turning[j])
            u[j] -= 6.283185307179586 * ceil(u[j] / 6.283185307179586 - 0.5);
}

/* Makes a step no longer than it may be. */
static void shorten(double step[4])
{
    double longest = 2.0;
    for (int j = 0; j < 4; j++)
        longest = fmax(longest, fabs(step[j]));
    for (int j = 0; j < 4; j++)
        step[j] *= 2.0 / longest;
}

/* The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping. The rows of
 * A, each with its share of the damping's root behind it, are made orthonormal one after another
 * (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994):
 * A A' would lose half of the digits. */
static void damped_step(
    const struct descent *d, const double e[6], double length, double little,
    double step[4])
{
    const double damping = 0.1 * fmin(length * length, 1.0) + little;
    double rows[6][10], y[6], sum[10] = { 0.0 };
    for (int i = 0; i < 6; i++) {
        double square = 0.0;
        for (int j = 0; j < 10; j++)
            rows[i][j] = j < 4 ? d->A[i][j] : j == 4 + i ? sqrt(damping) : 0.0;
        y[i] = e[i];
        for (int k = 0; k < i; k++) {
            double along = 0.0;
            for (int j = 0; j < 10; j++)
                along += rows[k][j] * rows[i][j];
            for (int j = 0; j < 10; j++)
                rows[i][j] -= along * rows[k][j];
            y[i] -= along * y[k];
        }
        for (int j = 0; j < 10; j++)
            square += rows[i][j] * rows[i][j];
        const double inverse = 1.0 / sqrt(square);
        y[i] *= inverse;
        for (int j = 0; j < 10; j++)
            rows[i][j] *= inverse;
    }
    for (int i = 6 - 1; i >= 0; i--) {
        double missing = y[i];
        for (int j = 0; j < 10; j++)
            missing -= rows[i][j] * sum[j];
        for (int j = 0; j < 10; j++)
            sum[j] += missing * rows[i][j];
    }
    for (int j = 0; j < 4; j++)
        step[j] = sum[j];
}

/* Takes a row as far as steps help, and tells how long another one would be; returns by how much
 * the row misses the pose then. Beside a singular place a step that is right may be long, and what
 * it leaves, half of its square, far more than was missed. */
static double descended(struct descent *d, int steps, double exact, double q[5], double *ahead)
{
    double u[4], best[4], step[4], least = HUGE_VAL;
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    for (int i = 0; i < 5; i++)
        d->q[i] = q[i];
    for (int j = 0; j < 4; j++)
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
            for (int j = 0; j < 4; j++)
                *ahead = fmax(*ahead, fabs(step[j]));
        }
        if (slow || (least <= 0.001 * exact && *ahead <= 0.0001))
            break;
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 4; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = 0.5 * way * way;
    }
    wrap_angles(best);
    for (int j = 0; j < 4; j++)
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
    double gap[4], widest = 0.0;
    for (int j = 0; j < 4; j++)
        gap[j] = (q[solved[j]] - other[solved[j]]) / unit[j];
    wrap_angles(gap);
    for (int j = 0; j < 4; j++)
        widest = fmax(widest, fabs(gap[j]));
    return widest;
}

/* Whether a row that was moved came to lie on one that missed by less at first. */
static int repeats(double q[4][5], const double first[4], int row)
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
        distance = fmax(distance, fabs(T[4 * coordinate[i] + 3]) / 0.952);
    return 1e-12 * distance;
}

/* Tightens the rows; ends those that do not fit, and all but one of those that have become the
 * same. Where one is exact the pose has not been rounded: then all have to be exact. */
static void tighten(const double T[16], double q[4][5], unsigned char status[4])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    int moved[4] = { 0 };
    double first[4], miss[4];
    for (int row = 0; row < 4; row++) {
        first[row] = miss[row] = HUGE_VAL;
        if (status[row] == NONE)
            continue;
        first[row] = missed_by(T, q[row]);
        miss[row] = tightened(&d, exact, first[row], q[row], &moved[row]);
    }
    double least = HUGE_VAL;
    for (int row = 0; row < 4; row++)
        least = fmin(least, miss[row]);
    const double enough = least <= exact ? exact : 1e-05;
    for (int row = 0; row < 4; row++)
        if (miss[row] > enough)
            q[row][0] = NAN;
    for (int row = 0; row < 4; row++) {
        if (!isnan(q[row][0]) && !(moved[row] && repeats(q, first, row)))
            continue;
        status[row] = NONE;
        for (int i = 0; i < 5; i++)
            q[row][i] = NAN;
    }
}

static const double
    d1 = 0.349, /* joint offset 1 [m] */
    a1 = 0.016, /* link length 1 [m] */
    a2 = 0.221, /* link length 2 [m] */
    a3 = 0.221, /* link length 3 [m] */
    d5 = 0.145, /* joint offset 5 [m] */
    second_weight = 0.952, /* lengths count in arm sizes [m] */
    free_limit1 = 9.52e-13, /* a length that fixes no angle [m] */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    offset4 = 1.5707963267948966, /* offset of joint 4 [rad] */
    longest3 = 0.195364, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    longest3_reach = 0.1953724157706304, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.1953639999999916, /* the longest, where branches merge [m^2] */
    shortest3_apart = 9.06304e-29, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 9.063039999999997e-25, /* square of a length that fixes no angle [m^2] */
    doubtful_slack = 0.01, /* a row may miss the pose by this before it is tightened */
    /* a row may miss the pose by this before it is tightened [m] */
    doubtful_slack1 = 0.009519999999999999,
    k1 = 0.097682, /* 2 * a3 * a2 [m^2] */
    k2 = 10.237300628570258, /* 1 / k1 [m^-2] */
    m1 = 9.06304e-09, /* doubt_limit1^2 [m^2] */
    m3 = 9.999999999999997e-17, /* doubt_limit_squared^2 */
    /* -1 * (longest3 - longest3_reach) * (longest3_reach - shortest3) [m^4] */
    m4 = 1.6442094386282138e-06,
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m5 = 1.6429994031951627e-12,
    m8 = 8.213869404159996e-17, /* doubt_limit_squared2^2 [m^4] */
    m9 = 1e-24, /* exact_slack^2 */
    m10 = 9.063039999999996e-25, /* exact_slack1^2 [m^2] */
    m11 = 2.7189119999999995e-10; /* 3 * pose_slack1^2 [m^2] */
/* coefficients */
static const double m6 = 4.524886877828054, m7 = 2.262443438914027;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T13 = T[2], T14 = T[3]; \
    const number T23 = T[6], T24 = T[7]; \
    const number T33 = T[10], T34 = T[11]

const char *const scorbot_pointing_branches[4] = {
    "left-down", "left-up", "right-down", "right-up",
};

static const double lowest[5] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[5] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void scorbot_pointing_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, v4 = v1 * c3 + x2_x * s3,
        v5 = v2 * c3 + x2_y * s3, y3_z = s2 * s3 - c2 * c3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), x4_x = x3_x * c4 - v4 * s4, x4_y = x3_y * c4 - v5 * s4,
        x4_z = y3_z * s4 - v3 * c4, z4_x = v4 * c4 + x3_x * s4, z4_y = v5 * c4 + x3_y * s4,
        v7 = y3_z * c4 + v3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x4_x * c5 - s1 * s5; T[1] = -(s1 * c5 + x4_x * s5); T[2] = z4_x;
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5;
    T[4] = x4_y * c5 + c1 * s5; T[5] = c1 * c5 - x4_y * s5; T[6] = z4_y;
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5;
    T[8] = x4_z * c5; T[9] = -(x4_z * s5); T[10] = -v7; T[11] = d1 - s2 * a2 - v3 * a3 - v7 * d5;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void scorbot_pointing_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z - v3 * a3, v4 = q[3] + offset4;
    const double c4 = cos(v4), s4 = sin(v4), z4_x = (v1 * c3 + x2_x * s3) * c4 + x3_x * s4,
        z4_y = (v2 * c3 + x2_y * s3) * c4 + x3_y * s4, v5 = (s2 * s3 - c2 * c3) * c4 + v3 * s4,
        p5_x = p3_x + z4_x * d5, p5_y = p3_y + z4_y * d5, p5_z = p3_z - v5 * d5, v6 = p5_z - d1,
        v7 = p5_z - p2_z, v8 = p5_x - p3_x, v9 = p5_y - p3_y, v10 = p5_z - p3_z;
    J[0] = -p5_y; J[1] = c1 * v6; J[2] = c1 * v7; J[3] = c1 * v10; J[4] = z4_y * v10 + v5 * v9;
    J[5] = p5_x; J[6] = s1 * v6; J[7] = s1 * v7; J[8] = s1 * v10; J[9] = -(v5 * v8 + z4_x * v10);
    J[10] = 0.0; J[11] = -(s1 * (p5_y - p1_y) + c1 * (p5_x - p1_x));
    J[12] = -(s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x)); J[13] = -(s1 * v9 + c1 * v8);
    J[14] = z4_x * v9 - z4_y * v8;
    J[15] = 0.0; J[16] = -s1; J[17] = -s1; J[18] = -s1; J[19] = z4_x;
    J[20] = 0.0; J[21] = c1; J[22] = c1; J[23] = c1; J[24] = z4_y;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = -v5;
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose, and 2 for what was rounded. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    const double square = T[2] * T[2] + T[6] * T[6] + T[10] * T[10];
    const double miss = (square - 1.0) * (square - 1.0);
    if (!(miss <= 1e-09))
        return 0;
    if (miss <= 1e-24)
        return 1;
    const double length = sqrt(square);
    T[2] /= length;
    T[6] /= length;
    T[10] /= length;
    return 2;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(
    const wide T[16], const wide free_joints[1], wide q[20], wide_mask kind[4])
{
    ENTRIES(wide);

    /* theta1 */
    const wide v1 = signed_wide(second_weight, T14 * T13 + T24 * T23), v2 = T14 + T13 * v1,
        v3 = T24 + T23 * v1, v4 = v2 * v2 + v3 * v3, w1 = sqrt_wide(v4), v5 = 1.0 / v4,
        factor1 = w1 * v5, v6 = v2 * factor1, v7 = v3 * factor1, angle1 = atan2_wide(-v3, -v2);

    /* theta234 */
    const wide v8 = w1 * (v5 * (T13 * v2 + T23 * v3)), v9 = T33 * T33 + v8 * v8,
        w234 = sqrt_wide(v9), v10 = 1.0 / v9, v11 = w234 * v10, angle2 = atan2_wide(-v8, T33);

    /* theta3 */
    const wide v12 = d5 * T33, v13 = T34 - d1, v14 = v11 * v12, Z1_3 = v13 - v14, v15 = d5 * v8,
        v16 = T14 * v6 + T24 * v7, v17 = a1 + v16, v18 = a1 - v16, v19 = v11 * v15, v20 = v19 - v17,
        v21 = w234 * (v10 * v15), Z2_3_p = v21 - v17, v22 = v18 + v21, v23 = Z1_3 * Z1_3,
        N3_p = v23 + Z2_3_p * Z2_3_p, N3_m = v23 + v22 * v22, K3_p = N3_p - k1, K3_m = N3_m - k1,
        D3_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = sqrt_wide(D3_p),
        w3_m = sqrt_wide(D3_m), v24 = w3_p - w3_p, v25 = w3_m - w3_m, s3_p = k2 * w3_p,
        s3_m = k2 * w3_m, c3_p = k2 * K3_p, c3_m = k2 * K3_m, angle3 = atan2_wide(w3_p, K3_p),
        angle4 = atan2_wide(w3_m, K3_m);

    /* theta2 */
    const wide v26 = v12 * v13, v27 = v10 * (v12 * v12 + v15 * v15), v28 = v13 * v13,
        Y1_2_p = m7 * (v27 + (v28 + v17 * v17)) - w234 * (m6 * (v10 * (v26 + v15 * v17))),
        Y1_2_m = m7 * (v27 + (v28 + v18 * v18)) - w234 * (m6 * (v10 * (v26 - v15 * v18))),
        v29 = Z1_3 * Y1_2_p, v30 = Z1_3 * Y1_2_m, v31 = v29 + w3_p * (m7 * v20),
        v32 = v29 + w3_p * (m7 * -v20), v33 = w3_m * (m7 * (v18 + v19)), v34 = v30 - v33,
        v35 = v30 + v33, v36 = Z2_3_p * Y1_2_p, v37 = v22 * Y1_2_m, v38 = m7 * Z1_3,
        v39 = m7 * -Z1_3, C2_pp = v36 - w3_p * v38, C2_pm = v36 - w3_p * v39,
        v40 = v37 + w3_m * v38, v41 = v37 + w3_m * v39, v42 = v31 * v31 + C2_pp * C2_pp,
        v43 = v32 * v32 + C2_pm * C2_pm, v44 = v34 * v34 + v40 * v40, v45 = v35 * v35 + v41 * v41,
        w2_pp = sqrt_wide(v42), w2_pm = sqrt_wide(v43), w2_mp = sqrt_wide(v44),
        w2_mm = sqrt_wide(v45), v46 = 1.0 / v42, v47 = 1.0 / v43, v48 = 1.0 / v44, v49 = 1.0 / v45,
        factor2_pp = w2_pp * v46, factor2_pm = w2_pm * v47, factor2_mp = w2_mp * v48,
        factor2_mm = w2_mm * v49, angle5 = atan2_wide(-v31, C2_pp),
        angle6 = atan2_wide(-v32, C2_pm), angle7 = atan2_wide(-v34, -v40),
        angle8 = atan2_wide(-v35, -v41);

    /* is the pose one that the arm can take? */
    const wide v50 = a1 - v19, v51 = a1 + v19,
        v52 = v50 + w2_pp * (v46 * (a3 * (c3_p * C2_pp + s3_p * v31) + a2 * C2_pp)),
        v53 = v50 + w2_pm * (v47 * (a3 * (c3_p * C2_pm - s3_p * v32) + a2 * C2_pm)),
        v54 = v51 + w2_mp * (v48 * (a3 * (s3_m * v34 - c3_m * v40) - a2 * v40)),
        v55 = v51 - w2_mm * (v49 * (a3 * (c3_m * v41 + s3_m * v35) + a2 * v41)), v56 = d1 + v14,
        v57 = T33 - T33 * v11, v58 = T13 - v11 * (v6 * v8), v59 = T23 - v11 * (v7 * v8),
        v60 = T34 + (factor2_pp * (a3 * (s3_p * C2_pp - c3_p * v31)) - (v56 + factor2_pp * (a2 *
            v31))),
        v61 = T34 - (factor2_pm * (a3 * (s3_p * C2_pm + c3_p * v32)) + (v56 + factor2_pm * (a2 *
            v32))),
        v62 = T34 - (factor2_mp * (a3 * (s3_m * v40 + c3_m * v34)) + (v56 + factor2_mp * (a2 *
            v34))),
        v63 = T34 + (factor2_mm * (a3 * (s3_m * v41 - c3_m * v35)) - (v56 + factor2_mm * (a2 *
            v35))), v64 = T14 + v6 * v52, v65 = T14 + v6 * v53, v66 = T14 - v6 * v54,
        v67 = T14 - v6 * v55, v68 = T24 + v7 * v52, v69 = T24 + v7 * v53, v70 = T24 - v7 * v54,
        v71 = T24 - v7 * v55, v72 = v60 * v60 + v64 * v64 + v68 * v68,
        v73 = v61 * v61 + v65 * v65 + v69 * v69, v74 = v62 * v62 + v66 * v66 + v70 * v70,
        v75 = v63 * v63 + v67 * v67 + v71 * v71;

    /* joint values */
    const wide v76 = angle2 - (angle3 + angle5) - offset4,
        v77 = angle2 - (angle6 - angle3) - offset4, v78 = offset4 + (angle2 + (angle4 + angle7)),
        v79 = offset4 + (angle2 + (angle8 - angle4)), v80 = centred_wide(v76),
        v81 = centred_wide(v77),
        v82 = pick_wide(-v78 <= -half_turn, all_wide(turn), only_wide(half_turn < -v78, -turn)) -
            v78,
        v83 = pick_wide(-v79 <= -half_turn, all_wide(turn), only_wide(half_turn < -v79, -turn)) -
            v79;
    const double v84 = NAN;
    const wide v85 = only_wide((v72 <= m10) == 0, v84), v86 = only_wide((v73 <= m10) == 0, v84),
        v87 = only_wide((v74 <= m10) == 0, v84), v88 = only_wide((v75 <= m10) == 0, v84),
        v89 = angle1 + v24, v90 = v25 + (angle1 - signed_wide(half_turn, -v3)),
        v91 = v24 + free_joints[0], v92 = v25 + free_joints[0];

    q[0] = v85 + v89; q[1] = angle5 + v85; q[2] = angle3 + v85; q[3] = v85 + raised_wide(v80);
    q[4] = v85 + v91;
    kind[0] = kind_of(q[0], 0);
    q[5] = v86 + v89; q[6] = angle6 + v86; q[7] = v86 - angle3; q[8] = v86 + raised_wide(v81);
    q[9] = v86 + v91;
    kind[1] = kind_of(q[5], 0);
    q[10] = v87 + v90; q[11] = angle7 + v87; q[12] = angle4 + v87; q[13] = v87 + raised_wide(v82);
    q[14] = v87 + v92;
    kind[2] = kind_of(q[10], 0);
    q[15] = v88 + v90; q[16] = angle8 + v88; q[17] = v88 - angle4; q[18] = v88 + raised_wide(v83);
    q[19] = v88 + v92;
    kind[3] = kind_of(q[15], 0);
    const wide_mask exact = irregularity_wide(T, free_joints) <= 1e-24;
    return (exact == 0) | ((v9 <= m3) | (v4 <= m1) | ((m10 < v75) & (v75 <= m11)) | (v45 <= m8) |
        ((m10 < v74) & (v74 <= m11)) | (v44 <= m8) | ((m10 < v73) & (v73 <= m11)) | (v43 <= m8) |
        ((m10 < v72) & (v72 <= m11)) | (v42 <= m8) | (m9 < v57 * v57 + v58 * v58 + v59 * v59) |
        ((-m4 <= D3_p) & (D3_p <= m5)) | ((-m4 <= D3_m) & (D3_m <= m5)));
}

#if LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(
    const double T[16], const double free_joints[1], double q[4][5], unsigned char status[4])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double v1 = copysign(second_weight, T14 * T13 + T24 * T23), v2 = T14 + T13 * v1,
        v3 = T24 + T23 * v1, v4 = v2 * v2 + v3 * v3, w1 = sqrt(v4), v5 = 1.0 / v4,
        factor1 = w1 * v5, v6 = v2 * factor1, v7 = v3 * factor1, v8 = copysign(half_turn, -v3);

    /* theta234 */
    const double v9 = w1 * (v5 * (T13 * v2 + T23 * v3)), v10 = T33 * T33 + v9 * v9,
        w234 = sqrt(v10), v11 = 1.0 / v10, v12 = w234 * v11;

    /* theta3 */
    const double v13 = d5 * T33, v14 = T34 - d1, v15 = v12 * v13, Z1_3 = v14 - v15, v16 = d5 * v9,
        v17 = T14 * v6 + T24 * v7;
    const four v18 = a1 + e1 * v17;
    const double v19 = v12 * v16;
    const four v20 = e1 * v19, v21 = v20 - v18, v22 = e1 * v16, Z2_3 = w234 * (v11 * v22) - v18;
    const double v23 = Z1_3 * Z1_3;
    const four N3 = v23 + Z2_3 * Z2_3, K3 = N3 - k1, D3 = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt_four(D3), v24 = w3 - w3, s3 = k2 * w3, c3 = k2 * K3;

    /* theta2 */
    const double v25 = v13 * v14, v26 = v11 * (v13 * v13 + v16 * v16), v27 = v14 * v14;
    const four Y1_2 = m7 * (v26 + (v27 + v18 * v18)) - w234 * (m6 * (v11 * (v25 + v18 * v22))),
        v28 = Z1_3 * Y1_2, v29 = v28 + w3 * (m7 * (e2 * v21)), v30 = Z2_3 * Y1_2,
        v31 = m7 * (e2 * Z1_3), C2 = v30 - w3 * v31, v32 = v29 * v29 + C2 * C2, w2 = sqrt_four(v32),
        v33 = 1.0 / v32, factor2 = w2 * v33;

    /* is the pose one that the arm can take? */
    const four v34 = a1 - v20,
        v35 = v34 + w2 * (v33 * (a3 * (c3 * C2 + e2 * (s3 * v29)) + a2 * C2));
    const double v36 = d1 + v15, v37 = T33 - T33 * v12, v38 = T13 - v12 * (v6 * v9),
        v39 = T23 - v12 * (v7 * v9);
    const four v40 = T34 + (factor2 * (a3 * (e2 * (s3 * C2) - c3 * v29)) - (v36 + factor2 * (a2 *
        v29))), v41 = T14 + e1 * (v6 * v35), v42 = T24 + e1 * (v7 * v35),
        v43 = v40 * v40 + v41 * v41 + v42 * v42;

    /* joint values */
    const double v48 = NAN;
    const four v49 = only_four((v43 <= m10) == 0, v48), v51 = v24 + free_joints[0], q5 = v49 + v51;

    if (bits_four(((irregularity_four(T, free_joints) <= 1e-24) == 0) | ((-m4 <= D3) & (D3 <= m5)) |
        ((v32 <= m8) | ((m10 < v43) & (v43 <= m11)))) | (unsigned)((v10 <= m3) | (m9 < v37 * v37 +
        v38 * v38 + v39 * v39) | (v4 <= m1)))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(shuffle(w3, all_four(-v3), 0, 5, 2, 3),
        all_four(-v9), 0, 1, 2, 7), shuffle(shuffle(K3, all_four(-v2), 0, 5, 2, 3), all_four(T33),
        0, 1, 2, 7)), ratio2 = ratio_four(-v29, C2);
    const four packed1 = angle_four(ratio1), angle3 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = shuffle(packed1, packed1, 1, 1, 1, 1),
        angle2 = shuffle(packed1, packed1, 3, 3, 3, 3), angle4 = angle_four(ratio2);
    const four v44 = e2 * angle3, v45 = e1 * angle2, v46 = v45 - (angle4 + v44) - offset4,
        v47 = centred_four(v46), v50 = v24 + (angle1 + v8 * (m2 * (e1 - 1.0))), q1 = v49 + v50,
        q2 = angle4 + v49, q3 = v44 + v49, q4 = v49 + raised_four(v47);

    store_4(&q[0][0], &q[1][0], &q[2][0], &q[3][0], q1, q2, q3, q4);
    store_1(&q[0][4], &q[1][4], &q[2][4], &q[3][4], q5);
    const unsigned long long none1 = (bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    wide pose[16], found[20], x[LANES];
    wide_mask kind[4];
    wide given[1];
    for (int i = 0; i < 1; i++)
        for (int k = 0; k < LANES; k++)
            given[i][k] = free_joints[1 * k + i];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, given, found, kind);
    for (int i = 0; i < 20; i += LANES) {
        const int from = i + LANES <= 20 ? i : 20 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 20 * k + from) = x[k];
    }
    for (int i = 1; i < 4; i++)
        kind[0] |= kind[i] << 8 * i;
    for (int k = 0; k < LANES; k++) {
        const long long word = kind[0][k];
        __builtin_memcpy(status + 4 * k, &word, 4);
    }
    return bits_wide(left);
}
#else
HELPER int solve_regular(
    const double T[16], const double free_joints[1], double q[4][5], unsigned char status[4])
{
    wide_mask kind[4];
    int count = 0;
    if (solve_wide(T, free_joints, &q[0][0], kind))
        return -1;
    for (int row = 0; row < 4; row++) {
        status[row] = (unsigned char)kind[row];
        count += kind[row] == 0;
    }
    return count;
}
#endif

/* LOST + j: the row was lost after joint j had been chosen freely; NEARLY + j: joint j is nearly
 * free, and the row's second value is its angle. */
enum { LOST = 128, NEARLY = 192 };

/* Notes why a row is lost, and how far it is from a solution. */
static void lose(int why, double off, double q[5], unsigned char *status)
{
    *status = (unsigned char)why;
    q[0] = off;
}

/* Fills the rows of the branches that have a solution, and no others. The first value of a row that
 * is LOST says how far it is from a solution (negative). */
static void solve(
    const double T[16], const double free_joints[1], const double seed[5], double q[4][5],
    unsigned char status[4])
{
    ENTRIES(double);

    /* theta1, type 2: U1[3, 4] and U1[3, 3] */
    const double v1 = copysign(second_weight, T14 * T13 + T24 * T23), v2 = T14 + T13 * v1,
        v3 = T24 + T23 * v1;
    const double w1 = sqrt(v2 * v2 + v3 * v3);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta234, type 3: U1[2, 3] and U1[1, 3] */
    const double v4 = T33 * T33, v6 = seed[1] + seed[2] + (seed[3] + offset4);

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v8 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(v2 * factor1),
            s1 = free1 ? sin(seed[0]) : -(v3 * factor1);
        const double q1 = atan2(s1, c1);

        /* theta234 */
        const double Z2_234 = T13 * c1 + T23 * s1;
        const double w234 = sqrt(Z2_234 * Z2_234 + v4);
        const int free234 = w234 <= free_limit_squared;
        const double v5 = 1.0 / (free234 ? 1.0 : w234);
        const double c234 = free234 ? cos(v6) : T33 * v5, s234 = free234 ? sin(v6) : Z2_234 * v5;
        const double theta234 = atan2(s234, c234);

        /* theta3 */
        const double v7 = c234 * d5;
        const double Z1_3 = v8 - v7;
        const double v9 = s234 * d5;
        const double Z2_3 = T14 * c1 + T24 * s1 - a1 - v9;
        const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
        const double K3 = N3 - k1;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
            if (free1) lose(LOST + 1, D3, q[2 * i1], &status[2 * i1]);
            if (free234) lose(LOST + 2, D3, q[2 * i1], &status[2 * i1]);
            if (free234) lose(LOST + 3, D3, q[2 * i1], &status[2 * i1]);
            if (free234) lose(LOST + 4, D3, q[2 * i1], &status[2 * i1]);
            continue; /* out of reach */
        }
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double c3 = K3 * k2;

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + a3 * c3;
        const double v11 = Z1_3 * Y1_2, v13 = Z2_3 * Y1_2;

        /* is the pose one that the arm can take? */
        const double v14 = a1 + v9, v16 = d1 + v7;
        if (!(fabs(T33 - c234) <= doubtful_slack && fabs(T13 - c1 * s234) <= doubtful_slack &&
            fabs(T23 - s1 * s234) <= doubtful_slack))
            continue; /* the arm can't take this pose */

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e2 * k2;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double v10 = a3 * s3, v12 = Z2_3 * v10 + v11;
            const double C2 = v13 - Z1_3 * v10;
            const double w2 = sqrt(v12 * v12 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : -(v12 * factor2);
            const double q2 = atan2(s2, c2);

            /* is the pose one that the arm can take? */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
                v15 = a3 * c23 + (a2 * c2 + v14);
            if (!(fabs(T34 + (a3 * s23 + (a2 * s2 - v16))) <= doubtful_slack1 && fabs(T14 - c1 *
                v15) <= doubtful_slack1 && fabs(T24 - s1 * v15) <= doubtful_slack1))
                continue; /* the arm can't take this pose */

            /* joint values */
            const double q4 = wrap(theta234 - (q3 + q2) - offset4);
            const int free2_ = free234 || free2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
            q[row][4] = free_joints[0];
            status[row] = (free1 || free2_ || free234 || free234) ? FREE : OK;
        }
    }
}

static void take(const double from[5], double to[5])
{
    for (int i = 0; i < 5; i++)
        to[i] = from[i];
}

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const double *T;
    const double *free_joints;
    double seed[5], start, q[4][5];
    unsigned char status[4];
    int joint, row;
};

/* How far a row is from a solution: 0 if it is solved. */
static double shortfall(const struct search *s)
{
    if (s->status[s->row] >= LOST)
        return s->q[s->row][0];
    return s->status[s->row] == NONE ? -HUGE_VAL : 0.0;
}

/* Solves with the joint moved: 0 if it serves, else less. */
static double attempt(struct search *s, double moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < 4; i++)
        s->status[i] = NONE;
    solve(s->T, s->free_joints, s->seed, s->q, s->status);
    const double result = shortfall(s);
    return result;
}

/* Whether the row was solved, as exactly as poses may be rounded. */
static int serves(const struct search *s)
{
    const int status = s->status[s->row];
    return status != NONE && status < LOST;
}

/* Golden section for a move that serves, or NaN. */
static double summit(struct search *s, double low, double high)
{
    for (int k = 0; k < 52; k++) {
        const double third = 0.3819660112501051 * (high - low);
        const double left = attempt(s, low + third), right = attempt(s, high - third);
        if (left == 0.0 || right == 0.0)
            return left == 0.0 ? low + third : high - third;
        if (left >= right)
            high -= third;
        else
            low += third;
    }
    /* where branches meet this one has no solution of its own */
    if (isinf(attempt(s, low - 1e-09)) || isinf(attempt(s, high + 1e-09)))
        return NAN;
    attempt(s, low);
    return serves(s) ? low : (double)NAN;
}

/* How far a free joint has to be moved from the seed's value until it serves, or NaN: a fan of
 * values, golden section, bisection of the nearest end; of two equally near the lower one. */
static double serving_value(struct search *s)
{
    const double step = 0.09817477042468103;
    if (attempt(s, 0.0) == 0.0)
        return 0.0;
    double nearest = NAN, before, here = -HUGE_VAL, after = attempt(s, -32.0 * step);
    for (int k = -32; k <= 32; k++) {
        before = here;
        here = after;
        after = attempt(s, (double)(k + 1) * step);
        double outer = (double)k * step, inner = k > 0 ? outer - step : k < 0 ? outer + step : 0.0;
        if (here < 0.0 && here >= before && here > after)
            outer = summit(s, outer - step, outer + step);
        else if (here < 0.0 || (k > 0 ? before : after) == 0.0)
            continue;
        if (isnan(outer))
            continue;
        for (int i = 0; i < 52; i++) {
            const double middle = 0.5 * (inner + outer);
            if (attempt(s, middle) == 0.0)
                outer = middle;
            else
                inner = middle;
        }
        if (!(fabs(outer) >= fabs(nearest) - 1e-09))
            nearest = outer;
    }
    return nearest;
}

/* A joint was nearly free: its angle had few digits, and the arm could not reach. Takes the nearest
 * that serves, also where the arm just reaches (an elbow is stretched); while it is right up to
 * rounding of what it was taken from, `solve` takes it as its own. */
static double serving_digits(struct search *s)
{
    double before[2] = { -HUGE_VAL, -HUGE_VAL };
    int past[2] = { 0 };
    for (double moved = 1e-15; moved < 0.1; moved *= 2.0)
        for (int way = 0; way < 2; way++) {
            const double there = way ? -moved : moved, here = attempt(s, there);
            if (here == 0.0)
                return there;
            if (here < 2.0 * before[way] && !past[way]++) {
                const double top = summit(s, 0.25 * there, there);
                if (!isnan(top))
                    return top;
            }
            before[way] = here;
        }
    return NAN;
}

/* Another value for a joint that had been chosen, if one serves. */
static void choose_again(
    const double T[16], const double free_joints[1], const double seed[5], int row, double q[4][5],
    unsigned char status[4])
{
    const int nearly = status[row] > NEARLY;
    struct search lost = { .T = T, .row = row, .free_joints = free_joints };
    lost.joint = status[row] - (nearly ? NEARLY : LOST) - 1;
    take(seed, lost.seed);
    lost.start = fmod(nearly ? q[row][1] : seed[lost.joint], turn);
    double nearest = nearly ? serving_digits(&lost) : serving_value(&lost);
    attempt(&lost, isnan(nearest) ? 0.0 : nearest);
    const int served = !isnan(nearest) && serves(&lost);
    status[row] = served ? lost.status[row] : NONE;
    for (int i = 0; i < 5; i++)
        q[row][i] = served ? lost.q[row][i] : (double)NAN;
}

/* Between which values starts lie. */
static const double span_low[4] = {
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
};
static const double span_width[4] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
};

/* Start number k; number 0 is the seed. */
static void start_of(const struct descent *d, int k, double u[4])
{
    for (int j = 0; j < 4; j++)
        u[j] = k == 0 ? d->seed[j] : span_low[j] + span_width[j] * fmod(0.5 + k * stride[j], 1.0);
}

/* Takes u to where damped least squares lead; returns by how much that misses the pose. Near to it
 * less damping than usual leads further, where joints hardly move the tool: there a step that is
 * right may be long, and what it leaves, half of its square, far more than was missed. */
static double descend(struct descent *d, double u[4])
{
    double least = HUGE_VAL, little = 1e-13, best[4], step[4];
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
        for (int j = 0; j < 4; j++) {
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
    const double T[16], const double free_joints[1], const double seed[5], int begun, double
        q[4][5],
    unsigned char status[4])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    double found[5] = { 0.0 };
    int before = 4, chosen = -1;
    for (int row = 4 - 1; row >= 0; row--) {
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
    d.q[4] = free_joints[0];
    for (int j = 0; j < 4; j++)
        d.seed[j] = seed[solved[j]] / unit[j];
    for (int k = 0; k < 12 && least; k++) {
        double u[4], end[5], ahead;
        start_of(&d, k, u);
        if (descend(&d, u) > 1e-05)
            continue;
        take(d.q, end);
        for (int j = 0; j < 4; j++)
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
    for (int row = 0; row < 4; row++) {
        status[row] = row == begun ? FREE : NONE;
        for (int i = 0; i < 5; i++)
            q[row][i] = row == begun ? found[i] : (double)NAN;
    }
}


/* A joint value moved by whole turns, near to another but inside its limits. */
static double turned(int joint, double given, double towards)
{
    const double low = lowest[joint] - 1e-09, high = highest[joint] + 1e-09;
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
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 1.05, 1.05, 1.05, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[5] = { 1.0, 1.0, 1.0, 1.0, 0.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[5], double e[6])
{
    double P[16], square = 0.0;
    scorbot_pointing_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3 * 4 + 2, k = (i + 2) % 3 * 4 + 2;
        e[3 + i] = P[j] * T[k] - P[k] * T[j];
        square += (P[j] - T[j]) * (P[j] - T[j]);
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[5], double damping, double e[6], double x[5])
{
    double A[6][11] = { { 0.0 } }, square[6] = { 0.0 }, J[30];
    scorbot_pointing_jacobian(x, J);
    double P[16];
    scorbot_pointing_fk(x, P);
    for (int j = 0; j < 5; j++) { /* turning about z changes nothing */
        double *spin = J + 15 + j;
        const double along = P[2] * spin[0] + P[6] * spin[5] + P[10] * spin[10];
        for (int i = 0; i < 3; i++)
            spin[5 * i] -= along * P[4 * i + 2];
    }
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
    const double T[16], const double free_joints[1], const double seed[5], double q[4][5],
    unsigned char status[4])
{
    double x[5], half[5], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    take(seed, x);
    x[4] = free_joints[0];
    if (!settle(T, 1e-12, 0.15, x))
        return;
    for (int row = 4 - 1; row >= 0; row--) {
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
    const double T[16], const double free_joints[1], const double *q_seed, double q[4][5],
    unsigned char status[4])
{
    const double zeros[5] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = isfinite(free_joints[0]) ? read_pose(T, pose) : 0;
    for (int i = 0; i < 5; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    if (valid == 2 && (count = solve_regular(pose, free_joints, q, status)) >= 0)
        return count;
    count = 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 5; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, free_joints, seed, q, status);
    int begun = 0; /* the first row that was not out of reach: here equations may have ended all */
    for (int row = 4 - 1; row >= 0; row--)
        begun = status[row] == NONE ? begun : row;
    for (int row = 0; row < 4; row++)
        if (status[row] >= LOST)
            choose_again(pose, free_joints, seed, row, q, status);
    tighten(pose, q, status);
    seek(pose, free_joints, seed, begun, q, status);
    stay(pose, free_joints, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == NONE)
            continue;
        for (int i = 0; i < 5; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, pace[i] > 0.0 ? 0.0 : *value);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int scorbot_pointing_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[4][5],
    unsigned char status[4])
{
    const int count = solve_regular(T, free_joints, q, status);
    return count < 0 ? ik_carefully(T, free_joints, q_seed, q, status) : count;
}

int scorbot_pointing_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[5], double q[5])
{
    double all[4][5], found[5], least = HUGE_VAL;
    unsigned char status[4];
    int result = -NONE;
    int valid = scorbot_pointing_ik(T, free_joints, q_seed, all, status) >= 0;
    for (int i = 0; i < 5; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 4 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 5; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
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

void scorbot_pointing_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, free_joints + k, q + 20 * k, status + 4 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)scorbot_pointing_ik(
                    T + 16 * i, free_joints + i, NULL, (double (*)[5])(q + 20 * i), status + 4 * i);
    }
#endif
    for (; k < n; k++)
        (void)scorbot_pointing_ik(
            T + 16 * k, free_joints + k, NULL, (double (*)[5])(q + 20 * k), status + 4 * k);
}
