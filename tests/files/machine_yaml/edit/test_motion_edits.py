"""The clips of a blend, and markers."""

import pytest
from edit_texts import DOOR, came, lines
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import DeleteBlendClip, SetBlendClip, SetMarker


def test_a_clip_moves_on_the_pad_and_another_comes():
    assert came(SetBlendClip("OPEN", "swing", 0.75)) == ["      clips: {still: 0, swing: 0.75}"]
    assert came(SetBlendClip("OPEN", "slam", 0.5)) == ["      clips: {still: 0, swing: 1, slam: 0.5}"]


def test_a_clip_goes_with_its_markers():
    marked = edited(DOOR, [SetBlendClip("OPEN", "slam", 0.5), SetMarker("OPEN", "shut", 0.9, "slam")])
    assert "      markers: {slam: {shut: 0.9}}" in marked
    assert edited(marked, [DeleteBlendClip("OPEN", "slam")]) == DOOR


def test_a_marker_comes_moves_and_goes():
    assert came(SetMarker("SHUT", "click", 0.1)) == [
        "  SHUT:    {motion: shut, loop: true, markers: {click: 0.1}}"
    ]
    assert came(SetMarker("OPENING", "half", 0.4)) == [
        "  OPENING: {motion: open, markers: {half: 0.4}}     # slowly"
    ]
    assert edited(DOOR, [SetMarker("SHUT", "click", 0.1), SetMarker("SHUT", "click", None)]) == DOOR


def test_the_only_marker_takes_the_member_along():
    text = edited(DOOR, [SetMarker("SHUT", "click", 0.1)])
    assert lines(SetMarker("SHUT", "click", None), text=text)[1] == "+   SHUT:    {motion: shut, loop: true}"


@pytest.mark.parametrize(
    ("operation", "words"),
    [
        (SetBlendClip("SHUT", "swing", 0), "SHUT plays no blend"),
        (DeleteBlendClip("OPEN", "swnig"), "did you mean swing"),
        (SetMarker("OPENING", "hlaf", None), "did you mean half"),
    ],
)
def test_refused(operation, words):
    with pytest.raises(MachineError, match=words):
        edited(DOOR, [operation])
