"""A robot from anything that describes one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Real
from operator import index
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from dhgen.descriptions.expand import Outside
from dhgen.descriptions.snap import MOST
from dhgen.descriptions.wishes import Wishes
from dhgen.errors import CommandError, RobotFileError
from dhgen.library.arm import Arm
from dhgen.library.wording import note_for_python
from dhgen.robot.load import is_description
from dhgen.robot.mapping import load_mapping
from dhgen.robot.source import quoted
from dhgen.robot.task import ARM_ANGLE
from dhgen.robot_files import RobotFile

if TYPE_CHECKING:
    import os


def load(  # noqa: PLR0913 - the options of `dhgen import`
    source: str | os.PathLike[str] | Mapping[str, Any],
    *,
    base: str | None = None,
    tip: str | None = None,
    snap: float | None = None,
    axes: bool = False,
    free: Sequence[int] | Literal["arm_angle"] | None = None,
    package: Mapping[str, str | os.PathLike[str]] | None = None,
    arg: Mapping[str, object] | None = None,
    numerical: bool = False,
) -> Arm:
    """The arm of a robot description, of a robot file, or of a dict with the keys of one.

    All arguments but the first and `numerical` are for descriptions, as in `dhgen import`; robot
    files and dicts have keys for what is like them.

    Args:
        source: The path of a URDF, xacro, MJCF or robot file (YAML), or a dict.
        base: The link that poses are in; by default the one before the first joint.
        tip: The link that poses are of; by default the longest arm's end.
        snap: What is nearer than this to a multiple of 15 degrees [rad], or to zero [arm sizes], is
            taken as exact; by default 1e-5 and 1e-7. Angles like 1.57 need 1e-3.
        axes: Whether the robot file holds axes in the reference position, not a table.
        free: The joints, from 1, whose values the caller gives, or "arm_angle"; by default as many
            as there are above six, where that leaves the most structure.
        package: Of a xacro: folders of ROS packages that are not above the file, by their names.
        arg: Of a xacro: values of its arguments, by their names.
        numerical: Whether to fall back to the numerical solver where nothing else works.

    Raises:
        RobotFileError: The source can't be read, or describes no robot: all its mistakes at once.
        CommandError: An option has no meaning for this source.
    """
    given: dict[str, object] = {"base": base, "tip": tip, "snap": snap, "axes": axes or None}
    given |= {"free": free, "package": package, "arg": arg}
    options = [name for name, value in given.items() if value is not None]
    if isinstance(source, Mapping):
        _demand_none(options, "a dict")
        file, label = _of_mapping(source)
    else:
        path = _path(source)
        if not is_description(path):
            _demand_none(options, str(path))
        links = _link("base", base), _link("tip", tip)
        wishes = Wishes(*links, _tolerance(snap), as_axes=axes, free=_joints(free))
        packages = {name: Path(folder) for name, folder in _named("package", package).items()}
        arguments = {name: _argument(value) for name, value in _named("arg", arg).items()}
        try:
            file, label = RobotFile.read(path, wishes, Outside(packages, arguments)), str(path)
        except RobotFileError as error:
            note_for_python(error, repr(str(source)))
            raise
    return Arm(file.with_numerical() if numerical else file, label)


def _of_mapping(mapping: Mapping[str, Any]) -> tuple[RobotFile, str]:
    """The robot file of a dict, as if it had been read from a file of the robot's name."""
    text, robot = load_mapping(mapping)
    return RobotFile(Path(f"{robot.name}.yaml"), robot, text), robot.name


def _path(source: str | os.PathLike[str]) -> Path:
    if isinstance(source, str) and source.lstrip().startswith("<"):
        raise CommandError("load takes a path, not the text of a description: write that to a file")
    try:
        return Path(source)
    except TypeError:
        what = f"{type(source).__name__} {quoted(repr(source))}"
        message = f"load takes a path, or a dict with keys of a robot file, not {what}"
        raise CommandError(message) from None


def _link(option: str, name: str | None) -> str | None:
    if not isinstance(name, (str, type(None))):
        raise CommandError(f"{option} takes the name of a link, not {name!r}")
    return name


def _named(option: str, values: Mapping[str, Any] | None) -> Mapping[str, Any]:
    if not isinstance(values, (Mapping, type(None))):
        raise CommandError(f"{option} takes a dict of names and values, not {values!r}")
    return values or {}


def _joints(free: Sequence[int] | str | None) -> tuple[int, ...] | str | None:
    if free is None or (isinstance(free, str) and free == ARM_ANGLE):
        return free
    try:
        return tuple(map(index, free))  # type: ignore[arg-type]
    except TypeError:
        message = f"free takes numbers of joints, as [7], or '{ARM_ANGLE}', not {free!r}"
        raise CommandError(message) from None


def _tolerance(snap: float | None) -> float | None:
    if snap is not None and not (isinstance(snap, Real) and 0.0 <= float(snap) <= MOST):
        raise CommandError(f"snap must be a number from 0 to {MOST:g}, not {snap!r}")
    return None if snap is None else float(snap)


def _demand_none(options: list[str], source: str) -> None:
    """Stops where options of an import are given for something else."""
    if options:
        subject = f"{', '.join(options)} {'are' if options[1:] else 'is'}"
        kinds = "robot descriptions (URDF, xacro, MJCF)"
        raise CommandError(f"{source}: {subject} for {kinds}; a robot file has its own keys")


def _argument(value: object) -> str:
    """A value as xacro writes it."""
    return str(value).lower() if isinstance(value, bool) else str(value)
