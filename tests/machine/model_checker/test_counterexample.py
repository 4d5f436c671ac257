"""Every refutation carries what must come from outside, and whoever sends it from the beginning sees what the
refutation says.
"""

import random
from dataclasses import replace
from itertools import pairwise

import gaits
import pytest
from statwalk.character.role import facts_of
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.definition.machine_definition import PropertyDefinition
from statwalk.machine.verify import verify
from statwalk.services.library.load import load
from statwalk.stage.stage import Stage
from ticking import RATE, Ticking, text_of

TICKS = {"A": 12, "b": 7, "C": 9, "d": 5}
KINDS = ("", "", "", "-", "{}", "{}", "{}", "{}!", "{} at end", "{}! at end")


def random_table(chance):
    """Cells of all kinds, without conditions."""
    states = list(TICKS)
    rows = [
        " | ".join((state, *(chance.choice(KINDS).format(chance.choice(states)) for _ in range(3))))
        for state in states
    ]
    return "\n".join(("state | GO | RUN | HOP | END", *(f"{row} | {chance.choice(states)}" for row in rows)))


def answers(table, *sentences):
    """The findings about properties, in order."""
    facts = {name: MotionFacts(count / RATE) for name, count in TICKS.items()}
    definition = read_machine(f"{text_of(table, TICKS)}properties: {list(sentences)}\n")
    return [one for one in verify(definition, facts) if one.kind == "property"]


def steps_of(table, replay, more=0):
    """(from, to) of every event taken in a replay and so many ticks after it, ticks apart; a stay leads to
    the state itself.
    """
    actor, pressed = Ticking(table, TICKS), dict(replay)
    for tick in range(1, max(pressed, default=0) + more + 1):
        actor.step(*([pressed[tick]] if tick in pressed else []))
        states, taken = actor.machine.states, [one for one in actor.verdicts if one.verdict == "taken"]
        yield [
            (states[one.from_state], states[one.to_state if one.to_state >= 0 else one.from_state])
            for one in taken
        ]


@pytest.mark.parametrize("seed", range(25))
def test_what_never_happens_does_where_that_is_refuted(seed):
    chance = random.Random(seed)
    table = random_table(chance)
    here, there = chance.choices(list(TICKS), k=2)
    (found,) = answers(table, f"never {here} -> {there}")
    if "refuted" in found.message:
        assert any((here, there) in ticks for ticks in steps_of(table, found.replay, more=60))
    else:
        presses = [
            (tick, chance.choice(("GO", "RUN", "HOP"))) for tick in range(1, 900) if chance.random() < 0.2
        ]
        assert not any((here, there) in ticks for ticks in steps_of(table, presses))


@pytest.mark.parametrize("seed", range(25))
def test_a_state_comes_without_the_one_before_it_where_that_is_refuted(seed):
    chance = random.Random(seed)
    table = random_table(chance)
    goal, gate = chance.sample("bCd", 2)
    (found,) = answers(table, f"{goal} only after {gate}")
    presses = found.replay
    if "refuted" not in found.message:
        presses = [
            (tick, chance.choice(("GO", "RUN", "HOP"))) for tick in range(1, 900) if chance.random() < 0.2
        ]
    entered = [to for ticks in steps_of(table, presses, more=60) for here, to in ticks if to != here]
    came = entered.index(goal) if goal in entered else len(entered)
    is_without = goal in entered and gate not in entered[:came]
    assert is_without == ("refuted" in found.message)


@pytest.mark.parametrize("seed", range(25))
def test_an_event_does_not_lead_where_that_is_refuted(seed):
    chance = random.Random(seed)
    table = random_table(chance)
    start, goal = chance.sample("AbCd", 2)
    (found,) = answers(table, f"from {start}, GO reaches {goal} within 250 ms")
    if "refuted" in found.message:
        assert found.replay[-1][1] == "GO"
        ticks = list(steps_of(table, found.replay, more=15))
        pressed = found.replay[-1][0]
        state = next((to for taken in reversed(ticks[: pressed - 1]) for _, to in reversed(taken)), "A")
        assert state == start
        assert goal not in {to for taken in ticks[pressed - 1 :] for _, to in taken}


def without(states, before, after):
    """The states of a life up to the first of `after`, where none of them is `before`."""
    life = states[: states.index(after) + 1]
    return life if before not in life else []


SENTENCES = {
    "TLFT only after WALK": lambda states, _: without(states, "WALK", "TLFT"),
    "never STWK -> WALK": lambda states, _: ("STWK", "WALK") in pairwise(states),
    "JUMP leads to STAT within 1 s": lambda states, _: "STAT" not in states[states.index("JUMP") :][:60],
    "from WALK, STOP reaches STAT within 100 ms": lambda states, last: (
        states[last - 2] == "WALK" and "STAT" not in states[last - 1 :][:6]
    ),
}


@pytest.mark.parametrize(("sentence", "is_shown"), SENTENCES.items())
def test_on_a_stage_the_walker_does_what_refutes_the_sentence(sentence, is_shown):
    role = load("faq-walker")
    definition = replace(role.definition, properties=(PropertyDefinition(sentence, 0),))
    (found,) = (one for one in verify(definition, facts_of(role.character)) if one.kind == "property")
    assert "refuted" in found.message
    stage, pressed, states = Stage(), dict(found.replay), []
    actor = stage.add(role)
    last = max(pressed)
    for tick in range(1, last + 90):
        if tick in pressed:
            stage.send(actor, pressed[tick])
        stage.step()
        states.append(actor.state)
    assert is_shown(states, last)


@pytest.mark.parametrize(
    ("limit", "verdict"), [("0.79 s", "refuted"), ("0.81 s", "undecided"), ("1 s", "proved")]
)
def test_on_a_stage_a_blend_lasts_as_long_as_the_proof_says(limit, verdict):
    """Half way between a walk of 1 s and a run of 0.6 s, whose feet come down in another rhythm."""
    role = gaits.role(
        ("MOVE  |      | STAND | STAND |", "MOVE  |      | STAND | STAND | STAND"),
        ("default: 1.2, min: 0", "default: 2.6, min: 1.2"),
        ("run: {left: 0.2, right: 0.62}", "run: {left: 0, right: 0.5}"),
    )
    sentence = f"MOVE leads to STAND within {limit}"
    definition = replace(role.definition, properties=(PropertyDefinition(sentence, 0),))
    (found,) = (one for one in verify(definition, facts_of(role.character)) if one.kind == "property")
    assert found.message.startswith(f"{sentence}: {verdict}")
    stage, pressed = Stage(), dict(found.replay or ((1, "GO"),))
    actor, states = stage.add(role), []
    for tick in range(1, 60):
        if tick in pressed:
            stage.send(actor, pressed[tick])
        stage.step()
        states.append(actor.state)
    assert states.count("MOVE") == 48
