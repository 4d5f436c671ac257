"""Blends in proofs: how long they take is what a life shows, tick for tick or between the bounds."""

import random
from itertools import pairwise

import pytest
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.model_checker.blend_lengths import blend_moments
from statwalk.machine.verify import verify
from ticking import RATE, Ticking

CLIPS = {"walk": 40, "run": 20, "limp": 60, "rest": 30}
"""ticks"""
TEXT = """character: c.glb
initial: REST
parameters: {x: {default: %(x)s, min: %(low)s, max: %(high)s}, y: {default: %(y)s, min: 0, max: 3}}
states:
  REST: {motion: rest, loop: true}
  MOVE:
    loop: %(loop)s
    motion: {over: %(over)s, clips: {%(clips)s}, markers: {%(markers)s}}
    markers: {%(points)s}
  DONE: {motion: rest, loop: true}
table: |
  state | GO | STOP | DUCK | END
  REST  | MOVE | | |
  MOVE  | | DONE at right | DONE | DONE
  DONE  | REST | | | REST
"""
POINTS = [0.1, 0.25, 0.4, 0.55, 0.7, 0.85]
LINE = "walk: 0, run: 2, limp: 3"
EVEN = "walk: {right: 0.6}"
PLANE = "walk: [0, 0], run: [2, 1], limp: [1, 3]"
STEPS = "walk: {left: 0.2, right: 0.6}, run: {left: 0.3, right: 0.5}, limp: {left: 0.1, right: 0.7}"


def file(**changed):
    """The machine file: three clips of different rhythm along a line."""
    points = ", ".join(f"p{number}: {phase}" for number, phase in enumerate(POINTS))
    given = {"over": "x", "clips": LINE, "markers": STEPS, "points": points, "loop": "false"}
    return TEXT % ({"x": 1, "y": 1, "low": 0, "high": 3} | given | changed)


def passed(actor, phases, chance=None):
    """The ticks after entering MOVE until its motion has passed each phase; `chance` sets parameters."""
    actor.step("GO")
    assert actor.state == "MOVE"
    left, duration, ticks, before = list(phases), max(CLIPS.values()), 0, actor.time_in_ticks
    found = []
    while left and ticks < 200:
        if chance and chance.random() < 0.2:
            actor.set(x=chance.uniform(0, 3), y=chance.uniform(0, 3))
        ended = actor.step() != "MOVE"
        now = duration if ended else actor.time_in_ticks
        while left and left[0] * duration <= now + 1e-5:
            found.append(ticks + 1 if ended else ticks + (left[0] * duration - before) / (now - before))
            left.pop(0)
        ticks, before = ticks + 1, now
    return found


def moments(actor, pick, as_set):
    """The phases of MOVE, and the ticks that have gone."""
    found = blend_moments(actor.machine, 1, pick, as_set)
    return [phase for phase, _ in found], [seconds * RATE for _, seconds in found]


def at(found, phase):
    """The ticks that have gone at a phase."""
    for (start, here), (end, there) in pairwise(zip(*found, strict=True)):
        if start <= phase <= end:
            return here + (there - here) * (phase - start) / (end - start)
    raise AssertionError(phase)


FIXED = [
    {"x": 0}, {"x": 0.7}, {"x": 2}, {"x": 2.6, "loop": "true"},
    {"over": "[x, y]", "clips": PLANE, "x": 1, "y": 1.2}, {"markers": EVEN},
]  # fmt: skip


@pytest.mark.parametrize("changed", FIXED, ids=str)
def test_while_nobody_sets_a_parameter_the_moments_are_those_of_a_life(changed):
    actor = Ticking.of(file(**changed), CLIPS)
    slow, quick = (moments(actor, pick, True) for pick in (max, min))
    assert slow == quick
    seen = passed(actor, POINTS)
    assert len(seen) == len(POINTS)
    # a tick that passes a change of pace is not divided evenly
    assert seen == pytest.approx([at(slow, phase) for phase in POINTS], abs=0.2)
    passed_all = Ticking.of(file(**changed), CLIPS)
    passed_all.step("GO")
    ticks = next(count for count in range(1, 99) if passed_all.step() != "MOVE")
    assert ticks == int(slow[1][-1] + 1 - 1e-3)


@pytest.mark.parametrize("changed", [{}, {"over": "[x, y]", "clips": PLANE}, {"loop": "true"}], ids=str)
@pytest.mark.parametrize("seed", range(6))
def test_whatever_is_set_and_when_a_life_stays_between_the_bounds(changed, seed):
    actor = Ticking.of(file(**changed), CLIPS)
    quick, slow = (moments(actor, pick, False) for pick in (min, max))
    seen = passed(actor, POINTS, random.Random(seed))
    for (phase, ticks), (start, begun) in pairwise([(0.0, 0.0), *zip(POINTS, seen, strict=True)][::-1]):
        assert at(quick, phase) - at(quick, start) - 0.2 <= ticks - begun
        assert ticks - begun <= at(slow, phase) - at(slow, start) + 0.2


