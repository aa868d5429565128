/* olson_pprrrr: Olson PPRRRR arm
 *
 * Inverse kinematics, generated from robots/olson_pprrrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/olson_pprrrr.yaml. The formulas and where they come from:
 * olson_pprrrr.md.
 */
#include "olson_pprrrr.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = OLSON_PPRRRR_OK, NONE = OLSON_PPRRRR_UNREACHABLE, FREE = OLSON_PPRRRR_FREE_JOINT,
    OUT = OLSON_PPRRRR_OUT_OF_LIMITS, INVALID = OLSON_PPRRRR_INVALID_POSE
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

#ifndef OLSON_PPRRRR_LIBM
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
 * -DOLSON_PPRRRR_SCALAR. With -DOLSON_PPRRRR_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(OLSON_PPRRRR_SCALAR) && !defined(OLSON_PPRRRR_LIBM)
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
#ifdef OLSON_PPRRRR_LIBM /* half the time of atan2 */
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
    d3 = 1.0, /* joint offset 3 [m] */
    a4 = 4.0, /* link length 5 [m] */
    d6 = 2.0, /* joint offset 6 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    free_limit_squared2 = 4.9e-23, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 7e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 7e-14, /* nearer to that boundary two branches are one [m] */
    /* the same where they follow an angle that is good to few digits [m] */
    blur_slack1 = 6.999999999999999e-11,
    doubt_limit_squared2 = 4.9e-07, /* square of a length that fixes no angle [m^2] */
    m1 = 9.999999999999999e-09, /* doubt_limit^2 */
    m4 = 6.999999999999999e-10; /* 10 * blur_slack1 [m] */
/* coefficients */
static const double m3 = 4.0;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const olson_pprrrr_branches[4] = {
    "noflip3-noflip5", "noflip3-flip5", "flip3-noflip5", "flip3-flip5",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 0, 0, 1, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 0.02040816326530612, 0.02040816326530612, 1.0, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 7e-09) /* of limits */
/* Of the values of a free joint that are tried, from one to the next. */
static const double fan_step[6] = {
    0.6872233929727672, 0.6872233929727672, 0.09817477042468103, 0.09817477042468103,
    0.09817477042468103, 0.09817477042468103,
};

