"""Reads a chunk file as a Character; docs/chunk.md describes the format byte by byte."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from statwalk.character.bulge_targets import checked_bulges, expressions_of_bulges
from statwalk.character.chain_of_names import chain_joints
from statwalk.character.character import Character
from statwalk.character.expressions import check_channels
from statwalk.character.muscle_targets import check_targets
from statwalk.errors import ModelError, StatwalkError
from statwalk.files.bulges_part import read_bulges
from statwalk.files.chunk.array_pool import ArrayPool, below
from statwalk.files.chunk.chunk_tree import Chunk, ChunkReader, refuse
from statwalk.files.chunk.clip_chunks import ClipReader
from statwalk.files.chunk.detail_chunks import read_levels
from statwalk.files.chunk.mesh_chunks import PolygonReader, read_skin
from statwalk.files.chunk.records import EXPR, IKCH, OBJE, TARG, Tag
from statwalk.files.chunk.skeleton_chunks import JointChunks, rest_of, skeleton_of
from statwalk.files.chunk.texture_chunks import read_object, read_textures
from statwalk.files.face_yaml import read_faces, read_muscles
from statwalk.files.gltf.model_textures import ModelTextures
from statwalk.files.gltf.read import read_model
from statwalk.files.gltf.write import model_glb
from statwalk.files.named_chains import MOST_CHAINS
from statwalk.files.yaml.yaml_text import tree_of_json
from statwalk.machine.definition.expression_definition import CLOCKS
from statwalk.machine.definition.expression_lines import read_lines
from statwalk.maths.formula.assignments import Assignment, AssignmentError
from statwalk.skin.bulge import Bulge

OBJECT_TAGS: tuple[Tag, ...] = (
    "NAME", "VECT", "BIND", "SKIN", "ANIM", "IKCH", "EXPR", "TARG", "FACE", "LODD", "BULG",
)  # fmt: skip


def read_chunk_file(data: bytes, name: str) -> Character:
    """Returns the Character in the bytes of a chunk file. Unknown chunks are skipped; `notes` name them.

    :raises ModelError: when the file is wrong; `place` is a byte offset.
    """
    reader = ChunkReader(data)
    parts: dict[str, list[Chunk]] = {"TEXT": [], "MATE": [], "OBJE": []}
    head = reader.head()
    for chunk in reader.inside(head, 0, ("TEXT", "MATE", "OBJE")):
        parts[chunk.tag].append(chunk)
    if len(parts["OBJE"]) != 1 or len(parts["TEXT"]) > 1:
        raise refuse(head, "a file has one OBJE, and one TEXT at most")
    materials = tuple(read_object(chunk) for chunk in parts["MATE"])
    textures = read_textures(reader, parts["TEXT"][0]) if parts["TEXT"] else None
    with np.errstate(over="ignore", invalid="ignore"):
        character = _ObjectReader(reader, parts["OBJE"][0]).character(name, materials)
        return replace(character, notes=_notes(reader), model_glb=_model(character, textures))


def _notes(reader: ChunkReader) -> tuple[str, ...]:
    return tuple(
        f"{count} {'chunks' if count > 1 else 'chunk'} {tag}, which statwalk does not know, skipped"
        for tag, count in sorted(reader.unknown.items())[:20]
    )


def _model(character: Character, textures: ModelTextures | None) -> bytes:
    """Returns the character as a .glb, which is read once: what glTF refuses, no viewer gets.

    :raises ModelError: when the chunks make no valid model.
    """
    try:
        model = model_glb(character, textures)
        read_model(model, character.name)
    except ModelError as error:
        raise ModelError(
            f"the chunks make no valid model: {error.message} ({error.place})", place="byte 12"
        ) from None
    return model


class _ObjectReader:
    """Reads an OBJE chunk: first the pool, then what refers to it."""

    def __init__(self, reader: ChunkReader, chunk: Chunk) -> None:
        self.reader, self.chunk = reader, chunk
        self.joint_count, self.weights_row = chunk.record(OBJE)
        self.pool, self.joints = ArrayPool(), JointChunks(reader)
        self.of: dict[str, list[Chunk]] = {tag: [] for tag in OBJECT_TAGS}
        for part in reader.inside(chunk, OBJE.size, OBJECT_TAGS):
            self.of[part.tag].append(part)

    def character(self, name: str, materials: Sequence[dict[str, object]]) -> Character:
        """Returns the character, without its model.

        :raises ModelError: when a chunk is wrong.
        """
        for chunk in self.of["VECT"]:
            self.pool.take(chunk)
        for chunk in self.of["SKIN"]:
            self.joints.take(chunk)
        character = self._skeleton(name, tuple(materials))
        polygons = PolygonReader(self.reader, self.pool, character)
        for joint, chunk in self.joints.polygons:
            polygons.take(joint, chunk)
        clips = ClipReader(self.reader, self.pool, character)
        for chunk in self.of["ANIM"]:
            clips.take(chunk)
        self._check_nodes(character, [part.node for part in polygons.parts()])
        return replace(
            character,
            parts=polygons.parts(),
            clips=clips.clips,
            chains=self._chains(character),
            **self._bulges(character),
            **self._face(character),
            levels=read_levels(self.of["LODD"], self.pool),
        )

    def _face(self, character: Character) -> dict[str, Any]:
        """Returns the muscles and named expressions."""
        if not self.of["FACE"]:
            return {}
        chunk = self.of["FACE"][0]
        try:
            entries = tree_of_json(read_object(chunk), ModelError).entries("muscles", "faces")
            muscles = read_muscles(entries.get("muscles"))
            check_targets(character, muscles)
            return {"muscles": muscles, "faces": read_faces(entries.get("faces"), muscles)}
        except StatwalkError as error:
            raise refuse(chunk, str(error)) from None

    def _bulges(self, character: Character) -> dict[str, Any]:
        """Returns the bulges, and the expressions, which set their weights."""
        expressions, bulges = self._expressions(), dict[str, Bulge]()
        for chunk in self.of["BULG"][:1]:
            try:
                entries = tree_of_json(read_object(chunk), ModelError).entries("bulges")
                bulges = checked_bulges(character, read_bulges(entries.get("bulges")))
                expressions = expressions_of_bulges(expressions, bulges)
            except StatwalkError as error:
                raise refuse(chunk, str(error)) from None
        check_channels(character, expressions, lambda message, _line: refuse(self.chunk, message))
        return {"expressions": expressions, "bulges": bulges}

    def _target_names(self, count: int) -> tuple[str, ...]:
        names = [""] * count
        for chunk in self.of["TARG"]:
            (column,) = chunk.record(TARG)
            names[below(chunk, column, count, "a morph weight")] = chunk.text(TARG.size)
        return tuple(names) if any(names) else ()

    def _skeleton(self, name: str, materials: tuple[dict[str, object], ...]) -> Character:
        joints = self.joints.in_order(self.joint_count)
        weights = self.pool.optional(self.chunk, self.weights_row, "the morph weights", "f4", (None,))
        rest = rest_of(joints, 0)
        if weights is not None:
            rest = rest._replace(weights=weights)
        return Character(
            name,
            skeleton_of(joints),
            np.array([joint.node for joint in joints], np.uint32).astype(np.int32),
            rest,
            skins=tuple(read_skin(self.reader, chunk, self.pool, len(joints)) for chunk in self.of["BIND"]),
            materials=materials,
            limits={joint.name: joint.limit for joint in joints if joint.limit is not None},
            target_names=self._target_names(rest.weights.shape[-1]),
        )

    def _check_nodes(self, character: Character, of_parts: Sequence[int]) -> None:
        """A .glb needs its nodes without a gap."""
        nodes = {*character.node_index.tolist(), *of_parts}
        if nodes != set(range(len(nodes))):
            raise refuse(self.chunk, f"the nodes of joints and parts run from 0 to {len(nodes) - 1}")

    def _chains(self, character: Character) -> dict[str, tuple[str, ...]]:
        chains: dict[str, tuple[str, ...]] = {}
        for chunk in self.of["IKCH"]:
            (count,) = chunk.record(IKCH)
            rows = chunk.numbers(IKCH.size, count)
            name, _ = self.reader.name(chunk, IKCH.size + 4 * count)
            names = [
                character.skeleton.names[below(chunk, row, len(character.skeleton), "a joint")]
                for row in rows
            ]
            if name in chains or len(chains) >= MOST_CHAINS:
                raise refuse(chunk, f"at most {MOST_CHAINS} chains, with names that differ; {name[:60]!r}")
            try:
                chain_joints(character.skeleton, names, "look-at")
            except StatwalkError as error:
                raise refuse(chunk, str(error)) from None
            chains[name] = tuple(names)
        return chains

    def _expressions(self) -> tuple[Assignment, ...]:
        lines = [(chunk.record(EXPR)[0], chunk.text(EXPR.size)) for chunk in self.of["EXPR"]]
        try:
            return read_lines(lines, (), CLOCKS)
        except AssignmentError as error:
            raise refuse(self.chunk, f"expressions: {error.message}") from None
