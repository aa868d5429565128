"""`import dhgen` costs nothing: what is large is imported by whoever asks for it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import dhgen
from dhgen.library.progress import show_progress

ROOT = Path(__file__).resolve().parents[2]
LARGE = {"sympy", "numba", "numpy", "pydantic", "ruamel", "jinja2", "dhgen.errors", "argparse"}


def loaded(statement: str) -> set[str]:
    """What of the large packages a statement imports in a new Python."""
    told = f"import sys; sys.path.insert(0, {str(ROOT)!r}); {statement}; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", told], capture_output=True, text=True, check=True)
    return LARGE & set(done.stdout.split())


def test_import_is_quick() -> None:
    assert loaded("import dhgen; dir(dhgen); dhgen.__version__") == set()
    assert loaded("import dhgen; dhgen.DhgenError") == {"dhgen.errors"}


def test_loading_and_printing_does_without_sympy() -> None:
    urdf = ROOT / "tests" / "descriptions" / "urdf" / "ur5.urdf"
    used = loaded(f"import dhgen; str(dhgen.load({str(urdf)!r}))")
    assert used.isdisjoint({"sympy", "numba"})


def test_all_names_are_there() -> None:
    assert dir(dhgen) == sorted(dhgen.__all__)
    for name in dhgen.__all__:
        assert getattr(dhgen, name) is not None
    for name, value in vars(dhgen.errors).items():
        if isinstance(value, type) and issubclass(value, dhgen.DhgenError):
            assert getattr(dhgen, name) is value
    with pytest.raises(AttributeError, match="module 'dhgen' has no attribute 'lod'"):
        dhgen.lod  # noqa: B018


def test_a_person_who_waits_is_told(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    show_progress("deriving")
    assert capsys.readouterr() == ("", "")
    monkeypatch.setattr(sys, "ps1", ">>> ", raising=False)
    show_progress("deriving")
    assert capsys.readouterr() == ("", "dhgen: deriving ...\n")
