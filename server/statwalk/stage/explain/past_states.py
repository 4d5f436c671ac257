"""The states around the tick of a question, each computed once for all trials."""

from __future__ import annotations

from statwalk.errors import UnknownNameError
from statwalk.stage.explain.influencing_actors import InfluencingActors
from statwalk.stage.stage import Stage
from statwalk.stage.state.stage_state import StageState

EARLIEST_S = 1.0
"""seconds before the tick of the question that are searched"""


class PastStates:
    """States of a stage along its log, with one of its actors and the actors that can influence it.

    :raises UnknownNameError: when the actor does not exist in the tick before `tick`.
    """

    def __init__(self, stage: Stage, actor: int, tick: int) -> None:
        self.stage, self.actor, self.tick = stage, actor, tick
        self.first = max(tick - 1 - round(EARLIEST_S * stage.rate), stage.first)
        self.influences = InfluencingActors(stage.roles, actor, _role_name(stage, actor, tick))
        self._states: dict[int, StageState] = {}
        if self.look_at(tick - 1).find(actor) is None:
            raise _no_such_actor(stage, actor, tick)

    def at(self, tick: int) -> StageState:
        """Returns a copy of the state of a tick."""
        return self.look_at(tick).copy()

    def look_at(self, tick: int) -> StageState:
        """Returns the state of a tick, which must not be stepped."""
        if tick not in self._states:
            state = self.influences.only(self.stage.state_before(min(tick, self.first)))
            while state.tick < tick:
                if state.tick >= self.first:
                    self.keep(state)
                state, _ = self.stage.after(state)
            self._states[tick] = state
        return self._states[tick]

    def keep(self, state: StageState) -> None:
        """Keeps a copy of a state that was reached along the log."""
        self._states[state.tick] = state.copy()

    def fork(self, tick: int) -> Stage:
        """Returns an independent stage that goes on from the state of a tick."""
        return self.stage.fork_from(self.at(tick))


def _role_name(stage: Stage, actor: int, tick: int) -> str:
    if arrival := stage.arrivals().get(actor):
        return stage.roles[arrival.role].name
    raise _no_such_actor(stage, actor, tick)


def _no_such_actor(stage: Stage, actor: int, tick: int) -> UnknownNameError:
    return UnknownNameError("actor", str(actor), map(str, stage.state_at(tick - 1).ids))
