/* kuka_iiwa14: KUKA LBR iiwa 14 R820
 *
 * Inverse kinematics, generated from robots/kuka_iiwa14.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_iiwa14.yaml. The formulas and where they come from:
 * kuka_iiwa14.md.
 */
#include "kuka_iiwa14.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = KUKA_IIWA14_OK, NONE = KUKA_IIWA14_UNREACHABLE, FREE = KUKA_IIWA14_FREE_JOINT,
    OUT = KUKA_IIWA14_OUT_OF_LIMITS, INVALID = KUKA_IIWA14_INVALID_POSE
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
#if defined(__clang__)
#define UNROLLED _Pragma("unroll")
#elif defined(__GNUC__) && __GNUC__ >= 8
#define UNROLLED _Pragma("GCC unroll 2")
#else
#define UNROLLED
#endif

#define maximum_double(a, b) ((a) > (b) ? (a) : (b))
#define minimum_double(a, b) ((a) < (b) ? (a) : (b))

#ifndef KUKA_IIWA14_LIBM
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
 * -DKUKA_IIWA14_SCALAR. With -DKUKA_IIWA14_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(KUKA_IIWA14_SCALAR) && !defined(KUKA_IIWA14_LIBM)
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

#define EACH(of, v, lanes) \
HELPER v of##_##v(v x) \
{ \
    for (int k = 0; k < lanes; k++) \
        x[k] = of(x[k]); \
    return x; \
}
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
EACH(cos, v, lanes) \
EACH(sin, v, lanes) \
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
#define cos_wide cos
#define sin_wide sin
#endif
#ifdef KUKA_IIWA14_LIBM /* half the time of atan2 */
HELPER double atan2_wide(double y, double x)
{
    return atan(y / x) + copysign(1.5707963267948966 - copysign(1.5707963267948966, x), y);
}
#else
ARCTANGENT(wide)
#endif

