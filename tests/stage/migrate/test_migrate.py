"""Live edits: everybody goes on where he is, by name; nothing jumps; an identical table changes nothing at
all.
"""

import numpy as np
import pytest
from builders import TABLE, role
from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.definition.cell_definition import AT_END, CellDefinition
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

ROLE = role()
DT = 1 / 60
WITHOUT_WALK = """
state | GO   | HOP  | TURN | STOP | END
STAND | HOP  | HOP  | TURN | -    |
HOP   |      | HOP! |      |      | STAND
TURN  |      |      |      | STAND | STAND
"""
RENAMED = """
state | HOP  | SPIN | GO | END
HOP   | HOP! |      |    | STAND
STAND | HOP  | TURN | WALK |
WALK  | HOP  | TURN | WALK |
TURN  |      |      |    | STAND
"""


def at_work(ticks=20):
    """Somebody who walks, and somebody who stands."""
    stage = Stage(seed=3)
    walker, other = stage.add_many(ROLE, [((0, 0, 0), 0), ((2, 0, 0), 1)])
    stage.send(walker, "GO")
    stage.step(ticks)
    return stage, walker, other


def test_an_identical_table_leaves_everything_as_it_was_to_the_bit():
    waiting = {("WALK", "STOP"): CellDefinition("STAND", 1, when=AT_END)}
    stage = Stage(seed=3)
    stage.add_many(role(cells=waiting), [((0, 0, 0), 0), ((2, 0, 0), 1)])
    for event in ("GO", "STOP"):
        stage.send(1, event)
        stage.step(10)
    plain = stage.fork()
    stage.hold(1, "TURN")
    plain.hold(1, "TURN")
    stage.edit(role(cells=waiting), "the same")
    for each in (stage, plain):
        each.send(2, "HOP")
        each.step(70)
    assert (stage.hash, list(stage.verdicts)) == (plain.hash, list(plain.verdicts))


def test_the_new_table_counts_from_the_next_event_on():
    stage, walker, other = at_work()
    stage.edit(role(cells={("STAND", "GO"): CellDefinition("HOP", 1)}))
    stage.send(other, "GO")
    stage.step()
    assert (walker.state, other.state) == ("WALK", "HOP")


def test_state_and_time_are_kept_by_name():
    stage, walker, _ = at_work()
    stage.edit(role(table=RENAMED))
    assert (walker.state, walker.time) == ("WALK", pytest.approx(19 * DT))


def test_the_stream_of_one_who_is_not_concerned_does_not_change():
    stage, walker, _ = at_work()
    plain = stage.fork()
    stage.edit(role(table=RENAMED))
    stage.step(30)
    plain.step(30)
    assert all((one == other).all() for one, other in zip(walker.pose, plain.actor(1).pose, strict=True))


def test_a_state_that_is_gone_is_left_for_the_fallback():
    stage, walker, _ = at_work()
    stage.edit(role(table=WITHOUT_WALK, fallback="TURN"))
    assert (walker.state, walker.time) == ("TURN", 0)


def test_without_a_fallback_it_is_the_initial_state():
    stage, walker, _ = at_work()
    stage.edit(role(table=WITHOUT_WALK))
    assert walker.state == "STAND"


def test_who_is_put_elsewhere_hears_of_it():
    stage, *_ = at_work()
    stage.edit(role(table=WITHOUT_WALK))
    stage.step()
    assert [one[3:8] for one in stage.frame.verdicts] == [
        ("EDIT", "taken", "the edit has no state WALK", "WALK", "STAND")
    ]


def test_nothing_jumps_where_a_state_is_gone():
    """The arm goes on at the velocity that was shown: what a tick changes differs little from what the tick
    before did.
    """
    stage, walker, _ = at_work()
    stage.edit(role(table=WITHOUT_WALK))
    shown = []
    for _ in range(30):
        shown.append(walker.pose.rotation[2].copy())
        stage.step()
    second = np.abs(np.diff(shown, n=2, axis=0)).max()
    assert second < 0.01
    assert np.abs(np.diff(shown, axis=0)).max() > 0.01  # it does move


def test_a_transition_after_an_edit_is_over_after_the_default_blend():
    stage, *_ = at_work()
    stage.edit(role(table=WITHOUT_WALK))
    stage.step(12)
    assert not stage.frame.casts[0].blend.any()


def test_a_parameter_keeps_its_value_within_the_new_bounds():
    stage, walker, _ = at_work()
    stage.set(walker, "pace", 0.5)
    stage.step()
    stage.edit(role(table=RENAMED))
    stage.step()
    before = walker.time
    stage.step()
    assert walker.time - before == pytest.approx(0.5 * DT)


