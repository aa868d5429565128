"""Modules, and the folders that they stand in, import one another in one direction only."""

from __future__ import annotations

import ast
from collections import defaultdict
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import dhgen

ROOT = Path(dhgen.__file__).resolve().parent
MODULES = {
    ".".join(path.relative_to(ROOT.parent).with_suffix("").parts).removesuffix(".__init__"): path
    for path in ROOT.rglob("*.py")
}


def imported(path: Path) -> set[str]:
    """The modules of dhgen that a file imports, also within functions, but not for types alone."""
    tree, found = ast.parse(path.read_text("utf-8")), set[str]()
    types = {
        id(each)
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
        for each in ast.walk(node)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and id(node) not in types:
            source = ".".join(filter(None, (*package(path, node.level), node.module)))
            whole = {f"{source}.{each.name}" for each in node.names}
            found |= {each if each in MODULES else source for each in whole}
    return found & set(MODULES)


def package(path: Path, level: int) -> tuple[str, ...]:
    """What the dots in front of a module stand for, as the runtime has them."""
    parts = path.relative_to(ROOT.parent).parts
    return parts[: len(parts) - level] if level else ()


IMPORTS = {name: imported(path) - {name} for name, path in MODULES.items()}


def folder(module: str) -> str:
    """The folder, or the file, at the top of the package."""
    return ".".join(module.split(".")[:2])


def test_imports_are_seen() -> None:
    assert "dhgen.paul.derive" in IMPORTS["dhgen.nominal.nominal"]
    assert "dhgen.kinematics.chain" not in IMPORTS["dhgen.nominal.nominal"]  # for types alone
    assert "dhgen.robot_files" in IMPORTS["dhgen.commands"]  # within functions
    runtime = "dhgen.runtime.python"
    assert {f"{runtime}.jit", f"{runtime}.rigid"} <= IMPORTS[f"{runtime}.general.loop"]


@pytest.mark.parametrize("of", ["modules", "folders"])
def test_no_circle(of: str) -> None:
    graph = defaultdict[str, set[str]](set)
    for module, others in IMPORTS.items():
        own = module if of == "modules" else folder(module)
        graph[own] |= {each if of == "modules" else folder(each) for each in others} - {own}
    TopologicalSorter(graph).prepare()  # raises CycleError, with the circle
