"""A stage from outside: actors and their inputs."""

import numpy as np
import pytest
from builders import role
from statwalk.errors import StageError, UnknownNameError
from statwalk.stage.stage import Stage

ROLE = role()


def test_actors_come_in_the_order_of_their_ids():
    stage = Stage()
    first, second = stage.add(ROLE), stage.add(role(name="other"))
    third = stage.add(ROLE, name="Ada")
    assert stage.actors == [first, second, third]
    assert [actor.name for actor in stage.actors] == ["tiny 1", "other 2", "Ada"]


def test_an_actor_is_there_at_once():
    stage = Stage()
    actor = stage.add(ROLE, position=(1, 0, 2), heading=0.5)
    assert actor.root.position.tolist() == [1, 0, 2]
    assert actor.state == "STAND"


def test_an_actor_that_leaves_is_gone():
    stage = Stage()
    first, second = stage.add(ROLE), stage.add(ROLE)
    stage.remove(first)
    assert stage.actors == [second]
    with pytest.raises(UnknownNameError, match="no actor is called '1'"):
        first.state  # noqa: B018


def test_ids_are_not_given_twice():
    stage = Stage()
    stage.remove(stage.add(ROLE))
    assert stage.add(ROLE).id == 2


def test_each_actor_gets_its_own_events():
    stage = Stage()
    first, second = stage.add(ROLE), stage.add(ROLE)
    stage.send(second, "GO")
    stage.step()
    assert (first.state, second.state) == ("STAND", "WALK")


@pytest.mark.parametrize("event", ["GOO", "END", ""])
def test_an_unknown_event_lists_those_there_are(event):
    stage = Stage()
    actor = stage.add(ROLE)
    with pytest.raises(UnknownNameError, match="There are: GO, HOP, TURN, STOP"):
        stage.send(actor, event)


def test_an_unknown_parameter_lists_those_there_are():
    stage = Stage()
    with pytest.raises(UnknownNameError, match="did you mean pace"):
        stage.set(stage.add(ROLE), "pase", 1)


@pytest.mark.parametrize("value", [0.4, 2.1, float("nan")])
def test_a_parameter_keeps_its_range(value):
    stage = Stage()
    with pytest.raises(StageError, match=r"pace must lie in 0.5 … 2"):
        stage.set(stage.add(ROLE), "pace", value)


def test_a_place_must_be_finite():
    with pytest.raises(StageError, match="all finite"):
        Stage().add(ROLE, position=(0, float("inf"), 0))


def test_two_roles_of_one_name_are_refused():
    stage = Stage()
    stage.add(ROLE)
    with pytest.raises(StageError, match="another role"):
        stage.add(role())


def test_holding_repeats_until_release():
    stage = Stage()
    actor = stage.add(ROLE)
    stage.hold(actor, "TURN")
    stage.step(70)  # TURN ends after 60 ticks, STAND follows, and the held event takes it again
    assert actor.state == "TURN"
    stage.release(actor, "TURN")
    stage.step(70)
    assert actor.state == "STAND"


def test_parameters_of_many_are_set_each_for_its_own():
    stage = Stage()
    actors = [stage.add(ROLE) for _ in range(3)]
    for actor, pace in zip(actors, (0.5, 1.5, 2.0), strict=True):
        stage.send(actor, "GO")
        stage.set(actor, "pace", 1.0)
        stage.set(actor, "pace", pace)
    stage.step(25)
    assert [actor.time for actor in actors] == pytest.approx([24 / 60 * pace for pace in (0.5, 1.5, 2.0)])


def test_how_time_was_cut_makes_no_difference():
    hashes = set()
    for cuts in ([90], [1] * 90, [7, 53, 30]):
        stage = Stage()
        stage.send(stage.add(ROLE), "GO")
        for cut in cuts:
            stage.step(cut)
        hashes.add(stage.hash)
    assert len(hashes) == 1


def test_world_is_the_actors_place_times_the_pose():
    stage = Stage()
    actor = stage.add(ROLE, position=(1, 0, 2), heading=np.pi / 2)
    hips = actor.world[0]
    assert hips[:3, 3] == pytest.approx([1, 1, 2], abs=1e-6)
    assert hips[:3, 2] == pytest.approx(
        [1, 0, 0], abs=1e-6
    )  # its +Z now points along +X: a quarter turn to the left


def test_a_name_that_no_log_can_hold_is_refused():
    stage = Stage()
    with pytest.raises(StageError, match="half a character"):
        stage.add(ROLE, name="\ud800")
    assert stage.actors == []


def test_a_stage_prints_on_one_line():
    stage = Stage(seed=3)
    stage.add(role())
    stage.step(5)
    stage.seek(2)
    assert repr(stage) == "Stage(tick 2 of 5, 1 actors, seed 3)"
