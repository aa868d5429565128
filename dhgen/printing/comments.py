"""What users wrote, in a form that is safe in comments and docstrings of any language."""

from __future__ import annotations

import re

# They end a docstring or a comment, of C or of Markdown, or are read as other characters.
_MEANING = re.compile(r'[\\"*?<>]')


def plain(text: str) -> str:
    """Free text that cannot end a comment or a docstring."""
    text = text.replace("\\", "/").replace("??/", "?? /")  # first: from *\ they would make */
    return text.replace("*/", "* /").replace("/*", "/ *").replace('"""', "'''")


def plain_path(path: str) -> str:
    """A path in one line, with _ for what has a meaning there or can't be printed."""
    shown = "".join(c if c.isprintable() or c.isspace() else "_" for c in path)
    return _MEANING.sub("_", " ".join(shown.split()))
