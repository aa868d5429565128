"""Fills in the templates of the numerical solver: finished strings and numbers."""

from __future__ import annotations

from math import inf, pi
from typing import TYPE_CHECKING

from dhgen.kinematics.order import TIE
from dhgen.numerical import kernel as constants
from dhgen.numerical.miss import ASIDE
from dhgen.numerical.starts import directions
from dhgen.program.tolerances import TOLERANCES
from dhgen.targets.layout import c_array, python_array
from dhgen.targets.numerical.texts import any_turn, position_rows, turning_places
from dhgen.targets.solver.given import given_places
from dhgen.targets.templates import render

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.numerical.both_sides import Turning
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.targets.c_calls import CCalls
    from dhgen.targets.python_calls import PythonCalls
    from dhgen.targets.solver.common import Common
    from dhgen.targets.solver.module import Module


Numbers = dict[str, tuple[str, ...]]


# How Python's function `_look` is compiled: once for many callers, or into its only one.
APART = "float64(float64[:, ::1], float64[::1], float64[::1], float64[::1], float64[:, ::1])"
ONCE, INSIDE = f'@_apart("{APART}")', "@_inner"


def c_tools(kernel: NumericalKernel, module: Module) -> str:
    """The static functions in C99 that descend, follow a continuum, keep and sort solutions."""
    arrays = _c_arrays(kernel)
    return render("c/numerical.c.jinja", module=module, arrays=arrays, n=_texts(kernel))


def python_tools(kernel: NumericalKernel, module: Module) -> str:
    """The same functions in Python."""
    arrays = _python_arrays(kernel)
    return render(
        "python/numerical.py.jinja", module=module, arrays=arrays, looked=ONCE, n=_texts(kernel)
    )


def c_search(kernel: NumericalKernel, module: Module) -> str:
    """The static function `all_joints` in C99; it needs the tools."""
    return render("c/numerical_search.c.jinja", module=module, n=_texts(kernel))


def python_search(kernel: NumericalKernel, module: Module) -> str:
    """The function `_all_joints` in Python; it needs the tools."""
    return render("python/numerical_search.py.jinja", module=module, n=_texts(kernel))


def c_tightening(kernel: NumericalKernel, module: Module) -> str:
    """The static function `tighten` in C99, with all that it needs."""
    return render("c/tighten.c.jinja", module=module, arrays=_c_arrays(kernel), n=_texts(kernel))


def c_both_sides(kernel: NumericalKernel, turning: Turning, module: Module, calls: CCalls) -> str:
    """The static function `both_sides` in C99; it needs `solve` and what tightens."""
    return render(
        "c/both_sides.c.jinja",
        module=module,
        calls=calls,
        n=_texts(kernel),
        turning=turning_places(turning),
    )


def c_seeking(kernel: NumericalKernel, common: Common, calls: CCalls) -> str:
    """The static function `seek` in C99; it needs what tightens and, with limits, searches."""
    return render(
        "c/seek.c.jinja",
        module=common.module,
        searches=common.searches,
        calls=calls,
        arrays=_c_arrays(kernel),
        n=_texts(kernel),
        enough=_enough(kernel),
    )


def python_seeking(kernel: NumericalKernel, common: Common, calls: PythonCalls) -> str:
    """The function `_seek` in Python; it needs what tightens and, with limits, searches."""
    return render(
        "python/seek.py.jinja",
        module=common.module,
        searches=common.searches,
        calls=calls,
        arrays=_python_arrays(kernel),
        n=_texts(kernel),
        enough=_enough(kernel),
    )


def _enough(kernel: NumericalKernel) -> str:
    """What a row may miss: a pose that is checked may have been rounded."""
    return repr(kernel.residual) if kernel.checked else f"{constants.LOOSE!r} * exact"


def python_both_sides(
    kernel: NumericalKernel, turning: Turning, module: Module, calls: PythonCalls
) -> str:
    """The function `_both_sides` in Python; it needs `_solve` and what tightens."""
    return render(
        "python/both_sides.py.jinja",
        module=module,
        calls=calls,
        n=_texts(kernel),
        turning=turning_places(turning),
    )


def python_tightening(kernel: NumericalKernel, module: Module) -> str:
    """The function `_tighten` in Python, with all that it needs."""
    arrays = _python_arrays(kernel)
    return render(
        "python/tighten.py.jinja", module=module, arrays=arrays, looked=INSIDE, n=_texts(kernel)
    )


def _c_arrays(kernel: NumericalKernel) -> dict[str, str]:
    return {
        key: c_array(f"static const {_type(key)} {key}[{len(values)}]", values)
        for key, values in _arrays(kernel, "INFINITY", ("0", "1")).items()
    }


