/* planar_rrr: Planar arm with three revolute joints
 *
 * Inverse kinematics, generated from robots/planar_rrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rrr.yaml. The formulas and where they come from:
 * planar_rrr.md.
 */
#include "planar_rrr.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = PLANAR_RRR_OK, NONE = PLANAR_RRR_UNREACHABLE, FREE = PLANAR_RRR_FREE_JOINT,
    OUT = PLANAR_RRR_OUT_OF_LIMITS, INVALID = PLANAR_RRR_INVALID_POSE
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

#ifndef PLANAR_RRR_LIBM
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
 * -DPLANAR_RRR_SCALAR. With -DPLANAR_RRR_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(PLANAR_RRR_SCALAR) && !defined(PLANAR_RRR_LIBM)
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
#ifdef PLANAR_RRR_LIBM /* half the time of atan2 */
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
    a1 = 0.4, /* link length 1 [m] */
    a2 = 0.3, /* link length 2 [m] */
    a3 = 0.15, /* link length 3 [m] */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    longest2 = 0.48999999999999994, /* square of the longest reach [m^2] */
    shortest2 = 0.010000000000000007, /* square of the shortest reach [m^2] */
    longest2_reach = 0.490000000000119, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.009999999999983007, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.48999999999998795, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.010000000000001705, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 7.224999999999999e-25, /* square of a length that fixes no angle [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 8.5e-06, /* a pose may be rounded by this [m] */
    k1 = 0.25, /* a1^2 + a2^2 [m^2] */
    k2 = 4.166666666666667, /* 1 / (2 * a2 * a1) [m^-2] */
    /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
    m1 = 5.755396159656667e-12,
    m6 = 7.225e-11, /* pose_slack1^2 [m^2] */
    m7 = 1.0000000000000002e-10, /* pose_slack^2 */
    m8 = 1.445e-10; /* 2 * pose_slack1^2 [m^2] */
/* coefficients */
static const double m2 = 1.25, m3 = 0.08750000000000001, m4 = 1.666666666666667,
m5 = 0.1166666666666667;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T33 = T[10], T34 = T[11]

