"""What is the same in two versions of a machine, and which state another name means."""

import pytest
from playing import STATES, TABLE, lived, role_of, text_of
from statwalk.stage.migrate.match_states import is_same


def test_machines_that_differ_in_their_lines_alone_are_the_same():
    plain, commented = (role_of(text).machine for text in (text_of(), "# a word\n\n" + text_of()))
    assert is_same(plain, commented)


@pytest.mark.parametrize(
    "more",
    [
        "cells:\n  STAND/GO: {blend: 0.3}",
        "cells:\n  STAND/GO: {when: end}",
        'cells:\n  STAND/GO: [{if: "pace > 1", to: WALK}]',
        "cells:\n  STAND/GO: {action: sing}",
        "senses: {GO: {when: pace > 1}}",
    ],
)
def test_machines_that_do_something_else_are_not(more):
    assert not is_same(role_of(text_of()).machine, role_of(text_of(more=more)).machine)


INSIDE = """
states:
  STAND: {motion: stand, loop: true}
  GAIT:
    machine:
      initial: STRIDE
      states: {STRIDE: {motion: walk, loop: true, speed: pace, markers: {left-down: 0.5}}}
      table: "state | GO\\nSTRIDE | -"
parameters: {pace: {default: 1, min: 0.5, max: 2}}
"""
INSIDE_TABLE = """
state | GO   | HOP | TURN | STOP
STAND | GAIT |     |      | -
GAIT  |      |     |      | STAND
"""
RENAMED = text_of().replace("WALK", "STROLL")
NESTED = text_of(INSIDE_TABLE, states=INSIDE)


@pytest.mark.parametrize(("text", "state"), [(RENAMED, "STROLL"), (NESTED, "GAIT.STRIDE")])
def test_in_a_state_with_another_name_an_actor_goes_on_to_the_bit(text, state):
    stage = lived(text_of(), "GO", ticks=20)
    plain = stage.fork()
    stage.edit(role_of(text))
    for each in (stage, plain):
        each.step(30)
    assert stage.actor(1).state == state
    assert all(
        (one == other).all() for one, other in zip(stage.actor(1).pose, plain.actor(1).pose, strict=True)
    )


def test_who_is_in_a_state_with_another_name_hears_of_it():
    stage = lived(text_of(), "GO", ticks=20)
    stage.edit(role_of(RENAMED))
    stage.step()
    assert [one[3:8] for one in stage.frame.verdicts] == [
        ("EDIT", "taken", "the edit calls WALK STROLL", "WALK", "STROLL")
    ]


MARCH = "  MARCH: {motion: walk, loop: true}\n  HOP:"
TWO = text_of(TABLE + "MARCH | STAND |  |  | | \n", states=STATES.replace("  HOP:", MARCH))


@pytest.mark.parametrize(("before", "after"), [(text_of(), TWO), (TWO, text_of())])
def test_with_two_states_of_its_motion_a_state_that_is_gone_is_none_of_them(before, after):
    """Two come where one goes, or one where two go."""
    stage = lived(before, "GO", ticks=20)
    stage.edit(role_of(after.replace("WALK", "STROLL").replace("MARCH", "PACE")))
    assert stage.actor(1).state == "STAND"
