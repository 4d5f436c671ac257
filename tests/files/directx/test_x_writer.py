"""What is written reads back the same, within the digits of 32-bit floats."""

import re

import numpy as np
import pytest
import small_x
import tiny_model
from statwalk.character.character import Character
from statwalk.files.directx import read_directx, write_directx
from statwalk.files.gltf import read_model
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton

ARM = read_directx(small_x.ARM.encode(), "arm")


def again(character: Character) -> Character:
    return read_directx(write_directx(character), character.name)


def alone(
    clip_channels: tuple[Channel, ...], scale: tuple[float, ...] = (1, 1, 1), loop: bool = False
) -> Character:
    """A joint without a mesh, with one clip."""
    rest = Pose(
        np.zeros((1, 3), np.float32),
        np.array([[0, 0, 0, 1]], np.float32),
        np.array([scale], np.float32),
        np.zeros(0, np.float32),
    )
    clip = Clip(
        "c", clip_channels, max(float(channel.times[-1]) for channel in clip_channels), rest, loop=loop
    )
    return Character(
        "a", Skeleton(("b",), np.array([-1], np.int32)), np.arange(1, dtype=np.int32), rest, {"c": clip}
    )


def floats(*values: float) -> np.ndarray:
    return np.array(values, np.float32)


def test_the_hand_made_file_comes_back() -> None:
    back = again(ARM)
    assert (back.skeleton.names, back.chains, back.materials) == (
        ARM.skeleton.names,
        ARM.chains,
        ARM.materials,
    )
    assert back.skins[0].inverse_bind.tolist() == ARM.skins[0].inverse_bind.tolist()
    for name, values in vars(ARM.parts[0]).items():
        if isinstance(values, np.ndarray):
            assert getattr(back.parts[0], name).tolist() == values.tolist(), name
    assert [clip.loop for clip in back.clips.values()] == [False, True]
    assert back.notes == ()


def test_a_model_comes_back_with_the_same_poses() -> None:
    model = read_model(tiny_model.model(), "tiny")
    back = again(model)
    for time in (0.0, 0.3, 1.0):
        mine, other = model.clips["Bend"].sample(time), back.clips["Bend"].sample(time)
        assert model.world(mine) == pytest.approx(back.world(other), abs=1e-6)
        pairs = zip(model.vertices(mine), back.vertices(other), strict=True)
        assert all(np.allclose(a.positions, b.positions, atol=1e-6) for a, b in pairs)


def test_numbers_have_no_exponent_and_all_digits() -> None:
    small = alone((Channel(0, "translation", floats(0), floats(1.17549435e-38, 1e25, 0.1)[None], "LINEAR"),))
    text = write_directx(small).decode()
    assert not re.search(r"\de[-+]", text[text.index("AnimationSet") :])
    assert again(small).clips["c"].channels[2].values.tolist() == small.clips["c"].channels[0].values.tolist()


@pytest.mark.parametrize(
    ("times", "rate"),
    [
        ((0, 0.5), 24),
        ((0, 0.04), 25),
        ((0, 1 / 30), 30),
        ((0, 1 / 60), 60),
        ((0, 0.0123457, 0.77777), 1_000_000),
    ],
)
def test_ticks_are_as_coarse_as_the_keys_allow(times: tuple[float, ...], rate: int) -> None:
    moved = alone((Channel(0, "scale", floats(*times), np.ones((len(times), 3), np.float32) * 2, "LINEAR"),))
    assert f"AnimTicksPerSecond {{\n{rate};\n}}" in write_directx(moved).decode()
    scale = next(channel for channel in again(moved).clips["c"].channels if channel.path == "scale")
    assert scale.times == pytest.approx(times, abs=1e-6)


def test_jumps_stay_jumps_within_a_tick() -> None:
    jump = Channel(
        0, "translation", floats(0, 0.5, 1), np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0]], np.float32), "STEP"
    )
    back = again(alone((jump,)))
    at = [0.0, 0.49, 0.499, 0.5, 0.9, 1.0]
    assert back.clips["c"].sample(at).translation[:, 0, 0] == pytest.approx([0, 0, 0, 1, 1, 2])


def test_curves_come_back_as_linear_keys_close_together() -> None:
    values = np.zeros((2, 3, 3), np.float32)
    values[1, 1, 0], values[0, 2, 1] = 1, 3
    curve = alone((Channel(0, "translation", floats(0, 1), values, "CUBICSPLINE"),))
    at = np.linspace(0, 1, 50)
    there, here = (character.clips["c"].sample(at).translation for character in (curve, again(curve)))
    assert there == pytest.approx(here, abs=1e-3)


def test_a_mirrored_joint_moves_the_same_way() -> None:
    turn = Channel(
        0, "rotation", floats(0, 1), np.array([[0, 0, 0, 1], [0, 0.6, 0, 0.8]], np.float32), "LINEAR"
    )
    mirrored = alone((turn,), scale=(1, -2, 1))
    back = again(mirrored)
    worlds = [character.world(character.clips["c"].sample(0.5)) for character in (mirrored, back)]
    assert worlds[0] == pytest.approx(worlds[1], abs=1e-6)


def test_names_are_made_plain_and_different() -> None:
    names = ("upper arm.L", "upper_arm_L", "3rd", "template", "")
    skeleton = Skeleton(names, np.array([-1, 0, 0, 0, 0], np.int32))
    rest = Pose(
        *(np.repeat(part, 5, 0) for part in ARM.bind_pose.take(slice(0, 1))[:3]), np.zeros(0, np.float32)
    )
    character = Character("n", skeleton, np.arange(5, dtype=np.int32), rest)
    assert again(character).skeleton.names == ("upper_arm_L", "upper_arm_L_2", "_3rd", "_template", "frame")


def test_a_clip_keeps_its_length_when_only_a_lost_channel_lasts_so_long() -> None:
    weights = Channel(0, "weights", floats(0, 2), np.zeros((2, 1), np.float32), "LINEAR")
    assert again(alone((weights,))).clips["c"].duration == 2.0
