"""MJCF files to a Description: MuJoCo compiles them, by the optional package mujoco.

Defaults, includes, degrees, Euler sequences and quaternions' ends are MuJoCo's affair: what is read
here is the compiled model, in radians, with quaternions w x y z.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from dhgen.descriptions.model import Description, Joint, Motion
from dhgen.descriptions.rotations import about, product, times, to_rpy, turned
from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.source import SourceText, Span

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.descriptions.model import Vector
    from dhgen.descriptions.rotations import Rotation

NOWHERE = Span(0)
_MOTIONS = (Motion.FLOATING, Motion.FLOATING, Motion.PRISMATIC, Motion.REVOLUTE)  # mjtJoint


def read_mjcf(path: Path) -> Description:
    """The robot of an MJCF file.

    Raises:
        RobotFileError: mujoco is not installed, or finds mistakes.
    """
    try:
        mujoco = importlib.import_module("mujoco")
    except ImportError:
        message = "this is an MJCF, which needs mujoco: pip install 'dhgen[mjcf]'"
        raise _refusal(path, message) from None
    try:
        model = mujoco.MjModel.from_xml_path(str(path))
    except (ValueError, mujoco.FatalError) as error:
        reason = " ".join(str(error).split())
        raise _refusal(path, f"MuJoCo can't compile this: {reason[:300]}") from None
    name = model.names.split(b"\0", 1)[0].decode() or path.stem
    source = SourceText.of("", str(path))
    joints: dict[str, Joint] = {}
    for body in range(1, model.nbody):
        for joint in _joints(model, body):
            joints[joint.child] = joint
    for site in range(model.nsite):
        frame = _site(model, site)
        joints.setdefault(frame.child, frame)
    return Description(name, "MJCF", _body(model, 0), joints, source)


def _joints(model: Any, body: int) -> list[Joint]:  # noqa: ANN401 - mujoco is optional
    """The joints that move a body, one after the other, and the fixed ones around them."""
    link, name = _body(model, int(model.body_parentid[body])), _body(model, body)
    xyz, rotation = _vector(model.body_pos[body]), _rotation(model.body_quat[body])
    first, count = int(model.body_jntadr[body]), int(model.body_jntnum[body])
    found: list[Joint] = []
    for number in range(first, first + count):
        anchor, axis = _vector(model.jnt_pos[number]), _vector(model.jnt_axis[number])
        motion = _MOTIONS[int(model.jnt_type[number])]
        at = tuple(a + b for a, b in zip(xyz, turned(rotation, anchor), strict=True))
        # a joint's value at the position that the file shows
        reference = float(model.qpos0[model.jnt_qposadr[number]]) if motion.is_actuated else 0.0
        if motion.turns:
            rotation = product(rotation, about(axis, -reference))
        elif motion.is_actuated:
            shift = turned(rotation, times(axis, -reference))
            at = tuple(a + b for a, b in zip(at, shift, strict=True))
        last = number == first + count - 1 and not any(anchor)
        child = name if last else f"{name}+{number - first + 1}"
        limited = bool(model.jnt_limited[number])
        low, high = (float(end) for end in model.jnt_range[number])
        x, y, z = at
        found.append(
            Joint(
                name=model.joint(number).name or f"joint{number + 1}",
                motion=Motion.CONTINUOUS if motion.turns and not limited else motion,
                parent=link,
                child=child,
                xyz=(x, y, z),
                rpy=to_rpy(rotation),
                axis=axis,
                limits=(low, high) if limited else None,
                mimics=None,
                place=NOWHERE,
            )
        )
        link, xyz, rotation = child, times(anchor, -1.0), _rotation((1.0, 0.0, 0.0, 0.0))
    if not found or found[-1].child != name:
        found.append(_fixed(name, link, xyz, rotation))
    return found


def _site(model: Any, site: int) -> Joint:  # noqa: ANN401 - mujoco is optional
    """A site as a frame that is fixed to its body."""
    name = model.site(site).name or f"site{site}"
    on = _body(model, int(model.site_bodyid[site]))
    position, quaternion = model.site_pos[site], model.site_quat[site]
    return _fixed(name, on, _vector(position), _rotation(quaternion))


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


def _body(model: Any, body: int) -> str:  # noqa: ANN401 - mujoco is optional
    return str(model.body(body).name) or f"body{body}"


def _vector(values: Any) -> Vector:  # noqa: ANN401 - an array of mujoco's
    x, y, z = (float(value) for value in values)
    return x, y, z


def _rotation(quaternion: Any) -> Rotation:  # noqa: ANN401 - an array of mujoco's
    w, x, y, z = (float(value) for value in quaternion)
    return (
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)),
        (2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)),
        (2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)),
    )


def _refusal(path: Path, message: str) -> RobotFileError:
    return RobotFileError((Diagnostic(str(path), 0, 0, message),))
