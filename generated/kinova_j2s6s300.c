/* kinova_j2s6s300: Kinova Jaco j2s6s300, spherical wrist
 *
 * Inverse kinematics, generated from robots/kinova_j2s6s300.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kinova_j2s6s300.yaml. The formulas and where they come from:
 * kinova_j2s6s300.md.
 */
#include "kinova_j2s6s300.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = KINOVA_J2S6S300_OK, NONE = KINOVA_J2S6S300_UNREACHABLE, FREE = KINOVA_J2S6S300_FREE_JOINT,
    OUT = KINOVA_J2S6S300_OUT_OF_LIMITS, INVALID = KINOVA_J2S6S300_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

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

#ifndef KINOVA_J2S6S300_LIBM
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
 * -DKINOVA_J2S6S300_SCALAR. With -DKINOVA_J2S6S300_LIBM the arctangents are those of <math.h>,
 * too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(KINOVA_J2S6S300_SCALAR) && !defined(KINOVA_J2S6S300_LIBM)
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
#ifdef KINOVA_J2S6S300_LIBM /* half the time of atan2 */
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
    return misfit_wide(T) + w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3 + 0.0 * (T[3] + T[7] + T[11]);
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

/* An angle moved by a whole turn to (-pi, pi] if it is below, above, or either. */
#define TURNS(v) \
HELPER v raised_##v(v x) { return x + only_##v(x <= -half_turn, turn); } \
HELPER v lowered_##v(v x) { return x - only_##v(half_turn < x, turn); } \

TURNS(wide)
#if LANES > 1
TURNS(four)
#endif

#define low(joint) (lowest[joint - 1] - slack(joint - 1))
#define high(joint) (highest[joint - 1] + slack(joint - 1))
/* How far a joint is beyond its limits; whether by rounding, perhaps. */
#define grazes(x) (abs_wide((x) - 5e-07) <= 5e-07)
#define grazes_four(x) (abs_four((x) - 5e-07) <= 5e-07)
#define beyond(x, joint) maximum_wide(low(joint) - (x), (x) - high(joint))
#define beyond_four(x, joint) maximum_four(low(joint) - (x), (x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.2755, /* joint offset 1 [m] */
    d2 = 0.0016, /* joint offset 2 [m] */
    a2 = 0.41, /* link length 2 [m] */
    d3 = 0.0114, /* joint offset 3 [m] */
    d4 = 0.31105, /* joint offset 4 [m] */
    d6 = 0.26375, /* joint offset 6 [m] */
    free_limit_squared2 = 1.6212928899999995e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 4.026528144692397e-07, /* a root of nothing, by rounding [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    longest3 = 0.5199131025, /* square of the longest reach [m^2] */
    shortest3 = 0.009791102499999996, /* square of the shortest reach [m^2] */
    boundary3 = 9.367415598763348e-14, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.5199131024999816, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.009791102500002518, /* the shortest, where branches merge [m^2] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset6 = -1.5707963267948966, /* offset of joint 6 [rad] */
    k1 = -0.0098, /* d2 - d3 [m] */
    k2 = 9.604000000000001e-05, /* k1^2 [m^2] */
    k3 = 2.495668000016213e-15, /* reach_slack1 * (reach_slack1 - k1 * 2) [m^2] */
    k4 = 2.4956680000016213e-16, /* merge_slack1 * (merge_slack1 - k1 * 2) [m^2] */
    k5 = 0.7853608733212912, /* 1 / arm_size1 [m^-1] */
    k6 = 0.255061, /* 2 * d4 * a2 [m^2] */
    k7 = 0.26485210249999996, /* a2^2 + d4^2 [m^2] */
    k8 = 15.371345486276748, /* 1 / (k6^2) [m^-4] */
    m1 = 2.4956680000016215e-13, /* 1000 * k4 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 9.401396550145706e-12,
    m5 = 2.628590635164551e-16, /* doubt_limit_squared2^2 [m^4] */
    m6 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m3 = 1.2195121951219514, m4 = 0.08700963109756096;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const kinova_j2s6s300_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -6.283185307179586, 0.8203047484373349, 0.33161255787892263, -6.283185307179586,
    0.5235987755982988, -6.283185307179586,
};
static const double highest[6] = {
    6.283185307179586, 5.462880558742252, 5.951572749300664, 6.283185307179586, 5.759586531581287,
    6.283185307179586,
};
#define slack(joint) 1e-09 /* of limits */

