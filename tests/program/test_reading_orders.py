"""A folder's docstring names its modules, in the order in which they are read."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import dhgen

ROOT = Path(dhgen.__file__).parent
# Of these the order is that of the table of types, which the code below the docstring has.
BY_TYPE = {"derivation/types", "program/lowering/types", "paul/types"}


def missing(folder: Path) -> set[str]:
    text = ast.get_docstring(ast.parse((folder / "__init__.py").read_text("utf-8"))) or ""
    words = set(re.findall(r"\w+", text))
    return {path.stem for path in folder.glob("[!_]*.py")} - words


def test_folders_name_their_modules() -> None:
    folders = [path.parent for path in sorted(ROOT.glob("*/**/__init__.py"))]
    told = {
        folder.relative_to(ROOT).as_posix(): missing(folder)
        for folder in folders
        if folder.relative_to(ROOT).as_posix() not in BY_TYPE
    }
    assert {name: modules for name, modules in told.items() if modules} == {}
