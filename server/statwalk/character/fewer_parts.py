"""Leaves parts out of a character, with what belongs to them alone: morph targets, and the keys of their
weights.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.character.expressions import check_channels
from statwalk.character.muscle_targets import check_targets
from statwalk.errors import ContentError, StatwalkError
from statwalk.motion.clip import Channel, Clip
from statwalk.motion.keys.channel import Path
from statwalk.skin.primitive import Primitive

STILL_PATHS: tuple[Path, ...] = ("scale", "translation", "rotation")


def with_parts(character: Character, kept: Collection[int]) -> Character:
    """Returns the character with the parts of these places in `parts`, at least one, without a model and
    without levels of detail, which were measured with all parts. Meshes get new numbers.

    :raises ContentError: when its muscles, bulges or expressions need a morph target that is gone.
    """
    parts = [part for row, part in enumerate(character.parts) if row in kept]
    columns = np.array(sorted({column for part in parts for column in _columns(part)}), np.int64)
    names = character.target_names
    fewer = replace(
        character,
        parts=_renumbered(parts, columns),
        levels=(),
        bind_pose=character.bind_pose._replace(weights=character.bind_pose.weights[columns]),
        target_names=tuple(names[column] for column in columns) if names else (),
        clips={name: _clip(clip, columns) for name, clip in character.clips.items()},
        model_glb=b"",
    )
    _check_needs(fewer)
    return fewer


def _columns(part: Primitive) -> range:
    """The columns of a part's morph targets in the weights of a pose."""
    count = 0 if part.target_positions is None else len(part.target_positions)
    return range(part.weight_first, part.weight_first + count)


def _renumbered(parts: Sequence[Primitive], columns: NDArray[np.int64]) -> tuple[Primitive, ...]:
    """Returns the parts with the numbers of their meshes in a new file: nodes share a mesh where they show
    the same primitives of it.
    """
    of_node: dict[int, list[int]] = {}
    for part in parts:
        of_node.setdefault(part.node, []).append(part.primitive)
    meshes: dict[tuple[object, ...], int] = {}
    made = []
    for part in parts:
        shown = of_node[part.node]
        mesh = meshes.setdefault((part.mesh, part.skin, *shown), len(meshes))
        first = int(np.searchsorted(columns, part.weight_first))
        row = shown.index(part.primitive)
        made.append(replace(part, mesh=mesh, primitive=row, weight_first=first, collapses=None))
    return tuple(made)


def _clip(clip: Clip, columns: NDArray[np.int64]) -> Clip:
    """Returns the clip over the weights that are kept."""
    rest = clip.rest._replace(weights=clip.rest.weights[columns])
    channels: Sequence[Channel] = clip.channels
    if any(channel.path == "weights" for channel in channels):
        channels = tuple(_channels(clip, columns))
    return replace(clip, rest=rest, channels=channels)


def _channels(clip: Clip, columns: NDArray[np.int64]) -> Iterator[Channel]:
    """Yields the channels over the new columns. In place of the weights of a mesh that is gone its joint
    keeps still as long: the clip stays, also one that moved nothing else, and lasts as long.
    """
    keyed = {(channel.joint, channel.path) for channel in clip.channels}
    for channel in clip.channels:
        if channel.path != "weights":
            yield channel
        elif channel.weight_first in columns:
            yield replace(channel, weight_first=int(np.searchsorted(columns, channel.weight_first)))
        else:
            free = next((path for path in STILL_PATHS if (channel.joint, path) not in keyed), None)
            if free is not None:
                keyed.add((channel.joint, free))
                yield _still(clip, channel, free)


def _still(clip: Clip, channel: Channel, path: Path) -> Channel:
    times = channel.times[:: max(1, len(channel.times) - 1)]
    value = getattr(clip.rest, path)[channel.joint]
    return Channel(channel.joint, path, times, np.tile(value, (len(times), 1)))


def _check_needs(character: Character) -> None:
    """Checks that what moves morph targets still finds them."""
    try:
        check_channels(character, character.expressions, lambda message, _line: ContentError(message))
        check_targets(character, character.muscles)
        for name in character.bulges:
            character.target(name)
    except StatwalkError as error:
        raise ContentError(
            f"a mesh must stay, because the character moves its morph target: {error}"
        ) from None
