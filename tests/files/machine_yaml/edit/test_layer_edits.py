"""Layers that are added, changed, renamed, moved and deleted."""

import pytest
from edit_texts import DOOR, after, came, lines
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import (
    AddLayer,
    DeleteLayer,
    MoveLayer,
    RenameLayer,
    SetLayer,
    SetView,
)

ARMS = AddLayer("arms", {"mask": ["Shoulder.R"], "mode": "additive"}, "REST")


def test_a_new_layer_has_a_table():
    assert came(ARMS) == [
        "  arms:",
        "    mask: [Shoulder.R]",
        "    mode: additive",
        "    initial: REST",
        "    states: {REST: {motion: none}}",
        "    table: |",
        "      state | END",
        "      REST  |",
    ]


def test_its_members_change():
    assert lines(SetLayer("lamp", {"weight": 0.5})) == ["-     weight: wind", "+     weight: 0.5"]
    assert came(SetLayer("lamp", {"weight": None, "mode": "additive"})) == ["    mode: additive"]


def test_a_renamed_layer_keeps_its_view():
    text = after([SetView({"LIT": (1, 2)}, layer="lamp"), RenameLayer("lamp", "light")])
    assert "view:\n  base:\n    OPEN: [10, 20]\n  light:\n    LIT: [1, 2]\n" in text


def test_layers_move():
    text = after([ARMS, MoveLayer("arms", "lamp")])
    assert text.index("  arms:") < text.index("  lamp:")


def test_the_last_layer_takes_the_section_along():
    assert "layers" not in after([DeleteLayer("lamp")])


@pytest.mark.parametrize(
    ("operation", "words"),
    [
        (AddLayer("lamp"), "there is a layer lamp already"),
        (AddLayer("base"), "there is a layer base already"),
        (RenameLayer("lamp", "base"), "there is a layer base already"),
        (SetLayer("lmap", {}), "did you mean lamp"),
    ],
)
def test_refused(operation, words):
    with pytest.raises(MachineError, match=words):
        edited(DOOR, [operation])