def test_a_parameter_that_cannot_go_far_leaves_little_open():
    """From x = 1 to x = 2 a lap takes 30 to 20 ticks; the walk of 40 is out of reach."""
    actor = Ticking.of(file(low=1, high=2, markers=EVEN), CLIPS)
    assert moments(actor, max, False)[1] == pytest.approx([0, 30])
    assert moments(actor, min, False)[1] == pytest.approx([0, 20])


def test_between_two_clips_the_longest_way_may_lie_in_the_middle():
    """Lap and share of the way are both linear in x: at x = 1 the walk has 40 ticks and 0.2 of its way to
    the step, the run 80 ticks and 0.05; a mixture takes at most (40 + 40 t) (0.2 - 0.15 t).
    """
    text = file(clips="walk: 0, run: 3", markers="walk: {left: 0.2, right: 0.6}, run: {left: 0.05}")
    actor = Ticking.of(text, CLIPS | {"run": 80})
    most = max((40 + 40 * t / 1000) * (0.2 - 0.15 * t / 1000) for t in range(1001))
    assert most > 8
    assert moments(actor, max, False)[1][1] == pytest.approx(most, abs=1e-4)


def answer(text, sentence, ticks=CLIPS):
    facts = {name: MotionFacts(count / RATE) for name, count in ticks.items()}
    return next(
        one
        for one in verify(read_machine(f"{text}properties: ['{sentence}']\n"), facts)
        if one.kind == "property"
    )


def until(text, ticks, replay, goal):
    """The ticks from the one in which MOVE is entered to the one in which `goal` is, in a replay."""
    actor, pressed, since = Ticking.of(text, ticks), dict(replay), None
    for tick in range(1, 400):
        before = actor.state
        actor.step(*([pressed[tick]] if tick in pressed else []))
        if before != "MOVE" and actor.state == "MOVE":
            since = tick
        if since and actor.state == goal:
            return tick - since
    return None


HALF_WAY = {"clips": "walk: 0, limp: 2", "markers": EVEN}
"""at x = 1 a lap takes 50 ticks: neither the walk's 40 nor the limp's 60"""


@pytest.mark.parametrize(("ticks", "expected"), [(50, "proved (at most 0.8333 s)"), (49, "refuted")])
def test_the_pace_alone_decides_tick_for_tick(ticks, expected):
    text = file(low=1, high=1, **HALF_WAY)
    found = answer(text, f"MOVE leads to DONE within {ticks / RATE + 0.001:.3f} s")
    assert expected in found.message
    assert until(text, CLIPS, found.replay or ((1, "GO"),), "DONE") == 50


@pytest.mark.parametrize("pressed", [1, 12, 20])
def test_a_marker_in_a_blend_is_answered_tick_for_tick(pressed):
    """Half way between run and walk a lap takes 30 ticks; `right` stands at 0.55 of it: in tick 17. By the
    phase of the walk it would be 0.6 of 30: tick 18.
    """
    text = file(clips="walk: 0, run: 2", markers=STEPS.rsplit(", limp", 1)[0], low=1, high=1)
    longest = 30
    for ticks, expected in ((longest - 1, "refuted"), (longest, "proved")):
        found = answer(text, f"MOVE leads to DONE within {ticks / RATE + 0.001:.3f} s")
        assert expected in found.message
    actor = Ticking.of(text, CLIPS)
    actor.step("GO")
    actor.run(pressed - 1)
    actor.step("STOP")
    assert actor.path(40)[0] == (1 + (17 if pressed <= 17 else 30), "DONE")
    sentence = "from MOVE, STOP reaches DONE within {:.3f} s"
    assert "proved" in answer(text, sentence.format(16 / RATE + 0.001)).message
    assert "refuted" in answer(text, sentence.format(15 / RATE + 0.001)).message


@pytest.mark.parametrize("seed", range(12))
def test_what_is_refuted_shows_on_a_new_stage_and_what_is_proved_holds_whatever_is_set(seed):
    chance = random.Random(seed)
    x = round(chance.uniform(0, 3), 2)
    text = file(x=x, **(HALF_WAY if chance.random() < 0.3 else {}))
    limit = chance.randrange(20, 70)
    found = answer(text, f"MOVE leads to DONE within {limit / RATE + 0.001:.3f} s")
    if "refuted" in found.message:
        lasted = until(text, CLIPS, found.replay, "DONE")
        assert lasted is None or lasted > limit
    if "proved" in found.message:
        for _ in range(8):
            actor = Ticking.of(text, CLIPS)
            assert passed(actor, [1.0], chance)[0] <= limit
