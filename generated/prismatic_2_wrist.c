/* prismatic_2_wrist: Slide as joint 2, spherical wrist
 *
 * Inverse kinematics, generated from robots/prismatic_2_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/prismatic_2_wrist.yaml. The formulas and where they come from:
 * prismatic_2_wrist.md.
 */
#include "prismatic_2_wrist.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = PRISMATIC_2_WRIST_OK, NONE = PRISMATIC_2_WRIST_UNREACHABLE, FREE =
        PRISMATIC_2_WRIST_FREE_JOINT,
    OUT = PRISMATIC_2_WRIST_OUT_OF_LIMITS, INVALID = PRISMATIC_2_WRIST_INVALID_POSE
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

#ifndef PRISMATIC_2_WRIST_LIBM
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
 * -DPRISMATIC_2_WRIST_SCALAR. With -DPRISMATIC_2_WRIST_LIBM the arctangents are those of <math.h>,
 * too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(PRISMATIC_2_WRIST_SCALAR) && !defined(PRISMATIC_2_WRIST_LIBM)
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
#ifdef PRISMATIC_2_WRIST_LIBM /* half the time of atan2 */
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
    a1 = 0.1, /* link length 1 [m] */
    cat2 = 0.9800665778412416, /* cosine of the angle of joint 2 */
    sat2 = 0.19866933079506122, /* sine of the angle of joint 2 */
    a2 = 0.15, /* link length 2 [m] */
    d3 = 0.1, /* joint offset 3 [m] */
    a3 = 0.08, /* link length 3 [m] */
    d4 = 0.43, /* joint offset 4 [m] */
    d6 = 0.08, /* joint offset 6 [m] */
    free_limit_squared2 = 1.5375999999999999e-24, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 1.24e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 1.24e-14, /* nearer to that boundary two branches are one [m] */
    /* the same where they follow an angle that is good to few digits [m] */
    blur_slack1 = 1.2399999999999999e-11,
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 1.5376000000000001e-06,
    free_limit1 = 1.24e-12, /* a length that fixes no angle [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.4138869064318786, /* d1 * cat2 + (a1 * sat2 + d3) [m] */
    k2 = 0.08542781224187632, /* d4 * sat2 [m] */
    k3 = 0.0158935464636049, /* a3 * sat2 [m] */
    k4 = 0.007550515923624042, /* k2^2 + k3^2 [m^2] */
    k5 = 0.36820625816486496, /* d1 + (cat2 * d3 - a2 * sat2) [m] */
    k6 = 132.4412808495909, /* 1 / k4 [m^-2] */
    f1 = 0.2701996003807408, /* d1 - sat2 * a2 [m] */
    f2 = 0.09800665778412417, /* d3 * cat2 [m] */
    /* square of a length that fixes no angle [m^2] */
    doubt_limit_squared2 = 1.5375999999999998e-08,
    m1 = 1.2399999999999999e-11, /* 1000 * merge_slack1 [m] */
    m2 = 1.2399999999999999e-10, /* 10 * blur_slack1 [m] */
    m7 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m3 = 11.314168873492461, m4 = 0.7750600530519154, m5 = 2.1049616508823186,
m6 = 4.165947785154044;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const prismatic_2_wrist_branches[8] = {
    "left-noflip3-noflip4", "left-noflip3-flip4", "left-flip3-noflip4", "left-flip3-flip4",
    "right-noflip3-noflip4", "right-noflip3-flip4", "right-flip3-noflip4", "right-flip3-flip4",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 1, 0, 1, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 0.6503642039542143, 1.0, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 1.24e-09) /* of limits */

