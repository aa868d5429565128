"""Derivations of parallel robots: formats, French, and what they print against other numbers."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.cli import main
from dhgen.derivation.french.language import French
from dhgen.parallel.printing import parallel_derivation_as
from tests.derivation.test_figures import parsed
from tests.derivation.test_handouts import ENGINES, compiled, warned
from tests.parallel.made import GENERATED, NAMES, compilation, native
from tests.serial import ROBOTS

if TYPE_CHECKING:
    from pathlib import Path


@pytest.mark.parametrize("name", [*NAMES, "mixed_legs"])
def test_nothing_stays_english(name: str) -> None:
    language = French()
    text, beside = parallel_derivation_as("markdown", compilation(name).module, language)
    assert language.missing == []
    assert "modèle géométrique inverse" in text
    assert list(beside) == [f"figures/{name}_platform_fr.svg"]


@pytest.mark.parametrize("name", ["parallel_3rpr", "stewart"])
def test_every_format_has_the_text(name: str) -> None:
    module = compilation(name).module
    latex = parallel_derivation_as("latex", module)[0]
    assert r"\begin{document}" in latex
    assert r"A \dot{x} = B \dot{q}" in latex.replace("&", "").replace("  ", " ")
    text = parallel_derivation_as("text", module)[0]
    assert "A ẋ = B q̇" in text
    assert "Vᵢ ẋ = Qᵢᵀ (v + ω × R pᵢ)" in text
    assert "<math" in parallel_derivation_as("html", module)[0]


@pytest.mark.parametrize("name", NAMES)
def test_no_formula_of_the_text_is_that_of_tex(name: str) -> None:
    text = parallel_derivation_as("text", compilation(name).module)[0]
    assert re.findall(r"\\\w+|\b\w_\w\b", text) == []


@pytest.mark.slow
@pytest.mark.skipif("pdflatex" not in ENGINES, reason="no pdflatex")
def test_latex_compiles_without_a_warning(tmp_path: Path) -> None:
    latex = parallel_derivation_as("latex", compilation("parallel_3rpr").module)[0]
    assert warned(compiled("pdflatex", latex, tmp_path)) == []


@pytest.mark.parametrize("name", NAMES)
def test_the_figure_is_whole(name: str) -> None:
    text = (GENERATED / "figures" / f"{name}_platform.svg").read_text(encoding="utf-8")
    assert parsed(text).tag.endswith("svg")
    assert f"(figures/{name}_platform.svg)" in (GENERATED / f"{name}.md").read_text("utf-8")


def test_the_example_is_what_the_c_gives() -> None:
    """The pose and all rows of the document, which come from the interpreter, read as printed."""
    text = (GENERATED / "parallel_3rpr.md").read_text(encoding="utf-8")
    entries = re.search(r"X = \\begin\{bmatrix\}(.*?)\\end", text)
    assert entries
    T = np.array([[float(e) for e in row.split("&")] for row in entries[1].split(r"\\")])
    T[:2, :2] /= np.hypot(T[0, 0], T[1, 0])
    _, q, _ = native("parallel_3rpr").ik(T)
    table = [
        [float(cell.strip("$ ").removesuffix(r"^\circ")) for cell in line.strip("|").split("|")[:4]]
        for line in text.splitlines()
        if re.match(r"\| \d \| \d \|", line)
    ]
    assert len(table) == 6
    for leg, row, *values in table:
        expected = [math.radians(values[0]), values[1], *map(math.radians, values[2:])]
        np.testing.assert_allclose(q[int(leg) - 1, int(row)], expected, rtol=0, atol=3e-4)
    lengths = np.array([values[1] for leg, row, *values in table if row == 0])
    found = native("parallel_3rpr").assemblies(lengths)
    rows = re.findall(
        r"^\| \$([-\d.]+)\$ \| \$([-\d.]+)\$ \| \$([-\d.]+)\^\\circ\$ \|$", text, re.MULTILINE
    )
    told = np.array(rows, float) * (1.0, 1.0, math.radians(1.0))
    have = [[P[0, 3], P[1, 3], np.arctan2(P[1, 0], P[0, 0])] for P in found]
    assert len(told) == len(have) == 4
    np.testing.assert_allclose(have, told, rtol=0, atol=5e-3)


@pytest.mark.parametrize("name", NAMES)
def test_the_jacobian_that_a_leg_s_document_writes_out_is_there(name: str) -> None:
    """The document of the robot names it and leads there."""
    text = (GENERATED / f"{name}.md").read_text(encoding="utf-8")
    paths = re.findall(r"\]\((\w+\.md)\)", text)
    assert paths == [f"{chain.name}.md" for chain in compilation(name).robot.chains]
    assert "The derivation of the leg writes it out, with its forward model." in text
    for path in paths:
        forward = (GENERATED / path).read_text(encoding="utf-8").split("\n## Forward\n")[1]
        assert re.search(r"^J = \\begin\{bmatrix\}", forward.split("\n## ")[0], re.MULTILINE)


def test_the_command_explains(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(ROBOTS / "five_bar.yaml")
    assert main(["explain", file]) == 0
    text = capsys.readouterr().out
    assert "There are at most two assemblies." in text
    assert text.count("\n1. θ₂") == text.count("\n2. θ₁") == 1  # of the legs, which are alike
    out = tmp_path / "five.md"
    assert main(["explain", file, "--language", "fr", "--out", str(out)]) == 0
    assert "deux assemblages" in out.read_text(encoding="utf-8")
    leg = (tmp_path / "five_leg.md").read_text(encoding="utf-8")
    assert "modèle géométrique inverse" in leg
    linked = set(re.findall(r"\]\((figures/\w+\.svg)\)", out.read_text("utf-8") + leg))
    assert {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*.svg")} == linked
    assert r"[five\_bar\_leg](five_leg.md)" in out.read_text(encoding="utf-8")
    assert capsys.readouterr().out == f"wrote {out}, {tmp_path / 'five_leg.md'}\n"
    assert main(["explain", file, "--format", "html"]) == 0
    assert "of the legs are written beside --out FILE" in capsys.readouterr().err
    page = tmp_path / "page.html"
    assert main(["explain", file, "--out", str(page)]) == 0
    assert '<a href="page_leg.html">five_bar_leg</a>' in page.read_text(encoding="utf-8")
    assert (tmp_path / "page_leg.html").exists()
    capsys.readouterr()
    assert main(["explain", file, "--program"]) != 0
    assert "is for serial arms" in capsys.readouterr().err
