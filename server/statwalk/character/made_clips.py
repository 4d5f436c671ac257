"""Clips that a file makes of a character's own clips (KF9)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import StatwalkError, UnknownNameError
from statwalk.machine.definition.clip_definition import (
    AnticipateChange,
    ClipChange,
    ClipDefinition,
    EaseChange,
    ExaggerateChange,
    FilterChange,
    LengthChange,
    SpeedChange,
    SquashChange,
    SwitchChange,
)
from statwalk.motion.clip import Clip
from statwalk.motion.filter_clip import filtered
from statwalk.motion.layers import below
from statwalk.motion.principles.anticipate import anticipate
from statwalk.motion.principles.ease import ease
from statwalk.motion.principles.exaggerate import exaggerate
from statwalk.motion.principles.retime import retime, to_frames
from statwalk.motion.principles.sides import Sides
from statwalk.motion.principles.squash import squash
from statwalk.motion.switched import switched
from statwalk.rig.evaluate import world_from_local

Refuse = Callable[[str, int], StatwalkError]
"""makes the error about a line of a file"""


def with_clips(character: Character, made: Mapping[str, ClipDefinition], refuse: Refuse) -> Character:
    """Returns the character with the clips that a file makes; without clips that another text made before.

    :raises StatwalkError: what `refuse` returns, when a clip does not exist or is there already, or a change
        is impossible.
    """
    own = {name: clip for name, clip in character.clips.items() if name not in character.made}
    if not made:
        return character if not character.made else replace(character, clips=own, made=frozenset())
    clips = dict(own)
    for name, definition in made.items():
        if name in clips:
            raise refuse(f"the character has a clip {name} already; choose another name", definition.line)
        if definition.of not in clips:
            raise refuse(str(UnknownNameError("clip", definition.of, clips)), definition.line)
        source = clips[definition.of]
        source = source if definition.loop is None else replace(source, loop=definition.loop)
        clip = changed(character, source, definition.changes, refuse)
        loop = clip.loop if definition.loop is None else definition.loop
        clips[name] = replace(clip, name=name, loop=loop)
    return replace(character, clips=clips, made=frozenset(made))


def changed(character: Character, clip: Clip, changes: Sequence[ClipChange], refuse: Refuse) -> Clip:
    """Returns the clip after some changes.

    :raises StatwalkError: what `refuse` returns, when a change is impossible.
    """
    for change in changes:
        try:
            clip = _changed(character, clip, change)
            clip.tracks  # noqa: B018 - packed now, so that no tick meets an error in the keys
        except StatwalkError as error:
            raise refuse(getattr(error, "message", str(error)), change.line) from None
    return clip


def _changed(character: Character, clip: Clip, change: ClipChange) -> Clip:
    match change:
        case SpeedChange(_, speed):
            return retime(clip, speed)
        case LengthChange(_, frames, rate):
            return to_frames(clip, frames, rate)
        case EaseChange(_, easing):
            return ease(clip, easing)
        case ExaggerateChange(_, factor, joints):
            return exaggerate(clip, factor, _rows(character, joints))
        case AnticipateChange(_, amount, seconds, joints):
            return anticipate(clip, amount, seconds, _rows(character, joints))
        case SquashChange(_, joint, axis, stretch):
            return squash(clip, character.skeleton.index(joint), stretch, axis)
        case FilterChange(_, low_pass, spikes):
            return filtered(clip, low_pass, spikes)
        case SwitchChange():
            return switched(clip)
        case _:
            return sides_of(character).clip(clip)


def _rows(character: Character, joints: Sequence[str]) -> frozenset[int] | None:
    """The rows of some joints and all below them; None: all joints."""
    if not joints:
        return None
    roots = [character.skeleton.index(name) for name in joints]
    return frozenset(np.flatnonzero(below(character.skeleton.parent, roots)).tolist())


def sides_of(character: Character) -> Sides:
    """Returns which joints of a character are partners, left and right, by their names, and how they
    mirror.
    """
    frames = world_from_local(character.skeleton, character.bind_pose)[..., :3].astype(np.float64)
    return Sides.of(character.skeleton.names, character.skeleton.parent, character.bind_pose, frames)
