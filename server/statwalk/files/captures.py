"""Motion capture of any kind that statwalk reads: the kind is told by the first bytes, not by the name."""

from __future__ import annotations

from pathlib import Path

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.bvh import read_bvh
from statwalk.files.bvh.read import Position
from statwalk.files.trc.read import read_trc

SUFFIXES = (".bvh", ".trc")
LARGEST_BYTES = 64 << 20
_BEGINS = {b"HIERARCHY": ".bvh", b"PATHFILETYPE": ".trc"}


def kind_of(start: bytes) -> str:
    """Returns the suffix of the capture that begins with these bytes (12 are enough); "" for other files."""
    head = start.removeprefix(b"\xef\xbb\xbf").lstrip().upper()
    return next((kind for word, kind in _BEGINS.items() if head.startswith(word)), "")


def read_capture(
    data: bytes, kind: str, name: str, position: Position = "replace", scale: float = 1.0
) -> Character:
    """Reads a capture of a kind (".bvh", ".trc") as a Character with one clip, both called `name`.

    :raises TextError: when the file is refused; `place` is the line.
    """
    return read_bvh(data, name, position, scale) if kind == ".bvh" else read_trc(data, name, scale)


def load_capture(path: Path, position: Position = "replace", scale: float = 1.0) -> Character:
    """Reads the capture of a file; its clip is called as the file without its suffix.

    :raises ContentError: when the file does not exist, is too large, or is refused.
    """
    if not path.is_file():
        raise ContentError("there is no such file", file=str(path))
    if path.stat().st_size > LARGEST_BYTES:
        raise ContentError(f"a capture may have {LARGEST_BYTES >> 20} MiB at most", file=str(path))
    try:
        return read_capture(path.read_bytes(), path.suffix.lower(), path.stem, position, scale)
    except ContentError as error:
        raise error.in_file(str(path)) from None
