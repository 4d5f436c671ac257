"""Dual-quaternion skin against the textbook in float64, and what must hold for every pose."""

import numpy as np
import pytest
from dual_reference import posed
from random_skin import JOINTS, bones, moved, rotations, skinned

NONE = np.zeros(0, np.float32)


@pytest.fixture
def chance():
    return np.random.default_rng(11)


def drawn(surface, world):
    (part,) = surface.posed_parts(world, NONE)
    return part.positions, part.normals


@pytest.mark.parametrize("influences", [1, 2, 4, 6])
@pytest.mark.parametrize("kind", ["rigid", "stretched", "mirrored"])
def test_vertices_and_normals_are_those_of_the_textbook(chance, kind, influences):
    surface, world = skinned(chance, influences), bones(chance, kind, JOINTS)
    positions, normals = drawn(surface, world)
    expected = posed(surface, world)
    assert positions == pytest.approx(expected[0], abs=1e-5)
    assert normals == pytest.approx(expected[1], abs=3e-5)


@pytest.mark.parametrize("kind", ["rigid", "stretched", "mirrored"])
def test_one_bone_alone_moves_its_vertices_by_its_matrix(chance, kind):
    surface, world = skinned(chance, 1), bones(chance, kind, JOINTS)
    matrices = world[surface.bones[:, 0]].astype(float)
    expected = np.einsum("vab,bv->va", matrices[..., :3], surface.positions) + matrices[..., 3]
    assert drawn(surface, world)[0] == pytest.approx(expected, abs=1e-5)


def test_bones_that_turn_alike_are_blended_as_matrices(chance):
    linear = rotations(chance, 1) @ np.array([np.diag(chance.uniform(0.5, 2, 3)) for _ in range(JOINTS)])
    world = moved(chance, linear)
    dual, plain = skinned(np.random.default_rng(5), 4), skinned(np.random.default_rng(5), 4, is_dual=False)
    assert drawn(dual, world)[0] == pytest.approx(drawn(plain, world)[0], abs=1e-5)


@pytest.mark.parametrize("size", [0.01, 3.0])
def test_a_character_that_is_scaled_as_a_whole_is_only_scaled(chance, size):
    surface, world = skinned(chance, 4), bones(chance, "rigid", JOINTS)
    assert drawn(surface, world * np.float32(size))[0] == pytest.approx(
        size * drawn(surface, world)[0], abs=size * 1e-5
    )


def test_the_sign_of_a_bones_quaternion_does_not_matter(chance):
    """A turn by 350 degrees and one by -10 are the same matrix; between them and 0 the short way counts."""
    surface = skinned(chance, 2)
    turns = [np.deg2rad(angle) for angle in (0, 350, -10, 175, -175, 10)]
    world = np.zeros((JOINTS, 3, 4), np.float32)
    for row, angle in enumerate(turns):
        world[row, :, :3] = [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    assert drawn(surface, world)[0] == pytest.approx(posed(surface, world)[0], abs=1e-5)


@pytest.mark.parametrize("number", [0, np.nan, np.inf, 3e38, 1e-44])
def test_every_matrix_gives_finite_vertices_and_unit_normals(chance, number):
    world = bones(chance, "stretched", JOINTS)
    world[2] = number
    with np.errstate(all="ignore"):
        positions, normals = drawn(skinned(chance, 4), world)
    assert np.isfinite(positions).all()
    assert np.linalg.norm(normals, axis=1) == pytest.approx(np.ones(len(normals)), abs=1e-5)
