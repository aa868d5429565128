/* cylindrical_wrist: Cylindrical arm with a spherical wrist
 *
 * Inverse kinematics, generated from robots/cylindrical_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cylindrical_wrist.yaml. The formulas and where they come from:
 * cylindrical_wrist.md.
 */
#include "cylindrical_wrist.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = CYLINDRICAL_WRIST_OK, NONE = CYLINDRICAL_WRIST_UNREACHABLE, FREE =
        CYLINDRICAL_WRIST_FREE_JOINT,
    OUT = CYLINDRICAL_WRIST_OUT_OF_LIMITS, INVALID = CYLINDRICAL_WRIST_INVALID_POSE
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

#ifndef CYLINDRICAL_WRIST_LIBM
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
 * -DCYLINDRICAL_WRIST_SCALAR. With -DCYLINDRICAL_WRIST_LIBM the arctangents are those of <math.h>,
 * too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(CYLINDRICAL_WRIST_SCALAR) && !defined(CYLINDRICAL_WRIST_LIBM)
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
#ifdef CYLINDRICAL_WRIST_LIBM /* half the time of atan2 */
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


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.3, /* joint offset 1 [m] */
    d6 = 0.1, /* joint offset 6 [m] */
    free_limit1 = 4e-13, /* a length that fixes no angle [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    m1 = 1.6000000000000003e-09, /* doubt_limit1^2 [m^2] */
    m3 = 9.999999999999999e-09; /* doubt_limit^2 */

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const cylindrical_wrist_branches[4] = {
    "forward-noflip", "forward-flip", "backward-noflip", "backward-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 1, 0, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 6.249999999999999, 6.249999999999999, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 4e-10) /* of limits */

void cylindrical_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = c1 * c4, x4_y = s1 * c4, v1 = c1 * s4,
        v2 = s1 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + s1 * s5,
        x5_y = x4_y * c5 - c1 * s5, v3 = s4 * c5, z5_y = c1 * c5 + x4_y * s5, v4 = s4 * s5,
        z5_x = x4_x * s5 - s1 * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - v1 * s6; T[1] = -(v1 * c6 + x5_x * s6); T[2] = z5_x;
    T[3] = z5_x * d6 - s1 * q[2];
    T[4] = x5_y * c6 - v2 * s6; T[5] = -(v2 * c6 + x5_y * s6); T[6] = z5_y;
    T[7] = c1 * q[2] + z5_y * d6;
    T[8] = -(v3 * c6 + c4 * s6); T[9] = v3 * s6 - c4 * c6; T[10] = -v4; T[11] = d1 + q[1] - v4 * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void cylindrical_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p2_z = d1 + q[1], v1 = s1 * q[2], p3_y = c1 * q[2];
    const double c4 = cos(q[3]), s4 = sin(q[3]), v2 = c1 * s4, v3 = s1 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_y = c1 * c5 + s1 * c4 * s5, v4 = s4 * s5,
        z5_x = c1 * c4 * s5 - s1 * c5, p6_x = z5_x * d6 - v1, p6_y = p3_y + z5_y * d6,
        v5 = v1 + p6_x, v6 = p6_y - p3_y, v7 = p2_z - v4 * d6 - p2_z;
    J[0] = -p6_y; J[1] = 0.0; J[2] = -s1; J[3] = c1 * v7; J[4] = c4 * v6 - v3 * v7;
    J[5] = z5_y * v7 + v4 * v6;
    J[6] = p6_x; J[7] = 0.0; J[8] = c1; J[9] = s1 * v7; J[10] = v2 * v7 - c4 * v5;
    J[11] = -(v4 * v5 + z5_x * v7);
    J[12] = 0.0; J[13] = 1.0; J[14] = 0.0; J[15] = -(s1 * v6 + c1 * v5); J[16] = v3 * v5 - v2 * v6;
    J[17] = z5_x * v6 - z5_y * v5;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = -s1; J[22] = -v2; J[23] = z5_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = c1; J[28] = -v3; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = -c4; J[35] = -v4;
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

    /* r2 */
    const wide q2_pp = T34 - d6 * T33 - d1;

    /* theta1, r3 */
    const wide wy = T24 - d6 * T23, s1 = d6 * T13 - T14, v1 = s1 * s1 + wy * wy,
        q3_pp = sqrt_wide(v1), factor1 = q3_pp * (1.0 / v1), angle1 = atan2_wide(s1, wy),
        q1_mp = angle1 - signed_wide(half_turn, s1);

    /* theta4 */
    const wide X4 = wy * T13 + T23 * s1, v2 = factor1 * X4, v3 = T33 * T33 + factor1 * (X4 * v2),
        angle2 = atan2_wide(T33, -v2), q4_pm = angle2 - signed_wide(half_turn, T33);

    /* theta5 */
    const wide angle3 = atan2_wide(-sqrt_wide(v3), factor1 * (T23 * wy - T13 * s1)),
        q5_mp = signed_wide(half_turn, -sqrt_wide(v3)) - angle3;

    /* theta6 */
    const wide v4 = X4 * T31 - T33 * (wy * T11 + s1 * T21),
        angle4 = atan2_wide(v4, X4 * T32 - T33 * (wy * T12 + s1 * T22)),
        q6_pm = angle4 - signed_wide(half_turn, v4);

    q[0] = angle1; q[1] = q2_pp; q[2] = q3_pp; q[3] = angle2; q[4] = angle3; q[5] = angle4;
    kind[0] = kind_of(q[0], 0);
    q[6] = angle1; q[7] = q2_pp; q[8] = q3_pp; q[9] = q4_pm; q[10] = -angle3; q[11] = q6_pm;
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_mp; q[13] = q2_pp; q[14] = -q3_pp; q[15] = -q4_pm; q[16] = q5_mp; q[17] = q6_pm;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_mp; q[19] = q2_pp; q[20] = -q3_pp; q[21] = -angle2; q[22] = -q5_mp; q[23] = angle4;
    kind[3] = kind_of(q[18], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v1 <= m1) | (v3 <= m3));
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

    /* r2 */
    const double q2 = T34 - d6 * T33 - d1;

    /* theta1, r3 */
    const double wy = T24 - d6 * T23, s1 = d6 * T13 - T14, v1 = s1 * s1 + wy * wy, w3 = sqrt(v1),
        factor1 = w3 * (1.0 / v1), v2 = copysign(half_turn, s1);
    const four v3 = e1 - 1.0;

    /* theta4 */
    const double X4 = wy * T13 + T23 * s1, v4 = factor1 * X4, v5 = T33 * T33 + factor1 * (X4 * v4),
        v6 = copysign(half_turn, T33);

    /* theta5 */
    const double v8 = copysign(half_turn, -sqrt(v5));

    /* theta6 */
    const double v9 = X4 * T31 - T33 * (wy * T11 + s1 * T21), v10 = copysign(half_turn, v9);

    /* joint values */
    const four q3 = e1 * w3;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0)) | (unsigned)((v1 <= m1) | (v5 <= m3)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ s1, T33, -sqrt(v5), v9 }, (four){ wy, -v4, factor1
        * (T23 * wy - T13 * s1), X4 * T32 - T33 * (wy * T12 + s1 * T22) });
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = shuffle(packed1, packed1, 2, 2, 2, 2),
        angle4 = shuffle(packed1, packed1, 3, 3, 3, 3);
    const four q1 = angle1 + v2 * (m2 * v3), v7 = e1 * angle2, q4 = v7 + v6 * (m2 * (e2 - e1)),
        q5_ = e1 * angle3 + v8 * (m2 * -v3), q6 = angle4 + v10 * (m2 * (e1 * e2 - 1.0)),
        q5 = e2 * q5_;

    store_4(&q[0][0], &q[1][0], &q[2][0], &q[3][0], q1, all_four(q2), q3, q4);
    store_2(&q[0][4], &q[1][4], &q[2][4], &q[3][4], q5, q6);
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

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[6], double q[4][6], unsigned char status[4])
{
    ENTRIES(double);

    /* r2, type 1: U0 A6^-1 [3, 4] */
    const double wz = T34 - T33 * d6;
    const double r2 = wz - d1;

    /* theta1, r3, type 4: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4] */
    const double wy = T24 - d6 * T23;
    const double v1 = d6 * T13 - T14;
    const double w3 = sqrt(v1 * v1 + wy * wy);
    const int free1 = w3 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w3;

    /* theta4, type 2: U4[3, 3] */
    const double v2 = T33 * T33;

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1, r3 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : wy * factor1,
            s1 = free1 ? sin(seed[0]) : v1 * factor1;
        const double q1 = atan2(s1, c1);
        const double r3 = w3 * e1;

        /* theta4 */
        const double X4 = T13 * c1 + T23 * s1;
        const double w4 = sqrt(X4 * X4 + v2);
        const int free4 = w4 <= free_limit;
        const double divisor4 = free4 ? 1.0 : w4;

        /* theta5, type 3: U4[2, 3] and U4[1, 3] */
        const double c5 = T23 * c1 - T13 * s1;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v3 = T12 * c1 + T22 * s1, v4 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta4 */
            if (e2 < 0.0 && free4) continue; /* both signs give the same */
            const double factor4 = e2 / divisor4;
            const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                s4 = free4 ? sin(seed[3]) : T33 * factor4;
            const double q4 = atan2(s4, c4);

            /* theta5 */
            const double q5 = atan2(-(w4 * e2), c5);

            /* theta6 */
            const double q6 = atan2(-(T31 * c4 + s4 * v4), -(T32 * c4 + s4 * v3));
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = r2; q[row][2] = r3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free1 || free4) ? FREE : OK;
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
static const double weights[6] = { 2.5, 2.5, 2.5, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 0.4, 0.4, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    cylindrical_wrist_fk(x, P);
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
    cylindrical_wrist_jacobian(x, J);
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

int cylindrical_wrist_ik(
    const double T[16], const double *q_seed, double q[4][6], unsigned char status[4])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int cylindrical_wrist_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[4][6], found[6], least = HUGE_VAL;
    unsigned char status[4];
    int result = -NONE;
    int valid = cylindrical_wrist_ik(T, q_seed, all, status) >= 0;
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

void cylindrical_wrist_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 24 * k, status + 4 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)cylindrical_wrist_ik(
                    T + 16 * i, NULL, (double (*)[6])(q + 24 * i), status + 4 * i);
    }
#endif
    for (; k < n; k++)
        (void)cylindrical_wrist_ik(T + 16 * k, NULL, (double (*)[6])(q + 24 * k), status + 4 * k);
}
