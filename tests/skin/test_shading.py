import numpy as np
import pytest
from statwalk.skin.shading import smooth_normals, triangles

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)


@pytest.mark.parametrize(
    ("mode", "expected"),
    [(4, [[0, 1, 2]]), (5, [[0, 1, 2], [2, 1, 3], [2, 3, 4]]), (6, [[1, 2, 0], [2, 3, 0], [3, 4, 0]])],
    ids=["list", "strip", "fan"],
)
def test_triangles_of_lists_strips_and_fans(mode, expected):
    assert triangles(np.arange(5), mode).tolist() == expected


def test_a_face_gives_its_own_normal():
    assert smooth_normals(CORNERS, np.array([[0, 1, 2]]))[:3].tolist() == [[0, 0, 1]] * 3


def test_an_edge_shares_the_normals_of_its_faces_by_area():
    faces = np.array([[0, 1, 2], [0, 3, 1]])
    assert smooth_normals(CORNERS, faces)[0] == pytest.approx([0, np.sqrt(0.5), np.sqrt(0.5)])


def test_a_vertex_without_faces_points_along_z():
    assert smooth_normals(CORNERS, np.array([[0, 1, 2]]))[3].tolist() == [0, 0, 1]
