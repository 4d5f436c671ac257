"""Clamped joints, sixteen at a time, against their degrees of freedom, clamped one by one in float64."""

import numpy as np
import pytest
from late_kernel import late_kernel
from numba import types
from scipy.spatial.transform import Rotation
from statwalk.maths.clamp_kinds import CONE, EULER
from statwalk.maths.clamp_table import CLAMP_TABLE, JointLimit, clamp_table
from statwalk.maths.compiling import FLOAT, LONG, write
from statwalk.maths.packed import ADDRESSES, opened, packed
from statwalk.maths.pose import Pose
from statwalk.maths.simd.clamp_lanes import clamp_rotation
from statwalk.maths.simd.joint_lanes import clamp_joint
from statwalk.maths.simd.lanes import broadcast
from statwalk.maths.simd.pose_lanes import load3, load4, store3, store4
from statwalk.rig.joint_types import joint
from statwalk.rig.joints import clamped_transform

SLIDES = {"slide_x": (-1.0, 1.0), "slide_z": (-0.5, 2.0), "angle": (-1.0, 1.0)}
LIMITS = {
    "revolute": joint("revolute", {"angle": (-0.2, 2.3)}, axis=(1, 2, 0)),
    "prismatic": joint("prismatic", {"slide": (-0.1, 0.5)}, axis=(1, 1, 0)),
    "helical": joint("helical", {"angle": (0.0, 6 * np.pi)}, pitch=0.2),
    "cylindrical": joint("cylindrical", {"angle": (-1.5, 3.5), "slide": (0.0, 0.4)}, axis=(0, 0, 1)),
    "cone": joint("spherical", {"swing_x": (-0.3, 1.0), "swing_z": (-0.7, 0.7), "twist": (-1, 1)}),
    "round cone": joint("spherical", {"swing_x": (-0.6, 0.6), "swing_z": (-0.6, 0.6), "twist": (-2, 1)}),
    "wide cone": JointLimit(CONE, twist=(-1, 1), swing=((-2.5, 2.5), (-2.5, 2.5)), type="spherical"),
    "range": joint("spherical", {"swing_x": (0.1, 1.0), "swing_z": (-0.7, 0.7)}),
    "thin cone": joint("spherical", {"swing_x": (-1e-3, 1.0), "swing_z": (-1e-3, 0.01)}),
    "PPR": joint("planar", SLIDES, axis=(0, 1, 1)),
    "PRP": joint("planar", SLIDES, axis=(0, 1, 1), order="PRP"),
    "RPP": joint("planar", SLIDES, axis=(0, 1, 1), order="RPP"),
    "fixed axes": JointLimit(EULER, angles=((0.3, 0.3), (-0.2, -0.2), (1, 1))),
    "far axes": JointLimit(EULER, angles=((-0.1, 0.1), (1.8, 3), (2, 3.5))),
    "axes": JointLimit(EULER, angles=((-1, 0.5), (-1.8, 1.8), (-3, 0.4)), slide=((-1, 1), (0, 0), (0, 0.5))),
}
COUNT = 1600
_table = opened(CLAMP_TABLE)


@late_kernel(ADDRESSES, LONG, write(FLOAT, 3), write(FLOAT, 3))
def clamp_all(table, row, translations, rotations):
    limits = _table(table)
    for block in range(rotations.shape[0]):
        t, q = clamp_joint(limits, row, load3(translations, 48 * block), load4(rotations, 64 * block))
        store3(translations, 48 * block, t)
        store4(rotations, 64 * block, q)


@late_kernel(ADDRESSES, LONG, types.float32, write(FLOAT, 3))
def clamp_long(table, row, length, rotations):
    limits = _table(table)
    long, per_length = broadcast(length), broadcast(np.float32(1) / length)
    for block in range(rotations.shape[0]):
        x, y, z, w = load4(rotations, 64 * block)
        q = clamp_rotation(limits, row, (x * long, y * long, z * long, w * long), per_length)
        store4(rotations, 64 * block, q)


def lanes(rows):
    return np.ascontiguousarray(rows.reshape(-1, 16, rows.shape[1]).swapaxes(1, 2), np.float32)


def unlaned(blocks):
    return blocks.swapaxes(1, 2).reshape(-1, blocks.shape[1])


REST = Rotation.from_euler("xyz", [0.4, -0.2, 0.9])
PLACE = np.array([1.0, 2, 3], np.float32)
POSE = Pose(PLACE[None], REST.as_quat()[None].astype(np.float32), np.ones((1, 3), np.float32), np.zeros(0))


def clamped(limit, ways, turns):
    """Translations (N, 3) and rotations relative to the rest pose -> local ones, before and after."""
    table = packed(clamp_table({0: limit}, POSE), CLAMP_TABLE)
    before = PLACE + REST.apply(ways), (REST * turns).as_quat()
    blocks = [lanes(rows) for rows in before]
    clamp_all(table.argument, 0, *blocks)
    return [rows.astype(np.float32) for rows in before], [unlaned(rows) for rows in blocks]


@pytest.mark.parametrize("name", LIMITS)
def test_lanes_clamp_as_the_joints_do(name):
    ways = np.random.default_rng(4).normal(size=(COUNT, 3))
    turns = Rotation.random(COUNT, random_state=5)
    _, (translation, rotation) = clamped(LIMITS[name], ways, turns)
    expected_way, expected_turn = clamped_transform(LIMITS[name], ways, turns.as_quat())
    np.testing.assert_allclose(translation, PLACE + REST.apply(expected_way), atol=3e-6)
    apart = Rotation.from_quat(rotation) * (REST * Rotation.from_quat(expected_turn)).inv()
    assert np.sort(apart.magnitude())[-3] < 1e-5  # at the far pole both ends are as near


@pytest.mark.parametrize("length", [0.001, 100])
@pytest.mark.parametrize("name", ["cone", "round cone", "range", "axes", "far axes"])
def test_rotations_of_any_length_are_clamped_to_unit_length(name, length):
    turns = Rotation.random(COUNT, random_state=8)
    _, (_, expected) = clamped(LIMITS[name], np.zeros((COUNT, 3)), turns)
    blocks = lanes((REST * turns).as_quat())
    clamp_long(packed(clamp_table({0: LIMITS[name]}, POSE), CLAMP_TABLE).argument, 0, length, blocks)
    apart = np.abs(unlaned(blocks) - expected).max(1)
    assert np.sort(apart)[-3] < 3e-6  # where both ends are as near


@pytest.mark.parametrize("name", LIMITS)
def test_inside_the_limits_lanes_keep_their_bits(name):
    ways = np.random.default_rng(6).normal(size=(COUNT, 3))
    inside = clamped_transform(LIMITS[name], ways, Rotation.random(COUNT, random_state=7).as_quat())
    inside = clamped_transform(LIMITS[name], inside[0] * 0.999, inside[1])
    before, after = clamped(LIMITS[name], inside[0], Rotation.from_quat(inside[1]))
    for given, found in zip(before, after, strict=True):
        np.testing.assert_array_equal(found, given)


@pytest.mark.parametrize("name", LIMITS)
def test_at_the_poles_nothing_is_lost(name):
    poles = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [0, 0.5**0.5, 0, 0.5**0.5]])
    turns = REST.inv() * Rotation.from_quat(np.tile(poles, (16, 1)))
    _, (translation, rotation) = clamped(LIMITS[name], np.zeros((80, 3)), turns)
    assert np.isfinite(translation).all()
    np.testing.assert_allclose(np.linalg.norm(rotation, axis=1), 1, atol=1e-6)
