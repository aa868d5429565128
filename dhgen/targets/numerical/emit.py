"""Fills in the templates of the numerical solver."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.numerical.arrays import c_arrays, python_arrays
from dhgen.targets.numerical.descent import Descent
from dhgen.targets.numerical.problem import problem_of
from dhgen.targets.numerical.texts import turning_places
from dhgen.targets.templates import render

if TYPE_CHECKING:
    from dhgen.numerical.both_sides import Turning
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.targets.solver.calls import Calls
    from dhgen.targets.solver.common import Common
    from dhgen.targets.solver.module import Module

# How Python's function `_look` is compiled: once for many callers, or into its only one.
APART = "float64(float64[:, ::1], float64[::1], float64[::1], float64[::1], float64[:, ::1])"
ONCE, INSIDE = f'@_apart("{APART}")', "@_inner"


def c_tools(kernel: NumericalKernel, module: Module) -> str:
    """The static functions in C99 that descend, follow a continuum, keep and sort solutions."""
    return _filled("c/numerical/kernel.c.jinja", kernel, module, arrays=c_arrays(kernel))


def python_tools(kernel: NumericalKernel, module: Module) -> str:
    """The same functions in Python."""
    arrays = python_arrays(kernel)
    return _filled("python/numerical/kernel.py.jinja", kernel, module, arrays=arrays, looked=ONCE)


def c_search(kernel: NumericalKernel, module: Module) -> str:
    """The static function `all_joints` in C99; it needs the tools."""
    return _filled("c/numerical/search.c.jinja", kernel, module)


def python_search(kernel: NumericalKernel, module: Module) -> str:
    """The function `_all_joints` in Python; it needs the tools."""
    return _filled("python/numerical/search.py.jinja", kernel, module)


def c_tightening(kernel: NumericalKernel, module: Module) -> str:
    """The static function `tighten` in C99, with all that it needs."""
    return _filled("c/numerical/tighten.c.jinja", kernel, module, arrays=c_arrays(kernel))


def python_tightening(kernel: NumericalKernel, module: Module) -> str:
    """The function `_tighten` in Python, with all that it needs."""
    arrays = python_arrays(kernel)
    return _filled(
        "python/numerical/tighten.py.jinja", kernel, module, arrays=arrays, looked=INSIDE
    )


def c_both_sides(kernel: NumericalKernel, turning: Turning, common: Common, calls: Calls) -> str:
    """The static function `both_sides` in C99; it needs `solve` and what tightens."""
    places = turning_places(turning)
    return _filled(
        "c/numerical/both_sides.c.jinja",
        kernel,
        common.module,
        searches=common.searches,
        calls=calls,
        turning=places,
    )


def python_both_sides(
    kernel: NumericalKernel, turning: Turning, common: Common, calls: Calls
) -> str:
    """The function `_both_sides` in Python; it needs `_solve` and what tightens."""
    places = turning_places(turning)
    return _filled(
        "python/numerical/both_sides.py.jinja",
        kernel,
        common.module,
        searches=common.searches,
        calls=calls,
        turning=places,
    )


def c_seeking(kernel: NumericalKernel, common: Common, calls: Calls) -> str:
    """The static function `seek` in C99; it needs what tightens and, with limits, searches."""
    return _filled(
        "c/numerical/seek.c.jinja",
        kernel,
        common.module,
        searches=common.searches,
        standing=common.standing,
        calls=calls,
        arrays=c_arrays(kernel),
    )


def python_seeking(kernel: NumericalKernel, common: Common, calls: Calls) -> str:
    """The function `_seek` in Python; it needs what tightens and, with limits, searches."""
    return _filled(
        "python/numerical/seek.py.jinja",
        kernel,
        common.module,
        searches=common.searches,
        standing=common.standing,
        calls=calls,
        arrays=python_arrays(kernel),
    )


def _filled(template: str, kernel: NumericalKernel, module: Module, **others: object) -> str:
    """A template with what all of them name, and what only some do."""
    return render(template, module=module, problem=problem_of(kernel), descent=Descent(), **others)
