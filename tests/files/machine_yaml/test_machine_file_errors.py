"""Wrong machine files: every error names the file, the line, the name and the nearest that exists."""

import pytest
from machine_texts import ROBOT
from statwalk.errors import MachineError, StatwalkError
from statwalk.files.machine_yaml.machine_file import load_machine, read_machine

WRONG = {
    "unknown key": ("title:", "titel:", "line 4: no key is called 'titel'; did you mean title?"),
    "unknown key of a state": (
        "loop: true",
        "lop: true",
        "line 8: no key is called 'lop'; did you mean loop?",
    ),
    "unknown initial": (
        "initial: STAT",
        "initial: STATE",
        "line 5: no state is called 'STATE'; did you mean STAT?",
    ),
    "unknown row": ("  WALK  |", "  WALL  |", "line 13: no state is called 'WALL'; did you mean WALK?"),
    "unknown state of a cell": (
        "WALK/STOP",
        "WAKL/STOP",
        "line 15: no state is called 'WAKL'; did you mean WALK?",
    ),
    "unknown event of a cell": (
        "WALK/STOP",
        "WALK/STOPP",
        "line 15: no event is called 'STOPP'; did you mean STOP?",
    ),
    "unknown event of a key": (
        "hold: FORWARD",
        "hold: FOREWARD",
        "line 17: no event is called 'FOREWARD'; did you mean FORWARD?",
    ),
    "unknown idle": (
        "initial: STAT",
        "initial: STAT\nidle: STOOP",
        "line 6: no event is called 'STOOP'; did you mean STOP?",
    ),
    "no cell": ("WALK/STOP", "WALK", "line 15: 'WALK' is no cell"),
    "no next state": ("WALK/STOP", "STAT/STOP", "line 15: the cell STAT/STOP has no next state"),
    "unknown moment": ("when: end}", "when: ende}", "line 15: no moment is called 'ende'; did you mean end?"),
    "marker": (
        "when: end}",
        "when: marker left foot}",
        "line 15: no moment is called 'marker left foot'. There are: now, end",
    ),
    "window": ("when: end}", "when: window 0.2-0.6}", "line 15: `window 0.2-0.6`: a window is written A..B"),
    "window of nothing": ("when: end}", "when: window 0.2..0.2}", "line 15: `window 0.2..0.2`"),
    "enter": ("when: end}", "enter: 1.5}", "line 15: '1.5' is not a finite number from 0 to 1"),
    "curve": (
        "blend: 0.1",
        "blend: {curve: qubic}",
        "line 15: no curve is called 'qubic'; did you mean cubic?",
    ),
    "action with commas": (
        "action: halt",
        "action: drop(coins, 3)",
        "line 15: an action with a comma is written in quotes here",
    ),
    "unclosed action": ("action: halt", "action: halt(", "line 15: 'halt(' is no action"),
    "raise": ("action: halt", "action: raise(HIT)", "line 15: `raise` is written raise(EVENT, WHOM)"),
    "alternatives": (
        "{blend: 0.1, action: halt, when: end}",
        "[]",
        "line 15: a cell has 1 to 32 alternatives, not 0",
    ),
    "alternative without state": (
        "{blend: 0.1, action: halt, when: end}",
        "[{if: pace > 1}]",
        "line 15: the key `to` is missing",
    ),
    "alternative with a moment": (
        "when: end}",
        "to: [{to: STAT at end}]}",
        "line 15: 'STAT at end' is no next state",
    ),
    "alternative that never counts": (
        "when: end}",
        "to: [{to: STAT}, {to: WALK}]}",
        "line 15: this alternative never counts",
    ),
    "weights": ("when: end}", "to: {STAT: 0}}", "line 15: at least one weight must be more than 0"),
    "negative weight": ("when: end}", "to: {STAT: -1}}", "line 15: '-1' is not a finite number from 0"),
    "key of a cell": ("{blend: 0.1", "{blnd: 0.1", "line 15: no key is called 'blnd'; did you mean blend?"),
    "senses": ("title: A robot", "senses: {GO: {}}", "line 4: a sense needs a condition"),
    "layers": ("title: A robot", "layers: {base: {}}", "line 4: base is the layer that every machine has"),
    "nested list as motion": ("motion: stand", "motion: [a]", "line 8: a mapping is needed here"),
    "none as motion": (
        "motion: stand",
        "motion: none",
        "line 8: STAT has no motion; only a state of a layer above",
    ),
    "blend of one clip": (
        "motion: stand",
        "motion: {over: pace, clips: {a: 1}}",
        "line 8: a blend has 2 to 64 clips, not 1",
    ),
    "blend over nothing known": (
        "motion: stand",
        "motion: {over: pase, clips: {}}",
        "line 8: no parameter is called 'pase'; did",
    ),
    "two clips on one spot": (
        "motion: stand",
        "motion: {over: pace, clips: {a: 1, b: 1.0}}",
        "line 8: the clips a and b have the same",
    ),
    "framing": (
        "loop: true",
        "framing: uper body",
        "line 8: no framing is called 'uper body'; did you mean upper body?",
    ),
    "ground speed": ("loop: true", "ground_speed: fast", "line 8: 'fast' is no ground speed"),
    "ground speed in space": (
        "loop: true",
        "ground_speed: [0, 0, 1]",
        "line 8: two numbers are needed, [x, z]",
    ),
    "ground speed of a rocket": ("loop: true", "ground_speed: 101", "line 8: '101' is not a finite number"),
    "final outside": ("loop: true", "final: true", "line 8: `final` is only for states of a sub-machine"),
    "marker of a state": (
        "loop: true",
        "markers: {left: 2}",
        "line 8: '2' is not a finite number from 0 to 1",
    ),
    "fallback": (
        "initial: STAT",
        "initial: STAT\nfallback: STAY",
        "line 6: no state is called 'STAY'; did you mean STAT?",
    ),
    "word of the conditions": (
        "pace: {default",
        "not: {default",
        "line 19: 'not' is no name for a parameter",
    ),
    "no motion": ("motion: stand, ", "", "line 8: a state needs a motion"),
    "semantics": (
        "semantics: 1",
        "semantics: 2",
        "line 1: this version of statwalk reads semantics 1, not '2'",
    ),
    "blend": ("blend: 0.1", "blend: -1", "line 15: '-1' is not a finite number from 0 to 60"),
    "buffer": ("buffer: 0.5", "buffer: nan", "line 6: 'nan' is not a finite number"),
    "speed": ("speed: pace", "speed: -3", "line 9: '-3' is not a finite number from 0 to 100"),
    "truth": ("loop: true", "loop: yes", "line 8: 'yes' is neither true nor false"),
    "key without down": ("hold: FORWARD, ", "", "line 17: a key needs `press: EVENT`"),
    "parameter": ("min: 0.5", "min: 5", "line 19: min 5 is more than max 2"),
    "missing table": ("table: |", "description: |", "the key `table` is missing"),
    "cell text": ("| WALK    |      |", "| WALK to |      |", "line 12: 'WALK to' is no cell"),
    "repeated state": (
        "  WALK: {motion",
        "  STAT: {motion",
        "line 9: the key 'STAT' was already given in line 8",
    ),
}


