"""A written file with one wrong sign is refused, wherever the sign stands, in Python and in C."""

from __future__ import annotations

import re
import shutil
from contextlib import contextmanager
from typing import TYPE_CHECKING

import numba
import pytest

from dhgen.atomic_write import write_files
from dhgen.compiler import Compilation, verified
from dhgen.errors import CompilerError, VerificationError
from dhgen.verify.native import Build
from dhgen.verify.verify import verify
from tests.compiling import compile_file, with_vectors
from tests.structures import first_of
from tests.targets.made import ROBOTS

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

NAME = "arm_3r"


@pytest.fixture(scope="module")
def compilation() -> Compilation:
    return compile_file(ROBOTS / f"{NAME}.yaml")


@pytest.fixture(scope="module")
def scara() -> Compilation:
    return compile_file(ROBOTS / "scara.yaml")


@contextmanager
def refused(what: str) -> Iterator[None]:
    """Verification must not let this pass."""
    try:
        yield
    except (VerificationError, IndexError, ValueError):  # the last two end plain Python only
        return
    pytest.fail(f"not seen: {what}")


@pytest.fixture(autouse=True)
def as_written(monkeypatch: pytest.MonkeyPatch) -> None:
    """Plain Python, and C as it stands: what is wrong is wrong all the same, and seen sooner."""
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    native = with_vectors(Build("native", ("-O0", "-march=native")))
    monkeypatch.setattr("dhgen.verify.verify.NATIVE", native)
    monkeypatch.setattr("dhgen.verify.verify.COUNT", 30)


def written(compilation: Compilation, folder: Path, file: str, text: str) -> Path:
    write_files(folder, {**compilation.files, file: text})
    return folder


def formulas(text: str, begin: str, end: str) -> list[tuple[int, int]]:
    """Places of the signs between two numbers, in the statements of one function."""
    start = text.index(begin)
    body = text[start : text.index(end, start)]
    # where rows stand: wrong numbers there write beyond C's arrays
    hidden = r"LOST \+.*\n.*|.* row = .*"
    body = re.sub(hidden, lambda lines: "." * len(lines[0]), body)
    signs = re.finditer(r"[\w\])] ([+-]) [\w(]", body)
    return [(start + sign.start(1), start + sign.end(1)) for sign in signs]


def flipped(text: str, place: tuple[int, int]) -> str:
    sign = {"+": "-", "-": "+"}[text[place[0] : place[1]]]
    return text[: place[0]] + sign + text[place[1] :]


PYTHON = {"fk": "def fk(", "jacobian": "def jacobian(", "solve": "def _solve("}
C = {"fk": f"void {NAME}_fk", "jacobian": f"void {NAME}_jacobian", "solve": "DHGEN_FN void solve"}
FEWEST = {"fk": 4, "jacobian": 4, "solve": 12}


@pytest.mark.slow
@pytest.mark.parametrize("function", first_of(PYTHON, count=1))
def test_every_sign_of_python(
    compilation: Compilation, function: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "")  # no C is there to compare with
    monkeypatch.delenv("CC", raising=False)
    text = compilation.files[f"{NAME}.py"]
    places = formulas(text, PYTHON[function], "\n\n\n")
    assert len(places) >= FEWEST[function]
    for place in places:
        folder = written(compilation, tmp_path, f"{NAME}.py", flipped(text, place))
        with refused(text[place[0] - 60 : place[1] + 40]):
            verify(compilation.module, folder)


@pytest.mark.slow
@pytest.mark.parametrize("function", first_of(sorted(C, reverse=True)))
def test_every_fifth_sign_of_c(
    compilation: Compilation, function: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # as many as in earnest: few poses come to the solver that serves singular ones
    monkeypatch.setattr("dhgen.verify.verify.COUNT", 150)
    text = compilation.files[f"{NAME}.c"]
    places = formulas(text, C[function], "\n}\n")[:: 5 if function == "solve" else 3]
    assert places
    for number, place in enumerate(places):
        # a library is loaded once a path
        folder = tmp_path / str(number)
        folder.mkdir()
        written(compilation, folder, f"{NAME}.c", flipped(text, place))
        with refused(text[place[0] - 60 : place[1] + 40]):
            verify(compilation.module, folder)


@pytest.mark.parametrize(
    ("file", "old", "new"),
    first_of(
        [
            (
                "dhgen_runtime/pose.py",
                "valid and rest <= ",
                "valid and rest <= 1e9 + ",
            ),  # the last row
            ("dhgen_runtime/pose.py", "valid = miss <= ", "valid = miss <= 1e9 + "),
            (
                "dhgen_runtime/turns.py",
                "value += TURN * math.floor((t",
                "value -= TURN * math.floor((t",
            ),
            (
                "dhgen_runtime/nearest.py",
                "moved = rows[row, i] - seed[i]",
                "moved = rows[row, i] + seed[i]",
            ),
            ("dhgen_runtime/nearest.py", "or distance < least:", "or distance > least:"),
            ("dhgen_runtime/one_pose.py", "math.isfinite(p * p * p if slides else p)", "True"),
            ("dhgen_runtime/careful.py", "status[row] = OUT_OF_LIMITS", "pass"),
            ("scara.py", "else OK\n", "else FREE_JOINT\n"),
        ],
        count=2,
    ),
)
def test_a_check_that_is_left_out(
    scara: Compilation, file: str, old: str, new: str, tmp_path: Path
) -> None:
    text = scara.files[file]
    assert old in text
    folder = written(scara, tmp_path, file, text.replace(old, new))
    with refused(f"{new} for {old}"):
        verify(scara.module, folder)


def test_what_does_not_compile(compilation: Compilation, tmp_path: Path) -> None:
    text = compilation.files[f"{NAME}.c"].replace("T[15] = 1.0;", "T[15] = counted;")
    folder = written(compilation, tmp_path, f"{NAME}.c", text)
    with pytest.raises(VerificationError, match=f"{NAME}.c does not compile:(.|\n)*counted"):
        verify(compilation.module, folder)


def test_what_only_warns(compilation: Compilation, tmp_path: Path) -> None:
    text = compilation.files[f"{NAME}.c"].replace(
        "const int row = ", "const int unused = 1, row = "
    )
    folder = written(compilation, tmp_path, f"{NAME}.c", text)
    with pytest.raises(VerificationError, match="unused"):
        verify(compilation.module, folder)


def test_as_it_is_it_passes(compilation: Compilation) -> None:
    report = verified(compilation)
    assert (report.poses, report.compiled) == (162, shutil.which("cc") is not None)
    assert report.solutions > 150
    assert report.residual < 1e-13


def test_without_a_c_compiler_python_is_verified_alone(
    compilation: Compilation,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False)
    report = verified(compilation)
    assert (report.poses, report.compiled) == (162, False)


def test_cc_names_the_compiler(
    compilation: Compilation,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    """A compiler of one's own, which refuses everything."""
    refusing = tmp_path / "refusing"
    refusing.write_text("#!/bin/sh\necho no thanks >&2\nexit 1\n")
    refusing.chmod(0o755)
    monkeypatch.setenv("CC", str(refusing))
    with pytest.raises(CompilerError, match="no thanks"):
        verified(compilation)
