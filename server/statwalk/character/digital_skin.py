"""Gives a character a digital skin (DS7, FAQ Q20 and Q21): each vertex belongs to one bone, and one list of
polygons joins the vertices of all bones into a seamless mesh.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.maths import transform
from statwalk.maths.arrays import Floats, Ints
from statwalk.rig.evaluate import world_from_local
from statwalk.skin.primitive import Primitive, Skin
from statwalk.skin.shading import smooth_normals

NAME = "digital skin"
WHOLE = 1 - 1e-6
"""the weight of the one bone of a vertex"""
SMALLEST = 1e-12
"""of the volume that a bone at rest makes of a cubic metre"""
MATERIAL: Mapping[str, Any] = {
    "name": NAME,
    "pbrMetallicRoughness": {
        "baseColorFactor": [1.0, 1.0, 1.0, 1.0],
        "metallicFactor": 0.0,
        "roughnessFactor": 0.7,
    },
}


class DigitalSkin(NamedTuple):
    """V vertices of B bones, and the polygons between them."""

    joints: Sequence[int]
    """(B,) the joints of the bones"""
    bone: Ints
    """(V,) the place in `joints` of each vertex's bone"""
    positions: Floats
    """(V, 3) metres, in the space of the vertex's bone"""
    colours: Floats
    """(V, 3) as light, 0…1"""
    polygons: Sequence[Sequence[int]]
    """the corners of each polygon, anticlockwise seen from outside"""


def with_digital_skin(character: Character, skin: DigitalSkin) -> Character:
    """Returns the character with the digital skin as its last part, without a model.

    The bones' matrices at rest carry the vertices to where they rest; normals are those of the smooth surface
    there.

    :raises ContentError: when the scale of a bone is 0 at rest.
    """
    rest = world_from_local(character.skeleton, character.bind_pose).astype(np.float64)[list(skin.joints)]
    positions = transform.apply(rest[skin.bone], skin.positions).astype(np.float32)
    faces = _triangles(skin.polygons)
    colours = np.concatenate([skin.colours, np.ones((len(positions), 1))], 1)
    part = Primitive(
        joint=int(skin.joints[0]),
        node=1 + max((*character.node_index.tolist(), *(part.node for part in character.parts)), default=-1),
        mesh=1 + max((part.mesh for part in character.parts), default=-1),
        primitive=0,
        positions=positions,
        normals=smooth_normals(positions, faces),
        indices=faces.reshape(-1).astype(np.uint32),
        material=len(character.materials),
        skin=len(character.skins),
        joints=skin.bone.astype(np.uint16)[:, None],
        weights=np.ones((len(positions), 1), np.float32),
        weight_first=character.bind_pose.weights.shape[-1],
        attributes={"COLOR_0": colours.astype(np.float32)},
    )
    bound = Skin(NAME, np.array(skin.joints, np.int32), _inverse(character, skin.joints, rest))
    return replace(
        character,
        parts=(*character.parts, part),
        skins=(*character.skins, bound),
        materials=(*character.materials, MATERIAL),
    )


def is_digital(character: Character, part: Primitive) -> bool:
    """Returns whether a part is a digital skin: it has a skin of that name, and each vertex follows one
    bone.
    """
    if part.skin is None or part.weights is None or character.skins[part.skin].name != NAME:
        return False
    return bool((part.weights.max(1) >= WHOLE).all())


def _inverse(character: Character, joints: Sequence[int], rest: Floats) -> NDArray[np.float32]:
    """Returns the inverse bind matrices (B, 3, 4) of bones at rest."""
    flat = np.abs(np.linalg.det(rest[..., :3])) < SMALLEST
    if flat.any():
        name = character.skeleton.names[joints[int(flat.argmax())]]
        raise ContentError(f"{name} has no size at rest, so that it can carry no vertices", place=NAME)
    return transform.invert(rest).astype(np.float32)


def _triangles(polygons: Sequence[Sequence[int]]) -> Ints:
    """Returns (T, 3) the polygons as fans around their first corners."""
    corners = [
        (polygon[0], polygon[k], polygon[k + 1]) for polygon in polygons for k in range(1, len(polygon) - 1)
    ]
    return np.array(corners, np.int64)
