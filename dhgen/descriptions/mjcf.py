"""MJCF files to a Description: MuJoCo compiles them, by the optional package mujoco.

Defaults, includes, degrees, Euler sequences and quaternions' ends are MuJoCo's affair: what is read
here is the compiled model, in radians, with quaternions w x y z.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from dhgen.descriptions.model import Description, Joint, Mimic, Motion
from dhgen.descriptions.rotations import (
    STILL,
    about,
    from_quaternion,
    product,
    times,
    to_rpy,
    turned,
)
from dhgen.errors import refused
from dhgen.robot.source import SourceText, Span

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from dhgen.descriptions.model import Vector
    from dhgen.descriptions.rotations import Rotation

NOWHERE = Span(0)
_MOTIONS = (Motion.FLOATING, Motion.BALL, Motion.PRISMATIC, Motion.REVOLUTE)  # mjtJoint
_CONNECT, _WELD, _JOINT_EQUALITY = range(3)  # mjtEq
_SITE = 6  # mjOBJ_SITE
_TERMS = 5  # of the polynomial of an equality of joints


def read_mjcf(path: Path) -> Description:
    """The robot of an MJCF file.

    Raises:
        RobotFileError: mujoco is not installed, or finds mistakes.
    """
    try:
        mujoco = importlib.import_module("mujoco")
    except ImportError:
        message = "this is an MJCF, which needs mujoco: pip install 'dhgen[mjcf]'"
        raise refused(path, message) from None
    try:
        model = mujoco.MjModel.from_xml_path(str(path))
    except (ValueError, mujoco.FatalError) as error:
        reason = " ".join(str(error).split())
        raise refused(path, f"MuJoCo can't compile this: {reason[:300]}") from None
    name = model.names.split(b"\0", 1)[0].decode() or path.stem
    source = SourceText.of("", str(path))
    joints: dict[str, Joint] = {}
    equalities = _equalities(model)
    for body in range(1, model.nbody):
        for joint in _joints(model, body, equalities):
            joints[joint.child] = joint
    for site in range(model.nsite):
        frame = _site(model, site)
        joints.setdefault(frame.child, frame)
    return Description(name, "MJCF", _body(model, 0), joints, source, _closures(model))


def _equalities(model: Any) -> dict[int, Mimic | float]:  # noqa: ANN401 - mujoco is optional
    """What joints follow by equalities that hold from the start, by their numbers.

    MuJoCo counts both joints from where the file shows them. Where no second joint is named, the
    first one is held at a value.
    """
    found: dict[int, Mimic | float] = {}
    for row in range(model.neq):
        if int(model.eq_type[row]) != _JOINT_EQUALITY or not model.eq_active0[row]:
            continue
        number, other = int(model.eq_obj1id[row]), int(model.eq_obj2id[row])
        offset, factor, *curve = (float(term) for term in model.eq_data[row][:_TERMS])
        offset += _reference(model, number)
        if other < 0:
            found[number] = offset
        else:
            offset -= factor * _reference(model, other)
            found[number] = Mimic(_joint(model, other), factor, offset, is_linear=not any(curve))
    return found


def _closures(model: Any) -> tuple[tuple[str, str], ...]:  # noqa: ANN401 - mujoco is optional
    """Bodies that are held together besides the joints between them.

    What is held to a mocap body is moved by the user's hand, not by a mechanism.
    """
    found = []
    for row in range(model.neq):
        if int(model.eq_type[row]) not in {_CONNECT, _WELD} or not model.eq_active0[row]:
            continue
        ends = [int(model.eq_obj1id[row]), int(model.eq_obj2id[row])]
        if int(model.eq_objtype[row]) == _SITE:
            ends = [int(model.site_bodyid[end]) for end in ends]
        if all(model.body_mocapid[end] < 0 for end in ends):
            first, second = (_body(model, end) for end in ends)
            found.append((first, second))
    return tuple(found)


def _reference(model: Any, number: int) -> float:  # noqa: ANN401 - mujoco is optional
    """A joint's value where the file shows it."""
    return float(model.qpos0[model.jnt_qposadr[number]])


