"""Which joints of a description are the arm's: from a base link to a tip link."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.descriptions.model import Motion
from dhgen.errors import Diagnostic, RobotFileError, refused
from dhgen.robot.arithmetic import nearest
from dhgen.robot.source import quoted

if TYPE_CHECKING:
    from dhgen.descriptions.model import Description, Joint

# Parts of the names of links and joints that are a hand's: an arm ends before them.
_HAND = re.compile(
    r"finger|gripper|knuckle|hand|jaw|claw|thumb|suction|vacuum|robotiq|(^|_)(pad|tip)s?(_|$)",
    re.IGNORECASE,
)
_FINGER = re.compile(r"finger|knuckle|jaw|thumb|(^|_)(pad|tip)s?(_|$)", re.IGNORECASE)
# Frames that are fixed to an arm's last moving link and mean its end, the best first.
_ENDS = (
    re.compile(r"(^|_)tool0$", re.IGNORECASE),
    re.compile(r"flange", re.IGNORECASE),
    re.compile(r"(^|_)(ee|eef|tcp)(_|$)|end_?effector", re.IGNORECASE),
    re.compile(r"link_?\d+$", re.IGNORECASE),
)
_WHEELS = re.compile(r"wheel|caster", re.IGNORECASE)
MAX_JOINTS = 64  # as many as a robot file holds


@dataclass(frozen=True, slots=True)
class ArmChain:
    """The joints of an arm.

    Attributes:
        base: The link that poses are in.
        tip: The link that poses are of.
        joints: From base to tip, fixed ones too.
        notes: What was chosen, and what was left out.
        driven_end: The last link that a drive of its own moves, where the tip is moved on from
            there by joints that follow others; else empty.
    """

    base: str
    tip: str
    joints: tuple[Joint, ...]
    notes: tuple[str, ...] = ()
    driven_end: str = ""

    @property
    def actuated(self) -> tuple[Joint, ...]:
        """The joints that a variable of their own moves."""
        return tuple(joint for joint in self.joints if joint.is_driven)


def choose_chain(description: Description, base: str | None, tip: str | None) -> ArmChain:
    """The chain from one link to another: the named ones, else the longest arm's.

    Args:
        description: The robot.
        base: The base link, or None for the parent of the first joint that moves.
        tip: The tip link, or None for the end of the longest arm.

    Raises:
        RobotFileError: No such link, no such chain, or several that are as long.
    """
    for option, link in (("--base", base), ("--tip", tip)):
        if link is not None and link != description.root and link not in description.joints:
            hint = nearest(link, (description.root, *description.joints))
            message = f"{option}: there is no link {quoted(link)}{hint}"
            raise refused(description.source.file, message)
    end = tip if tip is not None else _longest(description, base)
    joints = description.joints_to(end)
    if base is not None:
        joints = _from_base(description, joints, base, end)
    elif joints:
        joints = _from_first_moving(joints)
    passive: tuple[Joint, ...] = ()
    if tip is None:
        fixed = _fixed_end(description, end)
        passive = () if fixed else _passive_end(description, joints)
        if passive:
            fixed = _fixed_end(description, passive[-1].child)
        joints = (*joints, *passive, *fixed)
    chain = ArmChain(
        joints[0].parent if joints else end, joints[-1].child if joints else end, joints
    )
    _refuse_unfit(description, chain)
    notes = [*_passive_notes(passive, end), *_notes(description, chain)]
    return replace(chain, notes=tuple(notes), driven_end=end if passive else "")


def _is_hand(joint: Joint, children: dict[str, list[Joint]]) -> bool:
    """Whether a joint moves or holds a hand, by the names of the joint and of the link.

    A wrist may move a link that is called after the gripper on it: that carries more.
    """
    if _HAND.search(joint.name):
        return True
    if not _HAND.search(joint.child):
        return False
    carries = joint.child in children and not _FINGER.search(joint.child)
    return not (joint.motion.is_actuated and carries)


def _moves_arm(joint: Joint) -> bool:
    """Whether a joint counts for how long an arm is."""
    return joint.is_driven and not _WHEELS.search(joint.name)


def _longest(description: Description, base: str | None) -> str:
    """The last moving link of the longest arm; a hand ends an arm."""
    counts: dict[str, int] = {description.root: 0}
    children = description.children()
    waiting = [description.root]
    ends: dict[str, int] = {}
    while waiting:
        link = waiting.pop()
        for joint in children.get(link, ()):
            if _is_hand(joint, children):
                continue
            free = joint.motion.is_loose or joint.child == base
            counts[joint.child] = 0 if free else counts[link] + _moves_arm(joint)
            if _moves_arm(joint) and not free:
                ends[joint.child] = counts[joint.child]
            waiting.append(joint.child)
    if base is not None:
        ends = {end: n for end, n in ends.items() if _is_on_the_way(description, base, end)}
    if not ends:
        where = f" beyond {quoted(base)}" if base is not None else ""
        message = f"no joint{where} moves an arm: name its end with --tip LINK"
        raise refused(description.source.file, message)
    most = max(ends.values())
    best = sorted(end for end, count in ends.items() if count == most)
    if len(best) > 1:
        raise refused(description.source.file, _tie(description, best, most))
    return best[0]


def _tie(description: Description, best: list[str], most: int) -> str:
    ways = [_from_first_moving(description.joints_to(end)) for end in best[:6]]
    bases = [
        next((joint.child for joint in reversed(way) if joint.motion.is_loose), way[0].parent)
        for way in ways
    ]
    command = f"dhgen import {description.source.file}"
    shown = [
        f"{command} --base {base} --tip {end}" for base, end in zip(bases, best[:6], strict=True)
    ]
    more = [f"and {len(best) - 6} more"] if len(best) > 6 else []
    listed = "\n".join(f"    {line}" for line in (*shown, *more))
    return (
        f"{len(best)} chains have {most} moving joints, and nothing says which is meant:\n{listed}"
    )


def _is_on_the_way(description: Description, base: str, end: str) -> bool:
    return any(joint.parent == base for joint in description.joints_to(end))


def _from_base(
    description: Description, joints: tuple[Joint, ...], base: str, end: str
) -> tuple[Joint, ...]:
    for place, joint in enumerate(joints):
        if joint.parent == base:
            return joints[place:]
    if _is_on_the_way(description, end, base):
        order = f"{quoted(base)} is behind {quoted(end)}, not before it"
        raise refused(description.source.file, f"{order}: exchange --base and --tip")
    way = (description.root, *(joint.child for joint in joints))
    shown = ", ".join(map(quoted, way[:12])) + (", ..." if len(way) > 12 else "")
    message = f"{quoted(base)} is not on the way to {quoted(end)}, which is {shown}"
    raise refused(description.source.file, message)


def _from_first_moving(joints: tuple[Joint, ...]) -> tuple[Joint, ...]:
    """The chain without what is before the first joint that moves, or before a base that drives.

    Behind a joint of the arm nothing drives a base: what is there is between base and tip.
    """
    start = 0
    for place, joint in enumerate(joints):
        if _moves_arm(joint):
            break
        if joint.motion.is_loose:
            start = place + 1
    while start < len(joints) and not joints[start].motion.is_actuated:
        start += 1
    return joints[start:]


def _fixed_end(description: Description, link: str) -> tuple[Joint, ...]:
    """The fixed joints from the last moving link to the frame that means the arm's end, if any."""
    children = description.children()
    ways: list[tuple[Joint, ...]] = []
    waiting: list[tuple[str, tuple[Joint, ...]]] = [(link, ())]
    while waiting:
        at, way = waiting.pop()
        for joint in children.get(at, ()):
            if joint.motion is Motion.FIXED and not _is_hand(joint, children):
                ways.append((*way, joint))
                waiting.append((joint.child, ways[-1]))
    ways.sort(key=lambda way: (len(way), way[-1].child))
    for pattern in _ENDS:
        for way in ways:
            if pattern.search(way[-1].child):
                return way
    return ()


