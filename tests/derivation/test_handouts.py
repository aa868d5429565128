"""Handouts: LaTeX and HTML say what the Markdown says, and are what they should be as rendered."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections import Counter
from html import escape, unescape
from html.parser import HTMLParser
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET

import pytest

from dhgen.derivation.formats import derivation_as
from dhgen.derivation.french.language import French
from dhgen.derivation.handouts import derivation_html, derivation_latex
from dhgen.derivation.languages import ENGLISH
from dhgen.derivation.text.latex_text import latex_text
from dhgen.robot.load import load_text
from tests.derivation.stories import document, story, story_of
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.derivation.languages import Language
    from dhgen.derivation.story import Story

# A slide, a wrist, an offset wrist, seven joints, coupled drives, a quartic, a task of directions.
KINDS = [
    "scara",
    "kuka_kr6_r900",
    "xarm6",
    "franka_panda",
    "kuka_kr40pa",
    "concurrent_345",
    "general_5r_pointing",
]
TITLE = r"""50% & <b>_x^2~ \alpha {#} "quoted" 'it' -- Łódź ± Ж 机"""
HOSTILE = f"""
name: hostile
title: {json.dumps(TITLE)}
convention: standard
task: [x, y]
parameters: {{a_b: 0.5, elbow: 0.3}}
joints:
  - {{theta: q, a: a_b}}
  - {{theta: q, a: elbow}}
"""
ENGINES = {name for name in ("pdflatex", "xelatex") if shutil.which(name)}
BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
VOID = {"meta", "img", "br"}


def handout(name: str, wished: str, language: Language = ENGLISH) -> str:
    return handout_of(story(name), wished, name, language)


def handout_of(that: Story, wished: str, name: str = "x", language: Language = ENGLISH) -> str:
    text, beside = derivation_as(wished, that, name, language)
    assert not beside
    return text


def lines_of(displays: list[str]) -> list[str]:
    bare = re.sub(r"\\(?:begin|end)\{aligned\}\n?", "", "\\\\\n".join(displays))
    return [" ".join(line.replace("&", " ").split()) for line in bare.split("\\\\\n")]


@pytest.mark.parametrize("name", first_of(KINDS, count=3))
def test_latex_has_the_formulas_of_the_markdown(name: str) -> None:
    markdown, latex = document(name), handout(name, "latex")
    expected = re.findall(r"```math\n(.*?)\n```", markdown, re.DOTALL)
    found = re.findall(r"^\\formulas\{%\n(.*?)\}$", latex, re.DOTALL | re.MULTILINE)
    assert expected
    assert lines_of(found) == lines_of(expected)
    prose = re.sub(r"```.*?```", "", markdown, flags=re.DOTALL)
    inline = Counter(re.findall(r"\$`(.+?)`\$", prose) + re.findall(r"\$([^`$\n]+)\$", prose))
    assert inline
    assert not inline - Counter(re.findall(r"\$([^$\n]+)\$", latex))


@pytest.mark.parametrize("name", first_of(KINDS, count=3))
def test_html_has_the_words_of_the_markdown(name: str) -> None:
    markdown, html = document(name), handout(name, "html")
    left_out = re.compile(
        r"\A.*?(?=^# )|```math.*?```|```text|!\[.*?\]\(.*?\)|</?(?:details|summary)>",
        re.DOTALL | re.MULTILINE,
    )
    said = left_out.sub("", markdown)
    said = re.sub(r"\$`.+?`\$|\$[^`$\n]+\$", " FORMULA ", said)
    body = re.sub(r"\A.*?<h1>", "", html, flags=re.DOTALL)
    shown = re.sub(r'<math display="block">.*?</math>', " ", body, flags=re.DOTALL)
    shown = unescape(re.sub(r"<[^>]+>", " ", re.sub(r"<math>.*?</math>", " FORMULA ", shown)))
    words = re.compile(r"[^\W_]+")
    assert words.findall(shown) == words.findall(said)


class Tags(HTMLParser):
    """Tags that are closed in order, and what is loaded."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.loaded: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in VOID:
            self.open.append(tag)
        self.loaded += [value or "" for key, value in attrs if key in {"src", "href", "srcset"}]

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Of MathML: closed as it is opened."""

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("name", first_of(KINDS, count=3))
def test_html_is_whole_and_needs_no_other_file(name: str) -> None:
    html = handout(name, "html")
    tags = Tags()
    tags.feed(html)
    assert tags.open == []
    assert tags.loaded
    assert all(each.startswith("data:image/svg+xml;base64,") for each in tags.loaded)
    assert "@import" not in html
    assert "url(" not in html
    for formula in re.findall(r"<math.*?</math>", html, re.DOTALL):
        assert len(ET.fromstring(formula))  # noqa: S314  our own


def test_the_same_handout_every_time() -> None:
    for wished in ("latex", "html"):
        again = story_of(story("scara").robot)
        assert handout_of(again, wished, "scara") == handout("scara", wished)


def test_what_users_write_stays_what_it_is() -> None:
    that = story_of(load_text(HOSTILE, "hostile.yaml"))
    html = derivation_html(that, "a -- b.yaml")
    written = that.robot.title
    assert unescape(re.findall(r"<h1>(.*?)</h1>", html)[0]) == f"{written}: inverse kinematics"
    comment = re.findall(r"<!--(.*?)-->", html)[0]
    assert "--" not in comment
    latex = derivation_latex(that, "a.yaml")
    assert r"50\% \& \textless{}b\textgreater{}\_x\textasciicircum{}2" in latex
    assert r"\other{Ж} \other{机}" in latex


def test_letters_that_fonts_lack_are_told_to_latex() -> None:
    assert latex_text("é ł −θ₁ --") == r"é ł $-$$\theta$$_1$ -{}-"


def compiled(engine: str, text: str, folder: Path) -> str:
    """What a LaTeX says of a document."""
    (folder / "handout.tex").write_text(text, encoding="utf-8")
    command = [engine, "-interaction=nonstopmode", "-halt-on-error", "handout.tex"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    return (folder / "handout.log").read_text(encoding="utf-8", errors="replace")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "engine"),
    [
        *first_of(((name, "pdflatex") for name in ["hostile", *KINDS]), count=7),
        *first_of((name, "xelatex") for name in ["hostile", "kuka_kr6_r900"]),  # for its fonts
    ],
)
def test_latex_compiles_without_a_warning(name: str, engine: str, tmp_path: Path) -> None:
    if engine not in ENGINES:
        pytest.skip(f"no {engine}")
    that = story(name) if name != "hostile" else story_of(load_text(HOSTILE, "hostile.yaml"))
    missing = warned(compiled(engine, handout_of(that, "latex"), tmp_path))
    if name == "hostile":  # Latin Modern has no Chinese letters
        missing = [each for each in missing if "机" not in each and "Ж" not in each]
    assert missing == []


