/* delta_leg: Delta, three cranks with parallelograms: a leg
 *
 * Inverse kinematics, generated from robots/delta.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/delta.yaml. The formulas and where they come from: delta_leg.md, of
 * a leg of delta.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: f33bcc1b99634bba
 * SPDX-License-Identifier: MIT
 */
#include "delta_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(DELTA_LEG_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(DELTA_LEG_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef DELTA_LEG_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    crank = 0.524, /* link length 1 [m] */
    rod = 1.244, /* link length 3 [m] */
    free_limit_squared4 = 9.770775678976e-24, /* square of a length that fixes no angle [m^4] */
    reach_slack2 = 3.1258240000000004e-13, /* rounding at the boundary of the workspace [m^2] */
    merge_slack2 = 3.125824e-14, /* nearer to that boundary two branches are one [m^2] */
    free_limit1 = 1.768e-12, /* a length that fixes no angle [m] */
    k1 = -1.2729599999999999, /* crank^2 - rod^2 [m^2] */
    k2 = 0.6461885216240527; /* 1 / (rod^2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const delta_leg_branches[4] = {
    "shoulder+-elbow+", "shoulder+-elbow-", "shoulder--elbow+", "shoulder--elbow-",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -1.0471975511965976, 1.5707963267948966, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.0471975511965976, 1.0471975511965976, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.0, 0.524, 0.0 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 1.244, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void delta_leg_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3, x3_y = x2_y * c3;
    T[0] = x3_x; T[1] = -(x2_x * s3); T[2] = x2_y; T[3] = c1 * crank + x3_x * rod;
    T[4] = x3_y; T[5] = -(x2_y * s3); T[6] = -x2_x; T[7] = s1 * crank + x3_y * rod;
    T[8] = s3; T[9] = c3; T[10] = 0.0; T[11] = s3 * rod;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void delta_leg_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * crank, p1_y = s1 * crank;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), p3_x = p1_x + x2_x * c3 * rod,
        p3_y = p1_y + x2_y * c3 * rod, p3_z = s3 * rod, J22 = p3_x - p1_x, v1 = p3_y - p1_y;
    J[0] = -p3_y; J[1] = -v1; J[2] = -x2_x * p3_z;
    J[3] = p3_x; J[4] = J22; J[5] = -(x2_y * p3_z);
    J[6] = 0.0; J[7] = 0.0; J[8] = x2_y * v1 - -x2_x * J22;
    J[9] = 0.0; J[10] = 0.0; J[11] = x2_y;
    J[12] = 0.0; J[13] = 0.0; J[14] = -x2_x;
    J[15] = 1.0; J[16] = 1.0; J[17] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: the squared length of column 4 of U1 */
    const double X1 = T24 * crank * 2.0;
    const double Y1 = 2.0 * (crank * T14);
    const double N1 = X1 * X1 + Y1 * Y1;
    const int free1 = N1 <= free_limit_squared4;
    const double Z1 = T14 * T14 + (T24 * T24 + (T34 * T34 + k1));
    const double D1_squared = N1 - Z1 * Z1;
    const double v1 = fabs(Z1), v2 = 2.0 * v1;
    const int apart1 = merge_slack2 * (v2 + merge_slack2) < D1_squared;
    if (!(-(reach_slack2 * (v2 + reach_slack2)) < D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : v1 * sqrt(N1)));
    const double v3 = X1 * Z1, v4 = Y1 * Z1;

    /* theta3, type 3: U2[2, 4] and U2[1, 4] */
    const double s3 = T34 * rod * k2;

    for (int i1 = 0; i1 < 2; i1++) { /* shoulder+, shoulder- */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v4 - X1 * D1),
            s1 = free1 ? sin(seed[0]) : inverse1 * (v3 + Y1 * D1);
        const double q1 = atan2(s1, c1);

        /* theta2, type 2: U2[3, 4] */
        const double X2 = crank - (T14 * c1 + T24 * s1);
        const double Y2 = T24 * c1 - T14 * s1;
        const double w2 = sqrt(X2 * X2 + Y2 * Y2);
        const int free2 = w2 <= free_limit1;
        const double divisor2 = free2 ? 1.0 : w2;

        for (int i2 = 0; i2 < 2; i2++) { /* elbow+, elbow- */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : -(X2 * factor2),
                s2 = free2 ? sin(seed[1]) : Y2 * factor2;
            const double q2 = atan2(s2, c2);

            /* theta3 */
            const double c12 = c1 * c2 - s1 * s2, s12 = s1 * c2 + c1 * s2;
            const double c3 = rod * (T14 * c12 + T24 * s12 - crank * c2) * k2;
            const double q3 = atan2(s3, c3);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
            status[row] = (free1 || free2) ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef DELTA_LEG_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.0001768 [m]. */
static const double
    doubt_limit_squared4 = 9.770775678976e-08, /* square of a length that fixes no angle [m^4] */
    m1 = 3.1258239999999996e-11, /* 1000 * merge_slack2 [m^2] */
    m2 = 0.524, /* crank [m] */
    m3 = 3.125824e-08; /* doubt_limit1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = crank * T24 * 2.0, Y1 = 2.0 * (crank * T14), N1 = X1 * X1 + Y1 * Y1,
        Z1 = T14 * T14 + (T24 * T24 + (k1 + T34 * T34)), D1_squared = N1 - Z1 * Z1,
        w1 = dhgen_sqrt_wide(D1_squared), inverse1 = DHGEN_QUOTIENT(1.0, N1), v1 = X1 * Z1,
        v2 = Y1 * Z1, v3 = inverse1 * v2, v4 = w1 * (X1 * inverse1), c1_p = v3 - v4, c1_m = v3 + v4,
        v5 = inverse1 * v1, v6 = w1 * (Y1 * inverse1), s1_p = v5 + v6, s1_m = v5 - v6,
        angle1 = dhgen_atan2_wide(s1_p, c1_p), angle2 = dhgen_atan2_wide(s1_m, c1_m);

    /* theta2 */
    const dhgen_wide v7 = X1 * T14 - T24 * Y1, v8 = m2 - inverse1 * (T24 * v1 + T14 * v2),
        X2_p = v8 + w1 * (inverse1 * v7), X2_m = v8 + w1 * (inverse1 * -v7),
        Y2_p = T24 * c1_p - T14 * s1_p, Y2_m = T24 * c1_m - T14 * s1_m,
        v9 = X2_p * X2_p + Y2_p * Y2_p, v10 = X2_m * X2_m + Y2_m * Y2_m,
        angle3 = dhgen_atan2_wide(Y2_p, -X2_p), angle4 = dhgen_atan2_wide(Y2_m, -X2_m);

    /* theta3 */
    const dhgen_wide s3 = k2 * (rod * T34),
        angle5 = dhgen_atan2_wide(s3, dhgen_sqrt_wide(v9) * DHGEN_QUOTIENT(1.0, v9) * (k2 * (rod *
            (T24 * (c1_p * Y2_p - s1_p * X2_p) - T14 * (c1_p * X2_p + s1_p * Y2_p) + crank *
            X2_p)))),
        angle6 = dhgen_atan2_wide(s3, dhgen_sqrt_wide(v10) * DHGEN_QUOTIENT(1.0, v10) * (k2 * (rod *
            (T24 * (c1_m * Y2_m - s1_m * X2_m) - T14 * (c1_m * X2_m + s1_m * Y2_m) + crank *
            X2_m)))), v11 = dhgen_signed_wide(DHGEN_HALF_TURN, s3), q3_pm = v11 - angle5,
        q3_mm = v11 - angle6;

    /* joint values */
    const dhgen_wide v12 = dhgen_beyond_wide(angle1, joints),
        v13 = dhgen_beyond_wide(angle2, joints),
        excess_pp = dhgen_maximum_wide(v12, dhgen_exceeds_wide(angle5, joints + 2)),
        excess_pm = dhgen_maximum_wide(v12, dhgen_exceeds_wide(q3_pm, joints + 2)),
        excess_mp = dhgen_maximum_wide(v13, dhgen_exceeds_wide(angle6, joints + 2)),
        excess_mm = dhgen_maximum_wide(v13, dhgen_exceeds_wide(q3_mm, joints + 2));

    q[0] = angle1; q[1] = angle3; q[2] = angle5;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_pp);
    q[3] = angle1; q[4] = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, Y2_p); q[5] = q3_pm;
    kind[1] = dhgen_kind_within_wide(q[3], 0.0 < excess_pm);
    q[6] = angle2; q[7] = angle4; q[8] = angle6;
    kind[2] = dhgen_kind_within_wide(q[6], 0.0 < excess_mp);
    q[9] = angle2; q[10] = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, Y2_m); q[11] = q3_mm;
    kind[3] = dhgen_kind_within_wide(q[9], 0.0 < excess_mm);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7] + T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D1_squared) <= m1 * (merge_slack2 + 2.0 *
        dhgen_abs_wide(Z1))) | (N1 <= doubt_limit_squared4) | (v9 <= m3) | (v10 <= m3)) |
        (dhgen_within_slack_wide(excess_mm) | dhgen_within_slack_wide(excess_mp) |
        dhgen_within_slack_wide(excess_pp) | dhgen_within_slack_wide(excess_pm));
}

