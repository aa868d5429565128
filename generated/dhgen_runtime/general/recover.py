# SPDX-License-Identifier: MIT
"""The joints from a root of the determinant: null vectors, then the other angles one by one."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import carray, of_file, room
from ..rigid import follow, invert, take
from .loop import TINY, move, unit
from .places import LEFT_SLIDE, RIGHT_SLIDE, SLIDES
from .tables import STARTS

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

SMALLEST = 1e-15  # a diagonal is taken as no smaller [of the largest], which keeps vectors finite
PLANE = 1e-24  # below this determinant the rows of a shift don't span a plane: rounding, squared
# A matrix is not singular when its smallest singular value is this part of all, and the one before
# that part: where two are small, so many roots crowd that the sampled determinant can't show
# whether they are real.
REGULAR = 2e-7
ALONE = 1e-6


@inner
def _inverse_iteration(U: Floats, inverse: Floats, x: Floats) -> float:
    """Replaces x by U^-1 U^-T x, to length one; `inverse` holds the reciprocals of the diagonal.

    Returns what was its length: the reciprocal of the square of the smallest singular value, in the
    end.
    """
    for i in range(6):
        for j in range(i):
            x[i] -= U[j, i] * x[j]
        x[i] *= inverse[i]
    square = 0.0
    for i in range(5, -1, -1):
        for j in range(i + 1, 6):
            x[i] -= U[i, j] * x[j]
        x[i] *= inverse[i]
        square += x[i] * x[i]
    length = math.sqrt(square) + TINY
    for i in range(6):
        x[i] *= 1.0 / length
    return length


@apart("int64(float64[:, ::1], int64, float64[:, ::1], int64)")
def _split(n: Floats, shift: int, out: Floats, count: int) -> int:
    """Adds vectors w of the plane of two null vectors n with up w = x down w for some x.

    By least squares. The shift, by 3 for x3 or by 1 for x2, takes `down` to `up`. Returns how many
    vectors there are.
    """
    A, G, H = np.zeros((2, 2)), np.zeros((2, 2)), np.zeros((2, 2))
    for i in range(2):
        for j in range(2):
            for k in range(3 if shift == 3 else 4):
                up = k if shift == 3 else k + k // 2
                A[i, j] += n[i, up + shift] * n[j, up]
                G[i, j] += n[i, up + shift] * n[j, up + shift]
                H[i, j] += n[i, up] * n[j, up]
    det = G[0, 0] * G[1, 1] - G[0, 1] * G[0, 1]
    det_h = H[0, 0] * H[1, 1] - H[0, 1] * H[0, 1]
    if det < det_h:  # 1/x is the better unknown
        A[0, 1], A[1, 0] = A[1, 0], A[0, 1]
        G, det = H, det_h
    if det < PLANE:
        return count
    a = (G[1, 1] * A[0, 0] - G[0, 1] * A[1, 0]) / det
    b = (G[1, 1] * A[0, 1] - G[0, 1] * A[1, 1]) / det
    c = (G[0, 0] * A[1, 0] - G[0, 1] * A[0, 0]) / det
    d = (G[0, 0] * A[1, 1] - G[0, 1] * A[0, 1]) / det
    spread = math.sqrt(max(0.25 * (a - d) * (a - d) + b * c, 0.0))
    for sign in (-1.0, 1.0):
        # (M - x) w = 0 from the longer of its rows
        x = 0.5 * (a + d) + sign * spread
        upper = abs(a - x) + abs(b) > abs(d - x) + abs(c)
        w0, w1 = (b, x - a) if upper else (d - x, -c)
        for i in range(6):
            out[count, i] = w0 * n[0, i] + w1 * n[1, i]
        count += 1
    return count


@apart("Tuple((int64, boolean))(float64[:, :, ::1], int64, boolean, float64[:, ::1])")
def null_vectors(factors: Floats, at: int, double: bool, out: Floats) -> tuple[int, bool]:
    """Returns how many vectors near (x3, 1) x (x2^2, x2, 1) go to `out`, and if there is no root.

    One of a simple root, and of a double one also those at which one of the two shifts, x3 or x2,
    has an eigenvalue. There is no root where the matrix, one of those of `fold`, is regular: it has
    no singular value that is next to nothing, and not two small ones, as where so many roots crowd
    that the determinant does not show them.
    """
    factor, inverse = carray(room(36), (6, 6)), carray(room(6), 6)
    n = STARTS.copy()
    length = second = squares = 0.0
    for i in range(6):
        for j in range(i, 6):
            factor[i, j] = factors[i, j, at]
            squares += factor[i, j] * factor[i, j]
    most = 0.0
    for i in range(6):
        most = max(most, abs(factor[i, i]))
    least = most * SMALLEST + TINY
    for i in range(6):
        d = factor[i, i]
        inverse[i] = 1.0 / (d if abs(d) > least else math.copysign(least, d))
    for _ in range(4 if double else 2):
        length = _inverse_iteration(factor, inverse, n[0])
        if double:
            second = _inverse_iteration(factor, inverse, n[1])
            along = 0.0
            for i in range(6):
                along += n[0, i] * n[1, i]
            for i in range(6):
                n[1, i] -= along * n[0, i]
    for i in range(6):
        out[0, i] = n[0, i]
    regular = length * squares < 1.0 / REGULAR**2 and second * squares < 1.0 / ALONE**2
    if not double:
        return 1, regular
    square = 0.0
    for i in range(6):
        square += n[1, i] * n[1, i]
    for i in range(6):
        n[1, i] /= math.sqrt(square) + TINY
    count = 1
    for shift in (3, 1):
        count = _split(n, shift, out, count)
    return count, regular


@inner
def _right_length(K: Floats, M: Floats, value: tuple[float, ...]) -> float:
    """Returns d from invariants of B = Rz K Tz(d) M Rz, by least squares.

    `value` = l_z, p_z, p.l, p.p / 2 and (p x l)_z; those count that are linear in d.
    """
    e0, e1, e2, u0, u1, u2 = M[2], M[6], M[10], M[3], M[7], M[11]
    l0, q0 = K[0] * e0 + K[1] * e1 + K[2] * e2, K[0] * u0 + K[1] * u1 + K[2] * u2 + K[3]
    l1, q1 = K[4] * e0 + K[5] * e1 + K[6] * e2, K[4] * u0 + K[5] * u1 + K[6] * u2 + K[7]
    l2, q2 = K[8] * e0 + K[9] * e1 + K[10] * e2, K[8] * u0 + K[9] * u1 + K[10] * u2 + K[11]
    a, b, c = K[10], e2, K[9] * e0 - K[8] * e1
    total = a * (value[1] - q2) + b * (value[2] - (q0 * l0 + q1 * l1 + q2 * l2))
    total += c * (value[4] - (q0 * l1 - q1 * l0))
    return total / (a * a + b * b + c * c + TINY)


@inner
def _middle_before_slide(K: Floats, M: Floats, B: Floats) -> tuple[float, float]:
    """Returns c and s of phi5 in B = Rz K Rz(phi5) M Tz, from the third row of K."""
    x = B[8] * M[0] + B[9] * M[1] + B[10] * M[2]
    y = B[8] * M[4] + B[9] * M[5] + B[10] * M[6]
    return unit(K[8] * x + K[9] * y, K[9] * x - K[8] * y)


@inner
def _middle(K: Floats, M: Floats, value: tuple[float, ...]) -> tuple[float, float]:
    """Returns c and s of phi5 from invariants of B = Rz K Rz(phi5) M Rz, by least squares.

    `value` = l_z, p_z, p.l, p.p / 2 and (p x l)_z.
    """
    t0, t1, t2 = K[3], K[7], K[11]
    e0, e1, e2, u0, u1, u2 = M[2], M[6], M[10], M[3], M[7], M[11]
    axis = (K[8], K[9], K[10])
    foot = (
        K[0] * t0 + K[4] * t1 + K[8] * t2,
        K[1] * t0 + K[5] * t1 + K[9] * t2,
        K[2] * t0 + K[6] * t1 + K[10] * t2,
    )
    side = (K[4] * t0 - K[0] * t1, K[5] * t0 - K[1] * t1, K[6] * t0 - K[2] * t1)
    e, u = (e0, e1, e2), (u0, u1, u2)
    v = (u1 * e2 - u2 * e1, u2 * e0 - u0 * e2, u0 * e1 - u1 * e0)
    pairs = ((axis, e), (axis, u), (foot, e), (foot, u), (axis, v))
    rest = (
        0.0,
        t2,
        u0 * e0 + u1 * e1 + u2 * e2,
        0.5 * (t0 * t0 + t1 * t1 + t2 * t2 + u0 * u0 + u1 * u1 + u2 * u2),
        side[2] * e2,
    )
    aa = ab = bb = ar = br = 0.0
    for i in range(5):
        left, right = pairs[i]
        a = left[0] * right[0] + left[1] * right[1]
        b = left[1] * right[0] - left[0] * right[1]
        r = value[i] - rest[i] - left[2] * right[2]
        if i == 4:
            a += side[0] * e0 + side[1] * e1
            b += side[1] * e0 - side[0] * e1
        aa += a * a
        ab += a * b
        bb += b * b
        ar += a * r
        br += b * r
    return unit(bb * ar - ab * br, aa * br - ab * ar)


@inner
def _partners(arm: Floats, joints: Ints, n: Floats, c: Floats, s: Floats) -> None:
    """Computes the cosines and sines of phi_2 and phi_3 from a null vector."""
    up = n[0] * n[0] + n[1] * n[1] + n[2] * n[2]
    down = n[3] * n[3] + n[4] * n[4] + n[5] * n[5]
    row = n[:3] if up > down else n[3:]
    sign = math.copysign(1.0, row[0] + row[2])
    c[1], s[1] = unit(sign * (row[2] - row[0]), sign * 2.0 * row[1])
    top = n[0] * row[0] + n[1] * row[1] + n[2] * row[2]
    bottom = n[3] * row[0] + n[4] * row[1] + n[5] * row[2]
    c[2], s[2] = unit(bottom * bottom - top * top, 2.0 * top * bottom)
    if arm[LEFT_SLIDE] > 0.0:
        if arm[SLIDES + joints[1]] > 0.0:  # x^2 over x and x over 1, by least squares
            s[1] = row[1] * (row[0] + row[2]) / (row[1] * row[1] + row[2] * row[2] + TINY)
        if arm[SLIDES + joints[2]] > 0.0:
            s[2] = top * bottom / (bottom * bottom + TINY)


@apart("void(float64[::1], int64[::1], float64[:, ::1], float64[::1], float64[::1], float64[::1])")
def angles(arm: Floats, joints: Ints, links: Floats, n: Floats, c: Floats, s: Floats) -> None:
    """Computes the cosines and sines of phi_2 ... phi_6 from phi_1 and a null vector, in place."""
    _partners(arm, joints, n, c, s)
    G = carray(room(12), 12)
    take(G, links[5])
    for i in range(3):
        move(arm, G, joints[i], c[i], s[i])
        follow(G, links[i])
    B = invert(G)
    l0, l1, q0, q1 = B[2], B[6], B[3], B[7]
    square = G[3] * G[3] + G[7] * G[7] + G[11] * G[11]
    value = (B[10], B[11], -G[11], 0.5 * square, q0 * l1 - q1 * l0)
    slides_4, slides_5 = arm[SLIDES + joints[4]] > 0.0, arm[SLIDES + joints[5]] > 0.0
    if arm[RIGHT_SLIDE] == 0.0:
        c[4], s[4] = _middle(links[3], links[4], value)
    elif slides_4:
        c[4], s[4] = 1.0, _right_length(links[3], links[4], value)
    else:
        c[4], s[4] = _middle_before_slide(links[3], links[4], B)
    C = carray(room(12), 12)
    take(C, links[3])
    move(arm, C, joints[4], c[4], s[4])
    follow(C, links[4])
    cosine, sine = C[2] * l0 + C[6] * l1, C[2] * l1 - C[6] * l0
    if arm[RIGHT_SLIDE] == 0.0:
        cosine, sine = cosine + C[3] * q0 + C[7] * q1, sine + C[3] * q1 - C[7] * q0
    elif slides_4:
        cosine += C[3] * q0 + C[7] * q1
        sine += C[3] * q1 - C[7] * q0
    else:
        for j in range(2):
            cosine += C[j] * B[j] + C[4 + j] * B[4 + j]
            sine += C[j] * B[4 + j] - C[4 + j] * B[j]
    c[3], s[3] = unit(cosine, sine)
    if slides_5:  # along the third column of B
        x, y = c[3] * C[3] - s[3] * C[7], s[3] * C[3] + c[3] * C[7]
        c[5], s[5] = 1.0, -G[11] - x * l0 - y * l1 - C[11] * B[10]
        return
    cosine = sine = 0.0
    for i in range(2):
        for j in range(2):
            # columns of Rz(phi_4) C against columns of B
            x, y = c[3] * C[j] - s[3] * C[4 + j], s[3] * C[j] + c[3] * C[4 + j]
            along = x * B[i] + y * B[4 + i] + C[8 + j] * B[8 + i]
            if i == j:
                cosine += along
            else:
                sine += -along if i else along
    c[5], s[5] = unit(cosine, sine)
