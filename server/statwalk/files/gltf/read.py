"""Reads the bytes of a .glb or .gltf into a checked Character; glTF comes in only here, and goes out only
through `write`.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ModelError
from statwalk.files.gltf import container, json_text
from statwalk.files.gltf.accessors import Accessors
from statwalk.files.gltf.animations import Animations
from statwalk.files.gltf.carried import carried
from statwalk.files.gltf.compression import drop_draco
from statwalk.files.gltf.detail import with_detail_of
from statwalk.files.gltf.document import Document, parse
from statwalk.files.gltf.materials import shallow
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
    source = data if container.is_glb(data) else None
    text, binary = _parts_of(data)
    document = parse(text)
    if drop_draco(document):
        source = None
    with np.errstate(over="ignore", invalid="ignore"):
        try:
            return _read_document(document, name, binary, folder, source)
        except ModelError:
            if not json_text.make_whole(document.root):
                raise
            return _read_document(Document(document.root), name, binary, folder, None)


def _parts_of(data: bytes) -> tuple[bytes | memoryview, memoryview | None]:
    """Returns the JSON text, and the binary chunk of a .glb or None for a .gltf."""
    if container.is_glb(data):
        text, binary = container.split(data)
        return text, memoryview(b"") if binary is None else binary
    if not data.lstrip()[:1] == b"{":
        raise ModelError(
            "this is no glTF: the file must start with glTF (a .glb) or { (a .gltf)", place="byte 0"
        )
    return data, None


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
    parts, levels = with_detail_of(document, accessors, drawn.parts)
    bind_pose = Pose(*rest, drawn.weights)
    clips = Animations(document, accessors, nodes.joint_of, drawn.weight_span, bind_pose).clips()
    accessors.check_rest()
    check_textures(document, views)
    model = source if source is not None and stands_alone(document) else packed(document, views)
    character = Character(
        name=name,
        skeleton=nodes.skeleton,
        node_index=nodes.node_index,
        bind_pose=bind_pose,
        clips=clips,
        skins=skins,
        parts=parts,
        levels=levels,
        materials=tuple(shallow(material) for material in document["materials"]),
        model_glb=model,
        target_names=drawn.target_names,
    )
    return replace(carried(document, character), notes=tuple(document.notes))
