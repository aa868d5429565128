"""Constant frames: base, tool and home, from any of the ways of writing a rotation."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.robot.angles import ROUNDING, SNAP, cosine, sine
from dhgen.robot.exact import add, multiply, negate, number, subtract
from dhgen.robot.expression import ONE, ZERO, Expression
from dhgen.robot.robot import Frame

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.robot.cells import Cells
    from dhgen.robot.reader import Path
    from dhgen.robot.schema import FrameEntry


Rows = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]

IDENTITY: tuple[Expression, ...] = (ONE, ZERO, ZERO, ZERO, ONE, ZERO, ZERO, ZERO, ONE)


def from_rpy(angles: Sequence[Expression], values: Sequence[float]) -> tuple[Expression, ...]:
    """R = Rz(yaw) Ry(pitch) Rx(roll), rotations about fixed axes as in URDF.

    Args:
        angles: Roll, pitch, yaw in radians.
        values: The same as floats.
    """
    cr, cp, cy = (cosine(angle, value) for angle, value in zip(angles, values, strict=True))
    sr, sp, sy = (sine(angle, value) for angle, value in zip(angles, values, strict=True))
    return (
        multiply(cy, cp),
        subtract(multiply(multiply(cy, sp), sr), multiply(sy, cr)),
        add(multiply(multiply(cy, sp), cr), multiply(sy, sr)),
        multiply(sy, cp),
        add(multiply(multiply(sy, sp), sr), multiply(cy, cr)),
        subtract(multiply(multiply(sy, sp), cr), multiply(cy, sr)),
        negate(sp),
        multiply(cp, sr),
        multiply(cp, cr),
    )


def from_quaternion(x: Fraction, y: Fraction, z: Fraction, w: Fraction) -> tuple[Fraction, ...]:
    """The rotation of a quaternion of any length but zero.

    Dividing by the squared norm instead of normalising needs no square root: the matrix of a
    rational quaternion is rational, and exactly orthonormal.
    """
    n = x * x + y * y + z * z + w * w
    return (
        1 - 2 * (y * y + z * z) / n,
        2 * (x * y - z * w) / n,
        2 * (x * z + y * w) / n,
        2 * (x * y + z * w) / n,
        1 - 2 * (x * x + z * z) / n,
        2 * (y * z - x * w) / n,
        2 * (x * z - y * w) / n,
        2 * (y * z + x * w) / n,
        1 - 2 * (x * x + y * y) / n,
    )


def to_quaternion(rows: Rows) -> tuple[float, float, float, float]:
    """The quaternion x, y, z, w of a rotation, by its largest component (Shepperd 1978)."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    squares = (1 + a - e - i, 1 - a + e - i, 1 - a - e + i, 1 + a + e + i)
    largest = max(range(4), key=lambda k: squares[k])
    candidates = (
        (squares[0], b + d, c + g, h - f),
        (b + d, squares[1], f + h, c - g),
        (c + g, f + h, squares[2], d - b),
        (h - f, c - g, d - b, squares[3]),
    )
    x, y, z, w = candidates[largest]
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    return x / norm, y / norm, z / norm, w / norm


def nearest_rotation(rows: Rows) -> Rows:
    """The rotation nearest to a nearly orthonormal matrix: Newton's iteration for its polar factor.

    X becomes (X + X^-T)/2 (Higham 1986); three steps take an error of 1e-6 below rounding.
    """
    x = rows
    for _ in range(4):
        cofactors = _cofactors(x)
        size = dot(x[0], cofactors[0])
        r0, r1, r2 = (
            tuple((p + q / size) / 2 for p, q in zip(row, minors, strict=True))
            for row, minors in zip(x, cofactors, strict=True)
        )
        x = ((r0[0], r0[1], r0[2]), (r1[0], r1[1], r1[2]), (r2[0], r2[1], r2[2]))
    return x


def dot(a: Sequence[float], b: Sequence[float]) -> float:
    """The inner product."""
    return sum(p * q for p, q in zip(a, b, strict=True))


