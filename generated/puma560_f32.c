/* puma560_f32: Unimation PUMA 560
 *
 * Inverse kinematics, generated from robots/puma560.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma560.yaml. The formulas and where they come from: puma560.md.
 */
#include "puma560_f32.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = PUMA560_F32_OK, NONE = PUMA560_F32_UNREACHABLE, FREE = PUMA560_F32_FREE_JOINT,
    OUT = PUMA560_F32_OUT_OF_LIMITS, INVALID = PUMA560_F32_INVALID_POSE
};

static const float turn = 6.2831855f;
#define half_turn (0.5f * turn)

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

#ifndef PUMA560_F32_LIBM
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
#ifdef PUMA560_F32_LIBM /* half the time of atan2 */
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
HELPER v raised_##v(v x) { return x + only_##v(x <= -half_turn, turn); } \

TURNS(wide)

#define high(joint) (highest[joint - 1] + slack(joint - 1))
/* How far a joint is beyond its limits; whether by rounding, perhaps. */
#define grazes(x) (abs_wide((x) - 0.005f) <= 0.005f)
#define exceeds(x, joint) (abs_wide(x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const float
    d1 = 0.67183f, /* joint offset 1 [m] */
    a2 = 0.4318f, /* link length 2 [m] */
    d3 = 0.15005f, /* joint offset 3 [m] */
    a3 = 0.0203f, /* link length 3 [m] */
    d4 = 0.4318f, /* joint offset 4 [m] */
    free_limit_squared2 = 1.1638741e-09f, /* square of a length that fixes no angle [m^2] */
    least_root1 = 0.00341156f, /* a root of nothing, by rounding [m] */
    longest3 = 0.74662894f, /* square of the longest reach [m^2] */
    shortest3 = 2.2744655e-07f, /* square of the shortest reach [m^2] */
    boundary3 = 8.803972e-06f, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.74662864f, /* the longest, where branches merge [m^2] */
    shortest3_apart = 2.2760928e-07f, /* the shortest, where branches merge [m^2] */
    free_limit = 2e-05f, /* a length that fixes no angle */
    k1 = 0.022515003f, /* d3^2 [m^2] */
    k2 = 2.0476648e-06f, /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
    k3 = 5.1190487e-08f, /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
    k4 = 0.5862421f, /* 1 / arm_size1 [m^-1] */
    k5 = 0.37290248f, /* 2 * d4 * a2 [m^2] */
    k6 = 0.01753108f, /* 2 * a3 * a2 [m^2] */
    k7 = 0.37331456f, /* d4 * a2 + (a3^2 + d4 * a2) [m^2] */
    k8 = 7.175475f, /* 1 / (k5^2 + k6^2) [m^-4] */
    /* square of a length that fixes no angle [m^2] */
    doubt_limit_squared2 = 2.9096855e-06f,
    turn1 = 1.5238184f, /* a constant angle [rad] */
    m7 = 1e-06f; /* doubt_limit^2 */
/* coefficients */
static const float m1 = 0.12579383f, m2 = 0.9988974f, m3 = 2.6757524f,
m4 = 0.046960667f, m5 = 1.1579435f, m6 = 0.00047717695f;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const puma560_f32_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-down-noflip",
    "right-down-flip", "right-up-noflip", "right-up-flip",
};

static const float lowest[6] = {
    -2.7925267f, -1.9198622f, -2.3561945f, -4.6425757f,
    -1.7453293f, -4.6425757f,
};
static const float highest[6] = {
    2.7925267f, 1.9198622f, 2.3561945f, 4.6425757f, 1.7453293f,
    4.6425757f,
};
#define slack(joint) 2e-06f /* of limits */

