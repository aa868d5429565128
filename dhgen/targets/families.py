"""Which local values belong together, and share a statement."""

from __future__ import annotations

import re

# Values without a name of the derivation's, entries of a matrix, and columns of frames.
_NUMBERED = re.compile(r"(?:v|angle|packed|[JTpxyz])\d+")
_COSINE_OR_SINE = re.compile(r"[cs](\d+)")
_COMPONENT = re.compile(r"(w\d+)[xyz]")


def follows(name: str, before: str) -> bool:
    """Whether a value may share another's statement: what has no name, that of an angle too."""
    family = _family(name)
    return family == _family(before) or (not family and bool(_COSINE_OR_SINE.fullmatch(before)))


def _family(name: str) -> str:
    """Branches of a value, cosine and sine, a vector ...; empty without a name of its own."""
    stem = name.partition("_")[0]
    if _NUMBERED.fullmatch(stem):
        return ""
    part = _COSINE_OR_SINE.fullmatch(stem) or _COMPONENT.fullmatch(stem)
    return part[1] if part else stem
