"""The head of a generated file says of which robot file it was made, as `sha256sum` calls it."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ROBOTS = sorted(path.stem for path in (ROOT / "robots").glob("*.yaml"))


@pytest.mark.parametrize("ending", [".c", ".h", ".py"])
def test_the_digest_is_that_of_the_file(ending: str) -> None:
    for name in ROBOTS:
        text = (ROOT / "robots" / f"{name}.yaml").read_bytes().replace(b"\r\n", b"\n")
        told = f"SHA-256 of the robot file: {sha256(text).hexdigest()[:16]}\n"
        assert told in (ROOT / "generated" / f"{name}{ending}").read_text("utf-8"), name
