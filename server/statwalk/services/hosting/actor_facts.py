"""Reads the facts of actors: the arrays are copied while a stage stands still, the facts are made later."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.expressions import values_by_name
from statwalk.character.role import Role
from statwalk.machine.settings import values_of
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.random import Words
from statwalk.rig.limits import ClampedJoint
from statwalk.services.hosting.stage_replies import ActorFacts
from statwalk.stage.stage import Stage
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.hashing import text
from statwalk.stage.steps.expression_values import expression_values
from statwalk.stage.steps.limit_excess import clamped_joints
from statwalk.stage.steps.reached import reached_targets


class ActorColumns(NamedTuple):
    """n actors of one role, as arrays that no tick writes into; L layers."""

    role: Role
    names: Mapping[int, str]
    """by id"""
    ids: NDArray[np.int64]
    states: Ints
    """(n, L)"""
    times: Floats
    """(n,) seconds into the motion of the base layer"""
    positions: Floats
    """(n, 3)"""
    headings: Floats
    hashes: Words
    expressed: Floats
    """(n, F) what expressions set"""
    parameters: Floats
    """(n, P) as they are set"""
    clamped: list[tuple[ClampedJoint, ...]]
    solver_memory: Floats
    """(n, K)"""

    @classmethod
    def of(cls, cast: Cast, names: Mapping[int, str], rows: Ints, tick: int, dt: float) -> ActorColumns:
        """Returns the columns of some rows of a cast at a tick of `dt` seconds."""
        machine = cast.machine
        columns: tuple[Any, ...] = (cast.ids, machine.state, machine.time[:, 0])
        columns += cast.position, cast.heading, cast.hash
        clamped = clamped_joints(cast, rows, (tick, dt))
        copies: Any = (
            *(column[rows].copy() for column in columns),
            expression_values(cast, rows, tick, dt),
            machine.parameters[rows],
            clamped,
            cast.solver_memory[rows],
        )
        return cls(cast.role, names, *copies)

    def facts(self) -> Iterator[ActorFacts]:
        """Yields the facts of each actor."""
        machine = self.role.machine
        for actor, states, time, position, heading, hashed, values, numbers, clamped, reached in zip(
            *(column.tolist() for column in self[2:-2]),
            self.clamped,
            reached_targets(self.role, self.solver_memory),
            strict=True,
        ):
            names = tuple(machine.states[state] for state in states)
            yield ActorFacts(
                id=actor,
                name=self.names[actor],
                machine=self.role.name,
                state=names[0],
                states=names,
                time=time,
                position=tuple(position),
                heading=heading,
                hash=text(hashed),
                **values_by_name(self.role.expressions, values)._asdict(),
                parameters=values_of(machine, numbers),
                clamped=clamped,
                reached=reached,
            )


def columns_of(stage: Stage, actors: Iterable[int] | None = None) -> list[ActorColumns]:
    """Returns the columns of all actors at the playhead, or of some, by role; their facts can be made while
    the stage goes on.

    :raises UnknownNameError: when an actor does not exist.
    """
    names, tick, dt = stage.state.names, stage.tick, 1 / stage.rate
    if actors is None:
        return [ActorColumns.of(cast, names, np.arange(len(cast.ids)), tick, dt) for cast in stage.casts]
    wanted = np.array([stage.actor(actor).id for actor in actors], np.int64)
    rows = [(cast, np.flatnonzero(np.isin(cast.ids, wanted))) for cast in stage.casts]
    return [ActorColumns.of(cast, names, some, tick, dt) for cast, some in rows if len(some)]


def facts_in(columns: Iterable[ActorColumns]) -> Iterator[ActorFacts]:
    """Yields the facts of actors; by id within a role."""
    return (facts for cast in columns for facts in cast.facts())
