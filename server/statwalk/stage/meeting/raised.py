"""Events that actors raise on each other: by touching, and by the action `raise(EVENT, WHOM)`. They count in the tick that follows."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import NamedTuple

from statwalk.machine.ticking.step import RAISED, TOUCH
from statwalk.stage.cast import Cast
from statwalk.stage.frame import Action

__all__ = ["RAISED", "TOUCH", "Notice", "Raised", "raised_by"]

RAISE = "raise"
OTHER, ALL = "other", "all"
"""whom an event may be raised on beside an actor of that name: who raised the event that the cell answers, or everybody else"""
MOST_RAISED = 16
"""as many as can wait for an actor reach it in a tick; without a bound a thousand actors could raise a million events on each other"""


class Raised(NamedTuple):
    """An event that waits for the next tick of `actor`."""

    actor: int
    """id"""
    event: str
    other: int
    """id of who touched it or raised the event"""
    kind: int
    """TOUCH or RAISED"""
    point: tuple[float, float, float] | None = None
    """where it was touched, metres"""
    time: float = 0.0
    """0…1 within the tick in which it was touched"""

    @property
    def where(self) -> str:
        """The place and the moment of a touch, in words."""
        return f"touched at {', '.join(f'{part:.2f}' for part in self.point or ())} m, {self.time:.2f} into the tick"


class Notice(NamedTuple):
    """What the machine itself cannot give a verdict on: an event that reached nobody, or somebody who cannot take it; what an edit did."""

    actor: int
    """id of the one who hears of it"""
    event: str
    other: int
    reason: str
    layer: int = 0
    from_state: str = ""
    to_state: str = ""
    """where an edit has put the actor in another state"""


def raised_by(actions: Iterable[Action], casts: Sequence[Cast]) -> tuple[tuple[Raised, ...], tuple[Notice, ...]]:
    """What the actions of a tick raise, in their order, and what of it is lost."""
    raising = Raising(casts)
    for action in actions:
        if action.name == RAISE:
            raising.take(action)
    return tuple(raising.raised), tuple(raising.lost)


class Raising:
    """Hands out the events of one tick: to nobody more than MOST_RAISED, and in no more time than that takes."""

    def __init__(self, casts: Sequence[Cast]) -> None:
        self.casts = casts
        self.raised: list[Raised] = []
        self.lost: list[Notice] = []
        self.reached: Counter[int] = Counter()
        self.knowing: dict[str, list[int]] = {}
        self.open: dict[str, list[int]] = {}
        """of those who know an event, the ones that can still be reached"""

    def take(self, action: Action) -> None:
        """An action `raise(EVENT, WHOM)`."""
        event, whom = str(action.arguments[0]), str(action.arguments[1])
        targets = self.everybody_else(action.actor, event) if whom == ALL else self.whom(action, whom)
        if targets is None:
            reason = {OTHER: "there is no other", ALL: f"nobody else knows {event}"}.get(whom, f"nobody here is called {whom}")
            self.lost.append(Notice(action.actor, event, action.other, reason))
        for actor in targets or ():
            self.reach(actor, event, action.actor)

    def reach(self, actor: int, event: str, raiser: int) -> None:
        """One event for one actor."""
        self.reached[actor] += 1
        if self.reached[actor] <= MOST_RAISED:
            self.raised.append(Raised(actor, event, raiser, RAISED))
        elif self.reached[actor] == MOST_RAISED + 1:
            self.lost.append(Notice(actor, event, raiser, f"more than {MOST_RAISED} events were raised on it in one tick"))

    def whom(self, action: Action, whom: str) -> list[int] | None:
        """The ids of those whom an action means by `other` or by name; None where there is none."""
        if whom == OTHER:
            return [action.other] if any(cast.row(action.other) >= 0 for cast in self.casts) else None
        return self.named.get(whom)

    @cached_property
    def named(self) -> dict[str, list[int]]:
        """The ids of all actors by name; several may share one."""
        found: dict[str, list[int]] = {}
        for cast in self.casts:
            for actor, name in zip(cast.ids.tolist(), cast.names, strict=True):
                found.setdefault(name, []).append(actor)
        return found

    def everybody_else(self, raiser: int, event: str) -> list[int] | None:
        """Those who know the event, but for the raiser, and but for those who have had too many already; None where nobody knows it."""
        if event not in self.knowing:
            self.knowing[event] = [actor for cast in self.casts if event in cast.role.machine.events[:-1] for actor in cast.ids.tolist()]
            self.open[event] = self.knowing[event]
        if not any(actor != raiser for actor in self.knowing[event]):
            return None
        self.open[event] = [actor for actor in self.open[event] if self.reached[actor] <= MOST_RAISED]
        return [actor for actor in self.open[event] if actor != raiser]
