"""Fills in the templates of the general algorithm."""

from __future__ import annotations

from textwrap import indent
from typing import TYPE_CHECKING

from dhgen.targets.general.algorithm import algorithm, c_algorithm, python_algorithm
from dhgen.targets.general.rows import rows
from dhgen.targets.general.spelling import c_spelling, python_spelling
from dhgen.targets.layout import c_array, python_array
from dhgen.targets.templates import named, render

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain


def c_source(kernel: GeneralKernel, name: str) -> str:
    """The static functions of `<name>_general` in C99; they need <math.h>."""
    common, own = algorithm(kernel, name), c_algorithm(kernel, name)
    return render("c/general/kernel.c.jinja", **named(common), **named(own))


def python_source(kernel: GeneralKernel, name: str) -> str:
    """The function `<name>_general` in Python; it needs numba and numpy."""
    common, own = algorithm(kernel, name), python_algorithm(kernel)
    return render("python/general/kernel.py.jinja", **named(common), **named(own))


def c_rows(kernel: GeneralKernel, chain: Chain, name: str) -> str:
    """The static function `all_joints` in C99; it calls `<name>_general` and the descent."""
    facing, zero = _behind(chain)
    return render(
        "c/general/rows.c.jinja",
        p=name,
        rows=rows(kernel, chain),
        facing=indent(c_array(f"static const double facing[{len(facing)}]", facing), "    "),
        zero=indent(c_array(f"static const double zero[{len(zero)}]", zero), "    "),
        spelling=c_spelling(kernel, name),
    )


def python_rows(kernel: GeneralKernel, chain: Chain, name: str) -> str:
    """The function `_all_joints` in Python; it calls `<name>_general` and the descent."""
    facing, zero = _behind(chain)
    return render(
        "python/general/rows.py.jinja",
        p=name,
        rows=rows(kernel, chain),
        facing=python_array("_FACING = np.array", facing),
        zero=python_array("_ZERO = np.array", zero),
        spelling=python_spelling(kernel),
    )


def _behind(chain: Chain) -> tuple[list[str], list[str]]:
    """Signs and offsets of the joint values behind the loop's angles and lengths."""
    solved = chain.solved
    return [repr(float(joint.sign)) for joint in solved], [repr(joint.offset) for joint in solved]
