"""Properties with a time, worked out by hand; durations are in ticks of 1/60 s."""

import random
from itertools import chain

import pytest
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.verify import verify
from ticking import RATE, Ticking, text_of

TABLE = (
    "state | GO | STOP | DUCK | END\nIDLE | JUMP | | |\nJUMP | | | | FLY\nFLY | | IDLE at end | | DOWN\n"
    "DOWN | | | DOWN at end | IDLE"
)
TICKS = {"IDLE": 60, "JUMP": 30, "FLY": 20, "DOWN": 10}
PARAMETERS = "parameters: {pace: {default: 1, min: 0.5, max: 2}, still: {default: 1, min: 0, max: 2}}\n"


def finding(sentence, more="", table=TABLE, ticks=TICKS, markers=None, text=""):
    """The finding about a property of a machine."""
    said = text or text_of(table, ticks, more)
    facts = {
        name: MotionFacts(
            count / RATE, None, tuple((mark, at / RATE) for mark, at in (markers or {}).get(name, {}).items())
        )
        for name, count in ticks.items()
    }
    return next(
        one
        for one in verify(read_machine(f"{said}properties: ['{sentence}']\n"), facts)
        if one.kind == "property"
    )


def answer(sentence, *args, **more):
    return finding(sentence, *args, **more).message.removeprefix(f"{sentence}: ")


def test_the_motions_one_after_the_other():
    way = "IDLE -GO 0.01667 s-> JUMP -END 0.5167 s-> FLY -STOP 0.85 s-> IDLE"
    assert answer("JUMP leads to DOWN within 1 s") == f"refuted: {way} and after 1 s not in DOWN"


def test_proved_to_the_tick():
    assert answer("JUMP leads to FLY within 500 ms") == "proved (at most 0.5 s)"
    assert answer("JUMP leads to FLY within 0.49 s").startswith(
        "refuted: IDLE -GO 0.01667 s-> JUMP and after"
    )


def test_an_outer_state_stands_for_all_within():
    text = (
        "character: c.glb\ninitial: A\n"
        "states: {A: {motion: A}, B: {machine: {initial: C, states: {C: {motion: C}}}}}\n"
    )
    cells = "table: |\n  state | GO | END\n  A | A | B\n  B | | A\n"
    assert (
        answer("A leads to B within 1 s", text=text + cells, ticks={"A": 60, "C": 60})
        == "proved (at most 1 s)"
    )


def test_an_end_can_be_put_off_for_ever():
    refuted = finding("DOWN leads to IDLE within 1 s")
    assert {event for _, event in refuted.replay} == {"GO", "DUCK"}


def test_what_nothing_forces_is_refuted_by_waiting():
    assert answer("IDLE leads to JUMP within 9 s") == "refuted: IDLE and after 9 s not in JUMP"


def test_one_event_and_then_silence():
    assert (
        answer("from FLY, STOP reaches IDLE within 0.5 s") == "proved (at most 0.3167 s)"
    )  # a tick after FLY has begun
    assert answer("from DOWN, STOP reaches IDLE within 0.5 s") == "proved (at most 0.15 s)"


def test_an_event_that_waits_in_vain():
    """GO in FLY waits 0.3 s, which at the beginning of FLY (and DOWN after it) is not enough."""
    assert answer("from FLY, GO reaches JUMP within 2 s").startswith(
        "refuted: IDLE -GO 0.01667 s-> JUMP -END 0.5167 s-> FLY -GO"
    )


def test_an_event_that_waits_long_enough():
    assert (
        answer("from FLY, GO reaches JUMP within 1 s", "defaults: {buffer: 1}\n") == "proved (at most 0.5 s)"
    )


def test_senses_are_free():
    more = "senses: {HIT: {when: speed > 1}}\ncells: {JUMP/HIT: {to: IDLE}}\n"
    assert answer("from JUMP, STOP reaches DOWN within 2 s", more).startswith(
        "refuted: IDLE -GO 0.01667 s-> JUMP"
    )


def test_conditions_are_free():
    more = f"{PARAMETERS}cells: {{JUMP/END: [{{if: pace > 1, to: FLY}}, {{to: IDLE}}]}}\n"
    said = answer("JUMP leads to FLY within 1 s", more, TABLE.replace("| FLY\n", "|\n"))
    assert (
        said == "refuted: IDLE -GO 0.01667 s-> JUMP -END 0.5167 s-> IDLE and after 1 s not in FLY, "
        "if conditions and chance will have it"
    )


@pytest.mark.parametrize(
    ("seconds", "expected"),
    [
        (1, "proved (at most 1 s)"),
        (
            0.5,
            "undecided: it takes 0.25 s at the least, and at the most 1 s; JUMP lasts as long as pace will "
            "have it",
        ),
        (0.2, "refuted: IDLE -GO 0.01667 s-> JUMP and after 0.2 s not in FLY"),
    ],
)
def test_a_speed_that_is_set_from_outside(seconds, expected):
    text = text_of(TABLE, TICKS, PARAMETERS).replace("JUMP, loop: false", "JUMP, loop: false, speed: pace")
    assert answer(f"JUMP leads to FLY within {seconds} s", text=text) == expected


