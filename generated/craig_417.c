/* craig_417: Arm of exercise 4.17 in Craig, Introduction to Robotics
 *
 * Inverse kinematics, generated from robots/craig_417.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/craig_417.yaml. The formulas and where they come from:
 * craig_417.md.
 */
#include "craig_417.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = CRAIG_417_OK, NONE = CRAIG_417_UNREACHABLE, FREE = CRAIG_417_FREE_JOINT,
    OUT = CRAIG_417_OUT_OF_LIMITS, INVALID = CRAIG_417_INVALID_POSE
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

#ifndef CRAIG_417_LIBM
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
 * -DCRAIG_417_SCALAR. With -DCRAIG_417_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(CRAIG_417_SCALAR) && !defined(CRAIG_417_LIBM)
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
#ifdef CRAIG_417_LIBM /* half the time of atan2 */
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
    sqrt2 = 1.4142135623730951, /* square root of 2 */
    d4 = 1.0, /* joint offset 4 [m] */
    a3 = 1.0, /* link length 4 [m] */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    free_limit_squared2 = 9e-24, /* square of a length that fixes no angle [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 3.0000000000000004e-05, /* a pose may be rounded by this [m] */
    k1 = 0.5, /* 1 / 2 */
    k2 = 0.7071067811865476, /* sqrt2 * 1 / 2 */
    k3 = 0.5000000000000001, /* k2^2 */
    k4 = 1.4142135623731953e-13, /* reach_slack * (2 * sqrt2 * 1 / 2 + reach_slack) */
    k5 = 1.4142135623731051e-14, /* merge_slack * (2 * sqrt2 * 1 / 2 + merge_slack) */
    k6 = 2.0, /* d3 + d4 [m] */
    k7 = 2.8284271247461903, /* sqrt2 * k6 [m] */
    m1 = 1.414213562373105e-11, /* 1000 * k5 */
    m2 = 9.999999999999997e-17, /* doubt_limit_squared^2 */
    m6 = 8.1e-15, /* doubt_limit_squared2^2 [m^4] */
    m7 = 9.000000000000002e-10, /* pose_slack1^2 [m^2] */
    m8 = 2.7000000000000006e-09, /* 3 * pose_slack1^2 [m^2] */
    m9 = 1.0000000000000002e-10, /* pose_slack^2 */
    m10 = 6.000000000000001e-10; /* 6 * pose_slack^2 */
/* coefficients */
static const double m3 = 0.7071067811865476, m4 = 0.5, m5 = 1.4142135623730951;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T33 = T[10], T34 = T[11]

const char *const craig_417_branches[2] = {
    "left", "right",
};

