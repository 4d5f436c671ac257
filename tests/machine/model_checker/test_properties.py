"""Sentences about a table: proved, refuted with a way that can be tried, undecided, or not understood."""

import pytest
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.model_checker.properties import FORMS
from statwalk.machine.verify import verify
from ticking import Ticking, text_of

TABLE = (
    "state | GO | LEFT | END\nSTAT | WALK | TURN |\nWALK | JUMP | TURN | STAT\nTURN | | | STAT\n"
    "JUMP | | | FLY\nFLY | | | STAT"
)
TICKS = dict.fromkeys(("STAT", "WALK", "TURN", "JUMP", "FLY"), 9)


def answer(sentence):
    definition = read_machine(text_of(TABLE, TICKS, f"properties: [{sentence!r}]\n"))
    return next(
        (one.severity, one.message.removeprefix(f"{sentence}: "))
        for one in verify(definition)
        if one.kind == "property"
    )


@pytest.mark.parametrize(
    "sentence",
    [
        "JUMP only after WALK",
        "FLY only after JUMP",
        "FLY only after WALK",
        "never FLY -> WALK",
        "WALK only after WALK",
    ],
)
def test_proved(sentence):
    assert answer(sentence) == ("info", "proved")


def test_refuted_with_a_shortest_way():
    assert answer("TURN only after WALK") == ("error", "refuted: STAT -LEFT-> TURN")
    assert answer("never JUMP -> FLY") == ("error", "refuted: STAT -GO-> WALK -GO-> JUMP -END-> FLY")


def test_the_counterexample_can_be_replayed():
    actor = Ticking(TABLE, TICKS)
    assert actor.step("LEFT") == "TURN"


@pytest.mark.parametrize(
    ("sentence", "severity", "message"),
    [
        (
            "JUMP leads to STAT within 4 s",
            "warning",
            "undecided: how long the motions last is not known here",
        ),
        ("WALL only after STAT", "error", "not understood: no state is called 'WALL'; did you mean WALK?"),
        (
            "from STAT, GOO reaches FLY within 2 s",
            "error",
            "not understood: no event is called 'GOO'; did you mean GO?",
        ),
        ("it looks good", "error", f"not understood: a property reads {FORMS}"),
    ],
)
def test_without_an_answer_the_reason(sentence, severity, message):
    assert answer(sentence) == (severity, message)
