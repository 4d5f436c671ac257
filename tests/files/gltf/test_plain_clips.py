"""Animations read in columns are the same as those read channel by channel, and what is odd is left to the
latter.
"""

import numpy as np
import pytest
from reference_poses import MODELS, place
from statwalk.errors import ModelError
from statwalk.files.gltf import read_model
from statwalk.motion.keys.channel_table import ClipChannels
from tiny_model import document, glb, model


def clip(change=None):
    root, binary = document()
    if change is not None:
        change(root)
    return read_model(glb(root, binary), "tiny").clips["Bend"]


def one_by_one(read, monkeypatch):
    """What is read without columns."""
    with monkeypatch.context() as patch:
        patch.setattr("statwalk.files.gltf.animations.plain_tables", lambda *_: {})
        return read()


@pytest.mark.parametrize("name", MODELS)
def test_both_ways_give_the_same_poses(name, monkeypatch):
    path = place(name)

    def read():
        return read_model(path.read_bytes(), path.stem, path.parent)

    slow = one_by_one(read, monkeypatch).clips
    for name, fast in read().clips.items():
        times = np.linspace(-0.1, fast.duration + 0.1, 7)
        assert fast.duration == slow[name].duration
        assert [array.tobytes() for array in fast.sample(times)] == [
            array.tobytes() for array in slow[name].sample(times)
        ]


def test_a_plain_animation_is_read_in_columns():
    assert isinstance(clip().channels, ClipChannels)


def test_its_channels_are_there_when_they_are_asked_for():
    channel = clip().channels[0]
    assert (channel.joint, channel.path, channel.interpolation, channel.times.tolist()) == (
        1,
        "rotation",
        "LINEAR",
        [0, 1],
    )


def twice(root):
    """Two channels that move the same property."""
    animation = root["animations"][0]
    animation["channels"] *= 2


def of_nothing(root):
    """A channel without a node."""
    root["animations"][0]["channels"].append({"sampler": 0, "target": {"path": "rotation"}})


@pytest.mark.parametrize("change", [twice, of_nothing])
def test_what_is_odd_is_read_one_by_one(change):
    assert [type(channel).__name__ for channel in clip(change).channels] == ["Channel"]
    assert not isinstance(clip(change).channels, ClipChannels)


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("sampler", True),
        ("sampler", 1),
        ("sampler", -1),
        ("sampler", 1 << 70),
        ("sampler", 0.5),
        ("target", []),
    ],
)
def test_what_is_wrong_is_named(field, value):
    def change(root):
        root["animations"][0]["channels"][0][field] = value

    with pytest.raises(ModelError) as caught:
        clip(change)
    assert caught.value.place == f"/animations/0/channels/0/{field}"


@pytest.mark.parametrize("value", [True, 1 << 70, -1, 2.5])
def test_a_count_that_is_no_count_is_named(value):
    def change(root):
        root["accessors"][8]["count"] = value

    with pytest.raises(ModelError) as caught:
        clip(change)
    assert caught.value.place.startswith("/accessors/8")


def test_many_key_times_are_refused_before_they_are_read():
    root, binary = document()
    root["accessors"][7] = {"componentType": 5126, "type": "SCALAR", "count": 60_000_000}
    with pytest.raises(ModelError) as caught:
        read_model(glb(root, binary), "tiny")
    assert caught.value.place == "/accessors/7/count"


def test_the_model_itself_is_read():
    assert read_model(model(), "tiny").clips["Bend"].duration == 1
