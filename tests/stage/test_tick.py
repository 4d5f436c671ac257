"""The tick, worked out by hand on the tiny character: 60 Hz, stand 2 s, walk 1 s (1.5 m), hop 0.5 s (0.4 m),
turn 1 s (90° to the left).
"""

import numpy as np
import pytest
from builders import CLIPS, role
from playing import role_of, text_of
from statwalk.machine.definition.cell_definition import CellDefinition
from statwalk.stage.stage import Stage

DT = 1 / 60


def stage_with(**options):
    stage = Stage()
    return stage, stage.add(role(**options))


def test_time_runs_in_the_motion():
    stage, actor = stage_with()
    stage.step(30)
    assert actor.time == pytest.approx(0.5)


def test_the_pose_is_the_motions():
    stage, actor = stage_with()
    stage.step(30)
    assert actor.pose.rotation[2] == pytest.approx(CLIPS["stand"].sample(0.5).rotation[2], abs=1e-6)


def test_an_input_counts_in_the_next_tick():
    stage, actor = stage_with()
    stage.send(actor, "GO")
    assert actor.state == "STAND"
    stage.step()
    assert actor.state == "WALK"


def test_the_new_motion_starts_in_the_tick_of_its_event():
    stage, actor = stage_with()
    stage.send(actor, "GO")
    stage.step()
    assert actor.time == 0
    stage.step()
    assert actor.time == pytest.approx(DT)


def test_a_transition_is_over_after_its_blend():
    stage, actor = stage_with()
    stage.step(25)
    stage.send(actor, "GO")
    stage.step(12)  # 0.2 s: the twelfth tick is the last
    assert actor.pose.rotation[2] == pytest.approx(CLIPS["walk"].sample(11 * DT).rotation[2], abs=1e-6)
    assert not stage.frame.casts[0].blend.any()


def test_blend_counts_down_evenly():
    stage, actor = stage_with()
    stage.send(actor, "GO")
    left = []
    for _ in range(12):
        stage.step()
        left.append(stage.frame.casts[0].blend[0, 0])
    assert left == pytest.approx(1 - np.arange(1, 13) / 12)


def test_without_blend_the_new_motion_is_shown_at_once():
    cut = {("STAND", "GO"): CellDefinition("WALK", 1, blend=0.0)}
    stage, actor = stage_with(cells=cut)
    stage.step(25)
    stage.send(actor, "GO")
    stage.step()
    assert actor.pose.rotation[2] == pytest.approx(CLIPS["walk"].sample(0).rotation[2], abs=1e-6)


def test_time_left_after_end_goes_into_the_motion_that_follows():
    stage = Stage(rate=7)
    actor = stage.add(role())
    stage.send(actor, "HOP")
    stage.step(5)  # HOP at 0; 4/7 s later it has been over for 4/7 − 0.5 s
    assert actor.state == "STAND"
    assert actor.time == pytest.approx(4 / 7 - 0.5)


def test_the_root_goes_the_way_of_the_time_left_after_end_once_also_through_a_loops_seam():
    """Ticks of 0.25 s: A, at 0.9, is at 0.9 s after four and ends 0.1 s on in its motion; 0.125 s of it are
    left, 0.1389 s of the tick, so that B goes from 0.8 through its end to 0.0778 s. 1.5 m a second.
    """
    walks = "motion: walk, loop: true"
    states = f"states:\n  A: {{{walks}, speed: 0.9}}\n  B: {{{walks}, speed: 2}}\n"
    cells = "cells: {A/END: {to: B, enter: 0.8, blend: 0}}"
    stage = Stage(rate=4)
    actor = stage.add(role_of(text_of("state | END\nA |\nB |", cells, states, "A")))
    stage.step(4)
    before = actor.root.position[2]
    stage.step()
    left = 0.125 / 0.9 * 2
    assert (actor.state, actor.time) == ("B", pytest.approx(0.8 + left - 1))
    assert actor.root.position[2] - before == pytest.approx(1.5 * (0.1 + left), abs=1e-6)


def test_a_walk_goes_on_through_its_loop():
    stage, actor = stage_with()
    stage.send(actor, "GO")
    stage.step(61)
    start = actor.root.position[2]
    stage.step(90)
    assert actor.root.position[2] - start == pytest.approx(2.25, abs=1e-6)


