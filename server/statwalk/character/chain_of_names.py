"""Inverse kinematics chains named by their joints: from names to rows of the skeleton (IK14)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Real

from statwalk.errors import ContentError, UnknownNameError
from statwalk.rig.skeleton import Skeleton
from statwalk.solve.chains import LONGEST_CHAIN, joints_between


def chain_joints(skeleton: Skeleton, names: Sequence[str], solver: str) -> tuple[tuple[int, ...], int]:
    """Returns the joints of a chain from its start to its end without a gap, and the index of a limb's middle
    joint.

    Two names are the start and the end, and all joints between take part; with more names, joints between
    them that are not named do not turn.

    :raises ContentError: when the names are no chain for this solver.
    :raises UnknownNameError: when the skeleton has no joint of a name.
    """
    if solver == "two-bone" and len(names) != 3:
        raise ContentError("two-bone needs three joints: start, middle, end", place="chain")
    least = 1 if solver == "look-at" else 2
    if len(names) < least or len(names) > LONGEST_CHAIN:
        raise ContentError(
            f"{solver} needs {least} to {LONGEST_CHAIN} joints, from start to end", place="chain"
        )
    rows = [skeleton.index(name) for name in names]
    for name in names:
        if name in skeleton.muscle_bones:
            raise ContentError(
                f"{name} is a muscle bone, which only deforms the skin: no chain can turn it", place="chain"
            )
    joints: tuple[int, ...] = (rows[0],)
    for above, below, name in zip(rows, rows[1:], names[1:], strict=False):
        between = joints_between(skeleton.parent, above, below)
        if len(between) < 2:
            raise ContentError(f"{name} is not below {skeleton.names[above]}", place="chain")
        joints += between[1:]
    if len(joints) > LONGEST_CHAIN:
        raise ContentError(f"{len(joints)} joints; at most {LONGEST_CHAIN}", place="chain")
    return joints, joints.index(rows[1]) if solver == "two-bone" else 1


def ends_at(skeleton: Skeleton, joints: Sequence[int], anchor: str) -> bool:
    """Returns whether an anchor is the last joint of a chain; otherwise it is the first.

    :raises ContentError: when it is neither.
    :raises UnknownNameError: when the skeleton has no such joint.
    """
    joint, first, last = skeleton.index(anchor), joints[0], joints[-1]
    if joint not in (first, last):
        ends = f"{skeleton.names[first]} or {skeleton.names[last]}"
        raise ContentError(f"{anchor} is no end of the chain; its anchor is {ends}", place="anchor")
    return joint == last


def sensitivities(
    skeleton: Skeleton,
    names: Sequence[str],
    joints: Sequence[int],
    solver: str,
    given: Mapping[str, float],
) -> tuple[float, ...]:
    """Returns the sensitivity of each joint of a chain: as given, else 1; 0 for joints that the chain passes
    over.

    :raises ContentError: when one is not 0…1, or the solver takes none.
    :raises UnknownNameError: when a joint is not in the chain.
    """
    if given and solver == "two-bone":
        raise ContentError("two-bone takes no sensitivities: both joints turn", place="sensitivity")
    known = [skeleton.names[joint] for joint in joints]
    for name, value in given.items():
        if name not in known:
            raise UnknownNameError("joint of the chain", name, known)
        if not (isinstance(value, Real) and 0 <= value <= 1):
            raise ContentError(f"the sensitivity of {name} is {value!r:.40}; it is 0…1", place="sensitivity")
    named = set(names) if len(names) > 2 else set(known)
    return tuple(given.get(name, float(name in named)) for name in known)