#if DHGEN_LANES > 1
static const double
    m4 = 0.5; /* 1 / 2 */
/* One regular pose, two signs in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e2 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double X1 = crank * T24 * 2.0, Y1 = 2.0 * (crank * T14), N1 = X1 * X1 + Y1 * Y1,
        Z1 = T14 * T14 + (T24 * T24 + (k1 + T34 * T34)), D1_squared = N1 - Z1 * Z1,
        w1 = sqrt(D1_squared), inverse1 = DHGEN_QUOTIENT(1.0, N1), v1 = X1 * Z1, v2 = Y1 * Z1,
        v3 = inverse1 * v2;
    const dhgen_four c1 = v3 - w1 * (inverse1 * (e1 * X1));
    const double v4 = inverse1 * v1;
    const dhgen_four s1 = v4 + w1 * (inverse1 * (e1 * Y1));

    /* theta2 */
    const double v5 = X1 * T14 - T24 * Y1, v6 = m2 - inverse1 * (T24 * v1 + T14 * v2);
    const dhgen_four X2 = v6 + w1 * (inverse1 * (e1 * v5)), Y2 = T24 * c1 - T14 * s1,
        v7 = X2 * X2 + Y2 * Y2, v8 = dhgen_signed_four(DHGEN_HALF_TURN, Y2), v9 = e2 - 1.0,
        v10 = m4 * v9;

    /* theta3 */
    const double s3 = k2 * (rod * T34), v11 = copysign(DHGEN_HALF_TURN, s3);
    const dhgen_four v12 = v11 * (m4 * -v9);

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] + T[7] + T[11])) <= DHGEN_ORTHONORMAL) == 0) |
        (v7 <= m3)) | (unsigned)((N1 <= doubt_limit_squared4) | (fabs(D1_squared) <= m1 *
        (merge_slack2 + 2.0 * fabs(Z1)))))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, Y2, 0, 5, 2, 7),
        dhgen_shuffle(c1, -X2, 0, 5, 2, 7)),
        ratio2 = dhgen_ratio_four(dhgen_four_of(s3, s3, s3, s3), dhgen_sqrt_four(v7) *
            DHGEN_QUOTIENT(1.0, v7) * (k2 * (rod * (T24 * (c1 * Y2 - s1 * X2) - T14 * (c1 * X2 + s1
            * Y2) + crank * X2))));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 3, 3), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2);
    const dhgen_four q2 = angle2 + v8 * v10, q3 = v12 + e2 * angle3,
        v13 = dhgen_beyond_four(angle1, joints),
        excess = dhgen_maximum_four(v13, dhgen_exceeds_four(q3, joints + 2));
    const dhgen_four_mask outside = 0.0 < excess;
    if (dhgen_bits_four(dhgen_within_slack_four(excess)))
        return -1;

    dhgen_store_2(q, q + 3, q + 6, q + 9, angle1, q2);
    dhgen_store_1(q + 2, q + 5, q + 8, q + 11, q3);
    const unsigned long long none1 = (dhgen_bits_four(angle1 != angle1) * 0x204081ull &
        0x1010101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[3] = { 3, 7, 11 };
DHGEN_TABLE int choosable[2] = { 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 0.5656, 0.5656, 0.5656, 0.0, 0.0, 0.0 }, 0.5656108597285068, { 1e-14, 1e-14 }, entries, 3,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, delta_leg_fk,
    delta_leg_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) delta_leg_##function
#include "dhgen/functions.h"
