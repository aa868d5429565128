/* fanuc_lrmate200id: Fanuc LR Mate 200iD
 *
 * Inverse kinematics, generated from robots/fanuc_lrmate200id.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/fanuc_lrmate200id.yaml. The formulas and where they come from:
 * fanuc_lrmate200id.md.
 */
#include "fanuc_lrmate200id.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = FANUC_LRMATE200ID_OK, NONE = FANUC_LRMATE200ID_UNREACHABLE, FREE =
        FANUC_LRMATE200ID_FREE_JOINT,
    OUT = FANUC_LRMATE200ID_OUT_OF_LIMITS, INVALID = FANUC_LRMATE200ID_INVALID_POSE
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

#ifndef FANUC_LRMATE200ID_LIBM
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
 * -DFANUC_LRMATE200ID_SCALAR. With -DFANUC_LRMATE200ID_LIBM the arctangents are those of <math.h>,
 * too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(FANUC_LRMATE200ID_SCALAR) && !defined(FANUC_LRMATE200ID_LIBM)
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
#ifdef FANUC_LRMATE200ID_LIBM /* half the time of atan2 */
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

/* An angle moved by a whole turn to (-pi, pi] if it is below, above, or either. */
#define TURNS(v) \
HELPER v raised_##v(v x) { return x + only_##v(x <= -half_turn, turn); } \
HELPER v lowered_##v(v x) { return x - only_##v(half_turn < x, turn); } \

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
    d1 = 0.33, /* joint offset 1 [m] */
    a1 = 0.05, /* link length 1 [m] */
    a2 = 0.33, /* link length 2 [m] */
    a3 = 0.035, /* link length 3 [m] */
    d4 = 0.335, /* joint offset 4 [m] */
    d6 = 0.08, /* z of the tool frame [m] */
    free_limit1 = 1.1600000000000001e-12, /* a length that fixes no angle [m] */
    longest3 = 0.4446534412689106, /* square of the longest reach [m^2] */
    shortest3 = 4.655873108936529e-05, /* square of the shortest reach [m^2] */
    longest3_reach = 0.44465344126906536, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 4.655873108778226e-05, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.4446534412688952, /* the longest, where branches merge [m^2] */
    shortest3_apart = 4.655873108952359e-05, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 1.3456000000000002e-24, /* square of a length that fixes no angle [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    k1 = 0.22110000000000002, /* 2 * d4 * a2 [m^2] */
    k2 = 0.023100000000000002, /* 2 * a3 * a2 [m^2] */
    k3 = 0.22235000000000002, /* a2^2 + (a3^2 + d4^2) [m^2] */
    k4 = 20.235205939761407, /* 1 / (k1^2 + k2^2) [m^-4] */
    turn1 = -1.4666963886852973, /* a constant angle [rad] */
    m1 = 1.3456000000000003e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 6.836537250918941e-12,
    m10 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m4 = 1.5151515151515151, m5 = 0.006893939393939396, m6 = 0.15425297487880124,
m7 = 1.4764213309828118, m8 = 0.006717717055971795, m9 = 0.0007018510356985458;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const fanuc_lrmate200id_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -2.9670597283903604, -1.7453292519943295, -1.2217304763960306, -3.3161255787892263,
    -2.181661564992912, -6.283185307179586,
};
static const double highest[6] = {
    2.9670597283903604, 2.530727415391778, 3.5779249665883754, 3.3161255787892263,
    2.181661564992912, 6.283185307179586,
};
#define slack(joint) 1e-09 /* of limits */

