/* SPDX-License-Identifier: MIT
 *
 * What a vector can do, written once for all types, and included for each type by a file that
 * defines DHGEN_VECTOR, DHGEN_MASK, DHGEN_SIZE, and DHGEN_OF for names. */

/* A number in all lanes. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(all)(double x)
{
    const DHGEN_VECTOR zero = { 0.0 };
    return x - zero;
}

/* A number where the mask is set, else zero. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(only)(DHGEN_MASK m, double x)
{
    return (DHGEN_VECTOR)(m & (DHGEN_MASK)DHGEN_OF(all)(x));
}

DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(copysign)(DHGEN_VECTOR x, DHGEN_VECTOR y)
{
    const DHGEN_MASK sign = (DHGEN_MASK)DHGEN_OF(all)(-0.0);
    return (DHGEN_VECTOR)((sign & (DHGEN_MASK)y) | (~sign & (DHGEN_MASK)x));
}

/* A number with the signs of lanes. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(signed)(double x, DHGEN_VECTOR y)
{
    return DHGEN_OF(copysign)(DHGEN_OF(all)(x), y);
}

/* The negative where another number's sign is set. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(negated)(DHGEN_VECTOR x, DHGEN_VECTOR where)
{
    return (DHGEN_VECTOR)((DHGEN_MASK)x ^ (DHGEN_MASK)DHGEN_OF(signed)(0.0, where));
}

DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(abs)(DHGEN_VECTOR x)
{
    return DHGEN_OF(copysign)(x, DHGEN_OF(all)(0.0));
}

DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(sin)(DHGEN_VECTOR x)
{
    for (int k = 0; k < DHGEN_SIZE; k++)
        x[k] = sin(x[k]);
    return x;
}

DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(cos)(DHGEN_VECTOR x)
{
    for (int k = 0; k < DHGEN_SIZE; k++)
        x[k] = cos(x[k]);
    return x;
}

/* Angles moved by whole turns to (-pi, pi]. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(wrap)(DHGEN_VECTOR x)
{
    for (int k = 0; k < DHGEN_SIZE; k++)
        x[k] = dhgen_wrap(x[k]);
    return x;
}
