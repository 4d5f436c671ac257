"""Reads the bytes of a .glb or .gltf into a checked Character; glTF comes in only here, and goes out only
through `write`.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ModelError
from statwalk.files.gltf import container
from statwalk.files.gltf.accessors import Accessors
from statwalk.files.gltf.animations import Animations
from statwalk.files.gltf.document import Document, parse
from statwalk.files.gltf.meshes import place_meshes
from statwalk.files.gltf.nodes import hierarchy, rest_transforms
from statwalk.files.gltf.pack import packed, stands_alone
from statwalk.files.gltf.skins import read_skins
from statwalk.files.gltf.textures import check_textures
from statwalk.files.gltf.views import Views
from statwalk.maths.pose import Pose


def read_model(data: bytes, name: str, folder: Path | None = None) -> Character:
    """Returns the Character in the bytes of a .glb or .gltf; `folder` holds the other files of a .gltf.

    A .glb is kept as it is, unless it refers to other files; a .gltf is packed into a .glb with its buffers
    and images. `notes` of the character list the repairs.

    :raises ModelError: when the model is wrong and cannot be repaired; `place` is a JSON pointer or a byte
        offset.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        if container.is_glb(data):
            text, binary = container.split(data)
            return _read_document(
                parse(text), name, memoryview(b"") if binary is None else binary, folder, data
            )
        return _read_text(data, name, folder)


def _read_text(data: bytes, name: str, folder: Path | None) -> Character:
    if not data.lstrip()[:1] == b"{":
        raise ModelError(
            "this is no glTF: the file must start with glTF (a .glb) or { (a .gltf)", place="byte 0"
        )
    return _read_document(parse(data), name, None, folder, None)


def _read_document(
    document: Document, name: str, binary: memoryview | None, folder: Path | None, source: bytes | None
) -> Character:
    """Returns the Character of a document; `binary` is the binary chunk of a .glb, None for a .gltf."""
    views = Views(document, binary, folder)
    accessors = Accessors(document, views)
    nodes = hierarchy(document)
    rest = rest_transforms(document, nodes.node_index)
    skins = read_skins(document, accessors, nodes.joint_of)
    drawn = place_meshes(document, accessors, nodes, skins)
    bind_pose = Pose(*rest, drawn.weights)
    clips = Animations(document, accessors, nodes.joint_of, drawn.weight_span, bind_pose).clips()
    accessors.check_rest()
    check_textures(document, views)
    model = source if source is not None and stands_alone(document) else packed(document, views)
    return Character(
        name=name,
        skeleton=nodes.skeleton,
        node_index=nodes.node_index,
        bind_pose=bind_pose,
        clips=clips,
        skins=skins,
        parts=drawn.parts,
        materials=tuple(document["materials"]),
        notes=tuple(document.notes),
        model_glb=model,
    )