def test_a_motion_that_may_stand_still():
    text = text_of(TABLE, TICKS, PARAMETERS).replace("JUMP, loop: false", "JUMP, loop: false, speed: still")
    assert answer("JUMP leads to FLY within 9 s", text=text).startswith(
        "undecided: it takes 0.25 s at the least, and at the most for ever"
    )


BLENDED = """character: c.glb
initial: A
parameters: {speed: {default: 1, min: 1, max: 3}}
states: {A: {motion: walk}, B: {motion: {over: speed, clips: {walk: 1, run: 3}}}}
table: |
  state | GO | END
  A     | B  |
  B     |    | A
"""


def test_a_blend_lasts_as_long_as_one_of_its_clips_or_something_between():
    ticks, quick = {"walk": 60, "run": 30}, BLENDED.replace("default: 1", "default: 3")
    said = (
        "undecided: it takes 0.5 s at the least, and at the most 1 s; B lasts as long as speed will have it"
    )
    assert answer("B leads to A within 0.8 s", text=quick, ticks=ticks) == said
    assert answer("B leads to A within 1 s", text=quick, ticks=ticks) == "proved (at most 1 s)"


def test_what_fails_while_nobody_sets_a_parameter_is_refuted():
    found = finding("B leads to A within 0.8 s", text=BLENDED, ticks={"walk": 60, "run": 30})
    assert found.message.endswith("refuted: A -GO 0.01667 s-> B and after 0.8 s not in A")
    assert found.replay == ((1, "GO"),)


def test_fractions_of_a_tick_are_looked_at_from_both_sides():
    ticks = {"A": 60, "B": 10.5, "C": 10.5}
    table = "state | GO | END\nA | B |\nB | | C\nC | | A"
    assert answer("B leads to A within 0.367 s", "", table, ticks) == "proved (at most 0.3667 s)"
    assert answer("B leads to A within 0.35 s", "", table, ticks).startswith(
        "undecided: it takes 0.3333 s at the least"
    )


def test_a_marker_comes_with_the_motion_alone():
    table = "state | GO | foot\nA | B |\nB | | A"
    assert (
        answer("B leads to A within 0.5 s", "", table, {"A": 60, "B": 60}, {"B": {"foot": 24}})
        == "proved (at most 0.4 s)"
    )


def test_a_state_that_is_never_entered():
    assert (
        answer("B leads to A within 1 s", "", "state | GO | END\nA | A |\nB | | A", {"A": 9, "B": 99})
        == "proved (it is never there)"
    )


def test_a_search_that_is_too_long_is_given_up():
    table = (
        "state | GO | END\n"
        + "".join(f"S{number} | S{number + 1} | S{number + 1}\n" for number in range(80))
        + "S80 | |"
    )
    ticks = {f"S{number}": 60_000 for number in range(81)}
    assert answer("S0 leads to S80 within 9 s", "", table, ticks).startswith(
        "undecided: there are too many moments"
    )


def random_table(chance, ticks):
    """Cells of all kinds, without conditions."""
    states = list(ticks)
    kinds = ("", "", "", "-", "{}", "{}", "{}", "{}!", "{} at end", "{}! at end")
    rows = [
        " | ".join((state, *(chance.choice(kinds).format(chance.choice(states)) for _ in range(3))))
        for state in states
    ]
    return "\n".join(
        (
            "state | GO | RUN | END",
            *(f"{row} | {chance.choice(states)}" for row in rows[:-1]),
            f"{rows[-1]} |",
        )
    )


@pytest.mark.parametrize("seed", range(30))
def test_a_counterexample_can_be_replayed_and_what_is_proved_is_not_seen_otherwise(seed):
    chance = random.Random(seed)
    ticks = {"A": 12, "b": 7, "C": 9, "d": 5}
    table = random_table(chance, ticks).replace("RUN | END", "RUN | HOP | END")
    start, goal = chance.sample("AbCd", 2)
    found = finding(f"{start} leads to {goal} within 250 ms", "", table, ticks)
    actor = Ticking(table, ticks)
    if "refuted" in found.message:
        assert any(goal not in run for run in after_entering(actor, dict(found.replay), start, 15))
    else:
        assert longest_seen(actor, chance, start, goal) <= 15


def entered(actor):
    """The states that were entered in the last tick, perhaps to be left in it."""
    return [actor.machine.states[state] for state in actor.last.changes.to_state]


def after_entering(actor, replay, start, count):
    """For each entry of `start` in a replay, the states that are entered with it and in the `count` ticks
    after it.
    """
    lives = [[actor.state]]
    for tick in range(1, max(replay, default=0) + 100):
        actor.step(*([replay[tick]] if tick in replay else []))
        lives.append(entered(actor))
    return [
        list(chain(*lives[tick : tick + count + 1])) for tick, states in enumerate(lives) if start in states
    ]


def longest_seen(actor, chance, start, goal):
    """The most ticks that `goal` has not come in since `start` was entered, in a random life."""
    longest, since = 0, 0 if actor.state == start else None
    for tick in range(1, 1500):
        actor.step(*([chance.choice(("GO", "RUN", "HOP"))] if chance.random() < 0.2 else []))
        for state in entered(actor):
            since = None if state == goal else tick if state == start and since is None else since
        longest = max(longest, 0 if since is None else tick - since)
    return longest
