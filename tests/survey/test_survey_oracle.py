"""What solvers are held to has nothing of theirs."""

from __future__ import annotations

import ast
from pathlib import Path

import dhgen.oracle

FOLDER = Path(dhgen.oracle.__file__).parent
ALLOWED = ("dhgen.robot.", "dhgen.oracle.")
ANNOTATIONS = "dhgen.arrays"  # names, no code


def imported(path: Path) -> list[str]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    names = [node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    return names + [
        alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.Import)
        for alias in node.names
    ]


def test_it_shares_the_robot_file_only() -> None:
    names = [name for path in FOLDER.glob("*.py") for name in imported(path)]
    own = [name for name in names if name.split(".")[0] == "dhgen"]
    assert own
    assert all(name.startswith(ALLOWED) or name == ANNOTATIONS for name in own)