void fanuc_lrmate200id_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * s3 - s2 * c3, z3_x = y2_x * c3 - x2_x * s3,
        z3_y = y2_y * c3 - x2_y * s3, z3_z = c2 * c3 + s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        z4_y = x3_y * s4 - c1 * c4, v2 = q[4] + offset5;
    const double c5 = cos(v2), s5 = sin(v2), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, T11_ = z3_x * c5 - x4_x * s5,
        T21_ = z3_y * c5 - x4_y * s5, T31_ = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = T11_; T[1] = x5_x * s6 - z4_x * c6; T[2] = -(x5_x * c6 + z4_x * s6);
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 - z3_x * d4 - -T11_ * d6;
    T[4] = T21_; T[5] = x5_y * s6 - z4_y * c6; T[6] = -(x5_y * c6 + z4_y * s6);
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 - z3_y * d4 - -T21_ * d6;
    T[8] = T31_; T[9] = x5_z * s6 - z4_z * c6; T[10] = -(x5_z * c6 + z4_z * s6);
    T[11] = d1 - s2 * a2 + x3_z * a3 - z3_z * d4 - -T31_ * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void fanuc_lrmate200id_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * s3 - s2 * c3, z3_x = y2_x * c3 - x2_x * s3,
        z3_y = y2_y * c3 - x2_y * s3, z3_z = c2 * c3 + s2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p3_x - z3_x * d4, p4_y = p3_y - z3_y * d4, p4_z = p3_z - z3_z * d4,
        z4_y = x3_y * s4 - c1 * c4, v2 = q[4] + offset5;
    const double c5 = cos(v2), s5 = sin(v2), z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        J21 = p4_x - z5_x * d6, v3 = p4_y - z5_y * d6, v4 = p4_z - z5_z * d6, v5 = v4 - d1,
        v6 = v4 - p2_z, v7 = J21 - p3_x, v8 = v3 - p3_y, v9 = v4 - p3_z, v10 = J21 - p4_x,
        v11 = v3 - p4_y, v12 = v4 - p4_z;
    J[0] = -v3; J[1] = c1 * v5; J[2] = -(c1 * v6); J[3] = z3_y * v9 - z3_z * v8;
    J[4] = z4_y * v12 - z4_z * v11; J[5] = z5_y * v12 - z5_z * v11;
    J[6] = J21; J[7] = s1 * v5; J[8] = -(s1 * v6); J[9] = z3_z * v7 - z3_x * v9;
    J[10] = z4_z * v10 - z4_x * v12; J[11] = z5_z * v10 - z5_x * v12;
    J[12] = 0.0; J[13] = -(s1 * (v3 - p1_y) + c1 * (J21 - p1_x));
    J[14] = s1 * (v3 - p2_y) + c1 * (J21 - p2_x); J[15] = z3_x * v8 - z3_y * v7;
    J[16] = z4_x * v11 - z4_y * v10; J[17] = z5_x * v11 - z5_y * v10;
    J[18] = 0.0; J[19] = -s1; J[20] = s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = -c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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