void olson_pprrrr_fk(const double q[6], double T[16])
{
    const double c3 = cos(q[2]), s3 = sin(q[2]);
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = s3 * c4, v1 = c3 * c4, v2 = s3 * s4,
        y4_y = c3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v2 * s5,
        x5_y = y4_y * s5 - v1 * c5, x5_z = s4 * c5 + c4 * s5, z6_x = v2 * c5 + x4_x * s5,
        y5_y = y4_y * c5 + v1 * s5, y5_z = c4 * c5 - s4 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - c3 * s6; T[1] = -(c3 * c6 + x5_x * s6); T[2] = z6_x;
    T[3] = q[1] + x4_x * a4 + z6_x * d6;
    T[4] = x5_y * c6 - s3 * s6; T[5] = -(s3 * c6 + x5_y * s6); T[6] = -y5_y;
    T[7] = q[0] - v1 * a4 - y5_y * d6;
    T[8] = x5_z * c6; T[9] = -(x5_z * s6); T[10] = -y5_z; T[11] = d3 + s4 * a4 - y5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void olson_pprrrr_jacobian(const double q[6], double J[36])
{
    const double c3 = cos(q[2]), s3 = sin(q[2]);
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = s3 * c4, v1 = c3 * c4,
        p5_x = q[1] + x4_x * a4, p5_y = q[0] - v1 * a4, p5_z = d3 + s4 * a4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z6_x = s3 * s4 * c5 + x4_x * s5,
        y5_y = c3 * s4 * c5 + v1 * s5, y5_z = c4 * c5 - s4 * s5, p6_x = p5_x + z6_x * d6,
        p6_y = p5_y - y5_y * d6, p6_z = p5_z - y5_z * d6, J23 = p6_x - q[1], v2 = p6_y - q[0],
        v3 = p6_z - d3, v4 = p6_z - p5_z;
    J[0] = 0.0; J[1] = 1.0; J[2] = -v2; J[3] = -(s3 * v3); J[4] = -(s3 * v4); J[5] = 0.0;
    J[6] = 1.0; J[7] = 0.0; J[8] = J23; J[9] = c3 * v3; J[10] = c3 * v4; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = s3 * J23 - c3 * v2;
    J[16] = s3 * (p6_x - p5_x) - c3 * (p6_y - p5_y); J[17] = 0.0;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = -c3; J[22] = -c3; J[23] = z6_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = -s3; J[28] = -s3; J[29] = -y5_y;
    J[30] = 0.0; J[31] = 0.0; J[32] = 1.0; J[33] = 0.0; J[34] = 0.0; J[35] = -y5_z;
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
HELPER wide_mask solve_wide(const wide T[16], wide q[24], wide_mask kind[4])
{
    ENTRIES(wide);

    /* theta3 */
    const wide v1 = T23 * T23 + T13 * T13, w3 = sqrt_wide(v1), v2 = 1.0 / v1, factor3 = w3 * v2,
        angle1 = atan2_wide(-T13, T23);

    /* theta45 */
    const wide angle2 = atan2_wide(-w3, -T33);

    /* theta6 */
    const wide v3 = v2 * (T23 * T12 - T13 * T22), v4 = v2 * (T23 * T11 - T13 * T21),
        angle3 = atan2_wide(-v4, -v3);

    /* theta5 */
    const wide X5 = a4 * T33,
        Y5 = w3 * (m3 * (v2 * (T23 * (T11 * T32 - T12 * T31) + T13 * (T22 * T31 - T21 * T32)))),
        N5 = X5 * X5 + Y5 * Y5, v5 = d6 * T33 + (d3 - T34), D5 = N5 - v5 * v5, w5 = sqrt_wide(D5),
        v6 = w5 - w5, inverse5 = 1.0 / N5, v7 = X5 * v5, v8 = Y5 * v5, v9 = X5 * w5, v10 = Y5 * w5,
        v11 = v10 - v7, v12 = v8 + v9, angle4 = atan2_wide(v11, -v12), v13 = v8 - v9,
        angle5 = atan2_wide(-(v7 + v10), -v13), angle6 = atan2_wide(-(v7 + v10), v13),
        angle7 = atan2_wide(v11, v12);

    /* r2 */
    const wide v14 = a4 * (T13 * factor3),
        v15 = T33 * X5 - w3 * (a4 * (w3 * v4 * T32 - w3 * v3 * T31)), v16 = w3 * v7 + T33 * v8,
        v17 = T14 - d6 * T13 + inverse5 * (v14 * v16), q2_pp = v17 + w5 * (inverse5 * (v14 * v15)),
        q2_pm = v17 + w5 * (inverse5 * (v14 * -v15));

    /* r1 */
    const wide v18 = a4 * (T23 * factor3), v19 = T24 - d6 * T23 + inverse5 * (v16 * v18),
        q1_pp = v19 + w5 * (inverse5 * (v15 * v18)), q1_pm = v19 + w5 * (inverse5 * (-v15 * v18));

    /* joint values */
    const wide v20 = angle2 - angle4, v21 = angle2 - angle5, v22 = angle2 + angle6,
        v23 = angle2 + angle7, q3_pp = angle1 + v6,
        q3_mp = v6 + (angle1 - signed_wide(half_turn, -T13)), q6_pp = angle3 + v6,
        q6_mp = v6 + (angle3 - signed_wide(half_turn, -v4));

    q[0] = q1_pp; q[1] = q2_pp; q[2] = q3_pp; q[3] = centred_wide(v20); q[4] = angle4; q[5] = q6_pp;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_pm; q[7] = q2_pm; q[8] = q3_pp; q[9] = centred_wide(v21); q[10] = angle5;
    q[11] = q6_pp;
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_pm; q[13] = q2_pm; q[14] = q3_mp;
    q[15] = pick_wide(-v22 <= -half_turn, all_wide(turn), only_wide(half_turn < -v22, -turn)) - v22;
    q[16] = angle6; q[17] = q6_mp;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_pp; q[19] = q2_pp; q[20] = q3_mp;
    q[21] = pick_wide(-v23 <= -half_turn, all_wide(turn), only_wide(half_turn < -v23, -turn)) - v23;
    q[22] = angle7; q[23] = q6_mp;
    kind[3] = kind_of(q[18], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((N5 <= doubt_limit_squared2) | (abs_wide(D5) <= m4 * (blur_slack1 + 2.0 *
        abs_wide(v5))) | (v1 <= m1));
}

#if LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[4][6], unsigned char status[4])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta3 */
    const double v1 = T23 * T23 + T13 * T13, w3 = sqrt(v1), v2 = 1.0 / v1, factor3 = w3 * v2,
        v3 = copysign(half_turn, -T13);
    const four v4 = m2 * (e1 - 1.0);

    /* theta6 */
    const double v5 = v2 * (T23 * T12 - T13 * T22), v6 = v2 * (T23 * T11 - T13 * T21),
        v7 = copysign(half_turn, -v6);

    /* theta5 */
    const double X5 = a4 * T33, v8 = a4 * (w3 * v6 * T32 - w3 * v5 * T31),
        Y5 = w3 * (m3 * (v2 * (T23 * (T11 * T32 - T12 * T31) + T13 * (T22 * T31 - T21 * T32)))),
        N5 = X5 * X5 + Y5 * Y5, v9 = d6 * T33 + (d3 - T34), D5 = N5 - v9 * v9, w5 = sqrt(D5),
        v10 = w5 - w5, inverse5 = 1.0 / N5, v11 = X5 * v9, v12 = Y5 * v9, v13 = X5 * w5;
    const four v14 = e1 * v12, v15 = e2 * v13;
    const double v16 = Y5 * w5;
    const four v17 = e1 * e2;

    /* r2 */
    const double wx = T14 - d6 * T13, v18 = a4 * (T13 * factor3);
    const four v19 = X5 * (T33 * v17) - v8 * (w3 * v17);
    const double v20 = w3 * v11;
    const four v21 = v20 + v14 * (e1 * T33), v22 = wx + inverse5 * (v18 * v21),
        q2 = v22 + w5 * (inverse5 * (v18 * v19));

    /* r1 */
    const double wy = T24 - d6 * T23, v23 = a4 * (T23 * factor3);
    const four v24 = wy + inverse5 * (v21 * v23), q1 = v24 + w5 * (inverse5 * (v19 * v23));

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0)) | (unsigned)((N5 <= doubt_limit_squared2)
        | (fabs(D5) <= m4 * (blur_slack1 + 2.0 * fabs(v9))) | (v1 <= m1)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ -T13, -w3, -v6, -T13 }, (four){ T23, -T33, -v5, T23
        }), ratio2 = ratio_four(v16 * v17 - v11, -(v14 + v15));
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = shuffle(packed1, packed1, 2, 2, 2, 2), angle4 = angle_four(ratio2);
    const four v25 = e1 * angle2, v26 = v25 - angle4, q4 = centred_four(v26),
        q3 = v10 + (angle1 + v3 * v4), q6 = v10 + (angle3 + v4 * v7);

    store_4(&q[0][0], &q[1][0], &q[2][0], &q[3][0], q1, q2, q3, q4);
    store_2(&q[0][4], &q[1][4], &q[2][4], &q[3][4], angle4, q6);
    const unsigned long long none1 = (bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[24], x[LANES];
    wide_mask kind[4];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 24; i += LANES) {
        const int from = i + LANES <= 24 ? i : 24 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 24 * k + from) = x[k];
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
HELPER int solve_regular(const double T[16], double q[4][6], unsigned char status[4])
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
    const double T[16], const double seed[6], double q[4][6], unsigned char status[4])
{
    ENTRIES(double);

    /* theta3, type 2: U3[2, 3] */
    const double w3 = sqrt(T23 * T23 + T13 * T13);
    const int free3 = w3 <= free_limit;
    const double divisor3 = free3 ? 1.0 : w3;
    const int near3 = w3 <= near_limit;

    /* theta5, type 2: U0 (A5 A6)^-1 [3, 4] */
    const double X5 = T33 * a4;
    const double v3 = X5 * X5, v4 = T33 * d6 + (d3 - T34), v5 = v4 * v4, v6 = fabs(v4),
        v7 = 2.0 * v6, v8 = merge_slack1 * (v7 + merge_slack1),
        v9 = blur_slack1 * (v7 + blur_slack1), v10 = X5 * v4;

    /* r2, type 1: U0 A6^-1 [1, 4] */
    const double wx = T14 - T13 * d6;

    /* r1, type 1: U0 A6^-1 [2, 4] */
    const double wy = T24 - T23 * d6;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip3, flip3 */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e1 < 0.0 && free3) continue; /* both signs give the same */
        const double factor3 = e1 / divisor3;
        const double v1 = T23 * factor3, v2 = T13 * factor3;
        const double off3 = near3 ? w3 * fabs(v1 * sin(seed[2]) + v2 * cos(seed[2])) : 1.0;
        const double ahead3 = near3 ? v1 * cos(seed[2]) - v2 * sin(seed[2]) : -1.0;
        const int same3 = near3 && 0.0 < ahead3 && off3 <= free_limit;
        const int held3 = free3 || same3;
        const double c3 = held3 ? cos(seed[2]) : v1, s3 = held3 ? sin(seed[2]) : -v2;
        const double q3 = atan2(s3, c3);
        const double root3 = w3 * e1;

        /* theta45, type 3: U3[3, 3] and U3[1, 3] */
        const double theta45 = atan2(-root3, -T33);

        /* theta6, type 3: U3[2, 2] and U3[2, 1] */
        const double Z1_6 = T12 * c3 + T22 * s3;
        const double Z2_6 = T11 * c3 + T21 * s3;
        const double q6 = atan2(-Z2_6, -Z1_6);

        /* theta5 */
        const double Y5 = a4 * (T32 * Z2_6 - T31 * Z1_6);
        const double N5 = v3 + Y5 * Y5;
        const int free5 = N5 <= free_limit_squared2;
        const double D5 = N5 - v5;
        const int apart5 = v8 < D5;
        if (!(-(reach_slack1 * (v7 + reach_slack1)) <= D5)) {
            if (near3) lose(NEARLY + 3, D5, q[2 * i1], &status[2 * i1]);
            if (near3) q[2 * i1][1] = atan2(-v2, v1);
            if (free3) lose(LOST + 3, D5, q[2 * i1], &status[2 * i1]);
            continue; /* out of reach */
        }
        const double w5 = sqrt(apart5 ? D5 : 0.0);
        const double inverse5 = 1.0 / (free5 ? 1.0 : (apart5 ? N5 : v6 * sqrt(N5)));
        const double v11 = Y5 * v4;

        /* r2 */
        const double v13 = s3 * a4;

        /* r1 */
        const double v14 = c3 * a4;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip5, flip5 */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta5 */
            if (e2 < 0.0 && (free5 || !apart5 || (near3 && !(v9 < D5))))
                continue; /* both signs give the same */
            const double root5 = w5 * e2;
            const double c5 = free5 ? cos(seed[4]) : -(inverse5 * (v11 + X5 * root5)),
                s5 = free5 ? sin(seed[4]) : inverse5 * (Y5 * root5 - v10);
            const double q5 = atan2(s5, c5);

            /* r2 */
            const double v12 = T33 * c5 + root3 * s5;
            const double r2 = wx + v12 * v13;

            /* r1 */
            const double r1 = wy - v12 * v14;

            /* joint values */
            const double q4 = wrap(theta45 - q5);
            const int row = 2 * i1 + i2;
            q[row][0] = r1; q[row][1] = r2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free3 || free5) ? FREE : OK;
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
    double seed[6], start, q[4][6];
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
    solve(s->T, s->seed, s->q, s->status);
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
    const double T[16], const double seed[6], int row, double q[4][6], unsigned char status[4])
{
    const int nearly = status[row] > NEARLY;
    struct search lost = { .T = T, .row = row };
    lost.joint = status[row] - (nearly ? NEARLY : LOST) - 1;
    take(seed, lost.seed);
    lost.start = nearly ? q[row][1] : seed[lost.joint];
    if (revolute[lost.joint])
        lost.start = fmod(lost.start, turn);
    double nearest = nearly ? serving_digits(&lost) : serving_value(&lost);
    attempt(&lost, isnan(nearest) ? 0.0 : nearest);
    const int served = !isnan(nearest) && serves(&lost);
    status[row] = served ? lost.status[row] : NONE;
    for (int i = 0; i < 6; i++)
        q[row][i] = served ? lost.q[row][i] : (double)NAN;
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
static const double weights[6] = { 0.1429, 0.1429, 0.1429, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 7.0, 7.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    olson_pprrrr_fk(x, P);
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
    olson_pprrrr_jacobian(x, J);
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
    const double T[16], const double seed[6], double q[4][6],
    unsigned char status[4])
{
    double x[6], half[6], e[6], least = HUGE_VAL, nearest = 0.001;
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
    const double T[16], const double *q_seed, double q[4][6], unsigned char status[4])
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
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 4; row++)
        if (status[row] >= LOST)
            choose_again(pose, seed, row, q, status);
    stay(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
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

int olson_pprrrr_ik(
    const double T[16], const double *q_seed, double q[4][6], unsigned char status[4])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int olson_pprrrr_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[4][6], found[6], least = HUGE_VAL;
    unsigned char status[4];
    int result = -NONE;
    int valid = olson_pprrrr_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 6; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 4 && valid; row++) {
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

void olson_pprrrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 24 * k, status + 4 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)olson_pprrrr_ik(
                    T + 16 * i, NULL, (double (*)[6])(q + 24 * i), status + 4 * i);
    }
#endif
    for (; k < n; k++)
        (void)olson_pprrrr_ik(T + 16 * k, NULL, (double (*)[6])(q + 24 * k), status + 4 * k);
}
