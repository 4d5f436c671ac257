"""Converts a character from one file format to another, and says what the target cannot hold."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.file_format import FileFormat, Loss
from statwalk.files.model_formats import WRITTEN, format_of
from statwalk.services.library.load import character_from


@dataclass(frozen=True)
class Conversion:
    """What was written.

    format                   the target's format
    joints, clips, vertices  how many the character has
    lost                     what the target cannot hold
    """

    target: Path
    format: str
    joints: int
    clips: int
    vertices: int
    lost: tuple[Loss, ...]

    def __str__(self) -> str:
        lines = [f"{self.target}: {self.joints} joints, {self.clips} clips, {self.vertices} vertices"]
        if self.lost:
            lines += [f"{self.format} cannot hold", *(f"  {loss}" for loss in self.lost)]
        return "\n".join(lines)


def convert(source: str | Path | Character, target: str | Path, *, clip: str = "") -> Conversion:
    """Writes the character of `source` to the file `target`, in the format of its suffix; returns what the
    file cannot hold.

    source  a Character, or whatever `load` reads: of a machine its character
    clip    the clip that comes first, which is the only one in formats that hold one; "": the first

    :raises ContentError: when the source is refused, or the target's format cannot be written.
    :raises UnknownNameError: when the character has no clip of the name, or there is no such source.
    """
    path = Path(target)
    row = written_format(path)
    character = source if isinstance(source, Character) else character_from(source)
    character = with_first(character, clip)
    files, lost = row.files(character, path.stem), row.losses(character)
    for name, data in zip((path.name, *list(files)[1:]), files.values(), strict=True):
        path.with_name(name).write_bytes(data)
    vertices = sum(len(part.positions) for part in character.parts)
    return Conversion(path, row.name, len(character.skeleton), len(character.clips), vertices, lost)


def written_format(path: Path) -> FileFormat:
    """Returns the format of a file to write, by its suffix.

    :raises ContentError: when no format has the suffix, or the format is only read.
    """
    row = format_of(path)
    if not row.is_written:
        raise ContentError(
            f"statwalk reads {row.name} files, but does not write them; it writes {', '.join(WRITTEN)}",
            file=str(path),
        )
    return row


def with_first(character: Character, clip: str) -> Character:
    """Returns the character with a clip before all others; "": as it is.

    :raises UnknownNameError: when the character has no clip of the name.
    """
    if not clip:
        return character
    return replace(character, clips={clip: character.clip(clip), **character.clips})