static double beyond_limits(const double values[6])
{
    double sum = 0.0;
    for (int i = 0; i < 6; i++)
        sum += fabs(overshoot(i, values[i]));
    return sum;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[48], wide_mask kind[8])
{
    ENTRIES(wide);

    /* theta1 */
    const wide t14 = T14 - d6 * T11, Y1 = d6 * T21 - T24, v1 = t14 * t14 + Y1 * Y1,
        w1 = sqrt_wide(v1), v2 = 1.0 / v1, angle1 = atan2_wide(Y1, -t14),
        q1__m = angle1 - signed_wide(half_turn, Y1);

    /* theta3 */
    const wide Z1_3 = T34 - d6 * T31 - d1, v3 = a1 + w1, v4 = a1 - w1, v5 = Z1_3 * Z1_3,
        N3_p = v5 + v3 * v3, N3_m = v5 + v4 * v4, D3_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = sqrt_wide(D3_p),
        w3_m = sqrt_wide(D3_m), angle2 = atan2_wide(w3_p, N3_p - k3),
        angle3 = atan2_wide(w3_m, N3_m - k3), q3__pp = angle2 - turn1, v6 = turn1 + angle2,
        q3__mp = angle3 - turn1, v7 = turn1 + angle3;

    /* theta2 */
    const wide Y1_2_p = m4 * N3_p - m5, Y1_2_m = m4 * N3_m - m5, v8 = Z1_3 * Y1_2_p,
        v9 = Z1_3 * Y1_2_m, v10 = m4 * Z1_3, v11 = m4 * -Z1_3, v12 = v3 * -Y1_2_p,
        v13 = v4 * -Y1_2_m, factor2_p = 1.0 / N3_p, factor2_m = 1.0 / N3_m;

    /* theta4 */
    const wide v14 = m6 * Z1_3, v15 = m7 * v3 - v14, v16 = m7 * v4 - v14, v17 = m7 + m8 * factor2_p,
        v18 = m7 + m8 * factor2_m, v19 = m6 + m9 * factor2_p, v20 = m6 + m9 * factor2_m,
        v21 = Z1_3 * v17 + v3 * v19, v22 = Z1_3 * v18 + v4 * v20,
        c2m3_pp = w3_p * (factor2_p * v15) - v21, c2m3_pm = w3_p * (factor2_p * -v15) - v21,
        c2m3_mp = w3_m * (factor2_m * v16) - v22, c2m3_mm = w3_m * (factor2_m * -v16) - v22,
        v23 = m7 * Z1_3, v24 = v3 * v17 - Z1_3 * v19, v25 = v4 * v18 - Z1_3 * v20,
        v26 = w3_p * (factor2_p * (v23 + m6 * v3)), s2m3_pp = v24 + v26, s2m3_pm = v24 - v26,
        v27 = w3_m * (factor2_m * (v23 + m6 * v4)), s2m3_mp = v25 + v27, s2m3_mm = v25 - v27,
        v28 = w1 * (v2 * (T21 * Y1 - T11 * t14)), X4_pp = c2m3_pp * v28 - T31 * s2m3_pp,
        X4_pm = c2m3_pm * v28 - T31 * s2m3_pm, v29 = c2m3_mp * v28 + T31 * s2m3_mp,
        v30 = c2m3_mm * v28 + T31 * s2m3_mm, Y4 = w1 * (v2 * (T11 * Y1 + t14 * T21)), v31 = Y4 * Y4,
        v32 = v31 + X4_pp * X4_pp, v33 = v31 + X4_pm * X4_pm, v34 = v31 + v29 * v29,
        v35 = v31 + v30 * v30, angle4 = atan2_wide(Y4, -X4_pp), angle5 = atan2_wide(Y4, -X4_pm),
        angle6 = atan2_wide(-Y4, v29), angle7 = atan2_wide(-Y4, v30),
        v36 = signed_wide(half_turn, Y4), v37 = signed_wide(half_turn, -Y4);

    /* theta6 */
    const wide v38 = w1 * (v2 * (t14 * T22 + Y1 * T12)), v39 = w1 * (v2 * (Y1 * T22 - t14 * T12)),
        v40 = w1 * (v2 * (t14 * T23 + Y1 * T13)), v41 = w1 * (v2 * (Y1 * T23 - t14 * T13)),
        v42 = Y4 * (s2m3_pp * T33 - c2m3_pp * v41) + X4_pp * v40,
        v43 = Y4 * (s2m3_pm * T33 - c2m3_pm * v41) + X4_pm * v40,
        v44 = v29 * v40 - Y4 * (s2m3_mp * T33 + c2m3_mp * v41),
        v45 = v30 * v40 - Y4 * (s2m3_mm * T33 + c2m3_mm * v41),
        angle8 = atan2_wide(v42, Y4 * (s2m3_pp * T32 - c2m3_pp * v39) + X4_pp * v38),
        angle9 = atan2_wide(v43, Y4 * (s2m3_pm * T32 - c2m3_pm * v39) + X4_pm * v38),
        angle10 = atan2_wide(v44, v29 * v38 - Y4 * (s2m3_mp * T32 + c2m3_mp * v39)),
        angle11 = atan2_wide(v45, v30 * v38 - Y4 * (s2m3_mm * T32 + c2m3_mm * v39));

    /* joint values */
    const wide v46 = w3_p * (m4 * v3), angle12 = atan2_wide(-(v8 + v46), v12 + w3_p * v10),
        v47 = angle12 - offset2, angle13 = atan2_wide(v46 - v8, v12 + w3_p * v11),
        v48 = angle13 - offset2, angle14 = atan2_wide(-(v9 + w3_m * (m4 * v4)), v13 + w3_m * v10),
        v49 = angle14 - offset2, angle15 = atan2_wide(-(v9 + w3_m * (m4 * -v4)), v13 + w3_m * v11),
        v50 = angle15 - offset2, q2_ppp = lowered_wide(v47), q2_pmp = lowered_wide(v48),
        q2_mpp = lowered_wide(v49), q2_mmp = lowered_wide(v50),
        angle16 = atan2_wide(sqrt_wide(v32), T31 * c2m3_pp + s2m3_pp * v28),
        angle17 = atan2_wide(sqrt_wide(v33), T31 * c2m3_pm + s2m3_pm * v28),
        angle18 = atan2_wide(sqrt_wide(v34), T31 * c2m3_mp - s2m3_mp * v28),
        angle19 = atan2_wide(sqrt_wide(v35), T31 * c2m3_mm - s2m3_mm * v28),
        v51 = angle16 - offset5, v52 = offset5 + angle16, v53 = angle17 - offset5,
        v54 = offset5 + angle17, v55 = angle18 - offset5, v56 = offset5 + angle18,
        v57 = angle19 - offset5, v58 = offset5 + angle19, q5_ppp = raised_wide(v51),
        q5_ppm = only_wide(-v52 <= -half_turn, turn) - v52, q5_pmp = raised_wide(v53),
        q5_pmm = only_wide(-v54 <= -half_turn, turn) - v54, q5_mpp = raised_wide(v55),
        q5_mpm = only_wide(-v56 <= -half_turn, turn) - v56, q5_mmp = raised_wide(v57),
        q5_mmm = only_wide(-v58 <= -half_turn, turn) - v58, v59 = lowered_wide(q3__pp),
        v60 = only_wide(half_turn < -v6, -turn) - v6, v61 = lowered_wide(q3__mp),
        v62 = only_wide(half_turn < -v7, -turn) - v7, v63 = exceeds(angle1, 1),
        v64 = exceeds(q1__m, 1), v65 = v59 + only_wide(v59 < low(3), turn),
        v66 = v60 + only_wide(v60 < low(3), turn), v67 = v61 + only_wide(v61 < low(3), turn),
        v68 = v62 + only_wide(v62 < low(3), turn), v69 = beyond(v65, 3), v70 = beyond(v66, 3),
        v71 = beyond(v67, 3), v72 = beyond(v68, 3), v73 = low(3) - v59, v74 = low(3) - v60,
        v75 = low(3) - v61, v76 = low(3) - v62, v77 = pick_wide(v73 < v69, v73, v69),
        v78 = pick_wide(v74 < v70, v74, v70), v79 = pick_wide(v75 < v71, v75, v71),
        v80 = pick_wide(v76 < v72, v76, v72), q3_ppp = pick_wide(0.0 < v77, v59, v65),
        q3_pmp = pick_wide(0.0 < v78, v60, v66), q3_mpp = pick_wide(0.0 < v79, v61, v67),
        q3_mmp = pick_wide(0.0 < v80, v62, v68), q1_ppp = angle1 + (w3_p - w3_p),
        q1_mpp = q1__m + (w3_m - w3_m),
        v81 = maximum_wide(v77, maximum_wide(v63, beyond(q2_ppp, 2))),
        v82 = maximum_wide(v78, maximum_wide(v63, beyond(q2_pmp, 2))),
        v83 = maximum_wide(v79, maximum_wide(v64, beyond(q2_mpp, 2))),
        v84 = maximum_wide(v80, maximum_wide(v64, beyond(q2_mmp, 2))),
        excess_ppp = maximum_wide(v81, exceeds(q5_ppp, 5)),
        excess_ppm = maximum_wide(v81, exceeds(q5_ppm, 5)),
        excess_pmp = maximum_wide(v82, exceeds(q5_pmp, 5)),
        excess_pmm = maximum_wide(v82, exceeds(q5_pmm, 5)),
        excess_mpp = maximum_wide(v83, exceeds(q5_mpp, 5)),
        excess_mpm = maximum_wide(v83, exceeds(q5_mpm, 5)),
        excess_mmp = maximum_wide(v84, exceeds(q5_mmp, 5)),
        excess_mmm = maximum_wide(v84, exceeds(q5_mmm, 5));

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = angle4; q[4] = q5_ppp; q[5] = angle8;
    kind[0] = kind_of(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = angle4 - v36; q[10] = q5_ppm;
    q[11] = angle8 - signed_wide(half_turn, v42);
    kind[1] = kind_of(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = angle5; q[16] = q5_pmp; q[17] = angle9;
    kind[2] = kind_of(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = angle5 - v36; q[22] = q5_pmm;
    q[23] = angle9 - signed_wide(half_turn, v43);
    kind[3] = kind_of(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_mpp; q[27] = angle6; q[28] = q5_mpp; q[29] = angle10;
    kind[4] = kind_of(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_mpp; q[33] = angle6 - v37; q[34] = q5_mpm;
    q[35] = angle10 - signed_wide(half_turn, v44);
    kind[5] = kind_of(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_mmp; q[39] = angle7; q[40] = q5_mmp; q[41] = angle11;
    kind[6] = kind_of(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_mmp; q[45] = angle7 - v37; q[46] = q5_mmm;
    q[47] = angle11 - signed_wide(half_turn, v45);
    kind[7] = kind_of(q[42], 0.0 < excess_mmm);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v35 <= m10) | (v34 <= m10) | (v33 <= m10) | (v32 <= m10) |
        (abs_wide(D3_m) <= m3) | (v1 <= m1) | (abs_wide(D3_p) <= m3)) | (grazes(excess_mmm) |
        grazes(excess_mmp) | grazes(excess_mpm) | grazes(excess_mpp) | grazes(excess_pmm) |
        grazes(excess_pmp) | grazes(excess_ppp) | grazes(excess_ppm));
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
    const double t14 = T14 - d6 * T11, Y1 = d6 * T21 - T24, v1 = t14 * t14 + Y1 * Y1, w1 = sqrt(v1),
        v2 = 1.0 / v1, v3 = copysign(half_turn, Y1);

    /* theta3 */
    const double Z1_3 = T34 - d6 * T31 - d1;
    const four v4 = a1 + e1 * w1;
    const double v5 = Z1_3 * Z1_3;
    const four N3 = v5 + v4 * v4, D3 = (longest3 - N3) * (N3 - shortest3), w3 = sqrt_four(D3);

    /* theta2 */
    const four Y1_2 = m4 * N3 - m5, v6 = Z1_3 * Y1_2, v7 = m4 * (e2 * Z1_3), v8 = v4 * -Y1_2,
        factor2 = 1.0 / N3;

    /* theta4 */
    const double v9 = m6 * Z1_3;
    const four v10 = m7 * v4 - v9, v11 = m7 + m8 * factor2, v12 = m6 + m9 * factor2,
        v13 = Z1_3 * v11 + v4 * v12, c2m3 = w3 * (factor2 * (e2 * v10)) - v13;
    const double v14 = m7 * Z1_3;
    const four v15 = v14 + m6 * v4, v16 = v4 * v11 - Z1_3 * v12,
        s2m3 = v16 + w3 * (factor2 * (e2 * v15));
    const double v17 = w1 * (v2 * (T21 * Y1 - T11 * t14));
    const four X4 = e1 * (c2m3 * v17) - T31 * s2m3;
    const double Y4 = w1 * (v2 * (T11 * Y1 + t14 * T21)), v18 = Y4 * Y4;
    const four v19 = v18 + X4 * X4, v20 = e1 * Y4, v21 = signed_four(half_turn, v20);

    /* theta6 */
    const double v22 = w1 * (v2 * (t14 * T22 + Y1 * T12)), v23 = w1 * (v2 * (Y1 * T22 - t14 * T12)),
        v24 = w1 * (v2 * (t14 * T23 + Y1 * T13)), v25 = w1 * (v2 * (Y1 * T23 - t14 * T13));
    const four v26 = e1 * (Y4 * (s2m3 * T33 - e1 * (c2m3 * v25)) + X4 * v24);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | (abs_four(D3) <= m3) | (v19 <= m10)) |
        (unsigned)(v1 <= m1))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(w3, all_four(Y1), 0, 5, 2, 3), shuffle(N3 - k3,
        all_four(-t14), 0, 5, 2, 3)),
        ratio2 = ratio_four(-(v6 + w3 * (m4 * (e2 * v4))), v8 + w3 * v7),
        ratio3 = ratio_four(v20, -X4),
        ratio4 = ratio_four(v26, e1 * (Y4 * (s2m3 * T32 - e1 * (c2m3 * v23)) + X4 * v22)),
        ratio5 = ratio_four(sqrt_four(v19), T31 * c2m3 + e1 * (s2m3 * v17));
    const four packed1 = angle_four(ratio1), angle2 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = shuffle(packed1, packed1, 1, 1, 1, 1), angle5 = angle_four(ratio2),
        angle3 = angle_four(ratio3), angle4 = angle_four(ratio4), angle6 = angle_four(ratio5);
    const four q1_ = angle1 + v3 * (m2 * (e1 - 1.0)), q3_ = e2 * angle2 - turn1,
        q4_m = angle3 - v21, q6_m = angle4 - signed_four(half_turn, v26), v27 = angle5 - offset2,
        q2_p = lowered_four(v27), v28 = angle6 - offset5, v29 = offset5 + angle6,
        q5_p = raised_four(v28), q5_m = only_four(-v29 <= -half_turn, turn) - v29,
        v30 = lowered_four(q3_), v31 = exceeds_four(q1_, 1),
        v32 = v30 + only_four(v30 < low(3), turn), v33 = beyond_four(v32, 3), v34 = low(3) - v30,
        v35 = pick_four(v34 < v33, v34, v33), q3_p = pick_four(0.0 < v35, v30, v32),
        q1_p = q1_ + (w3 - w3), v36 = maximum_four(v35, maximum_four(v31, beyond_four(q2_p, 2))),
        excess_p = maximum_four(v36, exceeds_four(q5_p, 5)),
        excess_m = maximum_four(v36, exceeds_four(q5_m, 5));
    const four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (bits_four((grazes_four(excess_p) | grazes_four(excess_m))))
        return -1;

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, q2_p, q3_p, angle3);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], q5_p, angle4);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, q2_p, q3_p, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], q5_m, q6_m);
    const unsigned long long none1 = (bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long outside1 = (bits_four(outside_p) * 0x200040008001ull &
        0x1000100010001ull) | (bits_four(outside_m) * 0x20004000800100ull & 0x100010001000100ull);
    const unsigned long long kind1 = none1 * NONE + (outside1 & ~none1) * OUT;
    __builtin_memcpy(status + 0, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~(none1 | outside1));
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

    /* theta1, type 2: U1[3, 4] */
    const double t14 = T14 - d6 * T11;
    const double Y1 = d6 * T21 - T24;
    const double w1 = sqrt(t14 * t14 + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double t34 = T34 - d6 * T31;
    const double Z1_3 = t34 - d1;
    const double v2 = Z1_3 * Z1_3;

    /* theta2, type 3: U1[1, 4] and U1[2, 4] */
    const double v6 = seed[1] + offset2;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(t14 * factor1),
            s1 = free1 ? sin(seed[0]) : Y1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v1 = w1 * e1 + a1;
        const double N3 = v2 + v1 * v1;
        const double K3 = N3 - k3;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v3 = k1 * K3, v4 = k2 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v7 = T11 * c1 + T21 * s1;
        const double Y4 = T11 * s1 - T21 * c1;
        const double v8 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v9 = T22 * c1 - T12 * s1, v10 = T12 * c1 + T22 * s1, v12 = T23 * c1 - T13 * s1,
            v13 = T13 * c1 + T23 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double root3 = w3 * e2;
            const double s3 = (v3 + k2 * root3) * k4, c3 = k4 * (v4 - k1 * root3);
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double X1_2 = a3 * s3 - d4 * c3;
            const double Y1_2 = a2 + (a3 * c3 + d4 * s3);
            const double v5 = v1 * X1_2 + Z1_3 * Y1_2;
            const double C2 = Z1_3 * X1_2 - v1 * Y1_2;
            const double w2 = sqrt(v5 * v5 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v6) : C2 * factor2,
                s2 = free2 ? sin(v6) : -(v5 * factor2);

            /* theta4 */
            const double c2m3 = c3 * c2 + s3 * s2;
            const double s2m3 = c3 * s2 - s3 * c2;
            const double X4 = c2m3 * v7 - T31 * s2m3;
            const double w4 = sqrt(X4 * X4 + v8);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T31 * c2m3 + s2m3 * v7;

            /* theta6 */
            const double v11 = T32 * s2m3 - c2m3 * v10, v14 = T33 * s2m3 - c2m3 * v13;

            /* joint values */
            const double q2 = wrap(atan2(s2, c2) - offset2);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);
                const double s5 = w4 * e3;

                /* theta6 */
                const double c6 = c4 * v9 + s4 * v11, s6 = c4 * v12 + s4 * v14;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q5 = wrap(atan2(s5, c5) - offset5);
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

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const double *T;
    double seed[6], start, q[8][6];
    unsigned char status[8];
    int joint, row;
};

