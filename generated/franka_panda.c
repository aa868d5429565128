/* franka_panda: Franka Emika Panda
 *
 * Inverse kinematics, generated from robots/franka_panda.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/franka_panda.yaml. The formulas and where they come from:
 * franka_panda.md.
 */
#include "franka_panda.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = FRANKA_PANDA_OK, NONE = FRANKA_PANDA_UNREACHABLE, FREE = FRANKA_PANDA_FREE_JOINT,
    OUT = FRANKA_PANDA_OUT_OF_LIMITS, INVALID = FRANKA_PANDA_INVALID_POSE
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
#if defined(__clang__)
#define UNROLLED _Pragma("unroll")
#elif defined(__GNUC__) && __GNUC__ >= 8
#define UNROLLED _Pragma("GCC unroll 2")
#else
#define UNROLLED
#endif

#define maximum_double(a, b) ((a) > (b) ? (a) : (b))
#define minimum_double(a, b) ((a) < (b) ? (a) : (b))

#ifndef FRANKA_PANDA_LIBM
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
 * -DFRANKA_PANDA_SCALAR. With -DFRANKA_PANDA_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(FRANKA_PANDA_SCALAR) && !defined(FRANKA_PANDA_LIBM)
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
#ifdef FRANKA_PANDA_LIBM /* half the time of atan2 */
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

#define low(joint) (lowest[joint - 1] - slack(joint - 1))
#define high(joint) (highest[joint - 1] + slack(joint - 1))
/* How far a joint is beyond its limits; whether by rounding, perhaps. */
#define grazes(x) (abs_wide((x) - 5e-07) <= 5e-07)
#define grazes_four(x) (abs_four((x) - 5e-07) <= 5e-07)
#define beyond(x, joint) maximum_wide(low(joint) - (x), (x) - high(joint))
#define beyond_four(x, joint) maximum_four(low(joint) - (x), (x) - high(joint))
#define exceeds(x, joint) (abs_wide(x) - high(joint))
#define exceeds_four(x, joint) (abs_four(x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.333, /* joint offset 1 [m] */
    d3 = 0.316, /* joint offset 3 [m] */
    a3 = 0.0825, /* link length 4 [m] */
    d5 = 0.384, /* joint offset 5 [m] */
    a4 = 0.0825, /* link length 5 [m] */
    a6 = 0.088, /* link length 7 [m] */
    d7 = 0.107, /* z of the tool frame [m] */
    reach_slack2 = 1.9404490000000003e-13, /* rounding at the boundary of the workspace [m^2] */
    merge_slack2 = 1.940449e-14, /* nearer to that boundary two branches are one [m^2] */
    least_root2 = 6.136238523396071e-07, /* a root of nothing, by rounding [m^2] */
    free_limit_squared2 = 1.940449e-24, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 1.393e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 1.393e-14, /* nearer to that boundary two branches are one [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.1155, /* 2 * (d3 * a4 + d5 * a3) [m^2] */
    k2 = 0.22907550000000002, /* 2 * (d3 * d5 - a4 * a3) [m^2] */
    k3 = 0.06581583470025, /* k1^2 + k2^2 [m^4] */
    k4 = 0.25318050000000003, /* d3^2 + (a4 * a3 + (d5^2 + (a4 * a3 - a6^2))) [m^2] */
    k5 = 0.515344644461153, /* 1 / arm_size2 [m^-2] */
    k6 = 15.193911990243306, /* 1 / k3 [m^-4] */
    doubt_limit_squared2 = 1.940449e-08, /* square of a length that fixes no angle [m^2] */
    turn1 = 0.46700242365301164, /* a constant angle [rad] */
    m1 = 1.940449e-11, /* 1000 * merge_slack2 [m^2] */
    m7 = 1.393e-11, /* 1000 * merge_slack1 [m] */
    m8 = 0.5, /* 1 / 2 */
    m10 = 3.765342321601e-16, /* doubt_limit_squared2^2 [m^4] */
    m11 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m2 = 1.754896834873102, m3 = 3.4805529861209807, m4 = 1.2446337324912609,
m5 = 0.0825, m6 = 0.2674017784649193, m9 = 0.384;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const franka_panda_branches[8] = {
    "noflip4-noflip5-noflip3", "noflip4-noflip5-flip3", "noflip4-flip5-noflip3",
    "noflip4-flip5-flip3", "flip4-noflip5-noflip3", "flip4-noflip5-flip3", "flip4-flip5-noflip3",
    "flip4-flip5-flip3",
};