static const double lowest[4] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[4] = { INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void craig_417_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2 * k2,
        v2 = s1 * s2 * k2, z3_z = c2 * k2, v3 = s1 * k2, z3_x = v1 - v3, v4 = c1 * k2,
        z3_y = v2 + v4, v5 = v1 + v3, v6 = v4 - v2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v5 * s3,
        x3_y = x2_y * c3 + v6 * s3, v7 = s2 * c3 + z3_z * s3, v8 = v5 * c3 + x2_x * s3,
        y3_y = v6 * c3 - x2_y * s3, y3_z = s2 * s3 - z3_z * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]);
    T[0] = x3_x * c4 - v8 * s4; T[1] = -(v8 * c4 + x3_x * s4); T[2] = z3_x;
    T[3] = z3_x + x3_x * a3 + z3_x * d4;
    T[4] = x3_y * c4 + y3_y * s4; T[5] = y3_y * c4 - x3_y * s4; T[6] = z3_y;
    T[7] = z3_y + x3_y * a3 + z3_y * d4;
    T[8] = y3_z * s4 - v7 * c4; T[9] = y3_z * c4 + v7 * s4; T[10] = z3_z;
    T[11] = z3_z - v7 * a3 + z3_z * d4;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void craig_417_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), v1 = c1 * s2 * k2, v2 = s1 * s2 * k2,
        z3_z = c2 * k2, v3 = s1 * k2, z3_x = v1 - v3, v4 = c1 * k2, z3_y = v2 + v4;
    const double c3 = cos(q[2]), s3 = sin(q[2]),
        p4_x = z3_x + (c1 * c2 * c3 - (v1 + v3) * s3) * a3 + z3_x * d4,
        p4_y = z3_y + (s1 * c2 * c3 + (v4 - v2) * s3) * a3 + z3_y * d4,
        p4_z = z3_z - (s2 * c3 + z3_z * s3) * a3 + z3_z * d4, v5 = p4_x - z3_x, v6 = p4_y - z3_y,
        v7 = p4_z - z3_z;
    J[0] = -p4_y; J[1] = c1 * p4_z; J[2] = z3_y * v7 - z3_z * v6; J[3] = 0.0;
    J[4] = p4_x; J[5] = s1 * p4_z; J[6] = z3_z * v5 - z3_x * v7; J[7] = 0.0;
    J[8] = 0.0; J[9] = -(s1 * p4_y + c1 * p4_x); J[10] = z3_x * v6 - z3_y * v5; J[11] = 0.0;
    J[12] = 0.0; J[13] = -s1; J[14] = z3_x; J[15] = z3_x;
    J[16] = 0.0; J[17] = c1; J[18] = z3_y; J[19] = z3_y;
    J[20] = 1.0; J[21] = 0.0; J[22] = z3_z; J[23] = z3_z;
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
HELPER wide_mask solve_wide(const wide T[16], wide q[8], wide_mask kind[2])
{
    ENTRIES(wide);

    /* theta1 */
    const wide N1 = T13 * T13 + T23 * T23, D1 = N1 - k3, w1 = sqrt_wide(D1), inverse1 = 1.0 / N1,
        v1 = k2 * T13, v2 = k2 * T23, v3 = inverse1 * v2, v4 = w1 * (T13 * inverse1),
        c1_p = v3 - v4, c1_m = v3 + v4, v5 = inverse1 * v1, v6 = w1 * (T23 * inverse1),
        v7 = v5 + v6, v8 = v5 - v6;

    /* theta2 */
    const wide S2 = k2 * w1, v9 = k2 * T33, v10 = v9 * v9 + S2 * S2, w2 = sqrt_wide(v10),
        v11 = 1.0 / v10, v12 = w2 * v11, c2 = v9 * v12, v13 = S2 * v12,
        angle1 = atan2_wide(-S2, v9);

    /* theta34 */
    const wide v14 = T23 * T11 - T13 * T21, v15 = m3 * (inverse1 * (v1 * T11 + v2 * T21)),
        v16 = v15 + w1 * (m3 * (inverse1 * v14)), v17 = v15 + w1 * (m3 * (inverse1 * -v14)),
        v18 = T23 * T12 - T13 * T22, v19 = m3 * (inverse1 * (v1 * T12 + v2 * T22)),
        v20 = v19 + w1 * (m3 * (inverse1 * v18)), v21 = v19 + w1 * (m3 * (inverse1 * -v18)),
        v22 = v16 * v16 + v20 * v20, v23 = v17 * v17 + v21 * v21,
        v24 = sqrt_wide(v22) * (1.0 / v22), v25 = sqrt_wide(v23) * (1.0 / v23);

    /* theta3 */
    const wide v26 = 2.0 * T24, v27 = 2.0 * T14, v28 = v13 * T34, v29 = T13 * v26 - T23 * v27,
        v30 = m5 - m4 * (inverse1 * (v1 * v27 + v2 * v26)),
        v31 = v30 + w1 * (m4 * (inverse1 * v29)), v32 = v30 + w1 * (m4 * (inverse1 * -v29)),
        v33 = S2 * T34, C3_p = w2 * (m3 * (v11 * (v33 + v9 * (c1_p * T14 - v7 * T24)))),
        C3_m = w2 * (m3 * (v11 * (v9 * (c1_m * T14 - v8 * T24) - v33))),
        v34 = v31 * v31 + C3_p * C3_p, v35 = v32 * v32 + C3_m * C3_m,
        factor3_p = sqrt_wide(v34) * (1.0 / v34), factor3_m = sqrt_wide(v35) * (1.0 / v35),
        angle2 = atan2_wide(-v31, C3_p), angle3 = atan2_wide(-v32, C3_m);

    /* is the pose one that the arm can take? */
    const wide v36 = c1_p * c2, v37 = c1_m * c2, v38 = c1_p * v13, v39 = c1_m * v13, v40 = v7 * c2,
        v41 = v8 * c2, v42 = v7 * v13, v43 = v8 * v13, v44 = k1 * (sqrt2 * (v16 * v24)),
        v45 = k1 * (sqrt2 * (v17 * v25)), v46 = a3 * (v31 * factor3_p),
        v47 = a3 * (v32 * factor3_m), v48 = c1_p * T24 + v7 * T14 - k1 * (sqrt2 * (k6 - v46)),
        v49 = c1_m * T24 + v8 * T14 - k1 * (sqrt2 * (k6 - v47)), v50 = T23 * c1_p + T13 * v7 - k2,
        v51 = T23 * c1_m + T13 * v8 - k2, v52 = c1_p * T21 + v7 * T11 - v44,
        v53 = c1_m * T21 + v8 * T11 - v45, v54 = c2 * T34,
        v55 = v54 + (T24 * v42 - T14 * v38) - k1 * (sqrt2 * (k6 + v46)),
        v56 = v54 + (T14 * v39 - T24 * v43) - k1 * (sqrt2 * (k6 + v47)), v57 = T33 * c2,
        v58 = k2 - (v57 + (T23 * v42 - T13 * v38)), v59 = k2 - (v57 + (T13 * v39 - T23 * v43)),
        v60 = c2 * T31, v61 = v44 + (v60 + (T21 * v42 - T11 * v38)),
        v62 = v45 + (v60 + (T11 * v39 - T21 * v43)),
        v63 = v28 + (T14 * v36 - T24 * v40) - a3 * (C3_p * factor3_p),
        v64 = T14 * v37 - T24 * v41 - v28 - a3 * (C3_m * factor3_m), v65 = v13 * T31,
        v66 = v65 + (T11 * v36 - T21 * v40) - v20 * v24,
        v67 = T11 * v37 - T21 * v41 - v65 - v21 * v25, v68 = T33 * v13,
        v69 = v68 + (T13 * v36 - T23 * v40), v70 = T13 * v37 - T23 * v41 - v68,
        v71 = v48 * v48 + v55 * v55 + v63 * v63, v72 = v49 * v49 + v56 * v56 + v64 * v64,
        v73 = v50 * v50 + v52 * v52 + v58 * v58 + v61 * v61 + v66 * v66 + v69 * v69,
        v74 = v51 * v51 + v53 * v53 + v59 * v59 + v62 * v62 + v67 * v67 + v70 * v70;

    /* joint values */
    const wide angle4 = atan2_wide(v16, v20), v75 = angle4 - angle2, angle5 = atan2_wide(v17, v21),
        v76 = angle5 - angle3;
    const double v77 = NAN;
    const wide v78 = only_wide(((v71 <= m7) & (v73 <= m9)) == 0, v77),
        v79 = only_wide(((v72 <= m7) & (v74 <= m9)) == 0, v77), angle6 = atan2_wide(-v7, c1_p),
        angle7 = atan2_wide(-v8, c1_m);

    q[0] = v78 + angle6; q[1] = angle1 + v78; q[2] = angle2 + v78; q[3] = v78 + centred_wide(v75);
    kind[0] = kind_of(q[0], 0);
    q[4] = v79 + angle7; q[5] = v79 - angle1; q[6] = angle3 + v79; q[7] = v79 + centred_wide(v76);
    kind[1] = kind_of(q[4], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v35 <= m6) | (v23 <= m2) | (v34 <= m6) | (v22 <= m2) | ((m7 < v72) &
        (v72 <= m8)) | ((m7 < v71) & (v71 <= m8)) | ((m9 < v74) & (v74 <= m10)) | (abs_wide(D1) <=
        m1) | (v10 <= m2) | ((m9 < v73) & (v73 <= m10)));
}

