"""The numbers of the runtime in C are those that the compiler decides by, and those of Python."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import pytest

from dhgen.runtime import c_runtime_files
from dhgen.runtime.python import assemblies, direct, platform, pose, tolerances, velocities
from dhgen.runtime.python.numerical import (
    descent,
    other_values,
    pairs,
    refine_rows,
    search_lost_rows,
    solutions,
    split_close_roots,
)
from dhgen.tolerances import DOUBLE, SINGLE

if TYPE_CHECKING:
    from types import ModuleType

    from dhgen.tolerances import Precision, Tolerances

DEFINED = re.compile(r"^#define DHGEN_(\w+) ([-+.\de]+)$", re.MULTILINE)


def defined(text: str) -> dict[str, float]:
    """The numbers that a text defines."""
    return {name: float(number) for name, number in DEFINED.findall(text)}


def table(precision: Precision) -> dict[str, float]:
    """The part of the table in C that is for an arithmetic."""
    text = c_runtime_files()["dhgen/tolerances.h"]
    both, _, parts = text.partition("#ifndef DHGEN_SINGLE_PRECISION")
    double, _, single = parts.partition("#else")
    return defined(both) | defined(double if precision is DOUBLE else single)


def expected(known: Tolerances) -> dict[str, float]:
    """What the compiler has in the place of each."""
    return {
        "ORTHONORMAL": known.orthonormal,
        "ROUNDED": known.rotation,
        "NO_YAW": known.steep,
        "LIMIT": known.limit,
        "NEAR_LIMIT": known.limit_slack,
        "EXACT": known.exact,
        "PROMISED": max(known.promised, known.exact),
        "FREE": known.free,
        "MERGE": known.merge,
        "DOUBTFUL": known.doubtful,
        "APART_BY": known.distinct,
        "FAR_ANGLE": known.far,
        "FINE": known.fine,
        # ten times what rounding may be, where that is more
        "TOGETHER": max(1e-3, 10.0 * known.distinct),
        "FAMILY": max(1e-6, 10.0 * known.exact),
        # of the runtime alone
        "LAST_ROW": pose.LAST_ROW if known is DOUBLE.tolerances else 1e-6,
        "BESIDE_SEED": tolerances.BESIDE_SEED,
    }


@pytest.mark.parametrize("precision", [DOUBLE, SINGLE], ids=lambda each: each.name)
def test_the_table_in_c_is_that_of_the_compiler(precision: Precision) -> None:
    assert table(precision) == pytest.approx(expected(precision.tolerances), rel=1e-12, abs=0.0)


def test_a_clamped_row_does_not_become_another_branch() -> None:
    for precision in (DOUBLE, SINGLE):
        assert table(precision)["MERGE"] <= precision.tolerances.distinct**2
    assert DOUBLE.tolerances.clamped <= table(DOUBLE)["MERGE"]


def test_poses_and_angles_are_read_alike_in_python() -> None:
    found = table(DOUBLE)
    assert found["ROUNDED"] == pose.ROTATION
    assert found["ORTHONORMAL"] == pose.ORTHONORMAL
    assert found["NO_YAW"] == pose.NO_YAW


def test_tolerances_of_closed_forms_are_alike_in_python() -> None:
    found = table(DOUBLE) | defined(c_runtime_files()["dhgen/circle_roots.h"])
    ours = {name: value for name, value in vars(tolerances).items() if name.isupper()}
    assert len(ours) > 10
    assert {name: found[name] for name in ours} == ours


# Numbers of the numerical solver: in C, and as Python calls them.
IN_DESCENTS = {
    "SOLUTION": descent.SOLUTION,
    "SMALL_SINE": descent.ASIDE,
    "DESCENT_DAMPING": descent.DAMPING,
    "DAMPING_FLOOR": descent.FLOOR,
    "SLOW_MISS": descent.NEARLY,
    "LONGEST_STEP": descent.LONGEST,
    "DESCENT_STEPS": descent.STEPS,
    "PULL": descent.PULL,
    "PULLED_STEPS": descent.PULLED_STEPS,
    "PULL_SETTLED": descent.SETTLED,
    "SAME_UNITS": solutions.SAME,
    "NEIGHBOURS": solutions.NEIGHBOURS,
    "STEPS_ASIDE": solutions.STEPS_ASIDE,
    "STAYING_PART": solutions.STAYS,
    "SAME_BETWEEN": solutions.SAME_BETWEEN,
    "NEXT_TO": solutions.NEXT_TO,
    "SAME_NEXT_TO": solutions.SAME_NEXT_TO,
    "SINGULAR_LENGTH": solutions.SINGULAR,
    "FEELER": solutions.FEELER,
    "FELT": solutions.FELT,
    "TIE": solutions.TIE,
    "SLOWEST_REGULAR": pairs.SLOWEST_REGULAR,
    "STILL": pairs.STILL,
    "BEND_STEP": pairs.BEND_STEP,
    "FARTHEST_OTHER": pairs.FARTHEST_OTHER,
}


# The same where rows are completed.
IN_ROWS = (
    (refine_rows, ("ROW_STEPS", "ESCAPES", "STUCK", "SPARE", "SURE", "LOOSE")),
    (other_values, ("CLOSE_FAN", "TOGETHER")),
    (split_close_roots, ("TURNED_AWAY", "FIRST_POWER", "LAST_POWER", "POWER_STEP")),
    (search_lost_rows, ("SEARCH_STARTS",)),
)
FAULTS = ("IS_BEYOND_LIMITS", "IS_INEXACT", "IS_MISSING")
ACROSS = re.compile(r"dhgen_across\[5\] = \{(.*)\}")


def test_completed_rows_are_alike_in_python() -> None:
    files, found = c_runtime_files(), table(DOUBLE)
    for module, _ in IN_ROWS:
        name = module.__name__.rpartition(".")[2]
        found |= defined(files[f"dhgen/numerical/{name}.h"])
    ours = {name: getattr(module, name) for module, names in IN_ROWS for name in names}
    assert {name: found[name] for name in ours} == ours
    across = ACROSS.search(files["dhgen/numerical/split_close_roots.h"])
    assert across is not None
    assert tuple(map(float, across[1].split(","))) == split_close_roots.ACROSS
    wrong = {each: getattr(search_lost_rows, each) for each in FAULTS}
    listed = ", ".join(f"DHGEN_{name} = {number}" for name, number in wrong.items())
    assert f"enum {{ {listed} }};" in files["dhgen/numerical/search_lost_rows.h"]


def test_descents_are_alike_in_python() -> None:
    files = c_runtime_files()
    found = table(DOUBLE)
    for name in ("arm", "descent", "pull", "solutions", "family", "keep", "pairs"):
        found |= defined(files[f"dhgen/numerical/{name}.h"])
    assert {name: found[name] for name in IN_DESCENTS} == pytest.approx(IN_DESCENTS, abs=0.0)
    turns_in_c = [found[f"ANY_TURN_{axis}"] for axis in "XYZ"]
    assert turns_in_c == pytest.approx(list(descent.ANY_TURN), rel=1e-15)


def test_joint_velocities_are_alike_in_python() -> None:
    text = c_runtime_files()["dhgen/velocities.h"]
    found = defined(text.partition("#else")[0])
    assert found == {name: getattr(velocities, name) for name in found}
    assert len(found) == 4


PLATFORMS = {
    assemblies: ("meeting", "triangle", "assemblies"),
    direct: ("direct",),
    platform: ("platform",),
}


@pytest.mark.parametrize("module", PLATFORMS, ids=lambda each: each.__name__)
def test_platforms_are_alike_in_python(module: ModuleType) -> None:
    files = c_runtime_files()
    found: dict[str, float] = {}
    for name in PLATFORMS[module]:
        found |= defined(files[f"dhgen/{name}.h"])
    found.pop("DEGREE", None)  # a size of arrays
    assert found
    assert found == {name: getattr(module, name) for name in found}


def test_what_follows_from_others_does() -> None:
    found = table(DOUBLE)
    for path, text in c_runtime_files().items():
        if path.endswith(".h") and "tolerances" not in path:
            found |= defined(text)
    assert found["LOOSE"] * found["EXACT"] == pytest.approx(found["PROMISED"])
    assert found["GOLDEN"] == pytest.approx((3.0 - math.sqrt(5.0)) / 2.0, rel=1e-15)
    assert found["HALF_TURN"] == math.pi
    assert found["TURN"] == 2.0 * math.pi
    assert 0.5 ** found["HALVINGS"] < 1e-15 < 0.5 ** (found["HALVINGS"] - 5)
