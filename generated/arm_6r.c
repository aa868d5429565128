/* arm_6r: Arm with six revolute joints and a spherical wrist
 *
 * Inverse kinematics, generated from robots/arm_6r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/arm_6r.yaml. The formulas and where they come from: arm_6r.md.
 */
#include "arm_6r.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = ARM_6R_OK, NONE = ARM_6R_UNREACHABLE, FREE = ARM_6R_FREE_JOINT,
    OUT = ARM_6R_OUT_OF_LIMITS, INVALID = ARM_6R_INVALID_POSE
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

#ifndef ARM_6R_LIBM
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
 * -DARM_6R_SCALAR. With -DARM_6R_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(ARM_6R_SCALAR) && !defined(ARM_6R_LIBM)
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
#ifdef ARM_6R_LIBM /* half the time of atan2 */
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
    d1 = 0.4, /* joint offset 1 [m] */
    a2 = 0.4, /* link length 2 [m] */
    d4 = 0.35, /* joint offset 4 [m] */
    d6 = 0.1, /* joint offset 6 [m] */
    free_limit1 = 1.25e-12, /* a length that fixes no angle [m] */
    longest3 = 0.5625, /* square of the longest reach [m^2] */
    shortest3 = 0.0025000000000000044, /* square of the shortest reach [m^2] */
    longest3_reach = 0.5625000000001875, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.002499999999987505, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.5624999999999812, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0025000000000012543, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 1.5624999999999999e-24, /* square of a length that fixes no angle [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.27999999999999997, /* 2 * d4 * a2 [m^2] */
    k2 = 0.28250000000000003, /* a2^2 + d4^2 [m^2] */
    k3 = 12.755102040816327, /* 1 / (k1^2) [m^-4] */
    m1 = 1.5625e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.050715070505213e-11,
    m6 = 2.44140625e-16, /* doubt_limit_squared2^2 [m^4] */
    m7 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m4 = 1.2499999999999998, m5 = 0.04687500000000003;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const arm_6r_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void arm_6r_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, v4 = v1 * c3 + x2_x * s3,
        v5 = v2 * c3 + x2_y * s3, z3_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + s1 * s4,
        x4_y = x3_y * c4 - c1 * s4, v6 = v3 * c4, y5_x = s1 * c4 - x3_x * s4,
        z4_y = c1 * c4 + x3_y * s4, y5_z = v3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v4 * s5,
        x5_y = x4_y * c5 - v5 * s5, x5_z = z3_z * s5 - v6 * c5, v7 = v4 * c5 + x4_x * s5,
        v8 = v5 * c5 + x4_y * s5, z5_z = z3_z * c5 + v6 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y5_x * s6; T[1] = y5_x * c6 - x5_x * s6; T[2] = -v7;
    T[3] = x2_x * a2 - v4 * d4 - v7 * d6;
    T[4] = x5_y * c6 - z4_y * s6; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = -v8;
    T[7] = x2_y * a2 - v5 * d4 - v8 * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 - s2 * a2 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void arm_6r_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, v4 = v1 * c3 + x2_x * s3,
        v5 = v2 * c3 + x2_y * s3, z3_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_y = c1 * c4 + x3_y * s4, y5_z = v3 * s4,
        p4_x = p2_x - v4 * d4, p4_y = p2_y - v5 * d4, p4_z = p2_z + z3_z * d4,
        z4_x = x3_x * s4 - s1 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v6 = v4 * c5 + (x3_x * c4 + s1 * s4) * s5,
        v7 = v5 * c5 + (x3_y * c4 - c1 * s4) * s5, z5_z = z3_z * c5 + v3 * c4 * s5,
        p6_x = p4_x - v6 * d6, p6_y = p4_y - v7 * d6, p6_z = p4_z + z5_z * d6, v8 = p6_z - d1,
        v9 = p6_x - p2_x, v10 = p6_y - p2_y, v11 = p6_z - p2_z, v12 = p6_x - p4_x,
        v13 = p6_y - p4_y, v14 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = c1 * v8; J[2] = c1 * v11; J[3] = -(v5 * v11 + z3_z * v10);
    J[4] = z4_y * v14 + y5_z * v13; J[5] = -(v7 * v14 + z5_z * v13);
    J[6] = p6_x; J[7] = s1 * v8; J[8] = s1 * v11; J[9] = z3_z * v9 + v4 * v11;
    J[10] = -(y5_z * v12 + z4_x * v14); J[11] = z5_z * v12 + v6 * v14;
    J[12] = 0.0; J[13] = -(s1 * p6_y + c1 * p6_x); J[14] = -(s1 * v10 + c1 * v9);
    J[15] = v5 * v9 - v4 * v10; J[16] = z4_x * v13 - z4_y * v12; J[17] = v7 * v12 - v6 * v13;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = -v4; J[22] = z4_x; J[23] = -v6;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = -v5; J[28] = z4_y; J[29] = -v7;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = -y5_z; J[35] = z5_z;
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
    const wide wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = wx * wx + Y1 * Y1, w1 = sqrt_wide(v1),
        v2 = 1.0 / v1, angle1 = atan2_wide(Y1, -wx);

    /* theta3 */
    const wide Z1_3 = T34 - d6 * T33 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt_wide(D3), v3 = w3 - w3,
        v4 = k1 * (N3 - k2), v5 = k3 * v4, v6 = k1 * w3, c3 = k3 * v6, angle2 = atan2_wide(-v4, v6),
        q3_pmp = signed_wide(half_turn, -v4) - angle2;

    /* theta2 */
    const wide v7 = d4 * c3, Y1_2 = a2 + d4 * v5, v8 = Z1_3 * Y1_2, v9 = w1 * v7, v10 = v9 - v8,
        v11 = v8 + v9, v12 = m5 + m4 * N3, v13 = Z1_3 * v12, v14 = w3 * (m4 * w1),
        S2_pp = v14 - v13, v15 = v13 + v14, v16 = w1 * Y1_2, v17 = Z1_3 * v7, v18 = v16 + v17,
        v19 = v16 - v17, v20 = w3 * (m4 * Z1_3), v21 = w3 * (m4 * -Z1_3), v22 = w1 * v12,
        v23 = v20 + v22, v24 = v21 + v22, v25 = v20 - v22, v26 = v21 - v22, v27 = S2_pp * S2_pp,
        v28 = v27 + v23 * v23, v29 = v15 * v15, v30 = v29 + v24 * v24, v31 = v29 + v25 * v25,
        v32 = v27 + v26 * v26, w2_pp = sqrt_wide(v28), w2_pm = sqrt_wide(v30),
        w2_mp = sqrt_wide(v31), w2_mm = sqrt_wide(v32), v33 = 1.0 / v28, v34 = 1.0 / v30,
        v35 = 1.0 / v31, v36 = 1.0 / v32, angle3 = atan2_wide(S2_pp, -v23),
        angle4 = atan2_wide(-v15, -v24), angle5 = atan2_wide(-v15, -v25),
        angle6 = atan2_wide(S2_pp, -v26);

    /* theta4 */
    const wide v37 = v5 * v10 - c3 * v18, c23_pp = w2_pp * (v33 * v37), v38 = v5 * v11,
        c23_pm = w2_pm * (v34 * (c3 * v19 - v38)), v39 = w2_mp * (v35 * (v38 + c3 * -v19)),
        c23_mm = w2_mm * (v36 * v37), v40 = c3 * v10 + v5 * v18, s23_pp = w2_pp * (v33 * v40),
        v41 = c3 * v11, s23_pm = w2_pm * (v34 * (v41 + v5 * v19)),
        s23_mp = w2_mp * (v35 * (v5 * -v19 - v41)), v42 = w2_mm * (v36 * v40),
        v43 = w1 * (v2 * (T23 * Y1 - T13 * wx)), X4_pp = T33 * s23_pp - c23_pp * v43,
        X4_pm = T33 * s23_pm - c23_pm * v43, X4_mp = T33 * s23_mp - v39 * v43,
        X4_mm = c23_mm * v43 - T33 * v42, Y4 = w1 * (v2 * (T13 * Y1 + wx * T23)), v44 = Y4 * Y4,
        v45 = v44 + X4_pp * X4_pp, v46 = v44 + X4_pm * X4_pm, v47 = v44 + X4_mp * X4_mp,
        v48 = v44 + X4_mm * X4_mm, angle7 = atan2_wide(Y4, -X4_pp), angle8 = atan2_wide(Y4, -X4_pm),
        angle9 = atan2_wide(-Y4, -X4_mp), angle10 = atan2_wide(-Y4, -X4_mm),
        v49 = signed_wide(half_turn, Y4), v50 = signed_wide(half_turn, -Y4);

    /* theta5 */
    const wide angle11 = atan2_wide(-sqrt_wide(v45), -(T33 * c23_pp + s23_pp * v43)),
        angle12 = atan2_wide(-sqrt_wide(v46), -(T33 * c23_pm + s23_pm * v43)),
        angle13 = atan2_wide(-sqrt_wide(v47), T33 * v39 + s23_mp * v43),
        angle14 = atan2_wide(-sqrt_wide(v48), -(T33 * c23_mm + v42 * v43));

    /* theta6 */
    const wide v51 = w1 * (v2 * (wx * T22 + Y1 * T12)), v52 = w1 * (v2 * (Y1 * T22 - wx * T12)),
        v53 = w1 * (v2 * (wx * T21 + Y1 * T11)), v54 = w1 * (v2 * (Y1 * T21 - wx * T11)),
        v55 = -X4_pp * v53 - Y4 * (c23_pp * v54 - s23_pp * T31),
        v56 = -X4_pm * v53 - Y4 * (c23_pm * v54 - s23_pm * T31),
        v57 = Y4 * (v39 * v54 - s23_mp * T31) + X4_mp * v53,
        v58 = Y4 * (v42 * T31 - c23_mm * v54) + X4_mm * v53,
        angle15 = atan2_wide(v55, -X4_pp * v51 - Y4 * (c23_pp * v52 - s23_pp * T32)),
        angle16 = atan2_wide(v56, -X4_pm * v51 - Y4 * (c23_pm * v52 - s23_pm * T32)),
        angle17 = atan2_wide(v57, Y4 * (v39 * v52 - s23_mp * T32) + X4_mp * v51),
        angle18 = atan2_wide(v58, Y4 * (v42 * T32 - c23_mm * v52) + X4_mm * v51);

    /* joint values */
    const wide q1_ppp = angle1 + v3, q1_mpp = v3 + (angle1 - signed_wide(half_turn, Y1));

    q[0] = q1_ppp; q[1] = angle3; q[2] = angle2; q[3] = angle7; q[4] = angle11; q[5] = angle15;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_ppp; q[7] = angle3; q[8] = angle2; q[9] = angle7 - v49; q[10] = -angle11;
    q[11] = angle15 - signed_wide(half_turn, v55);
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_ppp; q[13] = angle4; q[14] = q3_pmp; q[15] = angle8; q[16] = angle12;
    q[17] = angle16;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_ppp; q[19] = angle4; q[20] = q3_pmp; q[21] = angle8 - v49; q[22] = -angle12;
    q[23] = angle16 - signed_wide(half_turn, v56);
    kind[3] = kind_of(q[18], 0);
    q[24] = q1_mpp; q[25] = angle5; q[26] = angle2; q[27] = angle9; q[28] = angle13;
    q[29] = angle17;
    kind[4] = kind_of(q[24], 0);
    q[30] = q1_mpp; q[31] = angle5; q[32] = angle2; q[33] = angle9 - v50; q[34] = -angle13;
    q[35] = angle17 - signed_wide(half_turn, v57);
    kind[5] = kind_of(q[30], 0);
    q[36] = q1_mpp; q[37] = angle6; q[38] = q3_pmp; q[39] = angle10; q[40] = angle14;
    q[41] = angle18;
    kind[6] = kind_of(q[36], 0);
    q[42] = q1_mpp; q[43] = angle6; q[44] = q3_pmp; q[45] = angle10 - v50; q[46] = -angle14;
    q[47] = angle18 - signed_wide(half_turn, v58);
    kind[7] = kind_of(q[42], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v48 <= m7) | (v32 <= m6) | (v47 <= m7) | (v31 <= m6) | (v46 <= m7) |
        (v30 <= m6) | (v45 <= m7) | (v1 <= m1) | (abs_wide(D3) <= m3) | (v28 <= m6));
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
    const double wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = wx * wx + Y1 * Y1, w1 = sqrt(v1),
        v2 = 1.0 / v1, v3 = copysign(half_turn, Y1);

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3), v4 = w3 - w3, v5 = k1 * (N3 - k2),
        v6 = k3 * v5, v7 = k1 * w3, c3 = k3 * v7, v8 = copysign(half_turn, -v5);

    /* theta2 */
    const double v9 = d4 * c3, Y1_2 = a2 + d4 * v6, v10 = Z1_3 * Y1_2, v11 = w1 * v9;
    const four v12 = e1 * e2, v13 = v11 * v12 - v10;
    const double v14 = m5 + m4 * N3, v15 = Z1_3 * v14;
    const four S2 = w3 * (m4 * (w1 * v12)) - v15;
    const double v16 = w1 * Y1_2, v17 = Z1_3 * v9;
    const four v18 = e2 * v17, v19 = e1 * v16, v20 = v18 + v19, v21 = w3 * (m4 * (e2 * Z1_3)),
        v22 = w1 * (e1 * v14), v23 = v21 + v22, v24 = S2 * S2 + v23 * v23, w2 = sqrt_four(v24),
        v25 = 1.0 / v24;

    /* theta4 */
    const four v26 = e2 * c3, c23 = w2 * (v25 * (v6 * v13 - v20 * v26)),
        s23 = w2 * (v25 * (v13 * v26 + v6 * v20));
    const double v27 = w1 * (v2 * (T23 * Y1 - T13 * wx));
    const four X4 = T33 * s23 - e1 * (c23 * v27);
    const double Y4 = w1 * (v2 * (T13 * Y1 + wx * T23)), v28 = Y4 * Y4;
    const four v29 = v28 + X4 * X4, v30 = e1 * Y4, v31 = signed_four(half_turn, v30);

    /* theta6 */
    const double v32 = w1 * (v2 * (wx * T22 + Y1 * T12)), v33 = w1 * (v2 * (Y1 * T22 - wx * T12)),
        v34 = w1 * (v2 * (wx * T21 + Y1 * T11)), v35 = w1 * (v2 * (Y1 * T21 - wx * T11));
    const four v36 = e1 * (-X4 * v34 - Y4 * (e1 * (c23 * v35) - s23 * T31));

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | ((v24 <= m6) | (v29 <= m7))) |
        (unsigned)((v1 <= m1) | (fabs(D3) <= m3)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ Y1, -v5, Y1, Y1 }, (four){ -wx, v7, -wx, -wx }),
        ratio2 = ratio_four(S2, -v23), ratio3 = ratio_four(v30, -X4),
        ratio4 = ratio_four(v36, e1 * (-X4 * v32 - Y4 * (e1 * (c23 * v33) - s23 * T32))),
        ratio5 = ratio_four(-sqrt_four(v29), -(T33 * c23 + e1 * (s23 * v27)));
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = angle_four(ratio2),
        angle4 = angle_four(ratio3), angle6 = angle_four(ratio4), angle5 = angle_four(ratio5);
    const four q3_p = e2 * angle2 + v8 * (m2 * (1.0 - e2)), q4_m = angle4 - v31,
        q6_m = angle6 - signed_four(half_turn, v36), q1_p = v4 + (angle1 + v3 * (m2 * (e1 - 1.0)));

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

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const double wx = T14 - T13 * d6;
    const double Y1 = d6 * T23 - T24;
    const double w1 = sqrt(wx * wx + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v1 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(wx * factor1),
            s1 = free1 ? sin(seed[0]) : Y1 * factor1;
        const double q1 = atan2(s1, c1);
        const double root1 = w1 * e1;

        /* theta3 */
        const double N3 = v1 + root1 * root1;
        const double K3 = N3 - k2;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v2 = k1 * K3 * k3;

        /* theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4] */
        const double Y1_2 = a2 + d4 * v2;
        const double v4 = Z1_3 * Y1_2, v5 = root1 * Y1_2;

        /* theta4, type 2: U4[3, 3] */
        const double v7 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v8 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v9 = T22 * c1 - T12 * s1, v10 = T12 * c1 + T22 * s1, v12 = T21 * c1 - T11 * s1,
            v13 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double c3 = k3 * (k1 * (w3 * e2));
            const double q3 = atan2(-v2, c3);

            /* theta2 */
            const double v3 = d4 * c3;
            const double S2 = root1 * v3 - v4;
            const double v6 = Z1_3 * v3 + v5;
            const double w2 = sqrt(S2 * S2 + v6 * v6);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : -(v6 * factor2),
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 + v2 * s2, s23 = c3 * s2 - v2 * c2;
            const double X4 = T33 * s23 - c23 * v7;
            const double w4 = sqrt(X4 * X4 + v8);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta6 */
            const double v11 = c23 * v10 - T32 * s23, v14 = c23 * v13 - T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5, type 3: U4[2, 3] and U4[1, 3] */
                const double q5 = atan2(-(w4 * e3), -(T33 * c23 + s23 * v7));

                /* theta6 */
                const double q6 = atan2(-(c4 * v12 + s4 * v14), -(c4 * v9 + s4 * v11));
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
static const double weights[6] = { 0.8, 0.8, 0.8, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    arm_6r_fk(x, P);
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
    arm_6r_jacobian(x, J);
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

int arm_6r_ik(const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int arm_6r_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = arm_6r_ik(T, q_seed, all, status) >= 0;
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

void arm_6r_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)arm_6r_ik(T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)arm_6r_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
