"""Arms whose steps take the roots of a quartic for whole poses: no robot of robots/ is one."""

from __future__ import annotations

from tests.derivation.made import made_of


def test_where_its_roots_meet_is_told_but_is_no_factor() -> None:
    text = made_of(
        "theta: q, d: 0.380, a: 0.262, alpha: 0",
        "theta: q, d: 0.281, a: 0.104, alpha: 0",
        "theta: q, d: 0.115, a: 0.331, alpha: pi/2",
        "theta: q, d: 0.260, a: 0.298, alpha: pi/2",
        "theta: q, d: 0.481, a: 0.121, alpha: pi/2",
        "theta: q, d: 0.216, a: 0.286, alpha: pi/2",
    )
    assert (
        "Where two roots of the equation meet, two solutions become one, and $\\det J = 0$" in text
    )
    assert "| 1 | two roots of the equation meet | $\\det J = 0$ |" in text
    assert "in factors" not in text
