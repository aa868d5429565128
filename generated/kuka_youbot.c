/* kuka_youbot: KUKA youBot arm
 *
 * Inverse kinematics, generated from robots/kuka_youbot.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_youbot.yaml. The formulas and where they come from:
 * kuka_youbot.md.
 */
#include "kuka_youbot.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = KUKA_YOUBOT_OK, NONE = KUKA_YOUBOT_UNREACHABLE, FREE = KUKA_YOUBOT_FREE_JOINT,
    OUT = KUKA_YOUBOT_OUT_OF_LIMITS, INVALID = KUKA_YOUBOT_INVALID_POSE
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

#ifndef KUKA_YOUBOT_LIBM
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
 * -DKUKA_YOUBOT_SCALAR. With -DKUKA_YOUBOT_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(KUKA_YOUBOT_SCALAR) && !defined(KUKA_YOUBOT_LIBM)
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
#ifdef KUKA_YOUBOT_LIBM /* half the time of atan2 */
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
static const double
    d1 = 0.147, /* joint offset 1 [m] */
    a1 = 0.033, /* link length 1 [m] */
    a2 = 0.155, /* link length 2 [m] */
    a3 = 0.135, /* link length 3 [m] */
    d5 = 0.2175, /* joint offset 5 [m] */
    second_weight = 0.6875, /* lengths count in arm sizes [m] */
    free_limit1 = 6.874999999999999e-13, /* a length that fixes no angle [m] */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    offset4 = 1.5707963267948966, /* offset of joint 4 [rad] */
    longest3 = 0.08410000000000002, /* square of the longest reach [m^2] */
    shortest3 = 0.0003999999999999996, /* square of the shortest reach [m^2] */
    longest3_reach = 0.08410000000003988, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.00039999999999724956, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.08409999999999603, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.00040000000000027465, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 4.7265625e-25, /* square of a length that fixes no angle [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 6.875e-06, /* a pose may be rounded by this [m] */
    k1 = 0.04225, /* a2^2 + a3^2 [m^2] */
    k2 = 23.894862604540023, /* 1 / (2 * a3 * a2) [m^-2] */
    m1 = 4.726562499999999e-09, /* doubt_limit1^2 [m^2] */
    m3 = 9.999999999999997e-17, /* doubt_limit_squared^2 */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m4 = 3.345324017800363e-13,
    m7 = 2.2340393066406244e-17, /* doubt_limit_squared2^2 [m^4] */
    m10 = 1.0000000000000002e-10, /* pose_slack^2 */
    m11 = 4.7265625e-11, /* pose_slack1^2 [m^2] */
    m12 = 1.41796875e-10; /* 3 * pose_slack1^2 [m^2] */
/* coefficients */
static const double m5 = 3.2258064516129035, m6 = 0.018709677419354823, m8 = 3.7037037037037037,
m9 = 0.021481481481481466;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T33 = T[10], T34 = T[11]

const char *const kuka_youbot_branches[4] = {
    "left-down", "left-up", "right-down", "right-up",
};

