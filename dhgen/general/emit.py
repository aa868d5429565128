"""What the templates of the general algorithm are filled in with: finished strings."""

from __future__ import annotations

from math import isinf, pi
from textwrap import indent
from typing import TYPE_CHECKING

from dhgen.general import circle, lens, polish, reference
from dhgen.general.determinant import TINY
from dhgen.general.digits import HALF_CELLS, grid, harmonics
from dhgen.general.formulation import PARTNERS
from dhgen.general.four_turns import NEARLY_FLAT, PARALLEL
from dhgen.general.loop import LINKS, reach
from dhgen.general.offset_wrist import BARELY, NEARLY_RIGHT
from dhgen.numerical.kernel import FEW_STARTS
from dhgen.program.arctangent import STEEP, arctangent_coefficients
from dhgen.targets.layout import c_array, python_array
from dhgen.targets.templates import render

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.links import Held, Link
    from dhgen.general.rigid import Matrix
    from dhgen.kinematics.chain import Chain

ROOTS = 24  # more than 16 come from rounding
CANDIDATES = 96


def c_source(kernel: GeneralKernel, name: str) -> str:
    """The static functions of `<name>_general` in C99; they need <math.h>."""
    return render("c/general6r.c.jinja", p=name, P=name.upper(), t=_c_values(kernel, name))


def python_source(kernel: GeneralKernel, name: str) -> str:
    """The function `<name>_general` in Python; it needs numba and numpy."""
    return render("python/general6r.py.jinja", p=name, P=name.upper(), t=_python_values(kernel))


def c_rows(kernel: GeneralKernel, chain: Chain, name: str) -> str:
    """The static function `all_joints` in C99; it calls `<name>_general` and the descent."""
    facing, zero = _behind(chain)
    return render(
        "c/general6r_rows.c.jinja",
        p=name,
        dof=chain.dof,
        n=_descent(chain, kernel),
        facing=indent(c_array(f"static const double facing[{len(facing)}]", facing), "    "),
        zero=indent(c_array(f"static const double zero[{len(zero)}]", zero), "    "),
        **_c_free(kernel),
    )


def python_rows(kernel: GeneralKernel, chain: Chain, name: str) -> str:
    """The function `_all_joints` in Python; it calls `<name>_general` and the descent."""
    facing, zero = _behind(chain)
    return render(
        "python/general6r_rows.py.jinja",
        p=name,
        dof=chain.dof,
        n=_descent(chain, kernel),
        facing=python_array("_FACING = np.array", facing),
        zero=python_array("_ZERO = np.array", zero),
        **_python_free(kernel),
    )


def _descent(chain: Chain, kernel: GeneralKernel) -> dict[str, object]:
    return {
        "rows": kernel.rows,
        "solved": str(chain.dof - chain.given),
        "pointing": kernel.pointing,
        "pose": "whole" if kernel.pointing else "T",
        "residual": repr(reference.RESIDUAL),
        "starts": str(FEW_STARTS),
        "given": [number - 1 for number in chain.free],
    }


def _behind(chain: Chain) -> tuple[list[str], list[str]]:
    """Signs and offsets of the joint values behind the loop's angles and lengths."""
    signs = _numbers(float(joint.sign) for joint in chain.solved)
    return signs, _numbers(joint.offset for joint in chain.solved)


def _c_free(kernel: GeneralKernel) -> dict[str, str]:
    count = len(kernel.given)
    return {
        "free_parameter": f", const double free_joints[{count}]" if count else "",
        "free_argument": ", free_joints" if count else "",
    }


def _python_free(kernel: GeneralKernel) -> dict[str, str]:
    return {"free_argument": ", q_free" if kernel.given else ""}


