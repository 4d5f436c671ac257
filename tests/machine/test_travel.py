"""Ways through a table, worked out by hand; motions of 60 ticks take a second."""

from __future__ import annotations

import numpy as np
import pytest
from statwalk.machine.travel import events_towards, plan, reachable
from ticking import machine_of

TABLE = """
state | GO | RUN | JUMP | STOP | END
STAT  | STWK |  |      |      |
STWK  |      |  |      |      | WALK
WALK  |      | RUN at end | JUMP at foot | CSTP |
RUN   |      |  |      | CSTP |
JUMP  |      |  |      |      | WALK
CSTP  |      |  |      |      | STAT
"""
TICKS = {"STAT": 60, "STWK": 30, "WALK": 60, "RUN": 60, "JUMP": 60, "CSTP": 30}


@pytest.fixture
def machine():
    return machine_of(TABLE, TICKS, markers={"WALK": {"foot": 15}})


def row(machine, name):
    return machine.states.index(name)


def way(machine, start, goal):
    found = plan(machine, row(machine, start), row(machine, goal))
    return found and [(step.state, step.event) for step in found.steps]


def test_through_the_ends_of_motions(machine):
    assert way(machine, "STAT", "JUMP") == [("STAT", "GO"), ("STWK", "END"), ("WALK", "JUMP")]


def test_how_long_it_takes(machine):
    found = plan(machine, row(machine, "STAT"), row(machine, "JUMP"))
    assert [step.seconds for step in found.steps] == pytest.approx([1 / 60, 30 / 60, 15 / 60])


def test_the_end_is_waited_for(machine):
    assert plan(machine, row(machine, "WALK"), row(machine, "RUN")).seconds == pytest.approx(1.0)


def test_one_is_there(machine):
    assert way(machine, "WALK", "WALK") == []


def test_no_way():
    lost = machine_of("state | GO\nA | B\nB |\n", {"A": 60, "B": 60})
    assert (way(lost, "B", "A"), reachable(lost, row(lost, "B"))) == (None, ["B"])


def test_every_state_knows_its_first_step(machine):
    events = events_towards(machine, row(machine, "STAT"))
    assert [machine.events[event] if event >= 0 else "" for event in events] == [
        "",
        "END",
        "STOP",
        "STOP",
        "END",
        "END",
    ]


def test_the_sooner_of_two_ways():
    machine = machine_of(
        "state | SLOW | QUICK | END\nA | B at end | C |\nB | | |\nC | | | B\n", {"A": 60, "B": 60, "C": 30}
    )
    assert way(machine, "A", "B") == [("A", "QUICK"), ("C", "END")]


def test_what_is_drawn_seldom_takes_many_tries():
    machine = machine_of(
        "state | DRAW\nA |\nB |\nC |\n",
        {"A": 60, "B": 60, "C": 60},
        "cells: {A/DRAW: {to: {B: 9, C: 1}, when: end}}",
    )
    assert [plan(machine, 0, row(machine, name)).seconds for name in "BC"] == pytest.approx([10 / 9, 10])


def test_following_it_arrives(machine):
    events = events_towards(machine, row(machine, "RUN"))
    assert np.flatnonzero(events < 0).tolist() == [row(machine, "RUN")]
