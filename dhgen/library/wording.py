"""The command's advice for Python: options as arguments of `dhgen.load`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.errors import DhgenError

_OPTION = re.compile(r"--(?:(base|tip|snap|package) ([^\s,;)]+)|(numerical|axes)\b)")
_NUMBERS = frozenset({"snap"})


def note_for_python(error: DhgenError, source: str) -> None:
    """Adds to an exception how the options that its text advises are written in Python.

    Args:
        error: Its text is that of the command.
        source: What was loaded, as Python writes it.
    """
    calls = [
        f"    dhgen.load({', '.join((source, *arguments))})"
        for line in str(error).splitlines()
        if (arguments := [_argument(*found) for found in _OPTION.findall(line)])
    ]
    if calls:
        error.add_note("\n".join(("in Python:", *dict.fromkeys(calls))))


def _argument(name: str, value: str, flag: str) -> str:
    if flag:
        return f"{flag}=True"
    if name == "package":
        package, _, folder = value.partition("=")
        return f"package={{{package!r}: {folder!r}}}"
    return f"{name}={value if name in _NUMBERS else repr(value)}"
