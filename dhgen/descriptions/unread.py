"""Attributes of joints that no URDF has: mostly mistyped ones, and without them another arm."""

from __future__ import annotations

import difflib
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.descriptions.markup import Element
    from dhgen.descriptions.model import Joint

QUATERNION = "quat_xyzw"  # of an origin in URDF 1.2, in the place of rpy
# What URDF has up to version 1.2; effort and the like are known, though an arm does without.
_KNOWN = {
    "origin": ("xyz", "rpy", QUATERNION),
    "axis": ("xyz",),
    "limit": ("lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"),
}
_OTHER_WORDS = {
    **dict.fromkeys(("quat", "quaternion", "quat_wxyz", "wxyz", "xyzw", "orientation"), QUATERNION),
    **dict.fromkeys(("rotation", "euler"), "rpy"),
    **dict.fromkeys(("position", "translation", "direction"), "xyz"),
    **dict.fromkeys(("min", "low", "minimum"), "lower"),
    **dict.fromkeys(("max", "high", "maximum"), "upper"),
}
SHOWN = 6


def unread_attributes(*elements: Element | None) -> tuple[tuple[str, str], ...]:
    """The attributes that no URDF has, each with its element; those with a prefix are others'."""
    return tuple(
        (element.tag, key)
        for element in elements
        if element is not None
        for key in element.attributes
        if key not in _KNOWN[element.tag] and ":" not in key and key != "xmlns"
    )


def unread_notes(joints: Iterable[Joint]) -> list[str]:
    """A note on each attribute that was not read, with the joints that have it."""
    found: dict[tuple[str, str], list[str]] = {}
    for joint in joints:
        for each in joint.unread:
            found.setdefault(each, []).append(joint.name)
    return [_note(tag, key, names) for (tag, key), names in found.items()]


def _note(tag: str, key: str, names: list[str]) -> str:
    shown = ", ".join(names[:SHOWN]) + (", ..." if len(names) > SHOWN else "")
    shape = re.sub(r"[^a-z]", "", key.casefold())
    known = _KNOWN[tag]
    other = _OTHER_WORDS.get(key.casefold(), "")
    meant = [other] if other in known else difflib.get_close_matches(shape[:40], known, n=1)
    hint = f"write {meant[0]} if that is meant" if meant else f"known are {', '.join(known)}"
    return f"not read: {key[:40]} in the <{tag}> of {shown}, an attribute that URDF lacks; {hint}"
