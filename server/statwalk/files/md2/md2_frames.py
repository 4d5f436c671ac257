"""Takes the frames of an MD2 file from a character: posed vertices ten times a second, in bytes of each
frame's own bounds.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.md2.md2_content import FRAME_HEAD, LARGEST_NUMBER
from statwalk.files.md2.md2_cycles import RATE, comes_round, frame_names
from statwalk.files.md2.md2_file import METRES, TO_GLTF
from statwalk.files.md2.md2_header import MOST_FRAMES, VERTEX_BYTES
from statwalk.files.md2.md2_normals import nearest_normals
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip

FROM_GLTF = np.argsort(TO_GLTF)
FLOOR = -24.0
"""where the floor lies in the file, as under Quake II's players"""
STEPS = 255
LARGEST_FRAMES = 32 << 20
SAME = 1e-4
"""metres: vertices so near to each other are in the same place"""


class TakenFrames(NamedTuple):
    """The frames of a file.

    heads   (F,) scale, origin and name of each frame
    points  (F, W, 4) the bytes of the vertices: place and number of the normal
    rows    (V,) the vertex in the file of each of the character's
    """

    heads: NDArray[Any]
    points: NDArray[np.uint8]
    rows: Ints


def taken_frames(character: Character, drawn: Sequence[int]) -> TakenFrames:
    """Returns the frames of all clips, or of the pose at rest, with the vertices of the parts `drawn`.

    Vertices that have the same bytes in every frame become one.

    :raises ContentError: when there are too many frames, or a vertex is too far away.
    """
    counts, poses = _frames(character)
    vertices = sum(len(character.parts[row].positions) for row in drawn)
    check_count("bytes of frames", VERTEX_BYTES * len(poses) * vertices, LARGEST_FRAMES)
    positions, normals = _posed(character, drawn, poses)
    heads, points = _quantised(positions, normals, frame_names(counts))
    return TakenFrames(heads, *_merged(points))


def check_count(what: str, count: int, most: int) -> None:
    """Checks how many a file would have.

    :raises ContentError: when an MD2 file cannot hold so many.
    """
    if count > most:
        raise ContentError(f"an MD2 file holds {most:,} {what} at most; this character makes {count:,}")


def _frames(character: Character) -> tuple[dict[str, int], list[Pose]]:
    """Returns the number of frames of each clip, and the poses of all; one pose at rest without clips."""
    if not character.clips:
        return {"frame": 1}, [character.bind_pose]
    times = {name: _times(clip, character) for name, clip in character.clips.items()}
    check_count("frames", sum(map(len, times.values())), MOST_FRAMES)
    poses = [character.clips[name].sample(time) for name, row in times.items() for time in row]
    return {name: len(row) for name, row in times.items()}, poses


def _times(clip: Clip, character: Character) -> Floats:
    """Returns when the frames of a clip are taken: all around, or to its end, the last frame then too."""
    steps = max(1, round(clip.duration * RATE))
    if clip.duration <= 0:
        return np.zeros(1)
    check_count("frames", steps, MOST_FRAMES)
    times = np.linspace(0, clip.duration, steps + 1)
    return times[:-1] if comes_round(clip.name) and _meets(clip, character) else times


def _meets(clip: Clip, character: Character) -> bool:
    """Returns whether the clip ends as it begins."""
    first, last = (character.vertices(clip.sample(time)) for time in (0.0, clip.duration))
    return all(np.abs(a.positions - b.positions).max() < SAME for a, b in zip(first, last, strict=True))


def _posed(character: Character, drawn: Sequence[int], poses: Iterable[Pose]) -> tuple[Floats, Floats]:
    """Returns positions and normals (F, V, 3) in the units and along the axes of the file."""
    positions, normals = [], []
    for pose in poses:
        parts = character.vertices(pose)
        positions.append(np.concatenate([parts[row].positions for row in drawn]))
        normals.append(
            np.concatenate([_normals_of(parts[row].normals, parts[row].positions) for row in drawn])
        )
    units = np.stack(positions).astype(np.float64)[..., FROM_GLTF] / METRES
    units[..., 2] += FLOOR
    if not (np.abs(units) <= LARGEST_NUMBER).all():
        raise ContentError(
            f"an MD2 file holds places within {LARGEST_NUMBER:,.0f} inches; this character reaches farther"
        )
    return units, np.stack(normals)[..., FROM_GLTF]


def _normals_of(normals: NDArray[np.float32] | None, positions: Floats) -> Floats:
    return np.zeros(positions.shape, np.float32) if normals is None else normals


def _quantised(
    positions: Floats, normals: Floats, names: Sequence[str]
) -> tuple[NDArray[Any], NDArray[np.uint8]]:
    """Returns the heads of frames (F,), and their points (F, V, 4): three bytes, and the normal's number."""
    heads = np.zeros(len(positions), FRAME_HEAD)
    low, high = positions.min(1), positions.max(1)
    heads["origin"] = low
    heads["scale"] = np.where(high > low, (high - low) / STEPS, 1)
    heads["name"] = [name.encode("ascii") for name in names]
    points = np.empty((*positions.shape[:2], 4), np.uint8)
    steps = (positions - heads["origin"][:, None]) / heads["scale"][:, None].astype(np.float64)
    points[..., :3] = np.clip(np.rint(steps), 0, STEPS)
    points[..., 3] = nearest_normals(normals)
    return heads, points


def _merged(points: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], Ints]:
    """Returns the points (F, W, 4) of the vertices that differ in any frame, and their rows (V,)."""
    by_vertex = np.ascontiguousarray(points.swapaxes(0, 1)).reshape(points.shape[1], -1)
    keys = by_vertex.view(np.dtype((np.void, by_vertex.shape[1]))).reshape(-1)
    _, first, rows = np.unique(keys, return_index=True, return_inverse=True)
    order = np.argsort(np.argsort(first))
    return points[:, np.sort(first)], order[rows.reshape(-1)]
