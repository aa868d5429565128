"""Lines of C that are too long for a page."""

from __future__ import annotations

from dhgen.targets.c.fitting import fitted
from dhgen.targets.layout import WIDTH

FACTORS = " ".join(f"* factor{i}" for i in range(20))


def test_a_product_that_begins_with_a_star_stays_one() -> None:
    """A star more would be a multiplication, or what points to a number."""
    source = f"    x = first\n        {FACTORS};"
    broken = fitted(source)
    assert broken.split() == source.split()
    assert max(map(len, broken.split("\n"))) <= WIDTH


def test_lines_of_a_comment_begin_with_stars() -> None:
    """Also those behind its first line, and no line behind its end."""
    words = " ".join(["word"] * 30)
    broken = fitted(f"/* {words}\n * {words} */\nx = {FACTORS};").split("\n")
    end = next(i for i, line in enumerate(broken) if line.endswith("*/"))
    assert all(line.startswith(("/* word", " * word")) for line in broken[: end + 1])
    assert " ".join(broken[end + 1 :]).split() == f"x = {FACTORS};".split()


def test_lines_of_a_directive_go_on() -> None:
    """A directive ends with its line where no backslash stands, and that would not compile."""
    names = " && ".join(f"!defined({'LONG_' * 8}{i})" for i in range(4))
    for last in ("", " \\\n    more"):
        source = f"#if first && \\\n    {names}{last}\nx = {FACTORS};"
        broken = fitted(source)
        assert max(map(len, broken.split("\n"))) <= WIDTH
        whole = broken.replace(" \\\n", " ").split("\n")[0]
        assert whole.split() == source.replace(" \\\n", " ").split("\n")[0].split()


def test_a_paragraph_is_filled_anew() -> None:
    """And no other one; the end of a comment stays with its last word."""
    long = f"a {'name_' * 15} that is long"
    source = f"/* about\n *\n * {long} that go on\n * behind it. */\nint x;"
    assert fitted(source).split("\n") == [
        "/* about",
        " *",
        f" * {long} that",
        " * go on behind it. */",
        "int x;",
    ]
    exact = f"/* {'w' * 46} {'w' * 48}. */"
    assert len(exact) == WIDTH + 2
    assert fitted(exact).split("\n") == [f"/* {'w' * 46}", f" * {'w' * 48}. */"]