def _passive_end(description: Description, joints: tuple[Joint, ...]) -> tuple[Joint, ...]:
    """The joints behind the last drive that joints of the arm move, as rods keep a tool level.

    None where several ways go on: which of them carries the tool is not known.
    """
    children = description.children()
    own = {joint.name for joint in joints}
    ways: list[tuple[Joint, ...]] = []
    waiting: list[tuple[Joint, ...]] = [()]
    while waiting:
        way = waiting.pop()
        names = own.union(joint.name for joint in way)
        for joint in children.get((way or joints)[-1].child, ()):
            follows = joint.mimics is not None and joint.mimics.joint in names
            if (follows or joint.motion is Motion.FIXED) and not _is_hand(joint, children):
                waiting.append((*way, joint))
                ways += [waiting[-1]] * follows
    farthest = max(ways, key=len, default=())
    return farthest if all(way == farthest[: len(way)] for way in ways) else ()


def _refuse_unfit(description: Description, chain: ArmChain) -> None:
    """Stops where the chain holds what no serial arm has."""
    mistakes: list[Diagnostic] = []
    for joint in chain.joints:
        if joint.motion.is_loose:
            message = f"a {joint.motion.value} joint is between base and tip, {joint.name}: start "
            message += f"behind it, --base {joint.child}"
            mistakes.append(description.source.point(joint.place, message))
    if mistakes:
        raise RobotFileError(tuple(mistakes))
    if not chain.actuated:
        between = f"between {quoted(chain.base)} and {quoted(chain.tip)}"
        raise refused(description.source.file, f"nothing moves {between}")
    if len(chain.actuated) > MAX_JOINTS:
        message = f"{len(chain.actuated)} joints: at most {MAX_JOINTS} are read"
        raise refused(description.source.file, message)


