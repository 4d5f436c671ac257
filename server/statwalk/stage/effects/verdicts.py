"""Verdicts in words. The words are made when a verdict is read; most verdicts never are."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from typing import NamedTuple, overload

from statwalk.character.role import Role
from statwalk.machine.runtime.reasons import VERDICTS
from statwalk.machine.runtime.result import VerdictCodes
from statwalk.maths.arrays import Ints
from statwalk.stage.effects.authored_cells import cells_of
from statwalk.stage.effects.words import lines, notice_sentence, sentence, touch_sentence, values_of
from statwalk.stage.state.frame import Verdict
from statwalk.stage.state.pending_events import Notice, PendingEvent


class CastVerdicts(NamedTuple):
    """The verdicts on a cast in a tick, as codes; `ids` (N,) of its actors."""

    role: Role
    ids: Ints
    verdicts: VerdictCodes


class DeliveredNotice(NamedTuple):
    """A notice, the role of its actor, and the row of the state that the actor is in."""

    role: Role
    notice: Notice
    state: int


class TickVerdicts(Sequence[Verdict]):
    """The verdicts of one tick: first the notices, then the verdicts of the machines, cast by cast."""

    def __init__(
        self,
        tick: int,
        notices: Iterable[DeliveredNotice],
        casts: Iterable[CastVerdicts],
        inbox: Sequence[PendingEvent],
    ) -> None:
        """`inbox`: the pending events at the beginning of the tick."""
        self.tick = tick
        self._words: tuple[Verdict, ...] | None = None
        self._notices, self._inbox = tuple(notices), inbox
        self._casts = tuple(cast for cast in casts if len(cast.verdicts.rows))
        self._length = len(self._notices) + sum([len(cast.verdicts.rows) for cast in self._casts])

    @property
    def _made(self) -> tuple[Verdict, ...]:
        if self._words is None:  # not cached_property: its lock would have ticks wait for another reader
            touched = {event[:3]: touch_sentence(event) for event in self._inbox if event.point}
            self._words = (
                *(_notice_in_words(self.tick, delivered) for delivered in self._notices),
                *(verdict for cast in self._casts for verdict in _in_words(self.tick, cast, touched)),
            )
        return self._words

    def __len__(self) -> int:
        return self._length

    def __iter__(self) -> Iterator[Verdict]:
        return iter(self._made)

    @overload
    def __getitem__(self, place: int) -> Verdict: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[Verdict, ...]: ...
    def __getitem__(self, place: int | slice) -> Verdict | tuple[Verdict, ...]:
        return self._made[place]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and self._made == tuple(other)

    __hash__ = None  # type: ignore[assignment]


def _notice_in_words(tick: int, delivered: DeliveredNotice) -> Verdict:
    role, notice, state = delivered
    return Verdict(
        tick,
        notice.actor,
        notice.layer,
        notice.event,
        "taken" if notice.to_state else "dropped",
        notice_sentence(notice, role.name),
        notice.from_state or role.machine.states[state],
        notice.to_state,
        other=notice.other,
    )


def _in_words(
    tick: int, cast: CastVerdicts, touched: Mapping[tuple[int, str, int], str]
) -> Iterator[Verdict]:
    """Replaces rows by ids and names of actors, states and events; a touch also gets its place and time."""
    machine, cells = cast.role.machine, cells_of(cast.role)
    program, text = machine.program, machine.text
    for row, line in enumerate(lines(cast.verdicts)):
        actor, event, state = int(cast.ids[line.actor]), text.events[line.event], text.states[line.from_state]
        cell = (
            cells.get((line.layer, state, event))
            if any(text.cells.get((line.from_state, line.event), ()))
            else None
        )
        yield Verdict(
            tick,
            actor,
            line.layer,
            event,
            VERDICTS[line.verdict],
            "; ".join(
                filter(None, (touched.get((actor, event, line.other), ""), sentence(program, text, line)))
            ),
            state,
            text.states[line.to_state] if line.to_state >= 0 else "",
            cell.written if cell else None,
            cell.source if cell else "",
            cell.line if cell else 0,
            values_of(text, cast.verdicts, row),
            line.other,
        )


def _tick_of(verdicts: Sequence[Verdict]) -> int:
    return verdicts.tick if isinstance(verdicts, TickVerdicts) else verdicts[0].tick


class RememberedVerdicts(Sequence[Verdict]):
    """The newest `most` verdicts of many ticks."""

    def __init__(self, most: int) -> None:
        self.most = most
        self._ticks: deque[Sequence[Verdict]] = deque()
        self._length = 0

    def extend(self, verdicts: Sequence[Verdict]) -> None:
        """Appends the verdicts of another tick."""
        if not verdicts:
            return
        self._ticks.append(verdicts)
        self._length += len(verdicts)
        while self._length - (len(self._ticks[0]) if self._ticks else 0) >= self.most:
            self._length -= len(self._ticks.popleft())

    def until(self, tick: int) -> RememberedVerdicts:
        """Returns the verdicts up to and including a tick."""
        earlier = RememberedVerdicts(self.most)
        for verdicts in self._ticks:
            if _tick_of(verdicts) <= tick:
                earlier.extend(verdicts)
        return earlier

    def after(self, tick: int) -> Iterator[Verdict]:
        """Yields the verdicts after a tick; words are made when they are read, and more ticks may be appended
        in between.
        """
        left_out = self._length - len(self) if self._ticks and _tick_of(self._ticks[0]) > tick else 0
        later = tuple(verdicts for verdicts in self._ticks if _tick_of(verdicts) > tick)
        return islice((verdict for verdicts in later for verdict in verdicts), left_out, None)

    def __len__(self) -> int:
        return min(self._length, self.most)

    def __iter__(self) -> Iterator[Verdict]:
        return self.after(-1)

    @overload
    def __getitem__(self, place: int) -> Verdict: ...
    @overload
    def __getitem__(self, place: slice) -> list[Verdict]: ...
    def __getitem__(self, place: int | slice) -> Verdict | list[Verdict]:
        return list(self)[place]