def determinant(rows: Rows) -> float:
    """The determinant; +1 for a rotation, -1 for a mirror."""
    return dot(rows[0], _cofactors(rows)[0])


def _cofactors(rows: Rows) -> Rows:
    (a, b, c), (d, e, f), (g, h, i) = rows
    return (
        (e * i - f * h, f * g - d * i, d * h - e * g),
        (c * h - b * i, a * i - c * g, b * g - a * h),
        (b * f - c * e, c * d - a * f, a * e - b * d),
    )


def numbers(values: Sequence[Fraction]) -> tuple[Expression, ...]:
    """Fractions as expressions."""
    return tuple(number(value) for value in values)


IDENTITY_FRAME = Frame((ZERO, ZERO, ZERO), IDENTITY)

_ROTATIONS = ("rpy", "quaternion_xyzw", "quaternion_wxyz", "matrix")
_TOLERANCE = 1e-6  # what a matrix written with six digits is off
_EXACT = 1e-12  # what a matrix written with all digits is off


def read_frame(cells: Cells, path: Path, entry: FrameEntry) -> Frame:
    """A frame as written; mistakes are reported.

    Args:
        cells: Reads the cells, and reports.
        path: The place of the frame.
        entry: Its keys.
    """
    document = cells.report.document
    keys = ["matrix"] if entry.matrix else []
    if isinstance(plain := document.plain(path), dict):
        keys = [key for key in plain if getattr(entry, key, None)]
    given = [key for key in keys if key in _ROTATIONS]
    for key in given[1:]:
        message = (
            f"'{given[0]}' already gives the rotation: write only one of {', '.join(_ROTATIONS)}"
        )
        cells.report.error_at_key((*path, key), message)
    if "matrix" in given and "xyz" in keys:
        message = "'matrix' already gives the translation: write only one of xyz, matrix"
        cells.report.error_at_key((*path, "xyz"), message)
    xyz = read_lengths(cells, (*path, "xyz"), entry.xyz)
    frames = [_read_rotation(cells, (*path, key), entry, xyz) for key in given]
    return frames[0] if frames else Frame(xyz, IDENTITY)


def _read_rotation(
    cells: Cells, path: Path, entry: FrameEntry, xyz: tuple[Expression, Expression, Expression]
) -> Frame:
    match path[-1]:
        case "rpy":
            angles = [cells.angle((*path, i), cell) for i, cell in enumerate(entry.rpy)]
            return Frame(xyz, from_rpy(angles, [cells.value(angle) for angle in angles]))
        case "quaternion_xyzw":
            return Frame(xyz, _from_quaternion(cells, path, "xyzw", entry.quaternion_xyzw))
        case "quaternion_wxyz":
            return Frame(xyz, _from_quaternion(cells, path, "wxyz", entry.quaternion_wxyz))
        case _:
            return _from_matrix(cells, path, entry.matrix)


def read_lengths(
    cells: Cells, path: Path, entry: list[str]
) -> tuple[Expression, Expression, Expression]:
    """Three lengths, the origin when there are none."""
    if not entry:
        return ZERO, ZERO, ZERO
    x, y, z = (cells.length((*path, i), cell) for i, cell in enumerate(entry))
    return x, y, z


def _from_quaternion(
    cells: Cells, path: Path, order: str, components: list[str]
) -> tuple[Expression, ...]:
    parsed = [cells.parse((*path, i), cell) for i, cell in enumerate(components)]
    values = dict(zip(order, (cells.value(part) for part in parsed), strict=True))
    norm = math.hypot(*values.values())
    if math.isnan(norm):
        return IDENTITY
    if norm <= SNAP:
        cells.report.error(path, "a quaternion of length 0 is not a rotation")
        return IDENTITY
    if abs(norm - 1) > SNAP:
        cells.report.notice(path, f"the quaternion has length {norm:.9g} and is normalised")
    x, y, z, w = (Fraction(repr(values[c])) for c in "xyzw")
    return _exact_rotation(cells, numbers(from_quaternion(x, y, z, w)))