def _type(key: str) -> str:
    return "int" if key in {"solved", "turning", "coordinate"} else "double"


def _python_arrays(kernel: NumericalKernel) -> dict[str, str]:
    return {
        key: python_array(f"_{key.upper()} = np.array", values)
        for key, values in _arrays(kernel, "math.inf", ("False", "True")).items()
    }


def _arrays(kernel: NumericalKernel, infinity: str, truths: tuple[str, str]) -> Numbers:
    """Numbers of joints that are solved for, and of coordinates, as a language writes them."""
    size, count = kernel.arm.chain.size, len(kernel.solved)
    words = {inf: infinity, -inf: f"-{infinity}"}

    def numbers(values: Iterable[float]) -> tuple[str, ...]:
        return tuple(words.get(value, repr(value)) for value in values)

    arrays = {
        "solved": tuple(map(str, kernel.solved)),
        "turning": tuple(truths[turns] for turns in kernel.turns),
        "unit": numbers(kernel.units),
        "span_low": numbers(low for low, _ in kernel.spans),
        "span_width": numbers(high - low for low, high in kernel.spans),
        "stride": numbers(directions(count)),
        "no_lowest": numbers([-inf] * count),
        "no_highest": numbers([inf] * count),
    }
    if kernel.position:
        arrays["measure"] = numbers(unit / size for unit in kernel.units)
        arrays["coordinate"] = tuple(map(str, kernel.position))
    if kernel.bounded:
        arrays |= {"least_u": numbers(kernel.lowest), "most_u": numbers(kernel.highest)}
    return arrays


def _texts(kernel: NumericalKernel) -> dict[str, object]:
    """Counts, finished strings and choices."""
    chain = kernel.arm.chain
    dof = chain.dof
    return {
        "solved": len(kernel.solved),
        "equations": kernel.equations,
        "last_equation": kernel.equations - 1,
        "width": kernel.equations + len(kernel.solved),
        "jacobian_size": 6 * dof,
        "spin": 3 * dof,
        "twice": 2 * dof,
        "given": given_places(chain),
        "given_count": len(chain.free),
        "position": position_rows(kernel.position),
        "first_turn": len(kernel.position),
        "turns": kernel.turning or kernel.pointing,
        "turning": kernel.turning,
        "pointing": kernel.pointing,
        "redundant": kernel.redundant,
        "limited": kernel.limited,
        "bounded": kernel.bounded,
        "checked": kernel.checked,
        "size": repr(chain.size),
        "residual": repr(kernel.residual),
        "enough": "enough" if kernel.checked else repr(kernel.residual),
        **_method(kernel),
    }


def _listed(numbers: Sequence[float]) -> dict[str, object]:
    """Numbers as both languages write them one after another, and how many they are."""
    return {"many": len(numbers), "text": ", ".join(map(repr, numbers))}


def _method(kernel: NumericalKernel) -> dict[str, object]:
    starts = constants.REDUNDANT_STARTS if kernel.redundant else constants.STARTS
    return {
        "aside": repr(ASIDE),
        "any_turn": any_turn(),
        "damping": repr(constants.DAMPING),
        "floor": repr(constants.FLOOR),
        "nearly": repr(constants.NEARLY),
        "fine": repr(constants.FINE),
        "longest": repr(constants.LONGEST),
        "steps": constants.STEPS,
        "solution": repr(TOLERANCES.polished),
        "exact": repr(TOLERANCES.exact),
        "promised": repr(TOLERANCES.promised),
        "limit": repr(TOLERANCES.limit),
        "tightenings": constants.TIGHTENINGS,
        "spare": repr(constants.SPARE),
        "sure": repr(constants.SURE),
        "loose": repr(constants.LOOSE),
        "kept": 2 * kernel.rows,
        "beside": _listed(constants.BESIDE),
        "across": _listed(constants.ACROSS),
        "pull": repr(constants.PULL),
        "pulled": constants.PULLED,
        "settled": repr(constants.SETTLED),
        "starts": starts,
        "few_starts": constants.FEW_STARTS,
        "most_starts": constants.STARTS * constants.ROUNDS,
        "singular": repr(constants.SINGULAR),
        "feeler": repr(constants.FEELER),
        "felt": repr(constants.FELT),
        "together": repr(constants.TOGETHER),
        "neighbours": repr(constants.NEIGHBOURS),
        "between": _listed(constants.BETWEEN),
        "steps_aside": constants.STEPS_ASIDE,
        "stays": repr(constants.STAYS),
        "same": repr(constants.SAME),
        "tie": repr(TIE),
        "turn": repr(2 * pi),
    }
