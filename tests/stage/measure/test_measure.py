"""What is measured of faq-walker: its cycles hold the ground, a cut jumps, every cell is played."""

import pytest
from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.stage.measure.measure import measure_cells, measure_motions
from statwalk.stage.measure.subject import Subject

FOLDER = MACHINES / "faq-walker"
TEXT = (FOLDER / "machine.yaml").read_text()
WALKER = Subject(load_role(FOLDER))
CUT = Subject(load_role(FOLDER, text=TEXT.replace("TLFT/STOP:    {blend: 0.5}", "TLFT/STOP:    {blend: 0}")))


def cell(subject, name):
    (measured,) = measure_cells(subject, [subject.cell(name)])
    return measured


def test_the_walk_by_itself_holds_the_ground():
    row = WALKER.role.machine.states.index("WALK")
    (walk,) = measure_motions(WALKER, [row])
    assert (walk.name, walk.trials) == ("WALK", 1)
    assert walk.figures["slide"].worst < 0.012
    assert walk.figures["sink"].worst < 0.001
    assert walk.figures["hover"].worst < 0.006
    assert walk.figures["knee"].worst == 0


def test_a_cut_is_a_jump_and_a_blend_is_none():
    assert cell(CUT, "TLFT/STOP").figures["jump"].worst > 5
    assert cell(WALKER, "TLFT/STOP").figures["jump"].worst < 1.2


def test_a_cell_at_the_end_waits_for_it():
    turn = cell(WALKER, "TLFT/FORWARD")
    assert turn.figures["visible"].mean == pytest.approx(0.55, abs=0.05)  # half of a turn of a second


def test_every_phase_and_every_interruption_is_played():
    turn = cell(WALKER, "STAT/LEFT")
    assert turn.trials == 10 + 2 * 3 * 10  # RIGHT and STOP, after 1, 5 and 11 ticks
    assert turn.line == 1 + TEXT[: TEXT.index("  STAT  |")].count("\n")


def test_the_cells_are_those_that_change_the_state():
    names = [WALKER.name(cell) for cell in WALKER.cells]
    assert "STAT/FORWARD" in names
    assert "TLFT/LEFT" in names  # restarts
    assert "STAT/STOP" not in names  # stays
