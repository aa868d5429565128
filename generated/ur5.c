/* ur5: Universal Robots UR5
 *
 * Inverse kinematics, generated from robots/ur5.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/ur5.yaml. The formulas and where they come from: ur5.md.
 */
#include "ur5.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = UR5_OK, NONE = UR5_UNREACHABLE, FREE = UR5_FREE_JOINT,
    OUT = UR5_OUT_OF_LIMITS, INVALID = UR5_INVALID_POSE
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

#ifndef UR5_LIBM
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
 * -DUR5_SCALAR. With -DUR5_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(UR5_SCALAR) && !defined(UR5_LIBM)
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
#ifdef UR5_LIBM /* half the time of atan2 */
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
static const double
    d1 = 0.089159, /* joint offset 1 [m] */
    a2 = -0.425, /* link length 2 [m] */
    a3 = -0.39225, /* link length 3 [m] */
    d4 = 0.10915, /* joint offset 4 [m] */
    d5 = 0.09465, /* joint offset 5 [m] */
    d6 = 0.0823, /* joint offset 6 [m] */
    free_limit_squared2 = 1.4220777150809998e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 3.7710445702497337e-07, /* a root of nothing, by rounding [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    longest3 = 0.6678975625000001, /* square of the longest reach [m^2] */
    shortest3 = 0.0010725625000000002, /* square of the shortest reach [m^2] */
    boundary3 = 1.2992694420347808e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.6678975624999807, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0010725625000007814, /* the shortest, where branches merge [m^2] */
    longest3_clear = 0.6678975624805085, /* the longest, where blurred branches do [m^2] */
    shortest3_clear = 0.0010725625007810937, /* the shortest, where blurred branches do [m^2] */
    k1 = 0.0119137225, /* d4^2 [m^2] */
    k2 = 2.6032471470014224e-14, /* reach_slack1 * (2 * d4 + reach_slack1) [m^2] */
    k3 = 2.6032471470001422e-15, /* merge_slack1 * (2 * d4 + merge_slack1) [m^2] */
    k4 = 0.8385680946642751, /* 1 / arm_size1 [m^-1] */
    k5 = 0.3344850625, /* a2^2 + a3^2 [m^2] */
    k6 = 2.99928766917857, /* 1 / (2 * a3 * a2) [m^-2] */
    m1 = 2.603247147000142e-12, /* 1000 * k3 [m^2] */
    m2 = 9.999999999999999e-09, /* doubt_limit^2 */
    /* 10 * (longest3 - longest3_clear) * (longest3_clear - shortest3) [m^4] */
    m4 = 1.299750652900866e-10;
/* coefficients */
static const double m5 = 1.1764705882352942, m6 = 0.031488161764705896;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const ur5_branches[8] = {
    "left-noflip-down", "left-noflip-up", "left-flip-down", "left-flip-up", "right-noflip-down",
    "right-noflip-up", "right-flip-down", "right-flip-up",
};

