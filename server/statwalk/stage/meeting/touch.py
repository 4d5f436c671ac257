"""Step 10, sense: who touches whom in a tick. What is found are events of the next one (CD4).

    senses: {HIT: {touch: [body, monster], on: enter}}

`enter`: they touch, and did not when the tick began; `stay`: they did and still do; `leave`: they do not any more, or one is gone. Who goes
right through the other within a tick enters and leaves. Nobody touches itself.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runparts import Touch
from statwalk.machine.ticking.step import TOUCH
from statwalk.maths.arrays import Floats, Ints
from statwalk.stage.cast import Cast
from statwalk.stage.meeting.contacts import Contacts, Meetings, Pair, meetings
from statwalk.stage.meeting.raised import MOST_RAISED, Raised
from statwalk.world.collide import Bodies, touches

ORDER = {"stay": 0, "enter": 1, "leave": 2}
"""of what happens at the same moment"""


def touched(before: Contacts, casts: Sequence[Cast]) -> tuple[Contacts, tuple[Raised, ...]]:
    """What is remembered after a tick, and the events that the touches in it raise, by time, actor and event."""
    now = Contacts(tuple(dict.fromkeys((touch.own, touch.other) for cast in casts for touch in cast.role.machine.touches)))
    if not now.pairs:
        return now, ()
    bodies, row_of_pair = now.since(before, _bodies(casts, now.names)), now.row_of_pair
    hits = touches(bodies, row_of_pair >= 0)
    if not len(hits.first) and not len(before.touching):
        return replace(now, bodies=bodies), ()
    found = meetings(hits, bodies, row_of_pair, now.remembered(before))
    heard = [
        (event.time, event.actor, ORDER[touch.on], event)
        for cast in casts
        for touch in cast.role.machine.touches
        for event in _events(cast, touch, found, now.pairs)
    ]
    events = [event for *_, event in sorted(heard)]
    return replace(now, touching=found.who[found.lasts], bodies=bodies), tuple(_bounded(events))


def _bodies(casts: Iterable[Cast], names: Sequence[str]) -> Bodies:
    """The colliders of those names, of all who have them, where they are now."""
    found = [_bodies_of(cast, names) for cast in casts]
    return Bodies._make(np.concatenate(arrays) for arrays in zip(*found, strict=True))


def _bodies_of(cast: Cast, names: Sequence[str]) -> Bodies:
    colliders = cast.role.colliders
    kinds = np.array([names.index(name) if name in names else -1 for name in colliders.names], np.int64)
    placed = colliders.placed(cast.shown, cast.position, cast.heading)
    row, column = (placed.is_there & (kinds >= 0)).nonzero()
    center, normal = placed.center[row, column], placed.normal[row, column]
    return Bodies(cast.ids[row], kinds[column], center, center, placed.radius[row, column], colliders.is_plane[column], normal, normal)


def _events(cast: Cast, touch: Touch, found: Meetings, pairs: Sequence[Pair]) -> Iterator[Raised]:
    """What one sense of a cast's machine hears of the meetings."""
    mine = np.isin(found.who[:, 0], cast.ids) & (found.who[:, 1] == pairs.index((touch.own, touch.other)))
    heard, time, place = _moments(touch.on, found.take(mine))
    rows = _first_of_each(heard.who, time)
    name = cast.role.machine.events[touch.event]
    for who, when, point in zip(heard.who[rows].tolist(), time[rows].tolist(), place[rows].tolist(), strict=True):
        yield Raised(who[0], name, who[2], TOUCH, None if point[0] != point[0] else tuple(point), when)


def _moments(on: str, found: Meetings) -> tuple[Meetings, Floats, Floats]:
    """Those that count, when in the tick (M,) and where (M, 3)."""
    match on:
        case "enter":
            some = found.take(~found.was)
            return some, some.start, some.at_start
        case "leave":
            some = found.take(~found.lasts)
            return some, some.end, some.at_end
    some = found.take(found.was & found.lasts)
    return some, some.start, some.at_end


def _first_of_each(who: NDArray[np.int64], time: Floats) -> Ints:
    """Rows of the first MOST_RAISED that each actor hears of, by time; a heap of thousands would drown the machines."""
    order = np.lexsort((who[:, 2], time, who[:, 0]))
    actor = who[order, 0]
    rank = np.arange(len(actor)) - actor.searchsorted(actor)
    first: Ints = order[rank < MOST_RAISED]
    return first


def _bounded(events: Iterable[Raised]) -> Iterator[Raised]:
    """No more than MOST_RAISED for each actor."""
    reached: Counter[int] = Counter()
    for event in events:
        reached[event.actor] += 1
        if reached[event.actor] <= MOST_RAISED:
            yield event
