"""The gearbox meshes at every angle: outlines of the shipped teeth, no deeper in each other than 0.2 mm."""

import numpy as np
import pytest
import statwalk
from polygons import overlap

UNIT = 0.05
"""metres"""
DEEPEST = 0.0002 / UNIT
ROLE = statwalk.load("gearbox")
JOINTS = ROLE.character.skeleton.names
TEETH = {"gear_a": 10, "gear_b": 8}


def outline(joint):
    """The front edge of the shipped part with the most corners, in the joint's space, in its order."""
    row = JOINTS.index(joint)
    part = max(
        (part for part in ROLE.character.parts if part.joint == row),
        key=lambda part: np.ptp(part.positions[:, 1]),
    )
    front = part.positions[part.positions[:, 2] == part.positions[:, 2].max(), :2].astype(float)
    wall = front[part.normals[part.positions[:, 2] == part.positions[:, 2].max()][:, 2] == 0]
    return wall[::2]


A, B, RACK = outline("gear_a"), outline("gear_b"), outline("strip")


def placed(polygon, degrees, x, y):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return polygon @ np.array([[c, s], [-s, c]]) + [x, y]


def meshing(degrees, slip=0.0, rack_slip=0.0):
    """The overlaps of A with B and of B with the rack when A has turned so far; B and rack out of step."""
    b = -10 / 8 * degrees
    gear_b = placed(B, b + slip, 18, 0)
    way = np.radians(b) * 8 + rack_slip
    rack = placed(RACK, 0, 26, (way + np.pi) % (2 * np.pi) - np.pi)
    return overlap(placed(A, degrees, 0, 0), gear_b), overlap(gear_b, rack)


def test_the_shipped_parts_are_gears_of_the_right_size():
    for joint, polygon in (("gear_a", A), ("gear_b", B)):
        radii = np.linalg.norm(polygon, axis=1)
        radius = TEETH[joint]  # module 2: as many units as teeth
        assert radii.max() == pytest.approx(radius + 1.6, abs=1e-4)
        assert radii.min() == pytest.approx(radius - 2, abs=1e-4)
        turned = placed(polygon, 360 / TEETH[joint], 0, 0)
        np.testing.assert_allclose(turned, np.roll(polygon, -len(polygon) // TEETH[joint], 0), atol=1e-4)


def test_no_teeth_overlap_at_any_angle():
    for degrees in np.arange(0, 36, 0.5):
        gears, rack = meshing(degrees)
        assert gears <= DEEPEST, degrees
        assert rack <= DEEPEST, degrees


@pytest.mark.parametrize("slip", [1.0, -1.0])
def test_teeth_are_in_contact_a_degree_out_of_step_overlaps(slip):
    for degrees in np.arange(0, 36, 4.0):
        assert meshing(degrees, slip=slip)[0] > 5 * DEEPEST, degrees
        assert meshing(degrees, rack_slip=slip / 10)[1] > 5 * DEEPEST, degrees


def test_on_the_stage_they_mesh_too():
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    for _ in range(40):
        stage.step(1)
        worlds = actor.world
        flat = {
            name: (polygon @ worlds[JOINTS.index(name)][:2, :2].T + worlds[JOINTS.index(name)][:2, 3]) / UNIT
            for name, polygon in (("gear_a", A), ("gear_b", B), ("strip", RACK))
        }
        assert overlap(flat["gear_a"], flat["gear_b"]) <= DEEPEST
        assert overlap(flat["gear_b"], flat["strip"]) <= DEEPEST