const char *const planar_rrr_branches[2] = {
    "down", "up",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void planar_rrr_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - x2_y * s3,
        x3_y = x2_y * c3 + x2_x * s3;
    T[0] = x3_x; T[1] = -x3_y; T[2] = 0.0; T[3] = c1 * a1 + x2_x * a2 + x3_x * a3;
    T[4] = x3_y; T[5] = x3_x; T[6] = 0.0; T[7] = s1 * a1 + x2_y * a2 + x3_y * a3;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_rrr_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2,
        p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), p3_x = p2_x + (x2_x * c3 - x2_y * s3) * a3,
        p3_y = p2_y + (x2_y * c3 + x2_x * s3) * a3;
    J[0] = -p3_y; J[1] = p1_y - p3_y; J[2] = p2_y - p3_y;
    J[3] = p3_x; J[4] = p3_x - p1_x; J[5] = p3_x - p2_x;
    J[6] = 0.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 1.0; J[16] = 1.0; J[17] = 1.0;
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
HELPER wide_mask solve_wide(const wide T[16], wide q[6], wide_mask kind[2])
{
    ENTRIES(wide);

    /* theta123 */
    const wide v1 = T21 * T21 + T11 * T11, v2 = sqrt_wide(v1) * (1.0 / v1),
        angle1 = atan2_wide(T21, T11);

    /* theta2 */
    const wide v3 = v2 * (a3 * T11), Z1_2 = T14 - v3, v4 = v2 * (a3 * T21), Z2_2 = T24 - v4,
        N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2, D2 = (longest2 - N2) * (N2 - shortest2), w2 = sqrt_wide(D2),
        angle2 = atan2_wide(w2, N2 - k1);

    /* theta1 */
    const wide v5 = m3 + m2 * N2, v6 = Z2_2 * v5, S1_p = v6 - w2 * (m2 * Z1_2),
        S1_m = v6 - w2 * (m2 * -Z1_2), v7 = Z1_2 * v5, C1_p = v7 + w2 * (m2 * Z2_2),
        C1_m = v7 + w2 * (m2 * -Z2_2), factor1 = 1.0 / N2, angle3 = atan2_wide(S1_p, C1_p),
        angle4 = atan2_wide(S1_m, C1_m);

    /* is the pose one that the arm can take? */
    const wide v8 = m4 - m5 * factor1, v9 = Z1_2 * v8, v10 = Z2_2 * v8, v11 = T33 - 1.0,
        v12 = v1 - 1.0,
        v13 = T14 - (a2 * (v9 - w2 * (m4 * (Z2_2 * factor1))) + (v3 + a1 * (C1_p * factor1))),
        v14 = T14 - (a2 * (v9 - w2 * (m4 * (-Z2_2 * factor1))) + (v3 + a1 * (C1_m * factor1))),
        v15 = T24 - (a2 * (v10 + w2 * (m4 * (Z1_2 * factor1))) + (v4 + a1 * (S1_p * factor1))),
        v16 = T24 - (a2 * (v10 + w2 * (m4 * (-Z1_2 * factor1))) + (v4 + a1 * (S1_m * factor1))),
        v17 = v13 * v13 + v15 * v15, v18 = v14 * v14 + v16 * v16;

    /* joint values */
    const wide v19 = angle1 - (angle2 + angle3), v20 = angle1 - (angle4 - angle2);
    const double v21 = NAN;
    const wide v22 = only_wide((v17 <= m6) == 0, v21), v23 = only_wide((v18 <= m6) == 0, v21);

    q[0] = angle3 + v22; q[1] = angle2 + v22; q[2] = v22 + centred_wide(v19);
    kind[0] = kind_of(q[0], 0);
    q[3] = angle4 + v23; q[4] = v23 - angle2; q[5] = v23 + centred_wide(v20);
    kind[1] = kind_of(q[3], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((m6 < T34 * T34) | (abs_wide(D2) <= m1) | (m7 < v11 * v11 + T31 * T31 +
        T23 * T23 + T13 * T13 + v12 * v12) | ((m6 < v17) & (v17 <= m8)) | ((m6 < v18) & (v18 <=
        m8)));
}

#if LANES > 1
/* One regular pose, 1 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[2][3], unsigned char status[2])
{
    const four e1 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta123 */
    const double v1 = T21 * T21 + T11 * T11, v2 = sqrt(v1) * (1.0 / v1);

    /* theta2 */
    const double v3 = v2 * (a3 * T11), Z1_2 = T14 - v3, v4 = v2 * (a3 * T21), Z2_2 = T24 - v4,
        N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2, D2 = (longest2 - N2) * (N2 - shortest2), w2 = sqrt(D2);

    /* theta1 */
    const four v5 = e1 * Z1_2;
    const double v6 = m3 + m2 * N2, v7 = Z2_2 * v6;
    const four S1 = v7 - w2 * (m2 * v5), v8 = e1 * Z2_2;
    const double v9 = Z1_2 * v6;
    const four C1 = v9 + w2 * (m2 * v8);
    const double factor1 = 1.0 / N2;

    /* is the pose one that the arm can take? */
    const double v10 = m4 - m5 * factor1, v11 = Z1_2 * v10, v12 = Z2_2 * v10, v13 = T33 - 1.0,
        v14 = v1 - 1.0;
    const four v15 = T14 - (a2 * (v11 - w2 * (m4 * (v8 * factor1))) + (v3 + a1 * (C1 * factor1))),
        v16 = T24 - (a2 * (v12 + w2 * (m4 * (v5 * factor1))) + (v4 + a1 * (S1 * factor1))),
        v17 = v15 * v15 + v16 * v16;

    /* joint values */
    const double v20 = NAN;
    const four v21 = only_four((v17 <= m6) == 0, v20);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | ((m6 < v17) & (v17 <= m8))) |
        (unsigned)((m6 < T34 * T34) | (m7 < v13 * v13 + T31 * T31 + T23 * T23 + T13 * T13 + v14 *
        v14) | (fabs(D2) <= m1)))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(shuffle(S1, all_four(T21), 0, 1, 6, 3),
        all_four(w2), 0, 1, 2, 7), shuffle(shuffle(C1, all_four(T11), 0, 1, 6, 3), all_four(N2 -
        k1), 0, 1, 2, 7));
    const four packed1 = angle_four(ratio1), angle3 = shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = shuffle(packed1, packed1, 2, 2, 2, 2),
        angle2 = shuffle(packed1, packed1, 3, 3, 3, 3);
    const four v18 = e1 * angle2, v19 = angle1 - (angle3 + v18), q1 = angle3 + v21, q2 = v18 + v21,
        q3 = v21 + centred_four(v19);

    store_2(&q[0][0], &q[1][0], &q[0][0], &q[1][0], q1, q2);
    store_1(&q[0][2], &q[1][2], &q[0][2], &q[1][2], q3);
    const unsigned long long none1 = (bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[6], x[LANES];
    wide_mask kind[2];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < LANES; k++)
            q[6 * k + i] = found[i][k];
    for (int i = 1; i < 2; i++)
        kind[0] |= kind[i] << 8 * i;
    for (int k = 0; k < LANES; k++) {
        const long long word = kind[0][k];
        __builtin_memcpy(status + 2 * k, &word, 2);
    }
    return bits_wide(left);
}
#else
HELPER int solve_regular(const double T[16], double q[2][3], unsigned char status[2])
{
    wide_mask kind[2];
    int count = 0;
    if (solve_wide(T, &q[0][0], kind))
        return -1;
    for (int row = 0; row < 2; row++) {
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
static void lose(int why, double off, double q[3], unsigned char *status)
{
    *status = (unsigned char)why;
    q[0] = off;
}

/* Fills the rows of the branches that have a solution, and no others. The first value of a row that
 * is LOST says how far it is from a solution (negative). */
static void solve(
    const double T[16], const double seed[3], double q[2][3], unsigned char status[2])
{
    ENTRIES(double);

    /* theta123, type 3: U0[1, 2] and U0[2, 2] */
    const double w123 = sqrt(T21 * T21 + T11 * T11);
    const int free123 = w123 <= free_limit_squared;
    const double v1 = 1.0 / (free123 ? 1.0 : w123), v2 = seed[0] + seed[1] + seed[2];
    const double c123 = free123 ? cos(v2) : T11 * v1, s123 = free123 ? sin(v2) : T21 * v1;
    const double theta123 = atan2(s123, c123);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double v3 = c123 * a3;
    const double Z1_2 = T14 - v3;
    const double v4 = s123 * a3;
    const double Z2_2 = T24 - v4;
    const double N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2;
    const double K2 = N2 - k1;
    const double D2 = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) {
        if (free123) lose(LOST + 1, D2, q[0], &status[0]);
        if (free123) lose(LOST + 2, D2, q[0], &status[0]);
        if (free123) lose(LOST + 3, D2, q[0], &status[0]);
        return; /* out of reach */
    }
    const double w2 = sqrt(apart2 ? D2 : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_1 = a1 + a2 * c2;
    const double v5 = Z2_2 * X1_1, v6 = Z1_2 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabs(T34) <= pose_slack1 && fabs(T33 - 1.0) <= pose_slack && fabs(T31) <= pose_slack &&
        fabs(T23) <= pose_slack && fabs(T21 - s123) <= pose_slack && fabs(T11 - c123) <= pose_slack
        && fabs(T13) <= pose_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e1 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e1 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v5 - Z1_2 * Y1_1;
        const double C1 = v6 + Z2_2 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const double factor1 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : C1 * factor1,
            s1 = free1 ? sin(seed[0]) : S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1, s12 = c2 * s1 + s2 * c1;
        if (!(fabs(T14 - (a2 * c12 + (v3 + a1 * c1))) <= pose_slack1 && fabs(T24 - (a2 * s12 + (v4 +
            a1 * s1))) <= pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q3 = wrap(theta123 - (q2 + q1));
        const int free1_ = free123 || free1;
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
        status[row] = (free1_ || free123 || free123) ? FREE : OK;
    }
}

static void take(const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
}

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const double *T;
    double seed[3], start, q[2][3];
    unsigned char status[2];
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
    for (int i = 0; i < 2; i++)
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
    static const int joints[] = { 0, 1, 2 };
    double serving = NAN, before = -HUGE_VAL;
    for (int k = 0; k < 12 && isnan(serving) && s->best > before; k++) {
        before = s->best;
        s->seed[s->joint] = s->at;
        s->joint = joints[k % 3];
        s->start = s->at = s->seed[s->joint];
        serving = serving_value(s);
    }
    return serving;
}

/* Another value for a joint that had been chosen, if one serves. */
static void choose_again(
    const double T[16], const double seed[3], int row, double q[2][3], unsigned char status[2])
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
    for (int i = 0; i < 3; i++)
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
static double half_way(const double x[3], const double q[3], double half[3])
{
    double most = 0.0;
    for (int i = 0; i < 3; i++) {
        double off = q[i] - x[i];
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 1.176, 1.176, 1.176, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[3] = { 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[3], double e[6])
{
    double P[16], square = 0.0;
    planar_rrr_fk(x, P);
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
static void add_step(const int held[3], double damping, double e[6], double x[3])
{
    double A[6][9] = { { 0.0 } }, square[6] = { 0.0 }, J[18];
    planar_rrr_jacobian(x, J);
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
    const double T[16], const double seed[3], double q[2][3],
    unsigned char status[2])
{
    double x[3], half[3], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    take(seed, x);
    if (!settle(T, 1e-12, 0.15, x))
        return;
    for (int row = 2 - 1; row >= 0; row--) {
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
    const double T[16], const double *q_seed, double q[2][3], unsigned char status[2])
{
    const double zeros[3] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 3; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    if (valid == 2 && (count = solve_regular(pose, q, status)) >= 0)
        return count;
    count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++)
        if (status[row] >= LOST)
            choose_again(pose, seed, row, q, status);
    stay(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
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

int planar_rrr_ik(
    const double T[16], const double *q_seed, double q[2][3], unsigned char status[2])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int planar_rrr_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[2][3], found[3], least = HUGE_VAL;
    unsigned char status[2];
    int result = -NONE;
    int valid = planar_rrr_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 3; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 2 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 3; i++) {
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

void planar_rrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 6 * k, status + 2 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)planar_rrr_ik(T + 16 * i, NULL, (double (*)[3])(q + 6 * i), status + 2 * i);
    }
#endif
    for (; k < n; k++)
        (void)planar_rrr_ik(T + 16 * k, NULL, (double (*)[3])(q + 6 * k), status + 2 * k);
}
