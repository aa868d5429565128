/* ur5_f32: Universal Robots UR5
 *
 * Inverse kinematics, generated from robots/ur5.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/ur5.yaml. The formulas and where they come from: ur5.md.
 */
#include "ur5_f32.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = UR5_F32_OK, NONE = UR5_F32_UNREACHABLE, FREE = UR5_F32_FREE_JOINT,
    OUT = UR5_F32_OUT_OF_LIMITS, INVALID = UR5_F32_INVALID_POSE
};

static const float turn = 6.2831855f;
#define half_turn (0.5f * turn)

/* The angle moved by whole turns to (-pi, pi]. */
static float wrap(float angle)
{
    return angle - turn * ceilf(angle / turn - 0.5f);
}

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
#define MISFIT(name, number) \
static inline number misfit_##name(const number T[16]) \
{ \
    const number x0 = T[0], x1 = T[1], x2 = T[2]; \
    const number y0 = T[4], y1 = T[5], y2 = T[6]; \
    const number xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0f; \
    const number yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0f; \
    const number xy = x0 * y0 + x1 * y1 + x2 * y2; \
    const number zx = x1 * y2 - x2 * y1 - T[8]; \
    const number zy = x2 * y0 - x0 * y2 - T[9]; \
    const number zz = x0 * y1 - x1 * y0 - T[10]; \
    return xx * xx + yy * yy + 2.0f * xy * xy + zx * zx + zy * zy + zz * zz; \
}
MISFIT(one, float)

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

#ifndef UR5_F32_LIBM
/* atan r = r + r^3 (odd[0] + odd[1] r^2 + ...) for |r| up to tan(pi/8) */
static const float odd[11] = {
    -0.33333334f, 0.2f, -0.14285715f, 0.11111111f,
    -0.09090905f, 0.07692183f, -0.0666451f, 0.058581363f,
    -0.050853834f, 0.039229743f, -0.019174544f,
};

/* The angle of y and x, not both zero and not infinite, in [-pi, pi], within 3 ulp: the multiple of
 * pi/4 next to it and a ratio of at most tan(pi/8), then a polynomial in this. In two steps: of
 * several angles all ratios come first. `added` is x + y where m holds, else x: for one pose, which
 * waits for its values, so that the sum doesn't wait for m. */
#define added_four(x, m, y) pick_four(m, (x) + (y), x)
#define added_wide(x, m, y) ((x) + only_wide(m, 1.0f) * (y))
#define ARCTANGENT(v) \
typedef struct { v r, known, y; } v##_ratio; \
HELPER v##_ratio ratio_##v(v y, v x) \
{ \
    const v ax = abs_##v(x), ay = abs_##v(y); \
    const v##_mask steep = ay > ax; \
    const v most = maximum_##v(ay, ax), least = minimum_##v(ax, ay); \
    const v##_mask turned = least > most * 0.41421357f; \
    const v ahead = all_##v(0.7853982f), half = all_##v(1.5707964f); \
    const v part = negated_##v(pick_##v(steep, -ahead, ahead), x); \
    const v whole = pick_##v(steep, half, half - 2.0f * part); \
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

#define LANES 1
typedef float wide;
typedef int wide_mask;
#define all_wide(x) (x)
#define where_all(truth) (-(truth))
#define pick_wide(m, yes, no) ((m) ? (yes) : (no))
#define only_wide(m, x) ((m) ? (x) : 0.0f)
#define copysign_wide copysignf
#define signed_wide copysignf
#define negated_wide(x, where) ((x) * copysignf(1.0f, where))
#define abs_wide fabsf
#define sqrt_wide sqrtf
#define maximum_wide maximum_double
#define minimum_wide minimum_double
#ifdef UR5_F32_LIBM /* half the time of atan2 */
HELPER float atan2_wide(float y, float x)
{
    return atanf(y / x) + copysignf(1.5707964f - copysignf(1.5707964f, x), y);
}
#else
ARCTANGENT(wide)
#endif

MISFIT(wide, wide)

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16])
{
    const wide w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0f;
    return misfit_wide(T) + w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3 + 0.0f * (T[3] + T[7] + T[11]);
}

/* An angle moved by a whole turn to (-pi, pi] if it is below, above, or either. */
#define TURNS(v) \
HELPER v centred_##v(v x) \
{ \
    return x + pick_##v(x <= -half_turn, all_##v(turn), only_##v(half_turn < x, -turn)); \
}

TURNS(wide)


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const float
    d1 = 0.089159f, /* joint offset 1 [m] */
    a2 = -0.425f, /* link length 2 [m] */
    a3 = -0.39225f, /* link length 3 [m] */
    d4 = 0.10915f, /* joint offset 4 [m] */
    d5 = 0.09465f, /* joint offset 5 [m] */
    d6 = 0.0823f, /* joint offset 6 [m] */
    free_limit_squared2 = 5.688311e-10f, /* square of a length that fixes no angle [m^2] */
    least_root1 = 0.002385018f, /* a root of nothing, by rounding [m] */
    free_limit = 2e-05f, /* a length that fixes no angle */
    near_limit = 0.001f, /* a length whose direction is good to few digits */
    longest3 = 0.6678976f, /* square of the longest reach [m^2] */
    shortest3 = 0.0010725625f, /* square of the shortest reach [m^2] */
    boundary3 = 5.1990596e-06f, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.66789734f, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0010725703f, /* the shortest, where branches merge [m^2] */
    longest3_clear = 0.6678781f, /* the longest, where blurred branches do [m^2] */
    shortest3_clear = 0.0010733437f, /* the shortest, where blurred branches do [m^2] */
    k1 = 0.011913722f, /* d4^2 [m^2] */
    k2 = 1.0413216e-06f, /* reach_slack1 * (2 * d4 + reach_slack1) [m^2] */
    k3 = 2.6032486e-08f, /* merge_slack1 * (2 * d4 + merge_slack1) [m^2] */
    k4 = 0.8385681f, /* 1 / arm_size1 [m^-1] */
    k5 = 0.33448505f, /* a2^2 + a3^2 [m^2] */
    k6 = 2.9992876f, /* 1 / (2 * a3 * a2) [m^-2] */
    m1 = 1e-06f, /* doubt_limit^2 */
    /* (longest3 - longest3_clear) * (longest3_clear - shortest3) [m^4] */
    m3 = 1.2996985e-05f;
