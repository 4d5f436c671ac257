"""How far the vertices of a rigged character are from where the artist's weights put them."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from statwalk.character.character import Character
from statwalk.motion.clip import Clip

TIMES = 12


class VertexError(NamedTuple):
    """Distances over a clip, as shares of the body's height (or, of a lying body, its length)."""

    mean: float
    worst: float


def skinned(character: Character) -> Character:
    """The character with its skinned meshes only."""
    return replace(character, parts=tuple(part for part in character.parts if part.skin is not None))


def vertices(character: Character, clip: Clip) -> np.ndarray:
    """(T,V,3) at equal times of a clip."""
    times = np.linspace(0, clip.duration, TIMES, endpoint=False)
    poses = [character.vertices(clip.sample(time)) for time in times]
    return np.array([np.concatenate([part.positions for part in parts]) for parts in poses])


def vertex_error(artist: Character, clip: str, weights: str) -> VertexError:
    """Takes the artist's weights away, makes new ones for the same joints, and plays a clip with both."""
    artist = skinned(artist)
    ours = artist.autorig("own", weights)
    expected = vertices(artist, artist.clips[clip])
    size = np.ptp(expected[0], axis=0)
    height = size[1] if size[1] > size.max() / 4 else size.max()
    apart = np.linalg.norm(vertices(ours, artist.clips[clip]) - expected, axis=-1) / height
    return VertexError(float(apart.mean()), float(apart.max()))
