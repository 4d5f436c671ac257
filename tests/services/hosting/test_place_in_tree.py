"""Inputs in words."""

import pytest
from statwalk.services.hosting.place_in_tree import words
from statwalk.stage.state.commands import Add, Command, Edit, Hold, Press, Release, Remove, Set, Travel

NAMES = {1: "Ann"}
WORDS: dict[Command, str] = {
    Press(1, "JUMP"): "JUMP to Ann",
    Press(7, "JUMP"): "JUMP to actor 7",
    Hold(1, "FORWARD"): "hold FORWARD of Ann",
    Release(1, "FORWARD"): "release FORWARD of Ann",
    Set(1, "pace", 1.5): "pace = 1.5 of Ann",
    Travel(1, "CRCH"): "Ann travels to CRCH",
    Travel(1, ""): "Ann travels no further",
    Add(2, "Bob", "faq-walker", (0.0, 0.0, 0.0), 0.0): "Bob added",
    Remove(1): "Ann removed",
    Edit("faq-walker", "faq-walker@2", "…"): "faq-walker edited",
}


@pytest.mark.parametrize("command", WORDS, ids=lambda command: type(command).__name__)
def test_each_command_has_its_words(command: Command) -> None:
    assert words(command, NAMES) == WORDS[command]
