"""Fills in the templates of the general algorithm."""

from __future__ import annotations

from textwrap import indent
from typing import TYPE_CHECKING

from dhgen.general.loop import LINKS
from dhgen.targets.general.angles import Angles, Arctangent
from dhgen.targets.general.arm import arm
from dhgen.targets.general.elimination import Elimination, Kinds
from dhgen.targets.general.equations import equations
from dhgen.targets.general.links import links
from dhgen.targets.general.rows import rows
from dhgen.targets.general.sizes import Sizes
from dhgen.targets.general.spelling import c_spelling, python_spelling
from dhgen.targets.general.tables import tables
from dhgen.targets.general.tolerances import Tolerances
from dhgen.targets.general.wrist import wrist
from dhgen.targets.layout import c_array, python_array
from dhgen.targets.templates import render

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain


def c_source(kernel: GeneralKernel, name: str) -> str:
    """The static functions of `<name>_general` in C99; they need <math.h>."""
    places = [f"loop->link[{i}]" for i in range(LINKS)]
    return render(
        "c/general6r.c.jinja",
        **_texts(kernel, name),
        links=links(kernel, [*places, "P", "right"], "free_joints"),
        spelling=c_spelling(kernel, name),
        arctangent=Arctangent(),
    )


def python_source(kernel: GeneralKernel, name: str) -> str:
    """The function `<name>_general` in Python; it needs numba and numpy."""
    return render(
        "python/general6r.py.jinja",
        **_texts(kernel, name),
        links=links(kernel, [f"links[{i}]" for i in range(LINKS + 2)], "q_free"),
        spelling=python_spelling(kernel),
        elimination=Elimination(),
        kinds=Kinds(),
    )


def _texts(kernel: GeneralKernel, name: str) -> dict[str, object]:
    """What both languages write alike."""
    return {
        "p": name,
        "P": name.upper(),
        "arm": arm(kernel),
        "tables": tables(kernel),
        "equations": equations(kernel),
        "wrist": wrist(kernel),
        "sizes": Sizes(),
        "tolerances": Tolerances(),
        "angles": Angles(),
    }


def c_rows(kernel: GeneralKernel, chain: Chain, name: str) -> str:
    """The static function `all_joints` in C99; it calls `<name>_general` and the descent."""
    facing, zero = _behind(chain)
    return render(
        "c/general6r_rows.c.jinja",
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
        "python/general6r_rows.py.jinja",
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
