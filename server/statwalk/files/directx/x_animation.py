"""The AnimationSets of a .x file as clips."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from statwalk.errors import TextError
from statwalk.files.directx.left_handed import affine, mirrored, rotations
from statwalk.files.directx.x_numbers import NumberReader
from statwalk.files.directx.x_objects import REFERENCE, DataObject
from statwalk.files.gltf.names import unique
from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats
from statwalk.maths.filters import continuous
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip, duration_of
from statwalk.motion.keys.channel import Path

SET, ANIMATION, KEY, OPTIONS, TICKS = (
    "animationset",
    "animation",
    "animationkey",
    "animationoptions",
    "animtickspersecond",
)
DEFAULT_TICKS, MOST_TICKS = 4_800, 1_000_000_000
LAST_TICK = 2**32 - 1
"""a tick is a 32-bit number"""
DEFAULT_TICKS_NOTE = f"the file has no AnimTicksPerSecond; DirectX then counts {DEFAULT_TICKS} ticks a second"
TWICE_NOTE = "two animations of a set move the same property; the first is used"
ROTATION, SCALE, POSITION, MATRIX, MATRIX_TOO = range(5)
WIDTH = {ROTATION: 4, SCALE: 3, POSITION: 3, MATRIX: 16, MATRIX_TOO: 16}
MOST_SETS = 10_000


class _Keys(NamedTuple):
    """The keys of one AnimationKey: its kind, its times (K,) in ticks, and its values (K, n)."""

    kind: int
    times: Floats
    values: Floats


def read_clips(file: DataObject, row_of: Mapping[str, int], rest: Pose, notes: list[str]) -> dict[str, Clip]:
    """Returns every AnimationSet as a clip, by its name made unique.

    A joint whose animation has no keys of a kind keeps its rest for it.

    :raises TextError: when keys are wrong; `place` is the line.
    """
    sets = list(file.of_kind(SET))
    if len(sets) > MOST_SETS:
        raise TextError(f"the file has more than {MOST_SETS} animation sets", place=sets[MOST_SETS].place)
    ticks = _ticks(file)
    if sets and ticks is None:
        notes.append(DEFAULT_TICKS_NOTE)
    clips = {}
    for name, part in zip(unique([part.name for part in sets], "clip"), sets, strict=True):
        rate = _ticks(part) or ticks or DEFAULT_TICKS
        channels = _channels(part, row_of, rate, notes)
        clips[name] = Clip(name, channels, duration_of(channels), rest, loop=_is_closed(part))
    return clips


def _ticks(owner: DataObject) -> float | None:
    part = next(owner.of_kind(TICKS), None)
    if part is None:
        return None
    ticks = float(NumberReader(part).floats(1, "the ticks of a second")[0])
    if not 1 <= ticks <= MOST_TICKS:
        raise TextError(f"AnimTicksPerSecond should be 1 to {MOST_TICKS}, not {ticks:g}", place=part.place)
    return ticks


def _is_closed(part: DataObject) -> bool:
    """Returns whether all animations of a set say that they repeat."""
    options = [next(animation.of_kind(OPTIONS), None) for animation in part.of_kind(ANIMATION)]
    return bool(options) and all(
        found is not None and NumberReader(found).floats(1, "openclosed")[0] == 0 for found in options
    )


def _channels(
    part: DataObject, row_of: Mapping[str, int], rate: float, notes: list[str]
) -> tuple[Channel, ...]:
    """Returns the channels of a set; the first of two for one property."""
    channels: dict[tuple[int, str], Channel] = {}
    for animation in part.of_kind(ANIMATION):
        target = next((inner for inner in animation.parts if inner.kind in (REFERENCE, "frame")), None)
        joint = row_of.get(target.name) if target is not None else None
        if joint is None:
            shown = repr(target.name[:60]) if target is not None else "no frame"
            notes.append(f"an animation for {shown} is left out, because the file has no such frame")
            continue
        keys = (_keys(key, notes) for key in animation.of_kind(KEY))
        made = [channel for of_kind in keys for channel in _channels_of(joint, of_kind, rate, notes)]
        kept = [channels.setdefault((joint, channel.path), channel) for channel in made]
        if any(first is not channel for first, channel in zip(kept, made, strict=True)):
            notes.append(TWICE_NOTE)
    return tuple(channels.values())


def _keys(part: DataObject, notes: list[str]) -> _Keys:
    numbers = NumberReader(part)
    kind = int(numbers.floats(1, "the type of keys")[0])
    if kind not in WIDTH:
        numbers.at = 0
        raise numbers.refuse(
            f"the type of keys should be 0 (rotation), 1 (scale), 2 (position) or 4 (matrix), not {kind}"
        )
    width = WIDTH[kind]
    count = numbers.count("keys", width + 2)
    rows = numbers.floats(count * (width + 2), "keys").reshape(count, width + 2)
    numbers.end()
    ticks = rows[:, 0]
    wrong = np.flatnonzero(
        (rows[:, 1] != width) | (ticks < 0) | (ticks > LAST_TICK) | (ticks != np.floor(ticks))
    )
    if len(wrong):
        numbers.at = 2 + int(wrong[0]) * (width + 2)
        raise numbers.refuse(
            f"a key of type {kind} is a time, 0 to {LAST_TICK} ticks, then {width}, and {width} numbers"
        )
    times = rows[:, 0]
    if (times[1:] > times[:-1]).all():
        return _Keys(kind, times, rows[:, 2:])
    notes.append(
        "keys of an animation are not in the order of their times, or have the same; they were sorted"
    )
    times, first = np.unique(times, return_index=True)
    return _Keys(kind, times, rows[first, 2:])


def _channels_of(joint: int, keys: _Keys, rate: float, notes: list[str]) -> Iterator[Channel]:
    """Yields the channels of keys: one, or for matrices three."""
    times = (keys.times / rate).astype(np.float32)
    if not len(times):
        return
    if not (times[1:] > times[:-1]).all():
        times, kept = np.unique(times, return_index=True)
        keys = keys._replace(values=keys.values[kept])
    for path, values in _properties(keys, notes):
        yield Channel.checked(joint, path, times, values.astype(np.float32), "LINEAR")


def _properties(keys: _Keys, notes: list[str]) -> Iterator[tuple[Path, Floats]]:
    """Yields the properties of keys, in glTF's convention."""
    if keys.kind == ROTATION:
        yield "rotation", continuous(_unit_rotations(rotations(keys.values)))
    elif keys.kind == SCALE:
        yield "scale", keys.values
    elif keys.kind == POSITION:
        yield "translation", mirrored(keys.values)
    else:
        matrices = affine(keys.values)
        if transform.is_skewed(matrices).any():
            notes.append(
                "a key's matrix is skewed and was replaced by the nearest translation, rotation and scale"
            )
        translation, rotation, scale = transform.to_trs(matrices)
        yield "translation", translation
        yield "rotation", continuous(rotation)
        yield "scale", scale


def _unit_rotations(values: Floats) -> Floats:
    """Returns quaternions at unit length; one without length is no turn."""
    size = np.abs(values).max(-1, keepdims=True)
    return quat.normalize(np.where(size > 0, values / np.where(size > 0, size, 1), quat.IDENTITY))