static const double lowest[5] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[5] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void kuka_youbot_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 - v3 * s3, x3_z = s2 * c3 + c2 * s3, v4 = v2 * c3 + x2_x * s3,
        v5 = v3 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), x4_x = x3_x * c4 - v4 * s4, x4_y = x3_y * c4 - v5 * s4,
        x4_z = x3_z * c4 + y3_z * s4, z4_x = v4 * c4 + x3_x * s4, z4_y = v5 * c4 + x3_y * s4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x4_x * c5 + s1 * s5; T[1] = s1 * c5 - x4_x * s5; T[2] = z4_x;
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5;
    T[4] = x4_y * c5 - c1 * s5; T[5] = -(c1 * c5 + x4_y * s5); T[6] = z4_y;
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5;
    T[8] = x4_z * c5; T[9] = -(x4_z * s5); T[10] = z4_z;
    T[11] = d1 + s2 * a2 + x3_z * a3 + z4_z * d5;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kuka_youbot_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 - v3 * s3, x3_z = s2 * c3 + c2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3, v4 = q[3] + offset4;
    const double c4 = cos(v4), s4 = sin(v4), z4_x = (v2 * c3 + x2_x * s3) * c4 + x3_x * s4,
        z4_y = (v3 * c3 + x2_y * s3) * c4 + x3_y * s4, z4_z = x3_z * s4 - (c2 * c3 - s2 * s3) * c4,
        p5_x = p3_x + z4_x * d5, p5_y = p3_y + z4_y * d5, p5_z = p3_z + z4_z * d5, v5 = p5_z - d1,
        v6 = p5_z - p2_z, v7 = p5_x - p3_x, v8 = p5_y - p3_y, v9 = p5_z - p3_z;
    J[0] = -p5_y; J[1] = -(c1 * v5); J[2] = -(c1 * v6); J[3] = -(c1 * v9);
    J[4] = z4_y * v9 - z4_z * v8;
    J[5] = p5_x; J[6] = -(s1 * v5); J[7] = -(s1 * v6); J[8] = -(s1 * v9);
    J[9] = z4_z * v7 - z4_x * v9;
    J[10] = 0.0; J[11] = s1 * (p5_y - p1_y) + c1 * (p5_x - p1_x);
    J[12] = s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x); J[13] = s1 * v8 + c1 * v7;
    J[14] = z4_x * v8 - z4_y * v7;
    J[15] = 0.0; J[16] = s1; J[17] = s1; J[18] = s1; J[19] = z4_x;
    J[20] = 0.0; J[21] = -c1; J[22] = -c1; J[23] = -c1; J[24] = z4_y;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = z4_z;
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
HELPER wide_mask solve_wide(const wide T[16], wide q[20], wide_mask kind[4])
{
    ENTRIES(wide);

    /* theta1 */
    const wide v1 = signed_wide(second_weight, T14 * T13 + T24 * T23), v2 = T14 + T13 * v1,
        v3 = T24 + T23 * v1, v4 = v2 * v2 + v3 * v3, w1 = sqrt_wide(v4), v5 = 1.0 / v4,
        factor1 = w1 * v5, c1 = v2 * factor1, s1 = v3 * factor1, angle1 = atan2_wide(v3, v2);

    /* theta234 */
    const wide Z2_234 = w1 * (v5 * (T13 * v2 + T23 * v3)), v6 = T33 * T33 + Z2_234 * Z2_234,
        w234 = sqrt_wide(v6), v7 = 1.0 / v6, factor234 = w234 * v7,
        angle2 = atan2_wide(Z2_234, -T33);

    /* theta5 */
    const wide S5 = w1 * (v5 * (v2 * T21 - v3 * T11)), C5 = w1 * (v5 * (v2 * T22 - v3 * T12)),
        v8 = S5 * S5 + C5 * C5, v9 = sqrt_wide(v8) * (1.0 / v8), v10 = C5 * v9, v11 = S5 * v9,
        angle3 = atan2_wide(-S5, -C5);

    /* theta3 */
    const wide v12 = factor234 * (d5 * T33), Z1_3 = T34 - d1 - v12, v13 = d5 * Z2_234,
        v14 = T14 * c1 + T24 * s1, v15 = v14 - a1, v16 = a1 + v14, v17 = factor234 * v13,
        v18 = v15 - v17, v19 = v17 - v16, v20 = w234 * (v7 * v13), Z2_3_p = v15 - v20,
        Z2_3_m = v20 - v16, v21 = Z1_3 * Z1_3, N3_p = v21 + Z2_3_p * Z2_3_p,
        N3_m = v21 + Z2_3_m * Z2_3_m, D3_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = sqrt_wide(D3_p),
        w3_m = sqrt_wide(D3_m), v22 = w3_p - w3_p, v23 = w3_m - w3_m,
        angle4 = atan2_wide(w3_p, N3_p - k1), angle5 = atan2_wide(w3_m, N3_m - k1);

    /* theta2 */
    const wide v24 = m6 + m5 * N3_p, v25 = m6 + m5 * N3_m, v26 = Z1_3 * v24, v27 = Z1_3 * v25,
        S2_pp = v26 - w3_p * (m5 * v18), S2_pm = v26 - w3_p * (m5 * -v18),
        S2_mp = v27 - w3_m * (m5 * v19), S2_mm = v27 - w3_m * (m5 * -v19), v28 = m5 * Z1_3,
        v29 = m5 * -Z1_3, v30 = v18 * v24, v31 = v19 * v25, C2_pp = v30 + w3_p * v28,
        C2_pm = v30 + w3_p * v29, C2_mp = v31 + w3_m * v28, C2_mm = v31 + w3_m * v29,
        v32 = S2_pp * S2_pp + C2_pp * C2_pp, v33 = S2_pm * S2_pm + C2_pm * C2_pm,
        v34 = S2_mp * S2_mp + C2_mp * C2_mp, v35 = S2_mm * S2_mm + C2_mm * C2_mm,
        w2_pp = sqrt_wide(v32), w2_pm = sqrt_wide(v33), w2_mp = sqrt_wide(v34),
        w2_mm = sqrt_wide(v35), v36 = 1.0 / v32, v37 = 1.0 / v33, v38 = 1.0 / v34, v39 = 1.0 / v35,
        factor2_pp = w2_pp * v36, factor2_pm = w2_pm * v37, factor2_mp = w2_mp * v38,
        factor2_mm = w2_mm * v39, angle6 = atan2_wide(S2_pp, C2_pp),
        angle7 = atan2_wide(S2_pm, C2_pm), angle8 = atan2_wide(S2_mp, C2_mp),
        angle9 = atan2_wide(S2_mm, C2_mm);

    /* is the pose one that the arm can take? */
    const wide v40 = m8 * Z1_3, v41 = m8 * -Z1_3, v42 = m8 * N3_p - m9, v43 = m8 * N3_m - m9,
        v44 = v18 * v42, v45 = v19 * v43, v46 = Z1_3 * v42, v47 = Z1_3 * v43, v48 = a1 + v17,
        v49 = a1 - v17, v50 = v48 + w2_pp * (v36 * (a3 * (v44 - w3_p * v40) + a2 * C2_pp)),
        v51 = v48 + w2_pm * (v37 * (a3 * (v44 - w3_p * v41) + a2 * C2_pm)),
        v52 = v49 + w2_mp * (v38 * (a3 * (v45 - w3_m * v40) + a2 * C2_mp)),
        v53 = v49 + w2_mm * (v39 * (a3 * (v45 - w3_m * v41) + a2 * C2_mm)), v54 = d1 + v12,
        v55 = T33 - T33 * factor234, v56 = T31 + factor234 * (Z2_234 * v10),
        v57 = T23 - factor234 * (s1 * Z2_234),
        v58 = T21 - (c1 * v11 + factor234 * (v10 * (s1 * T33))),
        v59 = T11 - (factor234 * (v10 * (c1 * T33)) - s1 * v11),
        v60 = T13 - factor234 * (c1 * Z2_234),
        v61 = T34 - (v54 + factor2_pp * (a2 * S2_pp) + factor2_pp * (a3 * (v46 + w3_p * (m8 *
            v18)))),
        v62 = T34 - (v54 + factor2_pm * (a2 * S2_pm) + factor2_pm * (a3 * (v46 + w3_p * (m8 *
            -v18)))),
        v63 = T34 - (v54 + factor2_mp * (a2 * S2_mp) + factor2_mp * (a3 * (v47 + w3_m * (m8 *
            v19)))),
        v64 = T34 - (v54 + factor2_mm * (a2 * S2_mm) + factor2_mm * (a3 * (v47 + w3_m * (m8 *
            -v19)))), v65 = T14 - c1 * v50, v66 = T14 - c1 * v51, v67 = T14 + c1 * v52,
        v68 = T14 + c1 * v53, v69 = T24 - s1 * v50, v70 = T24 - s1 * v51, v71 = T24 + s1 * v52,
        v72 = T24 + s1 * v53, v73 = v61 * v61 + v65 * v65 + v69 * v69,
        v74 = v62 * v62 + v66 * v66 + v70 * v70, v75 = v63 * v63 + v67 * v67 + v71 * v71,
        v76 = v64 * v64 + v68 * v68 + v72 * v72;

    /* joint values */
    const wide v77 = angle6 - offset2, v78 = angle7 - offset2, v79 = angle8 - offset2,
        v80 = angle9 - offset2, v81 = angle2 - (angle4 + angle6) - offset4,
        v82 = angle2 - (angle7 - angle4) - offset4, v83 = offset4 + (angle2 + (angle5 + angle8)),
        v84 = offset4 + (angle2 + (angle9 - angle5)), v85 = centred_wide(v81),
        v86 = centred_wide(v82),
        v87 = pick_wide(-v83 <= -half_turn, all_wide(turn), only_wide(half_turn < -v83, -turn)) -
            v83,
        v88 = pick_wide(-v84 <= -half_turn, all_wide(turn), only_wide(half_turn < -v84, -turn)) -
            v84;
    const double v89 = NAN;
    const wide v90 = only_wide((v73 <= m11) == 0, v89), v91 = only_wide((v74 <= m11) == 0, v89),
        v92 = only_wide((v75 <= m11) == 0, v89), v93 = only_wide((v76 <= m11) == 0, v89),
        v94 = angle1 + v22, v95 = v23 + (angle1 - signed_wide(half_turn, v3)), v96 = angle3 + v22,
        v97 = v23 + (angle3 - signed_wide(half_turn, -S5));

    q[0] = v90 + v94; q[1] = v90 + raised_wide(v77); q[2] = angle4 + v90;
    q[3] = v90 + raised_wide(v85); q[4] = v90 + v96;
    kind[0] = kind_of(q[0], 0);
    q[5] = v91 + v94; q[6] = v91 + raised_wide(v78); q[7] = v91 - angle4;
    q[8] = v91 + raised_wide(v86); q[9] = v91 + v96;
    kind[1] = kind_of(q[5], 0);
    q[10] = v92 + v95; q[11] = v92 + raised_wide(v79); q[12] = angle5 + v92;
    q[13] = v92 + raised_wide(v87); q[14] = v92 + v97;
    kind[2] = kind_of(q[10], 0);
    q[15] = v93 + v95; q[16] = v93 + raised_wide(v80); q[17] = v93 - angle5;
    q[18] = v93 + raised_wide(v88); q[19] = v93 + v97;
    kind[3] = kind_of(q[15], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v6 <= m3) | (v4 <= m1) | (v8 <= m3) | ((m11 < v76) & (v76 <= m12)) |
        (v35 <= m7) | ((m11 < v75) & (v75 <= m12)) | (v34 <= m7) | ((m11 < v74) & (v74 <= m12)) |
        (v33 <= m7) | ((m11 < v73) & (v73 <= m12)) | (v32 <= m7) | (m10 < v55 * v55 + v56 * v56 +
        v57 * v57 + v58 * v58 + v59 * v59 + v60 * v60) | (abs_wide(D3_p) <= m4) | (abs_wide(D3_m) <=
        m4));
}

