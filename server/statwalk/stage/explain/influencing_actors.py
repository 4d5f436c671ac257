"""The actors that can influence one actor: a question about one actor need not play the others.

An actor is influenced by the actors whose colliders it touches, by actors that raise events, and, in a flock,
by the other members and by the colliders that the flock avoids; also through further actors. All other actors
change no bit of it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property

import numpy as np

from statwalk.character.role import Role
from statwalk.stage.state.cast import CastState
from statwalk.stage.state.stage_state import StageState
from statwalk.stage.steps.raise_events import RAISE


class InfluencingActors:
    """The actors that can influence `actor`, whose role is called `name`, on a stage with these versions of
    roles.
    """

    def __init__(self, roles: Mapping[str, Role], actor: int, name: str) -> None:
        self.roles, self.actor, self.name = dict(roles), actor, name

    @cached_property
    def names(self) -> frozenset[str]:
        """The names of the roles whose actors can influence the actor, its own among them."""
        reached, waiting = {self.name}, [self.name]
        while waiting:
            new = self._direct[waiting.pop()] - reached
            reached |= new
            waiting += new
        return frozenset(reached)

    @cached_property
    def counts_fellows(self) -> bool:
        """Whether other actors of its own role can influence the actor."""
        return any(self.name in self._direct[name] for name in self.names)

    def only(self, state: StageState) -> StageState:
        """Returns the state with the actor and all actors that can influence it; the arrays are shared."""
        casts = {key: self._chosen(self.roles[key].name, cast) for key, cast in state.casts.items()}
        return state.with_casts({key: cast for key, cast in casts.items() if cast is not None})

    def _chosen(self, name: str, cast: CastState) -> CastState | None:
        if name not in self.names:
            return None
        if name != self.name or self.counts_fellows:
            return cast
        return cast.take(np.flatnonzero(cast.ids == self.actor))

    @cached_property
    def _direct(self) -> dict[str, set[str]]:
        """The names of the roles that influence a role directly, by the name of the role."""
        names = {role.name for role in self.roles.values()}
        direct: dict[str, set[str]] = {name: set() for name in names}
        for role in self.roles.values():
            direct[role.name] |= self._touched(role)
            for event in _raised(role):
                for hearer in self._hearers(event):
                    direct[hearer].add(role.name)
                    direct[role.name].add(hearer)  # the raiser gets a notice if no actor has the event
        return direct

    def _touched(self, role: Role) -> set[str]:
        """The roles with colliders that a role senses or flies around; for a flock also its own role."""
        colliders = {touch.other for touch in role.machine.touches}
        flock = role.definition.flock
        colliders |= set() if flock is None else set(flock.avoid)
        names = {owner.name for owner in self.roles.values() if colliders.intersection(owner.colliders.names)}
        return names if flock is None else names | {role.name}

    def _hearers(self, event: str) -> set[str]:
        return {role.name for role in self.roles.values() if event in role.machine.events[:-1]}


def _raised(role: Role) -> Iterable[str]:
    return {str(action.arguments[0]) for action in role.machine.actions if action.name == RAISE}