MISFIT(wide, wide)

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16], const wide free_joints[1])
{
    const wide w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0;
    return misfit_wide(T) + w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3 + 0.0 * (T[3] + T[7] + T[11] +
        free_joints[0]);
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

HELPER four irregularity_four(const double T[16], const double free_joints[1])
{
    const four x = *(const four_at *)T, y = *(const four_at *)(T + 4),
        z = *(const four_at *)(T + 8), x1 = shuffle(x, x, 1, 2, 0, 3),
        y1 = shuffle(y, y, 1, 2, 0, 3), z1 = shuffle(z, z, 1, 2, 0, 3),
        x2 = shuffle(x, x, 2, 0, 1, 3), y2 = shuffle(y, y, 2, 0, 1, 3),
        lengths = x * x + y * y + z * z - 1.0, angles = x * x1 + y * y1 + z * z1,
        mirror = x1 * y2 - x2 * y1 - z,
        last = *(const four_at *)(T + 12) - (four){ 0.0, 0.0, 0.0, 1.0 };
    return (lengths * lengths + 2.0 * angles * angles + mirror * mirror) * (four){ 1.0, 1.0, 1.0,
        0.0 } + last * last + 0.0 * (free_joints[0]);
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

TURNS(wide)
#if LANES > 1
TURNS(four)
#endif

#define high(joint) (highest[joint - 1] + slack(joint - 1))
/* How far a joint is beyond its limits; whether by rounding, perhaps. */
#define grazes(x) (abs_wide((x) - 5e-07) <= 5e-07)
#define grazes_four(x) (abs_four((x) - 5e-07) <= 5e-07)
#define exceeds(x, joint) (abs_wide(x) - high(joint))
#define exceeds_four(x, joint) (abs_four(x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.36, /* joint offset 1 [m] */
    d3 = 0.42, /* joint offset 3 [m] */
    d5 = 0.4, /* joint offset 5 [m] */
    d7 = 0.126, /* joint offset 7 [m] */
    longest4 = 0.6724000000000001, /* square of the longest reach [m^2] */
    shortest4 = 0.0003999999999999985, /* square of the shortest reach [m^2] */
    longest4_reach = 0.6724000000002143, /* the longest, with what rounding adds [m^2] */
    shortest4_reach = 0.0003999999999947745, /* the shortest, with what rounding adds [m^2] */
    longest4_apart = 0.6723999999999786, /* the longest, where branches merge [m^2] */
    shortest4_apart = 0.00040000000000052087, /* the shortest, where branches merge [m^2] */
    least_root2 = 5.393694619178955e-07, /* a root of nothing, by rounding [m^2] */
    free_limit_squared2 = 1.705636e-24, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 1.3060000000000002e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 1.306e-14, /* nearer to that boundary two branches are one [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 3.141592653589793, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset6 = 3.141592653589793, /* offset of joint 6 [rad] */
    k1 = 0.336, /* 2 * d5 * d3 [m^2] */
    k2 = 0.33640000000000003, /* d3^2 + d5^2 [m^2] */
    k3 = 0.5862915651405106, /* 1 / arm_size2 [m^-2] */
    k4 = 8.857709750566894, /* 1 / (k1^2) [m^-4] */
    doubt_limit_squared2 = 1.705636e-08, /* square of a length that fixes no angle [m^2] */
    /* 1000 * (longest4 - longest4_apart) * (longest4_apart - shortest4) [m^4] */
    m1 = 1.4473755527432779e-11,
    m2 = 1.306e-11, /* 1000 * merge_slack1 [m] */
    m3 = 2.909194164496e-16, /* doubt_limit_squared2^2 [m^4] */
    m4 = 9.999999999999999e-09; /* doubt_limit^2 */

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const kuka_iiwa14_branches[8] = {
    "noflip4-left-noflip5", "noflip4-left-flip5", "noflip4-right-noflip5", "noflip4-right-flip5",
    "flip4-left-noflip5", "flip4-left-flip5", "flip4-right-noflip5", "flip4-right-flip5",
};

static const double lowest[7] = {
    -2.9670597283903604, -2.0943951023931953, -2.9670597283903604, -2.0943951023931953,
    -2.9670597283903604, -2.0943951023931953, -3.0543261909900767,
};
static const double highest[7] = {
    2.9670597283903604, 2.0943951023931953, 2.9670597283903604, 2.0943951023931953,
    2.9670597283903604, 2.0943951023931953, 3.0543261909900767,
};
#define slack(joint) 1e-09 /* of limits */

/* What follows from joint values: what the pose and the Jacobian are made of. */
#define MOTION \
    const double v1 = q[0] + offset1, c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2, \
        c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2, \
        z2_y = s1 * s2, c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3, \
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3, \
        z3_x = x2_x * s3 - s1 * c3, v3 = q[3] + offset4, c4 = cos(v3), s4 = sin(v3), \
        x4_x = x3_x * c4 + z2_x * s4, x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, \
        z4_z = c2 * c4 + x3_z * s4, z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4, \
        c5 = cos(q[4]), s5 = sin(q[4]), z5_x = x4_x * s5 - z3_x * c5, \
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5, v4 = q[5] + offset6, \
        c6 = cos(v4), s6 = sin(v4)

void kuka_iiwa14_fk(const double q[7], double T[16])
{
    MOTION;
    const double x5_x = x4_x * c5 + z3_x * s5, x5_y = x4_y * c5 + z3_y * s5,
        x5_z = x4_z * c5 + z3_z * s5, x6_x = x5_x * c6 + z4_x * s6, x6_y = x5_y * c6 + z4_y * s6,
        x6_z = x5_z * c6 + z4_z * s6, z6_x = x5_x * s6 - z4_x * c6, z6_y = x5_y * s6 - z4_y * c6,
        z6_z = x5_z * s6 - z4_z * c6;
    const double c7 = cos(q[6]), s7 = sin(q[6]);
    T[0] = x6_x * c7 + z5_x * s7; T[1] = z5_x * c7 - x6_x * s7; T[2] = z6_x;
    T[3] = z2_x * d3 + z4_x * d5 + z6_x * d7;
    T[4] = x6_y * c7 + z5_y * s7; T[5] = z5_y * c7 - x6_y * s7; T[6] = z6_y;
    T[7] = z2_y * d3 + z4_y * d5 + z6_y * d7;
    T[8] = x6_z * c7 + z5_z * s7; T[9] = z5_z * c7 - x6_z * s7; T[10] = z6_z;
    T[11] = d1 - c2 * d3 + z4_z * d5 + z6_z * d7;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kuka_iiwa14_jacobian(const double q[7], double J[42])
{
    MOTION;
    const double p3_x = z2_x * d3, p3_y = z2_y * d3, p3_z = d1 - c2 * d3, p5_x = p3_x + z4_x * d5,
        p5_y = p3_y + z4_y * d5, p5_z = p3_z + z4_z * d5,
        z6_x = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6,
        z6_y = (x4_y * c5 + z3_y * s5) * s6 - z4_y * c6,
        z6_z = (x4_z * c5 + z3_z * s5) * s6 - z4_z * c6, p7_x = p5_x + z6_x * d7,
        p7_y = p5_y + z6_y * d7, p7_z = p5_z + z6_z * d7, v5 = p7_z - d1, v6 = p7_x - p3_x,
        v7 = p7_y - p3_y, v8 = p7_z - p3_z, v9 = p7_x - p5_x, v10 = p7_y - p5_y, v11 = p7_z - p5_z;
    J[0] = -p7_y; J[1] = -(c1 * v5); J[2] = z2_y * v5 + c2 * p7_y; J[3] = z3_y * v8 - z3_z * v7;
    J[4] = z4_y * v8 - z4_z * v7; J[5] = z5_y * v11 - z5_z * v10; J[6] = z6_y * v11 - z6_z * v10;
    J[7] = p7_x; J[8] = -(s1 * v5); J[9] = -(c2 * p7_x + z2_x * v5); J[10] = z3_z * v6 - z3_x * v8;
    J[11] = z4_z * v6 - z4_x * v8; J[12] = z5_z * v9 - z5_x * v11; J[13] = z6_z * v9 - z6_x * v11;
    J[14] = 0.0; J[15] = s1 * p7_y + c1 * p7_x; J[16] = z2_x * p7_y - z2_y * p7_x;
    J[17] = z3_x * v7 - z3_y * v6; J[18] = z4_x * v7 - z4_y * v6; J[19] = z5_x * v10 - z5_y * v9;
    J[20] = z6_x * v10 - z6_y * v9;
    J[21] = 0.0; J[22] = s1; J[23] = z2_x; J[24] = z3_x; J[25] = z4_x; J[26] = z5_x; J[27] = z6_x;
    J[28] = 0.0; J[29] = -c1; J[30] = z2_y; J[31] = z3_y; J[32] = z4_y; J[33] = z5_y; J[34] = z6_y;
    J[35] = 1.0; J[36] = 0.0; J[37] = -c2; J[38] = z3_z; J[39] = z4_z; J[40] = z5_z; J[41] = z6_z;
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
static double beyond_limits(const double values[7])
{
    double sum = 0.0;
    for (int i = 0; i < 7; i++)
        sum += fabs(overshoot(i, values[i]));
    return sum;
}

#define sqrt_double sqrt
#define sin_double sin
#define cos_double cos

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    const number c3 = cos_##number(free_joints[0]), s3 = sin_##number(free_joints[0]); \
    /* theta4 */ \
    const number wx = T14 - d7 * T13, wy = T24 - d7 * T23, v1 = wy * wy, \
        Z1_2 = T34 - d7 * T33 - d1, V4 = v1 + wx * wx + Z1_2 * Z1_2, \
        D4 = (longest4 - V4) * (V4 - shortest4), w4 = sqrt_##number(D4), v2 = k1 * (V4 - k2), \
        v3 = k4 * v2, v4 = k1 * w4, v5 = k4 * v4; \
    /* theta1 */ \
    const number N1 = v1 - wx * -wx, Z1 = d5 * (s3 * v5), D1 = N1 - Z1 * Z1, \
        w1 = sqrt_##number(D1), v6 = w1 - w1, inverse1 = 1.0 / N1, v7 = -wx * Z1, v8 = wy * Z1; \
    /* theta2 */ \
    const number v15 = d5 * (c3 * v5), X2_2 = d3 + d5 * v3, v16 = Z1_2 * v15, v17 = w1 * X2_2, \
        v20 = Z1_2 * X2_2, v21 = w1 * v15; \
    /* theta5 */ \
    const number v24 = c3 * T13, v25 = v3 * v24, v26 = c3 * T23, v27 = v3 * v26, v28 = T33 * v5, \
        v29 = T13 * v5, v30 = T23 * v5, v31 = c3 * T33, v32 = v3 * v31, \
        v33 = T13 * wy + T23 * -wx, v38 = s3 * T33; \
    /* theta6 */ \
    const number v40 = v5 * v24, v41 = v5 * v26, v42 = T33 * v3, v43 = T13 * v3, v44 = T23 * v3, \
        v45 = v5 * v31; \
    /* theta7 */ \
    const number v47 = s3 * T32, v49 = v3 * (c3 * T12), v50 = v3 * (c3 * T22), v51 = v5 * T32, \
        v52 = v5 * T12, v53 = v5 * T22, v54 = v3 * (c3 * T32), v56 = s3 * T31, \
        v58 = v3 * (c3 * T11), v59 = v3 * (c3 * T21), v60 = v5 * T31, v61 = v5 * T11, \
        v62 = v5 * T21, v63 = v3 * (c3 * T31); \
    /* joint values */ \
    const number q3_p = v6 + (free_joints[0] + (w4 - w4))
#define SIGNED(number, signs) \
    /* theta1 */ \
    const number v9 = e1 * v8, v11 = inverse1 * v9, v12 = e1 * v7, v14 = inverse1 * v12; \
    /* theta2 */ \
    const number v19 = e1 * v16; \
    /* theta5 */ \
    const number v35 = inverse1 * (s3 * (T13 * v12 - T23 * v9)), v37 = e1 * v28; \
    /* theta6 */ \
    const number v46 = e1 * v45; \
    /* theta7 */ \
    const number v55 = e1 * v51, v64 = e1 * v60
#define SIGNED_TWICE(number, signs) \
    /* theta1 */ \
    const number v10 = w1 * (inverse1 * (e2 * -wx)), c1 = v11 - v10, \
        v13 = w1 * (inverse1 * (e2 * wy)), s1 = v13 + v14; \
    /* theta2 */ \
    const number v18 = e2 * v17, S2 = v18 - v19, v22 = v20 + v21 * (e1 * e2), \
        v23 = S2 * S2 + v22 * v22, factor2 = sqrt_##number(v23) * (1.0 / v23); \
    /* theta5 */ \
    const number v34 = w1 * (inverse1 * (s3 * (e2 * v33))), v36 = v34 + v35, \
        X5 = v3 * v36 + factor2 * (v22 * (v37 - (c1 * v25 + s1 * v27)) + S2 * (v32 + e1 * (c1 * \
            v29 + s1 * v30))), \
        Y5 = factor2 * (S2 * v38 - v22 * (s3 * (T13 * c1 + T23 * s1))) - c3 * (T13 * s1 - T23 * \
            c1), v39 = X5 * X5 + Y5 * Y5; \
    /* theta7 */ \
    const number v48 = s1 * T12 - c1 * T22, v57 = s1 * T11 - c1 * T21

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(
    const wide T[16], const wide free_joints[1], wide q[56], wide_mask kind[8])
{
    ENTRIES(wide);
    wide_mask left = (irregularity_wide(T, free_joints) <= 1e-24) == 0;
    KNOWN(wide);

    /* joint values */
    const wide angle5 = atan2_wide(-v4, -v2);
    left |= (N1 <= doubt_limit_squared2) | (abs_wide(D4) <= m1) | (0.0 < exceeds(free_joints[0], 3))
        | (abs_wide(D1 * (k3 * w4)) <= m2 * (merge_slack1 + 2.0 * abs_wide(Z1)));

    UNROLLED for (int i1 = 0; i1 < 2; i1++) { /* noflip4, flip4 */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* joint values */
        const wide v67 = e1 * angle5 - offset4, q4_ = raised_wide(v67), v70 = exceeds(q4_, 4),
            q4_p = v6 + q4_;

        UNROLLED for (int i2 = 0; i2 < 2; i2++) { /* left, right */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            SIGNED_TWICE(wide, double);

            /* theta5 */
            const wide angle1 = atan2_wide(Y5, -X5), q5_m = angle1 - signed_wide(half_turn, Y5);

            /* theta7 */
            const wide angle2 = atan2_wide(-(X5 * (c3 * v57 - factor2 * (S2 * v56 - v22 * (s3 * (c1
                * T11 + s1 * T21)))) + Y5 * (v3 * (s3 * v57) + factor2 * (v22 * (v64 - (c1 * v58 +
                s1 * v59)) + S2 * (v63 + e1 * (c1 * v61 + s1 * v62))))), -(X5 * (c3 * v48 - factor2
                * (S2 * v47 - v22 * (s3 * (c1 * T12 + s1 * T22)))) + Y5 * (v3 * (s3 * v48) + factor2
                * (v22 * (v55 - (c1 * v49 + s1 * v50)) + S2 * (v54 + e1 * (c1 * v52 + s1 *
                v53)))))),
                q7_m = angle2 - signed_wide(half_turn, -(X5 * (c3 * v57 - factor2 * (S2 * v56 - v22
                    * (s3 * (c1 * T11 + s1 * T21)))) + Y5 * (v3 * (s3 * v57) + factor2 * (v22 * (v64
                    - (c1 * v58 + s1 * v59)) + S2 * (v63 + e1 * (c1 * v61 + s1 * v62))))));

            /* joint values */
            const wide angle3 = atan2_wide(s1, c1), v65 = angle3 - offset1, q1_p = raised_wide(v65),
                angle4 = atan2_wide(S2, -v22), v66 = angle4 - offset2, q2_p = raised_wide(v66),
                angle6 = atan2_wide(sqrt_wide(v39), e1 * (v5 * v36) - factor2 * (S2 * (c1 * v43 + s1
                    * v44 - v46) + v22 * (v42 + e1 * (c1 * v40 + s1 * v41)))),
                v68 = angle6 - offset6, v69 = offset6 + angle6, q6_p = raised_wide(v68),
                q6_m = only_wide(-v69 <= -half_turn, turn) - v69,
                v71 = maximum_wide(exceeds(q2_p, 2), maximum_wide(v70, exceeds(q1_p, 1))),
                excess_p = maximum_wide(exceeds(angle2, 7), maximum_wide(exceeds(q6_p, 6),
                    maximum_wide(v71, exceeds(angle1, 5)))),
                excess_m = maximum_wide(exceeds(q7_m, 7), maximum_wide(exceeds(q6_m, 6),
                    maximum_wide(v71, exceeds(q5_m, 5))));
            const int row = 4 * i1 + 2 * i2;
            q[7 * row] = q1_p; q[7 * row + 1] = q2_p; q[7 * row + 2] = q3_p; q[7 * row + 3] = q4_p;
            q[7 * row + 4] = angle1; q[7 * row + 5] = q6_p; q[7 * row + 6] = angle2;
            kind[row] = kind_of(q[7 * row], 0.0 < excess_p);
            q[7 * row + 7] = q1_p; q[7 * row + 8] = q2_p; q[7 * row + 9] = q3_p;
            q[7 * row + 10] = q4_p; q[7 * row + 11] = q5_m; q[7 * row + 12] = q6_m;
            q[7 * row + 13] = q7_m;
            kind[row + 1] = kind_of(q[7 * row + 7], 0.0 < excess_m);
            left |= (v23 <= m3) | (v39 <= m4);
            left |= grazes(excess_p) | grazes(excess_m);
        }
    }
    return left;
}

#if LANES > 1
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(
    const double T[16], const double free_joints[1], double q[8][7], unsigned char status[8])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);
    KNOWN(double);
    SIGNED(four, four);
    SIGNED_TWICE(four, four);

    if (bits_four(((irregularity_four(T, free_joints) <= 1e-24) == 0) | ((v23 <= m3) | (v39 <= m4)))
        | (unsigned)((N1 <= doubt_limit_squared2) | (fabs(D4) <= m1) | (0.0 < fabs(free_joints[0]) -
        high(3)) | (fabs(D1 * (k3 * w4)) <= m2 * (merge_slack1 + 2.0 * fabs(Z1)))))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ -v4, -v4, -v4, -v4 }, (four){ -v2, -v2, -v2, -v2
        }), ratio2 = ratio_four(s1, c1), ratio3 = ratio_four(S2, -v22),
        ratio4 = ratio_four(Y5, -X5),
        ratio5 = ratio_four(-(X5 * (c3 * v57 - factor2 * (S2 * v56 - v22 * (s3 * (c1 * T11 + s1 *
            T21)))) + Y5 * (v3 * (s3 * v57) + factor2 * (v22 * (v64 - (c1 * v58 + s1 * v59)) + S2 *
            (v63 + e1 * (c1 * v61 + s1 * v62))))), -(X5 * (c3 * v48 - factor2 * (S2 * v47 - v22 *
            (s3 * (c1 * T12 + s1 * T22)))) + Y5 * (v3 * (s3 * v48) + factor2 * (v22 * (v55 - (c1 *
            v49 + s1 * v50)) + S2 * (v54 + e1 * (c1 * v52 + s1 * v53)))))),
        ratio6 = ratio_four(sqrt_four(v39), e1 * (v5 * v36) - factor2 * (S2 * (c1 * v43 + s1 * v44 -
            v46) + v22 * (v42 + e1 * (c1 * v40 + s1 * v41))));
    const four packed1 = angle_four(ratio1), angle5 = shuffle(packed1, packed1, 0, 0, 0, 0),
        angle3 = angle_four(ratio2), angle4 = angle_four(ratio3), angle1 = angle_four(ratio4),
        angle2 = angle_four(ratio5), angle6 = angle_four(ratio6);
    const four q5_m = angle1 - signed_four(half_turn, Y5),
        q7_m = angle2 - signed_four(half_turn, -(X5 * (c3 * v57 - factor2 * (S2 * v56 - v22 * (s3 *
            (c1 * T11 + s1 * T21)))) + Y5 * (v3 * (s3 * v57) + factor2 * (v22 * (v64 - (c1 * v58 +
            s1 * v59)) + S2 * (v63 + e1 * (c1 * v61 + s1 * v62)))))), v65 = angle3 - offset1,
        q1_p = raised_four(v65), v66 = angle4 - offset2, q2_p = raised_four(v66),
        v67 = e1 * angle5 - offset4, q4_ = raised_four(v67), v68 = angle6 - offset6,
        v69 = offset6 + angle6, q6_p = raised_four(v68),
        q6_m = only_four(-v69 <= -half_turn, turn) - v69, v70 = exceeds_four(q4_, 4),
        q4_p = v6 + q4_,
        v71 = maximum_four(exceeds_four(q2_p, 2), maximum_four(v70, exceeds_four(q1_p, 1))),
        excess_p = maximum_four(exceeds_four(angle2, 7), maximum_four(exceeds_four(q6_p, 6),
            maximum_four(v71, exceeds_four(angle1, 5)))),
        excess_m = maximum_four(exceeds_four(q7_m, 7), maximum_four(exceeds_four(q6_m, 6),
            maximum_four(v71, exceeds_four(q5_m, 5))));
    const four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (bits_four((grazes_four(excess_p) | grazes_four(excess_m))))
        return -1;

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, q2_p, all_four(q3_p), q4_p);
    store_4(&q[0][3], &q[2][3], &q[4][3], &q[6][3], q4_p, angle1, q6_p, angle2);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, q2_p, all_four(q3_p), q4_p);
    store_4(&q[1][3], &q[3][3], &q[5][3], &q[7][3], q4_p, q5_m, q6_m, q7_m);
    const unsigned long long none1 = (bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long outside1 = (bits_four(outside_p) * 0x200040008001ull &
        0x1000100010001ull) | (bits_four(outside_m) * 0x20004000800100ull & 0x100010001000100ull);
    const unsigned long long kind1 = none1 * NONE + (outside1 & ~none1) * OUT;
    __builtin_memcpy(status + 0, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~(none1 | outside1));
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    wide pose[16], found[56], x[LANES];
    wide_mask kind[8];
    wide given[1];
    for (int i = 0; i < 1; i++)
        for (int k = 0; k < LANES; k++)
            given[i][k] = free_joints[1 * k + i];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, given, found, kind);
    for (int i = 0; i < 56; i += LANES) {
        const int from = i + LANES <= 56 ? i : 56 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 56 * k + from) = x[k];
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
HELPER int solve_regular(
    const double T[16], const double free_joints[1], double q[8][7], unsigned char status[8])
{
    wide_mask kind[8];
    int count = 0;
    if (solve_wide(T, free_joints, &q[0][0], kind))
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
    const double T[16], const double free_joints[1], const double seed[7], double q[8][7],
    unsigned char status[8])
{
    ENTRIES(double);

    const double c3 = cos(free_joints[0]), s3 = sin(free_joints[0]);

    /* theta4, type 2: the squared length of column 4 of U1 A7^-1 */
    const double wx = T14 - T13 * d7;
    const double wy = T24 - d7 * T23;
    const double v1 = wy * wy;
    const double wz = T34 - d7 * T33;
    const double Z1_2 = wz - d1;
    const double V4 = wx * wx + v1 + Z1_2 * Z1_2;
    const double Z4 = V4 - k2;
    const double D4 = (longest4 - V4) * (V4 - shortest4);
    const int apart4 = shortest4_apart < V4 && V4 < longest4_apart;
    if (!(shortest4_reach <= V4 && V4 <= longest4_reach)) return; /* out of reach */
    const double w4 = sqrt(apart4 ? D4 : 0.0);
    const double v2 = (apart4 ? w4 : least_root2) * k3, v3 = k4 * (k1 * Z4);

    /* theta1, type 2: U1 A7^-1 [3, 4] */
    const double N1 = v1 + -wx * -wx;
    const int free1 = N1 <= free_limit_squared2;
    const double v7 = sqrt(N1), v10 = seed[0] + offset1;

    /* theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4] */
    const double X2_2 = d3 + d5 * v3;
    const double v13 = Z1_2 * X2_2, v15 = seed[1] + offset2;

    /* theta5, type 2: U5[3, 3] */
    const double v16 = c3 * T13, v17 = v3 * v16, v18 = c3 * T23, v19 = v3 * v18, v23 = c3 * T33,
        v24 = v3 * v23, v27 = s3 * T33;

    /* theta6, type 3: U5[2, 3] and U5[1, 3] */
    const double v30 = T33 * v3, v31 = T13 * v3, v32 = T23 * v3;

    /* theta7, type 3: U5[3, 2] and U5[3, 1] */
    const double v34 = s3 * T32, v37 = v3 * (c3 * T12), v38 = v3 * (c3 * T22),
        v42 = v3 * (c3 * T32), v44 = s3 * T31, v47 = v3 * (c3 * T11), v48 = v3 * (c3 * T21),
        v52 = v3 * (c3 * T31);

    for (int i1 = 0; i1 < 2; i1++) { /* noflip4, flip4 */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e1 < 0.0 && !apart4) continue; /* both signs give the same */
        const double v4 = k4 * (k1 * (w4 * e1));

        /* theta1 */
        const double Z1 = d5 * (s3 * v4);
        const double D1 = N1 - Z1 * Z1;
        const double v5 = fabs(Z1), v6 = 2.0 * v5;
        const int apart1 = merge_slack1 * (v6 + merge_slack1) < D1;
        if (!(-(reach_slack1 * (v6 + reach_slack1)) <= v2 * D1)) continue; /* out of reach */
        const double w1 = sqrt(apart1 ? D1 : 0.0);
        const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : v5 * v7));
        const double v8 = -wx * Z1, v9 = wy * Z1;

        /* theta2 */
        const double v11 = d5 * (c3 * v4), v12 = Z1_2 * v11;

        /* theta5 */
        const double v20 = T33 * v4, v21 = T13 * v4, v22 = T23 * v4;

        /* theta6 */
        const double v28 = v4 * v16, v29 = v4 * v18, v33 = v4 * v23;

        /* theta7 */
        const double v39 = T32 * v4, v40 = T12 * v4, v41 = T22 * v4, v49 = T31 * v4, v50 = T11 * v4,
            v51 = T21 * v4;

        /* joint values */
        const double q4 = wrap(atan2(-v4, -v3) - offset4);

        for (int i2 = 0; i2 < 2; i2++) { /* left, right */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta1 */
            if (e2 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
            const double root1 = w1 * e2;
            const double c1 = free1 ? cos(v10) : inverse1 * (v9 - -wx * root1),
                s1 = free1 ? sin(v10) : inverse1 * (v8 + wy * root1);

            /* theta2 */
            const double S2 = root1 * X2_2 - v12;
            const double v14 = root1 * v11 + v13;
            const double w2 = sqrt(S2 * S2 + v14 * v14);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v15) : -(v14 * factor2),
                s2 = free2 ? sin(v15) : S2 * factor2;

            /* theta5 */
            const double v25 = T13 * s1 - T23 * c1, v26 = s3 * v25;
            const double X5 = v3 * v26 - (c2 * (v20 - (c1 * v17 + s1 * v19)) - s2 * (c1 * v21 + s1 *
                v22 + v24));
            const double Y5 = c2 * (s3 * (T13 * c1 + T23 * s1)) + s2 * v27 - c3 * v25;
            const double w5 = sqrt(X5 * X5 + Y5 * Y5);
            const int free5 = w5 <= free_limit;
            const double divisor5 = free5 ? 1.0 : w5;

            /* theta6 */
            const double c6 = v4 * v26 - (s2 * (c1 * v31 + s1 * v32 - v33) - c2 * (c1 * v28 + s1 *
                v29 + v30));

            /* theta7 */
            const double v35 = T12 * s1 - T22 * c1,
                v36 = c3 * v35 - (c2 * (s3 * (T12 * c1 + T22 * s1)) + s2 * v34),
                v43 = c2 * (v39 - (c1 * v37 + s1 * v38)) - s2 * (c1 * v40 + s1 * v41 + v42) - v3 *
                    (s3 * v35), v45 = T11 * s1 - T21 * c1,
                v46 = c3 * v45 - (c2 * (s3 * (T11 * c1 + T21 * s1)) + s2 * v44),
                v53 = c2 * (v49 - (c1 * v47 + s1 * v48)) - s2 * (c1 * v50 + s1 * v51 + v52) - v3 *
                    (s3 * v45);

            /* joint values */
            const double q1 = wrap(atan2(s1, c1) - offset1);
            const double q2 = wrap(atan2(s2, c2) - offset2);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip5, flip5 */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta5 */
                if (e3 < 0.0 && free5) continue; /* both signs give the same */
                const double factor5 = e3 / divisor5;
                const double c5 = free5 ? cos(seed[4]) : -(X5 * factor5),
                    s5 = free5 ? sin(seed[4]) : Y5 * factor5;
                const double q5 = atan2(s5, c5);
                const double s6 = w5 * e3;

                /* theta7 */
                const double c7 = c5 * v36 + s5 * v43, s7 = c5 * v46 + s5 * v53;
                const double q7 = atan2(s7, c7);

                /* joint values */
                const double q6 = wrap(atan2(s6, c6) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = free_joints[0]; q[row][3] = q4;
                q[row][4] = q5; q[row][5] = q6; q[row][6] = q7;
                status[row] = (free1 || free2 || free5) ? FREE : OK;
            }
        }
    }
}

