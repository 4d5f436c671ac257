"""Layers over poses, against three.js (additive) and SciPy (override), and what a mask leaves alone."""

import json
import subprocess

import khronos
import locked_arrays
import numpy as np
import pytest
from paths import ROOT
from scipy.spatial.transform import Rotation, Slerp
from slow_layers import additive, offsets, override
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.motion.layers import Mask, below

PACKAGES = ROOT / "static" / "node_modules"
RNG = np.random.default_rng(5)
TIMES = np.array([0, 0.4, 1.0], np.float32)


def pose_of(actors=4, joints=5, weights=3):
    turns = Rotation.random(actors * joints, random_state=RNG).as_quat().reshape(actors, joints, 4)
    parts = RNG.normal(size=(2, actors, joints, 3))
    return Pose(
        *(
            a.astype(np.float32)
            for a in (parts[0], turns, 1 + 0.1 * parts[1], RNG.normal(size=(actors, weights)))
        )
    )


ALL = Mask(np.arange(5), np.arange(3))
SOME = Mask(np.array([1, 3]), np.array([2]))
UNDER, OVER, FIRST = pose_of(), pose_of(), pose_of()
HALF = np.full(4, 0.5)


def angle_between(one, other):
    return (
        (Rotation.from_quat(one.reshape(-1, 4)).inv() * Rotation.from_quat(other.reshape(-1, 4)))
        .magnitude()
        .max()
    )


def test_with_all_its_weight_a_layer_is_what_is_shown():
    shown = override(UNDER, OVER, np.ones(4), ALL)
    assert (shown.translation == OVER.translation).all()
    assert angle_between(shown.rotation, OVER.rotation) < 1e-6


def test_without_weight_it_is_as_if_it_were_not_there():
    shown = override(UNDER, OVER, np.zeros(4), ALL)
    assert (shown.translation == UNDER.translation).all()
    assert angle_between(shown.rotation, UNDER.rotation) < 1e-6


def test_with_some_weight_a_joint_turns_as_far_along_the_arc():
    shown = override(UNDER, OVER, np.full(4, 0.3), ALL)
    for actor in range(4):
        for joint in range(5):
            arc = Slerp(
                [0, 1], Rotation.from_quat([UNDER.rotation[actor, joint], OVER.rotation[actor, joint]])
            )
            assert angle_between(arc(0.3).as_quat(), shown.rotation[actor, joint]) < 1e-5


@pytest.mark.parametrize(
    "lay", [lambda u, o, w, m: override(u, o, w, m), lambda u, o, w, m: additive(u, o, FIRST, w, m)]
)
def test_a_mask_leaves_all_else_alone(lay):
    shown = lay(UNDER, OVER, HALF, SOME)
    for before, after in zip(UNDER[:3], shown[:3], strict=True):
        assert (before[:, [0, 2, 4]] == after[:, [0, 2, 4]]).all()
        assert (before[:, [1, 3]] != after[:, [1, 3]]).any((1, 2)).all()
    assert (UNDER.weights[:, :2] == shown.weights[:, :2]).all()
    assert (UNDER.weights[:, 2] != shown.weights[:, 2]).all()


def test_a_difference_of_nothing_changes_nothing():
    shown = additive(UNDER, FIRST, FIRST, np.ones(4), ALL)
    assert (shown.translation == UNDER.translation).all()
    assert angle_between(shown.rotation, UNDER.rotation) < 1e-6


def clip_of(rotations, positions):
    channels = (
        Channel(0, "translation", TIMES, positions.astype(np.float32)),
        Channel(0, "rotation", TIMES, rotations.astype(np.float32)),
    )
    rest = Pose(*(array[0, :1] for array in UNDER[:3]), np.zeros(0, np.float32))
    return Clip("clip", channels, 1.0, rest)


@pytest.mark.parametrize("weight", [1.0, 0.35])
@pytest.mark.parametrize("time", [0.0, 0.25, 0.7])
def test_an_additive_layer_is_what_three_js_shows(time, weight):
    keys = [
        (Rotation.random(3, random_state=seed).as_quat(), np.random.default_rng(seed).normal(size=(3, 3)))
        for seed in (1, 2)
    ]
    given = [
        {"times": TIMES.tolist(), "position": place.tolist(), "rotation": turn.tolist()}
        for turn, place in keys
    ]
    command = [khronos.node(), ROOT / "tests" / "support" / "threelayers.mjs", PACKAGES]
    text = json.dumps({"base": given[0], "over": given[1], "time": time, "weight": weight})
    expected = np.array(
        json.loads(subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout)
    )
    base, over = (clip_of(*pair) for pair in keys)
    shown = additive(
        base.sample([time]),
        over.sample([time]),
        over.sample([0.0]),
        np.array([weight]),
        Mask(np.arange(1), np.zeros(0, np.int64)),
    )
    assert shown.translation[0, 0] == pytest.approx(expected[:3], abs=1e-5)
    assert angle_between(shown.rotation[0, 0], expected[3:]) < 1e-4


def test_a_joint_brings_along_all_that_hang_on_it():
    parent = np.array([-1, 0, 1, 1, 0, 4])
    assert below(parent, [1]).tolist() == [False, True, True, True, False, False]


def test_the_numbers_of_an_offset_that_a_mask_moves():
    moved = offsets(SOME, 5, 3)
    assert np.flatnonzero(moved).tolist() == [
        3,
        4,
        5,
        9,
        10,
        11,
        18,
        19,
        20,
        24,
        25,
        26,
        33,
        34,
        35,
        39,
        40,
        41,
        47,
    ]


def test_the_arrays_of_a_mask_cannot_be_written():
    locked_arrays.check(SOME)