def _passive_notes(passive: tuple[Joint, ...], end: str) -> list[str]:
    """Notes on joints behind the last drive that move the tip."""
    followed = [f"{each.name} follows {each.mimics.joint}" for each in passive if each.mimics]
    movers = " and ".join(followed)
    return [f"the tip is moved by the arm, too: {movers} (--tip {end} ends before)"] * bool(passive)


def _notes(description: Description, chain: ArmChain) -> list[str]:
    inside = {joint.child for joint in chain.joints}
    children = description.children()
    links = [chain.base, *(joint.child for joint in chain.joints)]
    sides = [
        joint for link in links for joint in children.get(link, ()) if joint.child not in inside
    ]
    notes = [
        f"left out: the {joint.motion.value} joint {joint.name}, before the arm's base"
        for joint in description.joints_to(chain.base)
        if joint.motion.is_loose
    ]
    notes += _closure_notes(description, chain)
    moving = [joint for joint in sides if _count(children, joint)]
    for joint in moving[:6]:
        moved = _count(children, joint)
        joints = "1 joint" if moved == 1 else f"{moved} joints"
        left_out = f"left out: {joint.child} on {joint.parent}"
        follows = joint.mimics and joint.mimics.joint
        if moved == 1 and follows in {each.name for each in chain.joints}:
            may_be_held = joint.mimics is not None and abs(joint.mimics.multiplier) == 1.0
            how = f" (--tip {joint.child} takes it)" if may_be_held else ""
            notes.append(f"{left_out}, which follows {follows}{how}")
        else:
            notes.append(f"{left_out}, with {joints} of its own{_tips(chain, children, joint)}")
    still = [joint.child for joint in sides if not _count(children, joint)]
    if still:
        shown = ", ".join(still[:6]) + (", ..." if len(still) > 6 else "")
        notes.append(f"frames beside the arm: {shown} (dhgen import --tip takes one)")
    return notes


def _closure_notes(description: Description, chain: ArmChain) -> list[str]:
    """Notes on closed chains that joints of the arm are in: poses are computed without them."""
    notes = []
    for first, second in description.closures:
        ways = (set(description.joints_to(link)) for link in (first, second))
        around = set.symmetric_difference(*ways)
        if caught := [joint.name for joint in chain.actuated if joint in around]:
            held = f"what holds {first} and {second} together"
            notes.append(f"left out: {held}, a closed chain with {', '.join(caught)} in it")
    return notes


def _tips(chain: ArmChain, children: dict[str, list[Joint]], hand: Joint) -> str:
    """The frames of a hand that are fixed to the arm's last link, as a note goes on with them."""
    last = max(place for place, joint in enumerate(chain.joints) if joint.motion.is_actuated)
    if hand.motion is not Motion.FIXED or hand.parent not in {
        joint.child for joint in chain.joints[last:]
    }:
        return ""
    frames, place = [hand.child], 0
    while place < len(frames):
        fixed = (j for j in children.get(frames[place], ()) if j.motion is Motion.FIXED)
        frames += (joint.child for joint in fixed)
        place += 1
    shown = ", ".join(frames[:6]) + (", ..." if len(frames) > 6 else "")
    return f"; fixed to the arm: {shown} (dhgen import --tip takes {'one' if frames[1:] else 'it'})"


def _count(children: dict[str, list[Joint]], first: Joint) -> int:
    """How many joints move what hangs on one."""
    count, waiting = 0, [first]
    while waiting:
        joint = waiting.pop()
        count += joint.motion.is_actuated
        waiting += children.get(joint.child, ())
    return count
