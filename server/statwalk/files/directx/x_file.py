"""Reads a DirectX .x file in text form as a Character: frames become joints, meshes parts, SkinWeights skins,
AnimationSets clips. FF3.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import TextError
from statwalk.files.directx.x_animation import read_clips
from statwalk.files.directx.x_chains import read_chains
from statwalk.files.directx.x_frames import XFrames, read_frames_of
from statwalk.files.directx.x_materials import MATERIAL, XMaterials
from statwalk.files.directx.x_mesh import XMesh, read_mesh, surfaces
from statwalk.files.directx.x_objects import DataObject, read_objects
from statwalk.files.directx.x_skin import BoundVertices, read_skin
from statwalk.files.directx.x_text import text_after_header
from statwalk.files.gltf import write
from statwalk.maths.arrays import Ints
from statwalk.skin.primitive import Primitive

MOST_VERTICES = 2_000_000


def read_directx(data: bytes, name: str) -> Character:
    """Reads the character of a .x file; it is mirrored into glTF's right-handed convention.

    `notes` of the character list the repairs and what was left out.

    :raises TextError: when the file is refused; `place` is the line.
    """
    notes: list[str] = []
    with np.errstate(over="ignore", invalid="ignore"):
        file = read_objects(text_after_header(data, notes))
        frames = read_frames_of(file, notes)
        skeleton, rest = frames.skeleton(), frames.rest(notes)
        drawing = _Drawing(file, frames, notes)
        parts = tuple(part for row in range(len(frames.meshes)) for part in drawing.parts(row))
        character = Character(
            name,
            skeleton,
            np.arange(len(skeleton), dtype=np.int32),
            rest,
            clips=read_clips(file, frames.row_of, rest, notes),
            skins=tuple(bound.skin for bound in drawing.skins),
            parts=parts,
            materials=tuple(drawing.materials.read),
            chains=read_chains(file, frames.row_of, skeleton, notes),
            notes=tuple(dict.fromkeys(notes)),
        )
        return replace(character, model_glb=write.model_glb(character))


class _Drawing:
    """Makes the parts of a file's meshes."""

    def __init__(self, file: DataObject, frames: XFrames, notes: list[str]) -> None:
        self.frames, self.notes = frames, notes
        self.materials = XMaterials(notes, {part.name: part for part in file.of_kind(MATERIAL)})
        self.skins: list[BoundVertices] = []
        self.vertices = 0

    def parts(self, row: int) -> Iterator[Primitive]:
        """Yields the parts of the mesh in a row of the frames' meshes."""
        part, joint, node = self.frames.meshes[row]
        mesh = read_mesh(part)
        bound, skin = self._bound(row, len(mesh.positions)), len(self.skins) - 1
        rows = self.materials.rows(part, len(mesh.faces.sizes))
        if mesh.normals is None:
            self.notes.append("a mesh without normals got smooth normals")
        for number, (material, vertices, normals, indices) in enumerate(surfaces(mesh, rows)):
            self._take(len(vertices), part)
            primitive = Primitive(
                joint=joint,
                node=node,
                mesh=row,
                primitive=number,
                positions=np.ascontiguousarray(mesh.positions[vertices], np.float32),
                normals=np.ascontiguousarray(normals, np.float32),
                indices=indices.astype(np.uint32),
                material=None if material < 0 else material,
                attributes=_attributes(mesh, vertices),
            )
            yield primitive if bound is None else _skinned(primitive, skin, bound, vertices)

    def _bound(self, row: int, vertices: int) -> BoundVertices | None:
        part, joint, node = self.frames.meshes[row]
        carrier = joint if joint == node else None
        bound = read_skin(part, vertices, self.frames.row_of, carrier, self.notes)
        if bound is not None:
            self.skins.append(bound)
        return bound

    def _take(self, vertices: int, part: DataObject) -> None:
        self.vertices += vertices
        if self.vertices > MOST_VERTICES:
            raise TextError(f"the meshes have more than {MOST_VERTICES} vertices", place=part.place)


def _attributes(mesh: XMesh, vertices: Ints) -> dict[str, np.ndarray]:
    values = {"TEXCOORD_0": mesh.texture_coords, "COLOR_0": mesh.colors}
    return {
        name: np.ascontiguousarray(rows[vertices], np.float32)
        for name, rows in values.items()
        if rows is not None
    }


def _skinned(primitive: Primitive, skin: int, bound: BoundVertices, vertices: Ints) -> Primitive:
    return replace(
        primitive,
        skin=skin,
        joints=np.ascontiguousarray(bound.joints[vertices]),
        weights=np.ascontiguousarray(bound.weights[vertices]),
    )
