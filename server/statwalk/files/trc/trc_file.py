"""Reads a TRC file as a Character with one clip: the body that its markers show, in metres."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.character.character import Character
from statwalk.character.markers import solve_markers
from statwalk.errors import TextError
from statwalk.files.bvh.bvh_file import text_of
from statwalk.files.gltf import write
from statwalk.files.tetrahedra import MATERIAL, joined_parts
from statwalk.files.trc.tracks import read_tracks


def read_trc(data: bytes, name: str, scale: float = 1.0) -> Character:
    """Reads the character of a TRC file; its clip is called `name` too.

    Lengths are metres times `scale`. The joints have the names of body bones; knees and elbows that no marker
    shows are found by rule 12.

    :raises TextError: when the file is refused; `place` is the line.
    """
    tracks = read_tracks(text_of(data))
    if not len(tracks.times):
        raise TextError("the file has no frame", place="line 3")
    body = solve_markers(tracks.names, tracks.times, tracks.places * scale, name)
    parts = joined_parts(body.skeleton, body.rest.translation.astype(np.float64))
    character = Character(
        name,
        body.skeleton,
        np.arange(len(body.skeleton), dtype=np.int32),
        body.rest,
        clips={name: body.clip},
        parts=parts,
        materials=(MATERIAL,),
        notes=body.notes,
    )
    return replace(character, model_glb=write.model_glb(character))
