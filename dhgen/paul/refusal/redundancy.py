"""Why an arm with more joints than its task fixes is not solved, and what the user may do."""

from __future__ import annotations

from itertools import islice
from typing import TYPE_CHECKING

from dhgen.kinematics.arm_angle import why_no_arm_angle
from dhgen.paul.mobility import (
    NEARLY_NULL,
    crowded_axes,
    determining_tasks,
    still_coordinates,
    surplus,
    tasks_of_what_moves,
)
from dhgen.paul.refusal.free_joint_advice import choices_text
from dhgen.paul.refusal.size_limits import MOST_GIVEN, are_too_many_given

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain
    from dhgen.paul.mobility import Surplus
    from dhgen.paul.refusal.free_joint_advice import Choice


def redundant(
    chain: Chain, spare: Surplus, before: tuple[Chain, Surplus], choices: tuple[Choice, ...]
) -> str:
    """Why an arm with more joints than its task fixes is not solved, and what can be done.

    Args:
        chain: The arm.
        spare: What its task leaves open.
        before: Both without the free joints that are in the way (`open_from_the_start`).
        choices: Joints that would make good free ones.
    """
    lines = why_redundant(chain, spare)
    start, whole = before
    if whole.count == len(start.solved):
        lines.append("no joint is left to solve for: `task` must name something that the arm moves")
        return "\n".join(lines)
    lines += _task_of_what_moves(chain, spare)
    ways = [_given(chain, before, choices), _other_task(chain)]
    for way in reversed(ways) if still_coordinates(chain) else ways:
        lines += way
    lines.append("--numerical would give the solution near a seed, by damped least squares")
    return "\n".join(lines)


def why_redundant(chain: Chain, spare: Surplus) -> list[str]:
    """How many solutions a pose has, with the reasons: infinitely many if it is in reach at all."""
    vain = _in_vain(still_coordinates(chain))
    why = [*vain, *crowded_axes(chain), _moved(chain, spare)]
    independent, asked = chain.dof - chain.given - spare.count, chain.task.dimension
    if independent == asked:
        first, *others = why
        return [f"the arm has infinitely many solutions for every pose: {first}", *others]
    few = "nearly no pose is in reach, and those few have infinitely many solutions"
    motions = (
        "1 independent motion is" if independent == 1 else f"{independent} independent motions are"
    )
    return [f"{few}: {motions} left, and the task asks for {asked}", *why]


def _given(chain: Chain, before: tuple[Chain, Surplus], choices: tuple[Choice, ...]) -> list[str]:
    """Which joints may be given, to solve for the others."""
    start, whole = before
    if are_too_many_given(start.given + whole.count):
        return [f"{whole.count} are too many to be given under `free`: {MOST_GIVEN} may be"]
    values = "its value" if whole.count == 1 else "their values"
    which = _which(chain, whole, kept=start.free == chain.free)
    return [
        f"list {which}, to solve for the others given {values}",
        *choices_text(choices, whole),
        *_elbow_choice(chain),
    ]


def near_redundancy(chain: Chain) -> list[str]:
    """A warning that joints nearly move without moving the tool, wherever the arm is, or nothing.

    An arm whose joints do so exactly gets none: it is refused.
    """
    spare = surplus(chain, NEARLY_NULL)
    if not spare.count or surplus(chain).count:
        return []
    nearly = f"wherever the arm is, {_moved(chain, spare)} by more than 0.01 % of their way"
    why = "a pose tells few digits of their values; are twists rounded that are right angles?"
    return [f"{nearly}: {why}"]


def _moved(chain: Chain, spare: Surplus) -> str:
    """A clause with the joints that move without moving what the task names, free ones held."""
    held = f"with {_joints(chain, chain.free)} given, " if chain.free else ""
    names = _joints(chain, spare.joints)
    if spare.count == len(spare.joints):  # none of them matters at all
        return f"{held}{names} can move without changing what the task names"
    return f"{held}{names} can move together without changing what the task names"


def _which(chain: Chain, whole: Surplus, *, kept: bool) -> str:
    """A clause with the joints to be named under `free`, besides those there or in their place."""
    one, all_of_them = whole.count == 1, whole.count == len(whole.joints)
    if kept:
        them = "it" if one else "them"
        what = them if all_of_them else "one of them" if one else f"{whole.count} of them"
        return f"{what} under `free`" + " too" * bool(chain.free)
    names = _joints(chain, whole.joints)
    what = names if all_of_them else f"{'one' if one else whole.count} of {names}"
    return f"{what} under `free` in place of {_joints(chain, chain.free)}"


def _joints(chain: Chain, numbers: tuple[int, ...]) -> str:
    return f"joint{'s' * (len(numbers) > 1)} {chain.named(numbers)}"


def _in_vain(still: tuple[str, ...]) -> list[str]:
    """A clause with the coordinates of the task that no joint moves, if there are any."""
    return [f"the task names {' and '.join(still)}, which no joint moves"] if still else []


def _other_task(chain: Chain) -> list[str]:
    """The first task that fixes every joint, if there is one."""
    return [
        f"`task: {text}` determines every joint"
        + " of poses that the arm can take" * (task.dimension > chain.dof - chain.given)
        for text, task in islice(determining_tasks(chain).items(), 1)
    ]


def _task_of_what_moves(chain: Chain, spare: Surplus) -> list[str]:
    """A task of as many numbers as there are motions, where more are asked for."""
    if chain.dof - chain.given - spare.count == chain.task.dimension or _other_task(chain):
        return []
    found = tasks_of_what_moves(chain, spare)[:1]
    return [f"`task: {task.text}` asks for what they move, and no more" for task in found]


def _elbow_choice(chain: Chain) -> list[str]:
    """The arm angle, where there is one and nothing else is given."""
    if chain.free or why_no_arm_angle(chain):
        return []
    return ["  free: arm_angle fixes the elbow's position on its circle instead"]
