"""Runs the twelve rules over all bones until no rule finds anything more (FAQ Q26; IK1 to IK12)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import vector
from statwalk.maths.arrays import Floats
from statwalk.maths.formula.assignments import Assignment
from statwalk.solve import rules
from statwalk.solve.bone_expressions import assign, check_expressions
from statwalk.solve.bone_values import DEFAULT, BoneValue, BoneValues
from statwalk.solve.due_bones import DueBones

TOLERANCE = 1e-4
"""how far apart two values may be that should be one, as a part of the longest length"""


class _Rule(NamedTuple):
    number: int
    finds: str
    """the unknown; with a P in front the parent's"""
    needs: tuple[str, ...]
    function: Callable[..., Floats | rules.JointPoint]


RULES = (
    _Rule(1, "SP", ("PEP", "PRM", "TR"), rules.start_from_parent),
    _Rule(2, "TR", ("PRM", "SP", "PEP"), rules.own_translation),
    _Rule(3, "PEP", ("SP", "PRM", "TR"), rules.parent_end_from_start),
    _Rule(4, "RM", ("PRM", "RA"), rules.matrix_from_angles),
    _Rule(5, "RA", ("PRM", "RM"), rules.angles_from_matrix),
    _Rule(6, "PRM", ("RM", "RA"), rules.parent_matrix_from_angles),
    _Rule(7, "EP", ("SP", "RM", "DIR", "LEN"), rules.end_from_start),
    _Rule(8, "RM", ("PRM", "DIR", "SP", "EP"), lambda prm, d, sp, ep: rules.find_matrix(prm, d, ep - sp)),
    _Rule(9, "SP", ("EP", "RM", "DIR", "LEN"), rules.start_from_end),
    _Rule(
        10, "EP", ("SP", "LEN", "path"),
        lambda sp, length, path: rules.end_along_path(sp, length, path[..., 1, :] - path[..., 0, :]),
    ),
    _Rule(
        11, "PEP", ("PSP", "PLEN", "path"),
        lambda psp, plen, path: rules.joint_on_path(
            psp, plen, path[..., 0, :], path[..., 1, :] - path[..., 0, :]
        ),
    ),
    _Rule(12, "PEP", ("PSP", "PLEN", "EP", "LEN", "bend"), rules.joint_between),
)  # fmt: skip
_CHECKS = (*RULES[:1], RULES[3], RULES[6], RULES[9])
"""equations that must hold between known values: the other rules are the same equations, turned round"""


def propagate(
    state: BoneValues, expressions: Sequence[Assignment] = (), tolerance: float = TOLERANCE
) -> dict[str, BoneValue]:
    """Adds to `state` everything that the rules and the expressions find; returns the values of the free
    variables that expressions set.

    :raises ContentError: when known values contradict each other; `place` names bone and quantity.
    """
    variables: dict[str, BoneValue] = {}
    slack = tolerance * _size(state)
    order, due = range(len(state.bones.names)), DueBones(state, variables, expressions)
    progress = True
    while progress:
        progress = False
        for assignment in due.take_expressions():
            progress |= assign(state, variables, assignment)
        for bone in order:
            if bone in due.bones:
                due.bones.remove(bone)
                for rule in RULES:
                    progress |= _apply(state, bone, rule, slack)
                due.note_changes()
        progress = progress or _assume(state)
        due.note_changes()
        order = order[::-1]  # what is known of children comes to their parents in one round, too
    _check(state, slack)
    check_expressions(state, variables, expressions, tolerance)
    return variables


def _assume(state: BoneValues) -> bool:
    """Lets the first bone that has no direction and no known turn turn with its parent (RA 0)."""
    for bone in range(len(state.bones.names)):
        is_open = (bone, "RM") not in state.values and (bone, "RA") not in state.values
        direction = state.get(bone, "DIR")
        is_point = direction is None or not np.any(direction)
        if is_open and is_point and state.get(bone, "PRM") is not None:
            state.put(bone, "RA", np.zeros(3), DEFAULT)
            return True
    return False


def _size(state: BoneValues) -> float:
    lengths = [known.value for (_, name), known in state.values.items() if name == "LEN"]
    return max((float(np.max(length)) for length in lengths), default=0.0) or 1.0