def _from_matrix(cells: Cells, path: Path, entry: list[list[str]]) -> Frame:
    x, y, z = (cells.length((*path, i, 3), entry[i][3]) for i in range(3))
    places = [(i, j) for i in range(3) for j in range(3)]
    given = tuple(cells.parse((*path, i, j), entry[i][j]) for i, j in places)
    snapped = len(cells.snapped), len(cells.taken)
    exact = tuple(cells.ratio((*path, i, j), entry[i][j]) for i, j in places)
    bottom = [cells.value(cells.parse((*path, 3, j), entry[3][j])) for j in range(4)]
    if any(abs(p - q) > SNAP for p, q in zip(bottom, (0, 0, 0, 1), strict=True)):
        cells.report.error((*path, 3), "the last row of a frame's matrix must be 0 0 0 1")
    rows = _rows([cells.value(cell) for cell in exact])
    deviation = _check_rotation(cells, path, rows)
    off = _deviation(_rows([cells.value(cell) for cell in given]))
    if deviation > max(off, 4 * ROUNDING) and off <= _EXACT:
        # the cosine of a small angle is nearer to 1 than its sine to 0: a rotation is left as given
        del cells.snapped[snapped[0] :], cells.taken[snapped[1] :]
        return Frame((x, y, z), given)
    if deviation > _EXACT:
        message = f"the rotation is off by {deviation:.1e}; the nearest exact one is used"
        cells.report.notice(path, message)
        quaternion = (Fraction(repr(value)) for value in to_quaternion(nearest_rotation(rows)))
        return Frame((x, y, z), _exact_rotation(cells, numbers(from_quaternion(*quaternion))))
    return Frame((x, y, z), exact)


def _exact_rotation(cells: Cells, given: tuple[Expression, ...]) -> tuple[Expression, ...]:
    """A computed rotation, with the entries exact that are so but for rounding, if all can be."""
    exact = cells.exact_ratios(given)
    return exact if _is_as_orthonormal(cells, exact, given) else given


def _is_as_orthonormal(
    cells: Cells, exact: Sequence[Expression], given: Sequence[Expression]
) -> bool:
    """Whether exact entries are a rotation as much as the given ones are.

    The cosine of a small angle is nearer to 1 than its sine to 0: one taken as exact without the
    other leaves a matrix that is no rotation.
    """
    off = [_deviation(_rows([cells.value(entry) for entry in each])) for each in (exact, given)]
    return off[0] <= max(off[1], 4 * ROUNDING)


def _rows(values: Sequence[float]) -> Rows:
    a, b, c, d, e, f, g, h, i = values
    return (a, b, c), (d, e, f), (g, h, i)


def _check_rotation(cells: Cells, path: Path, rows: Rows) -> float:
    """How far the matrix is from a rotation; 0 after a mistake, which is reported."""
    if any(math.isnan(value) for row in rows for value in row):
        return 0.0
    for i, row in enumerate(rows):
        length = math.hypot(*row)
        if abs(length - 1) > _TOLERANCE:
            message = f"not orthonormal: the rotation's row {i + 1} has length {length:.9g}, not 1"
            cells.report.error((*path, i), message)
            return 0.0
    products = {(i, j): dot(rows[i], rows[j]) for i, j in ((0, 1), (0, 2), (1, 2))}
    for (i, j), product in products.items():
        if abs(product) > 2 * _TOLERANCE:
            message = f"not orthonormal: rows {i + 1} and {j + 1} have product {product:.6g}, not 0"
            cells.report.error((*path, j), message)
            return 0.0
    if determinant(rows) < 0:
        cells.report.error(path, "the determinant is -1, not 1: this is a mirror, not a rotation")
        return 0.0
    return _deviation(rows)


def _deviation(rows: Rows) -> float:
    """How far rows are from orthonormal: their lengths from 1, half their products from 0."""
    products = (dot(rows[i], rows[j]) for i, j in ((0, 1), (0, 2), (1, 2)))
    lengths = (abs(math.hypot(*row) - 1) for row in rows)
    return max(*lengths, *(abs(product) / 2 for product in products))
