"""The C of an arm in closed form stays small: what grows is read by people and by compilers."""

from __future__ import annotations

import re

from tests.robots.cases import ROBOTS

GENERATED = ROBOTS.parent / "generated"
MOST = 60_000  # bytes: what is promised for any arm


def test_c_of_closed_forms() -> None:
    sizes = {}
    for header in GENERATED.glob("*.h"):
        if re.search(r'_METHOD "closed form"', header.read_text(encoding="utf-8")):
            sizes[header.stem] = header.with_suffix(".c").stat().st_size
    assert len(sizes) > 60
    assert {name: size for name, size in sizes.items() if size > MOST} == {}
