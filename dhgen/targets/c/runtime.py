"""The C runtime pasted into one file of a robot."""

from __future__ import annotations

import re
from posixpath import dirname, join, normpath

from dhgen.runtime import c_runtime_files

VECTORS = "dhgen/vectors.h"
CALIBRATION, CALIBRATED = "dhgen/calibration.h", "dhgen/calibrated.h"
_INCLUDE = re.compile(r'#include "((?:\.\./)*[\w/]+\.h)"\n')
_GUARD = re.compile(r"#ifndef (DHGEN_\w+_H)\n#define \1\n(.*)#endif\n", re.DOTALL)
# What is a robot's own, and what its file includes from the folder beside it.
_CHOICE = re.compile(
    r"#ifdef (DHGEN_CALLER_GIVES|DHGEN_FRAMES)\n((?:(?!#else|#endif).*\n)*)"
    r"(?:#else\n((?:(?!#endif).*\n)*))?#endif\n\n?"
)
_VERSION = re.compile(
    r"#define DHGEN_EXPECTS .*\n|#if defined\(DHGEN_EXPECTS\) .*\n#error .*\n#endif\n"
)
_LANES = "#if DHGEN_LANES > 1\n"
# Also in a program whose other robots share the runtime.
_ALONE = "#undef DHGEN_SHARED /* the whole runtime is in this file */\n"
_LICENCE = "/* SPDX-License-Identifier: MIT\n *\n * "


def in_one_header(header: str) -> str:
    """A header with the type of a calibration pasted into it, guarded: others may hold it, too."""
    content = c_runtime_files()[CALIBRATION].replace(_LICENCE, "/* ")
    return header.replace(f'#include "{CALIBRATION}"\n', content)


def in_one_file(source: str, *, vectors: bool) -> str:
    """A source with what it includes of the runtime pasted into it.

    Args:
        source: The text.
        vectors: Whether its lanes may be vectors; otherwise what is for these alone is left out.
    """
    first = source.find('#include "dhgen/')
    if first >= 0:
        source = source[:first] + _ALONE + source[first:]
    # what defines the type of a calibration is in the header of arms that need it
    known = {CALIBRATION} if f'#include "{CALIBRATED}"' in source else set()
    pasted = _pasted(source, "", known if vectors else known | {VECTORS})

    def chosen(found: re.Match[str]) -> str:
        return str(found[2 if f"#define {found[1]} " in source else 3] or "")

    chosen_text = _CHOICE.sub(chosen, _VERSION.sub("", pasted))
    return chosen_text if vectors else _of_single_numbers(chosen_text)


def _of_single_numbers(text: str) -> str:
    """The text where a lane is a number: without what there is for several lanes."""
    kept = []
    choices: list[bool | None] = []  # of each condition around a line: none, or whether it is true
    for line in text.splitlines(keepends=True):
        word = line.split()[0] if line.startswith("#") else ""
        if line == _LANES:
            choices.append(False)
        elif word == "#else" and choices[-1] is not None:
            choices[-1] = True
        elif word != "#endif" or choices.pop() is None:
            if word in {"#if", "#ifdef", "#ifndef"}:
                choices.append(None)
            if False not in choices:
                kept.append(line)
    return "".join(kept)


def _pasted(source: str, folder: str, known: set[str]) -> str:
    """A text with what it includes of the runtime pasted into it.

    Args:
        source: The text.
        folder: Where it lies.
        known: Files that are not pasted (again); what is pasted once joins them.
    """

    def text(found: re.Match[str]) -> str:
        name = normpath(join(folder, found[1]))
        if name in known:
            return ""
        if name not in c_runtime_files():  # the robot's header
            return found[0]
        content = c_runtime_files()[name].replace(_LICENCE, "/* ")
        guarded = _GUARD.search(content)
        if guarded:
            known.add(name)
            content = content[: guarded.start()] + guarded[2]
        return _pasted(content, dirname(name), known).strip("\n") + "\n"

    return _INCLUDE.sub(text, source)
