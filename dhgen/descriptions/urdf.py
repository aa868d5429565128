"""A URDF file to a Description: all its mistakes at once, each at its line."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from dhgen.descriptions.locked import with_locked
from dhgen.descriptions.markup import Element, read_xml
from dhgen.descriptions.model import Description, Joint, Mimic, Motion
from dhgen.descriptions.rotations import from_quaternion, to_rpy
from dhgen.descriptions.tree import check_tree
from dhgen.descriptions.unread import QUATERNION, unread_attributes
from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.arithmetic import nearest
from dhgen.robot.source import Span, quoted

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.descriptions.model import Vector
    from dhgen.robot.source import SourceText

MOST_COLLECTED = 500
MAX_SHOWN = 20  # mistakes; one slip of a generator is in every joint
X: Vector = (1.0, 0.0, 0.0)
ORIGIN: Vector = (0.0, 0.0, 0.0)
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_ENDLESS = re.compile(r"[+-]?(inf|infinity)", re.ASCII | re.IGNORECASE)
LARGEST = 1e9  # a number beyond is nobody's


def read_urdf(content: bytes, file: str, kind: str = "URDF") -> Description:
    """The robot of a URDF file.

    Args:
        content: The file's bytes.
        file: What remarks call it.
        kind: What people call the file that the bytes come from.

    Raises:
        RobotFileError: It is no URDF, or has mistakes: all of them, where that is possible.
    """
    root, source = read_xml(content, file)
    return _Urdf(root, source, kind).description()


class _Urdf:
    def __init__(self, root: Element, source: SourceText, kind: str) -> None:
        self.root = root
        self.source = source
        self.kind = kind
        self.mistakes: list[Diagnostic] = []

    def description(self) -> Description:
        if self.root.tag != "robot":
            self.wrong(self.root, f"a URDF begins with <robot>, not <{self.root.tag}>")
            raise self.refusal()
        links = self.links()
        joints = [joint for each in self.root.all("joint") if (joint := self.joint(each, links))]
        self.refuse_twins("joint", self.root.all("joint"))
        if not self.root.all("joint"):
            macros = "; the file that calls these macros may have some" * (self.kind == "xacro")
            self.wrong(self.root, f"no <joint>: there is nothing that moves{macros}")
        if self.mistakes:
            raise self.refusal()
        root = check_tree(tuple(links), joints, self.wrong_at)
        if self.mistakes:
            raise self.refusal()
        name = self.root.attributes.get("name", "").strip() or "robot"
        by_child = {joint.child: joint for joint in with_locked(joints)}
        return Description(name, self.kind, root, by_child, self.source)

    def links(self) -> dict[str, Element]:
        elements = self.root.all("link")
        self.refuse_twins("link", elements)
        for element in elements:
            self.name(element)
        return {element.attributes.get("name", ""): element for element in elements}

    def joint(self, element: Element, links: dict[str, Element]) -> Joint | None:
        before = len(self.mistakes)
        name = self.name(element)
        motion = self.motion(element)
        parent, child = (self.link(element, tag, links) for tag in ("parent", "child"))
        origin, axis_element = self.only(element, "origin"), self.only(element, "axis")
        xyz, rpy = self.vector(origin, "xyz", ORIGIN), self.rpy(origin)
        axis = self.vector(axis_element, "xyz", X)
        if motion.is_actuated and math.hypot(*axis) < 1e-9:
            self.wrong_value(element.all("axis")[0], "xyz", "an axis can't have length 0")
        mimic, limit = self.only(element, "mimic"), self.only(element, "limit")
        limits = self.limits(limit, motion)
        mimics = None if mimic is None else self.mimic(mimic)
        if len(self.mistakes) > before:
            return None
        unread = unread_attributes(origin, axis_element, limit)
        return Joint(
            name, motion, parent, child, xyz, rpy, axis, limits, mimics, element.place, unread
        )

    def rpy(self, origin: Element | None) -> Vector:
        """Roll, pitch and yaw, by a quaternion (x y z w) where that is written in their place."""
        if origin is None or QUATERNION not in origin.attributes:
            return self.vector(origin, "rpy", ORIGIN)
        if "rpy" in origin.attributes:
            message = f"rpy and {QUATERNION}: only one of them can count"
            self.wrong_value(origin, QUATERNION, message)
        x, y, z, w = self.numbers(origin, QUATERNION, (0.0, 0.0, 0.0, 1.0))
        size = math.hypot(x, y, z, w)
        if size < 1e-9:
            self.wrong_value(origin, QUATERNION, "a quaternion can't have length 0")
            return ORIGIN
        return to_rpy(from_quaternion((w / size, x / size, y / size, z / size)))

    def mimic(self, element: Element) -> Mimic:
        """What a joint follows; mistakes are noted."""
        words = element.attributes
        multiplier = self.number(element, "multiplier", words.get("multiplier", "1"))
        offset = self.number(element, "offset", words.get("offset", "0"))
        return Mimic(words.get("joint", ""), multiplier, offset)

    def name(self, element: Element) -> str:
        name = element.attributes.get("name", "")
        if not name.strip():
            self.wrong(element, f"a <{element.tag}> needs a name")
        return name

    def motion(self, element: Element) -> Motion:
        given = element.attributes.get("type")
        known = [motion.value for motion in Motion if motion is not Motion.BALL]
        if given in known:
            return Motion(given)
        if given is None:
            self.wrong(element, f"a <joint> needs a type: {', '.join(known)}")
        else:
            message = f"unknown type of joint {quoted(given)}: one of {', '.join(known)}"
            self.wrong_value(element, "type", message)
        return Motion.FIXED

    def link(self, element: Element, tag: str, links: dict[str, Element]) -> str:
        found = self.only(element, tag)
        if found is None:
            self.wrong(element, f"a <joint> needs a <{tag} link=...>")
            return ""
        name = found.attributes.get("link", "")
        if name not in links:
            hint = nearest(name, tuple(links)) if len(self.mistakes) < MAX_SHOWN else ""
            self.wrong_value(found, "link", f"there is no link {quoted(name)}{hint}")
        return name

    def only(self, element: Element, tag: str) -> Element | None:
        found = element.all(tag)
        for again in found[1:]:
            self.wrong(again, f"a second <{tag}> in one joint: only one can count")
        return found[0] if found else None

    def vector(self, element: Element | None, key: str, default: Vector) -> Vector:
        x, y, z = default if element is None else self.numbers(element, key, default)
        return x, y, z

    def numbers(self, element: Element, key: str, default: tuple[float, ...]) -> tuple[float, ...]:
        """As many numbers as the default has."""
        if key not in element.attributes:
            return default
        words = element.attributes[key].split()
        if len(words) != len(default):
            count = {3: "three", 4: "four"}[len(default)]
            commas = " without commas" if "," in element.attributes[key] else ""
            message = f"{key} needs {count} numbers{commas}, not {quoted(element.attributes[key])}"
            self.wrong_value(element, key, message)
            return default
        return tuple(self.number(element, key, word) for word in words)

    def limits(self, element: Element | None, motion: Motion) -> tuple[float, float] | None:
        """Both ends, 0 where only one is written; None where a joint has no use for any."""
        ends = ("lower", "upper")
        if element is None or not motion.is_actuated:
            return None
        if motion is Motion.CONTINUOUS or not any(end in element.attributes for end in ends):
            return None
        low, high = (
            self.number(element, end, element.attributes.get(end, "0"), endless=True)
            for end in ends
        )
        return low, high

    def number(self, element: Element, key: str, word: str, *, endless: bool = False) -> float:
        word = word.strip()
        if endless and _ENDLESS.fullmatch(word):
            return float(word)
        if not _NUMBER.fullmatch(word):
            hint = ": numbers stand apart by blanks, without commas" if "," in word else ""
            self.wrong_value(element, key, f"{quoted(word)} is not a number{hint}", word)
            return 0.0
        value = float(word)
        if abs(value) > LARGEST and not endless:
            self.wrong_value(element, key, f"{quoted(word)} is beyond all sizes", word)
        return value

    def refuse_twins(self, what: str, elements: Iterable[Element]) -> None:
        first: dict[str, Element] = {}
        for element in elements:
            name = element.attributes.get("name", "")
            if name in first and name:
                line = self.source.number(first[name].place) + 1
                message = f"the {what} {quoted(name)} is already in line {line}"
                self.wrong_value(element, "name", message)
            first.setdefault(name, element)

    def wrong(self, element: Element, message: str) -> None:
        self.wrong_at(element.place, message)

    def wrong_at(self, place: Span, message: str) -> None:
        self.mistakes.append(self.source.point(place, message))
        if len(self.mistakes) == MOST_COLLECTED:
            raise self.refusal()

    def wrong_value(self, element: Element, key: str, message: str, part: str = "") -> None:
        """A mistake in an attribute, with the caret under it where it can be found."""
        tail = self.source.text[element.place.start : element.place.start + 2000].partition(">")[0]
        found = re.search(rf"\s{re.escape(key)}\s*=\s*[\"']", tail)
        value = element.attributes.get(key, "")
        if found is None:
            self.wrong(element, message)
            return
        start = element.place.start + found.end()
        shift = max(value.find(part), 0) if part else 0
        self.wrong_at(Span(start + shift, max(len(part or value), 1)), message)

    def refusal(self) -> RobotFileError:
        once = tuple(dict.fromkeys(self.mistakes))
        ordered = sorted(once, key=lambda mistake: (mistake.line, mistake.column))
        left = len(ordered) - MAX_SHOWN
        if left > 0:
            least = "at least " if len(self.mistakes) == MOST_COLLECTED else ""
            more = Diagnostic(self.source.file, 0, 0, f"and {least}{left} more mistakes")
            ordered = [*ordered[:MAX_SHOWN], more]
        return RobotFileError(tuple(ordered))
