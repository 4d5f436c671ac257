"""Character files: what they make of texts, and what they refuse."""

import numpy as np
import pytest
from statwalk.errors import TextError
from statwalk.files.character_yaml import load_character
from statwalk.files.gltf import read_model
from text_character import from_text

SKELETON = "Root --- - - - -\nArm Root 2 1 0 0\nHand Arm 1 1 0 0\n"
WAVE = "#time 0\n#rotate Arm 0 0 0\n#time 1\n#rotate Arm 0 0 90\n"
FILE = "name: arm\nskeleton: bones.txt\nscale: 0.5\nclips:\n  wave: {keys: wave.txt}\n"


@pytest.fixture
def folder(tmp_path):
    for name, text in {"bones.txt": SKELETON, "wave.txt": WAVE, "arm.yaml": FILE}.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def test_bones_become_joints_in_metres(folder):
    arm = load_character(folder / "arm.yaml")
    assert arm.skeleton.names == ("Root", "Arm", "Hand", "Hand.end")
    np.testing.assert_allclose(
        arm.world(arm.bind_pose)[:, :3, 3], [[0, 0, 0], [0, 0, 0], [1, 0, 0], [1.5, 0, 0]]
    )


def test_the_way_of_skinning_is_the_files(folder):
    assert load_character(folder / "arm.yaml").skinning == "linear"
    (folder / "arm.yaml").write_text(FILE + "skinning: dual-quaternion\n")
    assert load_character(folder / "arm.yaml").skinning == "dual-quaternion"


def test_clips_are_sampled_in_seconds_and_degrees(folder):
    arm = load_character(folder / "arm.yaml")
    hand = arm.world(arm.clip("wave").sample(0.5))[arm.skeleton.index("Hand"), :3, 3]
    np.testing.assert_allclose(hand, [np.sqrt(0.5), np.sqrt(0.5), 0], atol=1e-6)


def test_the_model_is_a_glb(folder):
    assert load_character(folder / "arm.yaml").model_glb[:4] == b"glTF"


def test_a_shipped_skeleton_by_name(tmp_path):
    (tmp_path / "hand.yaml").write_text("skeleton: hand\nscale: 0.01\n")
    assert "thumbend" in load_character(tmp_path / "hand.yaml").skeleton.names


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("scale: 0.5", "scale: 0", r"arm.yaml, line 3: '0' is not a finite number"),
        ("scale", "sclae", r"arm.yaml, line 3: no key is called 'sclae'; did you mean scale\?"),
        ("skeleton: bones.txt\n", "", "a character needs a skeleton"),
        ("bones.txt", "../bones.txt", "line 2: '../bones.txt' must name a file in the folder of this file"),
        ("bones.txt", "/etc/passwd", "line 2: '/etc/passwd' must name a file in the folder of this file"),
        ("bones.txt", "bnes.txt", "bnes.txt: the file cannot be read: No such file"),
        (
            "wave.txt}",
            "wave.txt, interpolation: b-splin}",
            r"line 5: no interpolation is called 'b-splin'; did you mean b-spline\?",
        ),
        (
            "clips:",
            "skinning: duel-quaternion\nclips:",
            "line 4: no way of skinning is called 'duel-quaternion'; did you mean dual-quaternion",
        ),
        ("{keys: wave.txt}", "{loop: true}", "line 5: a clip needs key frames: keys: walk.txt"),
    ],
)
def test_a_wrong_character_file_is_refused(folder, old, new, message):
    (folder / "arm.yaml").write_text(FILE.replace(old, new))
    with pytest.raises(TextError, match=message):
        load_character(folder / "arm.yaml")


def test_a_key_for_a_bone_that_is_not_there_names_file_and_line(folder):
    (folder / "wave.txt").write_text(WAVE.replace("Arm 0 0 90", "Amr 0 0 90"))
    with pytest.raises(TextError, match=r"wave.txt, line 4: no bone is called 'Amr'; did you mean Arm\?"):
        load_character(folder / "arm.yaml")


def test_a_b_spline_that_cannot_pass_through_its_keys_is_refused_when_loaded(folder):
    angles = [0, 160, 0, 160, 0, 160, 0]
    (folder / "wave.txt").write_text(
        "\n".join(f"#time {t}\n#rotate Arm 0 0 {angle}" for t, angle in enumerate(angles))
    )
    (folder / "arm.yaml").write_text(FILE.replace("wave.txt}", "wave.txt, interpolation: b-spline through}"))
    with pytest.raises(TextError, match="clip wave: a B-spline cannot pass through these rotations"):
        load_character(folder / "arm.yaml")


def test_the_model_read_back_moves_alike(tmp_path):
    keys = "#time 0\n#rotate Arm 0 0 0\n#length Hand 0\n#time 1\n#rotate Arm 20 40 60\n#length Hand 1\n"
    arm = from_text(tmp_path, SKELETON, 0.5, move=(keys, "interpolation: slerp"))
    again = read_model(arm.model_glb, "arm", None)
    ours, theirs = (model.world(model.clip("move").sample(0.7)) for model in (arm, again))
    rows = [again.skeleton.index(name) for name in arm.skeleton.names]
    np.testing.assert_allclose(theirs[rows], ours, atol=1e-5)
    drawn = {part.mesh: part.positions for part in again.vertices(again.clip("move").sample(0.7))}
    for part in arm.vertices(arm.clip("move").sample(0.7)):
        np.testing.assert_allclose(drawn[part.mesh], part.positions, atol=1e-5)
