/* stanford: Stanford arm
 *
 * Inverse kinematics, generated from robots/stanford.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/stanford.yaml. The formulas and where they come from: stanford.md.
 */
#include "stanford.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = STANFORD_OK, NONE = STANFORD_UNREACHABLE, FREE = STANFORD_FREE_JOINT,
    OUT = STANFORD_OUT_OF_LIMITS, INVALID = STANFORD_INVALID_POSE
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

#ifndef STANFORD_LIBM
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
 * -DSTANFORD_SCALAR. With -DSTANFORD_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(STANFORD_SCALAR) && !defined(STANFORD_LIBM)
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
#ifdef STANFORD_LIBM /* half the time of atan2 */
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

#define low(joint) (lowest[joint - 1] - slack(joint - 1))
#define high(joint) (highest[joint - 1] + slack(joint - 1))
/* How far a joint is beyond its limits; whether by rounding, perhaps. */
#define grazes(x) (abs_wide((x) - 5e-07) <= 5e-07)
#define grazes_four(x) (abs_four((x) - 5e-07) <= 5e-07)
#define beyond(x, joint) maximum_wide(low(joint) - (x), (x) - high(joint))
#define beyond_four(x, joint) maximum_four(low(joint) - (x), (x) - high(joint))
#define exceeds(x, joint) (abs_wide(x) - high(joint))
#define exceeds_four(x, joint) (abs_four(x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.412, /* joint offset 1 [m] */
    d2 = 0.154, /* joint offset 2 [m] */
    a3 = 0.0203, /* link length 3 [m] */
    free_limit_squared2 = 1.6129e-24, /* square of a length that fixes no angle [m^2] */
    free_limit1 = 1.27e-12, /* a length that fixes no angle [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.13369999999999999, /* d2 - a3 [m] */
    k2 = 0.01787569, /* k1^2 [m^2] */
    k3 = 3.395980000001613e-14, /* reach_slack1 * (2 * k1 + reach_slack1) [m^2] */
    k4 = 3.3959800000001613e-15, /* merge_slack1 * (2 * k1 + merge_slack1) [m^2] */
    m1 = 3.3959800000001614e-12, /* 1000 * k4 [m^2] */
    m2 = 1.6129e-08, /* doubt_limit1^2 [m^2] */
    m4 = 9.999999999999999e-09; /* doubt_limit^2 */
static const double per_size = 0.7874015748031495;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const stanford_branches[8] = {
    "left-forward-noflip", "left-forward-flip", "left-backward-noflip", "left-backward-flip",
    "right-forward-noflip", "right-forward-flip", "right-backward-noflip", "right-backward-flip",
};

static const double lowest[6] = {
    -2.9670597283903604, -2.9670597283903604, 0.3048, -2.9670597283903604, -1.5707963267948966,
    -2.9670597283903604,
};
static const double highest[6] = {
    2.9670597283903604, 2.9670597283903604, 1.27, 2.9670597283903604, 1.5707963267948966,
    2.9670597283903604,
};
static const int revolute[6] = { 1, 1, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 1.0, 0.62000124000248, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 1.27e-09) /* of limits */
/* Of the values of a free joint that are tried, from one to the next. */
static const double fan_step[6] = {
    0.09817477042468103, 0.09817477042468103, 0.030162500000000002, 0.09817477042468103,
    0.09817477042468103, 0.09817477042468103,
};

