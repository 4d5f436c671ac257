"""The state of a stage as bytes, exact and versioned: a JSON header that names every array, then the arrays,
little-endian, each at a multiple of 8 bytes. Reading executes no code, and checks sizes before it allocates
memory.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import starmap
from math import prod
from typing import Any

import numpy as np
import orjson
from numpy.typing import NDArray

from statwalk.character.role import Role
from statwalk.errors import StageError
from statwalk.stage.history.cast_codec import Arrays, from_arrays, to_arrays
from statwalk.stage.history.engine import ENGINE
from statwalk.stage.state.cast import CastState
from statwalk.stage.state.contacts import Contacts
from statwalk.stage.state.flights import Flight
from statwalk.stage.state.pending_events import NOTICE_REASONS, Notice, PendingEvent
from statwalk.stage.state.stage_state import StageState
from statwalk.world.collide import Bodies

MAGIC, VERSION = b"statwalk", 3
KIND = re.compile(r"[<|][biuf][1248]")
COUNTERS = {"tick": 0, "next_id": 1, "action_count": 0}
"""whole numbers of the header, and the least that each can be"""
ALIGNMENT = 8
LARGEST_COUNTER = (1 << 62) - 1


def to_bytes(state: StageState) -> bytes:
    """Returns the state as bytes; `from_bytes` returns the same state, to the bit."""
    arrays = dict(_arrays(state))
    header = {
        "version": VERSION,
        "engine": ENGINE,
        "tick": state.tick,
        "next_id": state.next_id,
        "names": list(state.names.items()),
        "action_count": state.action_count,
        "inbox": list(map(list, state.inbox)),
        "notices": list(map(list, state.notices)),
        "pairs": state.contacts.pairs,
        "casts": list(state.casts),
        "flights": [flight.role for flight in state.flights],
        "versions": list(state.versions.items()),
        "arrays": [[name, array.dtype.newbyteorder("<").str, array.shape] for name, array in arrays.items()],
    }
    text = orjson.dumps(header)
    parts: list[bytes | memoryview] = [MAGIC, len(text).to_bytes(8, "little"), text, _filling(len(text))]
    for array in arrays.values():
        stored = np.ascontiguousarray(array, array.dtype.newbyteorder("<"))
        parts += [stored.data, _filling(stored.nbytes)]
    return b"".join(parts)


def from_bytes(data: bytes, roles: Mapping[str, Role]) -> StageState:
    """Returns the state that `to_bytes` was called with, in writable arrays.

    :raises StageError: when the bytes are of another version, cut off, or do not fit the roles.
    """
    header, arrays = _parsed(data)
    try:
        _check_header(header)
        casts = {key: _cast(key, _part(arrays, f"cast.{key}."), roles) for key in header["casts"]}
        bodies = Bodies(**_part(arrays, "bodies.")) if "bodies.owner" in arrays else None
        return StageState(
            tick=header["tick"],
            casts=casts,
            next_id=header["next_id"],
            names={int(actor): name for actor, name in header["names"]},
            action_count=header["action_count"],
            inbox=tuple(starmap(_pending, header["inbox"])),
            notices=tuple(starmap(_notice, header["notices"])),
            contacts=Contacts(
                tuple((own, other) for own, other in header["pairs"]), _as_ids(arrays["touching"]), bodies
            ),
            flights=tuple(Flight(role, **_part(arrays, f"flight.{role}.")) for role in header["flights"]),
            versions=dict(header["versions"]),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise StageError(f"these bytes hold no stage: {error}") from None


def _check_header(header: Mapping[str, Any]) -> None:
    for name, least in COUNTERS.items():
        if type(header[name]) is not int or not least <= header[name] <= LARGEST_COUNTER:
            raise ValueError(f"{name} is {str(header[name])[:40]}; it is a whole number from {least} on")
    ids = [actor for actor, _ in header["names"]]
    if any(type(actor) is not int or not 1 <= actor < header["next_id"] for actor in ids):
        raise ValueError("an actor's id is not below next_id")


def _arrays(state: StageState) -> Iterator[tuple[str, NDArray[Any]]]:
    for key, cast in state.casts.items():
        yield from ((f"cast.{key}.{name}", array) for name, array in to_arrays(cast).items())
    yield "touching", state.contacts.touching
    if state.contacts.bodies is not None:
        yield from ((f"bodies.{name}", array) for name, array in state.contacts.bodies._asdict().items())
    for flight in state.flights:
        yield from (
            (f"flight.{flight.role}.{name}", array)
            for name, array in flight._asdict().items()
            if name != "role"
        )


def _parsed(data: bytes) -> tuple[dict[str, Any], Arrays]:
    """Header and arrays of the bytes; each array is a copy."""
    start = len(MAGIC) + 8
    if not data.startswith(MAGIC) or len(data) < start:
        raise StageError("these bytes hold no stage: they do not begin with `statwalk`")
    end = start + int.from_bytes(data[len(MAGIC) : start], "little")
    try:
        header = orjson.loads(data[start:end])
        if header["version"] != VERSION:
            raise StageError(
                f"the stage was written in version {header['version']!r}; this build reads version {VERSION}"
            )
        if header.get("engine") != ENGINE:
            raise StageError(f"engine {header.get('engine')!r} made the stage; this is engine {ENGINE}")
        place, arrays = end + len(_filling(end - start)), Arrays()
        for name, kind, shape in header["arrays"]:
            if not KIND.fullmatch(kind):
                raise ValueError(f"{kind[:20]!r} is no kind of an array here")
            arrays[name], place = _array(data, place, np.dtype(kind), tuple(shape))
    except (KeyError, TypeError, ValueError) as error:
        raise StageError(f"these bytes hold no stage: {error}") from None
    return header, arrays


def _array(data: bytes, place: int, kind: np.dtype[Any], shape: tuple[int, ...]) -> tuple[NDArray[Any], int]:
    """The array at a place, and the place of the next array."""
    size = prod(shape) * kind.itemsize
    if kind.hasobject or min(shape, default=0) < 0 or place + size > len(data):
        raise ValueError("an array is cut off")
    values = np.frombuffer(data, kind, prod(shape), place).reshape(shape).astype(kind.newbyteorder("="))
    return values, place + size + len(_filling(size))


def _cast(key: str, arrays: Arrays, roles: Mapping[str, Role]) -> CastState:
    if key not in roles:
        raise StageError(
            f"the stage plays {key!r}, which is not here; there are: {', '.join(roles) or 'none'}"
        )
    return from_arrays(key, roles[key], arrays)


def _part(arrays: Arrays, prefix: str) -> dict[str, Any]:
    return {name.removeprefix(prefix): array for name, array in arrays.items() if name.startswith(prefix)}


def _pending(
    actor: int, event: str, other: int, kind: int, point: list[float] | None, time: float
) -> PendingEvent:
    return PendingEvent(
        actor, event, other, kind, None if point is None else (point[0], point[1], point[2]), time
    )


def _notice(actor: int, event: str, other: int, reason: int, *operands: Any) -> Notice:
    """:raises ValueError: when no reason has this code."""
    if reason not in NOTICE_REASONS:
        raise ValueError(f"{reason!r} is no reason of a notice")
    return Notice(actor, event, other, reason, *operands)


def _as_ids(array: NDArray[Any]) -> NDArray[np.int64]:
    return array.astype(np.int64, copy=False)


def _filling(size: int) -> bytes:
    return bytes(-size % ALIGNMENT)
