/* puma: PUMA in its reference position
 *
 * Inverse kinematics, generated from robots/puma.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma.yaml. The formulas and where they come from: puma.md.
 */
#include "puma.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = PUMA_OK, NONE = PUMA_UNREACHABLE, FREE = PUMA_FREE_JOINT,
    OUT = PUMA_OUT_OF_LIMITS, INVALID = PUMA_INVALID_POSE
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

#ifndef PUMA_LIBM
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
 * -DPUMA_SCALAR. With -DPUMA_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(PUMA_SCALAR) && !defined(PUMA_LIBM)
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
#ifdef PUMA_LIBM /* half the time of atan2 */
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


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    L2 = 0.4318, /* z of axis 3 [m] */
    D3 = 0.15005, /* x of axis 4 [m] */
    D4 = 0.4318, /* z of axis 5 [m] */
    free_limit_squared2 = 3.57281304106196e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 5.977301264836799e-07, /* a root of nothing, by rounding [m] */
    longest3 = 0.7458049600000001, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    boundary3 = 2.435176934946171e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.7458049599999674, /* the longest, where branches merge [m^2] */
    shortest3_apart = 3.5728130410619605e-28, /* the shortest, where branches merge [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.8636, /* L2 + D4 [m] */
    k2 = 0.022515002499999996, /* D3^2 [m^2] */
    k3 = 5.6724560659962443e-14, /* reach_slack1 * (2 * D3 + reach_slack1) [m^2] */
    k4 = 5.672456065993029e-15, /* merge_slack1 * (2 * D3 + merge_slack1) [m^2] */
    k5 = 0.5290477290765635, /* 1 / arm_size1 [m^-1] */
    k6 = 0.37290248000000004, /* 2 * D4 * L2 [m^2] */
    k7 = 2.681666262986505, /* 1 / k6 [m^-2] */
    f1 = 0.8636, /* L2 + D4 [m] */
    g1 = 0.8636, /* L2 + D4 [m] */
    m1 = 5.672456065993029e-12, /* 1000 * k4 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 2.4343489251065266e-11,
    m4 = 1.276499302638241e-15, /* doubt_limit_squared2^2 [m^4] */
    m7 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m3 = 1.1579434923575729, m5 = 3.105217997900075, m6 = 2.3158869847151458;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const puma_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void puma_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = s1 * s2, v1 = c1 * s2, y2_x = s1 * c2,
        v2 = c1 * c2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        v3 = v1 * c3 + v2 * s3, x3_z = c2 * c3 - s2 * s3, v4 = s2 * c3 + c2 * s3,
        v5 = x2_x * s3 - y2_x * c3, v6 = v2 * c3 - v1 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = c1 * c4 + v5 * s4, x4_y = s1 * c4 + v6 * s4,
        x4_z = v4 * s4, y4_z = v4 * c4, v7 = c1 * s4 - v5 * c4, v8 = s1 * s4 - v6 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x3_x * c5 + v7 * s5,
        x5_y = v8 * s5 - v3 * c5, x5_z = x3_z * c5 - y4_z * s5, y5_y = v8 * c5 + v3 * s5,
        v9 = y4_z * c5 + x3_z * s5, v10 = x3_x * s5 - v7 * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x4_x * c6 + v10 * s6,
        x6_y = x4_y * c6 - y5_y * s6, x6_z = x4_z * c6 + v9 * s6;
    T[0] = x6_x; T[1] = v10 * c6 - x4_x * s6; T[2] = x5_x;
    T[3] = x2_x * L2 + c1 * D3 + x3_x * D4 - D3 * x6_x - x5_x * f1;
    T[4] = x6_y; T[5] = -(y5_y * c6 + x4_y * s6); T[6] = x5_y;
    T[7] = s1 * D3 - v1 * L2 - v3 * D4 - D3 * x6_y - x5_y * f1;
    T[8] = x6_z; T[9] = v9 * c6 - x4_z * s6; T[10] = x5_z;
    T[11] = c2 * L2 + x3_z * D4 - D3 * x6_z - x5_z * f1;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = s1 * s2, v1 = c1 * s2, y2_x = s1 * c2,
        v2 = c1 * c2, p3_x = x2_x * L2, v3 = v1 * L2, p3_z = c2 * L2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        v4 = v1 * c3 + v2 * s3, x3_z = c2 * c3 - s2 * s3, v5 = s2 * c3 + c2 * s3,
        p4_x = p3_x + c1 * D3, p4_y = s1 * D3 - v3, v6 = x2_x * s3 - y2_x * c3,
        v7 = v2 * c3 - v1 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = c1 * c4 + v6 * s4, x4_y = s1 * c4 + v7 * s4,
        x4_z = v5 * s4, y4_z = v5 * c4, p5_x = p4_x + x3_x * D4, p5_y = p4_y - v4 * D4,
        p5_z = p3_z + x3_z * D4, v8 = c1 * s4 - v6 * c4, v9 = s1 * s4 - v7 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x3_x * c5 + v8 * s5,
        x5_y = v9 * s5 - v4 * c5, x5_z = x3_z * c5 - y4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        J21 = p5_x - D3 * (x4_x * c6 + (x3_x * s5 - v8 * c5) * s6) - x5_x * g1,
        v10 = p5_y - D3 * (x4_y * c6 - (v9 * c5 + v4 * s5) * s6) - x5_y * g1,
        v11 = p5_z - D3 * (x4_z * c6 + (y4_z * c5 + x3_z * s5) * s6) - x5_z * g1, v12 = v11 - p3_z,
        v13 = J21 - p4_x, v14 = v10 - p4_y, v15 = J21 - p5_x, v16 = v10 - p5_y, v17 = v11 - p5_z;
    J[0] = -v10; J[1] = s1 * v11; J[2] = s1 * v12; J[3] = -(v4 * v12 + x3_z * v14);
    J[4] = x4_y * v17 - x4_z * v16; J[5] = x5_y * v17 - x5_z * v16;
    J[6] = J21; J[7] = -(c1 * v11); J[8] = -(c1 * v12); J[9] = x3_z * v13 - x3_x * v12;
    J[10] = x4_z * v15 - x4_x * v17; J[11] = x5_z * v15 - x5_x * v17;
    J[12] = 0.0; J[13] = c1 * v10 - s1 * J21; J[14] = c1 * (v3 + v10) - s1 * (J21 - p3_x);
    J[15] = x3_x * v14 + v4 * v13; J[16] = x4_x * v16 - x4_y * v15; J[17] = x5_x * v16 - x5_y * v15;
    J[18] = 0.0; J[19] = c1; J[20] = c1; J[21] = x3_x; J[22] = x4_x; J[23] = x5_x;
    J[24] = 0.0; J[25] = s1; J[26] = s1; J[27] = -v4; J[28] = x4_y; J[29] = x5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = x3_z; J[34] = x4_z; J[35] = x5_z;
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
    const wide t24 = T24 + D3 * T21 + k1 * T23, t14 = T14 + D3 * T11 + k1 * T13,
        N1 = t24 * t24 + t14 * t14, D1 = N1 - k2, w1 = sqrt_wide(D1), v1 = w1 - w1,
        inverse1 = 1.0 / N1, v2 = inverse1 * (D3 * t14), v3 = w1 * (t24 * inverse1), c1_p = v2 + v3,
        c1_m = v2 - v3, v4 = inverse1 * (D3 * t24), v5 = w1 * (t14 * inverse1), s1_p = v4 - v5,
        s1_m = v4 + v5;

    /* theta3 */
    const wide t34 = T34 + D3 * T31 + k1 * T33, N3 = D1 + t34 * t34,
        D3_ = (longest3 - N3) * (N3 - shortest3), w3 = sqrt_wide(D3_), v6 = w3 - w3,
        angle1 = atan2_wide(w3, N3 - k6);

    /* theta2 */
    const wide v7 = w3 * (m3 * t34), v8 = m3 * (w1 * N3), v9 = v7 + v8, v10 = v8 - v7,
        v11 = m3 * (t34 * N3), v12 = w3 * (m3 * w1), C2_pp = v11 - v12, C2_pm = v11 + v12,
        v13 = v9 * v9 + C2_pp * C2_pp, v14 = C2_pm * C2_pm, v15 = v10 * v10 + v14,
        v16 = v14 - v10 * -v10, factor2_pp = sqrt_wide(v13) * (1.0 / v13),
        factor2_pm = sqrt_wide(v15) * (1.0 / v15), factor2_mp = sqrt_wide(v16) * (1.0 / v16),
        angle2 = atan2_wide(-v9, C2_pp), angle3 = atan2_wide(-v10, C2_pm),
        angle4 = atan2_wide(v10, C2_pm), angle5 = atan2_wide(v9, C2_pp);

    /* theta4 */
    const wide v17 = m5 * N3, v18 = m3 - v17, v19 = v17 - m6, v20 = w1 * (N3 * (v18 + v19)),
        s23_pp = v7 + v20, s23_pm = v20 - v7, v21 = w1 * (N3 * (-v18 - v19)), s23_mp = v7 + v21,
        s23_mm = v21 - v7, v22 = T13 * s1_p - T23 * c1_p, v23 = T13 * s1_m - T23 * c1_m,
        X4_pp = C2_pm * v22 - T33 * s23_pp, X4_pm = C2_pp * v22 - T33 * s23_pm,
        X4_mp = C2_pp * v23 - T33 * s23_mp, X4_mm = C2_pm * v23 - T33 * s23_mm,
        v24 = T13 * c1_p + T23 * s1_p, v25 = T13 * c1_m + T23 * s1_m, v26 = v24 * v24,
        v27 = v25 * v25, v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp)),
        v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm)),
        v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp)),
        v31 = v27 + factor2_pp * (X4_mm * (factor2_pp * X4_mm)),
        angle6 = atan2_wide(-v24, factor2_pp * -X4_pp),
        angle7 = atan2_wide(-v24, factor2_pm * -X4_pm),
        angle8 = atan2_wide(-v25, factor2_mp * -X4_mp),
        angle9 = atan2_wide(-v25, factor2_pp * -X4_mm), v32 = signed_wide(half_turn, -v24),
        v33 = signed_wide(half_turn, -v25);

    /* theta5 */
    const wide v34 = T33 * C2_pm,
        angle10 = atan2_wide(-sqrt_wide(v28), factor2_pp * (v34 + s23_pp * v22)), v35 = T33 * C2_pp,
        angle11 = atan2_wide(-sqrt_wide(v29), factor2_pm * (v35 + s23_pm * v22)),
        angle12 = atan2_wide(-sqrt_wide(v30), factor2_mp * (v35 + s23_mp * v23)),
        angle13 = atan2_wide(-sqrt_wide(v31), factor2_pp * (v34 + s23_mm * v23));

    /* theta6 */
    const wide v36 = c1_p * T12 + s1_p * T22, v37 = c1_m * T12 + s1_m * T22,
        v38 = s1_p * T12 - c1_p * T22, v39 = s1_m * T12 - c1_m * T22, v40 = T11 * c1_p + T21 * s1_p,
        v41 = T11 * c1_m + T21 * s1_m, v42 = T11 * s1_p - T21 * c1_p, v43 = T11 * s1_m - T21 * c1_m,
        v44 = v24 * (s23_pp * T32 - C2_pm * v38) + X4_pp * v36,
        v45 = v24 * (s23_pm * T32 - C2_pp * v38) + X4_pm * v36,
        v46 = v25 * (s23_mp * T32 - C2_pp * v39) + X4_mp * v37,
        v47 = v25 * (s23_mm * T32 - C2_pm * v39) + X4_mm * v37,
        angle14 = atan2_wide(v44, -X4_pp * v40 - v24 * (T31 * s23_pp - C2_pm * v42)),
        angle15 = atan2_wide(v45, -X4_pm * v40 - v24 * (T31 * s23_pm - C2_pp * v42)),
        angle16 = atan2_wide(v46, -X4_mp * v41 - v25 * (T31 * s23_mp - C2_pp * v43)),
        angle17 = atan2_wide(v47, -X4_mm * v41 - v25 * (T31 * s23_mm - C2_pm * v43));

    /* joint values */
    const wide angle18 = atan2_wide(s1_p, c1_p), q1_ppp = v6 + angle18,
        angle19 = atan2_wide(s1_m, c1_m), q1_mpp = v6 + angle19, q3_ppp = v1 + angle1,
        q3_pmp = v1 - angle1;

    q[0] = q1_ppp; q[1] = angle2; q[2] = q3_ppp; q[3] = angle6; q[4] = angle10; q[5] = angle14;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_ppp; q[7] = angle2; q[8] = q3_ppp; q[9] = angle6 - v32; q[10] = -angle10;
    q[11] = angle14 - signed_wide(half_turn, v44);
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_ppp; q[13] = angle3; q[14] = q3_pmp; q[15] = angle7; q[16] = angle11;
    q[17] = angle15;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_ppp; q[19] = angle3; q[20] = q3_pmp; q[21] = angle7 - v32; q[22] = -angle11;
    q[23] = angle15 - signed_wide(half_turn, v45);
    kind[3] = kind_of(q[18], 0);
    q[24] = q1_mpp; q[25] = angle4; q[26] = q3_ppp; q[27] = angle8; q[28] = angle12;
    q[29] = angle16;
    kind[4] = kind_of(q[24], 0);
    q[30] = q1_mpp; q[31] = angle4; q[32] = q3_ppp; q[33] = angle8 - v33; q[34] = -angle12;
    q[35] = angle16 - signed_wide(half_turn, v46);
    kind[5] = kind_of(q[30], 0);
    q[36] = q1_mpp; q[37] = angle5; q[38] = q3_pmp; q[39] = angle9; q[40] = angle13;
    q[41] = angle17;
    kind[6] = kind_of(q[36], 0);
    q[42] = q1_mpp; q[43] = angle5; q[44] = q3_pmp; q[45] = angle9 - v33; q[46] = -angle13;
    q[47] = angle17 - signed_wide(half_turn, v47);
    kind[7] = kind_of(q[42], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v31 <= m7) | (v30 <= m7) | (v16 <= m4) | (v29 <= m7) | (v15 <= m4) |
        (v28 <= m7) | (abs_wide(D1) <= m1) | (abs_wide(D3_ * (k5 * w1)) <= m2) | (v13 <= m4));
}

