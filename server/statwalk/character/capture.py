"""Gives a character a captured motion: retargeted, filtered, as a new clip."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from statwalk.character.character import Character
from statwalk.character.retarget import Retargeted, Wish, retargeted
from statwalk.errors import ContentError
from statwalk.motion.filter_clip import Filter, filtered


@dataclass(frozen=True)
class CaptureWish:
    """What a user wants done with a captured clip.

    clip     the source's clip; "": its first
    name     the new clip's name; "": the old one, with a number if the character has a clip of that name
    carried  what is carried over
    filter   what is taken out of the captured clip before
    loop     whether the new clip repeats
    """

    clip: str = ""
    name: str = ""
    carried: Wish = field(default_factory=Wish)
    filter: Filter = field(default_factory=Filter)
    loop: bool = False


def with_capture(
    character: Character, source: Character, wish: CaptureWish
) -> tuple[Character, str, Retargeted]:
    """Returns the character with one more clip, the clip's name, and how it was carried over.

    The character's model is the one before: it does not have the clip yet.

    :raises ContentError: when the name is taken, or the clip cannot be carried over.
    :raises UnknownNameError: when the source has no clip of the name.
    """
    if not source.clips:
        raise ContentError(f"{source.name[:60]!r} has no clip that could be carried over", place="clip")
    clip = source.clip(wish.clip) if wish.clip else next(iter(source.clips.values()))
    if wish.name in character.clips:
        raise ContentError(
            f"the character has a clip {wish.name[:60]!r} already; choose another name", place="name"
        )
    name = wish.name or _free_name(clip.name, character)
    clean = filtered(clip, wish.filter.low_pass, wish.filter.spikes)
    carried, report = retargeted(clean, source, character, wish.carried)
    named = replace(carried, name=name, loop=wish.loop)
    return replace(character, clips={**character.clips, name: named}), name, report


def _free_name(name: str, character: Character) -> str:
    """Returns the name, with a number if the character has a clip of that name."""
    names = (name, *(f"{name} {number}" for number in range(2, len(character.clips) + 3)))
    return next(free for free in names if free not in character.clips)
