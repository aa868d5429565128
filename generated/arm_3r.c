/* arm_3r: Arm with three revolute joints, to its wrist centre
 *
 * Inverse kinematics, generated from robots/arm_3r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/arm_3r.yaml. The formulas and where they come from: arm_3r.md.
 */
#include "arm_3r.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = ARM_3R_OK, NONE = ARM_3R_UNREACHABLE, FREE = ARM_3R_FREE_JOINT,
    OUT = ARM_3R_OUT_OF_LIMITS, INVALID = ARM_3R_INVALID_POSE
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

#ifndef ARM_3R_LIBM
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
 * -DARM_3R_SCALAR. With -DARM_3R_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(ARM_3R_SCALAR) && !defined(ARM_3R_LIBM)
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
#ifdef ARM_3R_LIBM /* half the time of atan2 */
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


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    d1 = 0.4, /* joint offset 1 [m] */
    a2 = 0.4, /* link length 2 [m] */
    d4 = 0.35, /* z of the tool frame [m] */
    free_limit1 = 1.15e-12, /* a length that fixes no angle [m] */
    longest3 = 0.5625, /* square of the longest reach [m^2] */
    shortest3 = 0.0025000000000000044, /* square of the shortest reach [m^2] */
    longest3_reach = 0.5625000000001725, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0024999999999885045, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.5624999999999827, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.002500000000001154, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 1.3224999999999997e-24, /* square of a length that fixes no angle [m^2] */
    k1 = 0.27999999999999997, /* 2 * d4 * a2 [m^2] */
    k2 = 0.28250000000000003, /* a2^2 + d4^2 [m^2] */
    k3 = 12.755102040816327, /* 1 / (k1^2) [m^-4] */
    m1 = 1.3224999999999998e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 9.698908343125067e-12,
    m6 = 1.749006249999999e-16; /* doubt_limit_squared2^2 [m^4] */
/* coefficients */
static const double m4 = 1.2499999999999998, m5 = 0.04687500000000003;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T14 = T[3]; \
    const number T24 = T[7]; \
    const number T34 = T[11]

const char *const arm_3r_branches[4] = {
    "left-down", "left-up", "right-down", "right-up",
};

static const double lowest[3] = { -INFINITY, -INFINITY, -INFINITY };
static const double highest[3] = { INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void arm_3r_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), v3 = v1 * c3 + x2_x * s3, v4 = v2 * c3 + x2_y * s3,
        z3_z = s2 * s3 - c2 * c3;
    T[0] = x2_x * c3 - v1 * s3; T[1] = s1; T[2] = -v3; T[3] = x2_x * a2 - v3 * d4;
    T[4] = x2_y * c3 - v2 * s3; T[5] = -c1; T[6] = -v4; T[7] = x2_y * a2 - v4 * d4;
    T[8] = -(s2 * c3 + c2 * s3); T[9] = 0.0; T[10] = z3_z; T[11] = d1 - s2 * a2 + z3_z * d4;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void arm_3r_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, p2_x = x2_x * a2,
        p2_y = x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), J21 = p2_x - (c1 * s2 * c3 + x2_x * s3) * d4,
        v1 = p2_y - (s1 * s2 * c3 + x2_y * s3) * d4, v2 = p2_z + (s2 * s3 - c2 * c3) * d4,
        v3 = v2 - d1, v4 = v2 - p2_z;
    J[0] = -v1; J[1] = c1 * v3; J[2] = c1 * v4;
    J[3] = J21; J[4] = s1 * v3; J[5] = s1 * v4;
    J[6] = 0.0; J[7] = -(s1 * v1 + c1 * J21); J[8] = -(s1 * (v1 - p2_y) + c1 * (J21 - p2_x));
    J[9] = 0.0; J[10] = -s1; J[11] = -s1;
    J[12] = 0.0; J[13] = c1; J[14] = c1;
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
    const wide v1 = T14 * T14 + T24 * T24, w1 = sqrt_wide(v1), angle1 = atan2_wide(-T24, -T14);

    /* theta3 */
    const wide Z1_3 = T34 - d1, N3 = v1 + Z1_3 * Z1_3, D3 = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt_wide(D3), v2 = w3 - w3, angle2 = atan2_wide(-(k1 * (N3 - k2)), k1 * w3),
        q3_pm = signed_wide(half_turn, -(k1 * (N3 - k2))) - angle2;

    /* theta2 */
    const wide v3 = m5 + m4 * N3, v4 = Z1_3 * v3, v5 = w3 * (m4 * w1), S2_pp = v5 - v4,
        v6 = v4 + v5, v7 = w3 * (m4 * Z1_3), v8 = w3 * (m4 * -Z1_3), v9 = w1 * v3, v10 = v7 + v9,
        v11 = v8 + v9, v12 = v7 - v9, v13 = v8 - v9, v14 = S2_pp * S2_pp, v15 = v6 * v6;

    /* joint values */
    const wide q1_pp = angle1 + v2, q1_mp = v2 + (angle1 - signed_wide(half_turn, -T24));

    q[0] = q1_pp; q[1] = atan2_wide(S2_pp, -v10); q[2] = angle2;
    kind[0] = kind_of(q[0], 0);
    q[3] = q1_pp; q[4] = atan2_wide(-v6, -v11); q[5] = q3_pm;
    kind[1] = kind_of(q[3], 0);
    q[6] = q1_mp; q[7] = atan2_wide(-v6, -v12); q[8] = angle2;
    kind[2] = kind_of(q[6], 0);
    q[9] = q1_mp; q[10] = atan2_wide(S2_pp, -v13); q[11] = q3_pm;
    kind[3] = kind_of(q[9], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((abs_wide(D3) <= m3) | (v1 <= m1) | (v14 + v13 * v13 <= m6) | (v15 + v12
        * v12 <= m6) | (v14 + v10 * v10 <= m6) | (v15 + v11 * v11 <= m6));
}

