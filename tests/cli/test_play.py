"""`statwalk play` from the user's side: what changed when, and a hash that the same inputs always give."""

import pytest
from command_line import Ended, statwalk


def play(*arguments: str) -> Ended:
    return statwalk("play", *arguments)


def test_the_states_that_the_events_lead_through() -> None:
    told = play("faq-walker", "--events", "0:FORWARD 2:STOP", "--seconds", "4").stdout
    states = [word for word in told.split() if word in ("STAT", "STWK", "WALK", "CSTP")]
    assert states[:4] == ["STWK", "WALK", "CSTP", "STAT"]
    assert "after 240 ticks" in told


def test_the_same_inputs_give_the_same_output() -> None:
    asked = ("faq-walker", "--events", "0:+LEFT 1:-LEFT", "--seconds", "2", "--every-tick")
    first, second = play(*asked), play(*asked)
    assert first.stdout == second.stdout
    assert len(first.stdout.splitlines()) == 122


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("nobody",), "faq-walker"),
        (("faq-walker", "--events", "0:DANCE"), "FORWARD"),
        (("faq-walker", "--events", "now"), "SECONDS:EVENT"),
    ],
)
def test_what_does_not_exist_is_named(arguments: tuple[str, ...], said: str) -> None:
    ended = play(*arguments)
    assert ended.returncode == 2
    assert said in ended.stderr


def test_a_journey_is_followed() -> None:
    told = play("faq-walker", "--events", "0:@JUMP", "--seconds", "3").stdout
    states = [word for word in told.split() if word in ("TLFT", "WALK", "JUMP", "FLY")]
    assert states[-3:] == ["WALK", "JUMP", "FLY"]


def test_why_says_what_became_of_every_event() -> None:
    told = play("faq-walker", "--events", "0:JUMP", "--seconds", "0.1", "--why").stdout
    assert "     1  JUMP dropped in STAT: the cell is -" in told


def test_a_parameter_that_the_machine_has_not_is_named() -> None:
    ended = play("faq-walker", "--events", "0:pace=2")
    assert (ended.returncode, "pace" in ended.stderr) == (2, True)


def test_a_scene_is_played_and_its_deeds_are_told() -> None:
    told = play("playground", "--events", "0:+FORWARD", "--seconds", "3").stdout
    assert "coin 1: collect(coin)" in told
    assert "door: open(door)" in told
