"""The derivation as a document: why the solver is what it is, for people to follow by hand.

`derivation_files` writes Markdown for GitHub and its figures, `derivation_terminal` the same text
for a terminal, `derivation_summary` a dozen lines, `alternatives_text` the routes not taken.

| read             | what is in it                                                               |
|------------------|-----------------------------------------------------------------------------|
| document         | the order of the sections                                                   |
| story            | what all of them draw from: the arm, its steps, how polynomials are written |
| sections         | what is printed around the steps                                            |
| steps            | a step: its heading, its equations, and what its type's printer adds        |
| step_context     | one step on its way to paper: its letters, its sign                         |
| quotes           | the equations of a step as they are in the matrices                         |
| known_functions  | sines and cosines that a step has found, as later steps take them           |
| definitions      | letters in the order in which they become known                             |
| types            | a printer for each equation type                                            |
| conditions       | where a combination vanishes, in joint angles                               |
| effects          | what that means for the arm, and what the program does there                |
| sums_left        | of two angles about axes that are parallel there, the sum or the difference |
| example          | a pose to work through, and its rows                                        |
| whole_example    | one of an arm that is solved as a whole                                     |
| singular_example | one beside the example's, at which a condition is met                       |
| whole_turns      | those that solvers give joint values, and which rows keep their limits      |
| known_side       | a known matrix whose long entries get letters                               |
| cuspidal         | solutions that an arm can take without a singular place between             |
| values           | what a printed formula is worth in numbers                                  |
| velocity         | det J in factors, the motion that each loses, and a wrist's blocks          |
| figures          | the arm, its postures and its workspace as SVG                              |
| geometry         | how axes lie, and the arm's size                                            |
| notation         | letters, cells, polynomials and matrices as formulas                        |
| text             | formulas and documents as values, templates, and a printer for each format  |
| handouts         | the document in one file, as LaTeX and as HTML                              |
| formats          | the document as the command is asked for it                                 |
| languages        | what becomes of the finished document in a language                         |
| french           | French: a catalogue of sentences, and formulas as the courses write them    |
| summary          | what the terminal shows after a run                                         |

Prose that does not vary is Markdown in `templates/derivation`; here is what varies.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.document import document_blocks, singular_places
from dhgen.derivation.figures.all import figures_of
from dhgen.derivation.languages import ENGLISH
from dhgen.derivation.summary import alternatives_text, summary_text, task_remarks, tool_at_zero
from dhgen.derivation.text.markdown import markdown
from dhgen.derivation.text.plain import plain
from dhgen.printing.comments import plain_path
from dhgen.printing.templates import render

if TYPE_CHECKING:
    from dhgen.derivation.languages import Language
    from dhgen.derivation.story import Story


def derivation_files(story: Story, source: str, language: Language = ENGLISH) -> dict[str, str]:
    """The derivation as GitHub Markdown with formulas, and its figures, by their paths.

    Args:
        story: The arm and its derivation.
        source: How the robot file is called.
        language: That of the document and of its figures.
    """
    name, figures = story.robot.name, figures_of(story)
    blocks = map(language.block, document_blocks(story, figures))
    document = render(
        "derivation/document.md.jinja",
        name=name,
        source=plain_path(source),
        blocks=tuple(map(markdown, blocks)),
    )
    drawn = map(language.figure, figures)
    return {f"{name}.md": document} | {figure.path: figure.file(name, source) for figure in drawn}


def derivation_document(story: Story, source: str) -> str:
    """The Markdown alone."""
    return derivation_files(story, source)[f"{story.robot.name}.md"]


def derivation_terminal(story: Story, language: Language = ENGLISH) -> str:
    """The derivation as plain text, without figures."""
    first, *others = map(plain, map(language.block, document_blocks(story)))
    return render("derivation/terminal.txt.jinja", first=first, others=others)


def derivation_summary(story: Story) -> str:
    """A line for each step, the branches, the degenerate cases."""
    return summary_text(story, singular_places(story))


__all__ = [
    "alternatives_text",
    "derivation_document",
    "derivation_files",
    "derivation_summary",
    "derivation_terminal",
    "task_remarks",
    "tool_at_zero",
]
