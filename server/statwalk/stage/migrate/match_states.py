"""What is the same in two versions of a machine: all of it, a motion, a state."""

from __future__ import annotations

from dataclasses import fields

import numpy as np

from statwalk.machine.compile.machine import Machine
from statwalk.maths.arrays import Bools, Ints

NOT_COMPARED = ("condition", "when", "release", "line")
"""members that are ignored when two machines are compared: programs, whose text is compared, and
line numbers
"""


def is_same(old: Machine, new: Machine) -> bool:
    """Returns whether two machines behave in the same way, whatever their files look like."""
    return all(_plain(getattr(old, part.name)) == _plain(getattr(new, part.name)) for part in fields(Machine))


def _plain(value: object) -> object:
    """A value that can be compared: arrays as bytes, without programs and line numbers."""
    if isinstance(value, np.ndarray):
        return value.shape, value.tobytes()
    if isinstance(value, dict):
        return {key: _plain(member) for key, member in value.items()}
    if isinstance(value, tuple) and hasattr(value, "_asdict"):
        return tuple(_plain(member) for name, member in value._asdict().items() if name not in NOT_COMPARED)
    if isinstance(value, tuple):
        return tuple(_plain(member) for member in value)
    if hasattr(value, "__dataclass_fields__"):
        return tuple(
            _plain(getattr(value, name)) for name in value.__dataclass_fields__ if name not in NOT_COMPARED
        )
    return value


def matched_states(old: Machine, new: Machine, before: int, layer: int) -> Ints:
    """Returns (S,) the row in a layer of the new machine of each state of the old machine, -1 if the state
    is gone.

    A state whose name is gone is the one new state with its motion, unless another state that is gone had
    this motion, too: an edit renamed it, or moved it into or out of a sub-machine.
    """
    rows = {new.states[row]: row for row in new.rows(layer)}
    names = {name: row for row, name in enumerate(old.states) if old.layer_of[row] == before}
    found = np.array(
        [rows.get(name, -1) if names.get(name) == row else -1 for row, name in enumerate(old.states)]
    )
    gone = [row for name, row in names.items() if name not in rows]
    came = [row for name, row in rows.items() if name not in names]
    motions = _motions(old), _motions(new)
    for row in gone:
        alike = [other for other in came if motions[1][other] == motions[0][row]]
        rivals = [other for other in gone if motions[0][other] == motions[0][row]]
        if len(alike) == len(rivals) == 1:
            found[row] = alike[0]
    return found


def is_same_motion(old: Machine, new: Machine, before: Ints, after: Ints) -> Bools:
    """Returns (N,) whether two states play the same motion, as long and in the same way."""
    key_of = [_motions(old), _motions(new)]
    same = {
        (old_state, new_state): key_of[0][old_state] == key_of[1][new_state]
        for old_state, new_state in set(zip(before.tolist(), after.tolist(), strict=True))
    }
    return np.array([same[pair] for pair in zip(before.tolist(), after.tolist(), strict=True)], bool)


def _motions(machine: Machine) -> list[object]:
    """The motion of each state, in comparable form."""
    clips = [machine.motions[row] if row >= 0 else "" for row in machine.motion]
    return [
        (clip, _plain(blend), bool(loop), float(duration))
        for clip, blend, loop, duration in zip(
            clips, machine.blends, machine.loop, machine.duration, strict=True
        )
    ]
