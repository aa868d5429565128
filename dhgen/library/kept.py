"""Solvers that were verified, in a folder of the user's: each in one of its own, by its content.

A folder's name is the digest of all that its files depend on: the robot file, and dhgen itself with
its templates and its runtime. A file in it has the digests of the others: a folder that somebody
has tidied is built again. Any number of processes may build at once: a folder takes its place when
it is whole, and who comes second takes the first one's.
"""

from __future__ import annotations

import json
import tempfile
from contextlib import suppress
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

import dhgen
from dhgen.atomic_write import write_files
from dhgen.printing.templates import template_folder
from dhgen.runtime.helpers.dhgen_native import WRITABLE, cache_folder

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.robot_files import RobotFile

FOLDER = "solvers"  # in the cache folder, beside the libraries of dhgen_native
DIGESTS = "digests.json"
_CODE = {".py", ".c", ".h"}


def folder_of(file: RobotFile) -> Path:
    """Where the solver of a robot file is kept, if it is."""
    texts = (_of_dhgen(), file.path.name, str(file.robot.numerical), file.text)
    digest = _digest("\0".join(texts).encode("utf-8", "surrogateescape"))
    return cache_folder() / FOLDER / f"{file.robot.name}-{digest[:24]}"


@cache
def _of_dhgen() -> str:
    """The digest of dhgen: of its version, of its code, of what it copies and fills in."""
    package = Path(dhgen.__file__).parent
    code = (path for path in package.rglob("*") if path.suffix in _CODE)
    made = sha256(dhgen.__version__.encode())
    for path in (*sorted(code), *sorted(template_folder().rglob("*.jinja"))):
        made.update(f"\0{path.name}\0".encode() + path.read_bytes())
    return made.hexdigest()


def is_whole(folder: Path) -> bool:
    """Whether a folder holds all that was put there, as it was."""
    try:
        digests = json.loads((folder / DIGESTS).read_text("utf-8"))
        return all(_digest((folder / name).read_bytes()) == made for name, made in digests.items())
    except (OSError, ValueError, AttributeError):
        return False


def keep(folder: Path, texts: Mapping[str, str]) -> None:
    """Puts the files of a solver in its folder, unless they are there.

    Raises:
        OSError: The cache folder can't be written to.
    """
    with room_for(folder) as place:
        made = Path(place) / "made"
        write_files(made, texts)
        digests = {name: _digest((made / name).read_bytes()) for name in sorted(texts)}
        (made / DIGESTS).write_text(json.dumps(digests, indent=1), encoding="utf-8")
        _take_place(made, folder, Path(place) / "damaged")


def room_for(folder: Path) -> tempfile.TemporaryDirectory[str]:
    """A folder for the files of a solver, beside the one that they are to be in.

    Raises:
        OSError: The cache folder can't be written to.
    """
    try:
        folder.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        return tempfile.TemporaryDirectory(prefix=".", dir=folder.parent)
    except OSError as error:
        problem = f"solvers can't be kept there ({error.strerror}): {WRITABLE}"
        raise OSError(error.errno, problem, str(folder.parent)) from None


def _take_place(made: Path, folder: Path, aside: Path) -> None:
    """Gives a folder its name; one of that name that is not whole is put aside."""
    for _ in range(2):
        if is_whole(folder):
            return  # another process was sooner
        with suppress(FileNotFoundError):
            folder.rename(aside)
        try:
            made.rename(folder)
        except OSError:  # another process has just put its own there
            continue
        return


def _digest(content: bytes) -> str:
    return sha256(content).hexdigest()
