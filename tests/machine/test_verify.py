"""What is found in a table without running it."""

from statwalk.files.machinefile import read_machine
from statwalk.machine.build import MotionFacts
from statwalk.machine.verify import verify
from ticking import text_of


def found(table, states="A B", more="", motions=None):
    """(kind, message) of each finding."""
    ticks = dict.fromkeys(states.split(), 60)
    facts = None if motions is None else {name: MotionFacts(seconds) for name, seconds in motions.items()}
    return [(one.kind, one.message) for one in verify(read_machine(text_of(table, ticks, more)), facts)]


def test_nothing_is_wrong_with_a_table_where_nothing_is_wrong():
    assert found("state | GO | END\nA | B | \nB | | A") == []


def test_undefined_states_are_named_once_with_all_their_cells():
    assert found("state | GO | X | END\nALFA | BETA | BET |\nBETA | BET | | ALFA", "ALFA BETA") == [
        ("undefined state", "BET is no state; did you mean BETA? It stands in ALFA/X (line 8), BETA/GO (line 9)")
    ]


def test_unreachable_and_states_without_exit():
    assert found("state | GO\nA | B\nB | B\nC | A", "A B C") == [
        ("unreachable state", "C cannot be reached from A"),
        ("no exit", "B cannot be left (A -GO-> B)"),
    ]


def test_events_that_no_cell_answers():
    assert found("state | GO | NEVER | END\nA | B | - |\nB | | | A") == [("unused event", "no cell answers NEVER")]


def test_defaults_that_never_count():
    assert found("state | GO\nA | B\nB | A at end", more='cells: {"*/GO": {to: A}}') == [
        ("cell never fires", "*/GO never counts: other cells come before it")
    ]


def test_a_held_input_that_swings():
    assert found("state | GO | END\nA | B | B\nB | A | A") == [
        ("cycle without time", "GO held down changes the state in every tick: A -> B -> A")
    ]
    assert found("state | GO | END\nA | B | B\nB | A at end | A") == []


def test_cycles_of_motions_that_take_no_time():
    table = "state | GO | END\nA | | B\nB | | A"
    assert [kind for kind, _ in found(table, motions={"A": 0, "B": 0})] == ["cycle without time", "unused event"]
    assert [kind for kind, _ in found(table, motions={"A": 0, "B": 1})] == ["unused event"]


def test_a_dash_under_end_is_no_cycle_whatever_is_idle():
    """The idle event takes the place of an END that is blank, not of one that is `-`."""
    for end, times in (("", 2), ("-", 1)):  # once for STOP held down, which swings as well
        table = f"state | STOP | END\nA | B | {end}\nB | A | {end}"
        assert [kind for kind, _ in found(table, more="idle: STOP\n", motions={"A": 0, "B": 0})] == ["cycle without time"] * times


def test_motions_unknown_and_unused():
    assert found("state | GO | END\nA | B |\nB | | A", motions={"A": 1, "BB": 1}) == [
        ("unknown motion", "B has no motion 'B'; did you mean BB?"),
        ("unused motion", "no state uses the motion 'BB'"),
    ]


def test_parameters_unknown_and_unused():
    text = text_of("state | GO\nA | A", {"A": 60}, "parameters: {pace: {default: 1, min: 0, max: 2}}\n")
    assert [(one.kind, one.message) for one in verify(read_machine(text.replace("loop: false", "speed: pase")))] == [
        ("unknown parameter", "the speed of A is 'pase', which is no parameter; did you mean pace?"),
        ("unused parameter", "nobody uses the parameter pace"),
    ]
