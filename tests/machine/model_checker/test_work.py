"""The work that the properties of a machine may take together, and how somebody ends it."""

import pytest
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.lint.findings import Finding
from statwalk.machine.model_checker.work import MOST_WORK, RUN_STEP_WORK, Checkpoint, go_on
from statwalk.machine.verify import verify

SECONDS = 500
COUNT = 40
"""properties, each refuted by a run of so many seconds"""
TEXT = (
    "initial: A\nstates: {A: {motion: a}, B: {motion: a}, C: {motion: a}}\n"
    "table: |\n  state | GO | END\n  A | B | A\n  B | C | A\n  C | A | A\nproperties:\n"
) + f"  - A leads to C within {SECONDS} s\n" * COUNT


def answers(checkpoint: Checkpoint = go_on) -> list[Finding]:
    findings = verify(read_machine(TEXT), {"a": MotionFacts(0.5)}, checkpoint=checkpoint)
    return [finding for finding in findings if finding.kind == "property"]


def test_all_properties_have_one_budget() -> None:
    """A run of 500 s has 30,000 ticks: the budget is enough for eight of them, and the ninth is begun."""
    runs = 1 + MOST_WORK // (SECONDS * 60 * RUN_STEP_WORK)
    words = [finding.message.split(": ", 1)[1].split(" ")[0] for finding in answers()]
    assert (runs, words) == (9, ["refuted:"] * 9 + ["undecided:"] * (COUNT - 9))


def test_what_is_beyond_the_budget_says_so() -> None:
    assert answers()[-1].message.endswith(
        "the properties before it took all the work that a machine is allowed"
    )
    assert answers()[-1].severity == "warning"


class EnoughError(Exception):
    """Ends the work."""


def test_the_work_ends_at_any_property() -> None:
    asked = []

    def checkpoint() -> None:
        asked.append(True)
        if len(asked) == 12:
            raise EnoughError

    with pytest.raises(EnoughError):
        answers(checkpoint)
    assert len(asked) == 12


def test_a_property_without_a_time_looks_at_the_checkpoint_too() -> None:
    asked = []
    text = TEXT.split("properties:")[0] + "properties:\n" + "  - C only after B\n" * COUNT
    verify(read_machine(text), checkpoint=lambda: asked.append(True))
    assert len(asked) > COUNT