void prismatic_2_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), x2_x = c1 * cat2, x2_y = s1 * cat2,
        z2_x = c1 * sat2, z2_y = s1 * sat2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - s1 * s3,
        x3_y = x2_y * c3 + c1 * s3, v1 = sat2 * c3, v2 = s1 * c3 + x2_x * s3,
        z3_y = c1 * c3 - x2_y * s3, z3_z = sat2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - z2_x * s4,
        x4_y = x3_y * c4 - z2_y * s4, v3 = v1 * c4 + cat2 * s4, z4_x = z2_x * c4 + x3_x * s4,
        z4_y = z2_y * c4 + x3_y * s4, y5_z = v1 * s4 - cat2 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v2 * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = z3_z * s5 - v3 * c5, v4 = v2 * c5 + x4_x * s5,
        z5_y = z3_y * c5 - x4_y * s5, z5_z = z3_z * c5 + v3 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - z4_x * s6; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = -v4;
    T[3] = c1 * a1 - s1 * q[1] + x2_x * a2 + x3_x * a3 + z2_x * d3 - v2 * d4 - v4 * d6;
    T[4] = x5_y * c6 - z4_y * s6; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = z5_y;
    T[7] = s1 * a1 + c1 * q[1] + x2_y * a2 + x3_y * a3 + z2_y * d3 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = f1 - v1 * a3 + f2 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void prismatic_2_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), x2_x = c1 * cat2, x2_y = s1 * cat2,
        z2_x = c1 * sat2, z2_y = s1 * sat2, p2_x = c1 * a1 - s1 * q[1] + x2_x * a2,
        p2_y = s1 * a1 + c1 * q[1] + x2_y * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - s1 * s3,
        x3_y = x2_y * c3 + c1 * s3, v1 = sat2 * c3, v2 = s1 * c3 + x2_x * s3,
        z3_y = c1 * c3 - x2_y * s3, z3_z = sat2 * s3, p3_x = p2_x + x3_x * a3 + z2_x * d3,
        p3_y = p2_y + x3_y * a3 + z2_y * d3, p3_z = f1 - v1 * a3 + f2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = z2_x * c4 + x3_x * s4,
        z4_y = z2_y * c4 + x3_y * s4, p4_x = p3_x - v2 * d4, p4_y = p3_y + z3_y * d4,
        p4_z = p3_z + z3_z * d4, z4_z = cat2 * c4 - v1 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v3 = v2 * c5 + (x3_x * c4 - z2_x * s4) * s5,
        z5_y = z3_y * c5 - (x3_y * c4 - z2_y * s4) * s5,
        z5_z = z3_z * c5 + (v1 * c4 + cat2 * s4) * s5, p6_x = p4_x - v3 * d6,
        p6_y = p4_y + z5_y * d6, p6_z = p4_z + z5_z * d6, v4 = p6_x - p2_x, v5 = p6_y - p2_y,
        v6 = p6_z - f1, v7 = p6_x - p3_x, v8 = p6_y - p3_y, v9 = p6_z - p3_z, v10 = p6_x - p4_x,
        v11 = p6_y - p4_y, v12 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = -s1; J[2] = z2_y * v6 - cat2 * v5; J[3] = z3_y * v9 - z3_z * v8;
    J[4] = z4_y * v12 - z4_z * v11; J[5] = z5_y * v12 - z5_z * v11;
    J[6] = p6_x; J[7] = c1; J[8] = cat2 * v4 - z2_x * v6; J[9] = z3_z * v7 + v2 * v9;
    J[10] = z4_z * v10 - z4_x * v12; J[11] = z5_z * v10 + v3 * v12;
    J[12] = 0.0; J[13] = 0.0; J[14] = z2_x * v5 - z2_y * v4; J[15] = -(v2 * v8 + z3_y * v7);
    J[16] = z4_x * v11 - z4_y * v10; J[17] = -(v3 * v11 + z5_y * v10);
    J[18] = 0.0; J[19] = 0.0; J[20] = z2_x; J[21] = -v2; J[22] = z4_x; J[23] = -v3;
    J[24] = 0.0; J[25] = 0.0; J[26] = z2_y; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = cat2; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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
