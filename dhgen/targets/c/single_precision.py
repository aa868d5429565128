"""C in single precision: the C of double precision, token by token.

`double` becomes `float`, a literal gets an f and the digits that a float holds, a function of
<math.h> becomes its sibling for floats. Nothing is promoted to double on the way
(-Wdouble-promotion), so that a controller whose registers hold single precision never leaves them.
Tolerances and names are not its business: they come with the program, and the runtime's names are
pasted from parts.
"""

from __future__ import annotations

import re

import numpy as np

_TOKEN = re.compile(
    r"""
      (?P<kept> DHGEN_OF\(\w+\) | /\*.*?\*/ | "(?:[^"\\\n]|\\.)*" | \#\s*include[^\n]* )
    | (?P<word> [A-Za-z_]\w* )
    | (?P<number> (?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)? | \d+[eE][+-]?\d+ )
    | (?P<other> \d+\w* | \s+ | . )
    """,
    re.DOTALL | re.VERBOSE,
)
_WORDS = {
    "double": "float",
    "HUGE_VAL": "HUGE_VALF",
    **{
        name: f"{name}f"
        for name in (
            *("acos", "asin", "atan", "atan2", "ceil", "copysign", "cos", "fabs", "floor"),
            *("fma", "fmax", "fmin", "fmod", "hypot", "sin", "sqrt", "tan"),
        )
    },
}


# What is for double precision alone, and what replaces it.
_OTHERWISE = re.compile(
    r"#ifndef DHGEN_SINGLE_PRECISION\n(?:(?!#endif).)*?#else\n(.*?)#endif\n", re.DOTALL
)


def in_single_precision(text: str) -> str:
    """C source or a header in which every real number is a float.

    Raises:
        ValueError: A literal is beyond the range of a float.
    """
    single = _OTHERWISE.sub(r"\1", text)
    return "".join(_single(match) for match in _TOKEN.finditer(single))


def _single(match: re.Match[str]) -> str:
    if match["word"]:
        return _WORDS.get(match["word"], match["word"])
    if match["number"]:
        return _literal(match["number"])
    return match[0]


def _literal(text: str) -> str:
    """The fewest digits that give the float next to this number."""
    with np.errstate(over="ignore"):
        value = np.float32(text)
    if not np.isfinite(value) or (value == 0.0) != (float(text) == 0.0):
        raise ValueError(f"{text} is beyond the range of single precision")
    return f"{value!s}f"
