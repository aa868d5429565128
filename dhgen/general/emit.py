"""What the templates of the general algorithm are filled in with: finished strings."""

from __future__ import annotations

from math import pi
from textwrap import indent
from typing import TYPE_CHECKING

from dhgen.general import circle, polish, reference
from dhgen.general.determinant import TINY
from dhgen.general.digits import HALF_CELLS, grid, harmonics
from dhgen.general.loop import reach
from dhgen.general.offset_wrist import BARELY, NEARLY_RIGHT
from dhgen.numerical.kernel import FEW_STARTS
from dhgen.program.arctangent import STEEP, arctangent_coefficients
from dhgen.targets.layout import c_array, python_array
from dhgen.targets.templates import render

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.general.formulation import Formulation
    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.rigid import Matrix
    from dhgen.kinematics.chain import Chain

PADDED = 168  # 162 rows, to a multiple of eight
PADDED_RIGHT = 128  # 126
LEFT_ROW = 32  # 27
ROOTS = 24  # more than 16 come from rounding
CANDIDATES = 96


def c_source(kernel: GeneralKernel, name: str) -> str:
    """The static functions of `<name>_general` in C99; they need <math.h>."""
    return render("c/general6r.c.jinja", p=name, P=name.upper(), t=values(kernel))


def python_source(kernel: GeneralKernel, name: str) -> str:
    """The function `<name>_general` in Python; it needs numba and numpy."""
    return render("python/general6r.py.jinja", p=name, P=name.upper(), t=values(kernel))


def c_rows(chain: Chain, name: str) -> str:
    """The static function `all_joints` in C99; it calls `<name>_general` and the descent."""
    facing, zero = _behind(chain)
    return render(
        "c/general6r_rows.c.jinja",
        p=name,
        n=_descent(),
        facing=indent(c_array("static const double facing[6]", facing), "    "),
        zero=indent(c_array("static const double zero[6]", zero), "    "),
    )


def python_rows(chain: Chain, name: str) -> str:
    """The function `_all_joints` in Python; it calls `<name>_general` and the descent."""
    facing, zero = _behind(chain)
    return render(
        "python/general6r_rows.py.jinja",
        p=name,
        n=_descent(),
        facing=python_array("_FACING = np.array", facing),
        zero=python_array("_ZERO = np.array", zero),
    )


def _descent() -> dict[str, str]:
    return {"residual": repr(reference.RESIDUAL), "starts": str(FEW_STARTS)}


def _behind(chain: Chain) -> tuple[list[str], list[str]]:
    """Signs and offsets of the joint values behind the angles of the algebra."""
    return _numbers(float(j.sign) for j in chain.joints), _numbers(j.offset for j in chain.joints)


def values(kernel: GeneralKernel) -> dict[str, object]:
    """The constants of an arm and of the algorithm, as text."""
    loop = kernel.loop
    grid_c, grid_s = grid()
    return {
        "left": _numbers(_rows(loop.left)),
        "right": _numbers(_rows(loop.right)),
        "links": [_numbers(_rows(K)) for K in loop.links],
        "per_size": repr(1.0 / loop.size),
        # farther than all links in line the arm does not reach
        "reach": repr((1.0 + 1e-9) * reach(loop) * reach(loop)),
        "nudges": [_numbers(_rows(nudge)) for nudge in reference.nudges()],
        "formulations": [_formulation(f) for f in kernel.formulations],
        "sample_c": _numbers(circle.sample_cosines()[0]),
        "sample_s": _numbers(circle.sample_cosines()[1]),
        "harmonics": [_numbers(row) for row in harmonics()],
        "grid_c": [_numbers(row) for row in grid_c],
        "grid_s": [_numbers(row) for row in grid_s],
        "wrist": _wrist(kernel),
        "padded": PADDED,
        "padded_right": PADDED_RIGHT,
        "roots": ROOTS,
        "candidates": CANDIDATES,
        **_tolerances(),
    }


