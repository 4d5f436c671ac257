"""A cast as arrays by name, the form in which it is stored.

Poses are rows without empty lanes; offsets are stored only for transitions under way, and of the queues of
pending events only the places in use.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.character.role import Role
from statwalk.errors import StageError
from statwalk.machine.runtime.state import MOST_WAITING, QUEUE, MachineState, fresh
from statwalk.maths.arrays import Bools
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.stage.history.value_checks import check_values
from statwalk.stage.state.cast import COLUMNS, CastState
from statwalk.stage.state.pose_offsets import PoseOffsets

Arrays = dict[str, NDArray[Any]]
CLOCKS = ("elapsed", "duration", "quintic", "old_root_delta")
"""the arrays of PoseOffsets that have a row for each actor"""
OFFSETS = ("offsets.start", "offsets.rate")
PENDING = tuple(f"machine.{name}" for name in QUEUE)


def to_arrays(cast: CastState) -> Arrays:
    """Returns the stored arrays of a cast, by name."""
    arrays: Arrays = {name: getattr(cast, name) for name in COLUMNS}
    arrays |= {f"machine.{name}": array for name, array in cast.machine._asdict().items()}
    places = _used_places(cast.machine.waiting).reshape(-1).nonzero()[0]
    arrays |= {name: arrays[name].reshape(-1)[places] for name in PENDING}
    arrays |= {"shown": cast.shown.rows(), "previous": cast.previous.rows()}
    arrays |= {f"offsets.{name}": getattr(cast.offsets, name) for name in CLOCKS}
    return arrays | dict(zip(OFFSETS, cast.offsets.rows(), strict=True))


def from_arrays(key: str, role: Role, arrays: Arrays) -> CastState:
    """Returns the cast that `to_arrays` was called with; `key` names its role in messages.

    :raises StageError: when dtypes, shapes or counts of the arrays do not fit the role or one another.
    """
    _check_shapes(key, role, arrays)
    _check_counts(key, arrays)
    check_values(key, role.machine, arrays)
    rest, clocks = role.character.bind_pose, [arrays[f"offsets.{name}"] for name in CLOCKS]
    return CastState(
        machine=_machine_of(role, arrays),
        shown=PoseBuffer.of_rows(rest, arrays["shown"]),
        previous=PoseBuffer.of_rows(rest, arrays["previous"]),
        offsets=PoseOffsets.of_rows(clocks, *(arrays[name] for name in OFFSETS)),
        **{name: arrays[name] for name in COLUMNS},
    )


def _machine_of(role: Role, arrays: Arrays) -> MachineState:
    machine = fresh(role.machine.program, len(arrays["ids"]))
    is_used = _used_places(arrays["machine.waiting"])
    for name in QUEUE:
        getattr(machine, name)[is_used] = arrays[f"machine.{name}"]
    rest = {name: arrays[f"machine.{name}"] for name in MachineState._fields if name not in QUEUE}
    return machine._replace(**rest)


def _used_places(waiting: NDArray[Any]) -> Bools:
    """(N, L, 16) whether an event waits in the place."""
    is_used: Bools = np.arange(MOST_WAITING) < waiting[..., None]
    return is_used


def _check_shapes(key: str, role: Role, arrays: Arrays) -> None:
    count = len(arrays["ids"])
    for name, like in to_arrays(CastState.empty(role)).items():
        rows = len(arrays[name]) if name in OFFSETS + PENDING else count
        expected, stored = ((rows, *like.shape[1:]), like.dtype), (arrays[name].shape, arrays[name].dtype)
        if expected != stored:
            raise StageError(
                f"{key} has another shape: {name} is {_form(*stored)}, and {_form(*expected)} in the role "
                "that is here"
            )


def _form(shape: tuple[int, ...], kind: np.dtype[Any]) -> str:
    return f"{kind} {shape}"


def _check_counts(key: str, arrays: Arrays) -> None:
    waiting = arrays["machine.waiting"]
    wrong = waiting[(waiting < 0) | (waiting > MOST_WAITING)]
    if len(wrong):
        raise StageError(f"{key}: {wrong[0]} events wait in one layer; there is room for 0 … {MOST_WAITING}")
    under_way = np.count_nonzero(arrays["offsets.elapsed"] < arrays["offsets.duration"])
    for names, count in ((PENDING, int(waiting.sum())), (OFFSETS, under_way)):
        for name in names:
            if len(arrays[name]) != count:
                raise StageError(
                    f"{key}: {name} has {len(arrays[name])} rows, and the counts add up to {count}"
                )