#if LANES > 1
/* One regular pose, 1 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[2][4], unsigned char status[2])
{
    const four e1 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double N1 = T13 * T13 + T23 * T23, D1 = N1 - k3, w1 = sqrt(D1), inverse1 = 1.0 / N1,
        v1 = k2 * T13, v2 = k2 * T23, v3 = inverse1 * v2;
    const four c1 = v3 - w1 * (inverse1 * (e1 * T13));
    const double v4 = inverse1 * v1;
    const four v5 = v4 + w1 * (inverse1 * (e1 * T23));

    /* theta2 */
    const double S2 = k2 * w1, v6 = k2 * T33, v7 = v6 * v6 + S2 * S2, w2 = sqrt(v7), v8 = 1.0 / v7,
        v9 = w2 * v8, c2 = v6 * v9, v10 = S2 * v9;

    /* theta34 */
    const double v11 = T23 * T11 - T13 * T21, v12 = m3 * (inverse1 * (v1 * T11 + v2 * T21));
    const four v13 = v12 + w1 * (m3 * (inverse1 * (e1 * v11)));
    const double v14 = T23 * T12 - T13 * T22, v15 = m3 * (inverse1 * (v1 * T12 + v2 * T22));
    const four v16 = v15 + w1 * (m3 * (inverse1 * (e1 * v14))), v17 = v13 * v13 + v16 * v16,
        v18 = sqrt_four(v17) * (1.0 / v17);

    /* theta3 */
    const double v19 = 2.0 * T24, v20 = 2.0 * T14, v21 = v10 * T34, v22 = T13 * v19 - T23 * v20,
        v23 = m5 - m4 * (inverse1 * (v1 * v20 + v2 * v19));
    const four v24 = v23 + w1 * (m4 * (inverse1 * (e1 * v22))),
        C3 = w2 * (m3 * (v8 * (S2 * (e1 * T34) + v6 * (c1 * T14 - v5 * T24)))),
        v25 = v24 * v24 + C3 * C3, factor3 = sqrt_four(v25) * (1.0 / v25);

    /* is the pose one that the arm can take? */
    const four v26 = c1 * c2, v27 = c1 * v10, v28 = v5 * c2, v29 = v5 * v10,
        v30 = k1 * (sqrt2 * (v13 * v18)), v31 = a3 * (v24 * factor3),
        v32 = c1 * T24 + v5 * T14 - k1 * (sqrt2 * (k6 - v31)), v33 = T23 * c1 + T13 * v5 - k2,
        v34 = c1 * T21 + v5 * T11 - v30;
    const double v35 = c2 * T34;
    const four v36 = v35 + e1 * (T24 * v29 - T14 * v27) - k1 * (sqrt2 * (k6 + v31));
    const double v37 = T33 * c2;
    const four v38 = k2 - (v37 + e1 * (T23 * v29 - T13 * v27));
    const double v39 = c2 * T31;
    const four v40 = v30 + (v39 + e1 * (T21 * v29 - T11 * v27)),
        v41 = e1 * v21 + (T14 * v26 - T24 * v28) - a3 * (C3 * factor3);
    const double v42 = v10 * T31;
    const four v43 = T11 * v26 - T21 * v28 + e1 * v42 - v16 * v18;
    const double v44 = T33 * v10;
    const four v45 = T13 * v26 - T23 * v28 + e1 * v44, v46 = v32 * v32 + v36 * v36 + v41 * v41,
        v47 = v33 * v33 + v34 * v34 + v38 * v38 + v40 * v40 + v43 * v43 + v45 * v45;

    /* joint values */
    const double v49 = NAN;
    const four v50 = only_four(((v46 <= m7) & (v47 <= m9)) == 0, v49);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | ((v25 <= m6) | (v17 <= m2) | ((m9 < v47)
        & (v47 <= m10)) | ((m7 < v46) & (v46 <= m8)))) | (unsigned)((fabs(D1) <= m1) | (v7 <= m2)))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(-v5, all_four(-S2), 0, 1, 6, 3), shuffle(c1,
        all_four(v6), 0, 1, 6, 3)),
        ratio2 = ratio_four(shuffle(-v24, v13, 0, 1, 6, 7), shuffle(C3, v16, 0, 1, 6, 7));
    const four packed1 = angle_four(ratio1), angle4 = shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = shuffle(packed1, packed1, 2, 2, 2, 2), packed2 = angle_four(ratio2),
        angle2 = shuffle(packed2, packed2, 0, 1, 0, 1),
        angle3 = shuffle(packed2, packed2, 2, 3, 2, 3);
    const four v48 = angle3 - angle2, q1 = v50 + angle4, q2 = v50 + e1 * angle1, q3 = angle2 + v50,
        q4 = v50 + centred_four(v48);

    store_4(&q[0][0], &q[1][0], &q[0][0], &q[1][0], q1, q2, q3, q4);
    const unsigned long long none1 = (bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[8], x[LANES];
    wide_mask kind[2];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 8; i += LANES) {
        const int from = i + LANES <= 8 ? i : 8 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 8 * k + from) = x[k];
    }
    for (int i = 1; i < 2; i++)
        kind[0] |= kind[i] << 8 * i;
    for (int k = 0; k < LANES; k++) {
        const long long word = kind[0][k];
        __builtin_memcpy(status + 2 * k, &word, 2);
    }
    return bits_wide(left);
}
#else
HELPER int solve_regular(const double T[16], double q[2][4], unsigned char status[2])
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

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[4], double q[2][4], unsigned char status[2])
{
    ENTRIES(double);

    /* theta1, type 2: U1[2, 3] */
    const double N1 = T13 * T13 + T23 * T23;
    const int free1 = N1 <= free_limit_squared;
    const double D1 = N1 - k3;
    const int apart1 = k5 < D1;
    if (!(-k4 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : k2 * sqrt(N1)));
    const double v1 = T13 * k2, v2 = T23 * k2;

    /* theta2, type 3: U1[3, 3] and U1[1, 3] */
    const double v3 = k2 * T33, v4 = v3 * v3;

    /* theta34, type 3: U1[2, 2] and U1[2, 1] */
    const double v9 = seed[2] + seed[3];

    /* theta3, type 3: U2[3, 4] and U2[1, 4] */
    const double v10 = 2.0 * T24, v11 = 2.0 * T14;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v2 - T13 * root1),
            s1 = free1 ? sin(seed[0]) : -(inverse1 * (v1 + T23 * root1));
        const double q1 = atan2(s1, c1);

        /* theta2 */
        const double S2 = k2 * root1;
        const double w2 = sqrt(S2 * S2 + v4);
        const int free2 = w2 <= free_limit_squared;
        const double v5 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : v3 * v5, s2 = free2 ? sin(seed[1]) : -(S2 * v5);
        const double q2 = atan2(s2, c2);

        /* theta34 */
        const double Z2_34 = T21 * c1 - T11 * s1;
        const double v6 = k2 * Z2_34, v7 = k2 * (T22 * c1 - T12 * s1);
        const double w34 = sqrt(v6 * v6 + v7 * v7);
        const int free34 = w34 <= free_limit_squared;
        const double v8 = 1.0 / (free34 ? 1.0 : w34);
        const double c34 = free34 ? cos(v9) : v7 * v8, s34 = free34 ? sin(v9) : v6 * v8;

        /* theta3 */
        const double v12 = s2 * T34, v13 = a3 * (k1 * (s1 * v11 - c1 * v10 + k7));
        const double C3 = k2 * (c2 * (c1 * T14 + s1 * T24) - v12);
        const double w3 = sqrt(v13 * v13 + C3 * C3);
        const int free3 = w3 <= free_limit_squared2;
        const double factor3 = 1.0 / (free3 ? 1.0 : w3);
        const double c3 = free3 ? cos(seed[2]) : C3 * factor3,
            s3 = free3 ? sin(seed[2]) : -(v13 * factor3);
        const double q3 = atan2(s3, c3);

        /* is the pose one that the arm can take? */
        const double v14 = c1 * c2, v15 = c1 * s2, v16 = s1 * c2, v17 = s1 * s2,
            v18 = k1 * (sqrt2 * s34), v19 = a3 * s3;
        if (!(fabs(c1 * T24 - s1 * T14 - k1 * (sqrt2 * (k6 + v19))) <= pose_slack1 && fabs(T23 * c1
            - T13 * s1 - k2) <= pose_slack && fabs(Z2_34 - v18) <= pose_slack && fabs(T14 * v15 +
            T24 * v17 + c2 * T34 + k1 * (sqrt2 * (v19 - k6))) <= pose_slack1 && fabs(k2 - (T13 * v15
            + T23 * v17 + T33 * c2)) <= pose_slack && fabs(v18 + (T11 * v15 + T21 * v17 + T31 * c2))
            <= pose_slack && fabs(T14 * v14 + T24 * v16 - v12 - a3 * c3) <= pose_slack1 && fabs(T11
            * v14 + T21 * v16 - T31 * s2 - c34) <= pose_slack && fabs(T13 * v14 + T23 * v16 - T33 *
            s2) <= pose_slack))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = wrap(atan2(s34, c34) - q3);
        const int free3_ = free34 || free3;
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
        status[row] = (free1 || free2 || free3_ || free34) ? FREE : OK;
    }
}

