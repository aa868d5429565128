/* spherical: Spherical arm
 *
 * Inverse kinematics, generated from robots/spherical.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical.yaml. The formulas and where they come from:
 * spherical.md.
 */
#include "spherical.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = SPHERICAL_OK, NONE = SPHERICAL_UNREACHABLE, FREE = SPHERICAL_FREE_JOINT,
    OUT = SPHERICAL_OUT_OF_LIMITS, INVALID = SPHERICAL_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

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

#ifndef SPHERICAL_LIBM
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
 * -DSPHERICAL_SCALAR. With -DSPHERICAL_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(SPHERICAL_SCALAR) && !defined(SPHERICAL_LIBM)
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
#ifdef SPHERICAL_LIBM /* half the time of atan2 */
HELPER double atan2_wide(double y, double x)
{
    return atan(y / x) + copysign(1.5707963267948966 - copysign(1.5707963267948966, x), y);
}
#else
ARCTANGENT(wide)
#endif

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16])
{
    return 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] * T[11]);
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

typedef double two_at __attribute__((vector_size(16), aligned(8), may_alias)); /* in memory */

HELPER void store_2(double *r0, double *r1, double *r2, double *r3, four a, four b)
{
    const four first = shuffle(a, b, 0, 4, 2, 6);
    const four second = shuffle(a, b, 1, 5, 3, 7);
    *(two_at *)r0 = shuffle(first, first, 0, 1);
    *(two_at *)r1 = shuffle(second, second, 0, 1);
    *(two_at *)r2 = shuffle(first, first, 2, 3);
    *(two_at *)r3 = shuffle(second, second, 2, 3);
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
    return all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] * T[11]));
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
static const double
    d1 = 0.5, /* joint offset 1 [m] */
    free_limit1 = 5e-13, /* a length that fixes no angle [m] */
    m1 = 2.4999999999999996e-09; /* doubt_limit1^2 [m^2] */

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T14 = T[3]; \
    const number T24 = T[7]; \
    const number T34 = T[11]

const char *const spherical_branches[4] = {
    "left-forward", "left-backward", "right-forward", "right-backward",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
static const int revolute[3] = { 1, 1, 0 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 1.0, 1.0, 4.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 5e-10) /* of limits */

void spherical_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), v1 = c1 * s2, v2 = s1 * s2;
    T[0] = c1 * c2; T[1] = -s1; T[2] = -v1; T[3] = -(v1 * q[2]);
    T[4] = s1 * c2; T[5] = c1; T[6] = -v2; T[7] = -(v2 * q[2]);
    T[8] = s2; T[9] = 0.0; T[10] = c2; T[11] = d1 + c2 * q[2];
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void spherical_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), v1 = c1 * s2, v2 = s1 * s2, v3 = v1 * q[2],
        J11 = v2 * q[2], v4 = d1 + c2 * q[2] - d1;
    J[0] = J11; J[1] = -(c1 * v4); J[2] = -v1;
    J[3] = -v3; J[4] = -(s1 * v4); J[5] = -v2;
    J[6] = 0.0; J[7] = -(s1 * J11 + c1 * v3); J[8] = c2;
    J[9] = 0.0; J[10] = s1; J[11] = 0.0;
    J[12] = 0.0; J[13] = -c1; J[14] = 0.0;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
}

/* Copies a pose. Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3] * T[3] * T[3]) && isfinite(T[7] * T[7] * T[7]) && isfinite(T[11] * T[11] *
        T[11])))
        return 0;
    return 1;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[12], wide_mask kind[4])
{
    ENTRIES(wide);

    /* theta1 */
    const wide v1 = T14 * T14 + T24 * T24, angle1 = atan2_wide(T24, T14),
        q1_mp = angle1 - signed_wide(half_turn, T24);

    /* theta2, r3 */
    const wide Y2_2 = T34 - d1, v2 = v1 + Y2_2 * Y2_2, q3_pp = sqrt_wide(v2),
        angle2 = atan2_wide(-sqrt_wide(v1), Y2_2),
        q2_pm = angle2 - signed_wide(half_turn, -sqrt_wide(v1));

    q[0] = angle1; q[1] = angle2; q[2] = q3_pp;
    kind[0] = kind_of(q[0], 0);
    q[3] = angle1; q[4] = q2_pm; q[5] = -q3_pp;
    kind[1] = kind_of(q[3], 0);
    q[6] = q1_mp; q[7] = -angle2; q[8] = q3_pp;
    kind[2] = kind_of(q[6], 0);
    q[9] = q1_mp; q[10] = -q2_pm; q[11] = -q3_pp;
    kind[3] = kind_of(q[9], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v1 <= m1) | (v2 <= m1));
}

