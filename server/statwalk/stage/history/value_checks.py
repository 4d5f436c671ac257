"""Looks at the values of a stored cast before compiled code reads them: kernels check no bounds."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import StageError
from statwalk.machine.compile.machine import Machine
from statwalk.machine.runtime.state import FOR_END, OWED

LARGEST = 1e12
"""seconds, metres and parameters beyond it are no state that a stage comes to"""


def check_values(key: str, machine: Machine, arrays: dict[str, NDArray[Any]]) -> None:
    """Refuses values that no stage writes; `key` names the role in messages. Shapes are checked before.

    :raises StageError: when a state, an event or another number is not one of the machine's, when a number is
        not finite, or when the ids of the actors do not rise.
    """
    for name, (least, most) in _bounds(machine).items():
        values = arrays[f"machine.{name}"]
        wrong = values[(values < least) | (values > most)]
        if len(wrong):
            raise StageError(f"{key}: {name} has {wrong[0]}, and the machine has {least} … {most}")
    layers = np.arange(len(machine.layers))
    if (machine.layer_of[arrays["machine.state"]] != layers).any():
        raise StageError(f"{key}: an actor is in a state of another layer")
    ids = arrays["ids"]
    if len(ids) and (ids[0] < 1 or (np.diff(ids) <= 0).any()):
        raise StageError(f"{key}: the ids of the actors do not rise from 1 on")
    for name, values in arrays.items():
        # NaN fails the comparison as well
        if values.dtype.kind == "f" and not (np.abs(values) <= LARGEST).all():
            raise StageError(f"{key}: {name} has a number that is not finite, or beyond {LARGEST:g}")


def _bounds(machine: Machine) -> dict[str, tuple[int, int]]:
    """The least and the largest value of the arrays whose numbers are places in other arrays."""
    states, events = machine.target.shape
    count = int(machine.program.alternatives[-1])
    return {
        "state": (0, states - 1),
        "age": (0, np.iinfo(np.int32).max),
        "ended": (0, OWED),
        "waiting_event": (0, events - 1),
        "waiting_for": (0, FOR_END),
        "held": (0, np.iinfo(np.int32).max),
        "stayed": (-1, count - 1),
        "last": (-1, states - 1),
        "goal": (-1, states - 1),
    }
