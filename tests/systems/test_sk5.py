"""SK5 six joint types (FAQ Q4-Q10): degrees of freedom, symbols, transforms against SciPy, limits."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk import load_scene
from statwalk.rig.joint_types import freedoms, joint, symbol
from statwalk.rig.joints import clamp, transform, values

QUARTER = (-np.pi / 2, np.pi / 2)
SWING = {"swing_x": (-0.5, 1.0), "swing_z": (-0.7, 0.7)}
SLIDES = {"slide_x": (-1.0, 1.0), "slide_z": (-0.5, 2.0), "angle": (-1.0, 1.0)}
JOINTS = {
    "R1": joint("revolute", {"angle": (-0.2, 2.3)}, form="hinge"),
    "R2": joint("revolute", {"angle": QUARTER}, form="twist"),
    "R3": joint("revolute", {"angle": QUARTER}, form="turn"),
    "P": joint("prismatic", {"slide": (-0.1, 0.5)}, axis=(1, 1, 0)),
    "H": joint("helical", {"angle": (0.0, 6 * np.pi)}, pitch=0.2),
    "RP": joint("cylindrical", {"angle": QUARTER, "slide": (0.0, 0.4)}, form="offset"),
    "R͠P": joint("cylindrical", {"angle": QUARTER, "slide": (0.0, 0.4)}, form="coaxial", axis=(0, 0, 1)),
    "3R": joint("spherical", SWING),
    "PPR": joint("planar", SLIDES),
    "PRP": joint("planar", SLIDES, order="PRP"),
    "RPP": joint("planar", SLIDES, order="RPP", axis=(0, 1, 1)),
}
FREEDOMS = {
    "R1": 1,
    "R2": 1,
    "R3": 1,
    "P": 1,
    "H": 1,
    "RP": 2,
    "R͠P": 2,
    "3R": 3,
    "PPR": 3,
    "PRP": 3,
    "RPP": 3,
}
RNG = np.random.default_rng(5)


def within(limit, count=200):
    """Values inside the limits."""
    low, high = np.array([(freedom.low, freedom.high) for freedom in freedoms(limit)]).T
    return clamp(limit, RNG.uniform(low, high, (count, len(low))))


@pytest.mark.parametrize("name", JOINTS)
def test_the_type_fixes_symbol_and_degrees_of_freedom(name):
    assert (symbol(JOINTS[name]), len(freedoms(JOINTS[name]))) == (name, FREEDOMS[name])


@pytest.mark.parametrize("name", JOINTS)
def test_values_come_back_from_their_transform(name):
    wanted = within(JOINTS[name])
    np.testing.assert_allclose(values(JOINTS[name], *transform(JOINTS[name], wanted)), wanted, atol=1e-12)


@pytest.mark.parametrize("name", JOINTS)
def test_values_beyond_the_limits_are_clamped_and_others_stay(name):
    limit = JOINTS[name]
    inside = within(limit)
    np.testing.assert_allclose(clamp(limit, inside), inside, atol=1e-9)
    beyond = clamp(limit, 100 * np.sign(inside - inside.mean(0)))
    low, high = np.array([(freedom.low, freedom.high) for freedom in freedoms(limit)]).T
    assert (beyond >= low - 1e-9).all()
    assert (beyond <= high + 1e-9).all()


def test_a_hinge_bends_about_the_axis_at_right_angles_to_its_bone():
    _, rotation = transform(JOINTS["R1"], np.array([0.7]))
    np.testing.assert_allclose(rotation, Rotation.from_euler("x", 0.7).as_quat(), atol=1e-12)


def test_a_prismatic_joint_slides_along_its_axis_and_does_not_turn():
    way, rotation = transform(JOINTS["P"], np.array([0.3]))
    np.testing.assert_allclose(way, np.array([0.3, 0.3, 0]) / np.sqrt(2), atol=1e-12)
    np.testing.assert_allclose(rotation, [0, 0, 0, 1], atol=1e-12)


def test_a_turn_of_a_helical_joint_goes_its_pitch():
    way, rotation = transform(JOINTS["H"], np.array([2.5 * 2 * np.pi]))
    np.testing.assert_allclose(way, [0, 2.5 * 0.2, 0], atol=1e-12)
    assert Rotation.from_quat(rotation).magnitude() == pytest.approx(np.pi)


def test_a_spherical_joint_twists_first_and_then_swings():
    _, rotation = transform(JOINTS["3R"], np.array([0.3, -0.4, 1.1]))
    expected = Rotation.from_rotvec([0.3, 0, -0.4]) * Rotation.from_euler("y", 1.1)
    np.testing.assert_allclose(Rotation.from_quat(rotation).as_matrix(), expected.as_matrix(), atol=1e-12)


def test_the_swing_of_a_spherical_joint_stays_in_its_cone():
    x, z, _ = clamp(JOINTS["3R"], np.array([0.9, 0.6, 0.0]))
    assert (x / 1.0) ** 2 + (z / 0.7) ** 2 == pytest.approx(1)


@pytest.mark.parametrize(
    ("order", "way"),
    [("PPR", (1, 0, 2)), ("PRP", (1 + 2 * np.sin(0.5), 0, 2 * np.cos(0.5))),
     ("RPP", (np.cos(0.5) + 2 * np.sin(0.5), 0, 2 * np.cos(0.5) - np.sin(0.5)))],
)  # fmt: skip
def test_slides_after_the_turn_of_a_planar_joint_turn_with_it(order, way):
    limit = joint("planar", SLIDES, order=order)
    np.testing.assert_allclose(transform(limit, np.array([1, 2, 0.5]))[0], way, atol=1e-12)


@pytest.mark.parametrize(
    ("kind", "ranges", "more", "words"),
    [
        ("ball", {}, {}, "no type of joints is called 'ball'"),
        ("revolute", {"angle": (1, 0)}, {}, "the minimum of angle is more than its maximum: 1 > 0"),
        ("revolute", {"slide": (0, 1)}, {}, "a revolute joint has no slide"),
        ("spherical", {"swing_x": (0, np.pi / 2)}, {}, "less than 90 degrees"),
        ("prismatic", {}, {}, "needs the range of its slide"),
        ("helical", {}, {}, "has a pitch"),
        ("planar", SLIDES, {"order": "RRP"}, "no order of a planar joint is called 'RRP'"),
    ],
)
def test_a_wrong_joint_is_refused(kind, ranges, more, words):
    with pytest.raises(ValueError, match=words):
        joint(kind, ranges, **more)


def test_the_shipped_joints_show_all_six_types_and_stay_inside():
    stage = load_scene("joints").open()
    actors = [stage.actor(number) for number in range(1, 10)]
    types = {limit.type for actor in actors for limit in actor.role.limits.values()}
    before = [actor.pose for actor in actors]
    stage.step(100)
    assert types == {"revolute", "prismatic", "helical", "cylindrical", "spherical", "planar"}
    assert [actor.clamped for actor in actors] == [()] * 9
    assert all(
        np.abs(np.concatenate([a.rotation - b.rotation, a.translation - b.translation], -1)).max() > 0.01
        for a, b in zip(before, (actor.pose for actor in actors), strict=True)
    )


def test_a_slider_beyond_the_limit_holds_the_joint_at_it():
    stage = load_scene("joints").open()
    stage.send(1, "TRY")
    stage.set(1, "angle_deg", 96)
    stage.step(120)
    actor = stage.actor(1)
    turned = Rotation.from_quat(actor.pose.rotation[2]).as_euler("xyz", degrees=True)
    np.testing.assert_allclose(turned, [0, 0, 80], atol=1e-3)
    (clamped,) = actor.clamped
    assert (clamped.joint, np.degrees(clamped.angle)) == ("B", pytest.approx(16, abs=1e-2))
