"""SM3: the state table of FAQ Q19 as an integer array; the verifier finds exactly the misprints and proves
the FAQ's sentences.
"""

import pytest
from paths import MACHINES
from statwalk.files.machine_yaml.machine_file import load_machine, read_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.verify import verify
from statwalk.services.library.load import load

# FAQ Q19, column by column as printed.
PRINTED = """STAT STWK TLFG TRGT STAT
STWK WALK WALK WALK CSTP
WALK WALK TLFG TRGT CSTP
CSTP STAT STAT STAT STAT
TLFT TLFT TLFT TLFT CSTP
TRGT TRGT TLFT TRGY CSTP
JUMP FLY FLY FLY FLY
FLY LAND LAND LAND LAND
LAND CRCH CRCH CRCH CRCH
CRCH STUP STUP STUP STUP
STUP STAT STAT STAT STAT"""

# The corrected table: state, FORWARD, LEFT, RIGHT, STOP, JUMP, CROUCH, END; `.` is blank, `@` stands for `at
# end`.
CORRECTED = """STAT STWK TLFT TRGT STAT - CRCH .
STWK STWK . . CSTP . . WALK
WALK WALK TLFT TRGT CSTP JUMP . .
CSTP . . . CSTP . . STAT
TLFT WALK@ TLFT!@ TRGT CSTP . . STAT
TRGT WALK@ TLFT TRGT!@ CSTP . . STAT
JUMP . . . . . . FLY
FLY . . . . . . LAND
LAND . . . . . . CRCH
CRCH . . . . . CRCH@ STUP
STUP . . . . . . STAT"""


def rows(machine):
    """The built table, written as above."""
    names = {-1: ".", -2: "-"}
    for row, state in enumerate(machine.states):
        cells = []
        for column in range(len(machine.events)):
            to = int(machine.target[row, column])
            text = names.get(to) or (machine.undefined[row, column] if to == -3 else machine.states[to])
            restarts = any(part.restart for part in machine.alternatives.get((row, column), ()))
            cells.append(text + "!" * restarts + "@" * bool(machine.when[row, column]))
        yield " ".join((state, *cells))


def test_the_printed_table_is_shipped_as_printed():
    machine = load("faq-printed").machine
    assert machine.events == ("FORWARD", "LEFT", "RIGHT", "STOP", "END")
    assert machine.target.dtype == "int16"
    assert {row.replace("@", "").removesuffix(" .") for row in rows(machine)} == set(PRINTED.splitlines())


def test_the_corrected_table_is_the_walkers():
    assert "\n".join(rows(load("faq-walker").machine)) == CORRECTED


def test_the_verifier_finds_exactly_the_faults_of_the_printed_table():
    role = load("faq-printed")
    motions = {name: MotionFacts(clip.duration, clip.loop) for name, clip in role.character.clips.items()}
    undefined, unreachable = [], []
    for one in verify(role.definition, motions):
        (undefined if one.kind == "undefined state" else unreachable).append(one)
    assert [one.message.split(" is no state; did you mean ")[0] for one in undefined] == ["TLFG", "TRGY"]
    assert [one.message.split("stands in ")[1] for one in undefined] == [
        "STAT/LEFT (line 27), WALK/LEFT (line 29)",
        "TRGT/RIGHT (line 32)",
    ]
    assert {one.kind for one in unreachable} == {"unreachable state"}
    assert [one.state for one in unreachable] == ["JUMP", "FLY", "LAND", "CRCH", "STUP"]


def test_no_error_is_left_in_the_corrected_table():
    role = load("faq-walker")
    motions = {name: MotionFacts(clip.duration, clip.loop) for name, clip in role.character.clips.items()}
    assert {one.severity for one in verify(role.definition, motions)} == {"info"}


@pytest.mark.parametrize(
    ("sentence", "expected"),
    [
        ("JUMP only after WALK", "proved"),  # "can only jump … when walking"
        ("FLY only after JUMP", "proved"),  # "can only fly after jumping"
        ("STUP only after CRCH", "proved"),  # "may only stand up after crouching"
        ("LAND only after FLY", "proved"),  # "landing is only possible after flying"
        (
            "TLFT only after WALK",
            "refuted: STAT -LEFT-> TLFT",
        ),  # "can only … turn left or right when walking"
        ("TRGT only after WALK", "refuted: STAT -RIGHT-> TRGT"),
    ],
)
def test_the_sentences_of_the_faq(sentence, expected):
    text = (MACHINES / "faq-walker" / "machine.yaml").read_text()
    definition = read_machine(text[: text.index("properties:")] + f"properties: [{sentence}]\n")
    (answer,) = (one for one in verify(definition) if one.kind == "property")
    assert answer.message == f"{sentence}: {expected}"


def test_a_misprint_is_found_where_it_stands():
    text = (MACHINES / "faq-walker" / "machine.yaml").read_text()
    line = next(number for number, row in enumerate(text.splitlines(), 1) if row.startswith("  WALK  |"))
    misprinted = text.replace("  WALK  | WALK        | TLFT ", "  WALK  | WALK        | TLFG ")
    (found,) = (one for one in verify(read_machine(misprinted)) if one.severity == "error")
    assert (found.line, found.state, found.event) == (line, "WALK", "LEFT")


def test_the_printed_machine_can_be_read():
    assert load_machine(MACHINES / "faq-printed").definition.idle == "STOP"
