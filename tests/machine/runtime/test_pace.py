"""The pace of a blend, without a character: a lap takes the mean of its clips' durations."""

import pytest
from ticking import DT, RATE, Ticking

TICKS = {"walk": 20, "run": 30, "hop": 2.25}
TEXT = """character: c.glb
initial: HOP
parameters: {x: {default: 1, min: 0, max: 4}}
states:
  HOP:  {motion: hop}
  MOVE: {motion: {over: x, clips: {walk: 1, run: 3}}, loop: true, speed: 1.2}
table: |
  state | END
  HOP   | MOVE
  MOVE  |
cells:
  HOP/END: {enter: 0}
layers:
  arms: {initial: RUN, states: {RUN: {motion: run, loop: true}}}
"""


def entered(enter=0.0, x=1):
    """An actor that has entered MOVE in the third tick, with 0.75 of it left."""
    text = TEXT.replace("enter: 0", f"enter: {enter}").replace("default: 1", f"default: {x}")
    actor = Ticking.of(text, TICKS)
    assert actor.run(3) == "MOVE"
    return actor


@pytest.mark.parametrize(("x", "pace"), [(1, 30 / 20), (2, 30 / 25), (3, 1), (4, 1)])
def test_a_blend_goes_at_its_pace_from_the_time_left_after_end_on(x, pace):
    actor = entered(x=x)
    assert actor.time_in_ticks == pytest.approx(0.75 * 1.2 * pace)
    actor.step()
    assert actor.time_in_ticks == pytest.approx(1.75 * 1.2 * pace)
    assert actor.memory.time[0, 1] * RATE == pytest.approx(4)  # the other layer goes at its own


def test_a_change_in_the_tick_before_makes_no_difference():
    """HOP ends in the third tick, SKIP, of one tick, in the fourth."""
    text = TEXT.replace("  HOP   | MOVE\n", "  HOP   | SKIP\n  SKIP  | MOVE\n")
    text = text.replace("  HOP:  {motion: hop}\n", "  HOP:  {motion: hop}\n  SKIP: {motion: skip}\n")
    actor = Ticking.of(text, TICKS | {"skip": 1})
    assert (actor.run(3), actor.run(1)) == ("SKIP", "MOVE")
    assert actor.time_in_ticks == pytest.approx(0.75 * 1.2 * 1.5)


def test_the_change_says_where_the_time_left_after_end_has_led():
    effects = entered(0.5).effects
    assert effects.start[0] == pytest.approx((15 + 0.75 * 1.2 * 1.5) * DT)
    assert effects.carried[0] == pytest.approx(0.75 * DT)


def test_through_the_seam_of_a_loop_the_time_left_over_goes_at_the_speed_alone():
    """From 29.4 of 30 ticks: 0.75 ticks at speed 1.2 lead to 30.3, at the pace of the walk to 30.75."""
    assert entered(0.98).time_in_ticks == pytest.approx(0.3)


def test_a_parameter_counts_from_the_next_tick_on():
    """Motions advance by the parameters of the tick before."""
    actor = entered()
    actor.set(x=3)
    actor.step()
    assert actor.time_in_ticks == pytest.approx(1.75 * 1.2 * 1.5)
    actor.step()
    assert actor.time_in_ticks == pytest.approx(1.75 * 1.2 * 1.5 + 1.2)


@pytest.mark.parametrize("x", [1.05, 1.5, 2.9])
@pytest.mark.parametrize("foot", [0.1, 0.9, 0.999])
def test_a_blend_ends_however_far_a_marker_bends_its_way(foot, x):
    """The run's way is bent at the walk's marker: when the walk is nearly over, the run has most to go."""
    clips = "{walk: 1, run: 3}"
    bent = f"{clips}, markers: {{walk: {{foot: 0.998}}, run: {{foot: {foot}}}}}"
    text = TEXT.replace("loop: true, speed: 1.2", "speed: 1.2").replace(clips, bent)
    actor = Ticking.of(text.replace("MOVE  |", "MOVE  | HOP").replace("default: 1", f"default: {x}"), TICKS)
    assert "HOP" in [actor.run(1) for _ in range(3 + 30)][3:]
