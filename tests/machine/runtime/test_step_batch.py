"""Laws over random tables and inputs: one actor is the same alone and in a batch, nothing is unbounded, and
no state is written into.
"""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from statwalk.machine.runtime.state import MOST_WAITING, MachineState, fresh
from statwalk.machine.runtime.surroundings import Inputs, Measurements
from ticking import machine_of, stepped, verdicts_of

ACTORS, TICKS = 4, 25
STATES = ("A", "B", "c", "d")
EVENTS = ("E0", "E1", "E2")
cell = st.sampled_from(
    ["", "-", *STATES, "A!", "c!", "B at end", "d at end", "A at end", "A! at end", "NONE"]
)
tables = st.lists(
    st.lists(cell, min_size=len(EVENTS) + 1, max_size=len(EVENTS) + 1),
    min_size=len(STATES),
    max_size=len(STATES),
)
durations = st.lists(st.sampled_from([0, 0.3, 1, 2.5, 4, 9]), min_size=len(STATES), max_size=len(STATES))
one_input = st.tuples(st.integers(0, ACTORS - 1), st.integers(0, len(EVENTS) - 1), st.integers(0, 2))
inputs = st.lists(st.lists(one_input, max_size=6), min_size=TICKS, max_size=TICKS)


def machine(table, ticks):
    rows = "\n".join(" | ".join((state, *row)) for state, row in zip(STATES, table, strict=True))
    text = "state | " + " | ".join(EVENTS) + " | END\n" + rows
    return machine_of(text, dict(zip(STATES, ticks, strict=True)), "idle: E0\nevents: {E2: {buffer: 0.1}}\n")


def inputs_for(entries) -> Inputs:
    return Inputs.of(*np.array(entries, np.int64).reshape(-1, 3).T)


def one_tick(made, state, tick, entries):
    return stepped(made.program, state, tick, inputs_for(entries), Measurements.none(len(state.state)))


def play(made, n, per_tick):
    """The results of all ticks, from the first on."""
    state, results = fresh(made.program, n), []
    for tick, entries in enumerate(per_tick, 1):
        results.append(one_tick(made, state, tick, entries))
        state = results[-1].state
    return results


def same(a: MachineState, b: MachineState) -> bool:
    return all(np.array_equal(one, other) for one, other in zip(a.arrays(), b.arrays(), strict=True))


@settings(deadline=None, max_examples=40)
@given(tables, durations, inputs)
def test_alone_and_in_a_batch(table, ticks, entries):
    made = machine(table, ticks)
    together = play(made, ACTORS, entries)
    for actor in range(ACTORS):
        alone = play(
            made, 1, [[(0, event, kind) for who, event, kind in now if who == actor] for now in entries]
        )
        for one, all_ in zip(alone, together, strict=True):
            assert same(one.state, all_.state.take(np.array([actor])))
            assert [v._replace(actor=actor) for v in verdicts_of(made, one)] == [
                v for v in verdicts_of(made, all_) if v.actor == actor
            ]


@settings(deadline=None, max_examples=40)
@given(tables, durations, inputs)
def test_bounds(table, ticks, entries):
    made = machine(table, ticks)
    for result in play(made, ACTORS, entries):
        assert np.bincount(result.changes.actor, minlength=1).max() <= 8
        count = (result.state.waiting_event >= 0).sum(-1)
        assert count.max() <= MOST_WAITING
        for queue in result.state.waiting_event[:, 0]:
            names = queue[queue >= 0]
            assert len(set(names.tolist())) == len(names)
        duration = made.duration[result.state.state]
        assert (result.state.time >= 0).all()
        assert (result.state.time <= duration).all()
        assert ((result.state.state >= 0) & (result.state.state < len(STATES))).all()


@settings(deadline=None, max_examples=30)
@given(tables, durations, inputs)
def test_nothing_is_written_into(table, ticks, entries):
    made = machine(table, ticks)
    state = fresh(made.program, ACTORS)
    for tick, now in enumerate(entries, 1):
        before = state.copy()
        after = one_tick(made, state, tick, now).state
        assert same(state, before)
        state = after


def test_actors_come_and_go():
    made = machine([["B", "", "", "A"]] * 4, [4] * 4)
    state = one_tick(made, fresh(made.program, 3), 1, [(1, 0, 0)]).state
    assert state.take(np.array([True, False, True])).state.tolist() == [[0], [0]]
    assert state.take(np.array([1, 2])).state.tolist() == [[1], [0]]
    assert same(state.take(np.array([0, 1])).append(state.take(np.array([2]))), state)
