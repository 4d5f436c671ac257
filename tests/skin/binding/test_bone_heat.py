"""Laws of bone heat, and a cylinder with two bones whose weights can be told by hand."""

import numpy as np
import pytest
from rig_shapes import HALF, RADIUS, ROUND, cylinder
from statwalk.skin.binding.bind_surface import bind
from statwalk.skin.binding.bone_distance import BoneLines, sight
from statwalk.skin.binding.bone_heat import heat_weights, laplacian
from statwalk.skin.binding.shell import Shell, welded
from statwalk.skin.binding.volume import volume_of

TWO = BoneLines(np.array([[0, -0.9, 0], [0, 0, 0.0]]), np.array([[0, 0, 0], [0, 0.9, 0.0]]), np.array([0, 1]))


def shell_of(points: np.ndarray, faces: np.ndarray) -> Shell:
    return welded([points], [faces])


@pytest.fixture(scope="module")
def weights() -> np.ndarray:
    """Of the vertices of the cylinder, in their order."""
    shell = shell_of(*cylinder())
    return bind(shell, volume_of(shell), TWO, 2)[shell.of_vertex]


def test_weights_sum_to_one_and_are_not_negative(weights: np.ndarray) -> None:
    assert weights.min() >= 0
    assert weights.sum(1) == pytest.approx(1, abs=1e-9)


def test_a_ring_has_one_weight(weights: np.ndarray) -> None:
    rings = weights[:-2, 1].reshape(-1, ROUND)
    assert np.ptp(rings, axis=1).max() < 2e-3


def test_weights_rise_along_the_axis(weights: np.ndarray) -> None:
    rings = weights[:-2, 1].reshape(-1, ROUND).mean(1)
    assert (np.diff(rings) > -1e-9).all()
    assert rings[0] < 0.02
    assert rings[-1] > 0.98


def test_the_two_bones_are_each_others_mirror_image(weights: np.ndarray) -> None:
    rings = weights[:-2].reshape(-1, ROUND, 2).mean(1)
    assert rings[:, 0] == pytest.approx(rings[::-1, 1], abs=5e-3)
    assert rings[len(rings) // 2] == pytest.approx([0.5, 0.5], abs=5e-3)


def test_an_endless_cylinder_cools_exponentially() -> None:
    """Beside the joint the equation is w'' = (w - p) / d² along the axis: w = 1 - e^(-y/d) / 2 on the warm
    side.
    """
    points, faces = cylinder(161)
    shell = shell_of(points, faces)
    weights = bind(shell, volume_of(shell), TWO, 2)[shell.of_vertex]
    heights = points[:-2].reshape(-1, ROUND, 3)[:, 0, 1]
    rings = weights[:-2, 1].reshape(-1, ROUND).mean(1)
    near = (heights >= 0) & (heights < 0.6)
    assert rings[near] == pytest.approx(1 - np.exp(-heights[near] / RADIUS) / 2, abs=0.02)


def test_the_laplacian_of_a_square_is_known() -> None:
    """Two right triangles: cotangents of 45° and 90°, halved: 1/2 along the sides, next to nothing across."""
    shell = Shell(
        np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]]),
        np.array([[0, 1, 2], [0, 2, 3]]),
        np.arange(4),
    )
    matrix = laplacian(shell).toarray()
    assert matrix[0, 1] == matrix[1, 2] == matrix[2, 3] == pytest.approx(-0.5)
    assert abs(matrix[0, 2]) < 2e-3
    assert matrix.sum(1) == pytest.approx(0, abs=1e-12)


def test_a_piece_that_sees_no_bone_follows_the_nearest() -> None:
    """A small cylinder far from the bones, outside of the body that they are in."""
    points, faces = cylinder()
    away = points * 0.1 + [3, 0.5, 0]
    shell = welded([points, away], [faces, faces])
    volume = volume_of(shell)
    seen = sight(shell.points, TWO, volume)
    first = len(points)
    assert not seen.chosen[shell.of_vertex[first:]].any()
    weights = heat_weights(shell, seen, TWO.joint, 2)[shell.of_vertex[first:]]
    assert weights[:, 1] == pytest.approx(1, abs=1e-9)


def test_progress_ends_at_the_whole() -> None:
    shell = shell_of(*cylinder())
    shares: list[float] = []
    bind(shell, volume_of(shell), TWO, 2, "heat", shares.append)
    assert shares[-1] == 1


def test_nearest_is_all_or_nothing() -> None:
    shell = shell_of(*cylinder())
    weights = bind(shell, volume_of(shell), TWO, 2, "nearest")
    upper = shell.points[:, 1] > HALF / 100
    assert (weights[upper] == [0, 1]).all()
    assert (weights[shell.points[:, 1] < -HALF / 100] == [1, 0]).all()
