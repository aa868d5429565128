/* SPDX-License-Identifier: MIT
 *
 * The arctangent of lanes, written once for all types, and included for each type by a file that
 * defines DHGEN_VECTOR, DHGEN_MASK, DHGEN_OF for names, and DHGEN_ADDED(x, m, y) for x + y where m
 * holds, else x.
 *
 * The angle of y and x, not both zero and not infinite, in [-pi, pi], within 3 ulp: the multiple of
 * pi/4 next to it and a ratio of at most tan(pi/8), then a polynomial in this. In two steps: of
 * several angles all ratios come first. */

typedef struct {
    DHGEN_VECTOR r, known, y;
} DHGEN_OF(direction);

DHGEN_INLINE DHGEN_OF(direction) DHGEN_OF(ratio)(DHGEN_VECTOR y, DHGEN_VECTOR x)
{
    const DHGEN_VECTOR ax = DHGEN_OF(abs)(x), ay = DHGEN_OF(abs)(y);
    const DHGEN_MASK steep = ay > ax;
    const DHGEN_VECTOR most = DHGEN_OF(maximum)(ay, ax), least = DHGEN_OF(minimum)(ax, ay);
    const DHGEN_MASK turned = least > most * 0.41421356237309515;
    const DHGEN_VECTOR ahead = DHGEN_OF(all)(0.7853981633974483);
    const DHGEN_VECTOR half = DHGEN_OF(all)(1.5707963267948966);
    const DHGEN_VECTOR part = DHGEN_OF(negated)(DHGEN_OF(pick)(steep, -ahead, ahead), x);
    const DHGEN_VECTOR whole = DHGEN_OF(pick)(steep, half, half - 2.0 * part);
    const DHGEN_VECTOR up = DHGEN_ADDED(least, turned, -most);
    const DHGEN_VECTOR down = DHGEN_ADDED(most, turned, least);
    DHGEN_OF(direction) of;
    of.r = DHGEN_QUOTIENT(DHGEN_OF(negated)(up, part), down);
    of.known = DHGEN_ADDED(whole, turned, part);
    of.y = y;
    return of;
}

DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(angle)(DHGEN_OF(direction) of)
{
    const double *const odd = dhgen_arctangent;
    const DHGEN_VECTOR r = of.r, u = r * r, u2 = u * u, u4 = u2 * u2;
    const DHGEN_VECTOR p0 = (odd[0] + odd[1] * u) + (odd[2] + odd[3] * u) * u2;
    const DHGEN_VECTOR p4 = (odd[4] + odd[5] * u) + (odd[6] + odd[7] * u) * u2;
    const DHGEN_VECTOR p8 = (odd[8] + odd[9] * u) + odd[10] * u2;
    const DHGEN_VECTOR p = p0 + (p4 + p8 * u4) * u4;
    return DHGEN_OF(negated)((of.known + r) + r * u * p, of.y);
}

DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(atan2)(DHGEN_VECTOR y, DHGEN_VECTOR x)
{
    return DHGEN_OF(angle)(DHGEN_OF(ratio)(y, x));
}