static const double lowest[7] = { -2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973 };
static const double highest[7] = { 2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973 };
#define slack(joint) 1e-09 /* of limits */

/* What follows from joint values: what the pose and the Jacobian are made of. */
#define MOTION \
    const double c1 = cos(q[0]), s1 = sin(q[0]), c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, \
        x2_y = s1 * c2, z3_x = c1 * s2, z3_y = s1 * s2, c3 = cos(q[2]), s3 = sin(q[2]), \
        x3_x = x2_x * c3 - s1 * s3, x3_y = x2_y * c3 + c1 * s3, v1 = s2 * c3, \
        z4_x = s1 * c3 + x2_x * s3, y3_y = c1 * c3 - x2_y * s3, y3_z = s2 * s3, c4 = cos(q[3]), \
        s4 = sin(q[3]), x4_x = x3_x * c4 + z3_x * s4, x4_y = x3_y * c4 + z3_y * s4, \
        x4_z = c2 * s4 - v1 * c4, y4_x = z3_x * c4 - x3_x * s4, y4_y = z3_y * c4 - x3_y * s4, \
        y4_z = c2 * c4 + v1 * s4, c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - z4_x * s5, \
        x5_y = x4_y * c5 + y3_y * s5, x5_z = x4_z * c5 + y3_z * s5, z6_x = z4_x * c5 + x4_x * s5, \
        z6_y = x4_y * s5 - y3_y * c5, z6_z = x4_z * s5 - y3_z * c5, c6 = cos(q[5]), \
        s6 = sin(q[5]), z7_x = x5_x * s6 - y4_x * c6, z7_y = x5_y * s6 - y4_y * c6, \
        z7_z = x5_z * s6 - y4_z * c6

