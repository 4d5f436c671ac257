"""Machines drawn at random, with all that a file can say, and random logs with edits in them: what must be so
of every one of them.
"""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import slow_inertialize
import wild_machines
from playing import role_of
from statwalk.machine.runtime.surroundings import Inputs
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage
from statwalk.stage.state.commands import Hold, Press, Release, Set, Travel
from statwalk.stage.steps.input_batch import input_batch
from statwalk.stage.steps.memory import Memory
from statwalk.stage.tick import decide
from ticking import verdicts_of

SEEDS = (0, 2, 3, 6)
TICKS, EDITED = 50, 20
ACTORS = ("first", "second", "third")
CROWD = np.repeat(np.arange(len(ACTORS)), 5)
DT = 1 / 60


def text(seed, calm=False):
    return wild_machines.machine(seed, calm)


def command(kind, actor, name, value):
    kinds = {"press": Press, "hold": Hold, "release": Release, "travel": Travel}
    return Set(actor, name, value) if kind == "set" else kinds[kind](actor, name)


class Shown:
    """A tick as it was shown: the state, the casts with their role, what the tick brought about and what was
    sent for the next one.
    """

    def __init__(self, stage):
        self.hash, self.tick, self.verdicts = stage.hash, stage.tick, stage.effects.verdicts
        self.casts, self.inbox = stage.copy().casts, stage.state.inbox


def lived(seed, calm=False, ticks=TICKS, rate=60):
    """A stage, and its state at every tick."""
    stage = Stage(seed=seed, rate=rate)
    stage.add_many(role_of(text(seed, calm)), [((place / 2, 0, 0), place) for place in range(3)], ACTORS)
    states = [Shown(stage)]
    for tick, told in wild_machines.inputs(seed, ticks, len(ACTORS)).items():
        for kind, actor, name, value in told:
            stage.keep(tick + 1, command(kind, actor, name, value))
        if tick == EDITED:
            stage.edit(role_of(text(seed + 100, calm)), text(seed + 100, calm))
            states[-1] = Shown(stage)
        stage.step()
        states.append(Shown(stage))
    return stage, states


@pytest.fixture(scope="module", params=SEEDS)
def played(request):
    """Seed, stage and states."""
    return request.param, *lived(request.param)


def said_by_turn(state):
    """The verdicts of each actor and layer in a tick."""
    found = {}
    for one in state.verdicts:
        found.setdefault((one.actor, one.layer), []).append(one)
    return found.values()


def test_something_happens(played):
    _, stage, _ = played
    assert {"taken", "waits", "dropped"} == {one.verdict for one in stage.verdicts}
    assert sum(bool(one.to_state) for one in stage.verdicts) > 5


def test_a_replay_is_the_same(played):
    seed, stage, _ = played
    again = replay(stage.dump(), lambda name, said="": role_of(said or text(seed), name.partition("@")[0]))
    assert again.hash == stage.hash


def test_seeking_shows_what_was_shown(played):
    _, stage, states = played
    copy = stage.copy()
    for tick in (7, EDITED + 1, TICKS):
        copy.seek(0)
        copy.seek(tick)
        assert copy.hash == states[tick].hash


def test_a_fork_that_is_told_the_same_goes_the_same_way(played):
    _, stage, states = played
    fork = stage.fork_at(EDITED + 5)
    for tick in range(EDITED + 6, TICKS + 1):
        for sent in stage.commands(tick):
            fork.keep(tick, sent)
        fork.step()
        assert fork.hash == states[tick].hash


def test_all_is_finite(played):
    _, _, states = played
    for cast in (cast for state in states for cast in state.casts):
        assert all(
            np.isfinite(array).all()
            for array in (cast.shown.values, cast.position, cast.heading, cast.machine.time)
        )


def test_at_most_8_changes_a_tick(played):
    _, _, states = played
    for several in (several for state in states for several in said_by_turn(state)):
        assert (
            sum(one.verdict == "taken" and one.to_state != "" and one.event != "EDIT" for one in several) <= 8
        )


def test_end_comes_last(played):
    """After it only what it has brought about is told: what was waiting for the motion that it ended, and
    what is asked in its place.
    """
    _, _, states = played
    for several in (several for state in states for several in said_by_turn(state)):
        events = [one.event for one in several if "was left before" not in one.reason]
        first = events.index("END") if "END" in events else len(events)
        assert set(events[first:]) <= {"END", "GO"}


def stepped(played, rows):
    """For each tick the role, and what the machines do of actors by their rows (perhaps several times)."""
    seed, stage, states = played
    for state in states[:-1]:
        told = input_batch(state.casts[0], state.inbox, stage.commands(state.tick + 1), DT)
        cast = told.cast.take(rows)
        alone = replace(cast, machine=cast.machine.copy())
        yield (
            cast.role.machine,
            decide(
                alone, Memory(cast.role, len(rows)), for_rows(told.inputs, rows), DT, state.tick + 1, seed
            ),
        )


def for_rows(inputs, rows):
    """What is for an actor is for all rows that are it."""
    pairs = [
        (place, one) for one, actor in enumerate(inputs.actor) for place in np.flatnonzero(rows == actor)
    ]
    place, one = np.array(pairs, np.int64).reshape(-1, 2).T
    return Inputs.of(place, inputs.event[one], inputs.kind[one], inputs.other[one])


def bits(state):
    return [array.tobytes() for array in state.arrays()]


@pytest.mark.parametrize("actor", range(len(ACTORS)))
def test_an_actor_of_a_batch_is_as_it_is_alone(played, actor):
    for (machine, alone), (_, every) in zip(
        stepped(played, np.array([actor])), stepped(played, CROWD), strict=True
    ):
        row = 5 * actor + 2
        assert bits(alone.state) == bits(every.state.take(np.array([row])))
        said = [one for one in verdicts_of(machine, every) if one.actor == row]
        assert [one._replace(actor=row) for one in verdicts_of(machine, alone)] == said


@pytest.mark.parametrize("seed", SEEDS)
def test_nothing_jumps_where_nothing_is_cut(seed):
    """In 1/240 s no joint turns by 9°, and no actor goes 1 cm: clips swing by at most 5°, poses differ by up
    to 180°.
    """
    _, states = lived(seed, calm=True, ticks=120, rate=240)
    for one, other in ((one.casts[0], other.casts[0]) for one, other in pairwise(states)):
        assert np.abs(slow_inertialize.difference(other.shown.poses(), one.shown.poses())).max() < 0.15
        assert np.abs(other.position - one.position).max() < 0.01
