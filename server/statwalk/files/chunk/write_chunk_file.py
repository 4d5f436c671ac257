"""Writes a character as a chunk file."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.bulges_part import bulges_in_words
from statwalk.files.chunk.array_pool import PoolWriter
from statwalk.files.chunk.chunk_tree import joined
from statwalk.files.chunk.clip_chunks import clip_chunk
from statwalk.files.chunk.detail_chunks import level_chunks
from statwalk.files.chunk.mesh_chunks import polygon_chunk, skin_chunk
from statwalk.files.chunk.records import EXPR, FILE, IKCH, LARGEST_BYTES, MAGIC, OBJE, TARG, VERSION
from statwalk.files.chunk.skeleton_chunks import joint_chunks
from statwalk.files.chunk.texture_chunks import object_chunk, texture_chunk
from statwalk.files.face_yaml import in_words
from statwalk.files.gltf.model_textures import textures_of


def write_chunk_file(character: Character) -> bytes:
    """Returns the chunk file of a character: the same bytes for the same character.

    :raises ContentError: when the file would be too large, or joints are nested too deep.
    """
    textures = textures_of(character.model_glb)
    content = [texture_chunk(textures)] if any(textures.resources.values()) else []
    content += [object_chunk("MATE", dict(material)) for material in character.materials]
    data = FILE.pack(MAGIC, VERSION) + joined("HEAD", *content, _object(character))
    if len(data) > LARGEST_BYTES:
        raise ContentError(
            f"the chunk file would have {len(data) >> 20} MiB; it may have {LARGEST_BYTES >> 20} at most"
        )
    return data


def _object(character: Character) -> bytes:
    pool, polygons = PoolWriter(), dict[int, list[bytes]]()
    record = OBJE.pack(len(character.skeleton), pool.add(character.bind_pose.weights))
    for row, part in enumerate(character.parts):
        polygons.setdefault(part.joint, []).append(polygon_chunk(pool, row, part))
    skins = [skin_chunk(pool, skin) for skin in character.skins]
    levels = level_chunks(pool, character.levels)
    clips = [clip_chunk(pool, name, clip) for name, clip in character.clips.items()]
    joints = joint_chunks(character, polygons)
    name = joined("NAME", character.name.encode())
    return joined("OBJE", record, name, *pool.chunks, *skins, *levels, *joints, *clips, *_rules(character))


def _rules(character: Character) -> Iterator[bytes]:
    """Yields the chunks of chains, names of morph targets, muscles, bulges and expressions."""
    for name, joints in character.chains.items():
        rows = b"".join(IKCH.pack(character.skeleton.index(joint)) for joint in joints)
        yield joined("IKCH", IKCH.pack(len(joints)) + rows, joined("NAME", name.encode()))
    for column, target in enumerate(character.target_names):
        if target:
            yield joined("TARG", TARG.pack(column) + target.encode())
    if face := in_words(character.muscles, character.faces):
        yield object_chunk("FACE", face)
    if bulges := bulges_in_words(character.bulges):
        yield object_chunk("BULG", bulges)
    for line in character.expressions:
        yield joined("EXPR", EXPR.pack(line.line) + line.text.encode())
