"""The names that emitted code has of its own, read from templates, headers and generated files."""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from dhgen.robot.names import C_KEYWORDS, C_LIBRARY, PYTHON
from dhgen.runtime import c_runtime_files

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

ROOT = Path(__file__).resolve().parents[2]
OF_THE_RUNTIME = re.compile("dhgen_|DHGEN_")
# Robots on legs have their constants inside functions, where nothing that follows is in the way.
_TEMPLATES = ("calibrated", "descents", "general", "regular", "solver")
# What a robot's file includes behind its constants.
_BEHIND_THE_CONSTANTS = ("functions", "functions_calibrated", "one_pose")

_JINJA = re.compile(r"\w*\{\{.*?\}\}\w*|\{%.*?%\}|\{#.*?#\}", re.DOTALL)
# Where a name is none of a variable, a function or a macro: in comments and texts, in conditions of
# the preprocessor, where ## makes it a part of another one, as a member.
_ELSEWHERE = re.compile(
    r"""/\*.*?\*/ | "[^"\n]*" | \#\s*(?:include|if|ifdef|ifndef|elif)\b[^\n]* | \#\s*[a-z]+
    | \#\#\s*\w+ | DHGEN_(?:NAME|DO)\(\w+\) | \b\d[\w.]* | (?:\.|->)\s*[A-Za-z]\w*""",
    re.DOTALL | re.VERBOSE,
)
_NO_ARM = re.compile(r"/parallel\.|^#define DHGEN_INTERFACE", re.MULTILINE)
_TYPES = {"four", "wide"}  # what macros take for dhgen_four and dhgen_wide
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_CONSTANTS = re.compile(r"^static const double\s(.*?);", re.DOTALL | re.MULTILINE)
_ARRAY = re.compile(r'\b_(?:[Pp]laces|numbers)\("(\w+)"|DHGEN_TABLE [\w ]*?(\w+)(?:\[[^\]]*\])* =')
_LOOKED_FOR = re.compile(r'\b(?:has|get)attr\((?:module|robot|self\._robot), "([A-Za-z]\w*)"')


def of_c(code: str) -> set[str]:
    """The names in a piece of C, without those that no constant can have."""
    names = re.findall(r"(?<!\w)[A-Za-z]\w*", _ELSEWHERE.sub(" ", code))
    own = {name for name in names if not OF_THE_RUNTIME.match(name)}
    return own - C_KEYWORDS - C_LIBRARY - _TYPES


def of_c_templates() -> set[str]:
    """The names in templates, and in headers that are included behind a robot's constants."""
    runtime = c_runtime_files()
    texts = [(ROOT / f"templates/c/{name}.c.jinja").read_text("utf-8") for name in _TEMPLATES]
    headers = [runtime[f"dhgen/{name}.h"] for name in _BEHIND_THE_CONSTANTS]
    return of_c("\n".join([*(_JINJA.sub(" ", text) for text in texts), *headers]))


@cache
def of_generated_c() -> frozenset[str]:
    """The names in all generated C, but its constants and what begins with the robot's name."""
    found: set[str] = set()
    for stem, text in _robots("c"):
        code = _COMMENT.sub("", re.sub(rf"\b(?:{stem}|{stem.upper()})_\w+", " ", text))
        constants = re.findall(r"(\w+) = ", "\n".join(_CONSTANTS.findall(code)))
        found |= of_c(code) - set(constants)
    return frozenset(found)


def of_arrays() -> set[str]:
    """The names of C's arrays that no template has, and no robot of robots/ needs to have."""
    files = sorted((ROOT / "dhgen/targets/c").glob("*.py"))
    text = "\n".join(path.read_text("utf-8") for path in files)
    return {first or second for first, second in _ARRAY.findall(text)}


@cache
def of_python_functions() -> frozenset[str]:
    """The names of all generated Python in functions with formulas, and of these functions."""
    found: set[str] = set()
    for _, behind, constants in _modules():
        found |= _named(each for each in behind if isinstance(each, ast.FunctionDef)) - constants
    return frozenset(_possible(found))


