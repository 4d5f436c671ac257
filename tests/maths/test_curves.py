"""Curves against SciPy's splines."""

import numpy as np
import pytest
from hypothesis import given
from rotations import FRACTIONS
from scipy.interpolate import BSpline, CubicSpline
from scipy.spatial.transform import Rotation
from statwalk.errors import ContentError
from statwalk.maths import curves, quat

RNG = np.random.default_rng(13)


def windows(controls: np.ndarray) -> np.ndarray:
    """The four controls of each segment, (K-1, 4, n)."""
    return np.stack([controls[:-3], controls[1:-2], controls[2:-1], controls[3:]], 1)


def bspline(controls: np.ndarray, f: float) -> np.ndarray:
    """The points (…, n) at f of the segments with `controls` (…, 4, n)."""
    return (controls * curves.bspline_basis(f)[..., None]).sum(-2)


@given(FRACTIONS)
def test_bspline_weights_are_a_partition_of_unity(f):
    weights = curves.bspline_basis(f)
    assert weights.sum() == pytest.approx(1, abs=1e-15)
    assert (weights >= 0).all()


def test_bspline_is_scipys():
    controls = RNG.normal(size=(7, 3))
    spline = BSpline(np.arange(-3.0, 8), controls, 3)
    for f in (0.0, 0.3, 1.0):
        np.testing.assert_allclose(bspline(windows(controls), f), spline(np.arange(4) + f), atol=1e-14)


def test_ends_begin_and_end_on_the_end_keys():
    keys = RNG.normal(size=(5, 3))
    segments = windows(curves.ends(keys))
    np.testing.assert_allclose(bspline(segments[0], 0.0), keys[0], atol=1e-14)
    np.testing.assert_allclose(bspline(segments[-1], 1.0), keys[-1], atol=1e-14)


def test_bspline_through_is_the_natural_cubic_spline():
    keys = RNG.normal(size=(9, 3))
    segments = windows(curves.bspline_through(keys))
    expected = CubicSpline(np.arange(9), keys, bc_type="natural")
    np.testing.assert_allclose(bspline(segments, 0.4), expected(np.arange(8) + 0.4), atol=1e-12)


def test_bspline_through_a_loop_is_the_periodic_cubic_spline():
    keys = RNG.normal(size=(9, 3))
    keys[-1] = keys[0]
    segments = windows(curves.bspline_through(keys, loop=True))
    expected = CubicSpline(np.arange(9), keys, bc_type="periodic")
    np.testing.assert_allclose(bspline(segments, 0.4), expected(np.arange(8) + 0.4), atol=1e-12)


def test_a_lap_that_ends_further_on_goes_on_smoothly():
    keys, way = RNG.normal(size=(6, 3)), np.array([0.0, 0, 9])
    laps = np.concatenate([keys, keys[:1] + way])
    one = windows(curves.bspline_through(laps, loop=True))
    two = windows(curves.bspline_through(np.concatenate([laps[:-1], laps + way]), loop=True))
    np.testing.assert_allclose(
        bspline(two, 0.4),
        np.concatenate([bspline(one, 0.4) + i * way for i in range(2)]),
        atol=1e-12,
    )


def test_float32_stays():
    assert curves.bspline_through(np.eye(3, dtype=np.float32)).dtype == np.float32


def turns(count: int, degrees: float) -> np.ndarray:
    """Random rotations, each `degrees` from the one before."""
    axes = RNG.normal(size=(count, 3))
    steps = Rotation.from_rotvec(np.radians(degrees) * axes / np.linalg.norm(axes, axis=1, keepdims=True))
    chain = [Rotation.identity()]
    for step in steps[1:]:
        chain.append(chain[-1] * step)
    return np.array([rotation.as_quat() for rotation in chain])


def test_bspline_rotation_about_one_axis_is_the_bspline_of_the_angles():
    angles = np.array([[0.1], [0.5], [-0.4], [0.9]])
    controls = quat.from_axis_angle([0.0, 0.0, 1.0], angles[:, 0])
    expected = quat.from_axis_angle([0.0, 0.0, 1.0], bspline(angles, 0.3)[0])
    np.testing.assert_allclose(curves.bspline_rotation(controls, 0.3), expected, atol=1e-14)


def test_bspline_rotation_is_the_cumulative_product():
    controls = turns(4, 40.0)
    first, second, third = (curves.bspline_basis(0.6)[k:].sum() for k in (1, 2, 3))
    r = Rotation.from_quat(controls)
    steps = [
        Rotation.from_rotvec((r[k].inv() * r[k + 1]).as_rotvec() * part)
        for k, part in enumerate((first, second, third))
    ]
    expected = (r[0] * steps[0] * steps[1] * steps[2]).as_quat()
    np.testing.assert_allclose(
        quat.align(expected, curves.bspline_rotation(controls, 0.6)), expected, atol=1e-13
    )


@pytest.mark.parametrize("loop", [False, True])
def test_rotations_through_meets_every_key(loop):
    keys = turns(8, 45.0)
    keys = np.concatenate([keys, keys[-2::-1]]) if loop else keys
    segments = windows(curves.rotations_through(keys, loop))
    met = curves.bspline_rotation(segments, np.zeros(len(segments)))
    np.testing.assert_allclose(quat.align(keys[:-1], met), keys[:-1], atol=1e-9)


def test_rotations_too_far_apart_are_refused():
    with pytest.raises(ContentError, match="60 degrees"):
        curves.rotations_through(turns(12, 150.0))
