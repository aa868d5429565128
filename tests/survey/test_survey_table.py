"""The report: lines, faults, totals."""

from __future__ import annotations

from dataclasses import replace

from dhgen.method import Method
from dhgen.survey.table import Answers, Line, survey_text

GOOD = Answers(
    method=Method.CLOSED_FORM,
    degree=2,
    rows=8,
    cpu=0.84,
    poses=200,
    expected=1600,
    found=1600,
    spurious=0,
    unmet=0,
    residual=3e-14,
    bound=1e-11,
    singular=450,
    answered=450,
    tried=20000,
    recalled=20000,
    faults=(),
)
PUMA = Line("puma560", "RRRRRR", "spherical wrist, ortho-parallel", GOOD)
GENERAL = Line(
    "xarm6",
    "RRRRRR",
    "general 6R",
    replace(
        GOOD,
        method=Method.GENERAL_6R,
        degree=16,
        rows=16,
        found=1599,
        recalled=19998,
        unmet=2,
        residual=2e-12,
        bound=1e-9,
        faults=("random: 1 of 8 missed, q = [0.5]",),
    ),
)
REFUSED = Line("loose", "RRR", "planar", None, "joints 1 and 2 turn about one axis")

TEXT = """\
arm      joints  structure                        method       degree  rows  CPU s  found/expected  spurious  residual  singular poses
puma560  RRRRRR  spherical wrist, ortho-parallel  closed form       2     8    0.8       1600/1600         0     1e-13         450/450
xarm6    RRRRRR  general 6R                       general 6R       16    16    0.8       1599/1600         0     1e-11         450/450
loose    RRR     planar                           not solved: joints 1 and 2 turn about one axis

xarm6: random: 1 of 8 missed, q = [0.5]

3 arms, 2 solved.
3199 of 3200 solutions found on 400 random poses, 0 spurious.
900 of 900 singular poses answered.
Own joint values found again on 39998 of 40000 random poses.
Residuals below 1e-13 (closed form), 1e-11 (general 6R) of the arm's size.
2 further solutions that the search did not find.
With faults or not solved: xarm6, loose.
"""  # noqa: E501


def test_the_report() -> None:
    assert survey_text([PUMA, GENERAL, REFUSED]) == TEXT


def test_what_is_complete() -> None:
    assert PUMA.complete
    assert not GENERAL.complete
    assert not REFUSED.complete
    for worse in (
        {"found": 1599},
        {"spurious": 1},
        {"residual": 1e-10},
        {"answered": 449},
    ):
        assert not replace(GOOD, **worse).complete
    assert replace(GOOD, unmet=3).complete
