"""Of an angle's two values the sign chooses by one rule: Y s - X c = e sqrt(X^2 + Y^2 - Z^2).

Khalil and Dombre's table has it so. What documents print for each form of the equation follows from
it by hand: with Z = 0 that s and c are e Y and -e X, with X = 0 that s is e sqrt(Y^2 - Z^2) / Y,
with Y = 0 that c is -e sqrt(X^2 - Z^2) / X.
"""

from __future__ import annotations

import re
from collections import Counter

from tests.derivation.stories import WITH_STEPS, document

NAME = r"(\w|\{[^{}]*\})"  # an index
RIGHT = r"(?: - [ZK]\^2)?"
ROOT = r"\\sqrt\{X\^2 \+ Y\^2" + RIGHT + r"\}"
HOLDS = {
    "combination": rf"(?:D|F|G|H|M)_{NAME} = Y s_\1 - X c_\1 = [^=]+ = \\varepsilon_\1 {ROOT}",
    "of squares": rf"W & = Y s_{NAME} - X c_\1 = \\varepsilon_\1 {ROOT} \\\\",
    "homogeneous": (
        rf"\\theta_{NAME} = \\mathrm{{atan2}}\(\\varepsilon_\1 Y, -\\varepsilon_\1 X\).*"
    ),
    "with another equation": (
        rf"\\theta_{NAME} = \\mathrm{{atan2}}\(\\varepsilon_\1 \\hat Y, -\\varepsilon_\1 \\hat X\)"
    ),
    "cosine alone": (
        rf"s_{NAME} & = \\frac\{{\\varepsilon_\1 \\sqrt\{{Y\^2 - ([ZK])\^2\}}\}}\{{Y\}} \\\\"
    ),
    "sine alone": (
        rf"c_{NAME} & = -\\frac\{{\\varepsilon_\1 \\sqrt\{{X\^2 - ([ZK])\^2\}}\}}\{{X\}} \\\\"
    ),
}
# A length has the sign of its own root; an angle found with it divides by the length.
LENGTH = r"r_\w & = (?:\\frac\{)?\\varepsilon_(\w) \\sqrt.*"
BESIDE = r"\\theta_\w & = \\mathrm\{atan2\}\(.*\)"


def signed_lines(text: str) -> list[str]:
    """The lines of a document's steps that hold a sign."""
    inverse = text.split("\n## Inverse\n")[1].split("\n## ", maxsplit=1)[0]
    blocks = re.findall(r"```math\n(.*?)\n```", inverse, re.DOTALL)
    return [line for block in blocks for line in block.split("\n") if "varepsilon" in line]


def test_every_sign_is_that_of_the_rule() -> None:
    seen: Counter[str] = Counter()
    for name in WITH_STEPS:
        text = document(name)
        is_ruled, before = False, ""
        for line in signed_lines(text):
            forms = [form for form, pattern in HOLDS.items() if re.fullmatch(pattern, line)]
            seen.update(forms)
            if not forms:
                length = re.fullmatch(LENGTH, before)
                assert re.fullmatch(LENGTH, line) or (length and re.fullmatch(BESIDE, line)), line
            before = line
            is_ruled |= bool(forms)
        assert ("chooses between the two values of an angle" in text) == is_ruled, name
    assert seen.keys() == HOLDS.keys()