def _c_values(kernel: GeneralKernel, name: str) -> dict[str, object]:
    places = [f"loop->link[{i}]" for i in range(LINKS)]
    slides = kernel.loop.slides
    partners = {f"partner_{place + 1}": f"{name}_tangents" for place in PARTNERS}
    if slides and not kernel.slides_on_the_right:
        for place in PARTNERS:
            choice = f"{name}_slides(form->joint[{place}]) ? {name}_lengths : {name}_tangents"
            partners[f"partner_{place + 1}"] = choice
    return {
        **_values(kernel),
        **_c_free(kernel),
        **partners,
        "given": _given(kernel, "free_joints"),
        "has_turned": any(not held.slides for held in _held(kernel)),
        "has_slid": any(held.slides for held in _held(kernel)),
        "links": _links(kernel, [*places, "P", "right"]),
        "is_slide": " || ".join(f"joint == {place}" for place in slides),
        "sine_of_start": f"{name}_slides(i) ? angle : sin(angle)" if slides else "sin(angle)",
    }


def _python_values(kernel: GeneralKernel) -> dict[str, object]:
    places = [f"links[{i}]" for i in range(LINKS + 2)]
    slides = kernel.loop.slides
    return {
        **_values(kernel),
        **_python_free(kernel),
        "given": _given(kernel, "q_free"),
        "links": _links(kernel, places),
        "circular_gap": _unless_slide("gap", f"min(gap, {2 * pi!r} - gap)", slides),
        "sine_of_start": _unless_slide("q[i]", "math.sin(q[i])", slides),
    }


def _unless_slide(length: str, angle: str, slides: tuple[int, ...]) -> str:
    """What is written for joint i: one thing where it slides, another where it turns."""
    return f"{length} if i in {slides!r} else {angle}" if slides else angle


def _given(kernel: GeneralKernel, array: str) -> list[dict[str, object]]:
    """The angles and lengths of the joints whose values the caller gives."""
    slides = {held.place: held.slides for link in _every_link(kernel) for held, _ in link.rest}
    return [
        {
            "value": f"{'-' if sign < 0 else ''}{array}[{place}]{_plus(offset)}",
            "slides": slides[place],
        }
        for place, (sign, offset) in enumerate(kernel.given)
    ]


def _plus(offset: float) -> str:
    if not offset:
        return ""
    return f" - {-offset!r}" if offset < 0.0 else f" + {offset!r}"


def _every_link(kernel: GeneralKernel) -> list[Link]:
    return [*kernel.loop.links, kernel.loop.left, kernel.loop.right]


def _links(kernel: GeneralKernel, to: Sequence[str]) -> list[dict[str, object]]:
    """How the links come from constants and the joints that are given; `to`: where they go."""
    result: list[dict[str, object]] = []
    count = 0
    for link, place in zip(_every_link(kernel), to, strict=True):
        rest = []
        first = count
        for held, _ in link.rest:
            count += 1
            rest.append({"behind": count, **_motion(held)})
        count += 1
        result.append({"to": place, "first": first, "rest": rest})
    return result


def _held(kernel: GeneralKernel) -> list[Held]:
    """The joints between links whose values the caller gives."""
    return [held for link in _every_link(kernel) for held, _ in link.rest]


def _motion(held: Held) -> dict[str, str]:
    """The name of a motion and its arguments."""
    if held.slides:
        return {"motion": "slide", "by": f"{held.factor!r} * given_{held.place}"}
    sign = "-" if held.factor < 0.0 else ""
    return {"motion": "turn", "by": f"c_{held.place}, {sign}s_{held.place}"}


def _constants(kernel: GeneralKernel) -> list[list[str]]:
    every = [[link.first, *(K for _, K in link.rest)] for link in _every_link(kernel)]
    return [_numbers(_rows(K)) for constants in every for K in constants]