#if LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[4][3], unsigned char status[4])
{
    const four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double v1 = T14 * T14 + T24 * T24, w1 = sqrt(v1), v2 = copysign(half_turn, -T24);

    /* theta3 */
    const double Z1_3 = T34 - d1, N3 = v1 + Z1_3 * Z1_3, D3 = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt(D3), v3 = w3 - w3, v4 = copysign(half_turn, -(k1 * (N3 - k2)));

    /* theta2 */
    const double v5 = m5 + m4 * N3, v6 = Z1_3 * v5;
    const four S2 = w3 * (m4 * (w1 * (e1 * e2))) - v6, v7 = w3 * (m4 * (e2 * Z1_3)),
        v8 = w1 * (e1 * v5), v9 = v7 + v8;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | (S2 * S2 + v9 * v9 <= m6)) |
        (unsigned)((v1 <= m1) | (fabs(D3) <= m3)))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ -T24, -(k1 * (N3 - k2)), -T24, -T24 }, (four){
        -T14, k1 * w3, -T14, -T14 }), ratio2 = ratio_four(S2, -v9);
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = angle_four(ratio2);
    const four q3 = e2 * angle2 + v4 * (m2 * (1.0 - e2)),
        q1 = v3 + (angle1 + v2 * (m2 * (e1 - 1.0)));

    store_2(&q[0][0], &q[1][0], &q[2][0], &q[3][0], q1, angle3);
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
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - d1;
    const double v1 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(T14 * factor1),
            s1 = free1 ? sin(seed[0]) : -(T24 * factor1);
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

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + d4 * v2;
        const double v4 = Z1_3 * Y1_2, v5 = root1 * Y1_2;

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
static const double weights[6] = { 0.8696, 0.8696, 0.8696, 0.0, 0.0, 0.0 };
/* What a step of one means for joints; none if given. */
static const double pace[3] = { 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[3], double e[6])
{
    double P[16], square = 0.0;
    arm_3r_fk(x, P);
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
    arm_3r_jacobian(x, J);
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

int arm_3r_ik(const double T[16], const double *q_seed, double q[4][3], unsigned char status[4])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int arm_3r_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[4][3], found[3], least = HUGE_VAL;
    unsigned char status[4];
    int result = -NONE;
    int valid = arm_3r_ik(T, q_seed, all, status) >= 0;
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

void arm_3r_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 12 * k, status + 4 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)arm_3r_ik(T + 16 * i, NULL, (double (*)[3])(q + 12 * i), status + 4 * i);
    }
#endif
    for (; k < n; k++)
        (void)arm_3r_ik(T + 16 * k, NULL, (double (*)[3])(q + 12 * k), status + 4 * k);
}