void puma560_f32_fk(const float q[6], float T[16])
{
    const float c1 = cosf(q[0]), s1 = sinf(q[0]);
    const float c2 = cosf(q[1]), s2 = sinf(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const float c3 = cosf(q[2]), s3 = sinf(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3;
    const float c4 = cosf(q[3]), s4 = sinf(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4,
        y5_y = c1 * c4 - x3_y * s4, z4_z = x3_z * s4;
    const float c5 = cosf(q[4]), s5 = sinf(q[4]), x5_x = x4_x * c5 - v3 * s5,
        x5_y = x4_y * c5 - v4 * s5, x5_z = x4_z * c5 + z3_z * s5;
    const float c6 = cosf(q[5]), s6 = sinf(q[5]);
    T[0] = x5_x * c6 - z4_x * s6; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = -(v3 * c5 + x4_x * s5);
    T[3] = x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4;
    T[4] = x5_y * c6 + y5_y * s6; T[5] = y5_y * c6 - x5_y * s6; T[6] = -(v4 * c5 + x4_y * s5);
    T[7] = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4;
    T[8] = x5_z * c6 - z4_z * s6; T[9] = -(z4_z * c6 + x5_z * s6); T[10] = z3_z * c5 - x4_z * s5;
    T[11] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4;
    T[12] = T[13] = T[14] = 0.0f;
    T[15] = 1.0f;
}

void puma560_f32_jacobian(const float q[6], float J[36])
{
    const float c1 = cosf(q[0]), s1 = sinf(q[0]);
    const float c2 = cosf(q[1]), s2 = sinf(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const float c3 = cosf(q[2]), s3 = sinf(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3, p3_z = p2_z + x3_z * a3,
        p3_x = p2_x + x3_x * a3 + s1 * d3, p3_y = p2_y + x3_y * a3 - c1 * d3;
    const float c4 = cosf(q[3]), s4 = sinf(q[3]), p4_x = p3_x - v3 * d4, p4_y = p3_y - v4 * d4,
        p4_z = p3_z + z3_z * d4;
    const float c5 = cosf(q[4]), s5 = sinf(q[4]), v5 = p4_z - d1, v6 = p4_z - p2_z, v7 = p4_x -
        p3_x,
        v8 = p4_y - p3_y, v9 = p4_z - p3_z;
    J[0] = -p4_y; J[1] = -(c1 * v5); J[2] = -(c1 * v6); J[3] = -(v4 * v9 + z3_z * v8); J[4] = 0.0f;
    J[5] = 0.0f;
    J[6] = p4_x; J[7] = -(s1 * v5); J[8] = -(s1 * v6); J[9] = z3_z * v7 + v3 * v9; J[10] = 0.0f;
    J[11] = 0.0f;
    J[12] = 0.0f; J[13] = s1 * p4_y + c1 * p4_x; J[14] = s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x);
    J[15] = v4 * v7 - v3 * v8; J[16] = 0.0f; J[17] = 0.0f;
    J[18] = 0.0f; J[19] = s1; J[20] = s1; J[21] = -v3; J[22] = s1 * c4 + x3_x * s4;
    J[23] = -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5);
    J[24] = 0.0f; J[25] = -c1; J[26] = -c1; J[27] = -v4; J[28] = x3_y * s4 - c1 * c4;
    J[29] = -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5);
    J[30] = 1.0f; J[31] = 0.0f; J[32] = 0.0f; J[33] = z3_z; J[34] = x3_z * s4;
    J[35] = z3_z * c5 - x3_z * c4 * s5;
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
    const wide N1 = T14 * T14 + T24 * T24, D1 = N1 - k1, w1 = sqrt_wide(D1), v1 = w1 - w1,
        inverse1 = 1.0f / N1, v2 = inverse1 * (d3 * T24), v3 = w1 * (T14 * inverse1), c1_p = v3 -
            v2,
        v4 = v2 + v3, v5 = inverse1 * (d3 * T14), v6 = w1 * (T24 * inverse1), s1_p = v5 + v6,
        s1_m = v5 - v6, angle1 = atan2_wide(s1_p, c1_p), angle2 = atan2_wide(s1_m, -v4);

    /* theta3 */
    const wide Z1_3 = T34 - d1, N3 = D1 + Z1_3 * Z1_3, D3 = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt_wide(D3), v7 = w3 - w3, v8 = m2 - m3 * N3, v9 = m1 * w3, s3_p = v8 + v9,
        s3_m = v8 - v9, v10 = m1 * N3 - m4, v11 = m3 * w3, c3_p = v10 + v11, c3_m = v10 - v11,
        angle3 = atan2_wide(w3, N3 - k7), q3__p = angle3 - turn1, v12 = turn1 + angle3;

    /* theta2 */
    const wide X1_2 = m5 * N3 - m6, v13 = Z1_3 * X1_2, v14 = w3 * (m5 * w1), S2_pp = v13 - v14,
        S2_pm = v13 + v14, v15 = w3 * (m5 * Z1_3), v16 = w3 * (m5 * -Z1_3), v17 = w1 * X1_2,
        v18 = w1 * -X1_2, C2_pp = v15 + v17, C2_pm = v16 + v17, C2_mp = v15 + v18,
        C2_mm = v16 + v18, factor2 = 1.0f / N3, angle4 = atan2_wide(S2_pp, C2_pp),
        angle5 = atan2_wide(S2_pm, C2_pm), angle6 = atan2_wide(S2_pm, C2_mp),
        angle7 = atan2_wide(S2_pp, C2_mm);

    /* theta4 */
    const wide c23_pp = c3_p * C2_pp - s3_p * S2_pp, c23_pm = c3_m * C2_pm - s3_m * S2_pm,
        c23_mp = c3_p * C2_mp - s3_p * S2_pm, c23_mm = c3_m * C2_mm - s3_m * S2_pp,
        s23_pp = c3_p * S2_pp + s3_p * C2_pp, s23_pm = c3_m * S2_pm + s3_m * C2_pm,
        s23_mp = c3_p * S2_pm + s3_p * C2_mp, s23_mm = c3_m * S2_pp + s3_m * C2_mm,
        v19 = c1_p * T13 + s1_p * T23, v20 = s1_m * T23 - v4 * T13,
        c4_pp = c23_pp * v19 + s23_pp * T33, c4_pm = c23_pm * v19 + s23_pm * T33,
        c4_mp = c23_mp * v20 + s23_mp * T33, c4_mm = c23_mm * v20 + s23_mm * T33,
        Y4_p = c1_p * T23 - s1_p * T13, v21 = v4 * T23 + s1_m * T13, v22 = Y4_p * Y4_p,
        v23 = v21 * v21, v24 = factor2 * c4_pp, v25 = factor2 * c4_pm, v26 = factor2 * c4_mp,
        v27 = factor2 * c4_mm, v28 = v22 + factor2 * (c4_pp * v24),
        v29 = v22 + factor2 * (c4_pm * v25), v30 = v23 + factor2 * (c4_mp * v26),
        v31 = v23 + factor2 * (c4_mm * v27), angle8 = atan2_wide(Y4_p, v24),
        angle9 = atan2_wide(Y4_p, v25), angle10 = atan2_wide(-v21, v26),
        angle11 = atan2_wide(-v21, v27), v32 = signed_wide(half_turn, Y4_p),
        v33 = signed_wide(half_turn, -v21);

    /* theta5 */
    const wide angle12 = atan2_wide(-sqrt_wide(v28), factor2 * (c23_pp * T33 - s23_pp * v19)),
        angle13 = atan2_wide(-sqrt_wide(v29), factor2 * (c23_pm * T33 - s23_pm * v19)),
        angle14 = atan2_wide(-sqrt_wide(v30), factor2 * (c23_mp * T33 - s23_mp * v20)),
        angle15 = atan2_wide(-sqrt_wide(v31), factor2 * (c23_mm * T33 - s23_mm * v20));

    /* theta6 */
    const wide v34 = s1_p * T12 - c1_p * T22, v35 = s1_m * T12 + v4 * T22,
        v36 = c1_p * T12 + s1_p * T22, v37 = s1_m * T22 - v4 * T12, v38 = s1_p * T11 - c1_p * T21,
        v39 = s1_m * T11 + v4 * T21, v40 = c1_p * T11 + s1_p * T21, v41 = s1_m * T21 - v4 * T11,
        angle16 = atan2_wide(-(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp * T31)), -(c4_pp * v34 +
            Y4_p * (c23_pp * v36 + s23_pp * T32))),
        angle17 = atan2_wide(-(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm * T31)), -(c4_pm * v34 +
            Y4_p * (c23_pm * v36 + s23_pm * T32))),
        v42 = v21 * (c23_mp * v41 + s23_mp * T31) - c4_mp * v39,
        angle18 = atan2_wide(v42, v21 * (c23_mp * v37 + s23_mp * T32) - c4_mp * v35),
        v43 = v21 * (c23_mm * v41 + s23_mm * T31) - c4_mm * v39,
        angle19 = atan2_wide(v43, v21 * (c23_mm * v37 + s23_mm * T32) - c4_mm * v35);

    /* joint values */
    const wide v44 = raised_wide(q3__p), v45 = only_wide(-v12 <= -half_turn, turn) - v12,
        v46 = exceeds(angle1, 1), v47 = exceeds(angle2, 1), v48 = exceeds(v44, 3),
        v49 = exceeds(v45, 3), q1_ppp = angle1 + v7, q1_mpp = angle2 + v7, q3_ppp = v1 + v44,
        q3_pmp = v1 + v45,
        excess_pp = maximum_wide(exceeds(angle12, 5), maximum_wide(exceeds(angle4, 2),
            maximum_wide(v46, v48))),
        excess_pm = maximum_wide(exceeds(angle13, 5), maximum_wide(exceeds(angle5, 2),
            maximum_wide(v46, v49))),
        excess_mp = maximum_wide(exceeds(angle14, 5), maximum_wide(exceeds(angle6, 2),
            maximum_wide(v47, v48))),
        excess_mm = maximum_wide(exceeds(angle15, 5), maximum_wide(exceeds(angle7, 2),
            maximum_wide(v47, v49)));
    const wide_mask outside_ppp = 0.0f < excess_pp, outside_pmp = 0.0f < excess_pm,
        outside_mpp = 0.0f < excess_mp, outside_mmp = 0.0f < excess_mm;

    q[0] = q1_ppp; q[1] = angle4; q[2] = q3_ppp; q[3] = angle8; q[4] = angle12; q[5] = angle16;
    kind[0] = kind_of(q[0], outside_ppp);
    q[6] = q1_ppp; q[7] = angle4; q[8] = q3_ppp; q[9] = angle8 - v32; q[10] = -angle12;
    q[11] = angle16 - signed_wide(half_turn, -(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp * T31)));
    kind[1] = kind_of(q[6], outside_ppp);
    q[12] = q1_ppp; q[13] = angle5; q[14] = q3_pmp; q[15] = angle9; q[16] = angle13;
    q[17] = angle17;
    kind[2] = kind_of(q[12], outside_pmp);
    q[18] = q1_ppp; q[19] = angle5; q[20] = q3_pmp; q[21] = angle9 - v32; q[22] = -angle13;
    q[23] = angle17 - signed_wide(half_turn, -(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm * T31)));
    kind[3] = kind_of(q[18], outside_pmp);
    q[24] = q1_mpp; q[25] = angle6; q[26] = q3_ppp; q[27] = angle10; q[28] = angle14;
    q[29] = angle18;
    kind[4] = kind_of(q[24], outside_mpp);
    q[30] = q1_mpp; q[31] = angle6; q[32] = q3_ppp; q[33] = angle10 - v33; q[34] = -angle14;
    q[35] = angle18 - signed_wide(half_turn, v42);
    kind[5] = kind_of(q[30], outside_mpp);
    q[36] = q1_mpp; q[37] = angle7; q[38] = q3_pmp; q[39] = angle11; q[40] = angle15;
    q[41] = angle19;
    kind[6] = kind_of(q[36], outside_mmp);
    q[42] = q1_mpp; q[43] = angle7; q[44] = q3_pmp; q[45] = angle11 - v33; q[46] = -angle15;
    q[47] = angle19 - signed_wide(half_turn, v43);
    kind[7] = kind_of(q[42], outside_mmp);
    const wide_mask exact = irregularity_wide(T) <= 1e-12f;
    return (exact == 0) | ((abs_wide(D3 * (k4 * w1)) <= boundary3) | (abs_wide(D1) <= k2) | (N3 <=
        doubt_limit_squared2) | (v31 <= m7) | (v30 <= m7) | (v28 <= m7) | (v29 <= m7)) |
        (grazes(excess_mm) | grazes(excess_mp) | grazes(excess_pp) | grazes(excess_pm));
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

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const float T[16], const float seed[6], float q[8][6], unsigned char status[8])
{
    ENTRIES(float);

    /* theta1, type 2: U1[3, 4] */
    const float N1 = T14 * T14 + T24 * T24;
    const int free1 = N1 <= free_limit_squared2;
    const float D1 = N1 - k1;
    const int apart1 = k3 < D1;
    if (!(-k2 <= D1)) return; /* out of reach */
    const float w1 = sqrtf(apart1 ? D1 : 0.0f);
    const float inverse1 = 1.0f / (free1 ? 1.0f : (apart1 ? N1 : d3 * sqrtf(N1)));
    const float v1 = T14 * d3, v2 = T24 * d3;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const float Z1_3 = T34 - d1;
    const float v3 = Z1_3 * Z1_3, v4 = free1 ? 1.0f : (apart1 ? w1 : least_root1) * k4;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const float e1 = i1 == 0 ? 1.0f : -1.0f;
        /* theta1 */
        if (e1 < 0.0f && (free1 || !apart1)) continue; /* both signs give the same */
        const float root1 = w1 * e1;
        const float c1 = free1 ? cosf(seed[0]) : inverse1 * (T14 * root1 - v2),
            s1 = free1 ? sinf(seed[0]) : inverse1 * (v1 + T24 * root1);
        const float q1 = atan2f(s1, c1);

        /* theta3 */
        const float N3 = v3 + root1 * root1;
        const float K3 = N3 - k7;
        const float D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= D3 * v4)) continue; /* out of reach */
        const float w3 = sqrtf(apart3 ? D3 : 0.0f);
        const float v5 = k5 * K3, v6 = k6 * K3;

        /* theta4, type 2: U4[3, 3] */
        const float v7 = T13 * c1 + T23 * s1;
        const float Y4 = T23 * c1 - T13 * s1;
        const float v9 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const float v10 = T12 * s1 - T22 * c1, v11 = T12 * c1 + T22 * s1,
            v13 = T11 * s1 - T21 * c1, v14 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const float e2 = i2 == 0 ? 1.0f : -1.0f;
            /* theta3 */
            if (e2 < 0.0f && !apart3) continue; /* both signs give the same */
            const float root3 = w3 * e2;
            const float s3 = (k6 * root3 - v5) * k8, c3 = k8 * (v6 + k5 * root3);
            const float q3 = atan2f(s3, c3);

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const float X1_2 = a2 + (a3 * c3 - d4 * s3);
            const float Y1_2 = d4 * c3 + a3 * s3;
            const float S2 = Z1_3 * X1_2 - root1 * Y1_2;
            const float C2 = root1 * X1_2 + Z1_3 * Y1_2;
            const float w2 = sqrtf(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const float factor2 = 1.0f / (free2 ? 1.0f : w2);
            const float c2 = free2 ? cosf(seed[1]) : C2 * factor2,
                s2 = free2 ? sinf(seed[1]) : S2 * factor2;
            const float q2 = atan2f(s2, c2);

            /* theta4 */
            const float c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
                v8 = c23 * v7 + T33 * s23;
            const float w4 = sqrtf(v8 * v8 + v9);
            const int free4 = w4 <= free_limit;
            const float divisor4 = free4 ? 1.0f : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const float c5 = T33 * c23 - s23 * v7;

            /* theta6 */
            const float v12 = c23 * v11 + T32 * s23, v15 = c23 * v14 + T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const float e3 = i3 == 0 ? 1.0f : -1.0f;
                /* theta4 */
                if (e3 < 0.0f && free4) continue; /* both signs give the same */
                const float factor4 = e3 / divisor4;
                const float c4 = free4 ? cosf(seed[3]) : v8 * factor4,
                    s4 = free4 ? sinf(seed[3]) : Y4 * factor4;
                const float q4 = atan2f(s4, c4);

                /* theta5 */
                const float q5 = atan2f(-(w4 * e3), c5);

                /* theta6 */
                const float q6 = atan2f(-(c4 * v13 + s4 * v15), -(c4 * v10 + s4 * v12));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? FREE : OK;
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
};

