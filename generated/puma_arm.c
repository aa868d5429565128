/* puma_arm: PUMA 560 to its wrist centre
 *
 * Inverse kinematics, generated from robots/puma_arm.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma_arm.yaml. The formulas and where they come from: puma_arm.md.
 */
#include "puma_arm.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = PUMA_ARM_OK, NONE = PUMA_ARM_UNREACHABLE, FREE = PUMA_ARM_FREE_JOINT,
    OUT = PUMA_ARM_OUT_OF_LIMITS, INVALID = PUMA_ARM_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

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

#ifndef PUMA_ARM_LIBM
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
 * -DPUMA_ARM_SCALAR. With -DPUMA_ARM_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(PUMA_ARM_SCALAR) && !defined(PUMA_ARM_LIBM)
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
#ifdef PUMA_ARM_LIBM /* half the time of atan2 */
HELPER double atan2_wide(double y, double x)
{
    return atan(y / x) + copysign(1.5707963267948966 - copysign(1.5707963267948966, x), y);
}
#else
ARCTANGENT(wide)
#endif

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16])
{
    return 0.0 * (T[3] + T[7] + T[11]);
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
    return all_four(0.0 * (T[3] + T[7] + T[11]));
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


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.67183, /* joint offset 1 [m] */
    a2 = 0.4318, /* link length 2 [m] */
    d3 = 0.15005, /* joint offset 3 [m] */
    a3 = 0.0203, /* link length 3 [m] */
    d4 = 0.4318, /* z of the tool frame [m] */
    free_limit_squared2 = 2.9096854084e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 5.394149987162018e-07, /* a root of nothing, by rounding [m] */
    longest3 = 0.7466289125534531, /* square of the longest reach [m^2] */
    shortest3 = 2.274465470660925e-07, /* square of the shortest reach [m^2] */
    boundary3 = 2.1999652436149993e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.7466289125534236, /* the longest, where branches merge [m^2] */
    shortest3_apart = 2.2744654708236271e-07, /* the shortest, where branches merge [m^2] */
    k1 = 0.022515002499999996, /* d3^2 [m^2] */
    k2 = 5.11904578000291e-14, /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
    k3 = 5.1190457800002905e-15, /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
    k4 = 0.5862420710759887, /* 1 / arm_size1 [m^-1] */
    k5 = 0.37290248000000004, /* 2 * d4 * a2 [m^2] */
    k6 = 0.01753108, /* 2 * a3 * a2 [m^2] */
    k7 = 0.37331457, /* d4 * a2 + (a3^2 + d4 * a2) [m^2] */
    k8 = 7.175474885806929, /* 1 / (k5^2 + k6^2) [m^-4] */
    turn1 = 1.5238184104468135, /* a constant angle [rad] */
    m1 = 5.119045780000291e-12, /* 1000 * k3 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 2.2049387897563516e-11;
/* coefficients */
static const double m3 = 1.1579434923575729, m4 = 0.000477176933765627;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T14 = T[3]; \
    const number T24 = T[7]; \
    const number T34 = T[11]

const char *const puma_arm_branches[4] = {
    "left-down", "left-up", "right-down", "right-up",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void puma_arm_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3;
    T[0] = x3_x; T[1] = -s1; T[2] = -v3; T[3] = x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4;
    T[4] = x3_y; T[5] = c1; T[6] = -v4; T[7] = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4;
    T[8] = x3_z; T[9] = 0.0; T[10] = z3_z; T[11] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma_arm_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]),
        J21 = p2_x + (x2_x * c3 - v1 * s3) * a3 + s1 * d3 - (v1 * c3 + x2_x * s3) * d4,
        v3 = p2_y + (x2_y * c3 - v2 * s3) * a3 - c1 * d3 - (v2 * c3 + x2_y * s3) * d4,
        v4 = p2_z + (s2 * c3 + c2 * s3) * a3 + (c2 * c3 - s2 * s3) * d4, v5 = v4 - d1,
        v6 = v4 - p2_z;
    J[0] = -v3; J[1] = -(c1 * v5); J[2] = -(c1 * v6);
    J[3] = J21; J[4] = -(s1 * v5); J[5] = -(s1 * v6);
    J[6] = 0.0; J[7] = s1 * v3 + c1 * J21; J[8] = s1 * (v3 - p2_y) + c1 * (J21 - p2_x);
    J[9] = 0.0; J[10] = s1; J[11] = s1;
    J[12] = 0.0; J[13] = -c1; J[14] = -c1;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
}

