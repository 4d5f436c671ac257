"""A stage from outside: actors, inputs, the playhead, forks."""

import numpy as np
import pytest
from builders import role
from statwalk.errors import StageError, UnknownNameError
from statwalk.stage.stage import Stage

ROLE = role()


@pytest.fixture
def stage():
    """A second and a half of one actor: GO at tick 11, HOP at tick 71."""
    stage = Stage(seed=1)
    actor = stage.add(ROLE)
    stage.step(10)
    stage.send(actor, "GO")
    stage.step(60)
    stage.send(actor, "HOP")
    stage.step(20)
    return stage


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


@pytest.mark.parametrize("tick", [0, 5, 10, 11, 60, 61, 70, 71, 90])
def test_seek_shows_what_was_shown(stage, tick):
    again = Stage(seed=1)
    actor = again.add(ROLE)
    hashes = {0: again.hash}
    for now in range(1, 91):
        if now in (11, 71):
            again.send(actor, "GO" if now == 11 else "HOP")
        again.step()
        hashes[now] = again.hash
    stage.seek(tick)
    assert stage.hash == hashes[tick]


def test_back_and_forth_ends_where_it_began(stage):
    before = stage.hash
    for tick in (3, 77, 0, 61, 90):
        stage.seek(tick)
    assert stage.hash == before


@pytest.mark.parametrize("tick", [-1, 91])
def test_seek_outside_names_what_there_is(stage, tick):
    with pytest.raises(StageError, match=r"this stage has 0 … 90"):
        stage.seek(tick)


def test_steps_from_the_past_follow_the_log_and_then_go_on(stage):
    before = stage.hash
    stage.seek(40)
    stage.step(50)
    assert stage.hash == before
    stage.step()
    assert stage.head == 91


def test_the_past_cannot_be_changed(stage):
    stage.seek(40)
    for change in (lambda: stage.send(1, "HOP"), lambda: stage.add(ROLE), lambda: stage.remove(1), lambda: stage.set(1, "pace", 1)):
        with pytest.raises(StageError, match=r"call fork\(\) first"):
            change()


def test_a_fork_shares_the_past_and_goes_its_own_way(stage):
    stage.seek(40)
    fork = stage.fork()
    fork.send(1, "STOP")
    fork.send(1, "TURN")
    fork.step(50)
    assert fork.actor(1).state == "TURN"
    stage.seek(90)
    fork.seek(40)
    assert stage.actor(1).state == "HOP"
    stage.seek(40)
    assert fork.hash == stage.hash


def test_a_fork_without_changes_runs_like_its_origin(stage):
    stage.seek(60)
    fork = stage.fork()
    stage.seek(70)
    fork.step(10)
    assert fork.hash == stage.hash


def test_a_fork_at_the_head_takes_along_what_was_sent():
    stage = Stage()
    actor = stage.add(ROLE)
    stage.send(actor, "GO")
    fork = stage.fork()
    fork.step()
    assert fork.actor(1).state == "WALK"


def test_a_fork_in_the_past_leaves_behind_what_was_sent_there(stage):
    stage.seek(70)
    fork = stage.fork()
    fork.step(20)
    assert (fork.actor(1).state, [entry.tick for entry in fork.log]) == ("WALK", [0, 11])


def test_a_fork_at_the_head_does_not_see_who_comes_after_it():
    stage = Stage()
    stage.add(ROLE)
    fork = stage.fork()
    stage.add(ROLE)
    fork.step(2)
    fork.seek(0)
    fork.step(2)
    assert [actor.id for actor in fork.actors] == [1]


def test_a_copy_has_all_the_past_and_the_playhead(stage):
    last = stage.hash
    stage.seek(40)
    copy = stage.copy()
    assert (copy.tick, copy.head, copy.hash) == (40, 90, stage.hash)
    copy.seek(90)
    assert (copy.hash, stage.tick) == (last, 40)


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


def test_the_log_says_in_which_tick_an_entry_counts(stage):
    assert [(entry.tick, entry.kind, entry.name) for entry in stage.log] == [
        (0, "add", "tiny 1"),
        (11, "press", "GO"),
        (71, "press", "HOP"),
    ]


def test_verdicts_say_what_became_of_an_event(stage):
    verdict = stage.verdicts[0]
    assert (verdict.tick, verdict.event, verdict.verdict, verdict.from_state, verdict.to_state) == (11, "GO", "taken", "STAND", "WALK")


def test_a_frame_holds_all_actors_and_nothing_of_it_changes(stage):
    frame = stage.frame
    kept = frame.casts[0].pose.rotation.copy()
    stage.step(30)
    assert (frame.casts[0].pose.rotation == kept).all()
    assert (frame.tick, frame.casts[0].role) == (90, ROLE)


def test_world_is_the_actors_place_times_the_pose():
    stage = Stage()
    actor = stage.add(ROLE, position=(1, 0, 2), heading=np.pi / 2)
    hips = actor.world[0]
    assert hips[:3, 3] == pytest.approx([1, 1, 2], abs=1e-6)
    assert hips[:3, 2] == pytest.approx([1, 0, 0], abs=1e-6)  # its +Z now points along +X: a quarter turn to the left
