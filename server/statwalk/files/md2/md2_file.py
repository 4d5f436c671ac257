"""Reads an MD2 file as a Character: its frames are the morph targets of one mesh on one joint, its cycles are
clips. FF4, DS2.

Quake's axes (x forward, y to the left, z up) become glTF's. Quake's unit is an inch. The joint stands so high
that the lowest vertex of the first frame touches the ground.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.errors import ContentError, ModelError
from statwalk.files.gltf import write
from statwalk.files.md2.md2_content import Md2Content, read_content
from statwalk.files.md2.md2_cycles import RATE, comes_round, cycles_of
from statwalk.files.md2.md2_header import byte_of
from statwalk.files.md2.md2_normals import NORMALS
from statwalk.files.md2.md2_skin import skin_material
from statwalk.files.scale import check_scale
from statwalk.maths import pose as poses
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.motion.switched import switched
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive
from statwalk.skin.shading import smooth_normals

Inbetween = Literal["linear", "switched"]
INBETWEENS: tuple[Inbetween, ...] = ("linear", "switched")
SUFFIX = ".md2"
METRES = 0.0254
TO_GLTF = [1, 2, 0]
"""the file's axis for x (left), y (up) and z (forward)"""
LARGEST_MORPHS = 64 << 20
"""bytes of all frames as morph targets: positions and normals"""


def read_md2(data: bytes, name: str, inbetween: Inbetween = "linear", scale: float = 1.0) -> Character:
    """Reads the character of an MD2 file; a clip is called as the beginning of its frames' names.

    `inbetween`: vertices go straight from frame to frame, or switch half-way. A unit of the file is an inch
    times `scale`. Cycles that come round have the first frame again at their end.

    :raises ModelError: when the file is refused; `place` is a byte.
    """
    if inbetween not in INBETWEENS:
        raise ContentError(f"inbetween is one of {', '.join(INBETWEENS)}, not {str(inbetween)[:40]!r}")
    check_scale(scale)
    content = read_content(data)
    metres = np.float32(METRES * scale)
    rest = poses.rest(1, len(content.names) - 1)
    rest.translation[0, 1] = -content.positions[0, :, 2].min() * metres
    part, notes = _part(content, metres)
    clips = [_clip(cycle, frames, rest, inbetween) for cycle, frames in cycles_of(content.names).items()]
    character = Character(
        name,
        Skeleton(("model",), np.array([-1], np.int32)),
        np.zeros(1, np.int32),
        rest,
        clips={clip.name: clip for clip in clips},
        parts=(part,),
        materials=(skin_material(content.skins, content.skin_size),),
        notes=notes,
    )
    return replace(character, model_glb=write.model_glb(character))


class _Corners(NamedTuple):
    """The corners of triangles, each pair of vertex and texture coordinate once."""

    vertices: Ints
    coordinates: Ints
    triangles: NDArray[np.uint32]
    """(3 T,) rows of the two, counter-clockwise"""


def _corners(content: Md2Content) -> _Corners:
    pairs = content.corners.astype(np.int64) << 16
    pairs += content.corner_coordinates if len(content.coordinates) else 0
    distinct, rows = np.unique(pairs, return_inverse=True)
    triangles = rows.reshape(-1, 3)[:, ::-1].astype(np.uint32)
    return _Corners(distinct >> 16, distinct & 0xFFFF, np.ascontiguousarray(triangles).reshape(-1))


def _part(content: Md2Content, metres: np.float32) -> tuple[Primitive, tuple[str, ...]]:
    """Returns the mesh, and what was mended."""
    corners = _corners(content)
    needed = 24 * len(content.names) * len(corners.vertices)
    if needed > LARGEST_MORPHS:
        raise ModelError(
            f"{len(content.names):,} frames of {len(corners.vertices):,} corners take {needed >> 20} MiB; at "
            f"most {LARGEST_MORPHS >> 20} MiB are allowed",
            place=byte_of("frames"),
        )
    positions = content.positions[:, corners.vertices][..., TO_GLTF] * metres
    normals, notes = _normals(content)
    normals = normals[:, corners.vertices][..., TO_GLTF]
    part = Primitive(
        joint=0,
        node=0,
        mesh=0,
        primitive=0,
        positions=np.ascontiguousarray(positions[0]),
        normals=np.ascontiguousarray(normals[0]),
        indices=corners.triangles,
        material=0,
        target_positions=_targets(positions),
        target_normals=_targets(normals),
        attributes=_attributes(content, corners),
    )
    return part, notes


def _targets(frames: NDArray[np.float32]) -> NDArray[np.float32] | None:
    """Returns how far the vertices of the other frames are from the vertices of the first: (F-1, V, 3)."""
    return frames[1:] - frames[0] if len(frames) > 1 else None


def _normals(content: Md2Content) -> tuple[NDArray[np.float32], tuple[str, ...]]:
    """Returns the normals (F, V, 3) along the axes of the file; computed if the file's are none."""
    if content.normals.max() < len(NORMALS) and content.normals.max() > content.normals.min():
        return NORMALS[content.normals], ()
    faces = content.corners[:, ::-1].astype(np.int64)
    normals = np.stack([smooth_normals(frame, faces) for frame in content.positions])
    return normals, ("the file's normals are not in Quake II's table, and were computed",)


def _attributes(content: Md2Content, corners: _Corners) -> Mapping[str, NDArray[np.float32]]:
    """Returns the texture coordinates; a pixel's is at its middle, as in the GL commands of Quake II."""
    if not len(content.coordinates):
        return {}
    pixels = content.coordinates[corners.coordinates].astype(np.float64) + 0.5
    return {"TEXCOORD_0": (pixels / content.skin_size).astype(np.float32)}


def _clip(name: str, frames: Sequence[int], rest: Pose, inbetween: Inbetween) -> Clip:
    """Returns the clip of a cycle: at each key one frame has the weight 1, the first frame none."""
    closes = comes_round(name) and len(frames) > 1
    order = np.array([*frames, frames[0]] if closes else frames)
    count = rest.weights.shape[-1]
    if not count:
        return Clip(name, (), 0.0, rest)
    times = (np.arange(len(order)) / RATE).astype(np.float32)
    channel = Channel(0, "weights", times, _one_each(order, count), "LINEAR")
    clip = Clip(name, (channel,), float(times[-1]), rest, loop=closes)
    return switched(clip) if inbetween == "switched" else clip


def _one_each(frames: Ints, count: int) -> Floats:
    """Returns the weights (K, count) of keys: target n is frame n + 1."""
    return np.asarray(frames[:, None] == np.arange(1, count + 1), np.float32)
