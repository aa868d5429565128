"""When values are known: behind what they wait for, and no later."""

from __future__ import annotations

from dhgen.program.arrival import arrivals
from dhgen.program.building.builder import Builder


def test_a_value_waits_for_the_slowest_of_its_operands() -> None:
    builder = Builder()
    square = builder.name(builder.square(builder.pose(1, 4)), "N1")
    root = builder.name(builder.apply("sqrt", square), "w1")
    quotient = builder.name(builder.div(builder.pose(1, 1), square), "c1")
    total = builder.add(root, quotient)
    known = arrivals(builder.finish("t", {"q1": total, "q2": builder.pose(1, 2)}, []))
    assert 0 < known["N1"] < known["c1"] < known["w1"] < known["q1"]
    alone = known["w1"] - known["N1"]
    assert known["q1"] > known["N1"] + alone