/* Solves with the joint moved: 0 if it serves, else less. */
static double attempt(struct search *s, double moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < 8; i++)
        s->status[i] = NONE;
    solve(s->T, s->seed, s->q, s->status);
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
    for (int i = 0; i < 6; i++) {
        const double value = s->q[s->row][i], moved = fabs(value - other.q[s->row][i]);
        if (moved < 1e-09 && fabs(overshoot(i, value)) > 0.0)
            return 1;
    }
    return 0;
}

/* A free joint took the seed's value, and that puts one beyond its limits: takes the nearest value
 * that keeps all, if there is one; other free joints the seed's, as far as their limits allow. */
static void keep_limits(
    const double T[16], const double seed[6], int row, double q[8][6], unsigned char status[8])
{
    static const int choosable[3] = { 3, 1, 0 };
    struct search search = { .T = T, .row = row };
    for (int i = 0; i < 6; i++)
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
static const double weights[6] = { 0.8621, 0.8621, 0.8621, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    fanuc_lrmate200id_fk(x, P);
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
    fanuc_lrmate200id_jacobian(x, J);
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

/* The same of a value as it stands: it might be turned. */
static double past_an_end(int joint, double value)
{
    const double low = lowest[joint], high = highest[joint];
    if (high - low < 6.183185307179587)
        return overshoot(joint, value);
    const double off = value - fmin(fmax(value, low), high);
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of all joints. */
static double past_ends(const double values[6])
{
    double sum = 0.0;
    for (int i = 0; i < 6; i++)
        sum += fabs(past_an_end(i, values[i]));
    return sum;
}

/* A joint value turned inside its limits, or next to the end that it and the seed are at. */
static double at_an_end(int joint, double value, double seed)
{
    const double near = value + turn * floor((seed - value) / turn + 0.5);
    const double past = fabs(past_an_end(joint, near));
    if (0.0 < past && past < 0.01 && fabs(near - seed) < 0.15)
        return near;
    const double off = overshoot(joint, value);
    if (off == 0.0 || fabs(off) > 0.01)
        return turned(joint, value, value);
    return off + (off > 0.0 ? highest : lowest)[joint];
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[6])
{
    double x[6], half[6], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[6] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 6 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? past_an_end(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 6; i++)
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

/* Takes joint values onto ends that they are past or, as two may not stand there, inside. */
static int lead_inside(const double T[16], double enough, double most, double q[6])
{
    double x[6], e[6];
    if (settle(T, enough, most, q))
        return 1;
    int past = 0;
    for (int i = 0; i < 6; i++)
        past += fabs(past_an_end(i, q[i])) > 0.0;
    enough = off_pose(T, q, e) + 1e-14;
    for (double farther = 2.0; past > 1 && farther <= 16.0; farther *= 2.0) {
        for (int i = 0; i < 6; i++)
            x[i] = q[i] - farther * past_an_end(i, q[i]);
        if (!settle(T, enough, most, x) || past_ends(x) > 0.0)
            continue;
        take(x, q);
        return 1;
    }
    return 0;
}

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const double T[16], int row, int far, double rows[8][6], const unsigned char status[8])
{
    double x[6], half[6], to[6], *q = rows[row];
    const double beyond = past_ends(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!lead_inside(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 8; k++)
        if (status[k] != NONE && past_ends(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const double T[16], const double seed[6], double q[8][6],
    unsigned char status[8])
{
    double x[6], half[6], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    for (int i = 0; i < 6; i++) {
        const double seen = seed[i], past = fabs(past_an_end(i, seen));
        const double here = past <= 0.15 ? seen : turned(i, seen, seen);
        x[i] = here - past_an_end(i, here);
    }
    if (!settle(T, 1e-12, 0.15, x) || (past_ends(x) > 1e-09 && !lead_inside(T, NAN, 0.15, x)))
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
    if (nearest > 1e-06 || past_ends(q[place]) > 0.0)
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
    for (int row = 0; row < 8; row++)
        if (status[row] == FREE && beyond_limits(q[row]) > 0.0)
            keep_limits(pose, seed, row, q, status);
    for (int row = 0; row < 8; row++)
        for (int i = 0; i < 6; i++)
            q[row][i] = at_an_end(i, q[row][i], seed[i]);
    stay(pose, seed, q, status);
    /* far where no row is inside */
    for (int n = 0; n < 8 || (n < 2 * 8 && count == 0); n++) {
        const int row = n % 8, far = n >= 8;
        if (status[row] == NONE)
            continue;
        if (stand(pose, row, far, q, status) && far)
            status[row] = FREE;
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

int fanuc_lrmate200id_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int fanuc_lrmate200id_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = fanuc_lrmate200id_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 6; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    int past = 0; /* joints past an end and turned */
    for (int i = 0; i < 6 && valid; i++)
        if (fmin(highest[i] - q_seed[i], q_seed[i] - lowest[i]) < 0.15)
            for (int row = 0; row < 8; row++)
                past += status[row] == OK
                    && past_an_end(i, at_an_end(i, all[row][i], q_seed[i])) != 0.0;
    if (past)
        (void)ik_carefully(T, q_seed, all, status);
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

void fanuc_lrmate200id_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)fanuc_lrmate200id_ik(
                    T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)fanuc_lrmate200id_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
