"""Soft skin against the printed formula, in float64, one vertex at a time (RTCA Listings 4 and 5)."""

import numpy as np
import pytest
from statwalk.skin.deform import surface
from statwalk.skin.primitive import Primitive, Skin

RANDOM = np.random.default_rng(7)
JOINTS, VERTICES = 6, 40


def turns(count):
    """(count,3,4) matrices that turn, scale unevenly and move."""
    linear = np.linalg.qr(RANDOM.normal(size=(count, 3, 3)))[0] * RANDOM.uniform(0.5, 2, (count, 1, 3))
    return np.concatenate([linear, RANDOM.normal(size=(count, 3, 1))], axis=2).astype(np.float32)


WORLD, INVERSE_BIND = turns(JOINTS), turns(4)
SKIN = Skin("skin", np.array([5, 0, 2, 3], np.int32), INVERSE_BIND)
POSITIONS, RAW_NORMALS = RANDOM.normal(size=(2, VERTICES, 3)).astype(np.float32)
NORMALS = (RAW_NORMALS / np.linalg.norm(RAW_NORMALS, axis=1, keepdims=True)).astype(np.float32)


def skinned(influences):
    joints = RANDOM.integers(0, 4, (VERTICES, influences)).astype(np.uint16)
    weights = RANDOM.dirichlet(np.ones(influences), VERTICES).astype(np.float32)
    return Primitive(0, 0, 0, 0, POSITIONS, NORMALS, skin=0, joints=joints, weights=weights)


def four_by_four(matrix):
    return np.vstack([matrix.astype(float), [0, 0, 0, 1]])


def blended_matrix(part, vertex):
    """Σ wᵢ · world(bone) · inverse_bind, 4 x 4."""
    pairs = zip(part.joints[vertex], part.weights[vertex], strict=True)
    return sum(
        float(w) * four_by_four(WORLD[SKIN.joints[j]]) @ four_by_four(INVERSE_BIND[j]) for j, w in pairs
    )


@pytest.mark.parametrize("influences", [1, 2, 4, 8, 11])
def test_positions_follow_the_formula_for_any_number_of_influences(influences):
    part = skinned(influences)
    expected = [(blended_matrix(part, v) @ [*POSITIONS[v], 1])[:3] for v in range(VERTICES)]
    posed = surface([part], [SKIN]).posed_parts(WORLD, np.zeros(0, np.float32))[0]
    assert posed.positions == pytest.approx(np.array(expected), abs=1e-5)


@pytest.mark.parametrize("influences", [1, 4, 8])
def test_normals_follow_the_inverse_transpose(influences):
    part = skinned(influences)
    turned = np.array(
        [np.linalg.inv(blended_matrix(part, v)[:3, :3]).T @ NORMALS[v] for v in range(VERTICES)]
    )
    expected = turned / np.linalg.norm(turned, axis=1, keepdims=True)
    assert surface([part], [SKIN]).posed_parts(WORLD, np.zeros(0, np.float32))[0].normals == pytest.approx(
        expected, abs=1e-4
    )


def test_parts_do_not_disturb_each_other():
    soft, rigid = skinned(4), Primitive(2, 1, 1, 0, POSITIONS)
    alone = [surface([part], [SKIN]).posed_parts(WORLD, np.zeros(0))[0].positions for part in (soft, rigid)]
    together = surface([soft, rigid], [SKIN]).posed_parts(WORLD, np.zeros(0))
    assert all(np.array_equal(left, right.positions) for left, right in zip(alone, together, strict=True))


def test_points_and_lines_have_no_normals():
    assert (
        surface([Primitive(0, 0, 0, 0, POSITIONS, mode=1)], []).posed_parts(WORLD, np.zeros(0))[0].normals
        is None
    )


def test_a_character_without_parts_has_no_vertices():
    assert surface([], []).posed_parts(WORLD, np.zeros(0)) == []