#if LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[4][5], unsigned char status[4])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double v1 = copysign(second_weight, T14 * T13 + T24 * T23), v2 = T14 + T13 * v1,
        v3 = T24 + T23 * v1, v4 = v2 * v2 + v3 * v3, w1 = sqrt(v4), v5 = 1.0 / v4,
        factor1 = w1 * v5, c1 = v2 * factor1, s1 = v3 * factor1, v6 = copysign(half_turn, v3);
    const four v7 = m2 * (e1 - 1.0);

    /* theta234 */
    const double Z2_234 = w1 * (v5 * (T13 * v2 + T23 * v3)), v8 = T33 * T33 + Z2_234 * Z2_234,
        w234 = sqrt(v8), v9 = 1.0 / v8, factor234 = w234 * v9;

    /* theta5 */
    const double S5 = w1 * (v5 * (v2 * T21 - v3 * T11)), C5 = w1 * (v5 * (v2 * T22 - v3 * T12)),
        v10 = S5 * S5 + C5 * C5, v11 = sqrt(v10) * (1.0 / v10), v12 = C5 * v11, v13 = S5 * v11,
        v14 = copysign(half_turn, -S5);

    /* theta3 */
    const double v15 = factor234 * (d5 * T33), Z1_3 = T34 - d1 - v15, v16 = d5 * Z2_234,
        v17 = T14 * c1 + T24 * s1;
    const four v18 = e1 * v17 - a1;
    const double v19 = factor234 * v16;
    const four v20 = e1 * v19, v21 = v18 - v20, Z2_3 = v18 - w234 * (v9 * (e1 * v16));
    const double v22 = Z1_3 * Z1_3;
    const four N3 = v22 + Z2_3 * Z2_3, D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt_four(D3),
        v23 = w3 - w3;

    /* theta2 */
    const four v24 = e2 * v21, v25 = m6 + m5 * N3, v26 = Z1_3 * v25, S2 = v26 - w3 * (m5 * v24),
        v27 = e2 * Z1_3, v28 = m5 * v27, v29 = v21 * v25, C2 = v29 + w3 * v28,
        v30 = S2 * S2 + C2 * C2, w2 = sqrt_four(v30), v31 = 1.0 / v30, factor2 = w2 * v31;

    /* is the pose one that the arm can take? */
    const four v32 = m8 * v27, v33 = m8 * N3 - m9, v34 = v21 * v33, v35 = Z1_3 * v33,
        v36 = a1 + v20, v37 = v36 + w2 * (v31 * (a3 * (v34 - w3 * v32) + a2 * C2));
    const double v38 = d1 + v15, v39 = T33 - T33 * factor234,
        v40 = T31 + factor234 * (Z2_234 * v12), v41 = T23 - factor234 * (s1 * Z2_234),
        v42 = T21 - (c1 * v13 + factor234 * (v12 * (s1 * T33))),
        v43 = T11 - (factor234 * (v12 * (c1 * T33)) - s1 * v13),
        v44 = T13 - factor234 * (c1 * Z2_234);
    const four v45 = T34 - (v38 + factor2 * (a2 * S2) + factor2 * (a3 * (v35 + w3 * (m8 * v24)))),
        v46 = T14 - e1 * (c1 * v37), v47 = T24 - e1 * (s1 * v37),
        v48 = v45 * v45 + v46 * v46 + v47 * v47;

    /* joint values */
    const double v54 = NAN;
    const four v55 = only_four((v48 <= m11) == 0, v54);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | (abs_four(D3) <= m4) | ((v30 <= m7) |
        ((m11 < v48) & (v48 <= m12)))) | (unsigned)((v8 <= m3) | (v4 <= m1) | (m10 < v39 * v39 + v40
        * v40 + v41 * v41 + v42 * v42 + v43 * v43 + v44 * v44) | (v10 <= m3)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ -S5, -S5, -S5, -S5 }, (four){ -C5, -C5, -C5, -C5
        }),
        ratio2 = ratio_four(shuffle(shuffle(w3, all_four(v3), 0, 5, 2, 3), all_four(Z2_234), 0, 1,
            2, 7), shuffle(shuffle(N3 - k1, all_four(v2), 0, 5, 2, 3), all_four(-T33), 0, 1, 2, 7)),
        ratio3 = ratio_four(S2, C2);
    const four packed1 = angle_four(ratio1), angle3 = shuffle(packed1, packed1, 0, 0, 0, 0),
        packed2 = angle_four(ratio2), angle4 = shuffle(packed2, packed2, 0, 0, 2, 2),
        angle1 = shuffle(packed2, packed2, 1, 1, 1, 1),
        angle2 = shuffle(packed2, packed2, 3, 3, 3, 3), angle5 = angle_four(ratio3);
    const four v49 = angle5 - offset2, v50 = e2 * angle4, v51 = e1 * angle2,
        v52 = v51 - (angle5 + v50) - offset4, v53 = centred_four(v52),
        v56 = v23 + (angle1 + v6 * v7), q1 = v55 + v56, q2 = v55 + raised_four(v49), q3 = v50 + v55,
        q4 = v55 + raised_four(v53), v57 = v23 + (angle3 + v7 * v14), q5 = v55 + v57;

    store_4(&q[0][0], &q[1][0], &q[2][0], &q[3][0], q1, q2, q3, q4);
    store_1(&q[0][4], &q[1][4], &q[2][4], &q[3][4], q5);
    const unsigned long long none1 = (bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[20], x[LANES];
    wide_mask kind[4];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
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
HELPER int solve_regular(const double T[16], double q[4][5], unsigned char status[4])
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
static void lose(int why, double off, double q[5], unsigned char *status)
{
    *status = (unsigned char)why;
    q[0] = off;
}

/* Fills the rows of the branches that have a solution, and no others. The first value of a row that
 * is LOST says how far it is from a solution (negative). */
static void solve(
    const double T[16], const double seed[5], double q[4][5], unsigned char status[4])
{
    ENTRIES(double);

    /* theta1, type 2: U1[3, 4] and U1[3, 3] */
    const double v1 = copysign(second_weight, T14 * T13 + T24 * T23), v2 = T14 + T13 * v1,
        v3 = T24 + T23 * v1;
    const double w1 = sqrt(v2 * v2 + v3 * v3);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta234, type 3: U1[2, 3] and U1[1, 3] */
    const double v4 = T33 * T33, v5 = seed[1] + offset2, v6 = v5 + seed[2] + (seed[3] + offset4);

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v9 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : v2 * factor1,
            s1 = free1 ? sin(seed[0]) : v3 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta234 */
        const double Z2_234 = T13 * c1 + T23 * s1;
        const double w234 = sqrt(Z2_234 * Z2_234 + v4);
        const int free234 = w234 <= free_limit_squared;
        const double factor234 = 1.0 / (free234 ? 1.0 : w234);
        const double c234 = free234 ? cos(v6) : -(T33 * factor234),
            s234 = free234 ? sin(v6) : Z2_234 * factor234;
        const double theta234 = atan2(s234, c234);

        /* theta5, type 3: U1[3, 2] and U1[3, 1] */
        const double S5 = T21 * c1 - T11 * s1;
        const double C5 = T22 * c1 - T12 * s1;
        const double w5 = sqrt(S5 * S5 + C5 * C5);
        const int free5 = w5 <= free_limit_squared;
        const double v7 = 1.0 / (free5 ? 1.0 : w5);
        const double c5 = free5 ? cos(seed[4]) : -(C5 * v7), s5 = free5 ? sin(seed[4]) : -(S5 * v7);
        const double q5 = atan2(s5, c5);

        /* theta3 */
        const double v8 = c234 * d5;
        const double Z1_3 = v8 + v9;
        const double v10 = s234 * d5;
        const double Z2_3 = T14 * c1 + T24 * s1 - a1 - v10;
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

        /* theta2, type 3: U1[2, 4] and U1[1, 4] */
        const double X1_2 = a2 + a3 * c3;
        const double v11 = Z1_3 * X1_2, v12 = Z2_3 * X1_2;

        /* is the pose one that the arm can take? */
        const double v13 = a1 + v10, v15 = d1 - v8;
        if (!(fabs(T33 + c234) <= pose_slack && fabs(T31 - s234 * c5) <= pose_slack && fabs(T23 - s1
            * s234) <= pose_slack && fabs(T21 - (c5 * (s1 * c234) - c1 * s5)) <= pose_slack &&
            fabs(T11 - (c5 * (c1 * c234) + s1 * s5)) <= pose_slack && fabs(T13 - c1 * s234) <=
            pose_slack))
            continue; /* the arm can't take this pose */

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e2 * k2;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double Y1_2 = a3 * s3;
            const double S2 = v11 - Z2_3 * Y1_2;
            const double C2 = v12 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v5) : C2 * factor2, s2 = free2 ? sin(v5) : S2 * factor2;
            const double theta2 = atan2(s2, c2);

            /* is the pose one that the arm can take? */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
                v14 = a3 * c23 + (a2 * c2 + v13);
            if (!(fabs(T34 - (a3 * s23 + (a2 * s2 + v15))) <= pose_slack1 && fabs(T14 - c1 * v14) <=
                pose_slack1 && fabs(T24 - s1 * v14) <= pose_slack1))
                continue; /* the arm can't take this pose */

            /* joint values */
            const double q2 = wrap(theta2 - offset2);
            const double q4 = wrap(theta234 - (q3 + theta2) - offset4);
            const int free2_ = free234 || free2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            status[row] = (free1 || free2_ || free234 || free234 || free5) ? FREE : OK;
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
    double seed[5], start, q[4][5];
    unsigned char status[4];
    int joint, row;
    double best, at; /* where the arm came nearest */
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
    if (result > s->best) {
        s->best = result;
        s->at = s->seed[s->joint];
    }
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

/* Several joints are free, none serves alone: in turn each goes to where the arm came nearest. */
static double serving_in_turn(struct search *s)
{
    static const int joints[] = { 0, 1, 2, 3 };
    double serving = NAN, before = -HUGE_VAL;
    for (int k = 0; k < 12 && isnan(serving) && s->best > before; k++) {
        before = s->best;
        s->seed[s->joint] = s->at;
        s->joint = joints[k % 4];
        s->start = s->at = s->seed[s->joint];
        serving = serving_value(s);
    }
    return serving;
}

/* Another value for a joint that had been chosen, if one serves. */
static void choose_again(
    const double T[16], const double seed[5], int row, double q[4][5], unsigned char status[4])
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
    for (int i = 0; i < 5; i++)
        q[row][i] = served ? lost.q[row][i] : (double)NAN;
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
static const double weights[6] = { 1.455, 1.455, 1.455, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[5], double e[6])
{
    double P[16], square = 0.0;
    kuka_youbot_fk(x, P);
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
    kuka_youbot_jacobian(x, J);
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
    const double T[16], const double seed[5], double q[4][5],
    unsigned char status[4])
{
    double x[5], half[5], e[6], least = HUGE_VAL, nearest = 0.001;
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
    const double T[16], const double *q_seed, double q[4][5], unsigned char status[4])
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
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 5; i++)
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

int kuka_youbot_ik(
    const double T[16], const double *q_seed, double q[4][5], unsigned char status[4])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int kuka_youbot_ik_nearest(const double T[16], const double q_seed[5], double q[5])
{
    double all[4][5], found[5], least = HUGE_VAL;
    unsigned char status[4];
    int result = -NONE;
    int valid = kuka_youbot_ik(T, q_seed, all, status) >= 0;
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

void kuka_youbot_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 20 * k, status + 4 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)kuka_youbot_ik(
                    T + 16 * i, NULL, (double (*)[5])(q + 20 * i), status + 4 * i);
    }
#endif
    for (; k < n; k++)
        (void)kuka_youbot_ik(T + 16 * k, NULL, (double (*)[5])(q + 20 * k), status + 4 * k);
}