def _apply(state: BoneValues, bone: int, rule: _Rule, slack: float) -> bool:
    """Runs a rule for a bone if its left side is unknown and its right side known; returns whether it ran."""
    if state.get(bone, rule.finds) is not None:
        return False
    if rule.finds.startswith("P") and state.bones.parent[bone] < 0:
        return False
    values = _right_side(state, bone, rule)
    if values is None:
        return False
    value = rule.function(*values)
    if isinstance(value, rules.JointPoint):
        if np.any(value.miss > slack):
            raise _out_of_reach(state, bone, rule, float(np.max(value.miss)))
        value = value.point
    state.put(bone, rule.finds, value, f"rule {rule.number}")
    return True


def _right_side(state: BoneValues, bone: int, rule: _Rule) -> list[Floats] | None:
    """The values that a rule needs; None: one is unknown, or the rule does not apply."""
    offset = state.get(bone, "TR")
    is_attached = offset is not None and not np.any(offset)
    if rule.number in (11, 12) and not is_attached:
        return None
    values = [state.get(bone, name) for name in rule.needs]
    if rule.number in (1, 3) and is_attached:  # no translation to turn: the parent's matrix has no say
        values[rule.needs.index("PRM")] = np.eye(3)
    known = [value for value in values if value is not None]
    if len(known) < len(values):
        return None
    if rule.number == 8 and not _can_aim(*known[1:]):
        return None
    return known


def _can_aim(direction: Floats, start: Floats, end: Floats) -> bool:
    """Whether a bone has a direction at rest, and a length in every frame."""
    return bool(np.all(vector.length(direction) > 0) and np.all(vector.length(end - start) > 0))


def _out_of_reach(state: BoneValues, bone: int, rule: _Rule, miss: float) -> ContentError:
    name, parent = state.bones.names[bone], state.bones.names[state.bones.parent[bone]]
    what = "the path" if rule.number == 11 else "the sphere of LEN about EP"
    return ContentError(
        f"rule {rule.number}: {what} of {name} misses the sphere of LEN about SP of {parent} by {miss:.6g}; "
        f"one of these values is wrong",
        place=f"{parent}.EP",
    )


def _check(state: BoneValues, slack: float) -> None:
    """Compares the two sides of every equation whose values are all known.

    :raises ContentError: when they differ by more than `slack` (a matrix by TOLERANCE).
    """
    for bone, name in enumerate(state.bones.names):
        _check_length(state, bone, name, slack)
        for rule in _CHECKS:
            left, right = state.get(bone, rule.finds), _right_side(state, bone, rule)
            if left is None or right is None:
                continue
            value = rule.function(*right)
            assert not isinstance(value, rules.JointPoint)
            apart = float(np.max(np.abs(value - left), initial=0.0))
            if apart > (slack if rule.finds != "RM" else 10 * TOLERANCE):
                raise _contradiction(state, bone, name, rule, apart)


def _check_length(state: BoneValues, bone: int, name: str, slack: float) -> None:
    start, end, length = (state.get(bone, quantity) for quantity in ("SP", "EP", "LEN"))
    if start is None or end is None or length is None:
        return
    apart = np.abs(vector.length(end - start) - length)
    if np.max(apart, initial=0.0) > slack:
        raise ContentError(
            f"SP and EP of {name} are {float(np.max(vector.length(end - start))):.6g} apart, but its LEN is "
            f"{float(np.max(length)):.6g}",
            place=f"{name}.LEN",
        )


def _contradiction(state: BoneValues, bone: int, name: str, rule: _Rule, apart: float) -> ContentError:
    sources = [f"{rule.finds} of {name} ({state.values[bone, rule.finds].source})"]
    for need in rule.needs:
        owner = int(state.bones.parent[bone]) if need.startswith("P") else bone
        known = state.values.get((owner, need.removeprefix("P")))
        if owner >= 0 and known is not None:
            sources.append(f"{need.removeprefix('P')} of {state.bones.names[owner]} ({known.source})")
    return ContentError(
        f"contradiction: rule {rule.number} gives another {rule.finds}, {apart:.6g} away: "
        + ", ".join(sources),
        place=f"{name}.{rule.finds}",
    )