def _joints(
    model: Any,  # noqa: ANN401 - mujoco is optional
    body: int,
    equalities: Mapping[int, Mimic | float],
) -> list[Joint]:
    """The joints that move a body, one after the other, and the fixed ones around them."""
    link, name = _body(model, int(model.body_parentid[body])), _body(model, body)
    xyz, rotation = _vector(model.body_pos[body]), from_quaternion(model.body_quat[body])
    first, count = int(model.body_jntadr[body]), int(model.body_jntnum[body])
    found: list[Joint] = []
    for number in range(first, first + count):
        anchor, axis = _vector(model.jnt_pos[number]), _vector(model.jnt_axis[number])
        motion = _MOTIONS[int(model.jnt_type[number])]
        at = tuple(a + b for a, b in zip(xyz, turned(rotation, anchor), strict=True))
        follows = equalities.get(number)
        held = follows if isinstance(follows, float) else 0.0
        start = held - _reference(model, number) if motion.is_actuated else 0.0
        if motion.turns:
            rotation = product(rotation, about(axis, start))
        elif motion.is_actuated:
            shift = turned(rotation, times(axis, start))
            at = tuple(a + b for a, b in zip(at, shift, strict=True))
        last = number == first + count - 1 and not any(anchor)
        child = name if last else _unused(model, f"{name}+{number - first + 1}")
        limited = bool(model.jnt_limited[number])
        low, high = (float(end) for end in model.jnt_range[number])
        x, y, z = at
        if isinstance(follows, float):
            motion = Motion.FIXED
        elif motion.turns and not limited:
            motion = Motion.CONTINUOUS
        found.append(
            Joint(
                name=_joint(model, number),
                motion=motion,
                parent=link,
                child=child,
                xyz=(x, y, z),
                rpy=to_rpy(rotation),
                axis=axis,
                limits=(low, high) if limited else None,
                mimics=follows if isinstance(follows, Mimic) else None,
                place=NOWHERE,
            )
        )
        link, xyz, rotation = child, times(anchor, -1.0), STILL
    if not found or found[-1].child != name:
        found.append(_fixed(name, link, xyz, rotation))
    return found


def _site(model: Any, site: int) -> Joint:  # noqa: ANN401 - mujoco is optional
    """A site as a frame that is fixed to its body."""
    name = model.site(site).name or _unused(model, f"site{site}")
    on = _body(model, int(model.site_bodyid[site]))
    position, quaternion = model.site_pos[site], model.site_quat[site]
    return _fixed(name, on, _vector(position), from_quaternion(quaternion))


def _fixed(name: str, parent: str, xyz: Vector, rotation: Rotation) -> Joint:
    return Joint(
        name=f"{name}_fixed",
        motion=Motion.FIXED,
        parent=parent,
        child=name,
        xyz=xyz,
        rpy=to_rpy(rotation),
        axis=(0.0, 0.0, 1.0),
        limits=None,
        mimics=None,
        place=NOWHERE,
    )


def _joint(model: Any, number: int) -> str:  # noqa: ANN401 - mujoco is optional
    return str(model.joint(number).name) or _unused(model, f"joint{number + 1}")


def _body(model: Any, body: int) -> str:  # noqa: ANN401 - mujoco is optional
    return str(model.body(body).name) or _unused(model, f"body{body}")


def _unused(model: Any, name: str) -> str:  # noqa: ANN401 - mujoco is optional
    """A name for what has none, that nothing in the file has."""
    names = bytes(model.names).decode().split("\0")
    while name in names:
        name += "_"
    return name


def _vector(values: Any) -> Vector:  # noqa: ANN401 - an array of mujoco's
    x, y, z = (float(value) for value in values)
    return x, y, z
