"""The state of a stage at a tick: arrays and plain values, no roles.

State, roles and commands determine all later ticks.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from statwalk.stage.state.cast import CastState
from statwalk.stage.state.contacts import Contacts
from statwalk.stage.state.flights import Flights
from statwalk.stage.state.hashing import combine, text
from statwalk.stage.state.pending_events import Notice, PendingEvent


@dataclass(frozen=True, eq=False)
class StageState:
    """The state of a stage at a tick.

    To keep a state, keep a `copy()`: `advance` takes the state that it is passed over, and may write into its
    arrays.
    """

    tick: int = 0
    casts: Mapping[str, CastState] = field(default_factory=dict)
    """by role key (the role's name, or `name@version`), in the order of the keys"""
    next_id: int = 1
    names: Mapping[int, str] = field(default_factory=dict)
    """names of the actors, by id"""
    action_count: int = 0
    inbox: tuple[PendingEvent, ...] = ()
    """events that were touched or raised in this tick, and count in the next tick"""
    notices: tuple[Notice, ...] = ()
    """what an edit did to actors; delivered in the next tick"""
    contacts: Contacts = field(default_factory=Contacts)
    flights: Flights = ()
    versions: Mapping[str, str] = field(default_factory=dict)
    """the key of the version in force, by the name of each role that was ever used"""

    def find(self, actor: int) -> tuple[str, int] | None:
        """Returns the role key and the row of an actor, or None."""
        return next(((key, row) for key, cast in self.casts.items() if (row := cast.row(actor)) >= 0), None)

    @property
    def ids(self) -> list[int]:
        """The ids of all actors, ascending."""
        return sorted(int(actor) for cast in self.casts.values() for actor in cast.ids)

    @property
    def hash(self) -> str:
        """16 hexadecimal digits over the tick and the hashes of all actors, by id."""
        casts = self.casts.values()
        ids = np.concatenate([np.zeros(0, np.int64), *(cast.ids for cast in casts)])
        hashes = np.concatenate([np.zeros(0, np.uint64), *(cast.hash for cast in casts)])
        pairs = np.column_stack([ids.astype(np.uint64), hashes])[np.argsort(ids)]
        return text(combine([self.tick, *pairs.ravel().tolist()]))

    def copy(self) -> StageState:
        """Returns a copy whose casts share no memory."""
        return replace(self, casts={key: cast.copy() for key, cast in self.casts.items()})

    def only(self, key: str, row: int) -> StageState:
        """Returns the state with one of its actors only."""
        return replace(self, casts={key: self.casts[key].take(np.array([row]))})

    def with_casts(self, casts: Mapping[str, CastState]) -> StageState:
        """Returns the state with these casts instead, by key; casts without actors are left out."""
        return replace(self, casts={key: casts[key] for key in sorted(casts) if len(casts[key].ids)})
