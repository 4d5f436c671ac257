"""The laws of batches over a machine with everything: layers, conditions, chance, markers, windows, senses,
history, smooth parameters.
"""

import numpy as np
import pytest
from hypothesis import given as whatever
from hypothesis import settings
from hypothesis import strategies as st
from statwalk.machine.runtime.state import MOST_WAITING, MachineState, fresh
from statwalk.machine.runtime.surroundings import Inputs, Measurements
from ticking import DT, actions_of, built, stepped, verdicts_of

ACTORS, TICKS = 4, 30
ROWS = list(range(20))
"""five of each actor: so many that those who are alike are found"""
FILE = """
character: c.glb
initial: walk
idle: E3
states:
  walk: {motion: walk, loop: true, speed: pace}
  HOP: {motion: hop}
  FIGHT:
    resume: true
    machine:
      initial: a
      states:
        a: {motion: walk, loop: true}
        B: {motion: hop, final: true}
      table: |
        state | E0 | E1 | END
        a | B at left | |
        B | a | B! |
table: |
  state | E0 | E1 | E2 | E3 | left | END
  walk | | HOP at left | FIGHT | | |
  HOP | HOP! at end | | FIGHT | walk | | walk
  FIGHT | | | walk | | walk | HOP
cells:
  walk/E0: [{if: pace > 1 and phase > 0.3, to: HOP, enter: 0.5}, {if: time > 0.1, to: walk, action: nod}]
  walk/E3: {walk: 3, HOP: 1}
  HOP/E1: {to: walk, when: window 0.8..0.2, enter: match, action: 'raise(E0, other)'}
  HOP/END: [{if: pace < 1.5, to: walk}]
parameters: {pace: {default: 1, min: 0, max: 3, smooth: 0.1}}
senses:
  E2: {when: speed > 0.5 and pace > 1.2, release: pace < 1}
layers:
  arms:
    initial: REST
    states: {REST: {motion: none}, WAVE: {motion: hop}}
    table: |
      state | E0 | E3 | END
      REST | WAVE | |
      WAVE | | REST at end | REST
"""
DURATIONS = {"walk": 7.5, "hop": 4}
one_input = st.tuples(st.integers(0, ACTORS - 1), st.integers(0, 5), st.integers(0, 5), st.integers(-1, 4))
inputs = st.lists(st.lists(one_input, max_size=5), min_size=TICKS, max_size=TICKS)
paces = st.lists(
    st.tuples(st.integers(0, ACTORS - 1), st.sampled_from([0.0, 0.9, 1.1, 3.0])),
    min_size=TICKS,
    max_size=TICKS,
)


@pytest.fixture(scope="module")
def machine():
    return built(FILE, DURATIONS, {"walk": {"left": 3}, "hop": {"left": 1}})


def around(rows):
    """Speeds and chance of the rows."""
    numbers = np.array(rows)
    speed = numbers % ACTORS * 0.3
    return Measurements(np.array([speed, 0 * speed, 0 * speed]), (numbers % 7 + 99).astype(np.uint64))


def begin(machine, rows):
    """Each a little further in its motions than the one before."""
    return fresh(machine.program, len(rows))._replace(
        time=np.repeat(np.array(rows)[:, None] * DT / 50, 2, axis=1)
    )


def given(rows, entries):
    """What is for an actor is for all rows that are it."""
    found = [
        (place, *rest) for actor, *rest in entries for place, row in enumerate(rows) if row % ACTORS == actor
    ]
    return Inputs.of(*np.array(found, np.int64).reshape(-1, 4).T)


def with_pace(rows, state, who, pace):
    parameters = state.parameters.copy()
    parameters[np.array(rows) % ACTORS == who, 0] = pace
    return state._replace(parameters=parameters)


def play(machine, rows, per_tick, paces):
    """The results of all ticks for some rows; row r is actor r % ACTORS."""
    state, results = begin(machine, rows), []
    for tick, (entries, (who, pace)) in enumerate(zip(per_tick, paces, strict=True), 1):
        results.append(
            stepped(
                machine.program, with_pace(rows, state, who, pace), tick, given(rows, entries), around(rows)
            )
        )
        state = results[-1].state
    return results


def same(one: MachineState, other: MachineState) -> bool:
    return all(
        first.tobytes() == second.tobytes()
        for first, second in zip(one.arrays(), other.arrays(), strict=True)
    )


@settings(deadline=None, max_examples=20)
@whatever(inputs=inputs, paces=paces)
def test_alone_and_in_a_batch(machine, inputs, paces):
    together = play(machine, ROWS, inputs, paces)
    for actor in (0, 5, 10, 19):
        for one, every in zip(play(machine, [actor], inputs, paces), together, strict=True):
            assert same(one.state, every.state.take(np.array([actor])))
            said, did = verdicts_of(machine, every), actions_of(machine, every)
            assert [one._replace(actor=actor) for one in verdicts_of(machine, one)] == [
                one for one in said if one.actor == actor
            ]
            assert [one._replace(actor=actor) for one in actions_of(machine, one)] == [
                one for one in did if one.actor == actor
            ]


@settings(deadline=None, max_examples=20)
@whatever(inputs=inputs, paces=paces)
def test_bounds_of_the_whole(machine, inputs, paces):
    for result in play(machine, ROWS, inputs, paces):
        state, changes = result.state, result.changes
        assert np.bincount(changes.actor * 2 + changes.layer, minlength=1).max() <= 8
        assert (state.waiting_event >= 0).sum(-1).max() <= MOST_WAITING
        assert (machine.layer_of[state.state] == [0, 1]).all()
        assert (state.time >= 0).all()
        assert (state.time <= machine.duration[state.state]).all()
        assert ((state.smoothed >= 0) & (state.smoothed <= 3)).all()
        assert (state.waiting == (state.waiting_event >= 0).sum(-1)).all()


@settings(deadline=None, max_examples=10)
@whatever(inputs=inputs, paces=paces)
def test_nothing_is_written_into(machine, inputs, paces):
    state = begin(machine, ROWS)
    for tick, entries in enumerate(inputs, 1):
        before = state.copy()
        after = stepped(machine.program, state, tick, given(ROWS, entries), around(ROWS)).state
        assert same(state, before)
        state = after
