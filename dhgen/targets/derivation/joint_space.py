"""What a vanishing combination means for the arm: in joint angles, and in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.chain import Turn
from dhgen.kinematics.product import product
from dhgen.targets.derivation.blocks import say
from dhgen.targets.derivation.formula import Symbol
from dhgen.targets.derivation.names import single, theta
from dhgen.targets.derivation.ring import used_places
from dhgen.targets.derivation.story import other_form

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.targets.derivation.blocks import Prose
    from dhgen.targets.derivation.step_context import StepContext

LONGEST = 3  # terms of a condition in joint angles


def joint_form(context: StepContext) -> Polynomial | None:
    """Y s - X c of a step of type 2 by joint angles: another element of the same matrices.

    The pool is searched for an equation whose side with U_0 is this combination, up to its sign
    and a constant.
    """
    algebra = context.story.algebra
    form = other_form(algebra, context.step)
    found: list[Polynomial] = []
    for equation in context.story.derivation.pool.equations:
        for sign in (1, -1):
            rest = equation.left - sign * form
            if algebra.is_constant(rest):
                value = sign * (equation.right - rest)
                if value and len(value) <= LONGEST:
                    found.append(value)
    if not found:
        return _by_square(context)
    return min(found, key=lambda value: (len(value), str(value)))


def _by_square(context: StepContext) -> Polynomial | None:
    """The sine or cosine of one joint whose square X^2 + Y^2 is on every witness."""
    from dhgen.paul.witness import build_witnesses  # noqa: PLC0415

    if context.polynomial("Z"):
        return None
    algebra = context.story.algebra
    witnesses = build_witnesses(context.story.derivation.pool)
    size = sum(witnesses.evaluate(context.polynomial(name)) ** 2 for name in "XY")
    for angle in algebra.angles:
        for name in (angle.sine, angle.cosine):
            generator = algebra.generator(name)
            if max(abs(size - witnesses.evaluate(generator) ** 2)) < 1e-9:
                return generator
    return None


def meaning_of_free(context: StepContext, joints: Polynomial | None) -> Prose:
    """What the arm looks like where an angle of type 2 with Z = 0 is free."""
    algebra = context.story.algebra
    parallel = _parallel_around(algebra, joints)
    if parallel is not None:
        first, last = parallel
        return say(
            f"axes {first} and {last} are parallel, and only {{}} together with {{}} is determined",
            theta(single(first)), theta(single(last)),
        )
    if _is_about_first_axis(context):
        return say(f"{point_name(context)} lies on axis 1, and every {{}} serves", theta(context.angle))
    return say("every {} serves", theta(context.angle))


def meaning_of_root(context: StepContext, joints: Polynomial | None) -> Prose:
    """What the arm looks like where the two values of a step meet."""
    del joints
    if _is_about_first_axis(context):
        return say(f"{point_name(context)} is as near to axis 1 as the arm's offset lets it")
    return say("the arm is at the edge of its reach")


def _is_about_first_axis(context: StepContext) -> bool:
    """Whether the equation compares x and y of a point with joint 1."""
    if context.angle != single(1):
        return False
    names = {
        str(context.story.algebra.ring.symbols[place])
        for name in "XY"
        for place in used_places(context.polynomial(name))
    }
    points = context.story.derivation.pool.points
    planes = [{"t14", "t24"}, *({p.names[0], p.names[1]} for p in points)]
    return names in planes


def point_name(context: StepContext) -> str:
    """What the point of an equation in column 4 is called."""
    names = [
        str(context.story.algebra.ring.symbols[place])
        for _, polynomial in context.step.coefficients
        for place in sorted(used_places(polynomial))
    ]
    named = any(name.startswith("w") for name in names)
    story = context.story
    if story.wrist is not None and (named or not story.derivation.pool.points):
        return "the wrist centre"
    return "the named point" if named else "the tool's origin"


def _parallel_around(algebra: Algebra, joints: Polynomial | None) -> tuple[int, int] | None:
    """The joints before and after joint k, when joints is its sine and that makes them parallel."""
    if joints is None or len(joints) != 1:
        return None
    used = used_places(joints)
    turning = [a for a in algebra.angles if used & {algebra.index[a.sine], algebra.index[a.cosine]}]
    if len(turning) != 1 or len(turning[0].terms) != 1:
        return None
    k = turning[0].terms[0][0]
    elements = [e for link in algebra.chain.links for e in algebra.lifted(link)]
    places = {e.joint: place for place, e in enumerate(elements) if isinstance(e, Turn)}
    if not {k - 1, k, k + 1} <= set(places):
        return None
    between = product(elements[places[k - 1] + 1 : places[k + 1]], algebra)
    lean = between.rotation[2][2]
    generator = algebra.generator(single(k).cosine)
    sine = algebra.generator(single(k).sine)
    flat = lean in (generator, -generator) if used == {algebra.index[single(k).sine]} else (
        lean in (sine, -sine)
    )
    return (k - 1, k + 1) if flat else None


__all__ = ["AngleSum", "Symbol", "joint_form", "meaning_of_free", "meaning_of_root", "point_name"]