void stanford_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = s1 * c4 + x2_x * s4,
        x4_y = x2_y * s4 - c1 * c4, v1 = s2 * s4, z4_x = x2_x * c4 - s1 * s4,
        z4_y = x2_y * c4 + c1 * s4, v2 = s2 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - z2_x * s5,
        x5_y = x4_y * c5 - z2_y * s5, v3 = v1 * c5 + c2 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z2_x * c5 + x4_x * s5;
    T[3] = z2_x * q[2] - s1 * d2 + s1 * a3;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z2_y * c5 + x4_y * s5;
    T[7] = c1 * d2 + z2_y * q[2] - c1 * a3;
    T[8] = -(v3 * c6 + v2 * s6); T[9] = v3 * s6 - v2 * c6; T[10] = c2 * c5 - v1 * s5;
    T[11] = d1 + c2 * q[2];
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void stanford_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2, p3_x = z2_x * q[2] - s1 * d2 + s1 * a3,
        p3_y = c1 * d2 + z2_y * q[2] - c1 * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]);
    const double c5 = cos(q[4]), s5 = sin(q[4]), v1 = d1 + c2 * q[2] - d1;
    J[0] = -p3_y; J[1] = c1 * v1; J[2] = z2_x; J[3] = 0.0; J[4] = 0.0; J[5] = 0.0;
    J[6] = p3_x; J[7] = s1 * v1; J[8] = z2_y; J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = -(s1 * p3_y + c1 * p3_x); J[14] = c2; J[15] = 0.0; J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0; J[19] = -s1; J[20] = 0.0; J[21] = z2_x; J[22] = x2_x * c4 - s1 * s4;
    J[23] = z2_x * c5 + (s1 * c4 + x2_x * s4) * s5;
    J[24] = 0.0; J[25] = c1; J[26] = 0.0; J[27] = z2_y; J[28] = x2_y * c4 + c1 * s4;
    J[29] = z2_y * c5 + (x2_y * s4 - c1 * c4) * s5;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = c2; J[34] = -(s2 * c4);
    J[35] = c2 * c5 - s2 * s4 * s5;
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