static const double lowest[6] = {
    -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586,
    -6.283185307179586, -6.283185307179586,
};
static const double highest[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
#define slack(joint) 1e-09 /* of limits */

void ur5_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v3 * s4,
        x4_y = x3_y * c4 - v4 * s4, x4_z = x3_z * c4 + y3_z * s4, z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, y5_z = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + s1 * s5,
        x5_y = x4_y * c5 - c1 * s5, x5_z = x4_z * c5, z5_x = s1 * c5 - x4_x * s5,
        v5 = c1 * c5 + x4_y * s5, v6 = x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - z4_x * s6; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = z5_x;
    T[3] = x2_x * a2 + x3_x * a3 + s1 * d4 + z4_x * d5 + z5_x * d6;
    T[4] = x5_y * c6 - z4_y * s6; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = -v5;
    T[7] = x2_y * a2 + x3_y * a3 - c1 * d4 + z4_y * d5 - v5 * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = -v6;
    T[11] = d1 + s2 * a2 + x3_z * a3 + -y5_z * d5 - v6 * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void ur5_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, p4_x = p3_x + s1 * d4, p4_y = p3_y - c1 * d4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_x = s1 * c5 - (x3_x * c4 - v3 * s4) * s5,
        v5 = c1 * c5 + (x3_y * c4 - v4 * s4) * s5, v6 = (x3_z * c4 + y3_z * s4) * s5,
        p5_x = p4_x + z4_x * d5, p5_y = p4_y + z4_y * d5, p5_z = p3_z + z4_z * d5,
        p6_x = p5_x + z5_x * d6, p6_y = p5_y - v5 * d6, p6_z = p5_z - v6 * d6, v7 = p6_z - d1,
        v8 = p6_z - p2_z, v9 = p6_z - p3_z, v10 = p6_x - p4_x, v11 = p6_y - p4_y, v12 = p6_x - p5_x,
        v13 = p6_y - p5_y, v14 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(c1 * v7); J[2] = -(c1 * v8); J[3] = -(c1 * v9);
    J[4] = z4_y * v9 - z4_z * v11; J[5] = v6 * v13 - v5 * v14;
    J[6] = p6_x; J[7] = -(s1 * v7); J[8] = -(s1 * v8); J[9] = -(s1 * v9);
    J[10] = z4_z * v10 - z4_x * v9; J[11] = -(v6 * v12 + z5_x * v14);
    J[12] = 0.0; J[13] = s1 * p6_y + c1 * p6_x; J[14] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x);
    J[15] = s1 * (p6_y - p3_y) + c1 * (p6_x - p3_x); J[16] = z4_x * v11 - z4_y * v10;
    J[17] = z5_x * v13 + v5 * v12;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = s1; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -c1; J[28] = z4_y; J[29] = -v5;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = z4_z; J[35] = -v6;
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
    const wide X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy, D1 = N1 - k1,
        w1 = sqrt_wide(D1), v1 = k4 * w1, inverse1 = 1.0 / N1, v2 = inverse1 * (d4 * wy),
        v3 = v2 + w1 * (X1 * inverse1), v4 = v2 + w1 * (inverse1 * -X1), v5 = inverse1 * (d4 * X1),
        s1_p = w1 * (wy * inverse1) - v5, s1_m = w1 * (inverse1 * -wy) - v5,
        angle1 = atan2_wide(s1_p, -v3), angle2 = atan2_wide(s1_m, -v4);

    /* theta6 */
    const wide v6 = v3 * T21 + s1_p * T11, v7 = v4 * T21 + s1_m * T11, v8 = v3 * T22 + s1_p * T12,
        v9 = v4 * T22 + s1_m * T12, v10 = v6 * v6 + v8 * v8, v11 = v7 * v7 + v9 * v9,
        w6_p = sqrt_wide(v10), w6_m = sqrt_wide(v11), v12 = 1.0 / v10, v13 = 1.0 / v11,
        angle3 = atan2_wide(-v8, v6), angle4 = atan2_wide(-v9, v7);

    /* theta5 */
    const wide c5_p = T13 * s1_p + T23 * v3, c5_m = T13 * s1_m + T23 * v4,
        angle5 = atan2_wide(w6_p, c5_p), angle6 = atan2_wide(w6_m, c5_m);

    /* theta234 */
    const wide v14 = v12 * (v6 * T32 - v8 * T31), v15 = v13 * (v7 * T32 - v9 * T31),
        c234_p = w6_p * v14, c234_m = w6_m * v15, v16 = v12 * (c5_p * (v6 * T31 + v8 * T32)) - T33,
        v17 = v13 * (c5_m * (v7 * T31 + v9 * T32)) - T33, s234_p = w6_p * v16, s234_m = w6_m * v17,
        angle7 = atan2_wide(v16, v14), angle8 = atan2_wide(v17, v15),
        theta234_pm = angle7 - signed_wide(half_turn, v16),
        theta234_mm = angle8 - signed_wide(half_turn, v17);

    /* theta3 */
    const wide v18 = d6 * w6_p, v19 = d6 * w6_m, v20 = T34 - d1, v21 = d5 * c234_p,
        v22 = d5 * c234_m, v23 = s234_p * v18, v24 = s234_m * v19, Z1_3_pp = v20 + (v21 + v23),
        Z1_3_pm = v20 + (v23 - v21), Z1_3_mp = v20 + (v22 + v24), Z1_3_mm = v20 + (v24 - v22),
        v25 = T24 * s1_p - T14 * v3, v26 = T24 * s1_m - T14 * v4, v27 = c234_p * v18,
        v28 = c234_m * v19, v29 = d5 * s234_p, v30 = d5 * s234_m, Z2_3_pp = v25 + (v27 - v29),
        Z2_3_pm = v25 + (v27 + v29), Z2_3_mp = v26 + (v28 - v30), Z2_3_mm = v26 + (v28 + v30),
        N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp,
        N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm,
        N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp,
        N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm,
        D3_pp = (longest3 - N3_pp) * (N3_pp - shortest3),
        D3_pm = (longest3 - N3_pm) * (N3_pm - shortest3),
        D3_mp = (longest3 - N3_mp) * (N3_mp - shortest3),
        D3_mm = (longest3 - N3_mm) * (N3_mm - shortest3), w3_pp = sqrt_wide(D3_pp),
        w3_pm = sqrt_wide(D3_pm), w3_mp = sqrt_wide(D3_mp), w3_mm = sqrt_wide(D3_mm),
        v31 = w3_pp - w3_pp, v32 = w3_pm - w3_pm, v33 = w3_mp - w3_mp, v34 = w3_mm - w3_mm,
        angle9 = atan2_wide(w3_pp, N3_pp - k5), angle10 = atan2_wide(w3_pm, N3_pm - k5),
        angle11 = atan2_wide(w3_mp, N3_mp - k5), angle12 = atan2_wide(w3_mm, N3_mm - k5);

    /* theta2 */
    const wide v35 = m6 + m5 * N3_pp, v36 = m6 + m5 * N3_pm, v37 = m6 + m5 * N3_mp,
        v38 = m6 + m5 * N3_mm, v39 = Z1_3_pp * v35, v40 = Z1_3_pm * v36, v41 = Z1_3_mp * v37,
        v42 = Z1_3_mm * v38, v43 = Z2_3_pp * v35, v44 = Z2_3_pm * v36, v45 = Z2_3_mp * v37,
        v46 = Z2_3_mm * v38, v47 = w3_pp * (m5 * Z2_3_pp), v48 = w3_pp * (m5 * Z1_3_pp),
        angle13 = atan2_wide(v47 - v39, -(v43 + v48)),
        angle14 = atan2_wide(-(v39 + v47), v48 - v43), v49 = w3_pm * (m5 * Z2_3_pm),
        v50 = w3_pm * (m5 * Z1_3_pm), angle15 = atan2_wide(v49 - v40, -(v44 + v50)),
        angle16 = atan2_wide(-(v40 + v49), v50 - v44), v51 = w3_mp * (m5 * Z2_3_mp),
        v52 = w3_mp * (m5 * Z1_3_mp), angle17 = atan2_wide(v51 - v41, -(v45 + v52)),
        angle18 = atan2_wide(-(v41 + v51), v52 - v45), v53 = w3_mm * (m5 * Z2_3_mm),
        v54 = w3_mm * (m5 * Z1_3_mm), angle19 = atan2_wide(v53 - v42, -(v46 + v54)),
        angle20 = atan2_wide(-(v42 + v53), v54 - v46);

    /* joint values */
    const wide v55 = angle7 - (angle9 + angle13), v56 = angle7 - (angle14 - angle9),
        v57 = theta234_pm - (angle10 + angle15), v58 = theta234_pm - (angle16 - angle10),
        v59 = angle8 - (angle11 + angle17), v60 = angle8 - (angle18 - angle11),
        v61 = theta234_mm - (angle12 + angle19), v62 = theta234_mm - (angle20 - angle12),
        q1_ppp = angle1 + v31, q1_pmp = angle1 + v32, q1_mpp = angle2 + v33, q1_mmp = angle2 + v34,
        q5_ppp = angle5 + v31, q5_pmp = v32 - angle5, q5_mpp = angle6 + v33, q5_mmp = v34 - angle6,
        q6_ppp = angle3 + v31, q6_pmp = v32 + (angle3 - signed_wide(half_turn, -v8)),
        q6_mpp = angle4 + v33, q6_mmp = v34 + (angle4 - signed_wide(half_turn, -v9));

    q[0] = q1_ppp; q[1] = angle13; q[2] = angle9; q[3] = centred_wide(v55); q[4] = q5_ppp;
    q[5] = q6_ppp;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_ppp; q[7] = angle14; q[8] = -angle9; q[9] = centred_wide(v56); q[10] = q5_ppp;
    q[11] = q6_ppp;
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_pmp; q[13] = angle15; q[14] = angle10; q[15] = centred_wide(v57); q[16] = q5_pmp;
    q[17] = q6_pmp;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_pmp; q[19] = angle16; q[20] = -angle10; q[21] = centred_wide(v58); q[22] = q5_pmp;
    q[23] = q6_pmp;
    kind[3] = kind_of(q[18], 0);
    q[24] = q1_mpp; q[25] = angle17; q[26] = angle11; q[27] = centred_wide(v59); q[28] = q5_mpp;
    q[29] = q6_mpp;
    kind[4] = kind_of(q[24], 0);
    q[30] = q1_mpp; q[31] = angle18; q[32] = -angle11; q[33] = centred_wide(v60); q[34] = q5_mpp;
    q[35] = q6_mpp;
    kind[5] = kind_of(q[30], 0);
    q[36] = q1_mmp; q[37] = angle19; q[38] = angle12; q[39] = centred_wide(v61); q[40] = q5_mmp;
    q[41] = q6_mmp;
    kind[6] = kind_of(q[36], 0);
    q[42] = q1_mmp; q[43] = angle20; q[44] = -angle12; q[45] = centred_wide(v62); q[46] = q5_mmp;
    q[47] = q6_mmp;
    kind[7] = kind_of(q[42], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((abs_wide(v1 * D3_mm) <= m4) | (abs_wide(v1 * D3_mp) <= m4) |
        (abs_wide(v1 * D3_pm) <= m4) | (abs_wide(v1 * D3_pp) <= m4) | (v11 <= m2) | (abs_wide(D1) <=
        m1) | (v10 <= m2));
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
    const double X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy, D1 = N1 - k1,
        w1 = sqrt(D1), v1 = k4 * w1, inverse1 = 1.0 / N1, v2 = inverse1 * (d4 * wy);
    const four v3 = v2 + w1 * (inverse1 * (e1 * X1));
    const double v4 = inverse1 * (d4 * X1);
    const four s1 = w1 * (inverse1 * (e1 * wy)) - v4;

    /* theta6 */
    const four v5 = v3 * T21 + s1 * T11, v6 = v3 * T22 + s1 * T12, v7 = v5 * v5 + v6 * v6,
        w6 = sqrt_four(v7), v8 = 1.0 / v7, v9 = signed_four(half_turn, -v6), v10 = m3 * (e2 - 1.0);

    /* theta5 */
    const four c5 = T13 * s1 + T23 * v3;

    /* theta234 */
    const four v11 = v8 * (v5 * T32 - v6 * T31), c234 = w6 * v11,
        v12 = v8 * (c5 * (v5 * T31 + v6 * T32)) - T33, s234 = w6 * v12,
        v13 = signed_four(half_turn, v12);

    /* theta3 */
    const four v14 = d6 * w6;
    const double v15 = T34 - d1;
    const four v16 = d5 * c234, v17 = s234 * v14, Z1_3 = v15 + (v17 + e2 * v16),
        v18 = T24 * s1 - T14 * v3, v19 = c234 * v14, v20 = d5 * s234, Z2_3 = v18 + (v19 - e2 * v20),
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt_four(D3),
        v21 = w3 - w3;

    /* theta2 */
    const four v22 = m6 + m5 * N3, v23 = Z1_3 * v22, v24 = Z2_3 * v22, v25 = w3 * (m5 * Z2_3),
        v26 = w3 * (m5 * Z1_3);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | (v7 <= m2) | (abs_four(v1 * D3) <= m4)) |
        (unsigned)(fabs(D1) <= m1))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(s1, -v6, 0, 5, 2, 7), shuffle(-v3, v5, 0, 5, 2,
        7)), ratio2 = ratio_four(shuffle(w6, v12, 0, 5, 2, 7), shuffle(c5, v11, 0, 5, 2, 7)),
        ratio3 = ratio_four(w3, N3 - k5), ratio4 = ratio_four(v25 - v23, -(v24 + v26)),
        ratio5 = ratio_four(-(v23 + v25), v26 - v24);
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle2 = shuffle(packed1, packed1, 1, 1, 3, 3), packed2 = angle_four(ratio2),
        angle3 = shuffle(packed2, packed2, 0, 0, 2, 2),
        angle4 = shuffle(packed2, packed2, 1, 1, 3, 3), angle5 = angle_four(ratio3),
        angle6 = angle_four(ratio4), angle7 = angle_four(ratio5);
    const four theta234 = angle4 + v10 * v13, v27 = theta234 - (angle5 + angle6),
        v28 = theta234 - (angle7 - angle5), q4_p = centred_four(v27), q4_m = centred_four(v28),
        q1_p = angle1 + v21, q5_p = v21 + e2 * angle3, q6_p = v21 + (angle2 + v9 * v10);

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, angle6, angle5, q4_p);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], q5_p, q6_p);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, angle7, -angle5, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], q5_p, q6_p);
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

