"""RD2 tetrahedra (FAQ Q28): each bone is drawn as one, base at its start and apex at its end; the printed
-3.306186 is -0.306186.
"""

import numpy as np
import pytest
from paths import MACHINES
from statwalk.files.character_yaml import load_character
from statwalk.files.tetrahedra import FACES, UNIT

MAMMAL = load_character(MACHINES / "faq-printed" / "character.yaml")
NAMES = MAMMAL.skeleton.names
WALK = MAMMAL.clip("walk")


def test_the_unit_tetrahedrons_base_is_an_equilateral_triangle_about_the_start():
    base = UNIT[1:]
    np.testing.assert_allclose(base.mean(0), 0, atol=1e-6)
    edges = np.linalg.norm(base - np.roll(base, 1, 0), axis=1)
    np.testing.assert_allclose(edges, edges[0], atol=2e-6)


def test_faces_look_outwards():
    corners = UNIT[FACES]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert ((corners.mean(1) - UNIT.mean(0)) * normals).sum(1).min() > 0


def test_every_bone_with_a_length_has_one():
    assert {NAMES[part.joint] for part in MAMMAL.parts} == {
        name for name in NAMES if name != "Root" and not name.endswith(".end")
    }


@pytest.mark.parametrize("time", [0.0, 0.3])
def test_base_at_the_start_and_apex_at_the_end(time):
    pose = WALK.sample(time)
    world = MAMMAL.world(pose)[:, :3, 3]
    for part, drawn in zip(MAMMAL.parts, MAMMAL.vertices(pose), strict=True):
        end = next(child for child, parent in enumerate(MAMMAL.skeleton.parent) if parent == part.joint)
        np.testing.assert_allclose(drawn.positions[0], world[end], atol=1e-5)
        np.testing.assert_allclose(drawn.positions[9:].mean(0), world[part.joint], atol=1e-5)


def test_normals_are_those_of_the_flat_faces():
    drawn = MAMMAL.vertices(WALK.sample(0.3))[3]
    face = drawn.positions.reshape(4, 3, 3)
    normals = np.cross(face[:, 1] - face[:, 0], face[:, 2] - face[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    np.testing.assert_allclose(drawn.normals.reshape(4, 3, 3), np.repeat(normals[:, None], 3, 1), atol=1e-4)
