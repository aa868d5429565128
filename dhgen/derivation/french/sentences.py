"""English text into French, by the catalogue: sentence by sentence, and holes in turn."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING

from dhgen.derivation.french.catalogue import HOLE, MARK, NUMBERS, catalogue, spaced

if TYPE_CHECKING:
    from dhgen.derivation.french.catalogue import Pair

_NUMBERED = re.compile(r"(\d+(?:\.\d+)*\. )(.+)", re.DOTALL)
# Not behind the initial of a name.
_SENTENCES = re.compile(rf"(?<=[.!?])(?<![ (-][A-Z]\.) (?=[A-Z0-9\"`{MARK[1:-1]}])")
_CLAUSES = re.compile("; ")
_WORDS = re.compile(r"[A-Za-z]{2}")
_POINT = re.compile(r"(?<=\d)\.(?=\d)")
_ITEMS = {"s": re.compile("(, | and )"), "q": re.compile(rf"(, | and )(?={MARK})")}
_SMALL = {" and ": " et ", " or ": " ou ", ", ": ", "}
_EDGE = "\x01"  # where words begin that filled a hole: what is before them may have to be joined
_JOINED = (
    (re.compile(f"\\b([Dd])e {_EDGE}le "), r"\1u "),
    (re.compile(f"\\b([Dd])e {_EDGE}les "), r"\1es "),
    (re.compile(f"\\bà {_EDGE}le "), "au "),
    (re.compile(f"\\bà {_EDGE}les "), "aux "),
    (re.compile(f"\\b([DdLl]|[Qq]u)e {_EDGE}(?=[aeiouyéèêàâîô])"), r"\1’"),
)


@lru_cache(maxsize=4096)
def french(text: str) -> str | None:
    """English words in French; None where the catalogue has no pair for them.

    Args:
        text: One or more sentences, or a phrase; a mark for every formula.
    """
    if not _WORDS.search(text):
        return spaced(_POINT.sub(",", re.sub(r"(?<=\S):$", " :", text)))
    if numbered := _NUMBERED.fullmatch(text):
        rest = french(numbered[2])
        return None if rest is None else numbered[1] + rest
    for pair in catalogue():
        if pair.may_be(text) and (found := pair.pattern.fullmatch(text)):
            written = filled(pair, found)
            if written is not None:
                return written
    in_parts = _in_parts(text, _SENTENCES, " ") or _in_parts(text, _CLAUSES, "\u00a0; ")
    if in_parts is None and text.endswith(".") and (phrase := french(text[:-1])) is not None:
        return f"{phrase}."
    return in_parts or _listed(text, _ITEMS["s"])


def sentences(text: str) -> list[str]:
    """A text in its sentences."""
    return _SENTENCES.split(text)


def _in_parts(text: str, between: re.Pattern[str], joint: str) -> str | None:
    parts = between.split(text)
    if len(parts) == 1:
        return None
    written = [french(part) for part in parts]
    return None if None in written else joint.join(filter(None, written))


def _listed(text: str, between: re.Pattern[str]) -> str | None:
    """Phrases one after the other: a, b and c."""
    items = between.split(text)
    written = [french(item) for item in items[::2]] if items[1:] else [None]
    if None in written:
        return None
    words = (_SMALL[word] for word in [*items[1::2], ", "])
    pairs = zip(filter(None, written), words, strict=True)
    return "".join(part for pair in pairs for part in pair).removesuffix(", ")


def filled(pair: Pair, found: re.Match[str]) -> str | None:
    """The French of a pair with what an English text has in its holes; None where one has none."""
    parts = HOLE.split(pair.french)
    written = parts[0]
    for hole, gender, after in zip(parts[1::3], parts[2::3], parts[3::3], strict=True):
        inside = _hole(hole[0], found[hole], is_feminine=gender == "f")
        if inside is None:
            return None
        written += (_EDGE + inside if hole[0] == "p" else inside) + after
    for before, joined in _JOINED:
        written = before.sub(joined, written)
    return written.replace(_EDGE, "")


def _hole(kind: str, text: str, *, is_feminine: bool) -> str | None:
    """What fills a hole in French."""
    match kind:
        case "f" | "l":
            return re.sub(" and | or ", lambda word: _SMALL[word[0]], text)
        case "n":
            return text.replace(".", ",").replace("-", "−")
        case "w":
            return NUMBERS.get(text, text) + ("e" if is_feminine and text in {"one", "no"} else "")
        case "p":
            return french(text)
        case "s" | "q":
            return french(text) or _listed(text, _ITEMS[kind])
        case _:
            return text
