"""Writes the parts of a character as meshes with their skin weights."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from statwalk.character.character import Character
from statwalk.files.directx.left_handed import mirrored, row_matrices
from statwalk.files.directx.x_number_text import float_words, listed, rows_of, triangles_text
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.primitive import TRIANGLES, Primitive
from statwalk.skin.shading import triangles

FREE = -1
"""the key of meshes that hang on no joint"""


def parts_by_joint(character: Character) -> dict[tuple[int, int], list[Primitive]]:
    """Returns the parts of triangles by the joint that carries them (FREE: none) and their node."""
    joint_of = {node: joint for joint, node in enumerate(character.node_index.tolist())}
    groups: dict[tuple[int, int], list[Primitive]] = {}
    for part in character.parts:
        if part.mode >= TRIANGLES and len(part.positions):
            joint = joint_of.get(part.node, FREE if part.skin is not None else part.joint)
            groups.setdefault((joint, part.node), []).append(part)
    return groups


class MeshText:
    """The texts of meshes; `joints` and `materials` are the names in the file."""

    def __init__(self, character: Character, joints: Sequence[str], materials: Sequence[str]) -> None:
        self.character, self.joints, self.materials = character, joints, materials

    def lines(self, name: str, parts: Sequence[Primitive], joint: int) -> Iterator[str]:
        """Yields the text of one mesh, made of parts that hang on the same joint."""
        first = np.cumsum([0, *(len(part.positions) for part in parts)])
        faces = [_triangles(part) + start for part, start in zip(parts, first, strict=False)]
        corners = np.concatenate(faces)
        triangle_text = triangles_text(corners)
        weights = self.character.bind_pose.weights
        points, normals = zip(*(_at_rest(part, weights) for part in parts), strict=True)
        yield f"Mesh {name} {{\n{first[-1]};\n{rows_of(mirrored(_joined(points)))}"
        yield triangle_text
        yield f"MeshNormals {{\n{first[-1]};\n{rows_of(mirrored(_joined(normals)))}\n{triangle_text}\n}}"
        yield from _attribute_texts(parts)
        yield from self._materials(parts, [len(rows) for rows in faces])
        if any(part.skin is not None for part in parts):
            yield from self._weights(parts, first, joint)
        yield "}"

    def _materials(self, parts: Sequence[Primitive], faces: Sequence[int]) -> Iterator[str]:
        used = sorted({FREE if part.material is None else part.material for part in parts})
        if used == [FREE]:
            return
        rows = np.repeat(
            [used.index(FREE if part.material is None else part.material) for part in parts], faces
        )
        names = "\n".join(f"{{{self.materials[row]}}}" for row in used)
        yield f"MeshMaterialList {{\n{len(used)};\n{len(rows)};\n{listed(rows.tolist())}\n{names}\n}}"

    def _weights(self, parts: Sequence[Primitive], first: Ints, joint: int) -> Iterator[str]:
        """Yields XSkinMeshHeader and the SkinWeights of each bone; a rigid part beside a skinned one follows
        its joint.
        """
        bones: dict[tuple[int, bytes], list[tuple[Ints, Floats]]] = {}
        most = 1
        for part, start in zip(parts, first, strict=False):
            for bone, inverse, vertices, weights in self._influences(part, joint):
                bones.setdefault((bone, inverse.tobytes()), []).append((vertices + start, weights))
            most = max(most, part.joints.shape[1] if part.joints is not None else 1)
        yield f"XSkinMeshHeader {{\n{most};\n{min(3 * most, len(bones))};\n{len(bones)};\n}}"
        for (bone, matrix), spans in bones.items():
            vertices, weights = (np.concatenate(column) for column in zip(*spans, strict=True))
            offset = row_matrices(np.frombuffer(matrix, np.float32).reshape(3, 4).astype(np.float64))
            yield (
                f'SkinWeights {{\n"{self.joints[bone]}";\n{len(vertices)};\n{listed(vertices.tolist())}\n'
                f"{listed(float_words(weights))}\n{listed(float_words(offset))};\n}}"
            )

    def _influences(self, part: Primitive, joint: int) -> Iterator[tuple[int, Floats, Ints, Floats]]:
        """Yields joint, inverse bind matrix, vertices and weights of each bone of a part."""
        if part.skin is None or part.joints is None or part.weights is None:
            count = len(part.positions)
            yield max(joint, 0), np.eye(4, dtype=np.float32)[:3], np.arange(count), np.ones(count, np.float32)
            return
        skin = self.character.skins[part.skin]
        vertex, column = np.nonzero(part.weights > 0)
        bone, weight = part.joints[vertex, column], part.weights[vertex, column]
        for row in np.unique(bone).tolist():
            chosen = bone == row
            yield int(skin.joints[row]), skin.inverse_bind[row], vertex[chosen], weight[chosen]


def _at_rest(part: Primitive, weights: Floats) -> tuple[Floats, Floats]:
    """Returns positions and normals (V, 3) with the morph targets as they rest."""
    normals = part.normals if part.normals is not None else np.zeros_like(part.positions)
    if part.target_positions is None:
        return part.positions, normals
    own = weights[part.weight_first : part.weight_first + len(part.target_positions)]
    moved = part.positions + np.tensordot(own, part.target_positions, 1)
    return moved, normals if part.target_normals is None else normals + np.tensordot(
        own, part.target_normals, 1
    )


def _joined(arrays: Sequence[Floats]) -> Floats:
    return np.concatenate(arrays).astype(np.float64)


def _triangles(part: Primitive) -> Ints:
    """Returns the triangles (T, 3) of a part, the other way round."""
    order = np.arange(len(part.positions)) if part.indices is None else part.indices.astype(np.int64)
    return triangles(order, part.mode)[:, [0, 2, 1]]


def _attribute_texts(parts: Sequence[Primitive]) -> Iterator[str]:
    """Yields texture coordinates and colours, if a part has them; others get zeros, and white."""
    if any("TEXCOORD_0" in part.attributes for part in parts):
        coords = _joined(
            [
                part.attributes.get("TEXCOORD_0", np.zeros((len(part.positions), 2), np.float32))
                for part in parts
            ]
        )
        yield f"MeshTextureCoords {{\n{len(coords)};\n{rows_of(coords)}\n}}"
    if any("COLOR_0" in part.attributes for part in parts):
        colors = _joined(
            [part.attributes.get("COLOR_0", np.ones((len(part.positions), 4), np.float32)) for part in parts]
        )
        words = iter(float_words(colors))
        rows = ";;,\n".join(
            f"{row};{';'.join(color)}" for row, color in enumerate(zip(*(words,) * 4, strict=True))
        )
        yield f"MeshVertexColors {{\n{len(colors)};\n{rows};;;\n}}"
