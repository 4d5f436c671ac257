"""Welding: a seam does not tear a mesh."""

import numpy as np
from statwalk.skin.binding.shell import welded


def test_vertices_at_one_place_are_one_point() -> None:
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0], [1, 1, 1e-9], [0, 1, 0]])
    shell = welded([square], [np.array([[0, 1, 2], [3, 4, 5]])])
    assert len(shell.points) == 4
    assert shell.of_vertex[0] == shell.of_vertex[3]
    assert shell.of_vertex[2] == shell.of_vertex[4]
    np.testing.assert_allclose(shell.points[shell.of_vertex], square, atol=1e-8)


def test_triangles_without_area_in_one_place_are_left_out() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 0]])
    assert len(welded([points], [np.array([[0, 1, 2], [1, 2, 3]])]).triangles) == 1