def _values(kernel: GeneralKernel) -> dict[str, object]:
    """The constants of an arm and of the algorithm, as text."""
    loop = kernel.loop
    grid_c, grid_s = grid()
    farthest = reach(loop)
    return {
        "constants": _constants(kernel),
        "slides": loop.slides,
        **_lengths(kernel),
        "most": kernel.rows,
        "closed": len(kernel.closed),
        "eliminations": len(kernel.eliminations),
        "ways": 4 if kernel.wrist else 2,
        "per_root": kernel.closed[0].solutions_per_root if kernel.closed else 0,
        "per_double_root": 2 * kernel.closed[0].solutions_per_root if kernel.closed else 0,
        "advance_c": _numbers(c for c, _ in loop.advances),
        "advance_s": _numbers(s for _, s in loop.advances),
        "size": repr(loop.size),
        "per_size": repr(1.0 / loop.size),
        # farther than all links in line the arm does not reach
        "reach": "" if isinf(farthest) else repr((1.0 + 1e-9) * farthest * farthest),
        "nudges": [_numbers(_rows(nudge)) for nudge in reference.nudges()],
        "formulations": [
            {"joints": [str(joint) for joint in f.joints], "sign": repr(float(f.sign))}
            for f in kernel.formulations
        ],
        "sample_c": _numbers(circle.sample_cosines()[0]),
        "sample_s": _numbers(circle.sample_cosines()[1]),
        "harmonics": [_numbers(row) for row in harmonics()],
        "grid_c": [_numbers(row) for row in grid_c],
        "grid_s": [_numbers(row) for row in grid_s],
        "wrist": _wrist(kernel),
        "roots": ROOTS,
        "candidates": CANDIDATES,
        **_tolerances(),
    }


def _lengths(kernel: GeneralKernel) -> dict[str, object]:
    """On which side the slide stands, and where the powers of its length stand."""
    right = kernel.slides_on_the_right
    return {
        "right_slide": right,
        "left_slide": bool(kernel.loop.slides) and not right,
        "powers": "1, d and d^2" if right else "d^2, d and 1",
        # a turn next to the left side leaves two of the eight monomials to some features alone
        "monomials": 8 if right else 6,
        "mixed": 14 if right else 8,
        "invariants": 3 if right else 5,
        "one": 0 if right else 2,
        "square": 2 if right else 0,
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
        "on_quintic": circle.NEWTON_STEPS,
        "settled": repr(circle.SETTLED),
        "quintic": repr(circle.QUINTIC),
        "rounding": repr(circle.ROUNDING),
        "noise_factor": repr(circle.NOISE_FACTOR),
        # the value of a parabola over its bend
        "lifted": repr(0.5 * circle.LIFTED**2),
        # its square
        "crowded": repr(lens.CROWDED**2),
        "strongest": repr(lens.STRONGEST),
        "mean_per_harmonic": repr(lens.MEAN_PER_HARMONIC),
        "noise": repr(reference.NOISE),
        "residual": repr(reference.RESIDUAL),
        "together": repr(reference.TOGETHER),
        "same": repr(reference.SAME),
        # the square of the sum of two unit vectors that are this close
        "close": repr(4.0 - reference.CLOSE**2),
        "steps": reference.STEPS,
        "steps_from_afar": reference.STEPS_FROM_AFAR,
        "batches": 16,
        "tie": repr(1e-9),
        "rank": repr(1e-9),
        "singular": repr(1e-6),
        "good_enough": repr(1e-29),
        "nearly_flat": repr(NEARLY_FLAT),
        "parallel": repr(PARALLEL),
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


def _rows(K: Matrix) -> list[float]:
    """The upper three rows."""
    return [x for row in K[:3] for x in row]


def _wrist(kernel: GeneralKernel) -> dict[str, object] | None:
    """The numbers of an offset wrist."""
    arm = kernel.wrist
    if arm is None:
        return None
    K0, K1, K2, K3, _ = (link.first for link in kernel.loop.links)
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
        # what the turns of joints 1 ... 4 bring into line with axis 3, E, W and z5
        "sources": _numbers([K0[0][2], K0[1][2], *elbow, *wrist, K3[0][2], K3[1][2]]),
        "nearly_right": repr(NEARLY_RIGHT),
        "barely": repr(BARELY),
    }
