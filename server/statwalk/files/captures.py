"""Motion capture of any kind that statwalk reads: the kind is told by the first bytes, not by the name."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.bvh import read_bvh
from statwalk.files.bvh.bvh_file import Position
from statwalk.files.gltf import write
from statwalk.files.md2.md2_file import Inbetween
from statwalk.files.trc.trc_file import read_trc
from statwalk.motion.filter_clip import Filter, filtered

SUFFIXES = (".bvh", ".trc")
LARGEST_BYTES = 64 << 20
_BEGINS = {b"HIERARCHY": ".bvh", b"PATHFILETYPE": ".trc"}


@dataclass(frozen=True)
class Reading:
    """How a file is read: a capture, an .md2, or any file with meshes.

    position   whether BVH position channels replace a joint's offset, or are added to it
    scale      multiplies all lengths
    filter     what is taken out of a capture's clip
    inbetween  whether the vertices of an .md2 go from frame to frame, or switch
    without    the meshes to leave out (`files.without_meshes`)
    """

    position: Position = "replace"
    scale: float = 1.0
    filter: Filter = field(default_factory=Filter)
    inbetween: Inbetween = "linear"
    without: tuple[str, ...] = ()


def kind_of(start: bytes) -> str:
    """Returns the suffix of the capture that begins with these bytes (12 are enough); "" for other files."""
    head = start.removeprefix(b"\xef\xbb\xbf").lstrip().upper()
    return next((kind for word, kind in _BEGINS.items() if head.startswith(word)), "")


def read_capture(data: bytes, kind: str, name: str, how: Reading | None = None) -> Character:
    """Reads a capture of a kind (".bvh", ".trc") as a Character with one clip, both called `name`.

    :raises ContentError: when the file is refused; `place` is the line.
    """
    how = how or Reading()
    read = (
        read_bvh(data, name, how.position, how.scale) if kind == ".bvh" else read_trc(data, name, how.scale)
    )
    if how.filter == Filter():
        return read
    clean = {key: filtered(clip, how.filter.low_pass, how.filter.spikes) for key, clip in read.clips.items()}
    character = replace(read, clips=clean)
    return replace(character, model_glb=write.model_glb(character))


def load_capture(path: Path, how: Reading | None = None) -> Character:
    """Reads the capture of a file; its clip is called as the file without its suffix.

    :raises ContentError: when the file does not exist, is too large, or is refused.
    """
    if not path.is_file():
        raise ContentError("there is no such file", file=str(path))
    if path.stat().st_size > LARGEST_BYTES:
        raise ContentError(f"a capture may have {LARGEST_BYTES >> 20} MiB at most", file=str(path))
    try:
        return read_capture(path.read_bytes(), path.suffix.lower(), path.stem, how)
    except ContentError as error:
        raise error.in_file(str(path)) from None
