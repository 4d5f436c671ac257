"""Events that actors raise on each other by the action `raise(EVENT, WHOM)`.

The events count in the next tick.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property

from statwalk.machine.runtime.surroundings import RAISED
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.frame import Action
from statwalk.stage.state.pending_events import (
    MOST_RAISED,
    NO_OTHER,
    NOBODY_IS_CALLED,
    NOBODY_KNOWS,
    TOO_MANY_RAISED,
    Notice,
    PendingEvent,
)

RAISE = "raise"
OTHER, ALL = "other", "all"
"""targets of a raised event beside the name of an actor: the actor that raised the event which the cell
answers, or all other actors
"""


def raised_by(
    actions: Iterable[Action], casts: Sequence[Cast], names: Mapping[int, str]
) -> tuple[tuple[PendingEvent, ...], tuple[Notice, ...]]:
    """Returns the events that the actions of a tick raise, in order, and notices about lost events; `names`
    of all actors by id.
    """
    raises = [action for action in actions if action.name == RAISE]
    if not raises:
        return (), ()
    raising = Raising(casts, names)
    for action in raises:
        raising.take(action)
    return tuple(raising.raised), tuple(raising.lost)


class Raising:
    """Delivers the events of one tick: at most MOST_RAISED to an actor, in time proportional to the
    deliveries.
    """

    def __init__(self, casts: Sequence[Cast], names: Mapping[int, str]) -> None:
        self.casts, self.names = casts, names
        self.raised: list[PendingEvent] = []
        self.lost: list[Notice] = []
        self.reached: Counter[int] = Counter()
        self.knowing: dict[str, list[int]] = {}
        self.open: dict[str, list[int]] = {}
        """the ids of actors that have an event and can still be reached, by event"""

    def take(self, action: Action) -> None:
        """Handles an action `raise(EVENT, WHOM)`."""
        event, target = str(action.arguments[0]), str(action.arguments[1])
        targets = self._all_others(action.actor, event) if target == ALL else self._targets_of(action, target)
        if targets is None:
            reason = {OTHER: NO_OTHER, ALL: NOBODY_KNOWS}.get(target, NOBODY_IS_CALLED)
            self.lost.append(Notice(action.actor, event, action.other, reason, target=target))
        for actor in targets or ():
            self.reach(actor, event, action.actor)

    def reach(self, actor: int, event: str, raiser: int) -> None:
        """Raises one event on one actor."""
        self.reached[actor] += 1
        if self.reached[actor] <= MOST_RAISED:
            self.raised.append(PendingEvent(actor, event, raiser, RAISED))
        elif self.reached[actor] == MOST_RAISED + 1:
            self.lost.append(Notice(actor, event, raiser, TOO_MANY_RAISED))

    def _targets_of(self, action: Action, target: str) -> list[int] | None:
        """Returns the ids of the actors that `other` or a name stands for; None if no actor does."""
        if target == OTHER:
            return [action.other] if any(cast.row(action.other) >= 0 for cast in self.casts) else None
        return self.named.get(target)

    @cached_property
    def named(self) -> dict[str, list[int]]:
        """The ids of all actors by name; several actors may share a name."""
        ids_of: dict[str, list[int]] = {}
        for actor, name in self.names.items():
            ids_of.setdefault(name, []).append(actor)
        return ids_of

    def _all_others(self, raiser: int, event: str) -> list[int] | None:
        """The actors that have the event, without the raiser and without actors that have reached
        MOST_RAISED; None if no other actor has the event.
        """
        if event not in self.knowing:
            self.knowing[event] = [
                actor
                for cast in self.casts
                if event in cast.role.machine.events[:-1]
                for actor in cast.ids.tolist()
            ]
            self.open[event] = self.knowing[event]
        if not any(actor != raiser for actor in self.knowing[event]):
            return None
        self.open[event] = [actor for actor in self.open[event] if self.reached[actor] <= MOST_RAISED]
        return [actor for actor in self.open[event] if actor != raiser]