void kinova_j2s6s300_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, v3 = s1 * c2, y2_x = c1 * s2,
        v4 = s1 * s2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 + y2_x * s3, v6 = v3 * c3 + v4 * s3,
        x3_z = c2 * s3 - s2 * c3, v7 = c2 * c3 + s2 * s3, z3_x = x2_x * s3 - y2_x * c3,
        z3_y = v4 * c3 - v3 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4, v8 = v6 * c4 + c1 * s4,
        x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4, z4_y = c1 * c4 - v6 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = z3_y * s5 - v8 * c5, x5_z = x4_z * c5 - v7 * s5, z6_x = z3_x * c5 - x4_x * s5,
        z6_y = z3_y * c5 + v8 * s5, z5_z = v7 * c5 + x4_z * s5, v9 = q[5] + offset6;
    const double c6 = cos(v9), s6 = sin(v9);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = x5_x * s6 - z4_x * c6; T[2] = z6_x;
    T[3] = x2_x * a2 - s1 * d2 + s1 * d3 - z3_x * d4 - -z6_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = x5_y * s6 - z4_y * c6; T[6] = z6_y;
    T[7] = c1 * d3 - (v3 * a2 + c1 * d2) - z3_y * d4 + z6_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = x5_z * s6 - z4_z * c6; T[10] = -z5_z;
    T[11] = d1 - s2 * a2 + v7 * d4 - z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kinova_j2s6s300_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, v3 = s1 * c2, y2_x = c1 * s2,
        v4 = s1 * s2, p2_z = d1 - s2 * a2, p2_x = x2_x * a2 - s1 * d2, v5 = v3 * a2 + c1 * d2,
        v6 = q[2] + offset3;
    const double c3 = cos(v6), s3 = sin(v6), x3_x = x2_x * c3 + y2_x * s3, v7 = v3 * c3 + v4 * s3,
        x3_z = c2 * s3 - s2 * c3, v8 = c2 * c3 + s2 * s3, p3_x = p2_x + s1 * d3,
        p3_y = c1 * d3 - v5, z3_x = x2_x * s3 - y2_x * c3, z3_y = v4 * c3 - v3 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p3_x - z3_x * d4, p4_y = p3_y - z3_y * d4, p4_z = p2_z + v8 * d4,
        z4_y = c1 * c4 - v7 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z6_y = z3_y * c5 + (v7 * c4 + c1 * s4) * s5,
        z5_z = v8 * c5 + x3_z * c4 * s5, z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        p6_x = p4_x - z5_x * d6, p6_y = p4_y + z6_y * d6, p6_z = p4_z - z5_z * d6, v9 = p6_z - d1,
        v10 = p6_z - p2_z, v11 = p6_x - p3_x, v12 = p6_y - p3_y, v13 = p6_x - p4_x,
        v14 = p6_y - p4_y, v15 = p6_z - p4_z;
    J[0] = p6_y; J[1] = c1 * v9; J[2] = -(c1 * v10); J[3] = z3_y * v10 + v8 * v12;
    J[4] = z4_y * v15 - z4_z * v14; J[5] = -(z6_y * v15 + z5_z * v14);
    J[6] = -p6_x; J[7] = -(s1 * v9); J[8] = s1 * v10; J[9] = -(v8 * v11 + z3_x * v10);
    J[10] = z4_z * v13 - z4_x * v15; J[11] = z5_z * v13 - z5_x * v15;
    J[12] = 0.0; J[13] = s1 * p6_y - c1 * p6_x; J[14] = c1 * (p6_x - p2_x) - s1 * (v5 + p6_y);
    J[15] = z3_x * v12 - z3_y * v11; J[16] = z4_x * v14 - z4_y * v13;
    J[17] = z5_x * v14 + z6_y * v13;
    J[18] = 0.0; J[19] = s1; J[20] = -s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = -c1; J[27] = z3_y; J[28] = z4_y; J[29] = -z6_y;
    J[30] = -1.0; J[31] = 0.0; J[32] = 0.0; J[33] = -v8; J[34] = z4_z; J[35] = z5_z;
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
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
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
    const double gap = turn - (high - low), over = value - high;
    const double rest = over - turn * floor(over / turn);
    const double off = rest >= gap ? 0.0 : rest <= gap - rest ? rest : rest - gap;
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of a row. */
static double beyond_limits(const double values[6])
{
    double sum = 0.0;
    for (int i = 0; i < 6; i++)
        sum += fabs(overshoot(i, values[i]));
    return sum;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[48], wide_mask kind[8])
{
    ENTRIES(wide);

    /* theta1 */
    const wide X1 = d6 * T13 - T14, wy = d6 * T23 - T24, N1 = X1 * X1 + wy * wy, D1 = N1 - k2,
        w1 = sqrt_wide(D1), v1 = w1 - w1, inverse1 = 1.0 / N1, v2 = inverse1 * (k1 * wy),
        c1_p = v2 - w1 * (X1 * inverse1), c1_m = v2 - w1 * (inverse1 * -X1),
        v3 = inverse1 * (k1 * X1), s1_p = v3 + w1 * (wy * inverse1),
        s1_m = v3 + w1 * (inverse1 * -wy);

    /* theta3 */
    const wide Z1_3 = d1 + (d6 * T33 - T34), N3 = D1 + Z1_3 * Z1_3,
        D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt_wide(D3), v4 = w3 - w3,
        v5 = k6 * (N3 - k7), v6 = k8 * v5, v7 = k6 * w3, c3 = k8 * v7;

    /* theta2 */
    const wide X1_2 = a2 + d4 * v6, X2_2 = d4 * c3, v8 = Z1_3 * X1_2, v9 = w1 * X2_2, v10 = v8 + v9,
        v11 = v8 - v9, v12 = m4 + m3 * N3, v13 = Z1_3 * v12, v14 = w3 * (m3 * w1),
        S2_pp = v13 + v14, S2_pm = v13 - v14, v15 = w1 * X1_2, v16 = Z1_3 * X2_2, v17 = v15 - v16,
        v18 = v15 + v16, v19 = w3 * (m3 * Z1_3), v20 = w1 * v12, C2_pp = v20 - v19,
        C2_pm = v19 + v20, v21 = S2_pp * S2_pp, v22 = v21 + C2_pp * C2_pp,
        v23 = S2_pm * S2_pm + C2_pm * C2_pm, v24 = v21 - C2_pp * -C2_pp, w2_pp = sqrt_wide(v22),
        w2_pm = sqrt_wide(v23), w2_mm = sqrt_wide(v24), v25 = 1.0 / v22, v26 = 1.0 / v23,
        v27 = 1.0 / v24;

    /* theta4 */
    const wide v28 = v6 * v10, c2m3_pp = w2_pp * (v25 * (c3 * v17 - v28)),
        v29 = w2_pm * (v26 * (c3 * v18 + v6 * v11)), v30 = w2_mm * (v27 * (v28 + c3 * -v17)),
        v31 = c3 * v10, s2m3_pp = w2_pp * (v25 * (v31 + v6 * v17)), v32 = v6 * v18 - c3 * v11,
        s2m3_pm = w2_pm * (v26 * v32), s2m3_mp = w2_pm * (v26 * -v32),
        s2m3_mm = w2_mm * (v27 * (v6 * -v17 - v31)), v33 = T13 * c1_p - T23 * s1_p,
        v34 = T13 * c1_m - T23 * s1_m, X4_pp = T33 * s2m3_pp - c2m3_pp * v33,
        X4_pm = T33 * s2m3_pm + v29 * v33, X4_mp = T33 * s2m3_mp + v29 * v34,
        X4_mm = T33 * s2m3_mm + v30 * v34, v35 = T23 * c1_p + T13 * s1_p,
        v36 = T23 * c1_m + T13 * s1_m, v37 = v35 * v35, v38 = v36 * v36, v39 = v37 + X4_pp * X4_pp,
        v40 = v37 + X4_pm * X4_pm, v41 = v38 + X4_mp * X4_mp, v42 = v38 + X4_mm * X4_mm,
        angle1 = atan2_wide(-v35, -X4_pp), angle2 = atan2_wide(-v35, -X4_pm),
        angle3 = atan2_wide(-v36, -X4_mp), angle4 = atan2_wide(-v36, -X4_mm),
        v43 = signed_wide(half_turn, -v35), v44 = signed_wide(half_turn, -v36);

    /* theta5 */
    const wide angle5 = atan2_wide(-sqrt_wide(v39), -(T33 * c2m3_pp + s2m3_pp * v33)),
        v45 = T33 * v29, angle6 = atan2_wide(-sqrt_wide(v40), v45 - s2m3_pm * v33),
        angle7 = atan2_wide(-sqrt_wide(v41), v45 - s2m3_mp * v34),
        angle8 = atan2_wide(-sqrt_wide(v42), T33 * v30 - s2m3_mm * v34);

    /* theta6 */
    const wide v46 = c1_p * T22 + s1_p * T12, v47 = c1_m * T22 + s1_m * T12,
        v48 = c1_p * T12 - s1_p * T22, v49 = c1_m * T12 - s1_m * T22, v50 = c1_p * T21 + s1_p * T11,
        v51 = c1_m * T21 + s1_m * T11, v52 = c1_p * T11 - s1_p * T21, v53 = c1_m * T11 - s1_m * T21,
        s6_pp = -X4_pp * v50 - v35 * (c2m3_pp * v52 - s2m3_pp * T31),
        s6_pm = v35 * (v29 * v52 + s2m3_pm * T31) - X4_pm * v50,
        s6_mp = v36 * (v29 * v53 + s2m3_mp * T31) - X4_mp * v51,
        s6_mm = v36 * (v30 * v53 + s2m3_mm * T31) - X4_mm * v51;

    /* joint values */
    const wide angle9 = atan2_wide(s1_p, c1_p), v54 = angle9 - offset1,
        angle10 = atan2_wide(s1_m, c1_m), v55 = angle10 - offset1,
        angle11 = atan2_wide(S2_pp, C2_pp), v56 = angle11 - offset2,
        angle12 = atan2_wide(S2_pm, C2_pm), v57 = angle12 - offset2,
        angle13 = atan2_wide(S2_pm, -C2_pm), v58 = angle13 - offset2,
        angle14 = atan2_wide(S2_pp, -C2_pp), v59 = angle14 - offset2, q2__pp = raised_wide(v56),
        q2__pm = raised_wide(v57), q2__mp = raised_wide(v58), q2__mm = raised_wide(v59),
        angle15 = atan2_wide(-v5, v7), v60 = angle15 - offset3,
        v61 = signed_wide(half_turn, -v5) - angle15 - offset3, q3__p = raised_wide(v60),
        q3__m = raised_wide(v61),
        angle16 = atan2_wide(s6_pp, v35 * (c2m3_pp * v48 - s2m3_pp * T32) + X4_pp * v46),
        angle17 = atan2_wide(s6_pm, X4_pm * v46 - v35 * (v29 * v48 + s2m3_pm * T32)),
        angle18 = atan2_wide(s6_mp, X4_mp * v47 - v36 * (v29 * v49 + s2m3_mp * T32)),
        angle19 = atan2_wide(s6_mm, X4_mm * v47 - v36 * (v30 * v49 + s2m3_mm * T32)),
        v62 = angle16 - offset6, v63 = angle16 - signed_wide(half_turn, s6_pp) - offset6,
        v64 = angle17 - offset6, v65 = angle17 - signed_wide(half_turn, s6_pm) - offset6,
        v66 = angle18 - offset6, v67 = angle18 - signed_wide(half_turn, s6_mp) - offset6,
        v68 = angle19 - offset6, v69 = angle19 - signed_wide(half_turn, s6_mm) - offset6,
        v70 = q2__pp + only_wide(q2__pp < low(2), turn),
        v71 = q2__pm + only_wide(q2__pm < low(2), turn),
        v72 = q2__mp + only_wide(q2__mp < low(2), turn),
        v73 = q2__mm + only_wide(q2__mm < low(2), turn), v74 = beyond(v70, 2), v75 = beyond(v71, 2),
        v76 = beyond(v72, 2), v77 = beyond(v73, 2), v78 = low(2) - q2__pp, v79 = low(2) - q2__pm,
        v80 = low(2) - q2__mp, v81 = low(2) - q2__mm, v82 = pick_wide(v78 < v74, v78, v74),
        v83 = pick_wide(v79 < v75, v79, v75), v84 = pick_wide(v80 < v76, v80, v76),
        v85 = pick_wide(v81 < v77, v81, v77), q2_ppp = pick_wide(0.0 < v82, q2__pp, v70),
        q2_pmp = pick_wide(0.0 < v83, q2__pm, v71), q2_mpp = pick_wide(0.0 < v84, q2__mp, v72),
        q2_mmp = pick_wide(0.0 < v85, q2__mm, v73), v86 = q3__p + only_wide(q3__p < low(3), turn),
        v87 = q3__m + only_wide(q3__m < low(3), turn), v88 = beyond(v86, 3), v89 = beyond(v87, 3),
        v90 = low(3) - q3__p, v91 = low(3) - q3__m, v92 = pick_wide(v90 < v88, v90, v88),
        v93 = pick_wide(v91 < v89, v91, v89), v94 = angle5 + only_wide(angle5 < low(5), turn),
        v95 = only_wide(-angle5 < low(5), turn) - angle5,
        v96 = angle6 + only_wide(angle6 < low(5), turn),
        v97 = only_wide(-angle6 < low(5), turn) - angle6,
        v98 = angle7 + only_wide(angle7 < low(5), turn),
        v99 = only_wide(-angle7 < low(5), turn) - angle7,
        v100 = angle8 + only_wide(angle8 < low(5), turn),
        v101 = only_wide(-angle8 < low(5), turn) - angle8, v102 = beyond(v94, 5),
        v103 = beyond(v95, 5), v104 = beyond(v96, 5), v105 = beyond(v97, 5), v106 = beyond(v98, 5),
        v107 = beyond(v99, 5), v108 = beyond(v100, 5), v109 = beyond(v101, 5),
        v110 = low(5) - angle5, v111 = low(5) + angle5, v112 = low(5) - angle6,
        v113 = low(5) + angle6, v114 = low(5) - angle7, v115 = low(5) + angle7,
        v116 = low(5) - angle8, v117 = low(5) + angle8, v118 = pick_wide(v110 < v102, v110, v102),
        v119 = pick_wide(v111 < v103, v111, v103), v120 = pick_wide(v112 < v104, v112, v104),
        v121 = pick_wide(v113 < v105, v113, v105), v122 = pick_wide(v114 < v106, v114, v106),
        v123 = pick_wide(v115 < v107, v115, v107), v124 = pick_wide(v116 < v108, v116, v108),
        v125 = pick_wide(v117 < v109, v117, v109), q1_ppp = v4 + raised_wide(v54),
        q1_mpp = v4 + raised_wide(v55), q3_ppp = v1 + pick_wide(0.0 < v92, q3__p, v86),
        q3_pmp = v1 + pick_wide(0.0 < v93, q3__m, v87), v126 = maximum_wide(v82, v92),
        v127 = maximum_wide(v83, v93), v128 = maximum_wide(v84, v92), v129 = maximum_wide(v85, v93),
        excess_ppp = maximum_wide(v118, v126), excess_ppm = maximum_wide(v119, v126),
        excess_pmp = maximum_wide(v120, v127), excess_pmm = maximum_wide(v121, v127),
        excess_mpp = maximum_wide(v122, v128), excess_mpm = maximum_wide(v123, v128),
        excess_mmp = maximum_wide(v124, v129), excess_mmm = maximum_wide(v125, v129);

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = angle1;
    q[4] = pick_wide(0.0 < v118, angle5, v94); q[5] = lowered_wide(v62);
    kind[0] = kind_of(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = angle1 - v43;
    q[10] = pick_wide(0.0 < v119, -angle5, v95); q[11] = lowered_wide(v63);
    kind[1] = kind_of(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = angle2;
    q[16] = pick_wide(0.0 < v120, angle6, v96); q[17] = lowered_wide(v64);
    kind[2] = kind_of(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = angle2 - v43;
    q[22] = pick_wide(0.0 < v121, -angle6, v97); q[23] = lowered_wide(v65);
    kind[3] = kind_of(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_ppp; q[27] = angle3;
    q[28] = pick_wide(0.0 < v122, angle7, v98); q[29] = lowered_wide(v66);
    kind[4] = kind_of(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_ppp; q[33] = angle3 - v44;
    q[34] = pick_wide(0.0 < v123, -angle7, v99); q[35] = lowered_wide(v67);
    kind[5] = kind_of(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_pmp; q[39] = angle4;
    q[40] = pick_wide(0.0 < v124, angle8, v100); q[41] = lowered_wide(v68);
    kind[6] = kind_of(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_pmp; q[45] = angle4 - v44;
    q[46] = pick_wide(0.0 < v125, -angle8, v101); q[47] = lowered_wide(v69);
    kind[7] = kind_of(q[42], 0.0 < excess_mmm);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v42 <= m6) | (v24 <= m5) | (v41 <= m6) | (v40 <= m6) | (v23 <= m5) |
        (v39 <= m6) | (abs_wide(D1) <= m1) | (abs_wide(D3 * (k5 * w1)) <= m2) | (v22 <= m5)) |
        (grazes(excess_mmm) | grazes(excess_mmp) | grazes(excess_mpm) | grazes(excess_mpp) |
        grazes(excess_pmm) | grazes(excess_pmp) | grazes(excess_ppp) | grazes(excess_ppm));
}

#if LANES > 1
static const double
    m7 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[8][6], unsigned char status[8])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double X1 = d6 * T13 - T14, wy = d6 * T23 - T24, N1 = X1 * X1 + wy * wy, D1 = N1 - k2,
        w1 = sqrt(D1), v1 = w1 - w1, inverse1 = 1.0 / N1, v2 = inverse1 * (k1 * wy);
    const four c1 = v2 - w1 * (inverse1 * (e1 * X1));
    const double v3 = inverse1 * (k1 * X1);
    const four s1 = v3 + w1 * (inverse1 * (e1 * wy));

    /* theta3 */
    const double Z1_3 = d1 + (d6 * T33 - T34), N3 = D1 + Z1_3 * Z1_3,
        D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3), v4 = w3 - w3, v5 = k6 * (N3 - k7),
        v6 = k8 * v5, v7 = k6 * w3, c3 = k8 * v7;

    /* theta2 */
    const double X1_2 = a2 + d4 * v6, X2_2 = d4 * c3, v8 = Z1_3 * X1_2, v9 = w1 * X2_2;
    const four v10 = e1 * e2, v11 = v8 + v9 * v10;
    const double v12 = m4 + m3 * N3, v13 = Z1_3 * v12;
    const four S2 = v13 + w3 * (m3 * (w1 * v10));
    const double v14 = w1 * X1_2, v15 = Z1_3 * X2_2;
    const four v16 = e1 * v14, v17 = e2 * v15, v18 = v16 - v17, v19 = w3 * (m3 * (e2 * Z1_3)),
        v20 = w1 * (e1 * v12), C2 = v20 - v19, v21 = S2 * S2 + C2 * C2, w2 = sqrt_four(v21),
        v22 = 1.0 / v21;

    /* theta4 */
    const four v23 = e2 * c3, c2m3 = w2 * (v22 * (v18 * v23 - v6 * v11)),
        s2m3 = w2 * (v22 * (v11 * v23 + v6 * v18)), v24 = T13 * c1 - T23 * s1,
        X4 = T33 * s2m3 - c2m3 * v24, v25 = T23 * c1 + T13 * s1, v26 = v25 * v25,
        v27 = v26 + X4 * X4, v28 = signed_four(half_turn, -v25);

    /* theta6 */
    const four v29 = c1 * T22 + s1 * T12, v30 = c1 * T12 - s1 * T22, v31 = c1 * T21 + s1 * T11,
        v32 = c1 * T11 - s1 * T21, s6 = -X4 * v31 - v25 * (c2m3 * v32 - s2m3 * T31);

    /* joint values */
    const double v35 = copysign(half_turn, -v5);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | ((v21 <= m5) | (v27 <= m6))) |
        (unsigned)((fabs(D1) <= m1) | (fabs(D3 * (k5 * w1)) <= m2)))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(s1, all_four(-v5), 0, 5, 2, 3), shuffle(c1,
        all_four(v7), 0, 5, 2, 3)), ratio2 = ratio_four(S2, C2), ratio3 = ratio_four(-v25, -X4),
        ratio4 = ratio_four(s6, v25 * (c2m3 * v30 - s2m3 * T32) + X4 * v29),
        ratio5 = ratio_four(-sqrt_four(v27), -(T33 * c2m3 + s2m3 * v24));
    const four packed1 = angle_four(ratio1), angle3 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle5 = shuffle(packed1, packed1, 1, 1, 1, 1), angle4 = angle_four(ratio2),
        angle1 = angle_four(ratio3), angle6 = angle_four(ratio4), angle2 = angle_four(ratio5);
    const four q4_m = angle1 - v28, v33 = angle3 - offset1, v34 = angle4 - offset2,
        q2_ = raised_four(v34), v36 = e2 * angle5 + v35 * (m7 * (1.0 - e2)) - offset3,
        q3_ = raised_four(v36), v37 = angle6 - offset6,
        v38 = angle6 - signed_four(half_turn, s6) - offset6, q6_p = lowered_four(v37),
        q6_m = lowered_four(v38), v39 = q2_ + only_four(q2_ < low(2), turn),
        v40 = beyond_four(v39, 2), v41 = low(2) - q2_, v42 = pick_four(v41 < v40, v41, v40),
        q2_p = pick_four(0.0 < v42, q2_, v39), v43 = q3_ + only_four(q3_ < low(3), turn),
        v44 = beyond_four(v43, 3), v45 = low(3) - q3_, v46 = pick_four(v45 < v44, v45, v44),
        v47 = angle2 + only_four(angle2 < low(5), turn),
        v48 = only_four(-angle2 < low(5), turn) - angle2, v49 = beyond_four(v47, 5),
        v50 = beyond_four(v48, 5), v51 = low(5) - angle2, v52 = low(5) + angle2,
        v53 = pick_four(v51 < v49, v51, v49), v54 = pick_four(v52 < v50, v52, v50),
        q5_p = pick_four(0.0 < v53, angle2, v47), q5_m = pick_four(0.0 < v54, -angle2, v48),
        q1_p = v4 + raised_four(v33), q3_p = v1 + pick_four(0.0 < v46, q3_, v43),
        v55 = maximum_four(v42, v46), excess_p = maximum_four(v53, v55),
        excess_m = maximum_four(v54, v55);
    const four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (bits_four((grazes_four(excess_p) | grazes_four(excess_m))))
        return -1;

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, q2_p, q3_p, angle1);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], q5_p, q6_p);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, q2_p, q3_p, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], q5_m, q6_m);
    const unsigned long long none1 = (bits_four(q1_p != q1_p) * 0x20204040808101ull &
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

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const double X1 = T13 * d6 - T14;
    const double wy = d6 * T23 - T24;
    const double N1 = X1 * X1 + wy * wy;
    const int free1 = N1 <= free_limit_squared2;
    const double D1 = N1 - k2;
    const int apart1 = k4 < D1;
    if (!(-k3 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : -(k1 * sqrt(N1))));
    const double v1 = X1 * k1, v2 = wy * k1, v3 = seed[0] + offset1;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = d6 * T33 - T34;
    const double Z1_3 = wz + d1;
    const double v4 = Z1_3 * Z1_3, v5 = free1 ? 1.0 : (apart1 ? w1 : least_root1) * k5;

    /* theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double v9 = seed[1] + offset2;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(v3) : inverse1 * (v2 - X1 * root1),
            s1 = free1 ? sin(v3) : inverse1 * (v1 + wy * root1);

        /* theta3 */
        const double N3 = v4 + root1 * root1;
        const double K3 = N3 - k7;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= D3 * v5)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v6 = k6 * K3 * k8;

        /* theta2 */
        const double X1_2 = a2 + d4 * v6;
        const double v7 = Z1_3 * X1_2, v8 = root1 * X1_2;

        /* theta4, type 2: U4[3, 3] */
        const double v10 = T13 * c1 - T23 * s1, v11 = T23 * c1 + T13 * s1, v12 = v11 * v11;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v13 = T22 * c1 + T12 * s1, v14 = T12 * c1 - T22 * s1,
            v16 = T21 * c1 + T11 * s1, v17 = T11 * c1 - T21 * s1;

        /* joint values */
        const double q1 = wrap(atan2(s1, c1) - offset1);

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double c3 = k8 * (k6 * (w3 * e2));

            /* theta2 */
            const double X2_2 = d4 * c3;
            const double S2 = v7 + root1 * X2_2;
            const double C2 = v8 - Z1_3 * X2_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v9) : C2 * factor2, s2 = free2 ? sin(v9) : S2 * factor2;

            /* theta4 */
            const double c2m3 = c3 * c2 - v6 * s2;
            const double s2m3 = c3 * s2 + v6 * c2;
            const double X4 = T33 * s2m3 - c2m3 * v10;
            const double w4 = sqrt(X4 * X4 + v12);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta6 */
            const double v15 = c2m3 * v14 - T32 * s2m3, v18 = c2m3 * v17 - T31 * s2m3;

            /* joint values */
            const double q2 = wrap(atan2(s2, c2) - offset2);
            const double q3 = wrap(atan2(-v6, c3) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : -(v11 * factor4);
                const double q4 = atan2(s4, c4);

                /* theta5, type 3: U4[2, 3] and U4[1, 3] */
                const double q5 = atan2(-(w4 * e3), -(T33 * c2m3 + s2m3 * v10));

                /* theta6 */
                const double s6 = c4 * v16 + s4 * v18;

                /* joint values */
                const double q6 = wrap(atan2(s6, -(c4 * v13 + s4 * v15)) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
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
        search.start = fmod(seed[joint], turn);
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
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.7854, 0.7854, 0.7854, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    kinova_j2s6s300_fk(x, P);
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
    kinova_j2s6s300_jacobian(x, J);
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

/* The same of a value as it stands: it might be turned. */
static double past_an_end(int joint, double value)
{
    const double low = lowest[joint], high = highest[joint];
    if (high - low < 6.183185307179587)
        return overshoot(joint, value);
    const double off = value - fmin(fmax(value, low), high);
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of all joints. */
static double past_ends(const double values[6])
{
    double sum = 0.0;
    for (int i = 0; i < 6; i++)
        sum += fabs(past_an_end(i, values[i]));
    return sum;
}

/* A joint value turned inside its limits, or next to the end that it and the seed are at. */
static double at_an_end(int joint, double value, double seed)
{
    const double near = value + turn * floor((seed - value) / turn + 0.5);
    const double past = fabs(past_an_end(joint, near));
    if (0.0 < past && past < 0.01 && fabs(near - seed) < 0.15)
        return near;
    const double off = overshoot(joint, value);
    if (off == 0.0 || fabs(off) > 0.01)
        return turned(joint, value, value);
    return off + (off > 0.0 ? highest : lowest)[joint];
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
            const double off = pace[i] > 0.0 ? past_an_end(i, x[i]) : 0.0;
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

/* Takes joint values onto ends that they are past or, as two may not stand there, inside. */
static int lead_inside(const double T[16], double enough, double most, double q[6])
{
    double x[6], e[6];
    if (settle(T, enough, most, q))
        return 1;
    int past = 0;
    for (int i = 0; i < 6; i++)
        past += fabs(past_an_end(i, q[i])) > 0.0;
    enough = off_pose(T, q, e) + 1e-14;
    for (double farther = 2.0; past > 1 && farther <= 16.0; farther *= 2.0) {
        for (int i = 0; i < 6; i++)
            x[i] = q[i] - farther * past_an_end(i, q[i]);
        if (!settle(T, enough, most, x) || past_ends(x) > 0.0)
            continue;
        take(x, q);
        return 1;
    }
    return 0;
}

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const double T[16], int row, int far, double rows[8][6], const unsigned char status[8])
{
    double x[6], half[6], to[6], *q = rows[row];
    const double beyond = past_ends(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!lead_inside(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 8; k++)
        if (status[k] != NONE && past_ends(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

/* Leads rows of nested roots to solutions, ends those that rounding alone tells from earlier ones:
 * half way the arm is singular. */
static void tell_once(const double T[16], double q[8][6], unsigned char status[8])
{
    const int held[6] = { 0 };
    for (int n = 0; n < 8 * 8; n++) {
        double half[6], e[6], *row = q[n / 8];
        const int k = n % 8;
        int ends = k == 0 && off_pose(T, row, e) > 1e-11 && !settle(T, 1e-12, 0.15, row);
        if (0 < k && k <= n / 8 && half_way(q[k - 1], row, half) < 0.001 && !isnan(half[0])) {
            for (int i = 0; i < 3; i++) {
                off_pose(T, half, e);
                add_step(held, 1e-13, e, half);
            }
            ends = off_pose(T, half, e) <= 1e-14;
        }
        for (int i = 0; i < 6 && ends; i++) {
            status[n / 8] = NONE;
            row[i] = NAN;
        }
    }
}

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const double T[16], const double seed[6], double q[8][6],
    unsigned char status[8])
{
    double x[6], half[6], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    for (int i = 0; i < 6; i++) {
        const double seen = seed[i], past = fabs(past_an_end(i, seen));
        const double here = past <= 0.15 ? seen : turned(i, seen, seen);
        x[i] = here - past_an_end(i, here);
    }
    if (!settle(T, 1e-12, 0.15, x) || (past_ends(x) > 1e-09 && !lead_inside(T, NAN, 0.15, x)))
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
    if (nearest > 1e-06 || past_ends(q[place]) > 0.0)
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
    tell_once(pose, q, status);
    for (int row = 0; row < 8; row++)
        for (int i = 0; i < 6; i++)
            q[row][i] = at_an_end(i, q[row][i], seed[i]);
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

int kinova_j2s6s300_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int kinova_j2s6s300_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = kinova_j2s6s300_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 6; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    int past = 0; /* joints past an end and turned */
    for (int i = 0; i < 6 && valid; i++)
        if (fmin(highest[i] - q_seed[i], q_seed[i] - lowest[i]) < 0.15)
            for (int row = 0; row < 8; row++)
                past += status[row] == OK
                    && past_an_end(i, at_an_end(i, all[row][i], q_seed[i])) != 0.0;
    if (past)
        (void)ik_carefully(T, q_seed, all, status);
    for (int row = 0; row < 8 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 6; i++) {
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

void kinova_j2s6s300_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)kinova_j2s6s300_ik(
                    T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)kinova_j2s6s300_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
