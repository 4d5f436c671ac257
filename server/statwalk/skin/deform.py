"""A primitive in a pose: morphed, then moved by its skin or its joint."""

from __future__ import annotations

from collections.abc import Sequence

from statwalk.maths.arrays import Floats
from statwalk.skin import rows as affine
from statwalk.skin.morph import morphed
from statwalk.skin.primitive import Part, Primitive, Skin
from statwalk.skin.rigid import rigid_rows
from statwalk.skin.soft import blended_rows, skin_rows


def matrices(skins: Sequence[Skin], world: Floats) -> list[Floats]:
    """The rows (…,12,K) of every skin for world matrices (…,J,3,4): once a pose, however many primitives share a skin."""
    return [skin_rows(skin, world) for skin in skins]


def posed(part: Primitive, skins: Sequence[Floats], world: Floats, morphs: Floats) -> tuple[Floats, Floats | None]:
    """Positions and unit normals (…,V,3) for `skins` from `matrices`, world (…,J,3,4) and morph weights (…,W).

    A skinned mesh is placed by its joints alone, not by the node that carries it (glTF 2.0, 3.7.3.1).
    """
    positions, normals = rest(part, morphs)
    rows = rigid_rows(world, part.joint) if part.skin is None else skinned_rows(part, skins[part.skin])
    return affine.points(rows, positions), None if normals is None else affine.normals(rows, normals)


def skinned_rows(part: Primitive, rows: Floats) -> Floats:
    """Rows (…,12,V) of a skinned primitive."""
    assert part.joints is not None
    assert part.weights is not None
    return blended_rows(rows, part.joints, part.weights)


def rest(part: Primitive, morphs: Floats) -> tuple[Floats, Floats | None]:
    """Positions and normals before any joint moves them: (V,3), or (…,V,3) where there are morph targets."""
    if part.target_positions is None:
        return part.positions, part.normals
    weights = morphs[..., part.weight_first : part.weight_first + len(part.target_positions)]
    positions = morphed(part.positions, part.target_positions, weights)
    if part.normals is None or part.target_normals is None:
        return positions, part.normals
    return positions, morphed(part.normals, part.target_normals, weights)


def posed_part(part: Primitive, skins: Sequence[Floats], world: Floats, morphs: Floats) -> Part:
    """The primitive in one pose, named by its indices in the file."""
    return Part(part.node, part.mesh, part.primitive, *posed(part, skins, world, morphs))