/* LOST + j: the row was lost after joint j had been chosen freely; NEARLY + j: joint j is nearly
 * free, and the row's second value is its angle. */
enum { LOST = 128, NEARLY = 192 };

/* Notes why a row is lost, and how far it is from a solution. */
static void lose(int why, double off, double q[6], unsigned char *status)
{
    *status = (unsigned char)why;
    q[0] = off;
}

/* Fills the rows of the branches that have a solution, and no others. The first value of a row that
 * is LOST says how far it is from a solution (negative). */
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
    const double v1 = (apart1 ? w1 : least_root1) * k4;
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : d4 * sqrt(N1)));
    const double v2 = X1 * d4, v3 = wy * d4;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v7 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : -(inverse1 * (v3 + X1 * root1)),
            s1 = free1 ? sin(seed[0]) : inverse1 * (wy * root1 - v2);
        const double q1 = atan2(s1, c1);

        /* theta6, type 2: U1 A6^-1 [3, 2] */
        const double X6 = T21 * c1 - T11 * s1;
        const double Y6 = T22 * c1 - T12 * s1;
        const double w6 = sqrt(X6 * X6 + Y6 * Y6);
        const int free6 = w6 <= free_limit;
        const double divisor6 = free6 ? 1.0 : w6;
        const int near6 = w6 <= near_limit;

        /* theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1] */
        const double c5 = T13 * s1 - T23 * c1;

        /* theta3 */
        const double v8 = T14 * c1 + T24 * s1, v9 = (free6 || free1 || near6) ? 1.0 : v1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta6 */
            if (e2 < 0.0 && free6) continue; /* both signs give the same */
            const double factor6 = e2 / divisor6;
            const double v4 = X6 * factor6, v5 = Y6 * factor6;
            const double off6 = near6 ? w6 * fabs(v4 * sin(seed[5]) + v5 * cos(seed[5])) : 1.0;
            const double ahead6 = near6 ? v5 * sin(seed[5]) - v4 * cos(seed[5]) : -1.0;
            const int same6 = near6 && 0.0 < ahead6 && off6 <= free_limit;
            const int held6 = free6 || same6;
            const double c6 = held6 ? cos(seed[5]) : -v4, s6 = held6 ? sin(seed[5]) : v5;
            const double q6 = atan2(s6, c6);
            const double s5 = w6 * e2;

            /* theta5 */
            const double q5 = atan2(s5, c5);

            /* theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1] */
            const double c234 = c6 * T32 + s6 * T31, s234 = c5 * (c6 * T31 - s6 * T32) - s5 * T33;
            const double theta234 = atan2(s234, c234);

            /* theta3 */
            const double v6 = d6 * s5;
            const double Z1_3 = c234 * d5 + s234 * v6 + v7;
            const double Z2_3 = c234 * v6 - s234 * d5 + v8;
            const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
            const double K3 = N3 - k5;
            const double D3 = (longest3 - N3) * (N3 - shortest3);
            const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
            if (!(-boundary3 <= D3 * v9)) {
                if (near6) lose(NEARLY + 6, D3, q[4 * i1 + 2 * i2], &status[4 * i1 + 2 * i2]);
                if (near6) q[4 * i1 + 2 * i2][1] = atan2(v5, -v4);
                if (free1) lose(LOST + 1, D3, q[4 * i1 + 2 * i2], &status[4 * i1 + 2 * i2]);
                if (free6) lose(LOST + 6, D3, q[4 * i1 + 2 * i2], &status[4 * i1 + 2 * i2]);
                continue; /* out of reach */
            }
            const double w3 = sqrt(apart3 ? D3 : 0.0);
            const double c3 = K3 * k6;

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + a3 * c3;
            const double v10 = Z1_3 * X1_2, v11 = Z2_3 * X1_2;

            for (int i3 = 0; i3 < 2; i3++) { /* down, up */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta3 */
                if (e3 < 0.0 && (!apart3 || (near6 && !(shortest3_clear < N3 && N3 <
                    longest3_clear))))
                    continue; /* both signs give the same */
                const double s3 = w3 * e3 * k6;
                const double q3 = atan2(s3, c3);

                /* theta2 */
                const double Y1_2 = a3 * s3;
                const double S2 = v10 - Z2_3 * Y1_2;
                const double C2 = v11 + Z1_3 * Y1_2;
                const double w2 = sqrt(S2 * S2 + C2 * C2);
                const int free2 = w2 <= free_limit_squared2;
                const double factor2 = 1.0 / (free2 ? 1.0 : w2);
                const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                    s2 = free2 ? sin(seed[1]) : S2 * factor2;
                const double q2 = atan2(s2, c2);

                /* joint values */
                const double q4 = wrap(theta234 - (q3 + q2));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free6) ? FREE : OK;
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
    double best, at; /* where the arm came nearest */
    int within; /* whether limits count */
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
    for (int i = 0; i < 8; i++)
        s->status[i] = NONE;
    solve(s->T, s->seed, s->q, s->status);
    const double result = shortfall(s);
    if (result > s->best) {
        s->best = result;
        s->at = s->seed[s->joint];
    }
    return result == 0.0 && s->within ? -beyond_limits(s->q[s->row]) : result;
}