static void take(const double from[7], double to[7])
{
    for (int i = 0; i < 7; i++)
        to[i] = from[i];
}

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const double *T;
    const double *free_joints;
    double seed[7], start, q[8][7];
    unsigned char status[8];
    int joint, row;
};

/* Solves with the joint moved: 0 if it serves, else less. */
static double attempt(struct search *s, double moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < 8; i++)
        s->status[i] = NONE;
    solve(s->T, s->free_joints, s->seed, s->q, s->status);
    if (s->status[s->row] == NONE)
        return -HUGE_VAL;
    return -beyond_limits(s->q[s->row]);
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
    return NAN;
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

/* Whether a joint beyond its limits does not move with the one that is searched. */
static int hopeless(struct search *s)
{
    struct search other = *s;
    if (isinf(attempt(s, 0.0)) || isinf(attempt(&other, 0.1)))
        return 0;
    for (int i = 0; i < 7; i++) {
        const double value = s->q[s->row][i], moved = fabs(value - other.q[s->row][i]);
        if (moved < 1e-09 && fabs(overshoot(i, value)) > 0.0)
            return 1;
    }
    return 0;
}

/* A free joint took the seed's value, and that puts one beyond its limits: takes the nearest value
 * that keeps all, if there is one; other free joints the seed's, as far as their limits allow. */
