"""What breaks a property: the run that a search finds at a pace, and the ticks of an actor's life that show
it.
"""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from statwalk.machine.compile.machine import Machine
from statwalk.machine.model_checker.counterexample import Refuted, refuted, shown
from statwalk.machine.model_checker.played import Candidate, Life, Told
from statwalk.machine.model_checker.search import SearchStep
from statwalk.machine.model_checker.search_at_pace import Pace, TimedQuestion, steps_of
from statwalk.machine.model_checker.state_space import NOTHING

Broken = tuple[Candidate, Told]


def leading(machine: Machine, here: Collection[int], there: Collection[int]) -> Broken:
    """An event that is taken in one of the states `here` leads to one of `there`."""

    def candidate(pace: Pace) -> Life | None:
        search = pace.freely
        taken = search.space.taken
        to = np.where(taken[:, 2] < 0, taken[:, 1], taken[:, 2])
        leads = search.ticks_of(np.isin(taken[:, 1], list(here)) & np.isin(to, list(there)))
        pace.work.spend(search.work)
        ticks = search.shortest(leads, np.ones(len(search.start), bool))
        return None if ticks is None else steps_of(search, ticks)

    def told(life: Life) -> Refuted | None:
        for tick, step in enumerate(life, 1):
            if any(
                one.state in here and (one.to if one.to >= 0 else one.state) in there for one in step.taken
            ):
                return shown(machine, life[:tick])
        return None

    return candidate, told


def entered_before(machine: Machine, goals: Collection[int], gates: Collection[int]) -> Broken:
    """A goal is entered, and no gate before it."""
    shut = [gate for gate in gates if gate not in goals]

    def candidate(pace: Pace) -> Life | None:
        search = pace.freely
        if search.states[0] in goals:
            return ()
        pace.work.spend(search.work)
        ticks = search.shortest(search.entering_before(goals, shut), ~search.entering(shut))
        return None if ticks is None else steps_of(search, ticks)

    def told(life: Life) -> Refuted | None:
        for tick, step in enumerate(life, 1):
            for _, state in step.changes:
                if state in shut:
                    return None
                if state in goals:
                    return shown(machine, life[:tick])
        return None

    return candidate, told


def late(machine: Machine, question: TimedQuestion) -> Broken:
    """No goal is entered within the limit after an entry of the start, or after the event of a question."""
    start, goals, event, limit = question

    def candidate(pace: Pace) -> Life | None:
        answer = pace.answer(question)
        return answer.steps if answer.longest > limit else None

    def told(life: Life) -> Refuted | None:
        state = machine.initial
        if event == NOTHING and state in start and not _enters(life[:limit], goals):
            return refuted(machine, goals, (), life[:limit])
        for tick, step in enumerate(life[: len(life) - limit], 1):
            after = life[tick : tick + limit]
            if _begins(machine, question, state, step, after) and not _enters(after, goals):
                return refuted(machine, goals, life[:tick], after)
            state = step.changes[-1][1] if step.changes else state
        return None

    return candidate, told


def _enters(steps: Life, states: Collection[int]) -> bool:
    return any(state in states for step in steps for _, state in step.changes)


def _begins(machine: Machine, question: TimedQuestion, state: int, step: SearchStep, after: Life) -> bool:
    """Whether the time of a question begins in a tick of the actor that is in `state`, and no goal is entered
    in the same tick.
    """
    start, goals, event, _ = question
    entered = [one for _, one in step.changes]
    if event == NOTHING:
        since = next((place for place, one in enumerate(entered) if one in start), len(entered))
        return since < len(entered) and not set(entered[since:]) & set(goals)
    world = {NOTHING, *(sense.event for sense in machine.senses), *(touch.event for touch in machine.touches)}
    is_last = all(later.press in world for later in after)
    return state in start and step.press == event and is_last and not {state, *entered} & set(goals)
