"""Loads a character from a file of any kind: a model, a character file with its texts, or a zip of one."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files import archive, model_formats
from statwalk.files.character_yaml import load_character
from statwalk.files.file_format import LARGEST_BYTES

TEXT_SUFFIXES = model_formats.CHARACTER_TEXT.suffixes


def load_character_file(path: Path) -> Character:
    """Loads the Character of a model, a character file or a zip.

    :raises ContentError: when the file does not exist, is too large, or is refused.
    """
    suffix = path.suffix.lower()
    if suffix not in (*TEXT_SUFFIXES, archive.SUFFIX):
        return model_formats.format_of(path).load_file(path)
    if not path.is_file():
        raise ContentError("there is no such file", file=str(path))
    if suffix in TEXT_SUFFIXES:
        return load_character(path)
    try:
        return load_zip(path, path.stem)
    except ContentError as error:
        file = f"{path}/{error.file}" if error.file else str(path)
        raise type(error)(error.message, file=file, place=error.place) from None


def load_zip(path: Path, name: str, room: Path | None = None) -> Character:
    """Loads the Character of a zip: of its character file, or else of its model, called `name`. The zip is
    unpacked in a folder below `room`, for a while.

    :raises ContentError: when the zip is too large, or it or a file in it is refused; `file` is the path in
        the zip.
    """
    if path.stat().st_size > LARGEST_BYTES:
        raise ContentError(f"a zip may have {LARGEST_BYTES >> 20} MiB at most")
    with tempfile.TemporaryDirectory(dir=room) as folder:
        main = archive.unpack(path, Path(folder))
        try:
            return replace(load_character_file(main), name=name)
        except ContentError as error:
            file = Path(error.file or main)
            inside = file.relative_to(folder) if file.is_relative_to(folder) else Path(file.name)
            raise type(error)(error.message, file=str(inside), place=error.place) from None
