"""What refutes a property of a shipped machine goes so on a stage: its inputs, played on a fresh one, end in
the violation.
"""

from dataclasses import replace
from itertools import pairwise

import pytest
from statwalk.machine.compile.link import landings
from statwalk.machine.definition.machine_definition import PropertyDefinition
from statwalk.services.library.load import load
from statwalk.stage.stage import Stage
from statwalk.stage.verified import verified


def asked(name, sentences):
    """The answers to sentences about a shipped machine."""
    role = load(name)
    properties = tuple(PropertyDefinition(sentence, 0) for sentence in sentences)
    found = verified(replace(role, definition=replace(role.definition, properties=properties)))
    return role, [one for one in found if one.kind == "property"]


def life(role, found):
    """The states of an actor, tick by tick from before the first, while a stage plays a replay."""
    stage, pressed = Stage(), dict(found.replay)
    actor = stage.add(role)
    states = [actor.state]
    for tick in range(1, found.ticks + 1):
        if tick in pressed:
            stage.send(actor, pressed[tick])
        stage.step()
        states.append(actor.state)
    return states


def edges(role):
    """(from, to) of the cells of the base that change the state, as written."""
    machine = role.machine
    base = len(machine.rows(0))
    return dict.fromkeys(
        (machine.states[row], machine.states[to])
        for (row, _), alternatives in machine.alternatives.items()
        for alternative in alternatives
        for to in landings(machine, alternative)
        if row < base and row != to
    )


@pytest.mark.parametrize("name", ["faq-walker", "biceps", "principles", "tree"])
def test_a_step_that_is_forbidden_is_made_in_the_tick_that_is_named(name):
    steps = list(edges(load(name)))[:12]
    role, answers = asked(name, [f"never {here} -> {there}" for here, there in steps])
    shown = [(step, found) for step, found in zip(steps, answers, strict=True) if found.replay]
    for step, found in shown:
        states = life(role, found)
        assert step in pairwise(states)
        assert states[-1] == step[1]
    assert len(shown) >= len(steps) // 2
    assert all("undecided" in one.message or "will not" in one.message for one in answers if not one.replay)


def test_the_walkers_turn_lasts_as_long_as_on_the_stage():
    """On the spot the turn takes 61 ticks; with the most that `entry speed` allows it would take 64."""
    role, (found,) = asked("faq-walker", ["never WALK -> JUMP"])
    assert "refuted: STAT -" in found.message
    assert life(role, found)[-2:] == ["WALK", "JUMP"]


def test_what_takes_too_long_takes_too_long_on_the_stage():
    role, (leads, reaches) = asked(
        "faq-walker", ["TLFT leads to STAT within 1.2 s", "from WALK, STOP reaches STAT within 500 ms"]
    )
    states = life(role, leads)
    assert "STAT" not in states[states.index("TLFT") :]
    assert len(states[states.index("TLFT") :]) == 73
    states = life(role, reaches)
    assert (reaches.replay[-1], states[-31]) == ((reaches.ticks - 30, "STOP"), states[-31])
    assert states[-32] == "WALK"
    assert "STAT" not in states[-31:]