/* Copies a pose. Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    return 1;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[12], wide_mask kind[4])
{
    ENTRIES(wide);

    /* theta1 */
    const wide D1 = T14 * T14 + T24 * T24 - k1, w1 = sqrt_wide(D1), v1 = w1 - w1, v2 = d3 * T14,
        v3 = d3 * T24, v4 = T14 * w1, v5 = T24 * w1;

    /* theta3 */
    const wide Z1_3 = T34 - d1, N3 = D1 + Z1_3 * Z1_3, D3 = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt_wide(D3), v6 = w3 - w3, angle1 = atan2_wide(w3, N3 - k7), q3__p = angle1 - turn1,
        v7 = turn1 + angle1;

    /* theta2 */
    const wide X1_2 = m3 * N3 - m4, v8 = Z1_3 * X1_2, v9 = w3 * (m3 * Z1_3),
        v10 = w3 * (m3 * -Z1_3), v11 = w1 * X1_2, v12 = w1 * -X1_2, v13 = w3 * (m3 * w1),
        v14 = v8 - v13, v15 = v8 + v13;

    /* joint values */
    const wide angle6 = atan2_wide(v2 + v5, v4 - v3), q1_pp = v6 + angle6,
        angle7 = atan2_wide(v2 - v5, -(v3 + v4)), q1_mp = v6 + angle7,
        q3_pp = v1 + raised_wide(q3__p), q3_pm = v1 + (only_wide(-v7 <= -half_turn, turn) - v7);

    q[0] = q1_pp; q[1] = atan2_wide(v14, v9 + v11); q[2] = q3_pp;
    kind[0] = kind_of(q[0], 0);
    q[3] = q1_pp; q[4] = atan2_wide(v15, v10 + v11); q[5] = q3_pm;
    kind[1] = kind_of(q[3], 0);
    q[6] = q1_mp; q[7] = atan2_wide(v15, v9 + v12); q[8] = q3_pp;
    kind[2] = kind_of(q[6], 0);
    q[9] = q1_mp; q[10] = atan2_wide(v14, v10 + v12); q[11] = q3_pm;
    kind[3] = kind_of(q[9], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((abs_wide(D1) <= m1) | (abs_wide(D3 * (k4 * w1)) <= m2));
}

