"""The files themselves: their header, their layout, and C under compilers and sanitizers."""

from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess
import sys
from pathlib import Path

import jinja2
import pytest

from dhgen.printing.templates import render
from tests.pose.pose_libraries import FILES, WARNINGS, compiler, emitted, run
from tests.structures import first_of

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("name", FILES)
def test_the_header_names_the_project_and_the_licence(name: str) -> None:
    text = (emitted() / name).read_text(encoding="utf-8")
    assert "Part of dhgen, which puts a copy of this file beside the robots" in text
    assert text.splitlines()[0].endswith(" SPDX-License-Identifier: MIT")
    assert str(ROOT) not in text
    assert not re.search(r"20[2-9]\d", text)
    assert text.isascii()
    assert text.endswith("\n")
    assert max(map(len, text.splitlines())) <= 100


@pytest.mark.parametrize("name", FILES)
def test_who_cites_a_document_says_what_it_is(name: str) -> None:
    text = (emitted() / name).read_text(encoding="utf-8")
    told = '"Document 001" is one of the course texts that dhgen follows'
    assert ("ocument 001" not in text) or told in text


def test_another_text_has_another_key(tmp_path: Path) -> None:
    """Two texts in a process would run each other's code out of numba's cache without it."""
    text = (emitted() / "dhgen_pose.py").read_text(encoding="utf-8")
    one, other, same = (tmp_path / f"{name}.py" for name in ("one", "other", "same"))
    for path, content in ((one, text), (other, f"{text}# changed\n"), (same, text)):
        path.write_text(content, encoding="utf-8")
    keys = [key_of(path) for path in (one, other, same)]
    assert keys[0] == keys[2] != keys[1]


def key_of(path: Path) -> str:
    """What a module is called by the code that numba compiles of it."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return str(module._KEY)


def test_c_needs_nothing_but_math() -> None:
    text = "".join((emitted() / name).read_text() for name in ("dhgen_pose.h", "dhgen_pose.c"))
    assert re.findall(r"#include (\S+)", text) == ['"dhgen_pose.h"', "<math.h>"]


def test_the_header_serves_cpp(tmp_path: Path) -> None:
    cpp = compiler("c++")
    source = tmp_path / "uses.cpp"
    source.write_text(
        '#include "dhgen_pose.h"\n#include "dhgen_pose.h"\n'
        "int main() { const double xyz[3] = {}, rpy[3] = {}; double T[16];\n"
        "  return dhgen_pose_from_xyz_rpy(xyz, rpy, T); }\n"
    )
    folder = emitted()
    run(compiler(), *WARNINGS, "-c", "-o", tmp_path / "pose.o", folder / "dhgen_pose.c")
    flags = ("-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I", str(folder))
    run(cpp, *flags, "-o", tmp_path / "uses", source, tmp_path / "pose.o", "-lm")
    run(tmp_path / "uses")


@pytest.mark.parametrize("optimization", first_of(["-O0", "-O3"]))
def test_a_walk_over_singular_and_broken_inputs_is_clean_under_sanitizers(
    tmp_path: Path, optimization: str
) -> None:
    cc = compiler()
    sanitizers = ("-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    probe = tmp_path / "probe.c"
    probe.write_text("int main(void) { return 0; }\n")
    linked = subprocess.run(
        [cc, *sanitizers, "-o", tmp_path / "probe", probe], capture_output=True, check=False
    )
    if linked.returncode != 0:
        pytest.skip("the C compiler has no address and undefined behaviour sanitizers")
    sources = (Path(__file__).with_name("pose_walk.c"), emitted() / "dhgen_pose.c")
    include = ("-I", str(emitted()))
    walk = tmp_path / "walk"
    run(cc, *WARNINGS, optimization, *sanitizers, *include, "-o", walk, *sources, "-lm")
    run(walk)


def test_templates_are_found_inside_an_installed_package(tmp_path: Path) -> None:
    """A wheel has them in `dhgen/templates`, a checkout beside `dhgen`."""
    package = tmp_path / "dhgen"
    (package / "printing").mkdir(parents=True)
    (package / "templates").mkdir()
    (package / "__init__.py").touch()
    (package / "printing" / "__init__.py").touch()
    shutil.copy(ROOT / "dhgen" / "printing" / "templates.py", package / "printing")
    (package / "templates" / "x.jinja").write_text("{% if a %}\n  {{ a }}<\n{% endif %}\n")
    assert shown_by("print(render('x.jinja', a=1), end='')", tmp_path) == "  1<\n"
    undefined = (
        "import jinja2\ntry: render('x.jinja')\nexcept jinja2.UndefinedError: print('refused')"
    )
    assert shown_by(undefined, tmp_path) == "refused\n"


def shown_by(code: str, folder: Path) -> str:
    """What code prints that runs with the package of a folder."""
    command = (sys.executable, "-c", f"from dhgen.printing.templates import render\n{code}")
    return subprocess.run(command, capture_output=True, text=True, check=True, cwd=folder).stdout


def test_an_unknown_template_is_an_error() -> None:
    with pytest.raises(jinja2.TemplateNotFound):
        render("c/nothing.jinja")