/* coefficients */
static const float m4 = 1.1764706f, m5 = 0.03148816f;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const ur5_f32_branches[8] = {
    "left-noflip-down", "left-noflip-up", "left-flip-down", "left-flip-up", "right-noflip-down",
    "right-noflip-up", "right-flip-down", "right-flip-up",
};

static const float lowest[6] = {
    -6.2831855f, -6.2831855f, -6.2831855f, -6.2831855f,
    -6.2831855f, -6.2831855f,
};
static const float highest[6] = {
    6.2831855f, 6.2831855f, 6.2831855f, 6.2831855f, 6.2831855f,
    6.2831855f,
};
#define slack(joint) 2e-06f /* of limits */

void ur5_f32_fk(const float q[6], float T[16])
{
    const float c1 = cosf(q[0]), s1 = sinf(q[0]);
    const float c2 = cosf(q[1]), s2 = sinf(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const float c3 = cosf(q[2]), s3 = sinf(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3;
    const float c4 = cosf(q[3]), s4 = sinf(q[3]), x4_x = x3_x * c4 - v3 * s4,
        x4_y = x3_y * c4 - v4 * s4, x4_z = x3_z * c4 + y3_z * s4, z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, y5_z = y3_z * c4 - x3_z * s4;
    const float c5 = cosf(q[4]), s5 = sinf(q[4]), x5_x = x4_x * c5 + s1 * s5,
        x5_y = x4_y * c5 - c1 * s5, x5_z = x4_z * c5, z5_x = s1 * c5 - x4_x * s5,
        v5 = c1 * c5 + x4_y * s5, v6 = x4_z * s5;
    const float c6 = cosf(q[5]), s6 = sinf(q[5]);
    T[0] = x5_x * c6 - z4_x * s6; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = z5_x;
    T[3] = x2_x * a2 + x3_x * a3 + s1 * d4 + z4_x * d5 + z5_x * d6;
    T[4] = x5_y * c6 - z4_y * s6; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = -v5;
    T[7] = x2_y * a2 + x3_y * a3 - c1 * d4 + z4_y * d5 - v5 * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = -v6;
    T[11] = d1 + s2 * a2 + x3_z * a3 + -y5_z * d5 - v6 * d6;
    T[12] = T[13] = T[14] = 0.0f;
    T[15] = 1.0f;
}

void ur5_f32_jacobian(const float q[6], float J[36])
{
    const float c1 = cosf(q[0]), s1 = sinf(q[0]);
    const float c2 = cosf(q[1]), s2 = sinf(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const float c3 = cosf(q[2]), s3 = sinf(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3;
    const float c4 = cosf(q[3]), s4 = sinf(q[3]), z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, p4_x = p3_x + s1 * d4, p4_y = p3_y - c1 * d4,
        z4_z = x3_z * s4 - y3_z * c4;
    const float c5 = cosf(q[4]), s5 = sinf(q[4]), z5_x = s1 * c5 - (x3_x * c4 - v3 * s4) * s5,
        v5 = c1 * c5 + (x3_y * c4 - v4 * s4) * s5, v6 = (x3_z * c4 + y3_z * s4) * s5,
        p5_x = p4_x + z4_x * d5, p5_y = p4_y + z4_y * d5, p5_z = p3_z + z4_z * d5,
        p6_x = p5_x + z5_x * d6, p6_y = p5_y - v5 * d6, p6_z = p5_z - v6 * d6, v7 = p6_z - d1,
        v8 = p6_z - p2_z, v9 = p6_z - p3_z, v10 = p6_x - p4_x, v11 = p6_y - p4_y, v12 = p6_x - p5_x,
        v13 = p6_y - p5_y, v14 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(c1 * v7); J[2] = -(c1 * v8); J[3] = -(c1 * v9);
    J[4] = z4_y * v9 - z4_z * v11; J[5] = v6 * v13 - v5 * v14;
    J[6] = p6_x; J[7] = -(s1 * v7); J[8] = -(s1 * v8); J[9] = -(s1 * v9);
    J[10] = z4_z * v10 - z4_x * v9; J[11] = -(v6 * v12 + z5_x * v14);
    J[12] = 0.0f; J[13] = s1 * p6_y + c1 * p6_x; J[14] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x);
    J[15] = s1 * (p6_y - p3_y) + c1 * (p6_x - p3_x); J[16] = z4_x * v11 - z4_y * v10;
    J[17] = z5_x * v13 + v5 * v12;
    J[18] = 0.0f; J[19] = s1; J[20] = s1; J[21] = s1; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0f; J[25] = -c1; J[26] = -c1; J[27] = -c1; J[28] = z4_y; J[29] = -v5;
    J[30] = 1.0f; J[31] = 0.0f; J[32] = 0.0f; J[33] = 0.0f; J[34] = z4_z; J[35] = -v6;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(float T[16])
{
    float G[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[i][j] = (i == j ? 1.5f : 0.0f)
                - 0.5f * (T[i] * T[j] + T[4 + i] * T[4 + j] + T[8 + i] * T[8 + j]);
    for (float *row = T; row < T + 12; row += 4) {
        const float x = row[0], y = row[1], z = row[2];
        for (int j = 0; j < 3; j++)
            row[j] = x * G[0][j] + y * G[1][j] + z * G[2][j];
    }
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose, and 2 for what was rounded. */
static int read_pose(const float given[16], float T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    if (!(fabsf(T[12]) + fabsf(T[13]) + fabsf(T[14]) + fabsf(T[15] - 1.0f) <= 1e-06f))
        return 0;
    const float miss = misfit_one(T);
    if (!(miss <= 1e-09f))
        return 0;
    if (miss <= 1e-12f)
        return 1;
    straighten(T);
    straighten(T);
    return 2;
}

/* How far a joint value is beyond its limits, whole turns aside; negative below. */
static float overshoot(int joint, float value)
{
    const float low = lowest[joint], high = highest[joint];
    if (low <= value && value <= high)
        return 0.0f;
    const float gap = turn - (high - low), over = value - high;
    const float rest = over - turn * floorf(over / turn);
    const float off = rest >= gap ? 0.0f : rest <= gap - rest ? rest : rest - gap;
    return fabsf(off) <= 0.5f * slack(joint) ? 0.0f : off;
}

/* The same of a row. */
static float beyond_limits(const float values[6])
{
    float sum = 0.0f;
    for (int i = 0; i < 6; i++)
        sum += fabsf(overshoot(i, values[i]));
    return sum;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[48], wide_mask kind[8])
{
    ENTRIES(wide);

    /* theta1 */
    const wide X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy, D1 = N1 - k1,
        w1 = sqrt_wide(D1), v1 = k4 * w1, inverse1 = 1.0f / N1, v2 = inverse1 * (d4 * wy),
        v3 = v2 + w1 * (X1 * inverse1), v4 = v2 + w1 * (inverse1 * -X1), v5 = inverse1 * (d4 * X1),
        s1_p = w1 * (wy * inverse1) - v5, s1_m = w1 * (inverse1 * -wy) - v5,
        angle1 = atan2_wide(s1_p, -v3), angle2 = atan2_wide(s1_m, -v4);

    /* theta6 */
    const wide v6 = v3 * T21 + s1_p * T11, v7 = v4 * T21 + s1_m * T11, v8 = v3 * T22 + s1_p * T12,
        v9 = v4 * T22 + s1_m * T12, v10 = v6 * v6 + v8 * v8, v11 = v7 * v7 + v9 * v9,
        w6_p = sqrt_wide(v10), w6_m = sqrt_wide(v11), v12 = 1.0f / v10, v13 = 1.0f / v11,
        angle3 = atan2_wide(-v8, v6), angle4 = atan2_wide(-v9, v7);

    /* theta5 */
    const wide c5_p = T13 * s1_p + T23 * v3, c5_m = T13 * s1_m + T23 * v4,
        angle5 = atan2_wide(w6_p, c5_p), angle6 = atan2_wide(w6_m, c5_m);

    /* theta234 */
    const wide v14 = v12 * (v6 * T32 - v8 * T31), v15 = v13 * (v7 * T32 - v9 * T31),
        c234_p = w6_p * v14, c234_m = w6_m * v15, v16 = v12 * (c5_p * (v6 * T31 + v8 * T32)) - T33,
        v17 = v13 * (c5_m * (v7 * T31 + v9 * T32)) - T33, s234_p = w6_p * v16, s234_m = w6_m * v17,
        angle7 = atan2_wide(v16, v14), angle8 = atan2_wide(v17, v15),
        theta234_pm = angle7 - signed_wide(half_turn, v16),
        theta234_mm = angle8 - signed_wide(half_turn, v17);

    /* theta3 */
    const wide v18 = d6 * w6_p, v19 = d6 * w6_m, v20 = T34 - d1, v21 = d5 * c234_p,
        v22 = d5 * c234_m, v23 = s234_p * v18, v24 = s234_m * v19, Z1_3_pp = v20 + (v21 + v23),
        Z1_3_pm = v20 + (v23 - v21), Z1_3_mp = v20 + (v22 + v24), Z1_3_mm = v20 + (v24 - v22),
        v25 = T24 * s1_p - T14 * v3, v26 = T24 * s1_m - T14 * v4, v27 = c234_p * v18,
        v28 = c234_m * v19, v29 = d5 * s234_p, v30 = d5 * s234_m, Z2_3_pp = v25 + (v27 - v29),
        Z2_3_pm = v25 + (v27 + v29), Z2_3_mp = v26 + (v28 - v30), Z2_3_mm = v26 + (v28 + v30),
        N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp,
        N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm,
        N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp,
        N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm,
        D3_pp = (longest3 - N3_pp) * (N3_pp - shortest3),
        D3_pm = (longest3 - N3_pm) * (N3_pm - shortest3),
        D3_mp = (longest3 - N3_mp) * (N3_mp - shortest3),
        D3_mm = (longest3 - N3_mm) * (N3_mm - shortest3), w3_pp = sqrt_wide(D3_pp),
        w3_pm = sqrt_wide(D3_pm), w3_mp = sqrt_wide(D3_mp), w3_mm = sqrt_wide(D3_mm),
        v31 = w3_pp - w3_pp, v32 = w3_pm - w3_pm, v33 = w3_mp - w3_mp, v34 = w3_mm - w3_mm,
        angle9 = atan2_wide(w3_pp, N3_pp - k5), angle10 = atan2_wide(w3_pm, N3_pm - k5),
        angle11 = atan2_wide(w3_mp, N3_mp - k5), angle12 = atan2_wide(w3_mm, N3_mm - k5);

    /* theta2 */
    const wide v35 = m5 + m4 * N3_pp, v36 = m5 + m4 * N3_pm, v37 = m5 + m4 * N3_mp,
        v38 = m5 + m4 * N3_mm, v39 = Z1_3_pp * v35, v40 = Z1_3_pm * v36, v41 = Z1_3_mp * v37,
        v42 = Z1_3_mm * v38, v43 = Z2_3_pp * v35, v44 = Z2_3_pm * v36, v45 = Z2_3_mp * v37,
        v46 = Z2_3_mm * v38, v47 = w3_pp * (m4 * Z2_3_pp), v48 = w3_pp * (m4 * Z1_3_pp),
        angle13 = atan2_wide(v47 - v39, -(v43 + v48)),
        angle14 = atan2_wide(-(v39 + v47), v48 - v43), v49 = w3_pm * (m4 * Z2_3_pm),
        v50 = w3_pm * (m4 * Z1_3_pm), angle15 = atan2_wide(v49 - v40, -(v44 + v50)),
        angle16 = atan2_wide(-(v40 + v49), v50 - v44), v51 = w3_mp * (m4 * Z2_3_mp),
        v52 = w3_mp * (m4 * Z1_3_mp), angle17 = atan2_wide(v51 - v41, -(v45 + v52)),
        angle18 = atan2_wide(-(v41 + v51), v52 - v45), v53 = w3_mm * (m4 * Z2_3_mm),
        v54 = w3_mm * (m4 * Z1_3_mm), angle19 = atan2_wide(v53 - v42, -(v46 + v54)),
        angle20 = atan2_wide(-(v42 + v53), v54 - v46);

    /* joint values */
    const wide v55 = angle7 - (angle9 + angle13), v56 = angle7 - (angle14 - angle9),
        v57 = theta234_pm - (angle10 + angle15), v58 = theta234_pm - (angle16 - angle10),
        v59 = angle8 - (angle11 + angle17), v60 = angle8 - (angle18 - angle11),
        v61 = theta234_mm - (angle12 + angle19), v62 = theta234_mm - (angle20 - angle12),
        q1_ppp = angle1 + v31, q1_pmp = angle1 + v32, q1_mpp = angle2 + v33, q1_mmp = angle2 + v34,
        q5_ppp = angle5 + v31, q5_pmp = v32 - angle5, q5_mpp = angle6 + v33, q5_mmp = v34 - angle6,
        q6_ppp = angle3 + v31, q6_pmp = v32 + (angle3 - signed_wide(half_turn, -v8)),
        q6_mpp = angle4 + v33, q6_mmp = v34 + (angle4 - signed_wide(half_turn, -v9));

    q[0] = q1_ppp; q[1] = angle13; q[2] = angle9; q[3] = centred_wide(v55); q[4] = q5_ppp;
    q[5] = q6_ppp;
    kind[0] = kind_of(q[0], 0);
    q[6] = q1_ppp; q[7] = angle14; q[8] = -angle9; q[9] = centred_wide(v56); q[10] = q5_ppp;
    q[11] = q6_ppp;
    kind[1] = kind_of(q[6], 0);
    q[12] = q1_pmp; q[13] = angle15; q[14] = angle10; q[15] = centred_wide(v57); q[16] = q5_pmp;
    q[17] = q6_pmp;
    kind[2] = kind_of(q[12], 0);
    q[18] = q1_pmp; q[19] = angle16; q[20] = -angle10; q[21] = centred_wide(v58); q[22] = q5_pmp;
    q[23] = q6_pmp;
    kind[3] = kind_of(q[18], 0);
    q[24] = q1_mpp; q[25] = angle17; q[26] = angle11; q[27] = centred_wide(v59); q[28] = q5_mpp;
    q[29] = q6_mpp;
    kind[4] = kind_of(q[24], 0);
    q[30] = q1_mpp; q[31] = angle18; q[32] = -angle11; q[33] = centred_wide(v60); q[34] = q5_mpp;
    q[35] = q6_mpp;
    kind[5] = kind_of(q[30], 0);
    q[36] = q1_mmp; q[37] = angle19; q[38] = angle12; q[39] = centred_wide(v61); q[40] = q5_mmp;
    q[41] = q6_mmp;
    kind[6] = kind_of(q[36], 0);
    q[42] = q1_mmp; q[43] = angle20; q[44] = -angle12; q[45] = centred_wide(v62); q[46] = q5_mmp;
    q[47] = q6_mmp;
    kind[7] = kind_of(q[42], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-12f;
    return (exact == 0) | ((abs_wide(v1 * D3_mm) <= m3) | (abs_wide(v1 * D3_mp) <= m3) |
        (abs_wide(v1 * D3_pm) <= m3) | (abs_wide(v1 * D3_pp) <= m3) | (v11 <= m1) | (abs_wide(D1) <=
        k2) | (v10 <= m1));
}

HELPER int solve_regular(const float T[16], float q[8][6], unsigned char status[8])
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

/* LOST + j: the row was lost after joint j had been chosen freely; NEARLY + j: joint j is nearly
 * free, and the row's second value is its angle. */
enum { LOST = 128, NEARLY = 192 };

/* Notes why a row is lost, and how far it is from a solution. */
static void lose(int why, float off, float q[6], unsigned char *status)
{
    *status = (unsigned char)why;
    q[0] = off;
}

/* Fills the rows of the branches that have a solution, and no others. The first value of a row that
 * is LOST says how far it is from a solution (negative). */
static void solve(
    const float T[16], const float seed[6], float q[8][6], unsigned char status[8])
{
    ENTRIES(float);

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const float X1 = T13 * d6 - T14;
    const float wy = T24 - d6 * T23;
    const float N1 = X1 * X1 + wy * wy;
    const int free1 = N1 <= free_limit_squared2;
    const float D1 = N1 - k1;
    const int apart1 = k3 < D1;
    if (!(-k2 <= D1)) return; /* out of reach */
    const float w1 = sqrtf(apart1 ? D1 : 0.0f);
    const float v1 = (apart1 ? w1 : least_root1) * k4;
    const float inverse1 = 1.0f / (free1 ? 1.0f : (apart1 ? N1 : d4 * sqrtf(N1)));
    const float v2 = X1 * d4, v3 = wy * d4;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const float v7 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const float e1 = i1 == 0 ? 1.0f : -1.0f;
        /* theta1 */
        if (e1 < 0.0f && (free1 || !apart1)) continue; /* both signs give the same */
        const float root1 = w1 * e1;
        const float c1 = free1 ? cosf(seed[0]) : -(inverse1 * (v3 + X1 * root1)),
            s1 = free1 ? sinf(seed[0]) : inverse1 * (wy * root1 - v2);
        const float q1 = atan2f(s1, c1);

        /* theta6, type 2: U1 A6^-1 [3, 2] */
        const float X6 = T21 * c1 - T11 * s1;
        const float Y6 = T22 * c1 - T12 * s1;
        const float w6 = sqrtf(X6 * X6 + Y6 * Y6);
        const int free6 = w6 <= free_limit;
        const float divisor6 = free6 ? 1.0f : w6;
        const int near6 = w6 <= near_limit;

        /* theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1] */
        const float c5 = T13 * s1 - T23 * c1;

        /* theta3 */
        const float v8 = T14 * c1 + T24 * s1, v9 = (free6 || free1 || near6) ? 1.0f : v1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const float e2 = i2 == 0 ? 1.0f : -1.0f;
            /* theta6 */
            if (e2 < 0.0f && free6) continue; /* both signs give the same */
            const float factor6 = e2 / divisor6;
            const float v4 = X6 * factor6, v5 = Y6 * factor6;
            const float off6 = near6 ? w6 * fabsf(v4 * sinf(seed[5]) + v5 * cosf(seed[5])) : 1.0f;
            const float ahead6 = near6 ? v5 * sinf(seed[5]) - v4 * cosf(seed[5]) : -1.0f;
            const int same6 = near6 && 0.0f < ahead6 && off6 <= free_limit;
            const int held6 = free6 || same6;
            const float c6 = held6 ? cosf(seed[5]) : -v4, s6 = held6 ? sinf(seed[5]) : v5;
            const float q6 = atan2f(s6, c6);
            const float s5 = w6 * e2;

            /* theta5 */
            const float q5 = atan2f(s5, c5);

            /* theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1] */
            const float c234 = c6 * T32 + s6 * T31, s234 = c5 * (c6 * T31 - s6 * T32) - s5 * T33;
            const float theta234 = atan2f(s234, c234);

            /* theta3 */
            const float v6 = d6 * s5;
            const float Z1_3 = c234 * d5 + s234 * v6 + v7;
            const float Z2_3 = c234 * v6 - s234 * d5 + v8;
            const float N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
            const float K3 = N3 - k5;
            const float D3 = (longest3 - N3) * (N3 - shortest3);
            const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
            if (!(-boundary3 <= D3 * v9)) {
                if (near6) lose(NEARLY + 6, D3, q[4 * i1 + 2 * i2], &status[4 * i1 + 2 * i2]);
                if (near6) q[4 * i1 + 2 * i2][1] = atan2f(v5, -v4);
                if (free1) lose(LOST + 1, D3, q[4 * i1 + 2 * i2], &status[4 * i1 + 2 * i2]);
                if (free6) lose(LOST + 6, D3, q[4 * i1 + 2 * i2], &status[4 * i1 + 2 * i2]);
                continue; /* out of reach */
            }
            const float w3 = sqrtf(apart3 ? D3 : 0.0f);
            const float c3 = K3 * k6;

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const float X1_2 = a2 + a3 * c3;
            const float v10 = Z1_3 * X1_2, v11 = Z2_3 * X1_2;

            for (int i3 = 0; i3 < 2; i3++) { /* down, up */
                const float e3 = i3 == 0 ? 1.0f : -1.0f;
                /* theta3 */
                if (e3 < 0.0f && (!apart3 || (near6 && !(shortest3_clear < N3 && N3 <
                    longest3_clear))))
                    continue; /* both signs give the same */
                const float s3 = w3 * e3 * k6;
                const float q3 = atan2f(s3, c3);

                /* theta2 */
                const float Y1_2 = a3 * s3;
                const float S2 = v10 - Z2_3 * Y1_2;
                const float C2 = v11 + Z1_3 * Y1_2;
                const float w2 = sqrtf(S2 * S2 + C2 * C2);
                const int free2 = w2 <= free_limit_squared2;
                const float factor2 = 1.0f / (free2 ? 1.0f : w2);
                const float c2 = free2 ? cosf(seed[1]) : C2 * factor2,
                    s2 = free2 ? sinf(seed[1]) : S2 * factor2;
                const float q2 = atan2f(s2, c2);

                /* joint values */
                const float q4 = wrap(theta234 - (q3 + q2));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free6) ? FREE : OK;
            }
        }
    }
}

static void take(const float from[6], float to[6])
{
    for (int i = 0; i < 6; i++)
        to[i] = from[i];
}

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const float *T;
    float seed[6], start, q[8][6];
    unsigned char status[8];
    int joint, row;
    float best, at; /* where the arm came nearest */
    int within; /* whether limits count */
};

/* How far a row is from a solution: 0 if it is solved. */
static float shortfall(const struct search *s)
{
    if (s->status[s->row] >= LOST)
        return s->q[s->row][0];
    return s->status[s->row] == NONE ? -HUGE_VALF : 0.0f;
}

/* Solves with the joint moved: 0 if it serves, else less. */
static float attempt(struct search *s, float moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < 8; i++)
        s->status[i] = NONE;
    solve(s->T, s->seed, s->q, s->status);
    const float result = shortfall(s);
    if (result > s->best) {
        s->best = result;
        s->at = s->seed[s->joint];
    }
    return result == 0.0f && s->within ? -beyond_limits(s->q[s->row]) : result;
}

/* Whether the row was solved, as exactly as poses may be rounded. */
static int serves(const struct search *s)
{
    const int status = s->status[s->row];
    if (s->within && beyond_limits(s->q[s->row]) > 0.0f)
        return 0;
    return status != NONE && status < LOST;
}

/* Golden section for a move that serves, or NaN. */
static float summit(struct search *s, float low, float high)
{
    for (int k = 0; k < 52; k++) {
        const float third = 0.38196602f * (high - low);
        const float left = attempt(s, low + third), right = attempt(s, high - third);
        if (left == 0.0f || right == 0.0f)
            return left == 0.0f ? low + third : high - third;
        if (left >= right)
            high -= third;
        else
            low += third;
    }
    /* where branches meet this one has no solution of its own */
    if (isinf(attempt(s, low - 2e-06f)) || isinf(attempt(s, high + 2e-06f)))
        return NAN;
    attempt(s, low);
    return serves(s) ? low : (float)NAN;
}

/* How far a free joint has to be moved from the seed's value until it serves, or NaN: a fan of
 * values, golden section, bisection of the nearest end; of two equally near the lower one. */
static float serving_value(struct search *s)
{
    const float step = 0.09817477f;
    if (attempt(s, 0.0f) == 0.0f)
        return 0.0f;
    float nearest = NAN, before, here = -HUGE_VALF, after = attempt(s, -32.0f * step);
    for (int k = -32; k <= 32; k++) {
        before = here;
        here = after;
        after = attempt(s, (float)(k + 1) * step);
        float outer = (float)k * step, inner = k > 0 ? outer - step : k < 0 ? outer + step : 0.0f;
        if (here < 0.0f && here >= before && here > after)
            outer = summit(s, outer - step, outer + step);
        else if (here < 0.0f || (k > 0 ? before : after) == 0.0f)
            continue;
        if (isnan(outer))
            continue;
        for (int i = 0; i < 52; i++) {
            const float middle = 0.5f * (inner + outer);
            if (attempt(s, middle) == 0.0f)
                outer = middle;
            else
                inner = middle;
        }
        if (!(fabsf(outer) >= fabsf(nearest) - 2e-06f))
            nearest = outer;
    }
    return nearest;
}

/* A joint was nearly free: its angle had few digits, and the arm could not reach. Takes the nearest
 * that serves, also where the arm just reaches (an elbow is stretched); while it is right up to
 * rounding of what it was taken from, `solve` takes it as its own. */
static float serving_digits(struct search *s)
{
    float before[2] = { -HUGE_VALF, -HUGE_VALF };
    int past[2] = { 0 };
    for (float moved = 1e-15f; moved < 0.1f; moved *= 2.0f)
        for (int way = 0; way < 2; way++) {
            const float there = way ? -moved : moved, here = attempt(s, there);
            if (here == 0.0f)
                return there;
            if (here < 2.0f * before[way] && !past[way]++) {
                const float top = summit(s, 0.25f * there, there);
                if (!isnan(top))
                    return top;
            }
            before[way] = here;
        }
    return NAN;
}

/* Several joints are free, none serves alone: in turn each goes to where the arm came nearest. */
static float serving_in_turn(struct search *s)
{
    static const int joints[] = { 0, 5 };
    float serving = NAN, before = -HUGE_VALF;
    for (int k = 0; k < 12 && isnan(serving) && s->best > before; k++) {
        before = s->best;
        s->seed[s->joint] = s->at;
        s->joint = joints[k % 2];
        s->start = s->at = s->seed[s->joint];
        serving = serving_value(s);
    }
    return serving;
}

/* Another value for a joint that had been chosen, if one serves. */
static void choose_again(
    const float T[16], const float seed[6], int row, float q[8][6], unsigned char status[8])
{
    const int nearly = status[row] > NEARLY;
    struct search lost = { .T = T, .row = row, .best = -HUGE_VALF };
    lost.joint = status[row] - (nearly ? NEARLY : LOST) - 1;
    take(seed, lost.seed);
    lost.start = fmodf(nearly ? q[row][1] : seed[lost.joint], turn);
    float nearest = nearly ? serving_digits(&lost) : serving_value(&lost);
    if (isnan(nearest) && !nearly)
        nearest = serving_in_turn(&lost);
    attempt(&lost, isnan(nearest) ? 0.0f : nearest);
    const int served = !isnan(nearest) && serves(&lost);
    status[row] = served ? lost.status[row] : NONE;
    for (int i = 0; i < 6; i++)
        q[row][i] = served ? lost.q[row][i] : (float)NAN;
}

/* Whether a joint beyond its limits does not move with the one that is searched. */
static int hopeless(struct search *s)
{
    struct search other = *s;
    attempt(s, 0.0f);
    attempt(&other, 0.1f);
    if (shortfall(s) < 0.0f || shortfall(&other) < 0.0f)
        return 0;
    for (int i = 0; i < 6; i++) {
        const float value = s->q[s->row][i], moved = fabsf(value - other.q[s->row][i]);
        if (moved < 2e-06f && fabsf(overshoot(i, value)) > 0.0f)
            return 1;
    }
    return 0;
}

/* A free joint took the seed's value, and that puts one beyond its limits: takes the nearest value
 * that keeps all, if there is one; other free joints the seed's, as far as their limits allow. */
static void keep_limits(
    const float T[16], const float seed[6], int row, float q[8][6], unsigned char status[8])
{
    static const int choosable[3] = { 5, 1, 0 };
    struct search search = { .T = T, .row = row, .within = 1 };
    for (int i = 0; i < 6; i++)
        search.seed[i] = seed[i] - overshoot(i, seed[i]);
    for (int k = 0; k < 3; k++) {
        const int joint = search.joint = choosable[k];
        const float inside = search.seed[joint];
        search.start = fmodf(seed[joint], turn);
        const float nearest = hopeless(&search) ? (float)NAN : serving_value(&search);
        /* beside the solution of another row this one has none */
        if (!isnan(nearest) && (fabsf(nearest) >= 0.003f || !isinf(attempt(&search, 0.0f)))) {
            attempt(&search, nearest);
            status[row] = search.status[row];
            take(search.q[row], q[row]);
            return;
        }
        search.seed[joint] = inside;
    }
}

/* A joint value moved by whole turns, near to another but inside its limits. */
static float turned(int joint, float given, float towards)
{
    const float low = lowest[joint] - 2e-06f, high = highest[joint] + 2e-06f;
    float value = given;
    if (fabsf(towards) < 100.0f)
        value += turn * floorf((towards - given) / turn + 0.5f);
    value -= turn * ceilf(fmaxf(value - high, 0.0f) / turn);
    value += turn * ceilf(fmaxf(low - value, 0.0f) / turn);
    return value <= high ? value : given;
}

/* How far joint values are from others, whole turns aside [rad, arm sizes]; half is the middle. */
static float half_way(const float x[6], const float q[6], float half[6])
{
    float most = 0.0f;
    for (int i = 0; i < 6; i++) {
        float off = q[i] - x[i];
        off -= turn * floorf(off / turn + 0.5f);
        most = fmaxf(most, fabsf(off));
        half[i] = x[i] + 0.5f * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const float weights[6] = { 0.8386f, 0.8386f, 0.8386f, 1.0f, 1.0f, 1.0f };
/* What a step of one means for joints; none if given. */
static const float pace[6] = { 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static float off_pose(const float T[16], const float x[6], float e[6])
{
    float P[16], square = 0.0f;
    ur5_f32_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0f ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0f;
        e[3 + i] = 0.0f;
        square += e[i] * e[i];
    }
    for (int i = 0; i < 9; i++) {
        const int j = (i / 3 + 1) % 3 * 4 + i % 3, k = (i / 3 + 2) % 3 * 4 + i % 3;
        e[3 + i / 3] += 0.5f * (P[j] * T[k] - P[k] * T[j]);
        square += 0.5f * (P[j] - T[j]) * (P[j] - T[j]);
    }
    return sqrtf(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[6], float damping, float e[6], float x[6])
{
    float A[6][12] = { { 0.0f } }, square[6] = { 0.0f }, J[36];
    ur5_f32_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++)
            A[i][j] = held[j] ? 0.0f : pace[j] * weights[i] * J[6 * i + j];
        A[i][6 + i] = sqrtf(damping + 1e-10f);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            float along = 0.0f;
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
static float past_an_end(int joint, float value)
{
    const float low = lowest[joint], high = highest[joint];
    if (high - low < 6.183185f)
        return overshoot(joint, value);
    const float off = value - fminf(fmaxf(value, low), high);
    return fabsf(off) <= 0.5f * slack(joint) ? 0.0f : off;
}

/* The same of all joints. */
static float past_ends(const float values[6])
{
    float sum = 0.0f;
    for (int i = 0; i < 6; i++)
        sum += fabsf(past_an_end(i, values[i]));
    return sum;
}

/* A joint value turned inside its limits, or next to the end that it and the seed are at. */
static float at_an_end(int joint, float value, float seed)
{
    const float near = value + turn * floorf((seed - value) / turn + 0.5f);
    const float past = fabsf(past_an_end(joint, near));
    if (0.0f < past && past < 0.01f && fabsf(near - seed) < 0.15f)
        return near;
    const float off = overshoot(joint, value);
    if (off == 0.0f || fabsf(off) > 0.01f)
        return turned(joint, value, value);
    return off + (off > 0.0f ? highest : lowest)[joint];
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const float T[16], float enough, float most, float q[6])
{
    float x[6], half[6], e[6], last = HUGE_VALF;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[6] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        float miss = off_pose(T, x, e), past = 0.0f;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-06f : enough;
        for (int i = 0; i < 6 && stands && miss < enough; i++) {
            const float off = pace[i] > 0.0f ? past_an_end(i, x[i]) : 0.0f;
            worst = fabsf(off) > fabsf(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabsf(past) > 0.0f) {
            moves++;
            for (int i = 0; i < 6; i++)
                held[i] = i == worst || (held[i] && moves != 2);
            last = HUGE_VALF;
            x[worst] -= past;
            miss = off_pose(T, x, e);
        }
        if (miss < enough) {
            take(x, q);
            settled = 1;
            enough = 0.5f * miss;
        } else if (settled || (miss > fmaxf(0.7f * last, 100.0f * enough) && ++lost == 4)) {
            break;
        }
        last = miss;
        add_step(held, (lost == 0 && miss > 100.0f * enough ? 0.003f : 0.1f * miss) * miss, e, x);
        if (!(half_way(x, q, half) <= most))
            break; /* another solution */
    }
    return settled;
}

/* Takes joint values onto ends that they are past or, as two may not stand there, inside. */
static int lead_inside(const float T[16], float enough, float most, float q[6])
{
    float x[6], e[6];
    if (settle(T, enough, most, q))
        return 1;
    int past = 0;
    for (int i = 0; i < 6; i++)
        past += fabsf(past_an_end(i, q[i])) > 0.0f;
    enough = off_pose(T, q, e) + 1e-06f;
    for (float farther = 2.0f; past > 1 && farther <= 16.0f; farther *= 2.0f) {
        for (int i = 0; i < 6; i++)
            x[i] = q[i] - farther * past_an_end(i, q[i]);
        if (!settle(T, enough, most, x) || past_ends(x) > 0.0f)
            continue;
        take(x, q);
        return 1;
    }
    return 0;
}

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const float T[16], int row, int far, float rows[8][6], const unsigned char status[8])
{
    float x[6], half[6], to[6], *q = rows[row];
    const float beyond = past_ends(q);
    if (!(0.0f < beyond && (far || beyond < 0.01f)))
        return 0;
    take(q, x);
    if (!lead_inside(T, NAN, far ? HUGE_VALF : 1.5f, x))
        return 0;
    const float off = half_way(q, x, half);
    for (int k = 0; k < 8; k++)
        if (status[k] != NONE && past_ends(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.03f && !settle(T, 5e-05f, 0.25f * off, half))
        return 0;
    take(x, q);
    return 1;
}

/* Leads rows of nested roots to solutions, ends those that rounding alone tells from earlier ones:
 * half way the arm is singular. */
static void tell_once(const float T[16], float q[8][6], unsigned char status[8])
{
    const int held[6] = { 0 };
    for (int n = 0; n < 8 * 8; n++) {
        float half[6], e[6], *row = q[n / 8];
        const int k = n % 8;
        int ends = k == 0 && off_pose(T, row, e) > 5e-05f && !settle(T, 5e-05f, 0.15f, row);
        if (0 < k && k <= n / 8 && half_way(q[k - 1], row, half) < 0.03f && !isnan(half[0])) {
            for (int i = 0; i < 3; i++) {
                off_pose(T, half, e);
                add_step(held, 1e-13f, e, half);
            }
            ends = off_pose(T, half, e) <= 1e-07f;
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
    const float T[16], const float seed[6], float q[8][6],
    unsigned char status[8])
{
    float x[6], half[6], e[6], least = HUGE_VALF, nearest = 0.03f;
    int place = 0;
    for (int i = 0; i < 6; i++) {
        const float seen = seed[i], past = fabsf(past_an_end(i, seen));
        const float here = past <= 0.15f ? seen : turned(i, seen, seen);
        x[i] = here - past_an_end(i, here);
    }
    if (!settle(T, 5e-05f, 0.15f, x) || (past_ends(x) > 2e-06f && !lead_inside(T, NAN, 0.15f, x)))
        return;
    for (int row = 8 - 1; row >= 0; row--) {
        float between = 0.0005f;
        if (status[row] != NONE) {
            const float off = half_way(x, q[row], half);
            between = off < 0.03f ? 0.0f : fmaxf(off_pose(T, half, e), 5e-05f);
            if (off < nearest) {
                nearest = off;
                place = row;
                least = -1.0f; /* its own */
            }
        }
        if (between <= 2.0f * least)
            place = row;
        least = fminf(least, between);
    }
    if (least >= 0.0f)
        status[place] = FREE;
    if (nearest > 0.003f || past_ends(q[place]) > 0.0f)
        take(x, q[place]);
}

/* A pose that is rounded, singular or none; regular ones need no stack for it. */
APART int ik_carefully(
    const float T[16], const float *q_seed, float q[8][6], unsigned char status[8])
{
    const float zeros[6] = { 0.0f }, *seed = q_seed ? q_seed : zeros;
    float pose[16];
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
        if (status[row] >= LOST)
            choose_again(pose, seed, row, q, status);
    for (int row = 0; row < 8; row++)
        if (status[row] == FREE && beyond_limits(q[row]) > 0.0f)
            keep_limits(pose, seed, row, q, status);
    tell_once(pose, q, status);
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
            float *value = &q[row][i];
            *value = turned(i, *value, 0.0f);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int ur5_f32_ik(const float T[16], const float *q_seed, float q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int ur5_f32_ik_nearest(const float T[16], const float q_seed[6], float q[6])
{
    float all[8][6], found[6], least = HUGE_VALF;
    unsigned char status[8];
    int result = -NONE;
    int valid = ur5_f32_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 6; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    int past = 0; /* joints past an end and turned */
    for (int i = 0; i < 6 && valid; i++)
        if (fminf(highest[i] - q_seed[i], q_seed[i] - lowest[i]) < 0.15f)
            for (int row = 0; row < 8; row++)
                past += status[row] == OK
                    && past_an_end(i, at_an_end(i, all[row][i], q_seed[i])) != 0.0f;
    if (past)
        (void)ik_carefully(T, q_seed, all, status);
    for (int row = 0; row < 8 && valid; row++) {
        float distance = 0.0f;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const float moved = all[row][i] - q_seed[i];
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

void ur5_f32_ik_batch(size_t n, const float *T, float *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)ur5_f32_ik(T + 16 * k, NULL, (float (*)[6])(q + 48 * k), status + 8 * k);
}
