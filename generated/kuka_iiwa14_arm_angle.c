/* kuka_iiwa14_arm_angle: KUKA LBR iiwa 14 R820, arm angle given
 *
 * Inverse kinematics, generated from robots/kuka_iiwa14_arm_angle.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_iiwa14_arm_angle.yaml. The formulas and where they come from:
 * kuka_iiwa14_arm_angle.md.
 */
#include "kuka_iiwa14_arm_angle.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = KUKA_IIWA14_ARM_ANGLE_OK, NONE = KUKA_IIWA14_ARM_ANGLE_UNREACHABLE, FREE =
        KUKA_IIWA14_ARM_ANGLE_FREE_JOINT,
    OUT = KUKA_IIWA14_ARM_ANGLE_OUT_OF_LIMITS, INVALID = KUKA_IIWA14_ARM_ANGLE_INVALID_POSE
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

#ifndef KUKA_IIWA14_ARM_ANGLE_LIBM
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
 * -DKUKA_IIWA14_ARM_ANGLE_SCALAR. With -DKUKA_IIWA14_ARM_ANGLE_LIBM the arctangents are those of
 * <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(KUKA_IIWA14_ARM_ANGLE_SCALAR) && !defined(KUKA_IIWA14_ARM_ANGLE_LIBM)
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
#ifdef KUKA_IIWA14_ARM_ANGLE_LIBM /* half the time of atan2 */
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
    free_limit = 1e-12, /* a length that fixes no angle */
    straight_limit = 5.353007080137295e-08, /* a stretched arm: its elbow is on either side [m^2] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 3.141592653589793, /* offset of joint 2 [rad] */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset6 = 3.141592653589793, /* offset of joint 6 [rad] */
    k1 = 0.336, /* 2 * d5 * d3 [m^2] */
    k2 = 0.33640000000000003, /* d3^2 + d5^2 [m^2] */
    k3 = 8.857709750566894, /* 1 / (k1^2) [m^-4] */
    /* 1000 * (longest4 - longest4_apart) * (longest4_apart - shortest4) [m^4] */
    m1 = 1.4473755527432779e-11,
    m2 = 1e-24, /* free_limit^2 */
    m3 = 9.999999999999999e-09; /* doubt_limit^2 */

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const kuka_iiwa14_arm_angle_branches[8] = {
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

void kuka_iiwa14_arm_angle_fk(const double q[7], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3,
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        z3_x = x2_x * s3 - s1 * c3, v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, z4_z = c2 * c4 + x3_z * s4,
        z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z5_x = x4_x * s5 - z3_x * c5,
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5, v4 = q[5] + offset6;
    const double c6 = cos(v4), s6 = sin(v4), x6_x = x5_x * c6 + z4_x * s6,
        x6_y = x5_y * c6 + z4_y * s6, x6_z = x5_z * c6 + z4_z * s6, z6_x = x5_x * s6 - z4_x * c6,
        z6_y = x5_y * s6 - z4_y * c6, z6_z = x5_z * s6 - z4_z * c6;
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

void kuka_iiwa14_arm_angle_jacobian(const double q[7], double J[42])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3,
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        p3_x = z2_x * d3, p3_y = z2_y * d3, p3_z = d1 - c2 * d3, z3_x = x2_x * s3 - s1 * c3,
        v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, z4_z = c2 * c4 + x3_z * s4,
        z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), p5_x = p3_x + z4_x * d5, p5_y = p3_y + z4_y * d5,
        p5_z = p3_z + z4_z * d5, z5_x = x4_x * s5 - z3_x * c5, z5_y = x4_y * s5 - z3_y * c5,
        z5_z = x4_z * s5 - z3_z * c5, v4 = q[5] + offset6;
    const double c6 = cos(v4), s6 = sin(v4), z6_x = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6,
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

double kuka_iiwa14_arm_angle_arm_angle(const double q[7])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        p3_x = z2_x * d3, p3_y = z2_y * d3, p3_z = d1 - c2 * d3, z3_x = x2_x * s3 - s1 * c3,
        v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3),
        p5_x = p3_x + ((x2_x * c3 + s1 * s3) * s4 - z2_x * c4) * d5,
        p5_y = p3_y + ((x2_y * c3 - c1 * s3) * s4 - z2_y * c4) * d5, v4 = p3_z - d1,
        v5 = p3_x * z3_x + z3_y * p3_y + z3_z * v4, v6 = p3_x - z3_x * v5, v7 = p3_y - z3_y * v5,
        v8 = v4 - z3_z * v5, v9 = p3_z + (c2 * c4 + s2 * c3 * s4) * d5 - d1,
        v10 = z3_x * (p5_y * v8 - v7 * v9) + z3_y * (v6 * v9 - p5_x * v8) + z3_z * (p5_x * v7 - p5_y
            * v6) < -straight_limit ? -1.0 : 1.0, v11 = z3_x * v10, v12 = z3_y * v10,
        v13 = z3_z * v10, v14 = p5_x * p5_x + p5_y * p5_y, v15 = sqrt(v14 + v9 * v9);
    const int v16 = sqrt(v14) <= v15 * free_limit;
    const double v17 = v16 ? 0.0 : p5_y, v18 = v16 ? 1.0 : -p5_x, v19 = v9 * v12 - p5_y * v13,
        v20 = p5_x * v13 - v9 * v11;
    const double psi = atan2(v15 * (v17 * v19 + v18 * v20), v9 * v18 * v19 - v9 * v17 * v20 + (p5_y
        * v17 - p5_x * v18) * (p5_y * v11 - p5_x * v12));
    return psi;
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

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(
    const wide T[16], const wide free_joints[1], wide q[56], wide_mask kind[8])
{
    ENTRIES(wide);

    /* theta4 */
    const wide wx = T14 - d7 * T13, wy = T24 - d7 * T23, v1 = T34 - d7 * T33 - d1,
        V4 = wx * wx + wy * wy + v1 * v1, D4 = (longest4 - V4) * (V4 - shortest4),
        v2 = k1 * (V4 - k2), v3 = k3 * v2, v4 = k1 * sqrt_wide(D4), v5 = k3 * v4;

    /* shoulder */
    const wide v6 = sqrt_wide(V4) * (1.0 / V4), gx = wx * v6, gy = wy * v6, gz = v1 * v6,
        v7 = gy * gy + gx * gx;
    const wide_mask upright = v7 <= m2;
    const wide v8 = 1.0 / pick_wide(upright, all_wide(1.0), sqrt_wide(v7)),
        v9 = pick_wide(upright, all_wide(0.0), gy * v8),
        v10 = pick_wide(upright, all_wide(1.0), -(gx * v8)), v11 = gz * v10, v12 = gz * v9,
        cos_psi = cos_wide(free_joints[0]), sin_psi = sin_wide(free_joints[0]),
        uz = cos_psi * (gy * v9 - gx * v10), ux = v11 * cos_psi + v9 * sin_psi,
        uy = v10 * sin_psi - v12 * cos_psi, nx = v9 * cos_psi - v11 * sin_psi,
        ny = v10 * cos_psi + v12 * sin_psi, v13 = d5 * v5, v14 = d3 + d5 * v3,
        v15 = v14 * v14 + v13 * v13, arm = sqrt_wide(v15), v16 = 1.0 / v15, v17 = arm * v16,
        v18 = v13 * v17, v19 = v14 * v17, v20 = d5 * (d3 * v5),
        side_p = pick_wide(-v20 < -straight_limit, all_wide(-1.0), all_wide(1.0)),
        side_m = pick_wide(v20 < -straight_limit, all_wide(-1.0), all_wide(1.0)),
        v21 = v19 * side_p, v22 = v19 * side_m, v23 = v18 * side_p, v24 = v18 * side_m,
        v25 = gx * v18, v26 = gy * v18, v27 = gy * v19, b22_p = v27 - uy * v23,
        b22_m = v27 + uy * v24;

    /* theta1 */
    const wide v28 = gx * v19, X1_p = ux * v23 - v28, v29 = v28 + ux * v24,
        v30 = X1_p * X1_p + b22_p * b22_p, v31 = v29 * v29 + b22_m * b22_m, w1_p = sqrt_wide(v30),
        w1_m = sqrt_wide(v31), v32 = 1.0 / v30, v33 = 1.0 / v31;

    /* theta2 */
    const wide v34 = gz * v19, c2_p = uz * v23 - v34, v35 = v34 + uz * v24;

    /* theta3 */
    const wide v36 = v32 * (b22_p * (v25 + ux * v21) + X1_p * (v26 + uy * v21)),
        v37 = v33 * (b22_m * (ux * v22 - v25) - v29 * (uy * v22 - v26)), v38 = w1_p * v36,
        v39 = w1_m * v37, v40 = v32 * (b22_p * (nx * side_p) + X1_p * (ny * side_p)),
        v41 = v33 * (b22_m * (nx * side_m) - v29 * (ny * side_m)), v42 = w1_p * v40,
        v43 = w1_m * v41, angle1 = atan2_wide(-v36, -v40), angle2 = atan2_wide(-v37, -v41),
        q3_pmp = angle1 - signed_wide(half_turn, -v36),
        q3_mmp = angle2 - signed_wide(half_turn, -v37);

    /* theta5 */
    const wide v44 = w1_p * (v32 * (T23 * b22_p - T13 * X1_p)),
        v45 = w1_m * (v33 * (T23 * b22_m + T13 * v29)), v46 = c2_p * v44 + T33 * w1_p,
        v47 = T33 * w1_m - v35 * v45, v48 = w1_p * (v32 * (T13 * b22_p + T23 * X1_p)),
        v49 = w1_m * (v33 * (T13 * b22_m - T23 * v29)), v50 = arm * (v16 * (gz * (T33 * v14))),
        v51 = T33 * v13, v52 = w1_p * v44 - (uz * (arm * (v16 * (side_p * v51))) - v50),
        v53 = w1_m * v45 + (v50 + uz * (arm * (v16 * (side_m * v51)))),
        X5_p = v5 * v52 - (v42 * (v3 * v46) + v38 * (v3 * v48)),
        v54 = v5 * v53 + (v43 * (v3 * v47) + v39 * (v3 * v49)), Y5_p = v42 * v48 - v38 * v46,
        Y5_m = v43 * v49 - v39 * v47, v55 = X5_p * X5_p + Y5_p * Y5_p,
        v56 = v54 * v54 + Y5_m * Y5_m, w5_p = sqrt_wide(v55), w5_m = sqrt_wide(v56),
        factor5_p = w5_p * (1.0 / v55), factor5_m = w5_m * (1.0 / v56), v57 = X5_p * factor5_p,
        v58 = v54 * factor5_m, s5_p = Y5_p * factor5_p, s5_m = Y5_m * factor5_m,
        angle3 = atan2_wide(Y5_p, -X5_p), angle4 = atan2_wide(Y5_m, v54),
        q5_ppm = angle3 - signed_wide(half_turn, Y5_p),
        q5_mpm = angle4 - signed_wide(half_turn, Y5_m);

    /* theta7 */
    const wide v59 = w1_p * (v32 * (b22_p * T12 + X1_p * T22)),
        v60 = w1_m * (v33 * (b22_m * T12 - v29 * T22)),
        v61 = w1_p * (v32 * (b22_p * T22 - X1_p * T12)),
        v62 = w1_m * (v33 * (b22_m * T22 + v29 * T12)), v63 = c2_p * v61 + w1_p * T32,
        v64 = w1_m * T32 - v35 * v62, v65 = arm * (v16 * (gz * (v14 * T32))),
        v66 = w1_p * (v32 * (b22_p * T11 + X1_p * T21)),
        v67 = w1_m * (v33 * (b22_m * T11 - v29 * T21)),
        v68 = w1_p * (v32 * (b22_p * T21 - X1_p * T11)),
        v69 = w1_m * (v33 * (b22_m * T21 + v29 * T11)), v70 = c2_p * v68 + w1_p * T31,
        v71 = w1_m * T31 - v35 * v69, v72 = arm * (v16 * (gz * (v14 * T31))), v73 = v13 * T31,
        v74 = v57 * (v42 * v66 - v38 * v70) - s5_p * (v5 * (w1_p * v68 - (uz * (arm * (v16 * (side_p
            * v73))) - v72)) - (v42 * (v3 * v70) + v38 * (v3 * v66))),
        v75 = s5_m * (v5 * (w1_m * v69 + (v72 + uz * (arm * (v16 * (side_m * v73))))) + (v43 * (v3 *
            v71) + v39 * (v3 * v67))) - v58 * (v43 * v67 - v39 * v71), v76 = v13 * T32,
        angle5 = atan2_wide(v74, v57 * (v42 * v59 - v38 * v63) - s5_p * (v5 * (w1_p * v61 - (uz *
            (arm * (v16 * (side_p * v76))) - v65)) - (v42 * (v3 * v63) + v38 * (v3 * v59)))),
        angle6 = atan2_wide(v75, s5_m * (v5 * (w1_m * v62 + (v65 + uz * (arm * (v16 * (side_m *
            v76))))) + (v43 * (v3 * v64) + v39 * (v3 * v60))) - v58 * (v43 * v60 - v39 * v64)),
        q7_ppm = angle5 - signed_wide(half_turn, v74),
        q7_mpm = angle6 - signed_wide(half_turn, v75);

    /* joint values */
    const wide angle7 = atan2_wide(b22_p, -X1_p), angle8 = atan2_wide(b22_m, v29),
        v77 = angle7 - offset1, v78 = angle7 - signed_wide(half_turn, b22_p) - offset1,
        v79 = angle8 - offset1, v80 = angle8 - signed_wide(half_turn, b22_m) - offset1,
        q1_ppp = raised_wide(v77), q1_pmp = raised_wide(v78), q1_mpp = raised_wide(v79),
        q1_mmp = raised_wide(v80), angle9 = atan2_wide(w1_p, c2_p),
        angle10 = atan2_wide(w1_m, -v35), v81 = angle9 - offset2, v82 = offset2 + angle9,
        v83 = angle10 - offset2, v84 = offset2 + angle10, q2_ppp = raised_wide(v81),
        q2_pmp = only_wide(-v82 <= -half_turn, turn) - v82, q2_mpp = raised_wide(v83),
        q2_mmp = only_wide(-v84 <= -half_turn, turn) - v84, angle11 = atan2_wide(-v4, -v2),
        v85 = angle11 - offset4, v86 = offset4 + angle11, q4_ppp = raised_wide(v85),
        q4_mpp = only_wide(-v86 <= -half_turn, turn) - v86,
        angle12 = atan2_wide(w5_p, -(v3 * v52 + (v42 * (v5 * v46) + v38 * (v5 * v48)))),
        angle13 = atan2_wide(w5_m, v43 * (v5 * v47) + v39 * (v5 * v49) - v3 * v53),
        v87 = angle12 - offset6, v88 = offset6 + angle12, v89 = angle13 - offset6,
        v90 = offset6 + angle13, q6_ppp = raised_wide(v87),
        q6_ppm = only_wide(-v88 <= -half_turn, turn) - v88, q6_mpp = raised_wide(v89),
        q6_mpm = only_wide(-v90 <= -half_turn, turn) - v90, v91 = exceeds(q4_ppp, 4),
        v92 = exceeds(q4_mpp, 4), v93 = exceeds(angle3, 5), v94 = exceeds(q5_ppm, 5),
        v95 = exceeds(angle4, 5), v96 = exceeds(q5_mpm, 5), v97 = exceeds(q6_ppp, 6),
        v98 = exceeds(q6_ppm, 6), v99 = exceeds(q6_mpp, 6), v100 = exceeds(q6_mpm, 6),
        v101 = exceeds(angle5, 7), v102 = exceeds(q7_ppm, 7), v103 = exceeds(angle6, 7),
        v104 = exceeds(q7_mpm, 7),
        v105 = maximum_wide(exceeds(angle1, 3), maximum_wide(exceeds(q2_ppp, 2), maximum_wide(v91,
            exceeds(q1_ppp, 1)))),
        v106 = maximum_wide(exceeds(q3_pmp, 3), maximum_wide(exceeds(q2_pmp, 2), maximum_wide(v91,
            exceeds(q1_pmp, 1)))),
        v107 = maximum_wide(exceeds(angle2, 3), maximum_wide(exceeds(q2_mpp, 2), maximum_wide(v92,
            exceeds(q1_mpp, 1)))),
        v108 = maximum_wide(exceeds(q3_mmp, 3), maximum_wide(exceeds(q2_mmp, 2), maximum_wide(v92,
            exceeds(q1_mmp, 1))));

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = angle1; q[3] = q4_ppp; q[4] = angle3; q[5] = q6_ppp;
    q[6] = angle5;
    kind[0] = kind_of(q[0], 0.0 < maximum_wide(v101, maximum_wide(v97, maximum_wide(v93, v105))));
    q[7] = q1_ppp; q[8] = q2_ppp; q[9] = angle1; q[10] = q4_ppp; q[11] = q5_ppm; q[12] = q6_ppm;
    q[13] = q7_ppm;
    kind[1] = kind_of(q[7], 0.0 < maximum_wide(v102, maximum_wide(v98, maximum_wide(v94, v105))));
    q[14] = q1_pmp; q[15] = q2_pmp; q[16] = q3_pmp; q[17] = q4_ppp; q[18] = angle3; q[19] = q6_ppp;
    q[20] = angle5;
    kind[2] = kind_of(q[14], 0.0 < maximum_wide(v101, maximum_wide(v97, maximum_wide(v93, v106))));
    q[21] = q1_pmp; q[22] = q2_pmp; q[23] = q3_pmp; q[24] = q4_ppp; q[25] = q5_ppm; q[26] = q6_ppm;
    q[27] = q7_ppm;
    kind[3] = kind_of(q[21], 0.0 < maximum_wide(v102, maximum_wide(v98, maximum_wide(v94, v106))));
    q[28] = q1_mpp; q[29] = q2_mpp; q[30] = angle2; q[31] = q4_mpp; q[32] = angle4; q[33] = q6_mpp;
    q[34] = angle6;
    kind[4] = kind_of(q[28], 0.0 < maximum_wide(v103, maximum_wide(v99, maximum_wide(v95, v107))));
    q[35] = q1_mpp; q[36] = q2_mpp; q[37] = angle2; q[38] = q4_mpp; q[39] = q5_mpm; q[40] = q6_mpm;
    q[41] = q7_mpm;
    kind[5] = kind_of(q[35], 0.0 < maximum_wide(v104, maximum_wide(v100, maximum_wide(v96, v107))));
    q[42] = q1_mmp; q[43] = q2_mmp; q[44] = q3_mmp; q[45] = q4_mpp; q[46] = angle4; q[47] = q6_mpp;
    q[48] = angle6;
    kind[6] = kind_of(q[42], 0.0 < maximum_wide(v103, maximum_wide(v99, maximum_wide(v95, v108))));
    q[49] = q1_mmp; q[50] = q2_mmp; q[51] = q3_mmp; q[52] = q4_mpp; q[53] = q5_mpm; q[54] = q6_mpm;
    q[55] = q7_mpm;
    kind[7] = kind_of(q[49], 0.0 < maximum_wide(v104, maximum_wide(v100, maximum_wide(v96, v108))));
    const wide_mask exact = irregularity_wide(T, free_joints) <= 1e-24;
    return (exact == 0) | ((v56 <= m3) | (v31 <= m3) | (v55 <= m3) | (abs_wide(D4) <= m1) | (v30 <=
        m3));
}

