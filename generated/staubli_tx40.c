/* staubli_tx40: Stäubli TX40
 *
 * Inverse kinematics, generated from robots/staubli_tx40.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/staubli_tx40.yaml. The formulas and where they come from:
 * staubli_tx40.md.
 */
#include "staubli_tx40.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = STAUBLI_TX40_OK, NONE = STAUBLI_TX40_UNREACHABLE, FREE = STAUBLI_TX40_FREE_JOINT,
    OUT = STAUBLI_TX40_OUT_OF_LIMITS, INVALID = STAUBLI_TX40_INVALID_POSE
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

#ifndef STAUBLI_TX40_LIBM
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
 * -DSTAUBLI_TX40_SCALAR. With -DSTAUBLI_TX40_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(STAUBLI_TX40_SCALAR) && !defined(STAUBLI_TX40_LIBM)
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
#ifdef STAUBLI_TX40_LIBM /* half the time of atan2 */
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

TURNS(wide)
#if LANES > 1
TURNS(four)
#endif


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.32, /* joint offset 1 [m] */
    a2 = 0.225, /* link length 2 [m] */
    d3 = 0.035, /* joint offset 3 [m] */
    d4 = 0.225, /* joint offset 4 [m] */
    d6 = 0.065, /* joint offset 6 [m] */
    free_limit_squared2 = 7.5690000000000015e-25, /* square of a length that fixes no angle [m^2] */
    least_root1 = 2.75118156434649e-07, /* a root of nothing, by rounding [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    longest3 = 0.2025, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    boundary3 = 1.5849821455311018e-14, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.20249999999999216, /* the longest, where branches merge [m^2] */
    shortest3_apart = 7.569000000000003e-29, /* the shortest, where branches merge [m^2] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    k1 = 0.0012250000000000002, /* d3^2 [m^2] */
    k2 = 6.09000000000757e-15, /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
    k3 = 6.090000000000759e-16, /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
    k4 = 1.1494252873563218, /* 1 / arm_size1 [m^-1] */
    k5 = 0.10125, /* 2 * d4 * a2 [m^2] */
    k6 = 97.54610577655845, /* 1 / (k5^2) [m^-4] */
    m1 = 6.090000000000759e-13, /* 1000 * k3 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 1.5906026495925924e-12,
    m4 = 5.728976100000003e-17, /* doubt_limit_squared2^2 [m^4] */
    m7 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m3 = 2.2222222222222223, m5 = 21.947873799725652, m6 = 4.4444444444444455;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const staubli_tx40_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void staubli_tx40_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 - v3 * s3, x3_y = x2_y * c3 - v4 * s3,
        x3_z = s2 * c3 + c2 * s3, z3_x = v3 * c3 + x2_x * s3, z3_y = v4 * c3 + x2_y * s3,
        z3_z = s2 * s3 - c2 * c3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), x4_x = x3_x * c4 + s1 * s4, x4_y = x3_y * c4 - c1 * s4,
        x4_z = x3_z * c4, z4_y = c1 * c4 + x3_y * s4, z4_z = x3_z * s4, z4_x = x3_x * s4 - s1 * c4,
        v7 = q[4] + offset5;
    const double c5 = cos(v7), s5 = sin(v7), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z5_x = x4_x * s5 - z3_x * c5,
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = x2_x * a2 + s1 * d3 + z3_x * d4 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = x2_y * a2 - c1 * d3 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = z4_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + s2 * a2 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void staubli_tx40_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 - v3 * s3, x3_y = x2_y * c3 - v4 * s3,
        x3_z = s2 * c3 + c2 * s3, z3_x = v3 * c3 + x2_x * s3, z3_y = v4 * c3 + x2_y * s3,
        p3_x = p2_x + s1 * d3, p3_y = p2_y - c1 * d3, z3_z = s2 * s3 - c2 * c3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), z4_y = c1 * c4 + x3_y * s4, z4_z = x3_z * s4,
        p4_x = p3_x + z3_x * d4, p4_y = p3_y + z3_y * d4, p4_z = p2_z + z3_z * d4,
        z4_x = x3_x * s4 - s1 * c4, v7 = q[4] + offset5;
    const double c5 = cos(v7), s5 = sin(v7), z5_x = (x3_x * c4 + s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 - c1 * s4) * s5 - z3_y * c5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        p6_x = p4_x + z5_x * d6, p6_y = p4_y + z5_y * d6, p6_z = p4_z + z5_z * d6, v8 = p6_z - d1,
        v9 = p6_z - p2_z, v10 = p6_x - p3_x, v11 = p6_y - p3_y, v12 = p6_x - p4_x,
        v13 = p6_y - p4_y, v14 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = -(c1 * v8); J[2] = -(c1 * v9); J[3] = z3_y * v9 - z3_z * v11;
    J[4] = z4_y * v14 - z4_z * v13; J[5] = z5_y * v14 - z5_z * v13;
    J[6] = p6_x; J[7] = -(s1 * v8); J[8] = -(s1 * v9); J[9] = z3_z * v10 - z3_x * v9;
    J[10] = z4_z * v12 - z4_x * v14; J[11] = z5_z * v12 - z5_x * v14;
    J[12] = 0.0; J[13] = s1 * p6_y + c1 * p6_x; J[14] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x);
    J[15] = z3_x * v11 - z3_y * v10; J[16] = z4_x * v13 - z4_y * v12;
    J[17] = z5_x * v13 - z5_y * v12;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[48], wide_mask kind[8])
{
    ENTRIES(wide);

    /* theta1 */
    const wide X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy, D1 = N1 - k1,
        w1 = sqrt_wide(D1), v1 = w1 - w1, inverse1 = 1.0 / N1, v2 = inverse1 * (d3 * wy),
        v3 = v2 + w1 * (X1 * inverse1), v4 = v2 + w1 * (inverse1 * -X1), v5 = inverse1 * (d3 * X1),
        s1_p = w1 * (wy * inverse1) - v5, s1_m = w1 * (inverse1 * -wy) - v5;

    /* theta3 */
    const wide Z1_3 = T34 - d6 * T33 - d1, N3 = D1 + Z1_3 * Z1_3,
        D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt_wide(D3), v6 = w3 - w3,
        v7 = k5 * (N3 - k5);

    /* theta2 */
    const wide v8 = m3 * (Z1_3 * N3), v9 = w3 * (m3 * w1), S2_pp = v8 - v9, S2_pm = v8 + v9,
        v10 = w3 * (m3 * Z1_3), v11 = w3 * (m3 * -Z1_3), v12 = m3 * (w1 * N3), C2_pp = v10 + v12,
        C2_pm = v11 + v12, C2_mp = v10 - v12, C2_mm = v11 - v12, v13 = S2_pp * S2_pp,
        v14 = v13 + C2_pp * C2_pp, v15 = S2_pm * S2_pm, v16 = v15 + C2_pm * C2_pm,
        v17 = v15 + C2_mp * C2_mp, v18 = v13 + C2_mm * C2_mm,
        factor2_pp = sqrt_wide(v14) * (1.0 / v14), factor2_pm = sqrt_wide(v16) * (1.0 / v16),
        factor2_mp = sqrt_wide(v17) * (1.0 / v17), factor2_mm = sqrt_wide(v18) * (1.0 / v18);

    /* theta4 */
    const wide v19 = m5 * N3, v20 = v19 - m3, v21 = m6 - v19, v22 = w1 * (N3 * (v20 + v21)),
        s23_pp = v22 - v10, s23_pm = v22 - v11, v23 = w1 * (N3 * (-v20 - v21)), s23_mp = v23 - v10,
        s23_mm = v23 - v11, v24 = T23 * s1_p - T13 * v3, v25 = T23 * s1_m - T13 * v4,
        X4_pp = S2_pm * v24 - T33 * s23_pp, X4_pm = S2_pp * v24 - T33 * s23_pm,
        X4_mp = S2_pp * v25 - T33 * s23_mp, X4_mm = S2_pm * v25 - T33 * s23_mm,
        Y4_p = T13 * s1_p + T23 * v3, Y4_m = T13 * s1_m + T23 * v4, v26 = Y4_p * Y4_p,
        v27 = Y4_m * Y4_m, v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp)),
        v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm)),
        v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp)),
        v31 = v27 + factor2_mm * (X4_mm * (factor2_mm * X4_mm));

    /* theta6 */
    const wide v32 = v3 * T22 + s1_p * T12, v33 = v4 * T22 + s1_m * T12,
        v34 = s1_p * T22 - v3 * T12, v35 = s1_m * T22 - v4 * T12, v36 = v3 * T21 + s1_p * T11,
        v37 = v4 * T21 + s1_m * T11, v38 = s1_p * T21 - v3 * T11, v39 = s1_m * T21 - v4 * T11,
        s6_pp = Y4_p * (s23_pp * T31 - S2_pm * v38) - v36 * -X4_pp,
        s6_pm = Y4_p * (s23_pm * T31 - S2_pp * v38) - v36 * -X4_pm,
        s6_mp = Y4_m * (s23_mp * T31 - S2_pp * v39) - v37 * -X4_mp,
        s6_mm = Y4_m * (s23_mm * T31 - S2_pm * v39) - v37 * -X4_mm,
        angle1 = atan2_wide(s6_pp, Y4_p * (s23_pp * T32 - S2_pm * v34) - v32 * -X4_pp),
        angle2 = atan2_wide(s6_pm, Y4_p * (s23_pm * T32 - S2_pp * v34) - v32 * -X4_pm),
        angle3 = atan2_wide(s6_mp, Y4_m * (s23_mp * T32 - S2_pp * v35) - v33 * -X4_mp),
        angle4 = atan2_wide(s6_mm, Y4_m * (s23_mm * T32 - S2_pm * v35) - v33 * -X4_mm);

    /* joint values */
    const wide angle5 = atan2_wide(s1_p, -v3), v40 = angle5 - offset1,
        angle6 = atan2_wide(s1_m, -v4), v41 = angle6 - offset1, angle7 = atan2_wide(S2_pp, C2_pp),
        v42 = angle7 - offset2, angle8 = atan2_wide(S2_pm, C2_pm), v43 = angle8 - offset2,
        angle9 = atan2_wide(S2_pm, C2_mp), v44 = angle9 - offset2,
        angle10 = atan2_wide(S2_pp, C2_mm), v45 = angle10 - offset2, q2_ppp = raised_wide(v42),
        q2_pmp = raised_wide(v43), q2_mpp = raised_wide(v44), q2_mmp = raised_wide(v45),
        angle11 = atan2_wide(v7, -(k5 * w3)), v46 = angle11 - offset3,
        v47 = signed_wide(half_turn, v7) - angle11 - offset3,
        angle12 = atan2_wide(Y4_p, factor2_pp * -X4_pp),
        angle13 = atan2_wide(Y4_p, factor2_pm * -X4_pm),
        angle14 = atan2_wide(Y4_m, factor2_mp * -X4_mp),
        angle15 = atan2_wide(Y4_m, factor2_mm * -X4_mm), v48 = signed_wide(half_turn, Y4_p),
        v49 = signed_wide(half_turn, Y4_m), v50 = angle12 - offset4, v51 = angle12 - v48 - offset4,
        v52 = angle13 - offset4, v53 = angle13 - v48 - offset4, v54 = angle14 - offset4,
        v55 = angle14 - v49 - offset4, v56 = angle15 - offset4, v57 = angle15 - v49 - offset4,
        v58 = T33 * S2_pm,
        angle16 = atan2_wide(sqrt_wide(v28), -(factor2_pp * (v58 + s23_pp * v24))),
        v59 = T33 * S2_pp,
        angle17 = atan2_wide(sqrt_wide(v29), -(factor2_pm * (v59 + s23_pm * v24))),
        angle18 = atan2_wide(sqrt_wide(v30), -(factor2_mp * (v59 + s23_mp * v25))),
        angle19 = atan2_wide(sqrt_wide(v31), -(factor2_mm * (v58 + s23_mm * v25))),
        v60 = angle16 - offset5, v61 = offset5 + angle16, v62 = angle17 - offset5,
        v63 = offset5 + angle17, v64 = angle18 - offset5, v65 = offset5 + angle18,
        v66 = angle19 - offset5, v67 = offset5 + angle19, q1_ppp = v6 + raised_wide(v40),
        q1_mpp = v6 + raised_wide(v41), q3_ppp = v1 + raised_wide(v46),
        q3_pmp = v1 + raised_wide(v47);

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = raised_wide(v50); q[4] = raised_wide(v60);
    q[5] = angle1;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = raised_wide(v51);
    q[10] = only_wide(-v61 <= -half_turn, turn) - v61;
    q[11] = angle1 - signed_wide(half_turn, s6_pp);
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = raised_wide(v52);
    q[16] = raised_wide(v62); q[17] = angle2;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = raised_wide(v53);
    q[22] = only_wide(-v63 <= -half_turn, turn) - v63;
    q[23] = angle2 - signed_wide(half_turn, s6_pm);
    kind[3] = kind_of(q[18], 0);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_ppp; q[27] = raised_wide(v54);
    q[28] = raised_wide(v64); q[29] = angle3;
    kind[4] = kind_of(q[24], 0);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_ppp; q[33] = raised_wide(v55);
    q[34] = only_wide(-v65 <= -half_turn, turn) - v65;
    q[35] = angle3 - signed_wide(half_turn, s6_mp);
    kind[5] = kind_of(q[30], 0);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_pmp; q[39] = raised_wide(v56);
    q[40] = raised_wide(v66); q[41] = angle4;
    kind[6] = kind_of(q[36], 0);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_pmp; q[45] = raised_wide(v57);
    q[46] = only_wide(-v67 <= -half_turn, turn) - v67;
    q[47] = angle4 - signed_wide(half_turn, s6_mm);
    kind[7] = kind_of(q[42], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v31 <= m7) | (v18 <= m4) | (v30 <= m7) | (v17 <= m4) | (v29 <= m7) |
        (v16 <= m4) | (v28 <= m7) | (abs_wide(D1) <= m1) | (abs_wide(D3 * (k4 * w1)) <= m2) | (v14
        <= m4));
}

