"""Sub-machines ("A state's motion"): flattened, an outer state's END when a final inner one ends, and back to
the inner state left last.
"""

from ticking import Ticking

FILE = """
character: c.glb
initial: stand
states:
  stand: {motion: stand, loop: true}
  FIGHT:
    resume: RESUME
    machine:
      initial: GUARD
      states:
        GUARD: {motion: guard, loop: true}
        HIT: {motion: hit}
        BOW: {motion: bow, final: true}
      table: |
        state | PUNCH | DONE | END
        GUARD | HIT | BOW |
        HIT | | |
        BOW | | |
table: |
  state | FIGHT | LEAVE | PUNCH | DONE | END
  stand | FIGHT | | | |
  FIGHT | | stand | | | stand
"""
TICKS = {"stand": 20, "guard": 10, "hit": 4, "bow": 6}


def fighter(resume=False):
    return Ticking.of(FILE.replace("RESUME", str(resume).lower()), TICKS)


def test_the_outer_state_is_where_its_machine_begins():
    assert fighter().step("FIGHT") == "FIGHT.GUARD"


def test_the_row_of_the_outer_state_is_a_default_for_the_inner_ones():
    actor = fighter()
    assert [actor.step(event) for event in ("FIGHT", "PUNCH", "LEAVE")] == [
        "FIGHT.GUARD",
        "FIGHT.HIT",
        "stand",
    ]


def test_the_outer_end_comes_when_a_final_state_ends_and_not_before():
    actor = fighter()
    actor.step("FIGHT")
    assert actor.path(30) == []  # GUARD wraps, and is not final
    actor.step("DONE")
    assert actor.path(9) == [(38, "stand")]  # BOW began in tick 32


def test_an_inner_state_that_is_not_final_holds_its_last_pose():
    actor = fighter()
    actor.step("FIGHT")
    actor.step("PUNCH")
    assert actor.path(20) == []


def test_it_begins_anew_each_time_without_resume():
    actor = fighter()
    assert [actor.step(event) for event in ("FIGHT", "PUNCH", "LEAVE", "FIGHT")][-1] == "FIGHT.GUARD"


def test_with_resume_it_goes_on_in_the_state_left_last():
    actor = fighter(resume=True)
    assert [actor.step(event) for event in ("FIGHT", "PUNCH", "LEAVE", "FIGHT")][-1] == "FIGHT.HIT"


def test_moving_within_is_no_leaving():
    actor = fighter(resume=True)
    for event in ("FIGHT", "PUNCH"):
        actor.step(event)
    assert actor.memory.last.tolist() == [[-1]]
    actor.step("LEAVE")
    assert [actor.machine.states[row] for row in actor.memory.last[0]] == ["FIGHT.HIT"]
