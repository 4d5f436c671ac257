from dataclasses import replace

import captures
import numpy as np
from statwalk.files.bvh import read_bvh
from statwalk.files.gltf import read_model
from statwalk.files.held_parts import EVERY_PART, PARTS, carriers, parts_of
from statwalk.motion.clip import Channel, Clip, Marker
from tiny_model import model


def test_a_skinned_model_with_a_morph_and_a_clip() -> None:
    parts = parts_of(read_model(model(), "tiny"))
    assert {"meshes", "skins", "morph targets", "normals", "clips"} <= parts.keys()
    assert parts["clips"] == ("Bend",)
    assert "limits" not in parts


def test_a_capture_has_no_skin() -> None:
    assert "skins" not in parts_of(read_bvh(captures.walk().encode(), "walk"))


def test_what_clips_carry_is_told_by_the_clips_that_carry_it() -> None:
    source = read_model(model(), "tiny")
    times, values = np.array([0.0, 1.0]), np.array([[1.0, 1, 1], [1, 2, 1]])
    channel = Channel(1, "scale", times, values, "STEP")
    clip = Clip("Grow", (channel,), 1.0, source.bind_pose, (Marker("tap", 0.5),), loop=True)
    parts = parts_of(replace(source, clips={**source.clips, "Grow": clip}))
    assert parts["clips after the first"] == ("Grow",)
    assert parts["stepped keys"] == parts["loops"] == ("Grow",)
    assert parts["markers"] == ("tap",)
    assert parts["scales of joints"] == ("knee",)


def test_a_node_that_only_carries_a_skin_is_no_bone() -> None:
    source = read_model(model(), "tiny")
    assert [source.skeleton.names[joint] for joint in carriers(source)] == ["skin"]
    assert "further roots" not in parts_of(source)


def test_every_kind_has_a_name() -> None:
    assert set(PARTS) == EVERY_PART