#if LANES > 1
static const double
    m8 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[8][6], unsigned char status[8])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy, D1 = N1 - k1,
        w1 = sqrt(D1), v1 = w1 - w1, inverse1 = 1.0 / N1, v2 = inverse1 * (d3 * wy);
    const four v3 = v2 + w1 * (inverse1 * (e1 * X1));
    const double v4 = inverse1 * (d3 * X1);
    const four s1 = w1 * (inverse1 * (e1 * wy)) - v4;

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1, N3 = D1 + Z1_3 * Z1_3,
        D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3), v5 = w3 - w3, v6 = k5 * (N3 - k5);

    /* theta2 */
    const four v7 = e1 * e2;
    const double v8 = m3 * (Z1_3 * N3);
    const four S2 = v8 - w3 * (m3 * (w1 * v7)), v9 = w3 * (m3 * (e2 * Z1_3)),
        v10 = m3 * (w1 * (e1 * N3)), C2 = v9 + v10, v11 = S2 * S2 + C2 * C2,
        factor2 = sqrt_four(v11) * (1.0 / v11);

    /* theta4 */
    const four v12 = v8 + w3 * (w1 * (m3 * v7));
    const double v13 = m5 * N3, v14 = v13 - m3;
    const four v15 = e1 * v14;
    const double v16 = m6 - v13;
    const four v17 = e2 * v16, s23 = w1 * (N3 * (v15 + v7 * v17)) - v9, v18 = T23 * s1 - T13 * v3,
        X4 = v12 * v18 - T33 * s23, Y4 = T13 * s1 + T23 * v3, v19 = Y4 * Y4,
        v20 = v19 + factor2 * (X4 * (factor2 * X4));

    /* theta6 */
    const four v21 = v3 * T22 + s1 * T12, v22 = s1 * T22 - v3 * T12, v23 = v3 * T21 + s1 * T11,
        v24 = s1 * T21 - v3 * T11, s6 = Y4 * (s23 * T31 - v12 * v24) - v23 * -X4;

    /* joint values */
    const double v27 = copysign(half_turn, v6);
    const four v29 = signed_four(half_turn, Y4);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | ((v11 <= m4) | (v20 <= m7))) |
        (unsigned)((fabs(D1) <= m1) | (fabs(D3 * (k4 * w1)) <= m2)))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(s1, all_four(v6), 0, 5, 2, 3), shuffle(-v3,
        all_four(-(k5 * w3)), 0, 5, 2, 3)), ratio2 = ratio_four(S2, C2),
        ratio3 = ratio_four(s6, Y4 * (s23 * T32 - v12 * v22) - v21 * -X4),
        ratio4 = ratio_four(Y4, factor2 * -X4),
        ratio5 = ratio_four(sqrt_four(v20), -(factor2 * (T33 * v12 + s23 * v18)));
    const four packed1 = angle_four(ratio1), angle2 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle4 = shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = angle_four(ratio2),
        angle1 = angle_four(ratio3), angle5 = angle_four(ratio4), angle6 = angle_four(ratio5);
    const four q6_m = angle1 - signed_four(half_turn, s6), v25 = angle2 - offset1,
        v26 = angle3 - offset2, q2_p = raised_four(v26),
        v28 = e2 * angle4 + v27 * (m8 * (1.0 - e2)) - offset3, v30 = angle5 - offset4,
        v31 = angle5 - v29 - offset4, q4_p = raised_four(v30), q4_m = raised_four(v31),
        v32 = angle6 - offset5, v33 = offset5 + angle6, q5_p = raised_four(v32),
        q5_m = only_four(-v33 <= -half_turn, turn) - v33, q1_p = v5 + raised_four(v25),
        q3_p = v1 + raised_four(v28);

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, q2_p, q3_p, q4_p);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], q5_p, angle1);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, q2_p, q3_p, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], q5_m, q6_m);
    const unsigned long long none1 = (bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~none1);
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
    const double wy = T24 - d6 * T23;
    const double N1 = X1 * X1 + wy * wy;
    const int free1 = N1 <= free_limit_squared2;
    const double D1 = N1 - k1;
    const int apart1 = k3 < D1;
    if (!(-k2 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : d3 * sqrt(N1)));
    const double v1 = X1 * d3, v2 = wy * d3, v3 = seed[0] + offset1;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v4 = Z1_3 * Z1_3, v5 = free1 ? 1.0 : (apart1 ? w1 : least_root1) * k4;

    /* theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double v9 = seed[1] + offset2;

    /* theta4, type 2: U4[3, 3] */
    const double v13 = seed[3] + offset4;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(v3) : -(inverse1 * (v2 + X1 * root1)),
            s1 = free1 ? sin(v3) : inverse1 * (wy * root1 - v1);

        /* theta3 */
        const double N3 = v4 + root1 * root1;
        const double K3 = N3 - k5;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= D3 * v5)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double s3 = k5 * K3 * k6;

        /* theta2 */
        const double X1_2 = a2 + d4 * s3;
        const double v7 = Z1_3 * X1_2, v8 = root1 * X1_2;

        /* theta4 */
        const double v11 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v12 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v14 = T22 * c1 - T12 * s1, v15 = T12 * c1 + T22 * s1,
            v17 = T21 * c1 - T11 * s1, v18 = T11 * c1 + T21 * s1;

        /* joint values */
        const double q1 = wrap(atan2(s1, c1) - offset1);

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double v6 = k6 * (k5 * (w3 * e2));

            /* theta2 */
            const double Y1_2 = d4 * v6;
            const double S2 = v7 - root1 * Y1_2;
            const double C2 = v8 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v9) : C2 * factor2, s2 = free2 ? sin(v9) : S2 * factor2;

            /* theta4 */
            const double v10 = v6 * c2 + s3 * s2;
            const double s23 = s3 * c2 - v6 * s2;
            const double X4 = v10 * v11 - T33 * s23;
            const double w4 = sqrt(X4 * X4 + v12);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta6 */
            const double v16 = T32 * s23 - v10 * v15, v19 = T31 * s23 - v10 * v18;

            /* joint values */
            const double q2 = wrap(atan2(s2, c2) - offset2);
            const double q3 = wrap(atan2(s3, -v6) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(v13) : -(X4 * factor4),
                    s4 = free4 ? sin(v13) : Y4 * factor4;
                const double s5 = w4 * e3;

                /* theta6 */
                const double c6 = c4 * v14 + s4 * v16, s6 = c4 * v17 + s4 * v19;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q4 = wrap(atan2(s4, c4) - offset4);
                const double q5 = wrap(atan2(s5, -(T33 * v10 + s23 * v11)) - offset5);
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
static const double weights[6] = { 1.149, 1.149, 1.149, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    staubli_tx40_fk(x, P);
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
    staubli_tx40_jacobian(x, J);
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
 * returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[6])
{
    double x[6], half[6], e[6], last = HUGE_VAL;
    int settled = 0, lost = 0, held[6] = { 0 };
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
    take(seed, x);
    if (!settle(T, 1e-12, 0.15, x))
        return;
    for (int row = 8 - 1; row >= 0; row--) {
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
    tell_once(pose, q, status);
    stay(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == NONE)
            continue;
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

int staubli_tx40_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int staubli_tx40_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = staubli_tx40_ik(T, q_seed, all, status) >= 0;
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

void staubli_tx40_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)staubli_tx40_ik(
                    T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)staubli_tx40_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
