"""The module of a robot with what it imports of the runtime in it."""

from __future__ import annotations

import ast
import hashlib
import re
from dataclasses import dataclass

from dhgen.printing.templates import render
from dhgen.runtime import PYTHON, python_runtime_files
from dhgen.runtime.python import DIGEST, INTERFACE

_ASKED = re.compile(r'_runtime\("([\w.]+)"\)')
_IMPORT = "from importlib import import_module\n"
_START = f'''\
"""The runtime of generated robots in Python, as this file holds it."""

INTERFACE = {INTERFACE}
DIGEST = "{DIGEST}"
'''


@dataclass(frozen=True, slots=True)
class Part:
    """A module of the runtime as a file holds it.

    Attributes:
        name: Of the module.
        line: How many lines of the file are before its text.
        text: Its source.
    """

    name: str
    line: int
    text: str


def in_one_file(text: str) -> str:
    """The text of a robot's module that imports what it holds itself."""
    head, _, rest = text.partition(render("python/beside.py.jinja"))
    head = head.replace(_IMPORT, f"{_IMPORT}from importlib.machinery import ModuleSpec\n")
    texts = _texts(text)
    digest = hashlib.sha256("".join(texts.values()).encode()).hexdigest()[:16]
    line, parts = _line_of_table(head, digest), []
    for name, source in texts.items():
        parts.append(Part(name, line, source))
        line += source.count("\n") + 1
    return head + render("python/inside.py.jinja", digest=digest, parts=parts) + rest


def _line_of_table(head: str, digest: str) -> int:
    """How many lines are before the first text."""
    behind = 2  # lines of the template
    return f"{head}{render('python/inside.py.jinja', digest=digest, parts=[])}".count("\n") - behind


def _texts(text: str) -> dict[str, str]:
    """The modules of the runtime that a text imports, directly or through others, by name."""
    files = {
        path.removesuffix(".py").removesuffix("/__init__").replace("/", "."): source
        for path, source in python_runtime_files().items()
    }
    files[PYTHON] = _START
    todo = [f"{PYTHON}.{name}" for name in _ASKED.findall(text)]
    needed: set[str] = set()
    while todo:
        name = todo.pop()
        if name in files and name not in needed:
            needed.add(name)
            todo += [name.rpartition(".")[0], *_imports(files, name)]
    return {name: files[name] for name in sorted(needed)}


def _imports(files: dict[str, str], name: str) -> list[str]:
    """What a module imports of the runtime where it is run, and perhaps names of what is there."""
    found = []
    package = f"{PYTHON}/{name.partition('.')[2].replace('.', '/')}/__init__.py"
    parents = name.split(".") + ([""] if package in python_runtime_files() else [])
    for node in ast.parse(files[name]).body:
        if isinstance(node, ast.ImportFrom) and node.level:
            above = ".".join([*parents[: -node.level], *filter(None, [node.module])])
            found += [above, *(f"{above}.{each.name}" for each in node.names)]
    return found
