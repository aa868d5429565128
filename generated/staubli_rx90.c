/* staubli_rx90: Stäubli RX90
 *
 * Inverse kinematics, generated from robots/staubli_rx90.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/staubli_rx90.yaml. The formulas and where they come from:
 * staubli_rx90.md.
 */
#include "staubli_rx90.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = STAUBLI_RX90_OK, NONE = STAUBLI_RX90_UNREACHABLE, FREE = STAUBLI_RX90_FREE_JOINT,
    OUT = STAUBLI_RX90_OUT_OF_LIMITS, INVALID = STAUBLI_RX90_INVALID_POSE
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

#ifndef STAUBLI_RX90_LIBM
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
 * -DSTAUBLI_RX90_SCALAR. With -DSTAUBLI_RX90_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(STAUBLI_RX90_SCALAR) && !defined(STAUBLI_RX90_LIBM)
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
#ifdef STAUBLI_RX90_LIBM /* half the time of atan2 */
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
    a2 = 0.45, /* link length 3 [m] */
    d4 = 0.45, /* joint offset 4 [m] */
    free_limit1 = 9e-13, /* a length that fixes no angle [m] */
    longest3 = 0.81, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    longest3_reach = 0.8100000000001621, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.8099999999999838, /* the longest, where branches merge [m^2] */
    shortest3_apart = 8.099999999999999e-29, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 8.1e-25, /* square of a length that fixes no angle [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.405, /* 2 * d4 * a2 [m^2] */
    k2 = 6.096631611034903, /* 1 / (k1^2) [m^-4] */
    m1 = 8.100000000000001e-09, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.312949748921684e-11,
    m5 = 6.561e-17, /* doubt_limit_squared2^2 [m^4] */
    m6 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m4 = 1.1111111111111112;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const staubli_rx90_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void staubli_rx90_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z5_x = s1 * c4 + x3_x * s4,
        y4_y = c1 * c4 - x3_y * s4, z5_z = x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v3 * s5,
        x5_y = x4_y * c5 - v4 * s5, x5_z = x4_z * c5 + y3_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - z5_x * s6; T[1] = -(z5_x * c6 + x5_x * s6); T[2] = -(v3 * c5 + x4_x * s5);
    T[3] = x2_x * a2 - v3 * d4;
    T[4] = x5_y * c6 + y4_y * s6; T[5] = y4_y * c6 - x5_y * s6; T[6] = -(v4 * c5 + x4_y * s5);
    T[7] = x2_y * a2 - v4 * d4;
    T[8] = x5_z * c6 - z5_z * s6; T[9] = -(z5_z * c6 + x5_z * s6); T[10] = y3_z * c5 - x4_z * s5;
    T[11] = s2 * a2 + y3_z * d4;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void staubli_rx90_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p3_x = x2_x * a2, p3_y = x2_y * a2, p3_z = s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, p4_x = p3_x - v3 * d4,
        p4_y = p3_y - v4 * d4, p4_z = p3_z + y3_z * d4;
    const double c4 = cos(q[3]), s4 = sin(q[3]);
    const double c5 = cos(q[4]), s5 = sin(q[4]), v5 = p4_z - p3_z;
    J[0] = -p4_y; J[1] = -(c1 * p4_z); J[2] = -(c1 * v5); J[3] = 0.0; J[4] = 0.0; J[5] = 0.0;
    J[6] = p4_x; J[7] = -(s1 * p4_z); J[8] = -(s1 * v5); J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = s1 * p4_y + c1 * p4_x; J[14] = s1 * (p4_y - p3_y) + c1 * (p4_x - p3_x);
    J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = -v3; J[22] = s1 * c4 + x3_x * s4;
    J[23] = -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5);
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -v4; J[28] = x3_y * s4 - c1 * c4;
    J[29] = -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5);
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = y3_z; J[34] = x3_z * s4;
    J[35] = y3_z * c5 - x3_z * c4 * s5;
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
    const wide v1 = T14 * T14 + T24 * T24, w1 = sqrt_wide(v1), v2 = 1.0 / v1,
        angle1 = atan2_wide(-T24, -T14);

    /* theta3 */
    const wide N3 = v1 + T34 * T34, D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt_wide(D3),
        v3 = w3 - w3, v4 = k1 * (N3 - k1), v5 = k2 * v4, v6 = k1 * w3, c3 = k2 * v6,
        angle2 = atan2_wide(-v4, v6), q3_pmp = signed_wide(half_turn, -v4) - angle2;

    /* theta2 */
    const wide X1_2 = a2 + d4 * v5, Y1_2 = d4 * c3, v7 = T34 * X1_2, v8 = w1 * Y1_2, v9 = v7 + v8,
        v10 = v7 - v8, v11 = m4 * (T34 * N3), v12 = w3 * (m4 * w1), S2_pp = v11 + v12,
        S2_pm = v11 - v12, v13 = w1 * X1_2, v14 = T34 * Y1_2, v15 = v14 - v13, v16 = v13 + v14,
        v17 = w3 * (m4 * T34), v18 = m4 * (w1 * N3), C2_pp = v17 - v18, C2_mp = v17 + v18,
        v19 = S2_pp * S2_pp, v20 = v19 + C2_pp * C2_pp, v21 = S2_pm * S2_pm + C2_mp * C2_mp,
        v22 = v19 - C2_pp * -C2_pp, w2_pp = sqrt_wide(v20), w2_pm = sqrt_wide(v21),
        w2_mm = sqrt_wide(v22), v23 = 1.0 / v20, v24 = 1.0 / v21, v25 = 1.0 / v22,
        angle3 = atan2_wide(S2_pp, C2_pp), angle4 = atan2_wide(S2_pm, -C2_mp),
        angle5 = atan2_wide(S2_pm, C2_mp), angle6 = atan2_wide(S2_pp, -C2_pp);

    /* theta4 */
    const wide v26 = v5 * v9, c23_pp = w2_pp * (v23 * (c3 * v15 + v26)),
        c23_pm = w2_pm * (v24 * (c3 * v16 + v5 * v10)), c23_mm = w2_mm * (v25 * (v26 - c3 * -v15)),
        v27 = c3 * v9, s23_pp = w2_pp * (v23 * (v27 - v5 * v15)), v28 = v5 * v16 - c3 * v10,
        s23_pm = w2_pm * (v24 * v28), s23_mp = w2_pm * (v24 * -v28),
        v29 = w2_mm * (v25 * (v27 + v5 * -v15)), v30 = w1 * (v2 * (T14 * T13 + T24 * T23)),
        X4_pp = s23_pp * T33 - c23_pp * v30, v31 = c23_pm * v30, X4_pm = s23_pm * T33 - v31,
        X4_mp = v31 + s23_mp * T33, X4_mm = c23_mm * v30 - v29 * T33,
        Y4 = w1 * (v2 * (T14 * T23 - T24 * T13)), v32 = Y4 * Y4, v33 = v32 + X4_pp * X4_pp,
        v34 = v32 + X4_pm * X4_pm, v35 = v32 + X4_mp * X4_mp, v36 = v32 + X4_mm * X4_mm,
        w4_pp = sqrt_wide(v33), w4_pm = sqrt_wide(v34), w4_mp = sqrt_wide(v35),
        w4_mm = sqrt_wide(v36), factor4_pp = w4_pp * (1.0 / v33), factor4_pm = w4_pm * (1.0 / v34),
        factor4_mp = w4_mp * (1.0 / v35), factor4_mm = w4_mm * (1.0 / v36),
        v37 = X4_pp * factor4_pp, v38 = X4_pm * factor4_pm, v39 = X4_mp * factor4_mp,
        v40 = X4_mm * factor4_mm, s4_pp = Y4 * factor4_pp, s4_pm = Y4 * factor4_pm,
        s4_mp = Y4 * factor4_mp, s4_mm = Y4 * factor4_mm, angle7 = atan2_wide(Y4, -X4_pp),
        angle8 = atan2_wide(Y4, -X4_pm), angle9 = atan2_wide(-Y4, -X4_mp),
        angle10 = atan2_wide(-Y4, -X4_mm), v41 = signed_wide(half_turn, Y4),
        v42 = signed_wide(half_turn, -Y4);

    /* theta5 */
    const wide angle11 = atan2_wide(w4_pp, c23_pp * T33 + s23_pp * v30), v43 = c23_pm * T33,
        angle12 = atan2_wide(w4_pm, v43 + s23_pm * v30),
        angle13 = atan2_wide(w4_mp, v43 - s23_mp * v30),
        angle14 = atan2_wide(w4_mm, c23_mm * T33 + v29 * v30);

    /* theta6 */
    const wide v44 = w1 * (v2 * (T14 * T22 - T24 * T12)), v45 = w1 * (v2 * (T14 * T12 + T24 * T22)),
        v46 = w1 * (v2 * (T14 * T21 - T24 * T11)), v47 = w1 * (v2 * (T14 * T11 + T24 * T21)),
        v48 = v37 * v46 - s4_pp * (s23_pp * T31 - c23_pp * v47), v49 = c23_pm * v47,
        v50 = v38 * v46 - s4_pm * (s23_pm * T31 - v49),
        v51 = s4_mp * (v49 + s23_mp * T31) - v39 * v46,
        v52 = s4_mm * (c23_mm * v47 - v29 * T31) - v40 * v46,
        angle15 = atan2_wide(v48, v37 * v44 - s4_pp * (s23_pp * T32 - c23_pp * v45)),
        v53 = c23_pm * v45, angle16 = atan2_wide(v50, v38 * v44 - s4_pm * (s23_pm * T32 - v53)),
        angle17 = atan2_wide(v51, s4_mp * (v53 + s23_mp * T32) - v39 * v44),
        angle18 = atan2_wide(v52, s4_mm * (c23_mm * v45 - v29 * T32) - v40 * v44);

    /* joint values */
    const wide q1_ppp = angle1 + v3, q1_mpp = v3 + (angle1 - signed_wide(half_turn, -T24));

    q[0] = q1_ppp; q[1] = angle3; q[2] = angle2; q[3] = angle7; q[4] = angle11; q[5] = angle15;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_ppp; q[7] = angle3; q[8] = angle2; q[9] = angle7 - v41; q[10] = -angle11;
    q[11] = angle15 - signed_wide(half_turn, v48);
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_ppp; q[13] = angle4; q[14] = q3_pmp; q[15] = angle8; q[16] = angle12;
    q[17] = angle16;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_ppp; q[19] = angle4; q[20] = q3_pmp; q[21] = angle8 - v41; q[22] = -angle12;
    q[23] = angle16 - signed_wide(half_turn, v50);
    kind[3] = kind_of(q[18], 0);
    q[24] = q1_mpp; q[25] = angle5; q[26] = angle2; q[27] = angle9; q[28] = angle13;
    q[29] = angle17;
    kind[4] = kind_of(q[24], 0);
    q[30] = q1_mpp; q[31] = angle5; q[32] = angle2; q[33] = angle9 - v42; q[34] = -angle13;
    q[35] = angle17 - signed_wide(half_turn, v51);
    kind[5] = kind_of(q[30], 0);
    q[36] = q1_mpp; q[37] = angle6; q[38] = q3_pmp; q[39] = angle10; q[40] = angle14;
    q[41] = angle18;
    kind[6] = kind_of(q[36], 0);
    q[42] = q1_mpp; q[43] = angle6; q[44] = q3_pmp; q[45] = angle10 - v42; q[46] = -angle14;
    q[47] = angle18 - signed_wide(half_turn, v52);
    kind[7] = kind_of(q[42], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v36 <= m6) | (v22 <= m5) | (v35 <= m6) | (v34 <= m6) | (v21 <= m5) |
        (v33 <= m6) | (v1 <= m1) | (abs_wide(D3) <= m3) | (v20 <= m5));
}