/* How far a joint value is beyond its limits, whole turns aside; negative below. */
static double overshoot(int joint, double value)
{
    const double low = lowest[joint], high = highest[joint];
    if (low <= value && value <= high)
        return 0.0;
    double off = value > high ? value - high : value - low;
    const double gap = turn - (high - low), over = value - high;
    const double rest = over - turn * floor(over / turn);
    if (revolute[joint])
        off = rest >= gap ? 0.0 : rest <= gap - rest ? rest : rest - gap;
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of a row. */
static double beyond_limits(const double values[6])
{
    double sum = 0.0;
    for (int i = 0; i < 6; i++)
        sum += fabs(overshoot(i, values[i])) * sqrt(weight[i]);
    return sum;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[48], wide_mask kind[8])
{
    ENTRIES(wide);

    /* theta1 */
    const wide N1 = T14 * T14 + T24 * T24, D1 = N1 - k2, w1 = sqrt_wide(D1), v1 = w1 - w1,
        inverse1 = 1.0 / N1, v2 = k1 * T14, v3 = k1 * T24, v4 = inverse1 * v3,
        v5 = w1 * (T14 * inverse1), c1_p = v4 - v5, c1_m = v4 + v5, v6 = inverse1 * v2,
        v7 = w1 * (T24 * inverse1), v8 = v6 + v7, v9 = v6 - v7, angle1 = atan2_wide(-v8, c1_p),
        angle2 = atan2_wide(-v9, c1_m);

    /* theta2, r3 */
    const wide Y2_2 = T34 - d1, v10 = D1 + Y2_2 * Y2_2, w3 = sqrt_wide(v10),
        factor2 = w3 * (1.0 / v10), angle3 = atan2_wide(-w1, Y2_2),
        q2_pmp = angle3 - signed_wide(half_turn, -w1);

    /* theta4 */
    const wide c4_p = v8 * T13 + c1_p * T23, c4_m = v9 * T13 + c1_m * T23,
        v11 = inverse1 * (Y2_2 * (T14 * T13 + T24 * T23)) - T33,
        v12 = inverse1 * (Y2_2 * (v2 * T23 - v3 * T13)), Y4_p = v12 + w1 * v11,
        Y4_m = v12 + w1 * -v11, v13 = factor2 * Y4_p, v14 = factor2 * Y4_m,
        v15 = c4_p * c4_p + factor2 * (Y4_p * v13), v16 = c4_m * c4_m + factor2 * (Y4_m * v14),
        angle4 = atan2_wide(v13, c4_p), angle5 = atan2_wide(v14, c4_m),
        q4_ppm = angle4 - signed_wide(half_turn, v13),
        q4_mpm = angle5 - signed_wide(half_turn, v14);

    /* theta5 */
    const wide v17 = Y2_2 * T33,
        angle6 = atan2_wide(-sqrt_wide(v15), factor2 * (v17 - w1 * (c1_p * T13 - v8 * T23))),
        angle7 = atan2_wide(-sqrt_wide(v16), factor2 * (v17 + w1 * (c1_m * T13 - v9 * T23))),
        q5_pmp = signed_wide(half_turn, -sqrt_wide(v15)) - angle6,
        q5_mmp = signed_wide(half_turn, -sqrt_wide(v16)) - angle7;

    /* theta6 */
    const wide v18 = T32 - inverse1 * (Y2_2 * (T14 * T12 + T24 * T22)),
        v19 = inverse1 * (Y2_2 * (v3 * T12 - v2 * T22)),
        v20 = T31 - inverse1 * (Y2_2 * (T14 * T11 + T24 * T21)),
        v21 = inverse1 * (Y2_2 * (v3 * T11 - v2 * T21)),
        s6_p = c4_p * (v21 + w1 * v20) + Y4_p * (c1_p * T21 + v8 * T11),
        s6_m = c4_m * (v21 + w1 * -v20) + Y4_m * (c1_m * T21 + v9 * T11),
        angle8 = atan2_wide(s6_p, c4_p * (v19 + w1 * v18) + Y4_p * (c1_p * T22 + v8 * T12)),
        angle9 = atan2_wide(s6_m, c4_m * (v19 + w1 * -v18) + Y4_m * (c1_m * T22 + v9 * T12)),
        q6_ppm = angle8 - signed_wide(half_turn, s6_p),
        q6_mpm = angle9 - signed_wide(half_turn, s6_m);

    /* joint values */
    const wide v22 = exceeds(angle1, 1), v23 = exceeds(angle2, 1), v24 = exceeds(angle3, 2),
        v25 = exceeds(q2_pmp, 2), v26 = per_size * beyond(w3, 3),
        v27 = per_size * maximum_wide(low(3) + w3, -(high(3) + w3)), v28 = exceeds(angle4, 4),
        v29 = exceeds(q4_ppm, 4), v30 = exceeds(angle5, 4), v31 = exceeds(q4_mpm, 4),
        v32 = exceeds(angle6, 5), v33 = exceeds(q5_pmp, 5), v34 = exceeds(angle7, 5),
        v35 = exceeds(q5_mmp, 5), q3_ppp = v1 + w3, q3_pmp = v1 - w3,
        v36 = maximum_wide(v26, maximum_wide(v22, v24)),
        v37 = maximum_wide(v27, maximum_wide(v22, v25)),
        v38 = maximum_wide(v26, maximum_wide(v23, v24)),
        v39 = maximum_wide(v27, maximum_wide(v23, v25)), v40 = exceeds(angle8, 6),
        excess_ppp = maximum_wide(v40, maximum_wide(v32, maximum_wide(v28, v36))),
        v41 = exceeds(q6_ppm, 6),
        excess_ppm = maximum_wide(v41, maximum_wide(v32, maximum_wide(v29, v36))),
        excess_pmp = maximum_wide(v41, maximum_wide(v33, maximum_wide(v28, v37))),
        excess_pmm = maximum_wide(v40, maximum_wide(v33, maximum_wide(v29, v37))),
        v42 = exceeds(angle9, 6),
        excess_mpp = maximum_wide(v42, maximum_wide(v34, maximum_wide(v30, v38))),
        v43 = exceeds(q6_mpm, 6),
        excess_mpm = maximum_wide(v43, maximum_wide(v34, maximum_wide(v31, v38))),
        excess_mmp = maximum_wide(v43, maximum_wide(v35, maximum_wide(v30, v39))),
        excess_mmm = maximum_wide(v42, maximum_wide(v35, maximum_wide(v31, v39)));

    q[0] = angle1; q[1] = angle3; q[2] = q3_ppp; q[3] = angle4; q[4] = angle6; q[5] = angle8;
    kind[0] = kind_of(q[0], 0.0 < excess_ppp);
    q[6] = angle1; q[7] = angle3; q[8] = q3_ppp; q[9] = q4_ppm; q[10] = -angle6; q[11] = q6_ppm;
    kind[1] = kind_of(q[6], 0.0 < excess_ppm);
    q[12] = angle1; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = -angle4; q[16] = q5_pmp; q[17] = q6_ppm;
    kind[2] = kind_of(q[12], 0.0 < excess_pmp);
    q[18] = angle1; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = -q4_ppm; q[22] = -q5_pmp;
    q[23] = angle8;
    kind[3] = kind_of(q[18], 0.0 < excess_pmm);
    q[24] = angle2; q[25] = -angle3; q[26] = q3_ppp; q[27] = angle5; q[28] = angle7; q[29] = angle9;
    kind[4] = kind_of(q[24], 0.0 < excess_mpp);
    q[30] = angle2; q[31] = -angle3; q[32] = q3_ppp; q[33] = q4_mpm; q[34] = -angle7;
    q[35] = q6_mpm;
    kind[5] = kind_of(q[30], 0.0 < excess_mpm);
    q[36] = angle2; q[37] = -q2_pmp; q[38] = q3_pmp; q[39] = -angle5; q[40] = q5_mmp;
    q[41] = q6_mpm;
    kind[6] = kind_of(q[36], 0.0 < excess_mmp);
    q[42] = angle2; q[43] = -q2_pmp; q[44] = q3_pmp; q[45] = -q4_mpm; q[46] = -q5_mmp;
    q[47] = angle9;
    kind[7] = kind_of(q[42], 0.0 < excess_mmm);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v10 <= m2) | (abs_wide(D1) <= m1) | (v15 <= m4) | (v16 <= m4)) |
        (grazes(excess_mmm) | grazes(excess_mmp) | grazes(excess_mpm) | grazes(excess_mpp) |
        grazes(excess_pmm) | grazes(excess_pmp) | grazes(excess_ppp) | grazes(excess_ppm));
}