def test_what_waits_is_looked_up_in_the_new_table():
    stage, _, other = at_work()
    stage.send(other, "HOP")
    stage.step()
    stage.send(other, "TURN")  # blank in HOP: it waits for 0.3 s
    stage.step()
    stage.edit(role(cells={("HOP", "TURN"): CellDefinition("TURN", 1)}))
    stage.step()
    assert other.state == "TURN"


def test_an_event_that_waits_and_is_gone_is_dropped_with_a_verdict():
    stage, _, other = at_work()
    stage.send(other, "HOP")
    stage.step()
    stage.send(other, "STOP")
    stage.step()
    stage.edit(role(table=RENAMED))
    stage.step()
    assert ("STOP", "dropped", "the edit has no such event") in [one[3:6] for one in stage.frame.verdicts]


def test_an_event_sent_before_the_edit_that_takes_it_away_is_dropped_with_a_verdict():
    stage, walker, _ = at_work()
    stage.send(walker, "STOP")
    stage.edit(role(table=RENAMED))
    stage.step()
    assert ("STOP", "dropped", "tiny has no event STOP") in [one[3:6] for one in stage.frame.verdicts]


def test_what_is_held_stays_held():
    stage, _, other = at_work()
    stage.hold(other, "TURN")
    stage.step(5)
    stage.edit(role(table=TABLE, cells={("STAND", "GO"): CellDefinition("HOP", 1)}))
    stage.step(70)
    assert (other.state, other.time < 0.3) == ("TURN", True)  # the second turn


def test_who_comes_after_an_edit_plays_by_it():
    stage, *_ = at_work()
    new = role(table=WITHOUT_WALK)
    stage.edit(new)
    stage.send(stage.add(stage.role("tiny")), "GO")
    stage.step()
    assert stage.actor(3).state == "HOP"
    with pytest.raises(StageError, match="another role on this stage is called 'tiny'"):
        stage.add(ROLE)


def test_old_ticks_show_the_old_machine():
    stage, walker, _ = at_work()
    stage.edit(role(table=WITHOUT_WALK))
    stage.step(100)
    stage.seek(10)
    assert (walker.state, stage.role("tiny")) == ("WALK", ROLE)
    stage.seek(20)
    assert walker.state == "STAND"


def test_a_fork_from_before_the_edit_goes_on_without_it():
    stage, *_ = at_work()
    stage.edit(role(table=WITHOUT_WALK))
    stage.step(10)
    stage.seek(19)
    fork = stage.fork()
    fork.step(30)
    assert fork.actor(1).state == "WALK"


def test_seeks_across_edits_end_where_they_began():
    stage, *_ = at_work()
    for table in (WITHOUT_WALK, RENAMED, TABLE):
        stage.edit(role(table=table), table)
        stage.step(50)
    hashes = {}
    for tick in (170, 20, 21, 70, 119, 121, 0, 170):
        stage.seek(tick)
        hashes.setdefault(tick, stage.hash)
        assert stage.hash == hashes[tick]


def test_a_log_with_edits_gives_the_same_stage():
    stage, *_ = at_work()
    for table in (WITHOUT_WALK, RENAMED):
        stage.edit(role(table=table), table)
        stage.send(2, "HOP")
        stage.step(33)
    again = replay(stage.dump(), lambda name, text=TABLE: role(table=text, name=name.partition("@")[0]))
    assert again.hash == stage.hash
    assert list(again.roles) == ["tiny", "tiny@2", "tiny@3"]


def test_two_edits_of_one_name_that_differ_are_refused():
    stage, *_ = at_work()
    stage.edit(role(table=RENAMED), RENAMED)
    lines = stage.dump()
    with pytest.raises(
        StageError, match=f"line {len(lines) + 1}: tiny@2 says something else in line {len(lines)}"
    ):
        replay([*lines, lines[-1].replace("SPIN", "SPUN")], lambda _, text=TABLE: role(table=text))


def test_an_edit_names_the_roles_there_are():
    stage, *_ = at_work()
    with pytest.raises(UnknownNameError, match="There are: tiny"):
        stage.edit(role(name="tinny"))


def test_the_past_cannot_be_edited():
    stage, *_ = at_work()
    stage.seek(3)
    with pytest.raises(StageError, match=r"call fork\(\) first"):
        stage.edit(role())
    assert list(stage.roles) == ["tiny"]