def test_the_roots_velocity_blends():
    """While it blends, the way of a tick grows by the smoothstep of the part that has passed."""
    stage, actor = stage_with()
    stage.step(3)
    stage.send(actor, "GO")
    places = []
    for _ in range(14):
        places.append(actor.root.position[2])
        stage.step()
    part = np.arange(2, 13) / 12
    assert np.diff(places)[1:12] == pytest.approx(1.5 * DT * part * part * (3 - 2 * part), abs=1e-7)


def test_a_turn_changes_the_heading_and_the_walk_follows_it():
    stage, actor = stage_with()
    stage.send(actor, "TURN")
    stage.step(121)
    assert actor.root.heading == pytest.approx(np.pi / 2, abs=0.02)
    before = actor.root.position
    stage.send(actor, "GO")
    stage.step(60)
    way = actor.root.position - before
    assert way[0] > 1
    assert abs(way[2]) < 0.05


def test_an_actor_that_faces_elsewhere_goes_there():
    stage = Stage()
    actor = stage.add(role(), position=(1, 0, 2), heading=np.pi)
    stage.send(actor, "GO")
    stage.step(60)
    assert actor.root.position[0] == pytest.approx(1, abs=1e-9)
    assert actor.root.position[2] < 1


def test_restart_begins_the_motion_again():
    stage, actor = stage_with()
    stage.send(actor, "HOP")
    stage.step(10)
    stage.send(actor, "HOP")
    stage.step()
    assert (actor.state, actor.time) == ("HOP", 0)


def test_stay_goes_on():
    stage, actor = stage_with()
    stage.send(actor, "GO")
    stage.step(10)
    stage.send(actor, "GO")
    stage.step()
    assert actor.time == pytest.approx(10 * DT)


def test_a_parameter_is_the_speed():
    stage, actor = stage_with()
    stage.send(actor, "GO")
    stage.set(actor, "pace", 2.0)
    stage.step(13)
    start = actor.root.position[2]
    stage.step(30)
    assert actor.root.position[2] - start == pytest.approx(1.5, abs=1e-6)


def test_without_a_root_joint_the_pose_moves_and_the_actor_stays():
    stage, actor = stage_with(root=None)
    stage.send(actor, "GO")
    stage.step(31)
    assert not actor.root.position.any()
    assert actor.pose.translation[0, 2] == pytest.approx(0.75, abs=1e-4)


def test_a_looping_motion_left_at_its_end_has_gone_its_way_once():
    """At 7 Hz and twice the speed the walk is over in the middle of a tick; what is left of the tick belongs
    to standing.
    """
    once = {
        ("STAND", "GO"): CellDefinition("WALK", 1, blend=0.0),
        ("WALK", "END"): CellDefinition("STAND", 1, blend=0.0),
    }
    stage = Stage(rate=7)
    actor = stage.add(role(cells=once))
    stage.set(actor, "pace", 2.0)
    stage.send(actor, "GO")
    stage.step(6)
    assert actor.state == "STAND"
    assert actor.root.position[2] == pytest.approx(1.5, abs=1e-6)


def test_a_motion_entered_at_a_phase_goes_no_further_than_its_ticks():
    """Half of the walk is skipped, and half of its way with it."""
    stage, actor = stage_with(cells={("STAND", "GO"): CellDefinition("WALK", 1, blend=0.0, enter=0.5)})
    stage.send(actor, "GO")
    stage.step(13)
    assert actor.time == pytest.approx(0.5 + 12 * DT)
    assert actor.root.position[2] == pytest.approx(1.5 * 12 * DT, abs=1e-6)


def test_time_left_after_end_goes_on_from_the_phase_that_is_entered():
    """At 7 Hz a hop of 0.5 s leaves 1/14 s of its last tick to the walk, which is entered a twentieth before
    its end and wraps.
    """
    cells = {
        ("HOP", "END"): CellDefinition("WALK", 1, blend=0.0, enter=0.95),
        ("STAND", "HOP"): CellDefinition("HOP", 1, blend=0.0),
    }
    stage = Stage(rate=7)
    actor = stage.add(role(cells=cells))
    stage.send(actor, "HOP")
    stage.step(5)
    assert actor.time == pytest.approx(0.95 + 1 / 14 - 1)
    assert actor.root.position[2] == pytest.approx(0.4 + 1.5 / 14, abs=1e-6)
