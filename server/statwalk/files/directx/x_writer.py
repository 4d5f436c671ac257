"""Writes a Character as a DirectX .x file in text form, for any reader of the format. FF3."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from statwalk.character.character import Character
from statwalk.files.directx.left_handed import row_matrices
from statwalk.files.directx.x_materials import power_of
from statwalk.files.directx.x_names import XNames
from statwalk.files.directx.x_number_text import float_words, listed
from statwalk.files.directx.x_write_clips import clip_texts
from statwalk.files.directx.x_write_meshes import FREE, MeshText, parts_by_joint
from statwalk.maths import transform
from statwalk.maths.arrays import Floats
from statwalk.skin.primitive import Primitive

HEADER = "xof 0303txt 0032\n"
TEMPLATES = """template AnimTicksPerSecond {
<9e415a43-7ba6-4a73-8743-b73d47e88476>
DWORD AnimTicksPerSecond;
}
template XSkinMeshHeader {
<3cf169ce-ff7c-44ab-93c0-f78f62d172e2>
WORD nMaxSkinWeightsPerVertex;
WORD nMaxSkinWeightsPerFace;
WORD nBones;
}
template SkinWeights {
<6f0d123b-bad2-4167-a0d0-80224f25fabb>
STRING transformNodeName;
DWORD nWeights;
array DWORD vertexIndices[nWeights];
array FLOAT weights[nWeights];
Matrix4x4 matrixOffset;
}
template IKchain {
<5b1f2c9e-7a64-4d0b-9c3e-2f8d61a7b045>
[Frame <3d82ab46-62da-11cf-ab39-0020af71e433>]
}
"""
_WHITE = {"name": "white"}
"""the material of parts without one"""
_HIGHLIGHT, _NO_HIGHLIGHT = "0.5;0.5;0.5;;", "0.0;0.0;0.0;;"


def write_directx(character: Character) -> bytes:
    """Returns the character as a .x file: frames, meshes with skin weights, animation sets and IK chains.

    Coordinates are mirrored back into DirectX's left-handed convention. Numbers keep all digits of 32-bit
    floats.
    """
    names = XNames()
    joints = names.all_of(character.skeleton.names, "frame")
    all_materials = [*character.materials, _WHITE]
    materials = names.all_of((str(material.get("name", "")) for material in all_materials), "material")
    used = {len(all_materials) - 1 if part.material is None else part.material for part in character.parts}
    lines = [
        HEADER + TEMPLATES,
        *(_material_text(materials[row], all_materials[row]) for row in sorted(used)),
        *_frame_texts(character, joints, materials, names),
        *clip_texts(character, joints, XNames().all_of(character.clips, "clip")),
        *_chain_texts(character, joints, XNames()),
    ]
    return ("\n".join(lines) + "\n").encode("ascii")


def _material_text(name: str, material: Mapping[str, Any]) -> str:
    factors = material.get("pbrMetallicRoughness", {})
    factors = factors if isinstance(factors, dict) else {}
    color = _numbers(factors.get("baseColorFactor"), [1.0] * 4)
    (roughness,) = _numbers([factors.get("roughnessFactor")], [1.0])
    glow = _numbers(material.get("emissiveFactor"), [0.0] * 3)
    power = float_words(np.array([power_of(float(roughness))]))[0]
    specular = _HIGHLIGHT if roughness < 1 else _NO_HIGHLIGHT
    return (
        f"Material {name} {{\n{';'.join(float_words(color))};;\n{power};\n{specular}\n"
        f"{';'.join(float_words(glow))};;\n}}"
    )


def _numbers(values: Any, otherwise: list[float]) -> Floats:
    """Returns numbers 0…1 of a glTF material, which nobody has checked; `otherwise` if they are none."""
    good = isinstance(values, list) and len(values) == len(otherwise)
    good = good and all(isinstance(value, int | float) for value in values)
    return np.clip(np.array(values if good else otherwise, np.float64), 0, 1)


def _frame_texts(
    character: Character, joints: list[str], materials: list[str], names: XNames
) -> Iterator[str]:
    """Yields the frames with their matrices and meshes, children inside their parents; then the meshes that
    hang on no joint.
    """
    matrices = row_matrices(
        transform.from_trs(*(part.astype(np.float64) for part in character.bind_pose[:3]))
    )
    children: dict[int, list[int]] = {}
    for joint, parent in enumerate(character.skeleton.parent.tolist()):
        children.setdefault(parent, []).append(joint)
    meshes: dict[int, list[list[Primitive]]] = {}
    for (joint, _), parts in parts_by_joint(character).items():
        meshes.setdefault(joint, []).append(parts)
    mesh_text = MeshText(character, joints, materials)
    ready = children.get(FREE, [])[::-1]
    while ready:
        joint = ready.pop()
        if joint == FREE:
            yield "}"
            continue
        matrix = listed(float_words(matrices[joint]))
        yield f"Frame {joints[joint]} {{\nFrameTransformMatrix {{\n{matrix};\n}}"
        for parts in meshes.get(joint, ()):
            yield from mesh_text.lines(names.one(f"{joints[joint]}_mesh", "mesh"), parts, joint)
        ready += [FREE, *children.get(joint, [])[::-1]]
    for parts in meshes.get(FREE, ()):
        yield from mesh_text.lines(names.one("skin_mesh", "mesh"), parts, FREE)


def _chain_texts(character: Character, joints: list[str], names: XNames) -> Iterator[str]:
    for name, chain in character.chains.items():
        frames = "\n".join(f"{{{joints[character.skeleton.index(joint)]}}}" for joint in chain)
        yield f"IKchain {names.one(name, 'chain')} {{\n{frames}\n}}"
