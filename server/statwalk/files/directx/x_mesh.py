"""A .x mesh as primitives: one for each of its materials, with the vertices that it uses."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.errors import TextError
from statwalk.files.directx.left_handed import mirrored
from statwalk.files.directx.x_faces import Faces, read_faces
from statwalk.files.directx.x_numbers import NumberReader
from statwalk.files.directx.x_objects import DataObject
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.rows import unit
from statwalk.skin.shading import smooth_normals

NORMALS, TEXTURE_COORDS, COLORS = "meshnormals", "meshtexturecoords", "meshvertexcolors"
_UP = np.array([[0.0], [1.0], [0.0]])


class XMesh(NamedTuple):
    """A mesh in glTF's convention.

    positions       (V, 3)
    faces           its polygons
    normals         (N, 3), and the normal (C,) of each corner; None: smooth normals
    texture_coords  (V, 2) or None
    colors          (V, 4) or None
    """

    positions: Floats
    faces: Faces
    normals: tuple[Floats, Ints] | None
    texture_coords: Floats | None
    colors: Floats | None


class XSurface(NamedTuple):
    """The triangles of one material: its vertices as rows of the mesh (v,), their normals (v, 3), and indices
    (n,) into these vertices.
    """

    material: int
    vertices: Ints
    normals: Floats
    indices: Ints


def read_mesh(mesh: DataObject) -> XMesh:
    """Reads a mesh with its normals, texture coordinates and colours.

    :raises TextError: when numbers are missing or wrong; `place` is the line.
    """
    numbers = NumberReader(mesh)
    count = numbers.count("vertices", 3)
    positions = mirrored(numbers.floats(3 * count, "vertices").reshape(count, 3))
    faces = read_faces(numbers, count, "faces")
    numbers.end()
    return XMesh(positions, faces, _normals(mesh, faces), _texture_coords(mesh, count), _colors(mesh, count))


def _normals(mesh: DataObject, faces: Faces) -> tuple[Floats, Ints] | None:
    part = next(mesh.of_kind(NORMALS), None)
    if part is None:
        return None
    numbers = NumberReader(part)
    count = numbers.count("normals", 3)
    values = mirrored(numbers.floats(3 * count, "normals").reshape(count, 3))
    own = read_faces(numbers, count, "faces of normals")
    numbers.end()
    if not np.array_equal(own.sizes, faces.sizes):
        raise TextError("MeshNormals must have the faces of its mesh, corner for corner", place=part.place)
    return unit(values.T, _UP).T, own.corners


def _texture_coords(mesh: DataObject, vertices: int) -> Floats | None:
    part = next(mesh.of_kind(TEXTURE_COORDS), None)
    if part is None:
        return None
    numbers = NumberReader(part)
    if numbers.count("texture coordinates", 2) != vertices:
        numbers.at = 0
        raise numbers.refuse(f"a mesh of {vertices} vertices needs {vertices} texture coordinates")
    values = numbers.floats(2 * vertices, "texture coordinates").reshape(vertices, 2)
    numbers.end()
    return values


def _colors(mesh: DataObject, vertices: int) -> Floats | None:
    """Returns the colours of vertices; white where the file has none."""
    part = next(mesh.of_kind(COLORS), None)
    if part is None:
        return None
    numbers = NumberReader(part)
    count = numbers.count("colours", 5)
    rows = numbers.floats(5 * count, "colours").reshape(count, 5)
    wrong = np.flatnonzero((rows[:, 0] < 0) | (rows[:, 0] >= vertices) | (rows[:, 0] != np.floor(rows[:, 0])))
    if len(wrong):
        numbers.at = 1 + 5 * int(wrong[0])
        raise numbers.refuse(
            f"a colour is for vertex {rows[wrong[0], 0]:g}; the mesh has {vertices} vertices"
        )
    colors = np.ones((vertices, 4))
    colors[rows[:, 0].astype(np.int64)] = rows[:, 1:].clip(0, 1)
    return colors


def surfaces(mesh: XMesh, materials: Ints) -> list[XSurface]:
    """Returns the triangles by material, given the material (F,) of each face; vertices whose corners have
    different normals are split.
    """
    triangles, face = mesh.faces.triangles()
    normals, normal_of = mesh.normals or (_smooth(mesh, triangles), mesh.faces.corners)
    keys = mesh.faces.corners * np.int64(max(len(normals), 1)) + normal_of
    made = []
    for material in np.unique(materials[face]).tolist():
        corners = triangles[materials[face] == material].reshape(-1)
        used, indices = np.unique(keys[corners], return_inverse=True)
        vertices, rows = np.divmod(used, max(len(normals), 1))
        made.append(XSurface(int(material), vertices, normals[rows], indices.reshape(-1)))
    return made


def _smooth(mesh: XMesh, triangles: Ints) -> Floats:
    return smooth_normals(mesh.positions, mesh.faces.corners[triangles])
