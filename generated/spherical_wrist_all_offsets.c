/* spherical_wrist_all_offsets: Spherical wrist on an arm with every offset
 *
 * Inverse kinematics, generated from robots/spherical_wrist_all_offsets.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical_wrist_all_offsets.yaml. The formulas and where they come
 * from: spherical_wrist_all_offsets.md.
 */
#include "spherical_wrist_all_offsets.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = SPHERICAL_WRIST_ALL_OFFSETS_OK, NONE = SPHERICAL_WRIST_ALL_OFFSETS_UNREACHABLE, FREE =
        SPHERICAL_WRIST_ALL_OFFSETS_FREE_JOINT,
    OUT = SPHERICAL_WRIST_ALL_OFFSETS_OUT_OF_LIMITS, INVALID =
        SPHERICAL_WRIST_ALL_OFFSETS_INVALID_POSE
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

#ifndef SPHERICAL_WRIST_ALL_OFFSETS_LIBM
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
 * -DSPHERICAL_WRIST_ALL_OFFSETS_SCALAR. With -DSPHERICAL_WRIST_ALL_OFFSETS_LIBM the arctangents are
 * those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(SPHERICAL_WRIST_ALL_OFFSETS_SCALAR) && !defined(SPHERICAL_WRIST_ALL_OFFSETS_LIBM)
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
#ifdef SPHERICAL_WRIST_ALL_OFFSETS_LIBM /* half the time of atan2 */
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
HELPER v lowered_##v(v x) { return x - only_##v(half_turn < x, turn); } \

TURNS(wide)
#if LANES > 1
TURNS(four)
#endif


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.5, /* joint offset 1 [m] */
    a1 = 0.12, /* link length 1 [m] */
    d2 = 0.13, /* joint offset 2 [m] */
    a2 = 0.43, /* link length 2 [m] */
    d3 = 0.06, /* joint offset 3 [m] */
    a3 = 0.09, /* link length 3 [m] */
    d4 = 0.38, /* joint offset 4 [m] */
    d6 = 0.07, /* joint offset 6 [m] */
    free_limit_squared2 = 3.1684000000000017e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 5.628854235099716e-07, /* a root of nothing, by rounding [m] */
    longest3 = 0.6732407360639862, /* square of the longest reach [m^2] */
    shortest3 = 0.0015592639360138612, /* square of the shortest reach [m^2] */
    boundary3 = 1.9612336995515177e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.673240736063957, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.001559263936015267, /* the shortest, where branches merge [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.07, /* d2 - d3 [m] */
    k2 = 0.004900000000000001, /* k1^2 [m^2] */
    k3 = 2.4920000000031693e-14, /* reach_slack1 * (2 * k1 + reach_slack1) [m^2] */
    k4 = 2.4920000000003178e-15, /* merge_slack1 * (2 * k1 + merge_slack1) [m^2] */
    k5 = 0.5617977528089886, /* 1 / arm_size1 [m^-1] */
    k6 = 0.3268, /* 2 * d4 * a2 [m^2] */
    k7 = 0.0774, /* 2 * a3 * a2 [m^2] */
    k8 = 0.3374, /* a2^2 + (a3^2 + d4^2) [m^2] */
    k9 = 8.866112830151877, /* 1 / (k6^2 + k7^2) [m^-4] */
    turn1 = -1.3382393849899876, /* a constant angle [rad] */
    m1 = 2.4920000000003177e-12, /* 1000 * k4 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 1.96123369955058e-11,
    m9 = 9.999999999999999e-09; /* doubt_limit^2 */