#if LANES > 1
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[8][6], unsigned char status[8])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double t24 = T24 + D3 * T21 + k1 * T23, t14 = T14 + D3 * T11 + k1 * T13,
        N1 = t24 * t24 + t14 * t14, D1 = N1 - k2, w1 = sqrt(D1), v1 = w1 - w1, inverse1 = 1.0 / N1,
        v2 = inverse1 * (D3 * t14);
    const four c1 = v2 + w1 * (inverse1 * (e1 * t24));
    const double v3 = inverse1 * (D3 * t24);
    const four s1 = v3 - w1 * (inverse1 * (e1 * t14));

    /* theta3 */
    const double t34 = T34 + D3 * T31 + k1 * T33, N3 = D1 + t34 * t34,
        D3_ = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_), v4 = w3 - w3;

    /* theta2 */
    const four v5 = w3 * (m3 * (e2 * t34)), v6 = m3 * (w1 * (e1 * N3)), v7 = v5 + v6, v8 = e1 * e2;
    const double v9 = m3 * (t34 * N3);
    const four C2 = v9 - w3 * (m3 * (w1 * v8)), v10 = v7 * v7 + C2 * C2,
        factor2 = sqrt_four(v10) * (1.0 / v10);

    /* theta4 */
    const four c23 = v9 + w3 * (w1 * (m3 * v8));
    const double v11 = m5 * N3, v12 = m3 - v11;
    const four v13 = e1 * v12;
    const double v14 = v11 - m6;
    const four v15 = e2 * v14, s23 = v5 + w1 * (N3 * (v13 + v8 * v15)), v16 = T13 * s1 - T23 * c1,
        X4 = c23 * v16 - T33 * s23, v17 = T13 * c1 + T23 * s1, v18 = v17 * v17,
        v19 = v18 + factor2 * (X4 * (factor2 * X4)), v20 = signed_four(half_turn, -v17);

    /* theta6 */
    const four v21 = c1 * T12 + s1 * T22, v22 = s1 * T12 - c1 * T22, v23 = T11 * c1 + T21 * s1,
        v24 = T11 * s1 - T21 * c1, v25 = v17 * (s23 * T32 - c23 * v22) + X4 * v21;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | ((v10 <= m4) | (v19 <= m7))) |
        (unsigned)((fabs(D1) <= m1) | (fabs(D3_ * (k5 * w1)) <= m2)))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(s1, all_four(w3), 0, 5, 2, 3), shuffle(c1,
        all_four(N3 - k6), 0, 5, 2, 3)), ratio2 = ratio_four(-v7, C2),
        ratio3 = ratio_four(v25, -X4 * v23 - v17 * (T31 * s23 - c23 * v24)),
        ratio4 = ratio_four(-v17, factor2 * -X4),
        ratio5 = ratio_four(-sqrt_four(v19), factor2 * (T33 * c23 + s23 * v16));
    const four packed1 = angle_four(ratio1), angle6 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = shuffle(packed1, packed1, 1, 1, 1, 1), angle2 = angle_four(ratio2),
        angle5 = angle_four(ratio3), angle3 = angle_four(ratio4), angle4 = angle_four(ratio5);
    const four q4_m = angle3 - v20, q6_m = angle5 - signed_four(half_turn, v25), q1_p = v4 + angle6,
        q3_p = v1 + e2 * angle1;

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, angle2, q3_p, angle3);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], angle4, angle5);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, angle2, q3_p, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], -angle4, q6_m);
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

    /* theta1, type 2: U1[1, 4] */
    const double t24 = T24 + D3 * T21 + k1 * T23;
    const double t14 = T14 + D3 * T11 + k1 * T13;
    const double N1 = t24 * t24 + t14 * t14;
    const int free1 = N1 <= free_limit_squared2;
    const double D1 = N1 - k2;
    const int apart1 = k4 < D1;
    if (!(-k3 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : D3 * sqrt(N1)));
    const double v1 = D3 * t24, v2 = D3 * t14;

    /* theta3, type 8: U1[3, 4] and U1[2, 4] */
    const double t34 = T34 + D3 * T31 + k1 * T33;
    const double v3 = t34 * t34, v4 = free1 ? 1.0 : (apart1 ? w1 : least_root1) * k5;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v2 + t24 * root1),
            s1 = free1 ? sin(seed[0]) : inverse1 * (v1 - t14 * root1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double N3 = v3 + root1 * root1;
        const double K3 = N3 - k6;
        const double D3_ = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= D3_ * v4)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_ : 0.0);
        const double c3 = K3 * k7;

        /* theta2, type 3: U1[3, 4] and U1[2, 4] */
        const double Y1_2 = L2 + D4 * c3;
        const double v6 = root1 * Y1_2, v8 = t34 * Y1_2;

        /* theta4, type 2: U4[1, 3] */
        const double v9 = T13 * s1 - T23 * c1, v10 = T13 * c1 + T23 * s1, v11 = v10 * v10;

        /* theta6, type 3: U4[1, 2] and U4[1, 1] */
        const double v12 = T12 * c1 + T22 * s1, v13 = T12 * s1 - T22 * c1,
            v15 = T11 * c1 + T21 * s1, v16 = T11 * s1 - T21 * c1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e2 * k7;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double v5 = D4 * s3, v7 = t34 * v5 + v6;
            const double C2 = v8 - root1 * v5;
            const double w2 = sqrt(v7 * v7 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : -(v7 * factor2);
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2;
            const double X4 = c23 * v9 - T33 * s23;
            const double w4 = sqrt(X4 * X4 + v11);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[3, 3] and U4[2, 3] */
            const double c5 = T33 * c23 + s23 * v9;

            /* theta6 */
            const double v14 = T32 * s23 - c23 * v13, v17 = T31 * s23 - c23 * v16;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : -(v10 * factor4);
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6 */
                const double c6 = c4 * v15 + s4 * v17;
                const double q6 = atan2(-(c4 * v12 + s4 * v14), c6);
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
static const double weights[6] = { 0.529, 0.529, 0.529, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    puma_fk(x, P);
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
    puma_jacobian(x, J);
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

int puma_ik(const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int puma_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = puma_ik(T, q_seed, all, status) >= 0;
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

void puma_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)puma_ik(T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)puma_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