def _tolerances() -> dict[str, object]:
    return {
        "arctangent": _numbers(arctangent_coefficients()),
        "tangent": repr(STEEP),
        "pi": repr(pi),
        "turn": repr(2 * pi),
        "half": repr(pi / 2),
        "quarter": repr(pi / 4),
        "almost_pi": repr(pi - 1e-14),
        "tiny": repr(TINY),
        "cells": circle.CELLS,
        "half_cells": HALF_CELLS,
        "width": repr(circle.WIDTH),
        "deepest": circle.DEEPEST,
        "halvings": circle.HALVINGS,
        "between": 4 * circle.NEWTON_STEPS,
        "quintic": repr(circle.QUINTIC),
        "rounding": repr(circle.ROUNDING),
        "noise_factor": repr(circle.NOISE_FACTOR),
        # the value of a parabola over its bend
        "lifted": repr(0.5 * circle.LIFTED**2),
        "noise": repr(reference.NOISE),
        "residual": repr(reference.RESIDUAL),
        "together": repr(reference.TOGETHER),
        "same": repr(reference.SAME),
        # the square of the sum of two unit vectors that are this close
        "close": repr(4.0 - reference.CLOSE**2),
        "steps": reference.STEPS,
        "steps_from_afar": reference.STEPS_FROM_AFAR,
        "batches": 8,
        "tie": repr(1e-9),
        "rank": repr(1e-9),
        "singular": repr(1e-6),
        "good_enough": repr(1e-29),
        "smallest": repr(1e-15),
        "smallest_square": repr(1e-30),
        "damping": repr(polish.DAMPING),
        "plane": repr(1e-24),
        # anything that no null vector is orthogonal to
        "start": _numbers((0.61, -0.37, 0.53, 0.29, 0.71, -0.43)),
        "start_2": _numbers((-0.31, 0.47, 0.59, 0.67, -0.23, 0.41)),
    }


def _numbers(numbers: Iterable[float]) -> list[str]:
    return [repr(x) for x in numbers]


def _rows(K: Matrix | None) -> list[float]:
    """The upper three rows; nothing for the pose."""
    return [0.0] * 12 if K is None else [x for row in K[:3] for x in row]


def _formulation(f: Formulation) -> dict[str, object]:
    height = PADDED_RIGHT if f.splits_each_pose else PADDED
    columns: Sequence[Sequence[float]] = tuple(zip(*f.table, strict=True))
    features = tuple(zip(*f.left, strict=True)) if f.left else ()
    return {
        "joints": [str(joint) for joint in f.joints],
        "sign": repr(float(f.sign)),
        "inverted": int((f.sign > 0) != f.splits_each_pose),
        "pose": f.pose,
        "each_pose": int(f.splits_each_pose),
        "links": [_numbers(_rows(K)) for K in f.links],
        "table": [_numbers(_padded(column, height)) for column in columns],
        "left": [_numbers(_padded(row, LEFT_ROW)) for row in features],
    }


def _wrist(kernel: GeneralKernel) -> dict[str, object] | None:
    """The numbers of an offset wrist."""
    arm = kernel.wrist
    if arm is None:
        return None
    K0, K1, K2, K3, _ = kernel.loop.links
    elbow = [K1[i][3] + arm.elbow * K1[i][2] for i in range(2)]
    wrist = [K2[i][3] + arm.wrist_4 * K2[i][2] for i in range(2)]
    return {
        "shoulder": repr(arm.shoulder),
        "wrist_5": repr(arm.wrist_5),
        "upper": repr(arm.upper),
        "lower": repr(arm.lower),
        "upper_square": repr(arm.upper * arm.upper),
        "lower_square": repr(arm.lower * arm.lower),
        "cosine": repr(arm.cosine),
        "sine": repr(arm.sine),
        "flip": repr(arm.flip),
        "bent": bool(arm.sine),
        "per_root": arm.solutions_per_root,
        # what the turns of joints 1 ... 4 bring into line with axis 3, E, W and z5
        "sources": _numbers([K0[0][2], K0[1][2], *elbow, *wrist, K3[0][2], K3[1][2]]),
        "nearly_right": repr(NEARLY_RIGHT),
        "barely": repr(BARELY),
    }


def _padded(row: Sequence[float], length: int) -> list[float]:
    return [*row, *[0.0] * (length - len(row))]
