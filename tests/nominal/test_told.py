"""What is said of the nearest arm with a structure: in the derivation, and in a terminal."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from dhgen.derivation import derivation_summary
from tests.compiling import compile_file
from tests.nominal.twins import twin

if TYPE_CHECKING:
    from pathlib import Path


def test_derivation_and_summary(tmp_path: Path) -> None:
    path = tmp_path / "twin_puma560.yaml"
    path.write_text(twin("puma560", 1e-4), encoding="utf-8")
    made = compile_file(path)
    nominal = made.module.nominal
    assert nominal is not None
    document = made.files["twin_puma560.md"]
    rows = re.findall(r"\| \$\\theta_\d\$ \| \$(\S+)\$ \| \$(\S+)\$ \| \$\S+\$ \|", document)
    told = [(float(d), float(a)) for d, a in rows]
    for found, d, a in zip(told, nominal.nearest.table.d, nominal.nearest.table.a, strict=False):
        assert abs(found[0] - d) < 1e-5
        assert abs(found[1] - a) < 1e-5
    assert told[5:] == [(0.0, 0.0)]
    length, angle = re.findall(
        r"farther apart than (\S+) m, and turned by no more than (\S+) rad", document
    )[0]
    assert abs(float(length) / nominal.nearest.deviation.length - 1.0) < 0.05
    assert abs(float(angle) / nominal.nearest.deviation.angle - 1.0) < 0.05
    summary = derivation_summary(made.story)
    assert f"closed form of an arm within {length} m and {angle} rad" in summary


def test_nothing_goes_first_where_only_plain_code_is_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "twin_puma560.yaml"
    path.write_text(twin("puma560", 1e-4) + "plain: true\n", encoding="utf-8")
    made = compile_file(path)
    assert made.module.nominal is None
    assert "nearest arm with a structure" not in made.files["twin_puma560.md"]