@pytest.mark.slow
@pytest.mark.parametrize("name", ["arm_6r", "ur5"])
def test_what_a_paragraph_announces_stands_on_its_page(name: str, tmp_path: Path) -> None:
    if "pdflatex" not in ENGINES or shutil.which("pdftotext") is None:
        pytest.skip("no pdflatex, or no pdftotext")
    compiled("pdflatex", handout(name, "latex"), tmp_path)
    done = subprocess.run(
        ["pdftotext", "-layout", "handout.pdf", "-"],  # noqa: S607
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    *pages, _, _ = done.stdout.split("\f")
    assert len(pages) > 5
    for page in pages:
        last = page.split()[-2]  # the number of the page is behind it
        assert last[-1] != ":"
        assert last not in {"with", "are", "is", "at"}


@pytest.mark.slow
@pytest.mark.parametrize("engine", ["pdflatex", "xelatex"])
def test_french_latex_compiles_without_a_warning(engine: str, tmp_path: Path) -> None:
    """With the packages for French where there are any: points, colons and figures among them."""
    if engine not in ENGINES:
        pytest.skip(f"no {engine}")
    assert warned(compiled(engine, handout("scara", "latex", French()), tmp_path)) == []


def warned(log: str) -> list[str]:
    """Letters that a LaTeX misses; it warns of nothing else."""
    told = re.findall(r"^(?:Overfull|Underfull \\vbox|LaTeX Warning|Package).*", log, re.MULTILINE)
    assert [each for each in told if "Warning" in each or "Overfull" in each] == []
    return re.findall(r"Missing character.*", log)


# How many formulas, tables and trees each document has, and how many of them, or of the document,
# are wider than their room.
MEASURE = """<script>
function measured(frame) {
    const root = frame.contentDocument.documentElement;
    const all = [root, ...root.querySelectorAll(".wide")];
    return [all.length, all.filter(each => each.scrollWidth > each.clientWidth + 1).length];
}
window.onload = () => {
    const frames = [...document.querySelectorAll("iframe")];
    document.body.replaceChildren(frames.map(each => [each.title, ...measured(each)]).join(";"));
};
</script>"""


@pytest.mark.slow
@pytest.mark.skipif(BROWSER is None, reason="no chromium")
def test_html_fits_the_window(tmp_path: Path) -> None:
    """Neither the page nor a formula, table or tree in it is wider than its room."""
    frames = [
        f'<iframe title="{name} {language.code} {width}" width="{width}" height="900" '
        f'srcdoc="{escape(handout(name, "html", language))}"></iframe>'
        for name in KINDS
        for language in (ENGLISH, French())
        for width in (946, 700)
    ]
    page = tmp_path / "handouts.html"
    # Without its encoding the browser guesses that from what of the file it has read by then.
    head = '<meta charset="utf-8">'
    page.write_text(f"{head}<body>{MEASURE}{''.join(frames)}</body>", encoding="utf-8")
    assert BROWSER is not None
    options = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"]
    options += [f"--user-data-dir={tmp_path}/own", "--dump-dom", page.as_uri()]
    done = subprocess.run([BROWSER, *options], capture_output=True, text=True, check=True)
    found = re.search(r"<body>(.*?)</body>", done.stdout, re.DOTALL)
    assert found is not None, done.stderr[-1000:]
    documents = [each.split(",") for each in found[1].split(";")]
    assert len(documents) == len(frames)
    assert all(int(count) > 5 for _, count, _ in documents)
    assert [title for title, _, wide in documents if wide != "0"] == []
