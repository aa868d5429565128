/* SPDX-License-Identifier: MIT
 *
 * Angles of lanes moved by a whole turn, and joint values and their limits, written once for all
 * types, and included for each type by a file that defines DHGEN_VECTOR, DHGEN_MASK, and DHGEN_OF
 * for names. */

/* An angle moved to (-pi, pi] that may be below. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(raised)(DHGEN_VECTOR x)
{
    return x + DHGEN_OF(only)(x <= -DHGEN_HALF_TURN, DHGEN_TURN);
}

/* An angle moved to (-pi, pi] that may be above. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(lowered)(DHGEN_VECTOR x)
{
    return x - DHGEN_OF(only)(DHGEN_HALF_TURN < x, DHGEN_TURN);
}

/* An angle moved to (-pi, pi] that may be either. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(centred)(DHGEN_VECTOR x)
{
    return x
        + DHGEN_OF(pick)(x <= -DHGEN_HALF_TURN, DHGEN_OF(all)(DHGEN_TURN),
            DHGEN_OF(only)(DHGEN_HALF_TURN < x, -DHGEN_TURN));
}

/* How far a joint is beyond its limits; negative inside. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(beyond)(DHGEN_VECTOR x, const struct dhgen_joint *joint)
{
    return DHGEN_OF(maximum)(dhgen_low(joint) - x, x - dhgen_high(joint));
}

/* How far a joint is beyond its limits where these are alike on both sides. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(exceeds)(DHGEN_VECTOR x, const struct dhgen_joint *joint)
{
    return DHGEN_OF(abs)(x) - dhgen_high(joint);
}

/* Whether a joint that is so far beyond its limits may be so by rounding. */
DHGEN_INLINE DHGEN_MASK DHGEN_OF(within_slack)(DHGEN_VECTOR x)
{
    return DHGEN_OF(abs)(x - DHGEN_NEAR_LIMIT) <= DHGEN_NEAR_LIMIT;
}