@pytest.mark.parametrize(("old", "new", "message"), WRONG.values(), ids=WRONG)
def test_errors_name_file_line_and_name(old, new, message):
    assert old in ROBOT
    with pytest.raises(MachineError) as caught:
        read_machine(ROBOT.replace(old, new, 1), file="my/machine.yaml")
    assert message in str(caught.value)
    assert caught.value.file == "my/machine.yaml"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "robot.glb",
            "robot.exe",
            "line 2: 'robot.exe' is no .glb, ",
        ),
        ("character: robot.glb", "", "the key `character` is missing"),
        (
            "table: |",
            "table: ../secret.csv\ndescription: |",
            "line 10: '../secret.csv': the table's file is in the folder of the machine file",
        ),
        ("table: |", "table: steps.csv\ndescription: |", "steps.csv: there is no such file"),
    ],
)
def test_files_that_a_folder_names(tmp_path, old, new, message):
    (tmp_path / "machine.yaml").write_text(ROBOT.replace(old, new))
    with pytest.raises(MachineError) as caught:
        load_machine(tmp_path)
    assert message in str(caught.value)


def test_a_folder_without_a_machine(tmp_path):
    with pytest.raises(MachineError, match=r"machine\.yaml: there is no such file"):
        load_machine(tmp_path)


@pytest.mark.parametrize("cut", range(0, len(ROBOT), 7))
def test_any_part_of_a_file_is_read_or_refused(cut):
    for text in (
        ROBOT[:cut],
        ROBOT[cut:],
        ROBOT[:cut] + ROBOT[cut + 7 :],
        ROBOT[:cut] + ": [" + ROBOT[cut:],
    ):
        try:
            read_machine(text)
        except StatwalkError:
            continue


def many(count, form):
    return "".join(f"  {form.format(number)}\n" for number in range(count))


def test_states_and_events_multiply_and_are_counted_before_anything_is_made_of_them():
    states, events = many(1_000, "S{}: {{motion: a}}"), many(100, "E{}: {{}}")
    with pytest.raises(
        MachineError, match="line 4: 1,001 states and 103 events make more than 100,000 cells"
    ):
        read_machine(
            f"initial: A\ntable: |\n  state | GO | STOP\nstates:\n  A: {{motion: a}}\n{states}events:\n"
            f"{events}"
        )


def test_what_is_resumed_multiplies_as_well():
    inner = many(400, "      S{}: {{motion: a}}")
    text = (
        "initial: F\nstates:\n  F:\n   resume: true\n   machine:\n    initial: S0\n    states:\n"
        f"{inner}table: |\n  state | GO\n"
    )
    assert len(read_machine(text).states) == 400
    events = many(30, "E{}: {{}}")
    with pytest.raises(
        MachineError,
        match="400 states and 32 events are too many with a composite state that resumes any of 400",
    ):
        read_machine(f"{text}events:\n{events}")