HELPER wide_mask solve_wide(const wide T[16], wide q[48], wide_mask kind[8])
{
    ENTRIES(wide);

    /* theta1 */
    const wide wy = T24 - d6 * T23, v1 = sat2 * wy, wx = T14 - d6 * T13, v2 = sat2 * wx,
        N1 = v1 * v1 + v2 * v2, wz = T34 - d6 * T33, Z1 = cat2 * wz - k1, D1 = N1 - Z1 * Z1,
        w1 = sqrt_wide(D1), v3 = w1 - w1, inverse1 = 1.0 / N1, v4 = v1 * Z1, v5 = v2 * Z1,
        v6 = inverse1 * v5, v7 = w1 * (v1 * inverse1), c1_p = v7 - v6, v8 = v6 + v7,
        v9 = inverse1 * v4, v10 = w1 * (v2 * inverse1), v11 = v9 + v10, v12 = v9 - v10;

    /* theta3 */
    const wide Z3 = wz - k5, D3 = k4 - Z3 * Z3, w3 = sqrt_wide(D3), v13 = w3 - w3,
        v14 = m5 * wz - m4, v15 = m3 * w3, v16 = v14 + v15, v17 = v14 - v15, v18 = m3 * wz - m6,
        v19 = m5 * w3, s3_p = v18 - v19, s3_m = v18 + v19;

    /* r2 */
    const wide v20 = a3 * s3_p - d4 * v16, v21 = a3 * s3_m - d4 * v17, v22 = c1_p * -wy - wx * v11,
        v23 = v8 * -wy + wx * v12;

    /* theta4 */
    const wide v24 = cat2 * T13, v25 = cat2 * T23, v26 = v1 * v24 - v2 * v25,
        v27 = sat2 * T33 + inverse1 * (v4 * v25 + v5 * v24), v28 = w1 * (inverse1 * v26) - v27,
        v29 = w1 * (inverse1 * -v26) - v27, v30 = T13 * v11 + T23 * c1_p,
        v31 = T13 * v12 - T23 * v8, X4_pp = v16 * v28 - s3_p * v30, X4_pm = v17 * v28 - s3_m * v30,
        X4_mp = v16 * v29 - s3_p * v31, X4_mm = v17 * v29 - s3_m * v31, v32 = sat2 * T13,
        v33 = sat2 * T23, v34 = v1 * v32 - v2 * v33,
        v35 = cat2 * T33 - inverse1 * (v4 * v33 + v5 * v32), v36 = v35 + w1 * (inverse1 * v34),
        v37 = v35 + w1 * (inverse1 * -v34), v38 = v36 * v36, v39 = v37 * v37,
        v40 = v38 + X4_pp * X4_pp, v41 = v38 + X4_pm * X4_pm, v42 = v39 + X4_mp * X4_mp,
        v43 = v39 + X4_mm * X4_mm, angle1 = atan2_wide(-v36, -X4_pp),
        angle2 = atan2_wide(-v36, -X4_pm), angle3 = atan2_wide(-v37, -X4_mp),
        angle4 = atan2_wide(-v37, -X4_mm), v44 = signed_wide(half_turn, -v36),
        v45 = signed_wide(half_turn, -v37);

    /* theta5 */
    const wide angle5 = atan2_wide(-sqrt_wide(v40), -(v16 * v30 + s3_p * v28)),
        angle6 = atan2_wide(-sqrt_wide(v41), -(v17 * v30 + s3_m * v28)),
        angle7 = atan2_wide(-sqrt_wide(v42), -(v16 * v31 + s3_p * v29)),
        angle8 = atan2_wide(-sqrt_wide(v43), -(v17 * v31 + s3_m * v29));

    /* theta6 */
    const wide v46 = sat2 * T12, v47 = sat2 * T22, v48 = v1 * v46 - v2 * v47,
        v49 = cat2 * T32 - inverse1 * (v4 * v47 + v5 * v46), v50 = v49 + w1 * (inverse1 * v48),
        v51 = v49 + w1 * (inverse1 * -v48), v52 = cat2 * T12, v53 = cat2 * T22,
        v54 = v1 * v52 - v2 * v53, v55 = sat2 * T32 + inverse1 * (v4 * v53 + v5 * v52),
        v56 = w1 * (inverse1 * v54) - v55, v57 = w1 * (inverse1 * -v54) - v55,
        v58 = c1_p * T22 + v11 * T12, v59 = v12 * T12 - v8 * T22, v60 = sat2 * T11,
        v61 = sat2 * T21, v62 = v1 * v60 - v2 * v61,
        v63 = cat2 * T31 - inverse1 * (v4 * v61 + v5 * v60), v64 = v63 + w1 * (inverse1 * v62),
        v65 = v63 + w1 * (inverse1 * -v62), v66 = cat2 * T11, v67 = cat2 * T21,
        v68 = v1 * v66 - v2 * v67, v69 = sat2 * T31 + inverse1 * (v4 * v67 + v5 * v66),
        v70 = w1 * (inverse1 * v68) - v69, v71 = w1 * (inverse1 * -v68) - v69,
        v72 = c1_p * T21 + v11 * T11, v73 = v12 * T11 - v8 * T21,
        v74 = v36 * (s3_p * v72 - v16 * v70) + X4_pp * v64,
        v75 = v36 * (s3_m * v72 - v17 * v70) + X4_pm * v64,
        v76 = v37 * (s3_p * v73 - v16 * v71) + X4_mp * v65,
        v77 = v37 * (s3_m * v73 - v17 * v71) + X4_mm * v65,
        angle9 = atan2_wide(v74, v36 * (s3_p * v58 - v16 * v56) + X4_pp * v50),
        angle10 = atan2_wide(v75, v36 * (s3_m * v58 - v17 * v56) + X4_pm * v50),
        angle11 = atan2_wide(v76, v37 * (s3_p * v59 - v16 * v57) + X4_mp * v51),
        angle12 = atan2_wide(v77, v37 * (s3_m * v59 - v17 * v57) + X4_mm * v51);

    /* joint values */
    const wide angle13 = atan2_wide(-v11, c1_p), q1_ppp = v13 + angle13,
        angle14 = atan2_wide(-v12, -v8), q1_mpp = v13 + angle14, angle15 = atan2_wide(s3_p, -v16),
        q3_ppp = v3 + angle15, angle16 = atan2_wide(s3_m, -v17), q3_pmp = v3 + angle16,
        q2_mpp = v23 - v20, q2_mmp = v23 - v21;

    q[0] = q1_ppp; q[1] = -(v20 + v22); q[2] = q3_ppp; q[3] = angle1; q[4] = angle5; q[5] = angle9;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_ppp; q[7] = -(v20 + v22); q[8] = q3_ppp; q[9] = angle1 - v44; q[10] = -angle5;
    q[11] = angle9 - signed_wide(half_turn, v74);
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_ppp; q[13] = -(v21 + v22); q[14] = q3_pmp; q[15] = angle2; q[16] = angle6;
    q[17] = angle10;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_ppp; q[19] = -(v21 + v22); q[20] = q3_pmp; q[21] = angle2 - v44; q[22] = -angle6;
    q[23] = angle10 - signed_wide(half_turn, v75);
    kind[3] = kind_of(q[18], 0);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_ppp; q[27] = angle3; q[28] = angle7; q[29] = angle11;
    kind[4] = kind_of(q[24], 0);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_ppp; q[33] = angle3 - v45; q[34] = -angle7;
    q[35] = angle11 - signed_wide(half_turn, v76);
    kind[5] = kind_of(q[30], 0);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_pmp; q[39] = angle4; q[40] = angle8; q[41] = angle12;
    kind[6] = kind_of(q[36], 0);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_pmp; q[45] = angle4 - v45; q[46] = -angle8;
    q[47] = angle12 - signed_wide(half_turn, v77);
    kind[7] = kind_of(q[42], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((abs_wide(D1) <= m1 * (merge_slack1 + 2.0 * abs_wide(Z1))) | (N1 <=
        doubt_limit_squared2) | (abs_wide(D3) <= m2 * (blur_slack1 + 2.0 * abs_wide(Z3))) | (v43 <=
        m7) | (v42 <= m7) | (v40 <= m7) | (v41 <= m7));
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
    const double wy = T24 - d6 * T23, v1 = sat2 * wy, wx = T14 - d6 * T13, v2 = sat2 * wx,
        N1 = v1 * v1 + v2 * v2, wz = T34 - d6 * T33, Z1 = cat2 * wz - k1, D1 = N1 - Z1 * Z1,
        w1 = sqrt(D1), v3 = w1 - w1, inverse1 = 1.0 / N1, v4 = v1 * Z1, v5 = v2 * Z1,
        v6 = inverse1 * v5;
    const four c1 = w1 * (inverse1 * (e1 * v1)) - v6;
    const double v7 = inverse1 * v4;
    const four v8 = v7 + w1 * (inverse1 * (e1 * v2));

    /* theta3 */
    const double Z3 = wz - k5, D3 = k4 - Z3 * Z3, w3 = sqrt(D3), v9 = w3 - w3, v10 = m5 * wz - m4;
    const four v11 = v10 + w3 * (m3 * e2);
    const double v12 = m3 * wz - m6;
    const four s3 = v12 - w3 * (m5 * e2);

    /* r2 */
    const four v13 = a3 * s3 - d4 * v11, v14 = c1 * -wy - wx * v8;

    /* theta4 */
    const double v15 = cat2 * T13, v16 = cat2 * T23, v17 = v1 * v15 - v2 * v16,
        v18 = sat2 * T33 + inverse1 * (v4 * v16 + v5 * v15);
    const four v19 = w1 * (inverse1 * (e1 * v17)) - v18, v20 = T13 * v8 + T23 * c1,
        X4 = v11 * v19 - s3 * v20;
    const double v21 = sat2 * T13, v22 = sat2 * T23, v23 = v1 * v21 - v2 * v22,
        v24 = cat2 * T33 - inverse1 * (v4 * v22 + v5 * v21);
    const four v25 = v24 + w1 * (inverse1 * (e1 * v23)), v26 = v25 * v25, v27 = v26 + X4 * X4,
        v28 = signed_four(half_turn, -v25);

    /* theta6 */
    const double v29 = sat2 * T12, v30 = sat2 * T22, v31 = v1 * v29 - v2 * v30,
        v32 = cat2 * T32 - inverse1 * (v4 * v30 + v5 * v29);
    const four v33 = v32 + w1 * (inverse1 * (e1 * v31));
    const double v34 = cat2 * T12, v35 = cat2 * T22, v36 = v1 * v34 - v2 * v35,
        v37 = sat2 * T32 + inverse1 * (v4 * v35 + v5 * v34);
    const four v38 = w1 * (inverse1 * (e1 * v36)) - v37, v39 = c1 * T22 + v8 * T12;
    const double v40 = sat2 * T11, v41 = sat2 * T21, v42 = v1 * v40 - v2 * v41,
        v43 = cat2 * T31 - inverse1 * (v4 * v41 + v5 * v40);
    const four v44 = v43 + w1 * (inverse1 * (e1 * v42));
    const double v45 = cat2 * T11, v46 = cat2 * T21, v47 = v1 * v45 - v2 * v46,
        v48 = sat2 * T31 + inverse1 * (v4 * v46 + v5 * v45);
    const four v49 = w1 * (inverse1 * (e1 * v47)) - v48, v50 = c1 * T21 + v8 * T11,
        v51 = v25 * (s3 * v50 - v11 * v49) + X4 * v44;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | (v27 <= m7)) | (unsigned)((fabs(D1) <= m1
        * (merge_slack1 + 2.0 * fabs(Z1))) | (fabs(D3) <= m2 * (blur_slack1 + 2.0 * fabs(Z3))) | (N1
        <= doubt_limit_squared2)))
        return -1;

    const four_ratio ratio1 = ratio_four(s3, -v11), ratio2 = ratio_four(-v8, c1),
        ratio3 = ratio_four(-v25, -X4),
        ratio4 = ratio_four(v51, v25 * (s3 * v39 - v11 * v38) + X4 * v33),
        ratio5 = ratio_four(-sqrt_four(v27), -(v11 * v20 + s3 * v19));
    const four packed1 = angle_four(ratio1), angle5 = shuffle(packed1, packed1, 0, 1, 0, 1),
        packed2 = angle_four(ratio2), angle4 = shuffle(packed2, packed2, 0, 0, 2, 2),
        angle1 = angle_four(ratio3), angle3 = angle_four(ratio4), angle2 = angle_four(ratio5);
    const four q4_m = angle1 - v28, q6_m = angle3 - signed_four(half_turn, v51), q1_p = v9 + angle4,
        q3_p = v3 + angle5;

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, -(v13 + v14), q3_p, angle1);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], angle2, angle3);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, -(v13 + v14), q3_p, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], -angle2, q6_m);
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

    /* theta1, type 2: U2 A6^-1 [3, 4] */
    const double wy = T24 - T23 * d6;
    const double v1 = wy * sat2;
    const double wx = T14 - d6 * T13;
    const double v2 = sat2 * wx;
    const double N1 = v1 * v1 + v2 * v2;
    const int free1 = N1 <= free_limit_squared2;
    const double wz = T34 - d6 * T33;
    const double Z1 = wz * cat2 - k1;
    const double D1 = N1 - Z1 * Z1;
    const double v3 = fabs(Z1), v4 = 2.0 * v3;
    const int apart1 = merge_slack1 * (v4 + merge_slack1) < D1;
    if (!(-(reach_slack1 * (v4 + reach_slack1)) <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : v3 * sqrt(N1)));
    const double v5 = v1 * Z1, v6 = v2 * Z1;
    const int near1 = N1 <= near_limit_squared2;
    const double v7 = v1 * cos(seed[0]) - v2 * sin(seed[0]);
    const double off1 = near1 ? fabs(Z1 + (v1 * sin(seed[0]) + v2 * cos(seed[0]))) : 1.0;
    const int v8 = off1 <= free_limit1;

    /* theta3, type 2: U0 A6^-1 [3, 4] */
    const double Z3 = wz - k5;
    const double D3 = k4 - Z3 * Z3;
    const double v9 = 2.0 * fabs(Z3);
    const int apart3 = merge_slack1 * (merge_slack1 + v9) < D3;
    if (!(-(reach_slack1 * (reach_slack1 + v9)) <= D3)) return; /* out of reach */
    const double w3 = sqrt(apart3 ? D3 : 0.0);
    const double v10 = k2 * Z3, v11 = k3 * Z3;

    /* theta4, type 2: U4[3, 3] */
    const double v15 = T13 * cat2, v16 = T23 * cat2, v17 = sat2 * T33, v20 = sat2 * T13,
        v21 = T23 * sat2, v22 = T33 * cat2;

    /* theta6, type 3: U4[3, 2] and U4[3, 1] */
    const double v25 = sat2 * T12, v26 = T22 * sat2, v27 = T32 * cat2, v29 = T12 * cat2,
        v30 = T22 * cat2, v31 = sat2 * T32, v35 = sat2 * T11, v36 = T21 * sat2, v37 = T31 * cat2,
        v39 = T11 * cat2, v40 = T21 * cat2, v41 = sat2 * T31;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double ahead1 = near1 ? root1 * v7 : -1.0;
        const int same1 = near1 && 0.0 <= ahead1 && v8;
        const int held1 = free1 || same1;
        const double c1 = held1 ? cos(seed[0]) : inverse1 * (v1 * root1 - v6),
            s1 = held1 ? sin(seed[0]) : -(inverse1 * (v5 + v2 * root1));
        const double q1 = atan2(s1, c1);

        /* r2, type 1: U1 A6^-1 [3, 4] */
        const double v14 = c1 * -wy + wx * s1;

        /* theta4 */
        const double v18 = c1 * v15 + s1 * v16 - v17, v19 = T13 * s1 - T23 * c1,
            v23 = c1 * v20 + s1 * v21 + v22, v24 = v23 * v23;

        /* theta6 */
        const double v28 = c1 * v25 + s1 * v26 + v27, v32 = c1 * v29 + s1 * v30 - v31,
            v33 = T22 * c1 - T12 * s1, v38 = c1 * v35 + s1 * v36 + v37,
            v42 = c1 * v39 + s1 * v40 - v41, v43 = T21 * c1 - T11 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip3, flip3 */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && (!apart3 || (near1 && !(blur_slack1 * (blur_slack1 + v9) < D3))))
                continue; /* both signs give the same */
            const double root3 = w3 * e2;
            const double v12 = k6 * (v11 + k2 * root3);
            const double s3 = k6 * (v10 - k3 * root3);
            const double q3 = atan2(s3, -v12);

            /* r2 */
            const double v13 = a3 * s3 - d4 * v12;

            /* theta4 */
            const double X4 = v12 * v18 - s3 * -v19;
            const double w4 = sqrt(X4 * X4 + v24);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = v12 * v19 - s3 * v18;

            /* theta6 */
            const double v34 = s3 * v33 - v12 * v32, v44 = s3 * v43 - v12 * v42;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip4, flip4 */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : -(v23 * factor4);
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v38 + s4 * v44), -(c4 * v28 + s4 * v34));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = -(v13 + v14); q[row][2] = q3; q[row][3] = q4;
                q[row][4] = q5; q[row][5] = q6;
                status[row] = (free1 || free4) ? FREE : OK;
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
static const double weights[6] = { 0.8065, 0.8065, 0.8065, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.24, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    prismatic_2_wrist_fk(x, P);
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
    prismatic_2_wrist_jacobian(x, J);
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

/* Ends rows that rounding alone tells from earlier ones: half way the arm is singular. */
static void tell_once(const double T[16], double q[8][6], unsigned char status[8])
{
    const int held[6] = { 0 };
    for (int n = 0; n < 8 * 8; n++) {
        double half[6], e[6], *row = q[n / 8];
        const int k = n % 8;
        int ends = 0;
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

int prismatic_2_wrist_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int prismatic_2_wrist_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = prismatic_2_wrist_ik(T, q_seed, all, status) >= 0;
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

void prismatic_2_wrist_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)prismatic_2_wrist_ik(
                    T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)prismatic_2_wrist_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
