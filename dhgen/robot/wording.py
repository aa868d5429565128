"""What a mistaken value is told: what is valid at its place, and what stands there."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.schema import FRAME_FORM, MAX_JOINTS
from dhgen.robot.source import quoted
from dhgen.robot.syntax import blank_told
from dhgen.robot.values import ExpectedError

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

    from dhgen.robot.reader import Path

# Infinity, or no end at all, as other programs and people write it.
ENDLESS = (
    *(".inf", "inf", "infinity", "oo"),
    *("none", "null", "no", "false", "unlimited", "continuous", "endless"),
)
NO_LIMITS = "if nothing stops the joint, leave 'limits' out"

# By the kind of mistake, where every key that takes such a value takes the same.
_KINDS = {
    "string_type": "a number or an expression",
}

_KEYED = {"model_type", "dict_type"}  # where keys with values belong

_ROW = "{theta: q, d: 0, a: 0.4, alpha: pi/2}"
_AXIS = "{type: prismatic, direction: [0, 0, 1]}"
_VECTOR = "a list [x, y, z]"

# What a key holds that takes a list or further keys.
_FORMS = {
    "parameters": "names with values, e.g. {a1: 0.4}",
    "joints": f"a list of joints, e.g. [{_ROW}]",
    "axes": f"a list of axes, e.g. [{_AXIS}]",
    "home": FRAME_FORM,
    "base": FRAME_FORM,
    "tool": FRAME_FORM,
    "units": "keys with values, e.g. {length: mm}",
    "limits": "a list [lowest, highest]",
    "direction": _VECTOR,
    "point": _VECTOR,
    "xyz": _VECTOR,
    "rpy": "a list [roll, pitch, yaw]",
    "quaternion_xyzw": "a list [x, y, z, w]",
    "quaternion_wxyz": "a list [w, x, y, z]",
    "matrix": "four rows of four numbers",
}

# What one entry of a list holds.
_ENTRIES = {
    "joints": f"a joint, e.g. {_ROW}",
    "axes": f"an axis, e.g. {_AXIS}",
    "matrix": "a row of four numbers",
}


def is_endless(given: object) -> bool:
    """Whether a value says infinity, or that there is no limit."""
    return isinstance(given, str) and given.strip().lstrip("+-").lower() in ENDLESS


def _is_none(given: object) -> bool:
    return given is None or is_endless(given)


def length_message(path: Path, details: ErrorDetails) -> str:
    """What a list of the wrong length is told, or too many parameters."""
    context = details.get("ctx", {})
    count = context.get("actual_length")
    bound = context.get("min_length", context.get("max_length"))
    if path[-1] in {"joints", "axes"}:
        return f"a robot has 1 to {MAX_JOINTS} joints, not {count}"
    if path[-1] == "parameters":
        return f"a robot has at most {bound} parameters"
    hint = f"; {NO_LIMITS}" if path[-1] == "limits" and not count else ""
    return f"expected {bound} values, not {count}: {_form(path)}{hint}"


def value_message(details: ErrorDetails) -> str:
    """What any other value is told that can't stand where it does."""
    given, path = details["input"], details["loc"]
    context = details.get("ctx", {})
    shown = quoted(given) if isinstance(given, str) else _kind(given)
    if details["type"] == "value_error":
        reason = context["error"]
        if isinstance(reason, ExpectedError):
            return f"expected {reason}, not {shown}"
        return f"{shown}: {reason}" if isinstance(given, str) else f"{reason}"
    if details["type"] == "string_type" and path[0] in {"name", "title", "source"}:
        return f"expected a text, not {shown}"
    expected = context.get("expected") or _KINDS.get(details["type"]) or _form(path)
    blank = blank_told(given) if details["type"] in _KEYED and isinstance(given, str) else None
    hint = f"; {NO_LIMITS}" if path[-1] == "limits" and _is_none(given) else ""
    return blank or f"expected {expected}, not {shown}{hint}"


def _form(path: Path) -> str:
    """What the key holds at the end of a path, or what an entry of its list does."""
    key = next(str(step) for step in reversed(path) if isinstance(step, str))
    return _FORMS[key] if path[-1] == key else _ENTRIES[key]


def _kind(given: object) -> str:
    if given is None:
        return "nothing"
    if not isinstance(given, list):
        return "keys with values"
    return f"a list of {len(given)}" if given else "an empty list"