/* Solves with the joint moved: 0 if it serves, else less. */
static float attempt(struct search *s, float moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < 8; i++)
        s->status[i] = NONE;
    solve(s->T, s->seed, s->q, s->status);
    if (s->status[s->row] == NONE)
        return -HUGE_VALF;
    return -beyond_limits(s->q[s->row]);
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
    return NAN;
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

/* Whether a joint beyond its limits does not move with the one that is searched. */
static int hopeless(struct search *s)
{
    struct search other = *s;
    if (isinf(attempt(s, 0.0f)) || isinf(attempt(&other, 0.1f)))
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
    static const int choosable[3] = { 3, 1, 0 };
    struct search search = { .T = T, .row = row };
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
static const float weights[6] = { 0.5862f, 0.5862f, 0.5862f, 1.0f, 1.0f, 1.0f };
/* What a step of one means for joints; none if given. */
static const float pace[6] = { 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static float off_pose(const float T[16], const float x[6], float e[6])
{
    float P[16], square = 0.0f;
    puma560_f32_fk(x, P);
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
    puma560_f32_jacobian(x, J);
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

int puma560_f32_ik(
    const float T[16], const float *q_seed, float q[8][6], unsigned char status[8])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int puma560_f32_ik_nearest(const float T[16], const float q_seed[6], float q[6])
{
    float all[8][6], found[6], least = HUGE_VALF;
    unsigned char status[8];
    int result = -NONE;
    int valid = puma560_f32_ik(T, q_seed, all, status) >= 0;
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

void puma560_f32_ik_batch(size_t n, const float *T, float *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)puma560_f32_ik(T + 16 * k, NULL, (float (*)[6])(q + 48 * k), status + 8 * k);
}
