"""Which names a file may give: they end up in Python, in C and in file names."""

from __future__ import annotations

import keyword
import re
import unicodedata
from typing import Literal, TypeAlias

from dhgen.robot.reserved import C_KEYWORDS, C_LIBRARY, FILES, PYTHON

LengthUnit: TypeAlias = Literal["m", "dm", "cm", "mm", "um", "in", "ft"]

MAX_ROBOT_NAME = 48
MAX_PARAMETER_NAME = 32
RESERVED = ("q", "pi", "deg", "sqrt", "sin", "cos")

_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*", re.ASCII)
# What the generator itself writes: c1 s23 q4 theta2 t06, and the field's matrices.
_GENERATED = re.compile(r"[csq]\d+|theta\d*|t\d\d|[TUR]", re.ASCII)

_CONTROL = ("Cc", "Cs", "Zl", "Zp")
# Marks that make a text read otherwise than it is.
_BIDIRECTIONAL = frozenset("\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e") | frozenset(
    "\u2066\u2067\u2068\u2069"
)


def why_no_robot_name(name: str) -> str | None:
    """Why a robot can't be called so, or None."""
    if name.casefold() in FILES:
        return "it is the name of a library or a device, so generated files can't have it"
    return _why_no_identifier(name, MAX_ROBOT_NAME)


def why_no_parameter_name(name: str) -> str | None:
    """Why a parameter can't be called so, or None."""
    if name in RESERVED:
        return f"it is reserved ({', '.join(RESERVED)} have their own meaning)"
    if _GENERATED.fullmatch(name):
        return "the derivation uses such names itself (c1, s23, q4, theta2, t06, T, U, R)"
    if name in PYTHON:
        return "the generated Python needs this name"
    return _why_no_identifier(name, MAX_PARAMETER_NAME)


def why_no_text(text: str, longest: int) -> str | None:
    """Why a text for people can't be used, or None."""
    if len(text) > longest:
        return f"it has {len(text)} characters; at most {longest} are allowed"
    for character in text:
        if unicodedata.category(character) in _CONTROL:
            return f"it contains the control character U+{ord(character):04X}"
        if character in _BIDIRECTIONAL:
            return f"it contains U+{ord(character):04X}, which changes the reading direction"
    return None


def _why_no_identifier(name: str, longest: int) -> str | None:
    checks = {
        "a name is made of a-z, A-Z, 0-9 and _, and starts with a letter": (
            not _IDENTIFIER.fullmatch(name)
        ),
        f"it has {len(name)} characters; at most {longest} are allowed": len(name) > longest,
        "a leading or double underscore is reserved": name.startswith("_") or "__" in name,
        "it is a keyword of Python": keyword.iskeyword(name),
        "it is a keyword of C or C++": name in C_KEYWORDS,
        "it is a name of the C library": name in C_LIBRARY,
    }
    return next((reason for reason, applies in checks.items() if applies), None)