/* Whether the row was solved, as exactly as poses may be rounded. */
static int serves(const struct search *s)
{
    const int status = s->status[s->row];
    if (s->within && beyond_limits(s->q[s->row]) > 0.0)
        return 0;
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

/* Several joints are free, none serves alone: in turn each goes to where the arm came nearest. */
static double serving_in_turn(struct search *s)
{
    static const int joints[] = { 0, 5 };
    double serving = NAN, before = -HUGE_VAL;
    for (int k = 0; k < 12 && isnan(serving) && s->best > before; k++) {
        before = s->best;
        s->seed[s->joint] = s->at;
        s->joint = joints[k % 2];
        s->start = s->at = s->seed[s->joint];
        serving = serving_value(s);
    }
    return serving;
}

/* Another value for a joint that had been chosen, if one serves. */
static void choose_again(
    const double T[16], const double seed[6], int row, double q[8][6], unsigned char status[8])
{
    const int nearly = status[row] > NEARLY;
    struct search lost = { .T = T, .row = row, .best = -HUGE_VAL };
    lost.joint = status[row] - (nearly ? NEARLY : LOST) - 1;
    take(seed, lost.seed);
    lost.start = fmod(nearly ? q[row][1] : seed[lost.joint], turn);
    double nearest = nearly ? serving_digits(&lost) : serving_value(&lost);
    if (isnan(nearest) && !nearly)
        nearest = serving_in_turn(&lost);
    attempt(&lost, isnan(nearest) ? 0.0 : nearest);
    const int served = !isnan(nearest) && serves(&lost);
    status[row] = served ? lost.status[row] : NONE;
    for (int i = 0; i < 6; i++)
        q[row][i] = served ? lost.q[row][i] : (double)NAN;
}

/* Whether a joint beyond its limits does not move with the one that is searched. */
static int hopeless(struct search *s)
{
    struct search other = *s;
    attempt(s, 0.0);
    attempt(&other, 0.1);
    if (shortfall(s) < 0.0 || shortfall(&other) < 0.0)
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
    static const int choosable[3] = { 5, 1, 0 };
    struct search search = { .T = T, .row = row, .within = 1 };
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
static const double weights[6] = { 0.8386, 0.8386, 0.8386, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    ur5_fk(x, P);
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
    ur5_jacobian(x, J);
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
        if (status[row] >= LOST)
            choose_again(pose, seed, row, q, status);
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

int ur5_ik(const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int ur5_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = ur5_ik(T, q_seed, all, status) >= 0;
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

void ur5_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)ur5_ik(T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)ur5_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
