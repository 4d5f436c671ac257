"""Step 10, sense: the touches of a tick, which become events of the next tick (CD4).

    senses: {HIT: {touch: [body, monster], on: enter}}

`enter`: they touch, and did not at the beginning of the tick; `stay`: they did and still do; `leave`: they no
longer touch, or one of them is gone. An actor that passes right through another within a tick enters and
leaves. No actor touches itself.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.alternatives import Touch
from statwalk.machine.runtime.surroundings import TOUCH
from statwalk.maths.arrays import Floats, Ints
from statwalk.rig.model_buffer import ModelBuffer
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.contacts import NO_CONTACTS, ContactChanges, Contacts, Pair, contact_changes
from statwalk.stage.state.pending_events import MOST_RAISED, PendingEvent
from statwalk.world.collide import NO_BODIES, Bodies, touches

ORDER = {"stay": 0, "enter": 1, "leave": 2}
"""order of events at the same moment"""


def touched(before: Contacts, casts: Sequence[Cast]) -> tuple[Contacts, tuple[PendingEvent, ...]]:
    """Returns the contacts after a tick, and the events that its touches raise, by time, actor and event."""
    pairs = tuple(
        dict.fromkeys((touch.own, touch.other) for cast in casts for touch in cast.role.machine.touches)
    )
    if not pairs:
        return NO_CONTACTS, ()
    now = Contacts.of(pairs)
    bodies, row_of_pair = now.since(before, _bodies(casts, now.names)), now.row_of_pair
    hits = touches(bodies, row_of_pair >= 0)
    if not len(hits.first) and not len(before.touching):
        return replace(now, bodies=bodies), ()
    changes = contact_changes(hits, bodies, row_of_pair, now.remembered(before))
    keyed = [
        (event.time, event.actor, ORDER[touch.on], event)
        for cast in casts
        for touch in cast.role.machine.touches
        for event in _events(cast, touch, changes, now.pairs)
    ]
    events = [event for *_, event in sorted(keyed)]
    return replace(now, touching=changes.contact[changes.lasts], bodies=bodies), tuple(_bounded(events))


def _bodies(casts: Iterable[Cast], names: Sequence[str]) -> Bodies:
    """The present colliders with these names, of all actors."""
    bodies = [_bodies_of(cast, cast.model, names) for cast in casts if cast.model is not None]
    return Bodies._make(np.concatenate(arrays) for arrays in zip(NO_BODIES, *bodies, strict=True))


def _bodies_of(cast: Cast, model: ModelBuffer, names: Sequence[str]) -> Bodies:
    colliders = cast.role.colliders
    kinds = _kinds_of(colliders.names, tuple(names))
    placed = colliders.placed(model, cast.position, cast.heading)
    row, column = (placed.is_there & (kinds >= 0)).nonzero()
    center, normal = placed.center[row, column], placed.normal[row, column]
    return Bodies(
        cast.ids[row],
        kinds[column],
        center,
        center,
        placed.radius[row, column],
        colliders.is_plane[column],
        normal,
        normal,
    )


@lru_cache(maxsize=256)
def _kinds_of(colliders: tuple[str, ...], names: tuple[str, ...]) -> Ints:
    """(C,) the row of each collider among the names, -1 none. Read-only."""
    kinds = np.array([names.index(name) if name in names else -1 for name in colliders], np.int64)
    kinds.setflags(write=False)
    return kinds


def _events(
    cast: Cast, touch: Touch, changes: ContactChanges, pairs: Sequence[Pair]
) -> Iterator[PendingEvent]:
    """The events that one sense of a cast's machine raises."""
    own = np.isin(changes.contact[:, 0], cast.ids) & (
        changes.contact[:, 1] == pairs.index((touch.own, touch.other))
    )
    counted, time, place = _moments(touch.on, changes.take(own))
    rows = _first_of_each(counted.contact, time)
    name = cast.role.machine.events[touch.event]
    for contact, when, point in zip(
        counted.contact[rows].tolist(), time[rows].tolist(), place[rows].tolist(), strict=True
    ):
        yield PendingEvent(
            contact[0], name, contact[2], TOUCH, None if point[0] != point[0] else tuple(point), when
        )


def _moments(on: str, changes: ContactChanges) -> tuple[ContactChanges, Floats, Floats]:
    """The touches that count for `on`, with time in the tick (M,) and place (M, 3)."""
    match on:
        case "enter":
            counted = changes.take(~changes.was)
            return counted, counted.start, counted.at_start
        case "leave":
            counted = changes.take(~changes.lasts)
            return counted, counted.end, counted.at_end
    counted = changes.take(changes.was & changes.lasts)
    return counted, counted.start, counted.at_end


def _first_of_each(contact: NDArray[np.int64], time: Floats) -> Ints:
    """Rows of the first MOST_RAISED touches of each actor, by time; a heap of thousands would overload the
    machines.
    """
    order = np.lexsort((contact[:, 2], time, contact[:, 0]))
    actor = contact[order, 0]
    rank = np.arange(len(actor)) - actor.searchsorted(actor)
    first: Ints = order[rank < MOST_RAISED]
    return first


def _bounded(events: Iterable[PendingEvent]) -> Iterator[PendingEvent]:
    """At most MOST_RAISED events for each actor."""
    reached: Counter[int] = Counter()
    for event in events:
        reached[event.actor] += 1
        if reached[event.actor] <= MOST_RAISED:
            yield event
