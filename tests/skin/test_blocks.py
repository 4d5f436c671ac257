"""Skinning on the shapes that blocks of sixteen could get wrong, and on values that no character should
have.
"""

import numpy as np
import pytest
from statwalk.skin.deform import surface
from statwalk.skin.primitive import Primitive, Skin

CHANCE = np.random.default_rng(11)
BONES = 5
SKIN = Skin(
    "skin", np.arange(BONES, dtype=np.int32), np.broadcast_to(np.eye(4, dtype=np.float32)[:3], (BONES, 3, 4))
)
AT_REST = np.array(SKIN.inverse_bind)
NONE = np.zeros(0, np.float32)


def part(vertices, influences=3, **given):
    """A soft part of so many vertices, of which each follows its own number of bones."""
    weights = CHANCE.uniform(0.1, 1, (vertices, influences))
    weights[np.arange(influences) >= CHANCE.integers(1, influences + 1, vertices)[:, None]] = 0
    joints = CHANCE.integers(0, BONES, (vertices, influences)).astype(np.uint16)
    normals = CHANCE.normal(size=(vertices, 3))
    values = {
        "positions": CHANCE.normal(size=(vertices, 3)).astype(np.float32),
        "normals": (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32),
        "skin": 0,
        "joints": joints,
        "weights": (weights / weights.sum(axis=1, keepdims=True)).astype(np.float32),
    }
    return Primitive(0, 0, 0, 0, **(values | given))


def posed(parts, world=AT_REST, weights=NONE):
    """(V,3) positions, normals, and (P,6) bounds."""
    whole = surface(parts, [SKIN])
    flat, bounds = (
        np.full((2, whole.positions.size), np.nan, np.float32),
        np.full((len(parts), 6), np.nan, np.float32),
    )
    whole.pose_into(world, weights, flat[0], flat[1], bounds)
    return (*flat.reshape(2, -1, 3), bounds)


@pytest.mark.parametrize("vertices", [1, 15, 16, 17, 127, 128, 129, 300])
def test_bones_at_rest_change_nothing_whatever_the_number_of_vertices(vertices):
    parts = [part(vertices), part(5, 8), part(vertices, 1)]
    positions, normals, _ = posed(parts)
    assert positions == pytest.approx(np.concatenate([p.positions for p in parts]), abs=1e-6)
    assert normals == pytest.approx(np.concatenate([p.normals for p in parts]), abs=1e-6)


def test_bounds_are_those_of_each_part():
    parts = [part(40), part(3)]
    positions, _, bounds = posed(parts)
    expected = [[*span.min(axis=0), *span.max(axis=0)] for span in (positions[:40], positions[40:])]
    assert bounds.tolist() == np.array(expected).tolist()


def test_morph_targets_move_only_their_own_part():
    targets = CHANCE.normal(size=(2, 20, 3)).astype(np.float32)
    parts = [part(18), part(20, target_positions=targets, weight_first=1)]
    moved = posed(parts, weights=np.array([9, 0.5, -0.25], np.float32))[0]
    shifts = 0.5 * targets[0] - 0.25 * targets[1]
    assert moved == pytest.approx(np.concatenate([parts[0].positions, parts[1].positions + shifts]), abs=1e-5)


def test_a_morph_is_gone_when_its_weight_is():
    parts = [part(20, target_positions=np.ones((1, 20, 3), np.float32))]
    whole = surface(parts, [SKIN])
    whole.posed_parts(AT_REST, np.ones(1, np.float32))
    assert whole.posed_parts(AT_REST, np.zeros(1, np.float32))[0].positions == pytest.approx(
        parts[0].positions, abs=1e-6
    )


@pytest.mark.parametrize("value", [np.inf, -np.inf, np.nan, 3e38, 1e20])
def test_whatever_the_matrices_are_vertices_bounds_and_normals_are_finite(value):
    world = AT_REST.copy()
    world[2, 1] = value
    assert all(np.isfinite(array).all() for array in posed([part(50), part(20)], world))


def test_vertices_of_sound_bones_do_not_notice_a_broken_one():
    world = AT_REST.copy()
    world[2] = np.nan
    joints = np.where(np.arange(40) % 7 == 0, 2, 1)[:, None].astype(np.uint16)
    source = part(40, 1, joints=joints)
    sound = joints[:, 0] == 1
    positions, normals, _ = posed([source], world)
    assert positions[sound] == pytest.approx(source.positions[sound], abs=1e-6)
    assert normals[sound] == pytest.approx(source.normals[sound], abs=1e-6)


@pytest.mark.parametrize("scale", [1e-18, 1e-9, 1e9, 1e18])
def test_normals_keep_their_direction_at_any_scale(scale):
    source = part(33)
    assert posed([source], AT_REST * np.float32(scale))[1] == pytest.approx(source.normals, abs=1e-5)


@pytest.mark.parametrize(
    ("normal", "expected"), [((0, 0, 0), (0, 0, 1)), ((np.nan, 0, 0), (0, 0, 1)), ((0, 3, 4), (0, 0.6, 0.8))]
)
def test_where_a_matrix_is_flat_the_normal_at_rest_stays(normal, expected):
    source = part(20, normals=np.tile(np.array(normal, np.float32), (20, 1)))
    assert posed([source], np.zeros_like(AT_REST))[1] == pytest.approx(np.tile(expected, (20, 1)), abs=1e-6)


def test_locked_arrays_are_welcome():
    world, weights = AT_REST.copy(), np.ones(1, np.float32)
    world.setflags(write=False)
    weights.setflags(write=False)
    assert np.isfinite(
        posed([part(20, target_positions=np.ones((1, 20, 3), np.float32))], world, weights)[0]
    ).all()


def test_a_bone_that_is_not_there_is_refused():
    with pytest.raises(IndexError):
        posed([part(20, joints=np.full((20, 3), BONES + 1, np.uint16))])


@pytest.mark.parametrize("joints", [0, BONES - 1])
def test_too_few_matrices_are_refused(joints):
    with pytest.raises((ValueError, IndexError)):
        posed([part(20)], AT_REST[:joints])


@pytest.mark.parametrize("floats", [59, 61])
def test_room_of_another_size_is_refused(floats):
    with pytest.raises(ValueError):
        surface([part(20)], [SKIN]).pose_into(
            AT_REST, NONE, np.empty(floats, np.float32), np.empty(60, np.float32), np.empty((1, 6))
        )