#if LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[4][3], unsigned char status[4])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double v1 = T14 * T14 + T24 * T24, v2 = copysign(half_turn, T24);

    /* theta2, r3 */
    const double Y2_2 = T34 - d1, v3 = v1 + Y2_2 * Y2_2, w3 = sqrt(v3),
        v4 = copysign(half_turn, -sqrt(v1));

    /* joint values */
    const four q3 = e2 * w3;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0)) | (unsigned)((v1 <= m1) | (v3 <= m1)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ T24, -sqrt(v1), T24, T24 }, (four){ T14, Y2_2, T14,
        T14 });
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = shuffle(packed1, packed1, 1, 1, 1, 1);
    const four q1 = angle1 + v2 * (m2 * (e1 - 1.0)), q2_ = angle2 + v4 * (m2 * (e2 - 1.0)),
        q2 = e1 * q2_;

    store_2(&q[0][0], &q[1][0], &q[2][0], &q[3][0], q1, q2);
    store_1(&q[0][2], &q[1][2], &q[2][2], &q[3][2], q3);
    const unsigned long long none1 = (bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[12], x[LANES];
    wide_mask kind[4];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 12; i += LANES) {
        const int from = i + LANES <= 12 ? i : 12 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 12 * k + from) = x[k];
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
HELPER int solve_regular(const double T[16], double q[4][3], unsigned char status[4])
{
    wide_mask kind[4];
    int count = 0;
    if (solve_wide(T, &q[0][0], kind))
        return -1;
    for (int row = 0; row < 4; row++) {
        status[row] = (unsigned char)kind[row];
        count += kind[row] == 0;
    }
    return count;
}
#endif

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[3], double q[4][3], unsigned char status[4])
{
    ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta2, r3, type 4: U1[1, 4] and U1[2, 4] */
    const double Y2_2 = T34 - d1;
    const double v1 = Y2_2 * Y2_2;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : T14 * factor1,
            s1 = free1 ? sin(seed[0]) : T24 * factor1;
        const double q1 = atan2(s1, c1);
        const double root1 = w1 * e1;

        /* theta2, r3 */
        const double w3 = sqrt(root1 * root1 + v1);
        const int free2 = w3 <= free_limit1;
        const double divisor2 = free2 ? 1.0 : w3;

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : Y2_2 * factor2,
                s2 = free2 ? sin(seed[1]) : -(root1 * factor2);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = r3;
            status[row] = (free1 || free2) ? FREE : OK;
        }
    }
}

static void take(const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
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
static double half_way(const double x[3], const double q[3], double half[3])
{
    double most = 0.0;
    for (int i = 0; i < 3; i++) {
        double off = q[i] - x[i];
        off -= revolute[i] ? turn * floor(off / turn + 0.5) : 0.0;
        most = fmax(most, fabs(off) * sqrt(weight[i]));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 2.0, 2.0, 2.0, 0.0, 0.0, 0.0 };
/* What a step of one means for joints; none if given. */
static const double pace[3] = { 1.0, 1.0, 0.5 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[3], double e[6])
{
    double P[16], square = 0.0;
    spherical_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[3], double damping, double e[6], double x[3])
{
    double A[6][9] = { { 0.0 } }, square[6] = { 0.0 }, J[18];
    spherical_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 3; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[3 * i + j];
        A[i][3 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 9; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 9; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 9; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 3; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[3])
{
    double x[3], half[3], e[6], last = HUGE_VAL;
    int settled = 0, lost = 0, held[3] = { 0 };
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
    const double T[16], const double seed[3], double q[4][3],
    unsigned char status[4])
{
    double x[3], half[3], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    take(seed, x);
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
    const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    const double zeros[3] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 3; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    stay(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
        if (status[row] == NONE)
            continue;
        for (int i = 0; i < 3; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int spherical_ik(const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int spherical_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[4][3], found[3], least = HUGE_VAL;
    unsigned char status[4];
    int result = -NONE;
    int valid = spherical_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 3; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 4 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 3; i++) {
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

void spherical_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 12 * k, status + 4 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)spherical_ik(T + 16 * i, NULL, (double (*)[3])(q + 12 * i), status + 4 * i);
    }
#endif
    for (; k < n; k++)
        (void)spherical_ik(T + 16 * k, NULL, (double (*)[3])(q + 12 * k), status + 4 * k);
}