#if LANES > 1
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[4][3], unsigned char status[4])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double D1 = T14 * T14 + T24 * T24 - k1, w1 = sqrt(D1), v1 = w1 - w1, v2 = d3 * T14,
        v3 = d3 * T24, v4 = T14 * w1, v5 = T24 * w1;

    /* theta3 */
    const double Z1_3 = T34 - d1, N3 = D1 + Z1_3 * Z1_3, D3 = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt(D3), v6 = w3 - w3;

    /* theta2 */
    const double X1_2 = m3 * N3 - m4, v7 = Z1_3 * X1_2;
    const four v8 = w3 * (m3 * (e2 * Z1_3)), v9 = w1 * (e1 * X1_2);

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0)) | (unsigned)((fabs(D1) <= m1) | (fabs(D3 *
        (k4 * w1)) <= m2)))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(v2 + e1 * v5, all_four(w3), 0, 5, 2, 3), shuffle(e1
        * v4 - v3, all_four(N3 - k7), 0, 5, 2, 3)),
        ratio2 = ratio_four(v7 - w3 * (m3 * (w1 * (e1 * e2))), v8 + v9);
    const four packed1 = angle_four(ratio1), angle3 = shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = shuffle(packed1, packed1, 1, 1, 1, 1), angle2 = angle_four(ratio2);
    const four q3_ = e2 * angle1 - turn1, q1 = v6 + angle3, q3 = v1 + raised_four(q3_);

    store_2(&q[0][0], &q[1][0], &q[2][0], &q[3][0], q1, angle2);
    store_1(&q[0][2], &q[1][2], &q[2][2], &q[3][2], q3);
    const unsigned long long none1 = (bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[12], x[LANES];
    wide_mask kind[4];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 12; i += LANES) {
        const int from = i + LANES <= 12 ? i : 12 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 12 * k + from) = x[k];
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
HELPER int solve_regular(const double T[16], double q[4][3], unsigned char status[4])
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
    const double T[16], const double seed[3], double q[4][3], unsigned char status[4])
{
    ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double N1 = T14 * T14 + T24 * T24;
    const int free1 = N1 <= free_limit_squared2;
    const double D1 = N1 - k1;
    const int apart1 = k3 < D1;
    if (!(-k2 <= D1)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1 : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : d3 * sqrt(N1)));
    const double v1 = T14 * d3, v2 = T24 * d3;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - d1;
    const double v3 = Z1_3 * Z1_3, v4 = free1 ? 1.0 : (apart1 ? w1 : least_root1) * k4;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double root1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (T14 * root1 - v2),
            s1 = free1 ? sin(seed[0]) : inverse1 * (v1 + T24 * root1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double N3 = v3 + root1 * root1;
        const double K3 = N3 - k7;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= D3 * v4)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double v5 = k5 * K3, v6 = k6 * K3;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && !apart3) continue; /* both signs give the same */
            const double root3 = w3 * e2;
            const double s3 = (k6 * root3 - v5) * k8, c3 = k8 * (v6 + k5 * root3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + (a3 * c3 - d4 * s3);
            const double Y1_2 = d4 * c3 + a3 * s3;
            const double S2 = Z1_3 * X1_2 - root1 * Y1_2;
            const double C2 = root1 * X1_2 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
            status[row] = (free1 || free2) ? FREE : OK;
        }
    }
}

static void take(const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
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
static const double weights[6] = { 0.5862, 0.5862, 0.5862, 0.0, 0.0, 0.0 };
/* What a step of one means for joints; none if given. */
static const double pace[3] = { 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[3], double e[6])
{
    double P[16], square = 0.0;
    puma_arm_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[3], double damping, double e[6], double x[3])
{
    double A[6][9] = { { 0.0 } }, square[6] = { 0.0 }, J[18];
    puma_arm_jacobian(x, J);
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

/* Leads rows of nested roots to solutions, ends those that rounding alone tells from earlier ones:
 * half way the arm is singular. */
static void tell_once(const double T[16], double q[4][3], unsigned char status[4])
{
    const int held[3] = { 0 };
    for (int n = 0; n < 4 * 4; n++) {
        double half[3], e[6], *row = q[n / 4];
        const int k = n % 4;
        int ends = k == 0 && off_pose(T, row, e) > 1e-11 && !settle(T, 1e-12, 0.15, row);
        if (0 < k && k <= n / 4 && half_way(q[k - 1], row, half) < 0.001 && !isnan(half[0])) {
            for (int i = 0; i < 3; i++) {
                off_pose(T, half, e);
                add_step(held, 1e-13, e, half);
            }
            ends = off_pose(T, half, e) <= 1e-14;
        }
        for (int i = 0; i < 3 && ends; i++) {
            status[n / 4] = NONE;
            row[i] = NAN;
        }
    }
}

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const double T[16], const double seed[3], double q[4][3],
    unsigned char status[4])
{
    double x[3], half[3], e[6], least = HUGE_VAL, nearest = 0.001;
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
    const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    const double zeros[3] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 3; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 4; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    tell_once(pose, q, status);
    stay(pose, seed, q, status);
    for (int row = 0; row < 4; row++) {
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

int puma_arm_ik(const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int puma_arm_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[4][3], found[3], least = HUGE_VAL;
    unsigned char status[4];
    int result = -NONE;
    int valid = puma_arm_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 3; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 4 && valid; row++) {
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

void puma_arm_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 12 * k, status + 4 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)puma_arm_ik(T + 16 * i, NULL, (double (*)[3])(q + 12 * i), status + 4 * i);
    }
#endif
    for (; k < n; k++)
        (void)puma_arm_ik(T + 16 * k, NULL, (double (*)[3])(q + 12 * k), status + 4 * k);
}
