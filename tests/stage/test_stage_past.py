"""The past of a stage: the playhead, forks, copies, and what is kept of each tick."""

import pytest
from builders import role
from statwalk.errors import StageError
from statwalk.stage.stage import Stage
from statwalk.stage.state.commands import Add, Press

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
    for change in (
        lambda: stage.send(1, "HOP"),
        lambda: stage.add(ROLE),
        lambda: stage.remove(1),
        lambda: stage.set(1, "pace", 1),
    ):
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


def test_the_log_says_in_which_tick_an_entry_counts(stage):
    assert [(entry.number, entry.tick, entry.command) for entry in stage.log] == [
        (1, 0, Add(1, "tiny 1", "tiny", (0.0, 0.0, 0.0), 0.0)),
        (2, 11, Press(1, "GO")),
        (3, 71, Press(1, "HOP")),
    ]


def test_verdicts_say_what_became_of_an_event(stage):
    verdict = stage.verdicts[0]
    assert (verdict.tick, verdict.event, verdict.verdict, verdict.from_state, verdict.to_state) == (
        11,
        "GO",
        "taken",
        "STAND",
        "WALK",
    )


def test_a_frame_holds_all_actors_and_nothing_of_it_changes(stage):
    frame = stage.frame
    kept = frame.casts[0].pose.rotation.copy()
    stage.step(30)
    assert (frame.casts[0].pose.rotation == kept).all()
    assert (frame.tick, frame.casts[0].role) == (90, ROLE)
