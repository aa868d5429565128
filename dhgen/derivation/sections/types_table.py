"""What the types of a derivation's steps are: their equations in general, by their numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.other_ways import other_step
from dhgen.derivation.steps import has_number_in_002, step_blocks
from dhgen.derivation.text.blocks import Table, display, joined, paragraph, say
from dhgen.derivation.text.formula import Listing, Symbol
from dhgen.derivation.text.walk import symbols_of
from dhgen.derivation.text.words import many
from dhgen.kinematics.transform import identity
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose

CAPITALS = frozenset("KPQRVWXYZ")  # those of matrices and of signed roots are others
FRAME_APART = "; the base frame, {} too, is a matrix"
_SPELLED = (
    ("\\theta", "θ"),
    ("\\", ""),
    ("-", "−"),
    ("^2", "²"),
    ("_1", "₁"),
    ("_2", "₂"),
    ("_i", "ᵢ"),
    ("_j", "ⱼ"),
)

SIGN = Symbol(r"\varepsilon_i = \pm 1", "εᵢ = ±1")
RULE = (
    ("X s_i + Y c_i = Z", "X sᵢ + Y cᵢ = Z"),
    (
        r"Y s_i - X c_i = \varepsilon_i \sqrt{X^2 + Y^2 - Z^2}",
        "Y sᵢ − X cᵢ = εᵢ √(X² + Y² − Z²)",
    ),
)
TYPE_2 = (
    Symbol(
        r"s_i = \frac{X Z + \varepsilon_i Y \sqrt{X^2 + Y^2 - Z^2}}{X^2 + Y^2}",
        "sᵢ = (X Z + εᵢ Y √(X² + Y² − Z²))/(X² + Y²)",
    ),
    Symbol(
        r"c_i = \frac{Y Z - \varepsilon_i X \sqrt{X^2 + Y^2 - Z^2}}{X^2 + Y^2}",
        "cᵢ = (Y Z − εᵢ X √(X² + Y² − Z²))/(X² + Y²)",
    ),
)
TYPE_2_BY_ANGLES = (
    Symbol(
        r"\theta_i = \varphi - \mathrm{atan2}(Z, \varepsilon_i \sqrt{X^2 + Y^2 - Z^2})",
        "θᵢ = φ − atan2(Z, εᵢ √(X² + Y² − Z²))",
    ),
    Symbol(r"\varphi = \mathrm{atan2}(Y, -X)", "φ = atan2(Y, −X)"),
)
TYPE_8 = (
    Symbol(r"c_j = \frac{Z_1^2 + Z_2^2 - X^2 - Y^2}{2 X Y}", "cⱼ = (Z₁² + Z₂² − X² − Y²)/(2 X Y)"),
    Symbol(r"s_i = \frac{B_1 Z_2 - B_2 Z_1}{B_1^2 + B_2^2}", "sᵢ = (B₁ Z₂ − B₂ Z₁)/(B₁² + B₂²)"),
    Symbol(r"c_i = \frac{B_1 Z_1 + B_2 Z_2}{B_1^2 + B_2^2}", "cᵢ = (B₁ Z₁ + B₂ Z₂)/(B₁² + B₂²)"),
    Symbol("B_1 = X + Y c_j", "B₁ = X + Y cⱼ"),
    Symbol("B_2 = Y s_j", "B₂ = Y sⱼ"),
)
TYPE_8_BY_TYPE_2 = Symbol(
    r"\theta_i = \mathrm{atan2}(B_1, B_2) - "
    r"\mathrm{atan2}(Z_1, \pm\sqrt{B_1^2 + B_2^2 - Z_1^2})",
    "θᵢ = atan2(B₁, B₂) − atan2(Z₁, ±√(B₁² + B₂² − Z₁²))",
)
TYPE_8_BY_HALF_ANGLE = Symbol(
    r"\theta_j = \pm 2\,\mathrm{atan2}(\sqrt{(X + Y)^2 - Z_1^2 - Z_2^2}, "
    r"\sqrt{Z_1^2 + Z_2^2 - (X - Y)^2})",
    "θⱼ = ±2 atan2(√((X + Y)² − Z₁² − Z₂²), √(Z₁² + Z₂² − (X − Y)²))",
)
TYPE_8_BY_TRIANGLE = (
    Symbol(r"\theta_i = \alpha \mp \beta", "θᵢ = α ∓ β"),
    Symbol(r"\alpha = \mathrm{atan2}(Z_2, Z_1)", "α = atan2(Z₂, Z₁)"),
    Symbol(
        r"\cos \beta = \frac{Z_1^2 + Z_2^2 + X^2 - Y^2}{2 X \sqrt{Z_1^2 + Z_2^2}}",
        "cos β = (Z₁² + Z₂² + X² − Y²)/(2 X √(Z₁² + Z₂²))",
    ),
)


def types_table(story: Story) -> list[Block]:
    """A line for every type of a step, or of a step that could replace one."""
    taken = {step.kind for step in story.steps}
    instead = _instead(story)
    kinds = sorted(taken | instead.keys(), key=lambda kind: kind.number)
    header = tuple(say(word) for word in ("type", "equations", "steps"))
    rows = tuple(_row(story, kind, instead.get(kind, [])) for kind in kinds)
    has_length = any("r" in each for kind in kinds for each in kind.value.equations)
    slides = [Symbol("r", "r")] if has_length else []
    length = "{} is an unknown length, " if slides else ""
    table = "document 003, which has the table" if story.cites_courses else "the table"
    text = (
        f"The types that occur here, numbered as in {table} of W. Khalil and E. Dombre (2002): "
        f"{length}{{}} and {{}} are the cosine and sine of an unknown angle, and capitals are "
        "known."
    )
    new = [str(kind.number) for kind in kinds if not kind.value.in_003]
    if new:
        text += f" {many('Type', new)} {'is' if len(new) == 1 else 'are'} not in that table."
    turned = [str(k.number) for k in (Kind.TWO_ANGLES, Kind.TWO_ANGLES_TURNED) if k in taken]
    if turned:
        text += f" An angle of type {' or '.join(turned)} may be one that is counted backwards."
    own = sorted({each.text[0] for each in symbols_of(_steps(story))} & CAPITALS)
    chain = story.algebra.chain
    frame = "Z" in own and chain.base != identity(chain.ring)
    if own:
        text += f" Each step defines {{}} anew{FRAME_APART if frame else ''}."
    if any(has_number_in_002(story, number) for number in range(1, len(story.steps) + 1)):
        text += " Document 002 counts four types in its own way; its number stands in parentheses."
    letters = *slides, Symbol("c_i", "cᵢ"), Symbol("s_i", "sᵢ")
    capitals = [joined([say("{}", Symbol(each, each)) for each in own])] if own else []
    apart = [Symbol("Z", "Z")] if frame else []
    head = paragraph(text, *letters, *capitals, *apart)
    return [head, Table(header, rows), *_rule_of_signs(story), *_in_the_course(story)]


def _rule_of_signs(story: Story) -> list[Block]:
    """Which of its two values an angle has, for all steps at once."""
    taken = {step.kind for step in story.steps}
    links = sorted((kind for kind in taken if kind.is_two_links), key=lambda kind: kind.number)
    if Kind.ANGLE not in taken and not links:
        return []
    text = (
        "The sign {} chooses between the two values of an angle, by one rule in every step: from "
        "{} follows {}."
    )
    right = "Z" if Kind.ANGLE in taken else "K"
    shown = [SIGN, *(Symbol(*(each.replace("Z", right) for each in pair)) for pair in RULE)]
    if Kind.ANGLE in taken and links:
        types = many("type", [str(kind.number) for kind in links])
        text += f" In steps of {types} {{}} takes the place of {{}}."
        shown += [Symbol("K", "K"), Symbol("Z", "Z")]
    if any(
        step.kind is Kind.ANGLE and quotes[0].facing < 0
        for step, quotes in zip(story.steps, story.quotes, strict=True)
    ):
        text += " Some equations are read with the opposite sign, so that it holds."
    return [paragraph(text, *shown)]


def _in_the_course(story: Story) -> list[Block]:
    """How the courses write solutions that look otherwise here."""
    blocks: list[Block] = []
    angle = "Document 002 has the same angle as" if story.cites_courses else "The same angle is"
    if any(step.kind is Kind.ANGLE and step.coefficient("Z") for step in story.steps):
        blocks.append(
            paragraph(
                "Khalil and Dombre write the solution of type 2 as {}, with the same sign. The "
                "steps leave out the divisor, a positive factor that both share and atan2 takes "
                f"no notice of. {angle} {{}} with {{}}.",
                Listing(TYPE_2),
                *TYPE_2_BY_ANGLES,
            )
        )
    if any(step.kind is Kind.ANGLE_AND_SUM for step in story.steps):
        blocks.append(
            paragraph(
                "Khalil and Dombre solve both angles of type 8 together: {}, then {} with {}. In "
                "it {} stands in the equation of cosines, whichever of the step's two that is, and "
                "{} and {} are the two links, as in the table; the steps' {} and {} are other "
                "coefficients. Here the second angle has a step of its own, of type 3, from the "
                "same two equations.",
                TYPE_8[0],
                Listing(TYPE_8[1:3]),
                Listing(TYPE_8[3:]),
                Symbol("Z_1", "Z₁"),
                *[Symbol("X", "X"), Symbol("Y", "Y")] * 2,
            )
        )
        blocks += _two_links_in_the_course(story)
    return blocks


def _two_links_in_the_course(story: Story) -> list[Block]:
    """How documents 002 and 000 solve the triangle of two links."""
    if not story.cites_courses:
        return []
    return [
        paragraph(
            "Document 002 takes {} from the first equation alone, of type 2, with a sign of its "
            "own: {}. Of the two values the second equation leaves one. For {} and {} positive it "
            "has",
            Symbol(r"\theta_i", "θᵢ"),
            TYPE_8_BY_TYPE_2,
            Symbol("X", "X"),
            Symbol("Y", "Y"),
        ),
        display(TYPE_8_BY_HALF_ANGLE),
        paragraph(
            "and document 000 reads the angles off the triangle of the links as well: {} with {} "
            "and {}, the upper sign for {}.",
            *TYPE_8_BY_TRIANGLE,
            Symbol(r"\theta_j > 0", "θⱼ > 0"),
        ),
    ]


def _steps(story: Story) -> list[Block]:
    numbers = range(1, len(story.steps) + 1)
    return [block for number in numbers for block in step_blocks(story, number)[0]]


def _instead(story: Story) -> dict[Kind, list[str]]:
    """The types of what could replace steps, and the numbers of these steps."""
    found: dict[Kind, list[str]] = {}
    for number in range(1, len(story.steps) + 1):
        other = other_step(story, number)
        if other is not None:
            found.setdefault(other.kind, []).append(str(number))
    return found


def _row(story: Story, kind: Kind, instead: list[str]) -> tuple[Prose, ...]:
    steps = [str(n) for n, step in enumerate(story.steps, start=1) if step.kind is kind]
    return (
        say(str(kind.number)),
        say("{}", Listing(tuple(map(_spelled, kind.value.equations)))),
        say(", ".join(steps) or f"in place of {many('step', instead)}"),
    )


def _spelled(equation: str) -> Symbol:
    """An equation's LaTeX, and how a terminal spells it."""
    text = equation
    for latex, plain in _SPELLED:
        text = text.replace(latex, plain)
    return Symbol(equation, text)