/* coefficients */
static const double m3 = 1.1627906976744187, m4 = 0.03767441860465117, m5 = 0.29508196721311475,
m6 = 1.2459016393442623, m7 = 0.04036721311475411, m8 = 0.00956065573770492;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const spherical_wrist_all_offsets_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void spherical_wrist_all_offsets_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, z3_x = v1 * c3 + x2_x * s3,
        z3_y = v2 * c3 + x2_y * s3, y4_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, v4 = v3 * c4, v5 = s1 * c4 + x3_x * s4,
        z4_y = c1 * c4 - x3_y * s4, z4_z = v3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - z3_x * s5,
        x5_y = x4_y * c5 - z3_y * s5, x5_z = y4_z * s5 - v4 * c5, z5_x = z3_x * c5 + x4_x * s5,
        z5_y = z3_y * c5 + x4_y * s5, v6 = y4_z * c5 + v4 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - v5 * s6; T[1] = -(v5 * c6 + x5_x * s6); T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3 + s1 * d3 + z3_x * d4 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * a2 + c1 * d2 + x3_y * a3 - c1 * d3 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = z4_z * c6 - x5_z * s6; T[10] = -v6;
    T[11] = d1 - s2 * a2 - v3 * a3 + -y4_z * d4 - v6 * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void spherical_wrist_all_offsets_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_z = d1 - s2 * a2, p2_x = p1_x + x2_x * a2 - s1 * d2,
        p2_y = p1_y + x2_y * a2 + c1 * d2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, z3_x = v1 * c3 + x2_x * s3,
        z3_y = v2 * c3 + x2_y * s3, y4_z = s2 * s3 - c2 * c3, p3_z = p2_z - v3 * a3,
        p3_x = p2_x + x3_x * a3 + s1 * d3, p3_y = p2_y + x3_y * a3 - c1 * d3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), v4 = s1 * c4 + x3_x * s4,
        z4_y = c1 * c4 - x3_y * s4, z4_z = v3 * s4, p4_x = p3_x + z3_x * d4,
        p4_y = p3_y + z3_y * d4, p4_z = p3_z + -y4_z * d4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_x = z3_x * c5 + (x3_x * c4 - s1 * s4) * s5,
        z5_y = z3_y * c5 + (x3_y * c4 + c1 * s4) * s5, v5 = y4_z * c5 + v3 * c4 * s5,
        p6_x = p4_x + z5_x * d6, p6_y = p4_y + z5_y * d6, p6_z = p4_z - v5 * d6, v6 = p6_z - d1,
        v7 = p6_z - p2_z, v8 = p6_x - p3_x, v9 = p6_y - p3_y, v10 = p6_z - p3_z, v11 = p6_x - p4_x,
        v12 = p6_y - p4_y, v13 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = c1 * v6; J[2] = c1 * v7; J[3] = z3_y * v10 - -y4_z * v9;
    J[4] = z4_y * v13 - z4_z * v12; J[5] = z5_y * v13 + v5 * v12;
    J[6] = p6_x; J[7] = s1 * v6; J[8] = s1 * v7; J[9] = -y4_z * v8 - z3_x * v10;
    J[10] = z4_z * v11 + v4 * v13; J[11] = -(v5 * v11 + z5_x * v13);
    J[12] = 0.0; J[13] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x));
    J[14] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)); J[15] = z3_x * v9 - z3_y * v8;
    J[16] = -(v4 * v12 + z4_y * v11); J[17] = z5_x * v12 - z5_y * v11;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = z3_x; J[22] = -v4; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = -y4_z; J[34] = z4_z; J[35] = -v5;
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
    const wide wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, N1 = wx * wx + Y1 * Y1, D1 = N1 - k2,
        w1 = sqrt_wide(D1), inverse1 = 1.0 / N1, v1 = inverse1 * (k1 * Y1),
        v2 = v1 + w1 * (wx * inverse1), v3 = v1 + w1 * (inverse1 * -wx), v4 = inverse1 * (k1 * wx),
        s1_p = w1 * (Y1 * inverse1) - v4, s1_m = w1 * (inverse1 * -Y1) - v4;

    /* theta3 */
    const wide Z1_3 = T34 - d6 * T33 - d1, v5 = a1 + w1, v6 = a1 - w1, v7 = Z1_3 * Z1_3,
        N3_p = v7 + v5 * v5, N3_m = v7 + v6 * v6, D3_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_m = (longest3 - N3_m) * (N3_m - shortest3), v8 = k5 * w1, w3_p = sqrt_wide(D3_p),
        w3_m = sqrt_wide(D3_m), angle1 = atan2_wide(w3_p, N3_p - k8),
        angle2 = atan2_wide(w3_m, N3_m - k8), q3__pp = angle1 - turn1, v9 = turn1 + angle1,
        q3__mp = angle2 - turn1, v10 = turn1 + angle2;

    /* theta2 */
    const wide v11 = Z1_3 * (m4 + m3 * N3_p), v12 = Z1_3 * (m4 + m3 * N3_m), factor2_p = 1.0 / N3_p,
        factor2_m = 1.0 / N3_m, v13 = v5 * (m3 + m4 * factor2_p), v14 = v6 * (m3 + m4 * factor2_m),
        v15 = w3_p * (m3 * v5),
        angle3 = atan2_wide(-(factor2_p * (v11 - v15)), -(v13 + w3_p * (m3 * (Z1_3 * factor2_p)))),
        angle4 = atan2_wide(-(factor2_p * (v11 + v15)), -(v13 + w3_p * (m3 * (-Z1_3 * factor2_p)))),
        angle5 = atan2_wide(-(factor2_m * (v12 - w3_m * (m3 * v6))), -(v14 + w3_m * (m3 * (Z1_3 *
            factor2_m)))),
        angle6 = atan2_wide(-(factor2_m * (v12 - w3_m * (m3 * -v6))), -(v14 + w3_m * (m3 * (-Z1_3 *
            factor2_m))));

    /* theta4 */
    const wide v16 = m5 * Z1_3, v17 = m6 - m7 * factor2_p, v18 = m6 - m7 * factor2_m,
        v19 = m8 * factor2_p - m5, v20 = m8 * factor2_m - m5, v21 = Z1_3 * v17 + v5 * v19,
        v22 = Z1_3 * v18 + v6 * v20, v23 = w3_p * (factor2_p * (v16 + m6 * v5)), c23_pp = v21 + v23,
        c23_pm = v21 - v23, v24 = w3_m * (factor2_m * (v16 + m6 * v6)), c23_mp = v22 + v24,
        c23_mm = v22 - v24, v25 = m6 * Z1_3, v26 = v25 - m5 * v5, v27 = v25 - m5 * v6,
        v28 = Z1_3 * v19 + v5 * -v17, v29 = Z1_3 * v20 + v6 * -v18,
        s23_pp = v28 + w3_p * (factor2_p * v26), s23_pm = v28 + w3_p * (factor2_p * -v26),
        s23_mp = v29 + w3_m * (factor2_m * v27), s23_mm = v29 + w3_m * (factor2_m * -v27),
        v30 = T23 * s1_p - T13 * v2, v31 = T23 * s1_m - T13 * v3,
        X4_pp = c23_pp * v30 - T33 * s23_pp, X4_pm = c23_pm * v30 - T33 * s23_pm,
        X4_mp = c23_mp * v31 - T33 * s23_mp, X4_mm = c23_mm * v31 - T33 * s23_mm,
        Y4_p = T13 * s1_p + T23 * v2, Y4_m = T13 * s1_m + T23 * v3, v32 = Y4_p * Y4_p,
        v33 = Y4_m * Y4_m, v34 = v32 + X4_pp * X4_pp, v35 = v32 + X4_pm * X4_pm,
        v36 = v33 + X4_mp * X4_mp, v37 = v33 + X4_mm * X4_mm, angle7 = atan2_wide(Y4_p, -X4_pp),
        angle8 = atan2_wide(Y4_p, -X4_pm), angle9 = atan2_wide(Y4_m, -X4_mp),
        angle10 = atan2_wide(Y4_m, -X4_mm), v38 = signed_wide(half_turn, Y4_p),
        v39 = signed_wide(half_turn, Y4_m);

    /* theta5 */
    const wide angle11 = atan2_wide(-sqrt_wide(v34), T33 * c23_pp + s23_pp * v30),
        angle12 = atan2_wide(-sqrt_wide(v35), T33 * c23_pm + s23_pm * v30),
        angle13 = atan2_wide(-sqrt_wide(v36), T33 * c23_mp + s23_mp * v31),
        angle14 = atan2_wide(-sqrt_wide(v37), T33 * c23_mm + s23_mm * v31);

    /* theta6 */
    const wide v40 = s1_p * T12 + v2 * T22, v41 = s1_m * T12 + v3 * T22,
        v42 = s1_p * T22 - v2 * T12, v43 = s1_m * T22 - v3 * T12, v44 = s1_p * T11 + v2 * T21,
        v45 = s1_m * T11 + v3 * T21, v46 = s1_p * T21 - v2 * T11, v47 = s1_m * T21 - v3 * T11,
        angle15 = atan2_wide(-(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp * T31)), -(-X4_pp * v40
            + Y4_p * (c23_pp * v42 - s23_pp * T32))),
        angle16 = atan2_wide(-(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm * T31)), -(-X4_pm * v40
            + Y4_p * (c23_pm * v42 - s23_pm * T32))),
        angle17 = atan2_wide(-(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp * T31)), -(-X4_mp * v41
            + Y4_m * (c23_mp * v43 - s23_mp * T32))),
        angle18 = atan2_wide(-(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm * T31)), -(-X4_mm * v41
            + Y4_m * (c23_mm * v43 - s23_mm * T32)));

    /* joint values */
    const wide q3_ppp = lowered_wide(q3__pp), q3_pmp = only_wide(half_turn < -v9, -turn) - v9,
        q3_mpp = lowered_wide(q3__mp), q3_mmp = only_wide(half_turn < -v10, -turn) - v10,
        angle19 = atan2_wide(s1_p, -v2), q1_ppp = angle19 + (w3_p - w3_p),
        angle20 = atan2_wide(s1_m, -v3), q1_mpp = angle20 + (w3_m - w3_m);

    q[0] = q1_ppp; q[1] = angle3; q[2] = q3_ppp; q[3] = angle7; q[4] = angle11; q[5] = angle15;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_ppp; q[7] = angle3; q[8] = q3_ppp; q[9] = angle7 - v38; q[10] = -angle11;
    q[11] = angle15 - signed_wide(half_turn, -(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp *
        T31)));
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_ppp; q[13] = angle4; q[14] = q3_pmp; q[15] = angle8; q[16] = angle12;
    q[17] = angle16;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_ppp; q[19] = angle4; q[20] = q3_pmp; q[21] = angle8 - v38; q[22] = -angle12;
    q[23] = angle16 - signed_wide(half_turn, -(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm *
        T31)));
    kind[3] = kind_of(q[18], 0);
    q[24] = q1_mpp; q[25] = angle5; q[26] = q3_mpp; q[27] = angle9; q[28] = angle13;
    q[29] = angle17;
    kind[4] = kind_of(q[24], 0);
    q[30] = q1_mpp; q[31] = angle5; q[32] = q3_mpp; q[33] = angle9 - v39; q[34] = -angle13;
    q[35] = angle17 - signed_wide(half_turn, -(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp *
        T31)));
    kind[5] = kind_of(q[30], 0);
    q[36] = q1_mpp; q[37] = angle6; q[38] = q3_mmp; q[39] = angle10; q[40] = angle14;
    q[41] = angle18;
    kind[6] = kind_of(q[36], 0);
    q[42] = q1_mpp; q[43] = angle6; q[44] = q3_mmp; q[45] = angle10 - v39; q[46] = -angle14;
    q[47] = angle18 - signed_wide(half_turn, -(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm *
        T31)));
    kind[7] = kind_of(q[42], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((v37 <= m9) | (v36 <= m9) | (v35 <= m9) | (v34 <= m9) | (abs_wide(D3_m *
        v8) <= m2) | (abs_wide(D1) <= m1) | (abs_wide(D3_p * v8) <= m2));
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
    const double wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, N1 = wx * wx + Y1 * Y1, D1 = N1 - k2,
        w1 = sqrt(D1), inverse1 = 1.0 / N1, v1 = inverse1 * (k1 * Y1);
    const four v2 = v1 + w1 * (inverse1 * (e1 * wx));
    const double v3 = inverse1 * (k1 * wx);
    const four s1 = w1 * (inverse1 * (e1 * Y1)) - v3;

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1;
    const four v4 = a1 + e1 * w1;
    const double v5 = Z1_3 * Z1_3;
    const four N3 = v5 + v4 * v4, D3 = (longest3 - N3) * (N3 - shortest3);
    const double v6 = k5 * w1;
    const four w3 = sqrt_four(D3);

    /* theta2 */
    const four v7 = Z1_3 * (m4 + m3 * N3), v8 = e2 * Z1_3, factor2 = 1.0 / N3,
        v9 = v4 * (m3 + m4 * factor2);

    /* theta4 */
    const double v10 = m5 * Z1_3;
    const four v11 = v10 + m6 * v4, v12 = m6 - m7 * factor2, v13 = m8 * factor2 - m5,
        v14 = Z1_3 * v12 + v4 * v13, c23 = v14 + w3 * (factor2 * (e2 * v11));
    const double v15 = m6 * Z1_3;
    const four v16 = v15 - m5 * v4, v17 = Z1_3 * v13 + v4 * -v12,
        s23 = v17 + w3 * (factor2 * (e2 * v16)), v18 = T23 * s1 - T13 * v2,
        X4 = c23 * v18 - T33 * s23, Y4 = T13 * s1 + T23 * v2, v19 = Y4 * Y4, v20 = v19 + X4 * X4,
        v21 = signed_four(half_turn, Y4);

    /* theta6 */
    const four v22 = s1 * T12 + v2 * T22, v23 = s1 * T22 - v2 * T12, v24 = s1 * T11 + v2 * T21,
        v25 = s1 * T21 - v2 * T11;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | (abs_four(D3 * v6) <= m2) | (v20 <= m9))
        | (unsigned)(fabs(D1) <= m1))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(w3, s1, 0, 5, 2, 7), shuffle(N3 - k8, -v2, 0, 5, 2,
        7)),
        ratio2 = ratio_four(-(factor2 * (v7 - w3 * (m3 * (e2 * v4)))), -(v9 + w3 * (m3 * (v8 *
            factor2)))), ratio3 = ratio_four(Y4, -X4),
        ratio4 = ratio_four(-(-X4 * v24 + Y4 * (c23 * v25 - s23 * T31)), -(-X4 * v22 + Y4 * (c23 *
            v23 - s23 * T32))), ratio5 = ratio_four(-sqrt_four(v20), T33 * c23 + s23 * v18);
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle6 = shuffle(packed1, packed1, 1, 1, 3, 3), angle2 = angle_four(ratio2),
        angle3 = angle_four(ratio3), angle5 = angle_four(ratio4), angle4 = angle_four(ratio5);
    const four q3_ = e2 * angle1 - turn1, q4_m = angle3 - v21,
        q6_m = angle5 - signed_four(half_turn, -(-X4 * v24 + Y4 * (c23 * v25 - s23 * T31))),
        q3_p = lowered_four(q3_), q1_p = angle6 + (w3 - w3);

    store_4(&q[0][0], &q[2][0], &q[4][0], &q[6][0], q1_p, angle2, q3_p, angle3);
    store_2(&q[0][4], &q[2][4], &q[4][4], &q[6][4], angle4, angle5);
    store_4(&q[1][0], &q[3][0], &q[5][0], &q[7][0], q1_p, angle2, q3_p, q4_m);
    store_2(&q[1][4], &q[3][4], &q[5][4], &q[7][4], -angle4, q6_m);
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
    const double N1 = wx * wx + Y1 * Y1;
    const int free1 = N1 <= free_limit_squared2;
    const double D1 = N1 - k2;
    const int apart1 = k4 < D1;
    if (!(-k3 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : k1 * sqrt(N1)));
    const double v1 = wx * k1, v2 = Y1 * k1;

    /* theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v4 = Z1_3 * Z1_3, v5 = free1 ? 1.0 : (apart1 ? w1 : least_root1) * k5;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : -(inverse1 * (v2 + wx * root1)),
            s1 = free1 ? sin(seed[0]) : inverse1 * (Y1 * root1 - v1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v3 = root1 + a1;
        const double N3 = v4 + v3 * v3;
        const double K3 = N3 - k8;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= D3 * v5)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v6 = k6 * K3, v7 = k7 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v9 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v10 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v11 = T12 * s1 - T22 * c1, v12 = T12 * c1 + T22 * s1,
            v14 = T11 * s1 - T21 * c1, v15 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double root3 = w3 * e2;
            const double s3 = (v6 + k7 * root3) * k9, c3 = k9 * (v7 - k6 * root3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4] */
            const double X1_2 = d4 * c3 - a3 * s3;
            const double Y1_2 = a2 + (a3 * c3 + d4 * s3);
            const double v8 = v3 * X1_2 + Z1_3 * Y1_2;
            const double C2 = Z1_3 * X1_2 - v3 * Y1_2;
            const double w2 = sqrt(v8 * v8 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : -(v8 * factor2);
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2;
            const double X4 = c23 * v9 - T33 * s23;
            const double w4 = sqrt(X4 * X4 + v10);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c23 + s23 * v9;

            /* theta6 */
            const double v13 = c23 * v12 - T32 * s23, v16 = c23 * v15 - T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e3 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e3 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e3), c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v14 + s4 * v16), -(c4 * v11 + s4 * v13));
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
static const double weights[6] = { 0.5618, 0.5618, 0.5618, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    spherical_wrist_all_offsets_fk(x, P);
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
    spherical_wrist_all_offsets_jacobian(x, J);
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

/* Leads rows of nested roots to solutions, ends those that rounding alone tells from earlier ones:
 * half way the arm is singular. */
static void tell_once(const double T[16], double q[8][6], unsigned char status[8])
{
    const int held[6] = { 0 };
    for (int n = 0; n < 8 * 8; n++) {
        double half[6], e[6], *row = q[n / 8];
        const int k = n % 8;
        int ends = k == 0 && off_pose(T, row, e) > 1e-11 && !settle(T, 1e-12, 0.15, row);
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

int spherical_wrist_all_offsets_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int spherical_wrist_all_offsets_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = spherical_wrist_all_offsets_ik(T, q_seed, all, status) >= 0;
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

void spherical_wrist_all_offsets_ik_batch(
    size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 48 * k, status + 8 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)spherical_wrist_all_offsets_ik(
                    T + 16 * i, NULL, (double (*)[6])(q + 48 * i), status + 8 * i);
    }
#endif
    for (; k < n; k++)
        (void)spherical_wrist_all_offsets_ik(
            T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