@cache
def of_python_files() -> frozenset[str]:
    """The names of all generated Python at file level that a constant could replace."""
    single = (ROOT / "templates/python/inside.py.jinja").read_text("utf-8")
    single = re.sub(r"\{%.*?%\}", "", re.sub(r"\{\{.*?\}\}", "0", single))
    found = _looked_up(ast.parse(single).body)
    for before, behind, constants in _modules():
        statements = [each for each in behind if not isinstance(each, ast.FunctionDef)]
        names = _bound(behind) | _named(statements) | _looked_up(before + behind)
        found |= names - constants
    return frozenset(_possible(found))


def of_helpers() -> set[str]:
    """What is looked for in the module of a robot."""
    files = sorted((ROOT / "dhgen/runtime/helpers").glob("*.py"))
    return {name for path in files for name in _LOOKED_FOR.findall(path.read_text("utf-8"))}


def in_printers() -> set[str]:
    """Words of the code that is not in templates."""
    found: set[str] = set()
    for path in sorted((ROOT / "dhgen/targets").rglob("*.py")):
        if path.name == "reserved.py":
            continue
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            text = node.value if isinstance(node, ast.Constant) else None
            if isinstance(text, str) and re.search(r"[=;(){}\[\]]|^\w+$", text):
                found |= of_c(text)
    return found


def in_python_templates() -> set[str]:
    """Words of the templates of Python."""
    files = sorted((ROOT / "templates/python").glob("*.py.jinja"))
    code = "\n".join(_JINJA.sub(" ", path.read_text("utf-8")) for path in files)
    code = re.sub(r'""".*?"""|#[^\n]*', "", code, flags=re.DOTALL)
    return set(re.findall(r"\b[A-Za-z]\w*", code))


def _robots(ending: str) -> Iterator[tuple[str, str]]:
    """The generated files of arms, each with its name, but those that hold the runtime."""
    for path in sorted((ROOT / "generated").glob(f"*.{ending}")):
        text = path.read_text("utf-8")
        if "robots/" in text and not _NO_ARM.search(text):
            yield path.stem, text


def _modules() -> Iterator[tuple[list[ast.stmt], list[ast.stmt], set[str]]]:
    """The statements of generated modules before constants and behind, and constants' names."""
    for _, text in _robots("py"):
        body = ast.parse(text).body
        start = next(i for i, each in enumerate(body) if "NAME" in _bound([each]))
        numbers = [each for each in body if isinstance(each, ast.Assign) and _is_float(each.value)]
        yield body[:start], body[start:], _bound(numbers)


def _is_float(value: ast.expr) -> bool:
    value = value.operand if isinstance(value, ast.UnaryOp) else value
    return isinstance(value, ast.Constant) and isinstance(value.value, float)


def _looked_up(body: Iterable[ast.stmt]) -> set[str]:
    """The names that functions look up at file level, whenever they are called."""
    every = (part for each in body for part in ast.walk(each))
    functions = [part for part in every if isinstance(part, ast.FunctionDef)]
    return {name for each in functions for name in _named(each.body) - _bound(ast.walk(each))}


def _bound(nodes: Iterable[ast.AST]) -> set[str]:
    """The names that nodes themselves bind."""
    found: set[str] = set()
    for node in nodes:
        match node:
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name) | ast.arg(arg=name):
                found.add(name)
            case ast.Name(id=name, ctx=ast.Store()):
                found.add(name)
            case ast.Assign(targets=targets):
                found |= _bound(part for each in targets for part in ast.walk(each))
    return found


def _named(nodes: Iterable[ast.AST]) -> set[str]:
    """All names in nodes, and in what is in them."""
    every = [part for node in nodes for part in ast.walk(node)]
    return {node.id for node in every if isinstance(node, ast.Name)} | _bound(every)


def _possible(names: Iterable[str]) -> set[str]:
    """Those of names that a constant could have."""
    possible = {name for name in names if not name.startswith("_")}
    return possible - C_KEYWORDS - C_LIBRARY - PYTHON
