"""The inside of meshes as voxels, against volumes known from geometry."""

import numpy as np
import pytest
from rig_shapes import boxes, cylinder
from statwalk.skin.binding.shell import welded
from statwalk.skin.binding.volume import Volume, volume_of


def body(points: np.ndarray, faces: np.ndarray) -> Volume:
    return volume_of(welded([points], [faces]))


def test_a_cylinder_has_its_volume() -> None:
    volume = body(*cylinder())
    filled = np.count_nonzero(volume.solid) * volume.size**3
    assert filled == pytest.approx(np.pi * 0.25**2 * 2, rel=0.12)  # voxels of the surface count whole


def test_depth_is_the_distance_from_the_surface() -> None:
    volume = body(*cylinder())
    heights = np.stack([np.zeros(5), np.linspace(-0.5, 0.5, 5), np.zeros(5)], -1)
    assert volume.depth_at(heights) == pytest.approx(0.25, abs=2 * volume.size)


def test_a_hole_is_closed() -> None:
    """A small triangle less: the flood from outside does not get in."""
    points, faces = cylinder()
    whole, holed = body(points, faces), body(points, faces[1:])
    assert np.count_nonzero(holed.solid) > 0.95 * np.count_nonzero(whole.solid)


def test_a_tube_open_at_both_ends_is_only_its_surface() -> None:
    points, faces = cylinder()
    tube = body(points, faces[(faces < len(points) - 2).all(1)])
    assert not tube.holds(np.array([0, 0.1, 0]))
    assert tube.holds(points[:-2]).all()


def test_overlapping_shells_are_one_body() -> None:
    volume = body(*boxes(((0, 0, 0), (1, 1, 1)), ((1, 0, 0), (1, 0.5, 0.5))))
    assert volume.holds(np.array([[0, 0, 0], [1, 0, 0], [1.9, 0, 0]])).all()
    assert not volume.holds(np.array([1.5, 0.9, 0]))


def test_a_sheet_is_its_own_body() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
    volume = body(points, np.array([[0, 1, 2], [0, 2, 3]]))
    assert volume.holds(np.array([0.5, 0.5, 0]))
    assert not volume.holds(np.array([0.5, 0.5, 0.1]))