void franka_panda_fk(const double q[7], double T[16])
{
    MOTION;
    const double x6_x = x5_x * c6 + y4_x * s6, x6_y = x5_y * c6 + y4_y * s6,
        x6_z = x5_z * c6 + y4_z * s6;
    const double c7 = cos(q[6]), s7 = sin(q[6]);
    T[0] = x6_x * c7 + z6_x * s7; T[1] = z6_x * c7 - x6_x * s7; T[2] = z7_x;
    T[3] = z3_x * d3 + x3_x * a3 - x4_x * a4 + y4_x * d5 + x6_x * a6 + z7_x * d7;
    T[4] = x6_y * c7 + z6_y * s7; T[5] = z6_y * c7 - x6_y * s7; T[6] = z7_y;
    T[7] = z3_y * d3 + x3_y * a3 - x4_y * a4 + y4_y * d5 + x6_y * a6 + z7_y * d7;
    T[8] = x6_z * c7 + z6_z * s7; T[9] = z6_z * c7 - x6_z * s7; T[10] = z7_z;
    T[11] = d1 + c2 * d3 - v1 * a3 - x4_z * a4 + y4_z * d5 + x6_z * a6 + z7_z * d7;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void franka_panda_jacobian(const double q[7], double J[42])
{
    MOTION;
    const double p3_x = z3_x * d3, p3_y = z3_y * d3, p3_z = d1 + c2 * d3, p4_x = p3_x + x3_x * a3,
        p4_y = p3_y + x3_y * a3, p4_z = p3_z - v1 * a3, p5_x = p4_x - x4_x * a4 + y4_x * d5,
        p5_y = p4_y - x4_y * a4 + y4_y * d5, p5_z = p4_z - x4_z * a4 + y4_z * d5,
        p7_x = p5_x + (x5_x * c6 + y4_x * s6) * a6, p7_y = p5_y + (x5_y * c6 + y4_y * s6) * a6,
        p7_z = p5_z + (x5_z * c6 + y4_z * s6) * a6, J21 = p7_x + z7_x * d7, v2 = p7_y + z7_y * d7,
        v3 = p7_z + z7_z * d7, v4 = v3 - d1, v5 = J21 - p3_x, v6 = v2 - p3_y, v7 = v3 - p3_z,
        v8 = J21 - p4_x, v9 = v2 - p4_y, v10 = v3 - p4_z, v11 = J21 - p5_x, v12 = v2 - p5_y,
        v13 = v3 - p5_z, v14 = J21 - p7_x, v15 = v2 - p7_y, v16 = v3 - p7_z;
    J[0] = -v2; J[1] = c1 * v4; J[2] = z3_y * v7 - c2 * v6; J[3] = -y3_y * v10 + y3_z * v9;
    J[4] = y4_y * v13 - y4_z * v12; J[5] = z6_y * v13 - z6_z * v12; J[6] = z7_y * v16 - z7_z * v15;
    J[7] = J21; J[8] = s1 * v4; J[9] = c2 * v5 - z3_x * v7; J[10] = -(y3_z * v8 + z4_x * v10);
    J[11] = y4_z * v11 - y4_x * v13; J[12] = z6_z * v11 - z6_x * v13;
    J[13] = z7_z * v14 - z7_x * v16;
    J[14] = 0.0; J[15] = -(s1 * v2 + c1 * J21); J[16] = z3_x * v6 - z3_y * v5;
    J[17] = z4_x * v9 - -y3_y * v8; J[18] = y4_x * v12 - y4_y * v11;
    J[19] = z6_x * v12 - z6_y * v11; J[20] = z7_x * v15 - z7_y * v14;
    J[21] = 0.0; J[22] = -s1; J[23] = z3_x; J[24] = z4_x; J[25] = y4_x; J[26] = z6_x; J[27] = z7_x;
    J[28] = 0.0; J[29] = c1; J[30] = z3_y; J[31] = -y3_y; J[32] = y4_y; J[33] = z6_y; J[34] = z7_y;
    J[35] = 1.0; J[36] = 0.0; J[37] = c2; J[38] = -y3_z; J[39] = y4_z; J[40] = z6_z; J[41] = z7_z;
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
#define abs_double fabs
#define sin_double sin
#define cos_double cos

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    const number c7 = cos_##number(free_joints[0]), s7 = sin_##number(free_joints[0]); \
    /* theta4 */ \
    const number v1 = d7 * T13 - T14, v2 = d7 * T23 - T24, v3 = d1 - (T34 - d7 * T33), \
        w2x = v1 * T11 + v2 * T21 + v3 * T31, w2y = v1 * T12 + v2 * T22 + v3 * T32, \
        w2z = T13 * v1 + T23 * v2 + T33 * v3, \
        Z4 = c7 * (2.0 * (a6 * w2x)) - s7 * (2.0 * (a6 * w2y)) + (w2x * w2x + (w2y * w2y + (w2z * \
            w2z - k4))), D4 = k3 - Z4 * Z4, w4 = sqrt_##number(D4), v4 = k5 * w4, v5 = m3 * Z4, \
        v6 = m2 * Z4; \
    /* theta5 */ \
    const number v8 = m5 + m6 * Z4, Z5 = c7 * w2y + s7 * w2x, v10 = Z5 * Z5, \
        v12 = m7 * (merge_slack1 + 2.0 * abs_##number(Z5)); \
    /* theta6 */ \
    const number v18 = m9 + m4 * Z4, Z2_6 = a6 + (c7 * w2x - s7 * w2y); \
    /* theta3 */ \
    const number v25 = c7 * T31 - s7 * T32, v30 = c7 * T32 + s7 * T31; \
    /* theta1 */ \
    const number v42 = c7 * T11 - s7 * T12, v45 = c7 * T12 + s7 * T11, v52 = c7 * T21 - s7 * T22, \
        v55 = c7 * T22 + s7 * T21; \
    /* joint values */ \
    const number v68 = free_joints[0] + (w4 - w4)
#define SIGNED(number, signs) \
    /* theta4 */ \
    const number c4 = v5 + w4 * (m2 * e1), s4 = w4 * (m3 * e1) - v6; \
    /* theta5 */ \
    const number v7 = a3 * c4 + d3 * s4 - a4, v9 = v8 - w4 * (m4 * e1), N5 = v9 * v9, \
        D5 = N5 - v10, w5 = sqrt_##number(D5), v11 = w5 - w5, inverse5 = 1.0 / N5, v13 = v9 * w5, \
        v14 = inverse5 * v13, v15 = v9 * Z5, s5 = inverse5 * v15, \
        v16 = signed_##number(half_turn, v15); \
    /* theta6 */ \
    const number Y1_6 = v18 + w4 * (m6 * e1), v19 = Y1_6 * Z2_6, v22 = w2z * Y1_6; \
    /* theta3 */ \
    const number v26 = c4 * v25, v27 = T33 * s4, v28 = T33 * c4, v29 = s4 * v25, \
        v31 = s5 * (c4 * v30), v32 = v14 * v26, v33 = v14 * v28, v34 = s5 * v25, v35 = T33 * s5, \
        v36 = v14 * v30; \
    /* theta2 */ \
    const number v39 = s5 * (s4 * v30), v40 = v14 * v29, v41 = v14 * v27; \
    /* theta1 */ \
    const number v43 = s5 * v42, v44 = T13 * s5, v46 = v14 * v45, v47 = T13 * s4, v48 = s4 * v42, \
        v49 = s5 * (c4 * v45), v50 = v14 * (c4 * v42), v51 = v14 * (T13 * c4), v53 = s5 * v52, \
        v54 = T23 * s5, v56 = v14 * v55, v57 = T23 * s4, v58 = s4 * v52, v59 = s5 * (c4 * v55), \
        v60 = v14 * (c4 * v52), v61 = v14 * (T23 * c4); \
    /* joint values */ \
    const number q7_p = v11 + v68
#define SIGNED_TWICE(number, signs) \
    /* theta5 */ \
    const signs v17 = m8 * (1.0 - e2); \
    /* theta6 */ \
    const number v20 = e2 * w2z, v21 = v19 - w5 * (inverse5 * (v7 * (v9 * v20))), v23 = e2 * Z2_6, \
        C6 = v22 + w5 * (inverse5 * (v7 * (v9 * v23))), v24 = v21 * v21 + C6 * C6, \
        factor6 = sqrt_##number(v24) * (1.0 / v24); \
    /* theta3 */ \
    const number c3 = v31 + factor6 * (C6 * (v27 - e2 * v32) + v21 * (v29 + e2 * v33)), \
        v37 = e2 * v36 + factor6 * (C6 * v34 - v21 * v35), v38 = c3 * c3 + v37 * v37; \
    /* theta1 */ \
    const number s1 = v37 * (v49 + factor6 * (C6 * (v47 - e2 * v50) + v21 * (v48 + e2 * v51))) - \
        c3 * (e2 * v46 + factor6 * (C6 * v43 - v21 * v44))

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(
    const wide T[16], const wide free_joints[1], wide q[56], wide_mask kind[8])
{
    ENTRIES(wide);
    wide_mask left = (irregularity_wide(T, free_joints) <= 1e-24) == 0;
    KNOWN(wide);

    /* theta4 */
    const wide angle1 = atan2_wide(w4, Z4);
    left |= (abs_wide(D4) <= m1 * (merge_slack2 + 2.0 * abs_wide(Z4))) | (0.0 <
        exceeds(free_joints[0], 7));

    UNROLLED for (int i1 = 0; i1 < 2; i1++) { /* noflip4, flip4 */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* theta4 */
        const wide q4_ = e1 * angle1 - turn1;

        /* theta5 */
        const wide angle2 = atan2_wide(v15, -v13);

        /* joint values */
        const wide v62 = raised_wide(q4_), v63 = beyond(v62, 4), q4_p = v11 + v62;
        left |= (N5 <= doubt_limit_squared2) | (abs_wide(v4 * D5) <= v12);

        UNROLLED for (int i2 = 0; i2 < 2; i2++) { /* noflip5, flip5 */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            SIGNED_TWICE(wide, double);

            /* theta5 */
            const wide q5_p = e2 * angle2 + v16 * v17;

            /* theta6 */
            const wide angle3 = atan2_wide(-v21, C6);

            /* theta3 */
            const wide angle4 = atan2_wide(-v37, c3), q3_m = angle4 - signed_wide(half_turn, -v37);

            /* theta2 */
            const wide angle5 = atan2_wide(-sqrt_wide(v38), v39 + factor6 * (-v21 * (v26 - e2 * v41)
                - C6 * (v28 + e2 * v40)));

            /* theta1 */
            const wide angle6 = atan2_wide(s1, c3 * (e2 * v56 + factor6 * (C6 * v53 - v21 * v54)) -
                v37 * (v59 + factor6 * (C6 * (v57 - e2 * v60) + v21 * (v58 + e2 * v61)))),
                q1_m = angle6 - signed_wide(half_turn, s1);

            /* joint values */
            const wide v64 = angle3 + only_wide(angle3 < low(6), turn), v65 = beyond(v64, 6),
                v66 = low(6) - angle3, v67 = pick_wide(v66 < v65, v66, v65),
                q6_p = pick_wide(0.0 < v67, angle3, v64),
                v69 = maximum_wide(v67, maximum_wide(exceeds(q5_p, 5), maximum_wide(v63,
                    exceeds(angle5, 2)))),
                excess_p = maximum_wide(exceeds(angle4, 3), maximum_wide(v69, exceeds(angle6, 1))),
                excess_m = maximum_wide(exceeds(q3_m, 3), maximum_wide(v69, exceeds(q1_m, 1)));
            const int row = 4 * i1 + 2 * i2;
            q[7 * row] = angle6; q[7 * row + 1] = angle5; q[7 * row + 2] = angle4;
            q[7 * row + 3] = q4_p; q[7 * row + 4] = q5_p; q[7 * row + 5] = q6_p;
            q[7 * row + 6] = q7_p;
            kind[row] = kind_of(q[7 * row], 0.0 < excess_p);
            q[7 * row + 7] = q1_m; q[7 * row + 8] = -angle5; q[7 * row + 9] = q3_m;
            q[7 * row + 10] = q4_p; q[7 * row + 11] = q5_p; q[7 * row + 12] = q6_p;
            q[7 * row + 13] = q7_p;
            kind[row + 1] = kind_of(q[7 * row + 7], 0.0 < excess_m);
            left |= (v24 <= m10) | (v38 <= m11);
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

    if (bits_four(((irregularity_four(T, free_joints) <= 1e-24) == 0) | ((N5 <=
        doubt_limit_squared2) | (abs_four(v4 * D5) <= v12)) | ((v24 <= m10) | (v38 <= m11))) |
        (unsigned)((fabs(D4) <= m1 * (merge_slack2 + 2.0 * fabs(Z4))) | (0.0 < fabs(free_joints[0])
        - high(7))))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(v15, all_four(w4), 0, 5, 2, 3), shuffle(-v13,
        all_four(Z4), 0, 5, 2, 3)), ratio2 = ratio_four(-v21, C6), ratio3 = ratio_four(-v37, c3),
        ratio4 = ratio_four(s1, c3 * (e2 * v56 + factor6 * (C6 * v53 - v21 * v54)) - v37 * (v59 +
            factor6 * (C6 * (v57 - e2 * v60) + v21 * (v58 + e2 * v61)))),
        ratio5 = ratio_four(-sqrt_four(v38), v39 + factor6 * (-v21 * (v26 - e2 * v41) - C6 * (v28 +
            e2 * v40)));
    const four packed1 = angle_four(ratio1), angle2 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = angle_four(ratio2),
        angle4 = angle_four(ratio3), angle6 = angle_four(ratio4), angle5 = angle_four(ratio5);
    const four q4_ = e1 * angle1 - turn1, q5_p = e2 * angle2 + v16 * v17,
        q3_m = angle4 - signed_four(half_turn, -v37), q1_m = angle6 - signed_four(half_turn, s1),
        v62 = raised_four(q4_), v63 = beyond_four(v62, 4),
        v64 = angle3 + only_four(angle3 < low(6), turn), v65 = beyond_four(v64, 6),
        v66 = low(6) - angle3, v67 = pick_four(v66 < v65, v66, v65),
        q6_p = pick_four(0.0 < v67, angle3, v64), q4_p = v11 + v62,
        v69 = maximum_four(v67, maximum_four(exceeds_four(q5_p, 5), maximum_four(v63,
            exceeds_four(angle5, 2)))),
        excess_p = maximum_four(exceeds_four(angle4, 3), maximum_four(v69, exceeds_four(angle6,
            1))),
        excess_m = maximum_four(exceeds_four(q3_m, 3), maximum_four(v69, exceeds_four(q1_m, 1)));
    const four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (bits_four((grazes_four(excess_p) | grazes_four(excess_m))))
        return -1;

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], angle6, angle5, angle4, q4_p);
    store_4(&q[0][3], &q[2][3], &q[4][3], &q[6][3], q4_p, q5_p, q6_p, q7_p);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_m, -angle5, q3_m, q4_p);
    store_4(&q[1][3], &q[3][3], &q[5][3], &q[7][3], q4_p, q5_p, q6_p, q7_p);
    const unsigned long long none1 = (bits_four(angle6 != angle6) * 0x200040008001ull &
        0x1000100010001ull) | (bits_four(q1_m != q1_m) * 0x20004000800100ull &
        0x100010001000100ull);
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

    const double c7 = cos(free_joints[0]), s7 = sin(free_joints[0]);

    /* theta4, type 2: the squared length of column 4 of A7 U0^-1 A1 */
    const double v1 = d7 * T13 - T14, v2 = d7 * T23 - T24;
    const double t34 = T34 - d7 * T33;
    const double v3 = d1 - t34;
    const double w2x = T11 * v1 + T21 * v2 + T31 * v3, w2y = T12 * v1 + T22 * v2 + T32 * v3,
        w2z = T13 * v1 + T23 * v2 + T33 * v3;
    const double Z4 = c7 * (2.0 * (w2x * a6)) - s7 * (2.0 * (w2y * a6)) + (w2x * w2x + (w2y * w2y +
        (w2z * w2z - k4)));
    const double D4 = k3 - Z4 * Z4;
    const double v4 = 2.0 * fabs(Z4);
    const int apart4 = merge_slack2 * (v4 + merge_slack2) < D4;
    if (!(-(reach_slack2 * (v4 + reach_slack2)) <= D4)) return; /* out of reach */
    const double w4 = sqrt(apart4 ? D4 : 0.0);
    const double v5 = (apart4 ? w4 : least_root2) * k5, v6 = k1 * Z4, v7 = k2 * Z4;

    /* theta5, type 2: A7 U0^-1 A1 [3, 4] */
    const double Z5 = c7 * w2y + s7 * w2x;
    const double v9 = Z5 * Z5, v10 = fabs(Z5), v11 = 2.0 * v10,
        v12 = merge_slack1 * (v11 + merge_slack1);

    /* theta6, type 3: A7 U0^-1 A1 [2, 4] and A7 U0^-1 A1 [1, 4] */
    const double Z2_6 = a6 + (c7 * w2x - s7 * w2y);

    /* theta3, type 2: U0 (A3 A4 A5 A6 A7)^-1 [3, 3] */
    const double v17 = c7 * T31 - s7 * T32, v22 = c7 * T32 + s7 * T31;

    /* theta1, type 3: U0 (A3 A4 A5 A6 A7)^-1 [1, 3] and U0 (A3 A4 A5 A6 A7)^-1 [2, 3] */
    const double v28 = c7 * T11 - s7 * T12, v31 = c7 * T12 + s7 * T11, v39 = c7 * T21 - s7 * T22,
        v42 = c7 * T22 + s7 * T21;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip4, flip4 */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e1 < 0.0 && !apart4) continue; /* both signs give the same */
        const double root4 = w4 * e1;
        const double c4 = k6 * (v7 + k1 * root4), s4 = k6 * (k2 * root4 - v6);
        const double q4 = atan2(s4, c4);

        /* theta5 */
        const double v8 = a3 * c4 + d3 * s4 - a4;
        const double N5 = -v8 * -v8;
        const int free5 = N5 <= free_limit_squared2;
        const double D5 = N5 - v9;
        const int apart5 = v12 < D5;
        if (!(-(reach_slack1 * (v11 + reach_slack1)) <= v5 * D5)) continue; /* out of reach */
        const double w5 = sqrt(apart5 ? D5 : 0.0);
        const double inverse5 = 1.0 / (free5 ? 1.0 : (apart5 ? N5 : v10 * sqrt(N5)));
        const double s5 = free5 ? sin(seed[4]) : inverse5 * (-v8 * Z5);

        /* theta6 */
        const double Y1_6 = d5 + (d3 * c4 - a3 * s4);
        const double v14 = Y1_6 * Z2_6, v16 = w2z * Y1_6;

        /* theta3 */
        const double v18 = c4 * v17, v19 = T33 * s4, v20 = T33 * c4, v21 = s4 * v17,
            v23 = s5 * (c4 * v22), v25 = s5 * v17, v26 = T33 * s5;

        /* theta2, type 3: U0 (A3 A4 A5 A6 A7)^-1 [3, 2] and U0 (A3 A4 A5 A6 A7)^-1 [3, 1] */
        const double v27 = s5 * (s4 * v22);

        /* theta1 */
        const double v29 = s5 * v28, v30 = T13 * s5, v33 = c4 * v28, v34 = T13 * s4, v35 = T13 * c4,
            v36 = s4 * v28, v37 = s5 * (c4 * v31), v40 = s5 * v39, v41 = T23 * s5, v44 = c4 * v39,
            v45 = T23 * s4, v46 = T23 * c4, v47 = s4 * v39, v48 = s5 * (c4 * v42);

        for (int i2 = 0; i2 < 2; i2++) { /* noflip5, flip5 */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta5 */
            if (e2 < 0.0 && (free5 || !apart5)) continue; /* both signs give the same */
            const double c5 = free5 ? cos(seed[4]) : -(inverse5 * (-v8 * (w5 * e2)));
            const double q5 = atan2(s5, c5);

            /* theta6 */
            const double v13 = v8 * c5, v15 = w2z * v13 + v14;
            const double C6 = v16 - v13 * Z2_6;
            const double w6 = sqrt(v15 * v15 + C6 * C6);
            const int free6 = w6 <= free_limit_squared2;
            const double factor6 = 1.0 / (free6 ? 1.0 : w6);
            const double c6 = free6 ? cos(seed[5]) : C6 * factor6,
                s6 = free6 ? sin(seed[5]) : -(v15 * factor6);
            const double q6 = atan2(s6, c6);

            /* theta3 */
            const double v24 = c6 * (c5 * v18 + v19) + s6 * (c5 * v20 - v21) + v23;
            const double Y3 = c5 * v22 - (c6 * v25 + s6 * v26);
            const double w3 = sqrt(v24 * v24 + Y3 * Y3);
            const int free3 = w3 <= free_limit;
            const double divisor3 = free3 ? 1.0 : w3;

            /* theta2 */
            const double c2 = c6 * (c5 * v21 - v20) + s6 * (v18 + c5 * v19) + v27;

            /* theta1 */
            const double v32 = c5 * v31 - (c6 * v29 + s6 * v30),
                v38 = c6 * (c5 * v33 + v34) + s6 * (c5 * v35 - v36) + v37,
                v43 = c5 * v42 - (c6 * v40 + s6 * v41),
                v49 = c6 * (c5 * v44 + v45) + s6 * (c5 * v46 - v47) + v48;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip3, flip3 */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta3 */
                if (e3 < 0.0 && free3) continue; /* both signs give the same */
                const double factor3 = e3 / divisor3;
                const double c3 = free3 ? cos(seed[2]) : v24 * factor3,
                    s3 = free3 ? sin(seed[2]) : Y3 * factor3;
                const double q3 = atan2(s3, c3);

                /* theta2 */
                const double q2 = atan2(-(w3 * e3), c2);

                /* theta1 */
                const double s1 = c3 * v32 - s3 * v38, c1 = s3 * v49 - c3 * v43;
                const double q1 = atan2(s1, c1);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6; q[row][6] = free_joints[0];
                status[row] = (free3 || free5 || free6) ? FREE : OK;
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
    static const int choosable[3] = { 5, 4, 2 };
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
static const double weights[6] = { 0.7179, 0.7179, 0.7179, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[7] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[7], double e[6])
{
    double P[16], square = 0.0;
    franka_panda_fk(x, P);
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
    franka_panda_jacobian(x, J);
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
    x[6] = free_joints[0];
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

int franka_panda_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[8][7],
    unsigned char status[8])
{
    const int count = solve_regular(T, free_joints, q, status);
    return count < 0 ? ik_carefully(T, free_joints, q_seed, q, status) : count;
}

int franka_panda_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    double all[8][7], found[7], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = franka_panda_ik(T, free_joints, q_seed, all, status) >= 0;
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

void franka_panda_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, free_joints + k, q + 56 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)franka_panda_ik(
                    T + 16 * i, free_joints + i, NULL, (double (*)[7])(q + 56 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)franka_panda_ik(
            T + 16 * k, free_joints + k, NULL, (double (*)[7])(q + 56 * k), status + 8 * k);
}
