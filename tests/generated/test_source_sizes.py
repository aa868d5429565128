"""The C of an arm in closed form stays small: what grows is read by people and by compilers."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.compiling import solvers_of
from tests.robots.cases import ROBOTS
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

GENERATED = ROBOTS.parent / "generated"
MOST = 40_000  # bytes of any arm, beside what all arms share
MOST_ALONE = 97_500  # of one in single precision, which holds what all arms share as well
BASE = "{xyz: [0.11, -0.23, 0.37], rpy: [0.3, -0.5, 0.7]}"
TOOL = "{xyz: [0.021, -0.034, 0.127], rpy: [-0.4, 0.6, 0.9]}"


def test_c_of_closed_forms() -> None:
    sizes = {}
    for header in GENERATED.glob("*.h"):
        if re.search(r'_METHOD "closed form"', header.read_text(encoding="utf-8")):
            sizes[header.stem] = header.with_suffix(".c").stat().st_size
    assert len(sizes) > 60
    most = {name: MOST_ALONE if name.endswith("_f32") else MOST for name in sizes}
    assert {name: size for name, size in sizes.items() if size > most[name]} == {}


def size_of(text: str, folder: Path, name: str) -> int:
    """Bytes of C that a robot file leads to."""
    (folder / f"{name}.yaml").write_text(text, encoding="utf-8")
    made = solvers_of(folder / f"{name}.yaml")
    assert made.derivation.method.value == "closed form"
    return len(made.files[f"{name}.c"])


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", first_of(["kuka_kr40pa", "ur5", "franka_panda", "techman_tm5_900"])
)
def test_on_any_base_with_any_tool(name: str, tmp_path: Path) -> None:
    text = (ROBOTS / f"{name}.yaml").read_text(encoding="utf-8")
    text = re.sub(r"(?m)^(base|tool):.*\n", "", text)
    assert size_of(f"{text}\nbase: {BASE}\ntool: {TOOL}\n", tmp_path, name) <= MOST


def rounded(name: str) -> str:
    """A robot file with twists as data sheets write them."""
    text = (ROBOTS / f"{name}.yaml").read_text(encoding="utf-8")
    return re.sub(r"(alpha: -?)pi/2", r"\g<1>1.5708", text)


@pytest.mark.breadth
@pytest.mark.parametrize("name", ["stanford", "doosan_m1013"])
def test_with_rounded_twists(name: str, tmp_path: Path) -> None:
    assert size_of(rounded(name), tmp_path, name) <= MOST


@pytest.mark.breadth
@pytest.mark.parametrize("name", ["franka_panda"])
def test_with_seven_rounded_twists(name: str, tmp_path: Path) -> None:
    """Columns that are carried from link to link: multiplied out it was 91.6 kB."""
    assert size_of(rounded(name), tmp_path, name) <= MOST