#if LANES > 1
static const double
    m4 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(
    const double T[16], const double free_joints[1], double q[8][7], unsigned char status[8])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta4 */
    const double wx = T14 - d7 * T13, wy = T24 - d7 * T23, v1 = T34 - d7 * T33 - d1,
        V4 = wx * wx + wy * wy + v1 * v1, D4 = (longest4 - V4) * (V4 - shortest4),
        v2 = k1 * (V4 - k2), v3 = k3 * v2, v4 = k1 * sqrt(D4), v5 = k3 * v4;

    /* shoulder */
    const double v6 = sqrt(V4) * (1.0 / V4), gx = wx * v6, gy = wy * v6, gz = v1 * v6,
        v7 = gy * gy + gx * gx;
    const int upright = v7 <= m2;
    const double v8 = 1.0 / (upright ? 1.0 : sqrt(v7)), v9 = upright ? 0.0 : (gy * v8),
        v10 = upright ? 1.0 : (-(gx * v8)), v11 = gz * v10, v12 = gz * v9,
        cos_psi = cos(free_joints[0]), sin_psi = sin(free_joints[0]),
        uz = cos_psi * (gy * v9 - gx * v10), ux = v11 * cos_psi + v9 * sin_psi,
        uy = v10 * sin_psi - v12 * cos_psi, nx = v9 * cos_psi - v11 * sin_psi,
        ny = v10 * cos_psi + v12 * sin_psi, v13 = d5 * v5, v14 = d3 + d5 * v3,
        v15 = v14 * v14 + v13 * v13, arm = sqrt(v15), v16 = 1.0 / v15, v17 = arm * v16,
        v18 = v13 * v17, v19 = v14 * v17, v20 = d5 * (d3 * v5);
    const four side = pick_four(-(e1 * v20) < -straight_limit, all_four(-1.0), all_four(1.0)),
        v21 = v19 * side, v22 = v18 * side;
    const double v23 = gx * v18, v24 = gy * v18, v25 = gy * v19;
    const four b22 = v25 - e1 * (uy * v22);

    /* theta1 */
    const double v26 = gx * v19;
    const four X1 = e1 * (ux * v22) - v26, v27 = X1 * X1 + b22 * b22, w1 = sqrt_four(v27),
        v28 = 1.0 / v27;

    /* theta2 */
    const double v29 = gz * v19;
    const four c2 = e1 * (uz * v22) - v29;

    /* theta3 */
    const four v30 = v28 * (b22 * (ux * v21 + e1 * v23) + X1 * (uy * v21 + e1 * v24)),
        v31 = w1 * v30, v32 = v28 * (b22 * (nx * side) + X1 * (ny * side)), v33 = w1 * v32,
        v34 = signed_four(half_turn, -v30), v35 = m4 * (e2 - 1.0);

    /* theta5 */
    const four v36 = w1 * (v28 * (T23 * b22 - T13 * X1)), v37 = c2 * v36 + T33 * w1,
        v38 = w1 * (v28 * (T13 * b22 + T23 * X1));
    const double v39 = arm * (v16 * (gz * (T33 * v14)));
    const four v40 = w1 * v36 - (uz * (arm * (v16 * (side * (v13 * (e1 * T33))))) - v39),
        X5 = e1 * (v5 * v40) - (v33 * (v3 * v37) + v31 * (v3 * v38)), Y5 = v33 * v38 - v31 * v37,
        v41 = X5 * X5 + Y5 * Y5, w5 = sqrt_four(v41), factor5 = w5 * (1.0 / v41),
        v42 = X5 * factor5, s5 = Y5 * factor5;

    /* theta7 */
    const four v43 = w1 * (v28 * (b22 * T12 + X1 * T22)), v44 = w1 * (v28 * (b22 * T22 - X1 * T12)),
        v45 = c2 * v44 + w1 * T32;
    const double v46 = arm * (v16 * (gz * (v14 * T32)));
    const four v47 = w1 * (v28 * (b22 * T11 + X1 * T21)), v48 = w1 * (v28 * (b22 * T21 - X1 * T11)),
        v49 = c2 * v48 + w1 * T31;
    const double v50 = arm * (v16 * (gz * (v14 * T31)));
    const four v51 = v42 * (v33 * v47 - v31 * v49) - s5 * (e1 * (v5 * (w1 * v48 - (uz * (arm * (v16
        * (side * (v13 * (e1 * T31))))) - v50))) - (v33 * (v3 * v49) + v31 * (v3 * v47)));

    /* joint values */
    const four v52 = signed_four(half_turn, b22);

    if (bits_four(((irregularity_four(T, free_joints) <= 1e-24) == 0) | ((v27 <= m3) | (v41 <= m3)))
        | (unsigned)(fabs(D4) <= m1))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ -v4, -v4, -v4, -v4 }, (four){ -v2, -v2, -v2, -v2
        }), ratio2 = ratio_four(shuffle(-v30, Y5, 0, 5, 2, 7), shuffle(-v32, -X5, 0, 5, 2, 7)),
        ratio3 = ratio_four(shuffle(w1, w5, 0, 5, 2, 7), shuffle(c2, -(v3 * v40 + e1 * (v33 * (v5 *
            v37) + v31 * (v5 * v38))), 0, 5, 2, 7)),
        ratio4 = ratio_four(shuffle(v51, b22, 0, 5, 2, 7), shuffle(v42 * (v33 * v43 - v31 * v45) -
            s5 * (e1 * (v5 * (w1 * v44 - (uz * (arm * (v16 * (side * (v13 * (e1 * T32))))) - v46)))
            - (v33 * (v3 * v45) + v31 * (v3 * v43))), -X1, 0, 5, 2, 7));
    const four packed1 = angle_four(ratio1), angle6 = shuffle(packed1, packed1, 0, 0, 0, 0),
        packed2 = angle_four(ratio2), angle1 = shuffle(packed2, packed2, 0, 0, 2, 2),
        angle2 = shuffle(packed2, packed2, 1, 1, 3, 3), packed3 = angle_four(ratio3),
        angle5 = shuffle(packed3, packed3, 0, 0, 2, 2),
        angle7 = shuffle(packed3, packed3, 1, 1, 3, 3), packed4 = angle_four(ratio4),
        angle3 = shuffle(packed4, packed4, 0, 0, 2, 2),
        angle4 = shuffle(packed4, packed4, 1, 1, 3, 3);
    const four q3_p = angle1 + v34 * v35, q5_m = angle2 - signed_four(half_turn, Y5),
        q7_m = angle3 - signed_four(half_turn, v51), v53 = angle4 + v35 * v52 - offset1,
        q1_p = raised_four(v53), v54 = e2 * angle5 - offset2, q2_p = raised_four(v54),
        v55 = e1 * angle6 - offset4, q4_p = raised_four(v55), v56 = angle7 - offset6,
        v57 = offset6 + angle7, q6_p = raised_four(v56),
        q6_m = only_four(-v57 <= -half_turn, turn) - v57, v58 = exceeds_four(q4_p, 4),
        v59 = exceeds_four(angle2, 5), v60 = exceeds_four(q5_m, 5), v61 = exceeds_four(q6_p, 6),
        v62 = exceeds_four(q6_m, 6), v63 = exceeds_four(angle3, 7), v64 = exceeds_four(q7_m, 7),
        v65 = maximum_four(exceeds_four(q3_p, 3), maximum_four(exceeds_four(q2_p, 2),
            maximum_four(v58, exceeds_four(q1_p, 1))));
    const four_mask outside_p = 0.0 < maximum_four(v63, maximum_four(v61, maximum_four(v59, v65))),
        outside_m = 0.0 < maximum_four(v64, maximum_four(v62, maximum_four(v60, v65)));

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, q2_p, q3_p, q4_p);
    store_4(&q[0][3], &q[2][3], &q[4][3], &q[6][3], q4_p, angle2, q6_p, angle3);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, q2_p, q3_p, q4_p);
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

    /* theta4, type 2: the squared length of column 4 of U1 A7^-1 */
    const double wx = T14 - T13 * d7;
    const double wy = T24 - d7 * T23;
    const double wz = T34 - d7 * T33;
    const double v1 = wz - d1;
    const double V4 = wx * wx + wy * wy + v1 * v1;
    const double Z4 = V4 - k2;
    const double D4 = (longest4 - V4) * (V4 - shortest4);
    const int apart4 = shortest4_apart < V4 && V4 < longest4_apart;
    if (!(shortest4_reach <= V4 && V4 <= longest4_reach)) return; /* out of reach */
    const double w4 = sqrt(apart4 ? D4 : 0.0);
    const double v2 = k3 * (k1 * Z4);

    /* shoulder, its rotation, from the arm angle and theta4 */
    const double reach = sqrt(V4);
    const double v4 = 1.0 / reach;
    const double gx = wx * v4;
    const double gy = wy * v4;
    const double gz = v1 * v4;
    const double lean = sqrt(gy * gy + gx * gx);
    const int upright = lean <= free_limit;
    const double v5 = 1.0 / (upright ? 1.0 : lean), v6 = upright ? 0.0 : gy * v5,
        v7 = upright ? 1.0 : -(gx * v5), v8 = gz * v7, v9 = gz * v6;
    const double cos_psi = cos(free_joints[0]);
    const double sin_psi = sin(free_joints[0]);
    const double uz = (gy * v6 - gx * v7) * cos_psi;
    const double ux = v8 * cos_psi + v6 * sin_psi;
    const double uy = v7 * sin_psi - v9 * cos_psi;
    const double nx = v6 * cos_psi - v8 * sin_psi;
    const double ny = v7 * cos_psi + v9 * sin_psi;
    const double v11 = d3 + d5 * v2, v12 = v11 * v11;

    /* theta1, type 2: B1[3, 2] */
    const double v20 = seed[0] + offset1;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip4, flip4 */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e1 < 0.0 && !apart4) continue; /* both signs give the same */
        const double v3 = k3 * (k1 * (w4 * e1));

        /* shoulder */
        const double v10 = d5 * v3;
        const double arm = sqrt(v10 * v10 + v12);
        const double v13 = 1.0 / arm, v14 = v10 * v13, v15 = v11 * v13;
        const double side = -(d5 * (d3 * v3)) < -straight_limit ? -1.0 : 1.0;
        const double v16 = v15 * side, v17 = v14 * side, v18 = gx * v14 + ux * v16;
        const double b13 = nx * side;
        const double v19 = gy * v14 + uy * v16;
        const double b22 = gy * v15 - uy * v17;
        const double b23 = ny * side;

        /* theta1 */
        const double X1 = ux * v17 - gx * v15;
        const double w1 = sqrt(X1 * X1 + b22 * b22);
        const int free1 = w1 <= free_limit;
        const double divisor1 = free1 ? 1.0 : w1;

        /* theta2, type 3: B1[2, 2] and B1[1, 2] */
        const double c2 = uz * v17 - gz * v15;

        /* theta5, type 2: U5[3, 3] */
        const double v24 = T33 * c2;

        /* theta7, type 3: U5[3, 2] and U5[3, 1] */
        const double v30 = T32 * c2, v36 = T31 * c2;

        /* joint values */
        const double q4 = wrap(atan2(-v3, -v2) - offset4);

        for (int i2 = 0; i2 < 2; i2++) { /* left, right */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta1 */
            if (e2 < 0.0 && free1) continue; /* both signs give the same */
            const double factor1 = e2 / divisor1;
            const double c1 = free1 ? cos(v20) : -(X1 * factor1),
                s1 = free1 ? sin(v20) : b22 * factor1;
            const double s2 = w1 * e2;

            /* theta3, type 3: B1[3, 1] and B1[3, 3] */
            const double s3 = v19 * c1 - v18 * s1, c3 = b23 * c1 - b13 * s1;
            const double q3 = atan2(s3, c3);

            /* theta5 */
            const double v21 = T13 * c1 + T23 * s1, v22 = c2 * v21 + T33 * s2,
                v23 = T13 * s1 - T23 * c1, v25 = s2 * v21 - v24;
            const double X5 = c3 * (v2 * v22) + s3 * (v2 * v23) + v3 * v25;
            const double Y5 = c3 * -v23 + s3 * v22;
            const double w5 = sqrt(X5 * X5 + Y5 * Y5);
            const int free5 = w5 <= free_limit;
            const double divisor5 = free5 ? 1.0 : w5;

            /* theta6, type 3: U5[2, 3] and U5[1, 3] */
            const double c6 = c3 * (v3 * v22) + s3 * (v3 * v23) - v2 * v25;

            /* theta7 */
            const double v26 = T12 * s1 - T22 * c1, v27 = T12 * c1 + T22 * s1,
                v28 = c2 * v27 + T32 * s2, v29 = c3 * -v26 + s3 * v28,
                v31 = c3 * (v2 * v28) + s3 * (v2 * v26) + v3 * (s2 * v27 - v30),
                v32 = T11 * s1 - T21 * c1, v33 = T11 * c1 + T21 * s1, v34 = c2 * v33 + T31 * s2,
                v35 = c3 * -v32 + s3 * v34,
                v37 = c3 * (v2 * v34) + s3 * (v2 * v32) + v3 * (s2 * v33 - v36);

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
                const double q7 = atan2(-(c5 * v35 + s5 * v37), -(c5 * v29 + s5 * v31));

                /* joint values */
                const double q6 = wrap(atan2(s6, c6) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6; q[row][6] = q7;
                status[row] = (free1 || free5) ? FREE : OK;
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
    static const int choosable[2] = { 4, 0 };
    struct search search = { .T = T, .row = row, .free_joints = free_joints };
    for (int i = 0; i < 7; i++)
        search.seed[i] = seed[i] - overshoot(i, seed[i]);
    for (int k = 0; k < 2; k++) {
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
    for (int row = 0; row < 8; row++) {
        if (status[row] == NONE)
            continue;
        for (int i = 0; i < 7; i++) {
            double *value = &q[row][i];
            if (!(lowest[i] <= *value && *value <= highest[i]))
                *value = turned(i, *value, *value);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int kuka_iiwa14_arm_angle_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[8][7],
    unsigned char status[8])
{
    const int count = solve_regular(T, free_joints, q, status);
    return count < 0 ? ik_carefully(T, free_joints, q_seed, q, status) : count;
}

int kuka_iiwa14_arm_angle_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    double all[8][7], found[7], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = kuka_iiwa14_arm_angle_ik(T, free_joints, q_seed, all, status) >= 0;
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

void kuka_iiwa14_arm_angle_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, free_joints + k, q + 56 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)kuka_iiwa14_arm_angle_ik(
                    T + 16 * i, free_joints + i, NULL, (double (*)[7])(q + 56 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)kuka_iiwa14_arm_angle_ik(
            T + 16 * k, free_joints + k, NULL, (double (*)[7])(q + 56 * k), status + 8 * k);
}
