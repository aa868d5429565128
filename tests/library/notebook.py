"""Runs a notebook's cells in this process, and writes what they show into it as a command:

    python -m tests.library.notebook docs/from_a_urdf.ipynb

Only what the notebooks of this project hold: cells of Markdown and of Python, printed lines, and
the value of a cell's last line as text and as Markdown.
"""

from __future__ import annotations

import ast
import contextlib
import io
import json
import sys
from pathlib import Path
from typing import Any

Output = dict[str, Any]


def outputs(path: Path) -> list[list[Output]]:
    """What the cells of Python show, one after the other, run in the notebook's folder."""
    names: dict[str, Any] = {"__name__": "__main__"}
    with contextlib.chdir(path.parent):
        return [_shown(_text(cell["source"]), names, n) for n, cell in enumerate(cells(path), 1)]


def kept_outputs(path: Path) -> list[list[Output]]:
    """What the notebook says that they show."""
    return [cell["outputs"] for cell in cells(path)]


def cells(path: Path) -> list[dict[str, Any]]:
    """The cells of Python."""
    every = json.loads(path.read_text("utf-8"))["cells"]
    return [cell for cell in every if cell["cell_type"] == "code"]


def _shown(source: str, names: dict[str, Any], number: int) -> list[Output]:
    body = ast.parse(source).body
    last = body.pop() if body and isinstance(body[-1], ast.Expr) else None
    printed, value = io.StringIO(), None
    with contextlib.redirect_stdout(printed):
        exec(compile(ast.Module(body, []), f"cell {number}", "exec"), names)  # noqa: S102
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names)  # noqa: S307
    shown: list[Output] = []
    if text := printed.getvalue():
        shown.append({"name": "stdout", "output_type": "stream", "text": _lines(text)})
    if value is not None:
        data = {"text/plain": _lines(repr(value))}
        if hasattr(value, "_repr_markdown_"):
            data = {"text/markdown": _lines(value._repr_markdown_()), **data}
        result = {"output_type": "execute_result", "execution_count": number, "metadata": {}}
        shown.append({**result, "data": data})
    return shown


def _text(source: str | list[str]) -> str:
    return source if isinstance(source, str) else "".join(source)


def _lines(text: str) -> list[str]:
    """As notebooks hold texts, so that a change is a few lines."""
    return text.splitlines(keepends=True)


def write(path: Path) -> None:
    """Runs a notebook and puts what its cells show into it."""
    notebook = json.loads(path.read_text("utf-8"))
    new = iter(outputs(path))
    count = 0
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            count += 1
            cell.update(outputs=next(new), execution_count=count)
    path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]).resolve())
