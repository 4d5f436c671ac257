"""Points of the skin for many poses at once, against the kernels that pose one."""

import numpy as np
from paths import MACHINES
from statwalk.character.skin_points import SkinPoints, bound_points, outermost_points
from statwalk.services.library.load import load_role

WALKER = load_role(MACHINES / "faq-walker").character
CLIP = WALKER.clips["walk"]
POSES = CLIP.sample(np.linspace(0, 1, 7))
WORLD = WALKER.world(POSES)[:, :, :3]


def vertices(row):
    return np.concatenate([part.positions for part in WALKER.vertices(POSES.take(row))])


def test_all_joints_together_carry_all_vertices_where_the_kernels_put_them():
    points = bound_points(WALKER, range(len(WALKER.skeleton)))
    assert np.abs(points.at(WORLD)[3] - vertices(3)).max() < 1e-6
    assert np.array_equal(points.heights(WORLD), points.at(WORLD)[..., 1])


def test_the_points_of_a_foot_are_its_own():
    foot = WALKER.skeleton.index("Left.foot")
    assert set(bound_points(WALKER, [foot]).carriers) == {foot}


def test_the_outermost_points_are_as_low_as_the_whole_skin():
    feet = [WALKER.skeleton.index(f"{side}.foot") for side in ("Left", "Right")]
    outermost = outermost_points(WALKER, feet)
    lowest = [vertices(row)[:, 1].min() for row in range(7)]
    assert outermost.count < 3000
    assert np.abs(outermost.heights(WORLD).min(-1) - lowest).max() < 1e-5


def test_joints_themselves_are_points():
    joint = SkinPoints.of_joints_themselves([5], len(WALKER.skeleton))
    assert np.allclose(joint.at(WORLD)[:, 0], WORLD[:, 5, :, 3])