#if LANES > 1
static const double
    m3 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[8][6], unsigned char status[8])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double N1 = T14 * T14 + T24 * T24, D1 = N1 - k2, w1 = sqrt(D1), v1 = w1 - w1,
        inverse1 = 1.0 / N1, v2 = k1 * T14, v3 = k1 * T24, v4 = inverse1 * v3;
    const four c1 = v4 - w1 * (inverse1 * (e1 * T14));
    const double v5 = inverse1 * v2;
    const four v6 = v5 + w1 * (inverse1 * (e1 * T24));

    /* theta2, r3 */
    const double Y2_2 = T34 - d1, v7 = D1 + Y2_2 * Y2_2, w3 = sqrt(v7), factor2 = w3 * (1.0 / v7),
        v8 = copysign(half_turn, -w1);
    const four v9 = e2 - 1.0, v10 = m3 * v9;

    /* theta4 */
    const four c4 = v6 * T13 + c1 * T23;
    const double v11 = inverse1 * (Y2_2 * (T14 * T13 + T24 * T23)) - T33,
        v12 = inverse1 * (Y2_2 * (v2 * T23 - v3 * T13));
    const four Y4 = v12 + w1 * (e1 * v11), v13 = factor2 * Y4, v14 = c4 * c4 + factor2 * (Y4 * v13);

    /* theta5 */
    const double v15 = Y2_2 * T33;
    const four v16 = signed_four(half_turn, -sqrt_four(v14)), v17 = m3 * -v9;

    /* theta6 */
    const double v18 = T32 - inverse1 * (Y2_2 * (T14 * T12 + T24 * T22)),
        v19 = inverse1 * (Y2_2 * (v3 * T12 - v2 * T22)),
        v20 = T31 - inverse1 * (Y2_2 * (T14 * T11 + T24 * T21)),
        v21 = inverse1 * (Y2_2 * (v3 * T11 - v2 * T21));
    const four s6 = c4 * (v21 + w1 * (e1 * v20)) + Y4 * (c1 * T21 + v6 * T11),
        v22 = signed_four(half_turn, s6), v23 = m3 * (e2 + 1.0);

    /* joint values */
    const four v24 = e2 * w3, v27 = per_size * beyond_four(v24, 3), q3_p = v1 + v24;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | (v14 <= m4)) | (unsigned)((fabs(D1) <=
        m1) | (v7 <= m2)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ -w1, -w1, -w1, -w1 }, (four){ Y2_2, Y2_2, Y2_2,
        Y2_2 }), ratio2 = ratio_four(shuffle(-v6, v13, 0, 5, 2, 7), shuffle(c1, c4, 0, 5, 2, 7)),
        ratio3 = ratio_four(shuffle(-sqrt_four(v14), s6, 0, 5, 2, 7), shuffle(factor2 * (v15 - e1 *
            (w1 * (c1 * T13 - v6 * T23))), c4 * (v19 + w1 * (e1 * v18)) + Y4 * (c1 * T22 + v6 *
            T12), 0, 5, 2, 7));
    const four packed1 = angle_four(ratio1), angle2 = shuffle(packed1, packed1, 0, 0, 0, 0),
        packed2 = angle_four(ratio2), angle1 = shuffle(packed2, packed2, 0, 0, 2, 2),
        angle3 = shuffle(packed2, packed2, 1, 1, 3, 3), packed3 = angle_four(ratio3),
        angle4 = shuffle(packed3, packed3, 0, 0, 2, 2),
        angle5 = shuffle(packed3, packed3, 1, 1, 3, 3);
    const four q2_ = angle2 + v8 * v10, q4__m = angle3 - signed_four(half_turn, v13),
        q5_p = e2 * angle4 + v16 * v17, q6_p = angle5 + v10 * v22, q6_m = angle5 - v22 * v23,
        q2_p = e1 * q2_, q4_p = e2 * angle3, q4_m = e2 * q4__m, v25 = exceeds_four(angle1, 1),
        v26 = exceeds_four(q2_, 2), v28 = exceeds_four(angle3, 4), v29 = exceeds_four(q4__m, 4),
        v30 = exceeds_four(q5_p, 5), v31 = maximum_four(v27, maximum_four(v25, v26)),
        excess_p = maximum_four(exceeds_four(q6_p, 6), maximum_four(v30, maximum_four(v28, v31))),
        excess_m = maximum_four(exceeds_four(q6_m, 6), maximum_four(v30, maximum_four(v29, v31)));
    const four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (bits_four((grazes_four(excess_p) | grazes_four(excess_m))))
        return -1;

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], angle1, q2_p, q3_p, q4_p);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], q5_p, q6_p);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], angle1, q2_p, q3_p, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], -q5_p, q6_m);
    const unsigned long long none1 = (bits_four(angle1 != angle1) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long outside1 = (bits_four(outside_p) * 0x200040008001ull &
        0x1000100010001ull) | (bits_four(outside_m) * 0x20004000800100ull & 0x100010001000100ull);
    const unsigned long long kind1 = none1 * NONE + (outside1 & ~none1) * OUT;
    __builtin_memcpy(status + 0, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~(none1 | outside1));
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[48], x[LANES];
    wide_mask kind[8];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 48; i += LANES) {
        const int from = i + LANES <= 48 ? i : 48 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 48 * k + from) = x[k];
    }
    for (int i = 1; i < 8; i++)
        kind[0] |= kind[i] << 8 * i;
    for (int k = 0; k < LANES; k++) {
        const long long word = kind[0][k];
        __builtin_memcpy(status + 8 * k, &word, 8);
    }
    return bits_wide(left);
}
#else
HELPER int solve_regular(const double T[16], double q[8][6], unsigned char status[8])
{
    wide_mask kind[8];
    int count = 0;
    if (solve_wide(T, &q[0][0], kind))
        return -1;
    for (int row = 0; row < 8; row++) {
        status[row] = (unsigned char)kind[row];
        count += kind[row] == 0;
    }
    return count;
}
#endif

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[6], double q[8][6], unsigned char status[8])
{
    ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double N1 = T14 * T14 + T24 * T24;
    const int free1 = N1 <= free_limit_squared2;
    const double D1 = N1 - k2;
    const int apart1 = k4 < D1;
    if (!(-k3 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : k1 * sqrt(N1)));
    const double v1 = T14 * k1, v2 = T24 * k1;

    /* theta2, r3, type 4: U1[1, 4] and U1[2, 4] */
    const double Y2_2 = T34 - d1;
    const double v3 = Y2_2 * Y2_2;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v2 - T14 * root1),
            s1 = free1 ? sin(seed[0]) : -(inverse1 * (v1 + T24 * root1));
        const double q1 = atan2(s1, c1);

        /* theta2, r3 */
        const double w3 = sqrt(root1 * root1 + v3);
        const int free2 = w3 <= free_limit1;
        const double divisor2 = free2 ? 1.0 : w3;

        /* theta4, type 2: U4[3, 3] */
        const double X4 = T13 * s1 - T23 * c1;
        const double v4 = T13 * c1 + T23 * s1, v5 = X4 * X4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v6 = T12 * c1 + T22 * s1, v8 = T22 * c1 - T12 * s1, v9 = T11 * c1 + T21 * s1,
            v11 = T21 * c1 - T11 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : Y2_2 * factor2,
                s2 = free2 ? sin(seed[1]) : -(root1 * factor2);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;

            /* theta4 */
            const double Y4 = T33 * s2 - c2 * v4;
            const double w4 = sqrt(v5 + Y4 * Y4);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c2 + s2 * v4;

            /* theta6 */
            const double v7 = c2 * v6 - T32 * s2, v10 = c2 * v9 - T31 * s2;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6 */
                const double c6 = c4 * v7 + s4 * v8, s6 = c4 * v10 + s4 * v11;
                const double q6 = atan2(s6, c6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = r3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? FREE : OK;
            }
        }
    }
}

