"""From the bytes of a .glb or .gltf to a Character, everything checked; with `write` the only way glTF comes in or goes out."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from statwalk.character import Character
from statwalk.errors import ModelError
from statwalk.files.glb import container
from statwalk.files.glb.accessors import Accessors
from statwalk.files.glb.animations import Animations
from statwalk.files.glb.document import Document, parse
from statwalk.files.glb.meshes import place_meshes
from statwalk.files.glb.nodes import hierarchy, rest_transforms
from statwalk.files.glb.pack import packed, stands_alone
from statwalk.files.glb.skins import read_skins
from statwalk.files.glb.textures import check_textures
from statwalk.files.glb.views import Views
from statwalk.maths.pose import Pose


def read_model(data: bytes, name: str, folder: Path | None = None) -> Character:
    """The Character in the bytes of a .glb or .gltf; `folder` is where files beside a .gltf are looked for.

    Raises ModelError, its place a JSON pointer or a byte, for whatever is not right and cannot be repaired; `notes` of the character
    say what was repaired. A .glb is kept as it came, unless it needs other files; a .gltf is packed into one with its buffers and images.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        if container.is_glb(data):
            text, binary = container.split(data)
            return read_document(parse(text), name, memoryview(b"") if binary is None else binary, folder, data)
        return read_text(data, name, folder)


def read_text(data: bytes, name: str, folder: Path | None) -> Character:
    """The Character in a .gltf."""
    if not data.lstrip()[:1] == b"{":
        raise ModelError("this is no glTF: it must start with glTF (a .glb) or { (a .gltf)", place="byte 0")
    return read_document(parse(data), name, None, folder, None)


def read_document(document: Document, name: str, binary: memoryview | None, folder: Path | None, source: bytes | None) -> Character:
    """The Character of a document whose first buffer may be `binary`, the binary chunk of a .glb; a .gltf (None) has none."""
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
