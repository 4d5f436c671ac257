"""What machines remember, under another version of their table: layers, sub-machines, senses, parameters, the
queue.
"""

import numpy as np
import pytest
from playing import STATES, lived, role_of, text_of
from statwalk.machine.runtime.state import FOR_END, FOR_MOMENT, LOOK_UP
from statwalk.stage.migrate.map_states import remap

ARMS = """
layers:
  {name}:
    mask: [{joint}]
    initial: REST
    states: {{REST: {{motion: none}}, WAVE: {{motion: hop}}, POINT: {{motion: turn}}}}
    table: |
      state | WAVE  | END
      REST  | WAVE  |
      WAVE  | POINT | REST
      POINT |       | REST
"""
WITH_ARMS = text_of(more=ARMS.format(name="arms", joint="arm"))
FEWER = """
state | GO   | TURN | HOP
STAND | WALK | TURN | HOP
WALK  |      | TURN | HOP
HOP   |      |      |
TURN  |      |      |
"""
INNER = """
states:
  STAND: {motion: stand, loop: true}
  FIGHT:
    resume: true
    machine:
      initial: GUARD
      states: {GUARD: {motion: stand, loop: true}, HIT: {motion: walk, loop: true}}
      table: "state | GO\\nGUARD | HIT"
parameters: {pace: {default: 1, min: 0.5, max: 2}}
"""
INNER_TABLE = """
state | GO    | TURN  | HOP
STAND |       | FIGHT |
FIGHT |       |       | STAND
"""


def parts(stage):
    cast = stage.casts[0]
    return cast.role.machine, cast.machine


def test_a_new_layer_begins_in_its_initial_state():
    stage = lived(text_of(), "GO")
    stage.edit(role_of(WITH_ARMS))
    assert stage.actor(1).states == ("WALK", "REST")
    stage.send(1, "WAVE")
    stage.step()
    assert stage.actor(1).states == ("WALK", "WAVE")


def test_layers_keep_their_states_by_name_whatever_their_order():
    stage = lived(WITH_ARMS, "WAVE")
    stage.edit(
        role_of(
            text_of(
                more=ARMS.format(name="hips", joint="hips")
                + ARMS.format(name="arms", joint="arm").replace("layers:\n", "")
            )
        )
    )
    assert stage.actor(1).states == ("STAND", "REST", "WAVE")


def test_where_a_layer_that_is_shown_goes_nothing_jumps():
    stage = lived(WITH_ARMS, "WAVE", ticks=12)
    stage.edit(role_of(text_of()))
    shown = []
    for _ in range(20):
        shown.append(stage.actor(1).pose.rotation[2].copy())
        stage.step()
    assert np.abs(np.diff(shown, n=2, axis=0)).max() < 0.02


def test_a_motion_of_another_length_goes_on_at_its_phase():
    stage = lived(text_of(), "GO", ticks=16)
    stage.edit(role_of(text_of(states=STATES.replace("motion: walk", "motion: stand"))))
    assert stage.actor(1).time == pytest.approx(15 / 60 * 2)  # walk lasts a second, stand two


def test_the_inner_state_left_last_is_kept():
    text = text_of(INNER_TABLE, states=INNER)
    stage = lived(text, "TURN", "GO", "HOP")
    assert stage.actor(1).state == "STAND"
    stage.edit(role_of(text_of(INNER_TABLE + "FIGHT.GUARD | | | -\n", states=INNER)))
    stage.send(1, "TURN")
    stage.step()
    assert stage.actor(1).state == "FIGHT.HIT"


def test_a_sub_machine_that_is_renamed_keeps_the_inner_state_left_last():
    stage = lived(text_of(INNER_TABLE, states=INNER), "TURN", "GO", "HOP")
    renamed = [text.replace("FIGHT", "BOX") for text in (INNER_TABLE, INNER)]
    stage.edit(role_of(text_of(renamed[0], states=renamed[1])))
    stage.send(1, "TURN")
    stage.step()
    assert stage.actor(1).state == "BOX.HIT"


def test_an_inner_state_that_has_left_its_sub_machine_is_not_resumed():
    stage = lived(text_of(INNER_TABLE, states=INNER), "TURN", "GO", "HOP")
    fewer = INNER.replace(", HIT: {motion: walk, loop: true}", "").replace("GUARD | HIT", "GUARD |")
    outside = fewer.replace("  FIGHT:", "  HIT: {motion: walk, loop: true}\n  FIGHT:")
    stage.edit(role_of(text_of(INNER_TABLE, states=outside)))
    stage.send(1, "TURN")
    stage.step()
    assert stage.actor(1).state == "FIGHT.GUARD"


def test_a_sense_that_is_on_stays_on():
    sense = "senses: {{{}HOP: {{when: pace > 0.6}}}}\n"
    stage = lived(text_of(more=sense.format("")), "GO", ticks=40)
    machine, state = parts(stage)
    done = remap(
        machine, role_of(text_of(more=sense.format("TURN: {when: pace > 9}, "))).machine, state
    ).state
    assert done.sensing.tolist() == [[False, True]]


def test_what_waits_for_a_moment_of_the_old_table_is_looked_up_anew():
    stage = lived(
        text_of(more="cells:\n  WALK/HOP: {when: marker left-down}\n  WALK/STOP: {when: end}"),
        "GO",
        "HOP",
        "STOP",
    )
    machine, state = parts(stage)
    assert state.waiting_for[0, 0, :2].tolist() == [FOR_MOMENT, FOR_END]
    done = remap(machine, role_of(text_of()).machine, state).state
    assert (done.waiting_for[0, 0, :2].tolist(), done.waiting.tolist()) == ([LOOK_UP, LOOK_UP], [[2]])


def test_the_queue_closes_its_ranks_where_an_event_is_gone():
    stage = lived(
        text_of(more="cells:\n  WALK/HOP: {when: end}\n  WALK/STOP: {when: end}\n  WALK/TURN: {when: end}"),
        "GO",
        "HOP",
        "STOP",
        "TURN",
    )
    machine, state = parts(stage)
    fewer = role_of(text_of(FEWER)).machine
    done = remap(machine, fewer, state)
    assert [fewer.events[event] for event in done.state.waiting_event[0, 0, :2]] == ["HOP", "TURN"]
    assert [machine.events[event] for _, _, event in done.lost] == ["STOP"]


def test_a_value_set_before_the_edit_is_brought_into_the_new_bounds():
    stage = lived(text_of(), "GO")
    stage.set(1, "pace", 2.0)
    stage.edit(role_of(text_of(states=STATES.replace("max: 2}", "max: 1.25}"))))
    stage.step()
    assert parts(stage)[1].parameters[0, 0] == 1.25
