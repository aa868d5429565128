"""xacro files to URDF, by the optional package xacrodoc; packages are found above the file."""

from __future__ import annotations

import contextlib
import importlib
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from dhgen.errors import refused
from dhgen.robot.source import quoted

if TYPE_CHECKING:
    from collections.abc import Collection, Mapping
    from pathlib import Path

MACROS = b"<xacro:"  # many files declare xacro's namespace and are expanded already
EXPRESSIONS = (b"${", b"$(")  # which remain in what expanded files hold for other programs
MOST_PACKAGES = 50


@dataclass(frozen=True, slots=True)
class Outside:
    """What a xacro needs of the world around it.

    Attributes:
        packages: Folders of ROS packages by their names.
        arguments: Values of its arguments.
    """

    packages: Mapping[str, Path] = field(default_factory=dict)
    arguments: Mapping[str, str] = field(default_factory=dict)


class _Asked(dict[str, str]):
    """Arguments that note which of them are asked for, by `in` or by their value."""

    def __init__(self, given: Mapping[str, str]) -> None:
        super().__init__(given)
        self.names: dict[str, None] = {}

    def __contains__(self, name: object) -> bool:
        self.names[str(name)] = None
        return super().__contains__(name)

    def __getitem__(self, name: str) -> str:
        self.names[name] = None
        return super().__getitem__(name)

    def note(self, given: Mapping[str, str]) -> tuple[str, ...]:
        """What of the given ones nothing asked for, and what there is; xacro itself takes any."""
        unasked = [name for name in given if name not in self.names]
        known = [name for name in self.keys() if name not in unasked]
        asks = f"it asks for {', '.join(map(quoted, known))}" if known else "it asks for none"
        return (f"{_not_read(unasked)}, which this xacro doesn't ask for: {asks}",) * bool(unasked)


def argument_notes(arguments: Mapping[str, str]) -> tuple[str, ...]:
    """The note on arguments for what is no xacro."""
    return (f"{_not_read(arguments)}: a xacro has arguments, and this is none",) * bool(arguments)


def _not_read(names: Collection[str]) -> str:
    some = "arguments" if len(names) > 1 else "argument"
    return f"not read: {some} {', '.join(map(quoted, names))}"


def has_macros(content: bytes) -> bool:
    """Whether a file is certainly not plain URDF yet."""
    return MACROS in re.sub(rb"<!--.*?-->", b"", content, flags=re.DOTALL)


def has_expressions(content: bytes) -> bool:
    """Whether a file that is no plain URDF may become one."""
    return any(mark in content for mark in EXPRESSIONS)


def expanded(path: Path, outside: Outside) -> tuple[bytes, tuple[str, ...]]:
    """The URDF of a xacro file, and notes on its arguments.

    Raises:
        RobotFileError: xacrodoc is not installed, a package is not found, or the file has mistakes.
    """
    try:
        xacrodoc = importlib.import_module("xacrodoc")
    except ImportError:
        message = "this is a xacro, which needs xacrodoc: pip install 'dhgen[xacro]'"
        raise refused(path, message) from None
    xacrodoc.packages.reset()  # what it found for another file counts for that alone
    xacrodoc.packages.update_package_cache(outside.packages)
    for _ in range(MOST_PACKAGES):
        try:
            return _run(xacrodoc, path, outside.arguments)
        except Exception as error:  # noqa: BLE001 - xacro raises whatever its expressions raise
            missing = _missing_package(error)
            reason = " ".join(str(error).split())[:300]
            if not missing:
                raise refused(path, f"xacro stops: {reason or type(error).__name__}") from None
        folder = _beside(path, missing)
        if folder is None:
            message = f"xacro asks for the package {quoted(missing)}, which is nowhere above the "
            raise refused(path, f"{message}file: name its folder, --package {missing}=DIR")
        xacrodoc.packages.update_package_cache({missing: folder})
    raise refused(path, f"xacro asks for more than {MOST_PACKAGES} packages")


def _run(
    xacrodoc: Any,  # noqa: ANN401 - xacrodoc is optional
    path: Path,
    arguments: Mapping[str, str],
) -> tuple[bytes, tuple[str, ...]]:
    file, asked = path.resolve(), _Asked(arguments)
    with contextlib.chdir(file.parent):  # what it includes is beside it
        document = xacrodoc.XacroDoc.from_file(str(file), subargs=asked, resolve_packages=False)
    return str(document.to_urdf_string()).encode(), asked.note(arguments)


def _missing_package(error: BaseException | None) -> str:
    """The name of the package that an error, or what it came from, is about; else nothing."""
    while error is not None:
        if type(error).__name__ in {"PackageNotFoundError", "ResourceNotFound"} and error.args:
            return str(error.args[0])
        error = error.__cause__ or error.__context__
    return ""


def _beside(path: Path, package: str) -> Path | None:
    """A folder called like a package, that the file is in or that is beside a folder it is in."""
    for folder in path.resolve().parents[:-1]:
        for place in (folder, folder / package):
            if place.name == package and place.is_dir():
                return place
    return None