static void take(const double from[4], double to[4])
{
    for (int i = 0; i < 4; i++)
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
static double half_way(const double x[4], const double q[4], double half[4])
{
    double most = 0.0;
    for (int i = 0; i < 4; i++) {
        double off = q[i] - x[i];
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.3333, 0.3333, 0.3333, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[4] = { 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[4], double e[6])
{
    double P[16], square = 0.0;
    craig_417_fk(x, P);
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
static void add_step(const int held[4], double damping, double e[6], double x[4])
{
    double A[6][10] = { { 0.0 } }, square[6] = { 0.0 }, J[24];
    craig_417_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 4; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[4 * i + j];
        A[i][4 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 10; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 10; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 10; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 4; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[4])
{
    double x[4], half[4], e[6], last = HUGE_VAL;
    int settled = 0, lost = 0, held[4] = { 0 };
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
    const double T[16], const double seed[4], double q[2][4],
    unsigned char status[2])
{
    double x[4], half[4], e[6], least = HUGE_VAL, nearest = 0.001;
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
    const double T[16], const double *q_seed, double q[2][4], unsigned char status[2])
{
    const double zeros[4] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 4; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    if (valid == 2 && (count = solve_regular(pose, q, status)) >= 0)
        return count;
    count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    stay(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == NONE)
            continue;
        for (int i = 0; i < 4; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int craig_417_ik(const double T[16], const double *q_seed, double q[2][4], unsigned char status[2])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int craig_417_ik_nearest(const double T[16], const double q_seed[4], double q[4])
{
    double all[2][4], found[4], least = HUGE_VAL;
    unsigned char status[2];
    int result = -NONE;
    int valid = craig_417_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 4; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 2 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 4; i++) {
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

void craig_417_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 8 * k, status + 2 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)craig_417_ik(T + 16 * i, NULL, (double (*)[4])(q + 8 * i), status + 2 * i);
    }
#endif
    for (; k < n; k++)
        (void)craig_417_ik(T + 16 * k, NULL, (double (*)[4])(q + 8 * k), status + 2 * k);
}