#if LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[8][6], unsigned char status[8])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double v1 = T14 * T14 + T24 * T24, w1 = sqrt(v1), v2 = 1.0 / v1,
        v3 = copysign(half_turn, -T24);

    /* theta3 */
    const double N3 = v1 + T34 * T34, D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3),
        v4 = w3 - w3, v5 = k1 * (N3 - k1), v6 = k2 * v5, v7 = k1 * w3, c3 = k2 * v7,
        v8 = copysign(half_turn, -v5);

    /* theta2 */
    const double X1_2 = a2 + d4 * v6, Y1_2 = d4 * c3, v9 = T34 * X1_2, v10 = w1 * Y1_2;
    const four v11 = e1 * e2, v12 = v9 + v10 * v11;
    const double v13 = m4 * (T34 * N3);
    const four S2 = v13 + w3 * (m4 * (w1 * v11));
    const double v14 = w1 * X1_2, v15 = T34 * Y1_2;
    const four v16 = e2 * v15, v17 = e1 * v14, v18 = v16 - v17, v19 = w3 * (m4 * (e2 * T34)),
        v20 = m4 * (w1 * (e1 * N3)), C2 = v19 - v20, v21 = S2 * S2 + C2 * C2, w2 = sqrt_four(v21),
        v22 = 1.0 / v21;

    /* theta4 */
    const four v23 = e2 * c3, c23 = w2 * (v22 * (v18 * v23 + v6 * v12)),
        s23 = w2 * (v22 * (v12 * v23 - v6 * v18));
    const double v24 = w1 * (v2 * (T14 * T13 + T24 * T23));
    const four X4 = s23 * T33 - e1 * (c23 * v24);
    const double Y4 = w1 * (v2 * (T14 * T23 - T24 * T13)), v25 = Y4 * Y4;
    const four v26 = v25 + X4 * X4, w4 = sqrt_four(v26), factor4 = w4 * (1.0 / v26),
        v27 = X4 * factor4, s4 = Y4 * factor4, v28 = e1 * Y4, v29 = signed_four(half_turn, v28);

    /* theta6 */
    const double v30 = w1 * (v2 * (T14 * T22 - T24 * T12)),
        v31 = w1 * (v2 * (T14 * T12 + T24 * T22)), v32 = w1 * (v2 * (T14 * T21 - T24 * T11)),
        v33 = w1 * (v2 * (T14 * T11 + T24 * T21));
    const four v34 = e1 * (v27 * v32 - s4 * (s23 * T31 - e1 * (c23 * v33)));

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | ((v21 <= m5) | (v26 <= m6))) |
        (unsigned)((v1 <= m1) | (fabs(D3) <= m3)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ -T24, -v5, -T24, -T24 }, (four){ -T14, v7, -T14,
        -T14 }), ratio2 = ratio_four(S2, C2), ratio3 = ratio_four(v28, -X4),
        ratio4 = ratio_four(w4, c23 * T33 + e1 * (s23 * v24)),
        ratio5 = ratio_four(v34, e1 * (v27 * v30 - s4 * (s23 * T32 - e1 * (c23 * v31))));
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = angle_four(ratio2),
        angle4 = angle_four(ratio3), angle5 = angle_four(ratio4), angle6 = angle_four(ratio5);
    const four q3_p = e2 * angle2 + v8 * (m2 * (1.0 - e2)), q4_m = angle4 - v29,
        q6_m = angle6 - signed_four(half_turn, v34), q1_p = v4 + (angle1 + v3 * (m2 * (e1 - 1.0)));

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, angle3, q3_p, angle4);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], angle5, angle6);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, angle3, q3_p, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], -angle5, q6_m);
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

    /* theta1, type 2: U1[2, 4] */
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1[3, 4] and U1[1, 4] */
    const double v1 = T34 * T34;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(T14 * factor1),
            s1 = free1 ? sin(seed[0]) : -(T24 * factor1);
        const double q1 = atan2(s1, c1);
        const double root1 = w1 * e1;

        /* theta3 */
        const double N3 = v1 + root1 * root1;
        const double K3 = N3 - k1;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v2 = k1 * K3 * k2;

        /* theta2, type 3: U1[3, 4] and U1[1, 4] */
        const double X1_2 = a2 + d4 * v2;
        const double v3 = T34 * X1_2, v4 = root1 * X1_2;

        /* theta4, type 2: U4[2, 3] */
        const double v5 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v6 = Y4 * Y4;

        /* theta6, type 3: U4[2, 2] and U4[2, 1] */
        const double v7 = T12 * s1 - T22 * c1, v8 = T12 * c1 + T22 * s1, v10 = T11 * s1 - T21 * c1,
            v11 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double c3 = k2 * (k1 * (w3 * e2));
            const double q3 = atan2(-v2, c3);

            /* theta2 */
            const double Y1_2 = d4 * c3;
            const double S2 = v3 + root1 * Y1_2;
            const double C2 = T34 * Y1_2 - v4;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 + v2 * s2, s23 = c3 * s2 - v2 * c2;
            const double X4 = c23 * v5 + T33 * s23;
            const double w4 = sqrt(X4 * X4 + v6);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[3, 3] and U4[1, 3] */
            const double c5 = T33 * c23 - s23 * v5;

            /* theta6 */
            const double v9 = c23 * v8 + T32 * s23, v12 = c23 * v11 + T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);
                const double s5 = w4 * e3;

                /* theta5 */
                const double q5 = atan2(s5, c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v10 + s4 * v12), -(c4 * v7 + s4 * v9));
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
static const double weights[6] = { 1.111, 1.111, 1.111, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    staubli_rx90_fk(x, P);
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
    staubli_rx90_jacobian(x, J);
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

int staubli_rx90_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int staubli_rx90_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = staubli_rx90_ik(T, q_seed, all, status) >= 0;
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

void staubli_rx90_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)staubli_rx90_ik(
                    T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)staubli_rx90_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
