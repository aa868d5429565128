"""The commands that write robot files: import and calibrate.

What needs sympy is imported late, so that errors and --help come at once.
"""

from __future__ import annotations

import sys
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING

from dhgen.errors import CommandError, refused
from dhgen.places_to_write import (
    print_replaced,
    refuse_mute,
    refuse_occupied,
    refuse_what_was_read,
)

if TYPE_CHECKING:
    import argparse
    from collections.abc import Sequence


def import_description(options: argparse.Namespace) -> int:
    """Writes the robot file of a description; the exit code."""
    from dhgen.descriptions.compare import SAMPLES  # noqa: PLC0415
    from dhgen.descriptions.expand import Outside  # noqa: PLC0415
    from dhgen.descriptions.files import import_file  # noqa: PLC0415
    from dhgen.descriptions.wishes import Wishes  # noqa: PLC0415
    from dhgen.descriptions.write import plain  # noqa: PLC0415

    chosen = options.base, options.tip, options.snap
    wishes = Wishes(*chosen, as_axes=options.axes, free=options.free)
    outside = Outside(dict(options.package), dict(options.arg))
    imported = import_file(options.file, wishes, outside)
    for note in imported.notes:
        print(f"note: {note}", file=sys.stderr)
    read = (options.file,)
    out = _write_robot_file(imported.robot.name, imported.text, options.out, read)
    if out is None:
        return 0
    chain, off = imported.chain, imported.difference
    joints = len(chain.actuated)
    print(f"{imported.robot.name}: {joints} joints, from {plain(chain.base)} to {plain(chain.tip)}")
    print(
        f"compared with {options.file.name} at {SAMPLES} random joint values: the tools are "
        f"{off.moved:.1e} {imported.robot.length_unit} apart at most "
        f"({off.moved / off.size:.1e} of the arm's size), and turned by {off.turned:.1e} rad"
    )
    print(f"wrote {out}; solvers: dhgen {quote(str(out))}")
    return 0


def calibrate(options: argparse.Namespace) -> int:
    """Writes the robot file of a calibrated arm; the exit code."""
    from dhgen.calibration.calibrate import calibrate as calibrated_by  # noqa: PLC0415
    from dhgen.calibration.read import read_calibration  # noqa: PLC0415
    from dhgen.robot_files import ParallelFile, read_file  # noqa: PLC0415

    file = read_file(options.file)
    if isinstance(file, ParallelFile):
        message = "a robot with legs is a parallel one: only serial arms are calibrated so far"
        raise refused(file.path, message)
    nominal = file.robot
    calibration = read_calibration(options.calibration)
    name = "" if options.out in {None, Path("-")} else options.out.stem
    made = calibrated_by(nominal, calibration, name=name, as_axes=options.axes)
    for note in made.notes:
        print(f"note: {note}", file=sys.stderr)
    read = (options.file, options.calibration)
    out = _write_robot_file(made.robot.name, made.text, options.out, read)
    if out is not None:
        moved = f"{made.moved.moved:.2g} {nominal.length_unit} and {made.moved.turned:.2g} rad"
        print(f"{made.robot.name}: the tool is up to {moved} away from that of {nominal.name}")
        print(f"wrote {out}; solvers: dhgen {quote(str(out))}")
    return 0


def _write_robot_file(
    name: str, text: str, wished: Path | None, read: Sequence[Path]
) -> Path | None:
    """Writes a robot file, and reports where it replaces another one.

    Args:
        name: The robot's, which names the file where nobody wishes another name.
        text: What to write.
        wished: Where to write; a file that is there is written over, a folder that is missing is
            made. A dash is the terminal.
        read: The files that this one is made of, which are not written over.

    Returns:
        Where it was written; None for the terminal.
    """
    from dhgen.atomic_write import replace_files  # noqa: PLC0415

    if wished == Path("-"):
        refuse_mute()
        print(text, end="")
        return None
    out = wished or Path(f"{name}.yaml")
    refuse_occupied([out])
    if out.exists() and wished is None and out.read_bytes() != text.encode():
        message = f"dhgen: {out} is there already: write over it with --out {quote(str(out))}"
        raise CommandError(f"{message}, or name another file")
    refuse_what_was_read(out, read)
    print_replaced(out, text)
    out.parent.mkdir(parents=True, exist_ok=True)
    replace_files(out.parent, {out.name: text.encode()})
    return out
