"""What a character file says travels in the model: written, read again, the same; what does not fit is left
out with a note.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
import orjson
import pytest
import tiny_model
from paths import MACHINES
from statwalk.files.character_archive import read_character, write_character
from statwalk.files.character_yaml import load_character
from statwalk.files.gltf import container, read_model, write
from statwalk.motion.clip import Marker
from whole_character import whole

SAID = {
    "joints": {"knee": {"type": "revolute", "form": "hinge", "axis": [1, 0, 0], "angle_deg": [0, 150]}},
    "limits": {"hip": {"rotation_deg": [[-40, -70, -30], [40, 70, 30]]}},
    "expressions": ["knee.rotate_x = 2 * hip.rotate_x"],
}


def saying(said, clip=None):
    """The small model with these extras."""
    root, binary = tiny_model.document()
    root["extras"] = {"artist": "somebody", "statwalk": said}
    if clip is not None:
        root["animations"][0]["extras"] = {"statwalk": clip}
    return tiny_model.glb(root, binary)


def texts(character):
    return [line.text for line in character.expressions]


MAMMAL = """
skeleton: mammal
scale: 0.08
joints:
  Left.upperleg: {type: spherical, axis: [0, -1, 0], swing_x_deg: [-30, 80], swing_z_deg: [-20, 45]}
  Left.lowerleg: {type: revolute, form: hinge, axis: [1, 0, 0], angle_deg: [0, 150]}
limits:
  Head: {rotation_deg: [[-40, -70, -30], [40, 70, 30]], translation: [[0, 0, 0], [0, 0, 0]]}
clips:
  walk: {keys: walk.txt, loop: true}
expressions: |
  Head.rotate_y = 0.5 * Left.upperleg.rotate_x
"""


def test_a_character_file_survives_in_its_model(tmp_path: Path):
    (tmp_path / "walk.txt").write_text((MACHINES / "faq-printed" / "walk.txt").read_text())
    (tmp_path / "mammal.yaml").write_text(MAMMAL)
    character = load_character(tmp_path / "mammal.yaml")
    again = read_model(character.model_glb, character.name)
    assert len(character.limits) == 3
    assert len(character.expressions) == 1
    assert again.limits.keys() == character.limits.keys()
    for name, limit in character.limits.items():
        same_words(again.limits[name], limit)
    assert sorted(texts(again)) == sorted(texts(character))
    assert {name: clip.loop for name, clip in again.clips.items()} == {
        name: clip.loop for name, clip in character.clips.items() if clip.channels
    }
    assert again.notes == ()


def same_words(read, said):
    assert (read.kind, read.type, read.form, read.order) == (said.kind, said.type, said.form, said.order)
    assert abs(np.dot(read.frame, said.frame)) == pytest.approx(1, abs=1e-12)
    for key in ("twist", "swing", "angles", "pitch"):
        np.testing.assert_allclose(getattr(read, key), getattr(said, key), atol=1e-12, err_msg=key)
    assert (read.slide is None) == (said.slide is None)
    if said.slide is not None:
        np.testing.assert_allclose(read.slide, said.slide, atol=1e-12)


def test_markers_and_loops_of_clips_survive():
    character = read_model(tiny_model.model(), "tiny")
    clip = replace(
        character.clip("Bend"), loop=True, markers=(Marker("left-down", 0.25), Marker("left-down", 0.75))
    )
    again = read_model(write.model_glb(replace(character, clips={"Bend": clip})), "tiny")
    assert (again.clip("Bend").markers, again.clip("Bend").loop) == (clip.markers, True)


def test_a_model_carries_what_is_said_about_it(tmp_path: Path):
    (tmp_path / "tiny.glb").write_bytes(tiny_model.model())
    (tmp_path / "tiny.yaml").write_text(
        "model: tiny.glb\nlimits:\n  knee: {rotation_deg: [[0, 0, 0], [90, 0, 0]]}\n"
        "expressions: |\n  knee.rotate_x = 2 * hip.rotate_x\n"
    )
    character = load_character(tmp_path / "tiny.yaml")
    again = read_model(character.model_glb, "tiny")
    same_words(again.limits["knee"], character.limits["knee"])
    assert texts(again) == texts(character) == ["knee.rotate_x = 2 * hip.rotate_x"]


def test_a_character_file_comes_before_its_model(tmp_path: Path):
    (tmp_path / "tiny.glb").write_bytes(saying(SAID))
    (tmp_path / "tiny.yaml").write_text(
        "model: tiny.glb\nlimits:\n  hip: {rotation_deg: [[-1, -2, -3], [1, 2, 3]]}\n"
    )
    character = load_character(tmp_path / "tiny.yaml")
    assert character.limits["hip"].angles[0] == pytest.approx((-np.pi / 180, np.pi / 180))
    assert character.limits["knee"].type == "revolute"
    assert texts(character) == SAID["expressions"]


def test_what_others_wrote_in_extras_stays(tmp_path: Path):
    character = read_model(saying(SAID), "tiny")
    assert orjson.loads(container.split(character.model_glb)[0])["extras"]["artist"] == "somebody"
    assert character.limits["knee"].twist == pytest.approx((0, np.radians(150)))


@pytest.mark.parametrize(
    "said",
    [
        {"limits": {"nobody": {"rotation_deg": [[0, 0, 0], [1, 1, 1]]}}},
        {"expressions": ["nobody.rotate_x = 1"]},
        {"expressions": ["knee.rotate_x ="]},
        {"joints": {"knee": {"type": "rubber"}}},
        {"colour": "red"},
        [1],
        "words",
        7,
        {"limits": {"knee": [[]] * 9}},
        {"chains": {"leg": ["hip", "nobody"]}},
        {"chains": {"leg": ["knee", "hip"]}},
        {"chains": ["hip", "knee"]},
        {"chains": {"leg": "hip"}},
    ],
)
def test_what_does_not_fit_is_left_out_with_a_note(said):
    character = read_model(saying(said), "tiny")
    assert (character.limits, character.expressions) == ({}, ())
    assert "extras.statwalk is left out" in character.notes[0]


@pytest.mark.parametrize(
    "said", [[], {"markers": 3}, {"markers": [["a"]]}, {"markers": [["a", 9.0]]}, {"markers": [[1, 0.5]]}]
)
def test_wrong_markers_are_left_out_with_a_note(said):
    character = read_model(saying({}, said), "tiny")
    assert character.clip("Bend").markers == ()
    assert "Bend are left out" in character.notes[0]


def test_an_uploaded_model_keeps_what_it_carries(tmp_path: Path):
    character = read_model(saying(SAID, {"loop": True, "markers": [["down", 0.5]]}), "tiny")
    write_character(character, tmp_path / "tiny.npz")
    again = read_character(tmp_path / "tiny.npz", character.model_glb)
    assert again.limits == character.limits
    assert texts(again) == texts(character)
    assert again.clip("Bend").markers == (Marker("down", 0.5),)


def test_a_written_model_carries_all_that_the_character_says():
    source = whole()
    back = read_model(write.model_glb(source), source.name)
    assert back.chains == source.chains == {"leg": ("hip", "knee")}
    assert texts(back) == texts(source)
    assert back.limits.keys() == source.limits.keys()
    assert not back.notes