static void keep_limits(
    const double T[16], const double free_joints[1], const double seed[7], int row, double q[8][7],
    unsigned char status[8])
{
    static const int choosable[3] = { 4, 1, 0 };
    struct search search = { .T = T, .row = row, .free_joints = free_joints };
    for (int i = 0; i < 7; i++)
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
static double half_way(const double x[7], const double q[7], double half[7])
{
    double most = 0.0;
    for (int i = 0; i < 7; i++) {
        double off = q[i] - x[i];
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.7657, 0.7657, 0.7657, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[7] = { 1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[7], double e[6])
{
    double P[16], square = 0.0;
    kuka_iiwa14_fk(x, P);
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
static void add_step(const int held[7], double damping, double e[6], double x[7])
{
    double A[6][13] = { { 0.0 } }, square[6] = { 0.0 }, J[42];
    kuka_iiwa14_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 7; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[7 * i + j];
        A[i][7 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 13; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 13; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 13; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 7; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[7])
{
    double x[7], half[7], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[7] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 7 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? overshoot(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 7; i++)
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

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const double T[16], int row, int far, double rows[8][7], const unsigned char status[8])
{
    double x[7], half[7], to[7], *q = rows[row];
    const double beyond = beyond_limits(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!settle(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 8; k++)
        if (status[k] != NONE && beyond_limits(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

/* Leads rows of nested roots to solutions, ends those that rounding alone tells from earlier ones:
 * half way the arm is singular. */
static void tell_once(const double T[16], double q[8][7], unsigned char status[8])
{
    const int held[7] = { 0 };
    for (int n = 0; n < 8 * 8; n++) {
        double half[7], e[6], *row = q[n / 8];
        const int k = n % 8;
        int ends = k == 0 && off_pose(T, row, e) > 1e-11 && !settle(T, 1e-12, 0.15, row);
        if (0 < k && k <= n / 8 && half_way(q[k - 1], row, half) < 0.001 && !isnan(half[0])) {
            for (int i = 0; i < 3; i++) {
                off_pose(T, half, e);
                add_step(held, 1e-13, e, half);
            }
            ends = off_pose(T, half, e) <= 1e-14;
        }
        for (int i = 0; i < 7 && ends; i++) {
            status[n / 8] = NONE;
            row[i] = NAN;
        }
    }
}

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const double T[16], const double free_joints[1], const double seed[7], double q[8][7],
    unsigned char status[8])
{
    double x[7], half[7], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    for (int i = 0; i < 7; i++)
        x[i] = seed[i] - overshoot(i, seed[i]);
    x[2] = free_joints[0];
    if (!settle(T, 1e-12, 0.15, x) || (beyond_limits(x) > 1e-09 && !settle(T, NAN, 0.15, x)))
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
    if (nearest > 1e-06 || beyond_limits(q[place]) > 0.0)
        take(x, q[place]);
}

/* A pose that is rounded, singular or none; regular ones need no stack for it. */
APART int ik_carefully(
    const double T[16], const double free_joints[1], const double *q_seed, double q[8][7],
    unsigned char status[8])
{
    const double zeros[7] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = isfinite(free_joints[0]) ? read_pose(T, pose) : 0;
    for (int i = 0; i < 7; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    if (valid == 2 && (count = solve_regular(pose, free_joints, q, status)) >= 0)
        return count;
    count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 7; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, free_joints, seed, q, status);
    for (int row = 0; row < 8; row++)
        if (status[row] == FREE && beyond_limits(q[row]) > 0.0)
            keep_limits(pose, free_joints, seed, row, q, status);
    tell_once(pose, q, status);
    stay(pose, free_joints, seed, q, status);
    /* far where no row is inside */
    for (int n = 0; n < 8 || (n < 2 * 8 && count == 0); n++) {
        const int row = n % 8, far = n >= 8;
        if (status[row] == NONE)
            continue;
        if (stand(pose, row, far, q, status) && far)
            status[row] = FREE;
        for (int i = 0; i < 7; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, pace[i] > 0.0 ? 0.0 : *value);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int kuka_iiwa14_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[8][7],
    unsigned char status[8])
{
    const int count = solve_regular(T, free_joints, q, status);
    return count < 0 ? ik_carefully(T, free_joints, q_seed, q, status) : count;
}

int kuka_iiwa14_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    double all[8][7], found[7], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = kuka_iiwa14_ik(T, free_joints, q_seed, all, status) >= 0;
    for (int i = 0; i < 7; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 8 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 7; i++) {
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

void kuka_iiwa14_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, free_joints + k, q + 56 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)kuka_iiwa14_ik(
                    T + 16 * i, free_joints + i, NULL, (double (*)[7])(q + 56 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)kuka_iiwa14_ik(
            T + 16 * k, free_joints + k, NULL, (double (*)[7])(q + 56 * k), status + 8 * k);
}
