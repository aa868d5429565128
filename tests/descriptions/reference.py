"""URDF read and evaluated another way: by ElementTree and quaternions."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.arrays import FloatArray
    from dhgen.descriptions.convert import Import

FILES = Path(__file__).parent / "urdf"
ARMS = sorted(path.stem for path in FILES.glob("*.urdf"))


def worst_difference(text: str, imported: Import, count: int = 50) -> tuple[float, float]:
    """How far the compiler's model of an import is from the description [length, rad]."""
    root = ET.fromstring(text)  # noqa: S314 - the tests' own
    joints = _way(root, imported.chain.base, imported.chain.tip)
    moving = [joint for joint in joints if joint.get("type") != "fixed"]
    arm = numeric_arm(build_chain(imported.robot))
    q = np.random.default_rng(1).uniform(-3, 3, (count, len(moving)))
    moved = turned = 0.0
    for values in q:
        point, quaternion = _tip(joints, iter(values))
        T = arm.pose(values)
        moved = max(moved, float(np.linalg.norm(T[:3, 3] - point)))
        turned = max(turned, float(np.abs(T[:3, :3] - _matrix(quaternion)).max()))
    return moved, turned


def _way(root: ET.Element, base: str, tip: str) -> list[ET.Element]:
    by_child = {_find(joint, "child").attrib["link"]: joint for joint in root.findall("joint")}
    found = []
    while tip != base:
        found.append(by_child[tip])
        tip = _find(found[-1], "parent").attrib["link"]
    return found[::-1]


def _find(element: ET.Element, tag: str) -> ET.Element:
    found = element.find(tag)
    return ET.Element(tag) if found is None else found


def _tip(joints: list[ET.Element], values: Iterator[float]) -> tuple[FloatArray, FloatArray]:
    point, turn = np.zeros(3), np.array([1.0, 0.0, 0.0, 0.0])
    for joint in joints:
        origin = _find(joint, "origin")
        point = point + _rotate(turn, _numbers(origin.get("xyz", "0 0 0")))
        roll, pitch, yaw = _numbers(origin.get("rpy", "0 0 0"))
        for unit, angle in zip(np.eye(3)[::-1], (yaw, pitch, roll), strict=True):
            turn = _times(turn, _about(unit, angle))
        kind = joint.get("type")
        if kind == "fixed":
            continue
        axis = _numbers(_find(joint, "axis").get("xyz", "1 0 0"))
        axis, value = axis / np.linalg.norm(axis), next(values)
        if kind == "prismatic":
            point = point + _rotate(turn, axis * value)
        else:
            turn = _times(turn, _about(axis, value))
    return point, turn


def _numbers(text: str) -> FloatArray:
    return np.array([float(word) for word in text.split()])


def _about(axis: FloatArray, angle: float) -> FloatArray:
    return np.array([math.cos(angle / 2), *(math.sin(angle / 2) * axis)])


def _times(p: FloatArray, q: FloatArray) -> FloatArray:
    return np.array(
        [
            p[0] * q[0] - p[1:] @ q[1:],
            *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])),
        ]
    )


def _rotate(turn: FloatArray, vector: FloatArray) -> FloatArray:
    back = turn * np.array([1.0, -1.0, -1.0, -1.0])
    return _times(_times(turn, np.array([0.0, *vector])), back)[1:]


def _matrix(turn: FloatArray) -> FloatArray:
    return np.column_stack([_rotate(turn, axis) for axis in np.eye(3)])
