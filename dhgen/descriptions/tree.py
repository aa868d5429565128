"""Whether links and joints are a tree: one root, each link moved by one joint, no circle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.source import quoted

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.descriptions.model import Joint
    from dhgen.robot.source import Span


def check_tree(
    links: Sequence[str], joints: Sequence[Joint], wrong: Callable[[Span, str], None]
) -> str:
    """The root of the tree; mistakes are reported.

    Args:
        links: All names, each once.
        joints: Between links that there are.
        wrong: Takes the place of a mistake and what is wrong.
    """
    moved: dict[str, Joint] = {}
    for joint in joints:
        if joint.parent == joint.child:
            wrong(joint.place, f"the joint {quoted(joint.name)} moves the link that it is on")
        elif (other := moved.get(joint.child)) is not None:
            both = f"{quoted(other.name)} and {quoted(joint.name)}"
            message = f"two joints move the link {quoted(joint.child)}, {both}: closed chains are "
            wrong(joint.place, message + "not read, leave one of them out")
        else:
            moved[joint.child] = joint
    _refuse_circles(moved, wrong)
    children = {joint.child for joint in joints}
    parents = {joint.parent for joint in joints}
    roots = [link for link in links if link not in children and link in parents]
    if len(roots) > 1:
        first = {root: next(j for j in joints if j.parent == root) for root in roots}
        shown = ", ".join(map(quoted, roots[:4])) + (", ..." if len(roots) > 4 else "")
        message = (
            f"the links are not one tree: no joint moves {shown}, and only one may be the root"
        )
        wrong(first[roots[1]].place, message)
    return roots[0] if roots else ""


def _refuse_circles(moved: dict[str, Joint], wrong: Callable[[Span, str], None]) -> None:
    done: set[str] = set()
    for start in moved:
        path: dict[str, None] = {}
        link = start
        while link in moved and link not in done and link not in path:
            path[link] = None
            link = moved[link].parent
        if link in path:
            circle = list(path)[list(path).index(link) :]
            shown = " on ".join(map(quoted, [*circle[:4], circle[0]]))
            last = max((moved[each] for each in circle), key=lambda joint: joint.place.start)
            wrong(last.place, f"links hang on each other in a circle: {shown}")
        done.update(path)