static void take(const double from[6], double to[6])
{
    for (int i = 0; i < 6; i++)
        to[i] = from[i];
}

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const double *T;
    double seed[6], start, q[8][6];
    unsigned char status[8];
    int joint, row;
};

/* Solves with the joint moved: 0 if it serves, else less. */
static double attempt(struct search *s, double moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < 8; i++)
        s->status[i] = NONE;
    solve(s->T, s->seed, s->q, s->status);
    if (s->status[s->row] == NONE)
        return -HUGE_VAL;
    return -beyond_limits(s->q[s->row]);
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
    return NAN;
}

/* How far a free joint has to be moved from the seed's value until it serves, or NaN: a fan of
 * values, golden section, bisection of the nearest end; of two equally near the lower one. */
static double serving_value(struct search *s)
{
    const double step = fan_step[s->joint];
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

/* Whether a joint beyond its limits does not move with the one that is searched. */
static int hopeless(struct search *s)
{
    struct search other = *s;
    if (isinf(attempt(s, 0.0)) || isinf(attempt(&other, 0.1)))
        return 0;
    for (int i = 0; i < 6; i++) {
        const double value = s->q[s->row][i], moved = fabs(value - other.q[s->row][i]);
        if (moved < 1e-09 && fabs(overshoot(i, value)) > 0.0)
            return 1;
    }
    return 0;
}

/* A free joint took the seed's value, and that puts one beyond its limits: takes the nearest value
 * that keeps all, if there is one; other free joints the seed's, as far as their limits allow. */
static void keep_limits(
    const double T[16], const double seed[6], int row, double q[8][6], unsigned char status[8])
{
    static const int choosable[3] = { 3, 1, 0 };
    struct search search = { .T = T, .row = row };
    for (int i = 0; i < 6; i++)
        search.seed[i] = seed[i] - overshoot(i, seed[i]);
    for (int k = 0; k < 3; k++) {
        const int joint = search.joint = choosable[k];
        const double inside = search.seed[joint];
        search.start = revolute[joint] ? fmod(seed[joint], turn) : inside;
        const double nearest = hopeless(&search) ? (double)NAN : serving_value(&search);
        /* beside the solution of another row this one has none */
        if (!isnan(nearest) && (fabs(nearest) >= 1e-06 || !isinf(attempt(&search, 0.0)))) {
            attempt(&search, nearest);
            status[row] = search.status[row];
            take(search.q[row], q[row]);
            return;
        }
        search.seed[joint] = inside;
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
static double half_way(const double x[6], const double q[6], double half[6])
{
    double most = 0.0;
    for (int i = 0; i < 6; i++) {
        double off = q[i] - x[i];
        off -= revolute[i] ? turn * floor(off / turn + 0.5) : 0.0;
        most = fmax(most, fabs(off) * sqrt(weight[i]));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.7874, 0.7874, 0.7874, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.27, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    stanford_fk(x, P);
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
static void add_step(const int held[6], double damping, double e[6], double x[6])
{
    double A[6][12] = { { 0.0 } }, square[6] = { 0.0 }, J[36];
    stanford_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[6 * i + j];
        A[i][6 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 12; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 12; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 12; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 6; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[6])
{
    double x[6], half[6], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[6] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 6 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? overshoot(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 6; i++)
                held[i] = i == worst || (held[i] && moves != 2);
            last = HUGE_VAL;
            x[worst] -= past;
            miss = off_pose(T, x, e);
        }
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

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const double T[16], int row, int far, double rows[8][6], const unsigned char status[8])
{
    double x[6], half[6], to[6], *q = rows[row];
    const double beyond = beyond_limits(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!settle(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 8; k++)
        if (status[k] != NONE && beyond_limits(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const double T[16], const double seed[6], double q[8][6],
    unsigned char status[8])
{
    double x[6], half[6], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    for (int i = 0; i < 6; i++)
        x[i] = seed[i] - overshoot(i, seed[i]);
    if (!settle(T, 1e-12, 0.15, x) || (beyond_limits(x) > 1e-09 && !settle(T, NAN, 0.15, x)))
        return;
    for (int row = 8 - 1; row >= 0; row--) {
        double between = 1e-06;
        if (status[row] != NONE) {
            const double off = half_way(x, q[row], half);
            between = off < 0.001 ? 0.0 : fmax(off_pose(T, half, e), 1e-12);
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
    if (nearest > 1e-06 || beyond_limits(q[place]) > 0.0)
        take(x, q[place]);
}

/* A pose that is rounded, singular or none; regular ones need no stack for it. */
APART int ik_carefully(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const double zeros[6] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 6; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    if (valid == 2 && (count = solve_regular(pose, q, status)) >= 0)
        return count;
    count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++)
        if (status[row] == FREE && beyond_limits(q[row]) > 0.0)
            keep_limits(pose, seed, row, q, status);
    stay(pose, seed, q, status);
    /* far where no row is inside */
    for (int n = 0; n < 8 || (n < 2 * 8 && count == 0); n++) {
        const int row = n % 8, far = n >= 8;
        if (status[row] == NONE)
            continue;
        if (stand(pose, row, far, q, status) && far)
            status[row] = FREE;
        for (int i = 0; i < 6; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int stanford_ik(const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int stanford_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = stanford_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 6; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 8 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 6; i++) {
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

void stanford_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)stanford_ik(T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)stanford_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
