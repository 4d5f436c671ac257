"""The time left after END leads a loop through its seam: its markers and windows come in the next tick."""

import pytest
from ticking import Ticking

CARRIED = {"start": 9.5, "late": 9.75, "low": 0.125, "right": 1, "far": 5, "early": 9.25}


def through_the_seam(more=""):
    """A ends at 2.25, so that b, entered at 9.5 of 10 ticks, is through its seam at 0.25 in the third tick,
    and at 1.25 in the fourth.
    """
    names = list(CARRIED)
    rows = f"A | | {' | '.join(' ' * 6)} | b\nb | | {' | '.join('b' * 6)} |"
    table = f"state | X | {' | '.join(names)} | END\n{rows}"
    cells = f"cells:\n  A/END: {{enter: 0.95}}\n{more}"
    actor = Ticking(table, {"A": 2.25, "b": 10}, cells, {"b": CARRIED})
    assert (actor.run(3), actor.time_in_ticks, actor.said) == ("b", 0.25, ["END taken"])
    return actor


def test_markers_that_the_time_left_over_has_passed_come_by_time_also_through_the_seam():
    actor = through_the_seam()
    met = [actor.said for _ in range(11) if actor.step()]
    first = ["start taken", "late taken", "low taken", "right taken"]
    assert met[:5] == [first, [], [], [], ["far taken"]]
    assert met[5:] == [
        [],
        [],
        [],
        ["early taken"],
        ["start taken", "late taken", "low taken"],
        ["right taken"],
    ]


@pytest.mark.parametrize(
    ("window", "at"),
    [("0.96..0.98", 4), ("0.01..0.02", 4), ("0.1..0.11", 4), ("0.2..0.25", 5), ("0.9..0.93", 12)],
)
def test_so_do_windows(window, at):
    actor = through_the_seam(f"  b/X: {{to: A, when: window {window}}}\n")
    actor.step("X")
    assert (actor.tick if actor.state == "A" else actor.path(20)[0][0]) == at


def test_a_cell_at_a_marker_that_the_time_left_over_has_passed_fires_in_the_next_tick():
    actor = through_the_seam("  b/X: {to: A, when: marker late}\n")
    assert actor.step("X") == "A"
