"""A file format as data: its suffixes, its reader and writer, and the parts of a character that it holds.

`model_formats` lists the formats. A new one needs a row there, a reader from bytes to a Character, and, to be
written, a function from a Character to bytes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.held_parts import parts_of

LARGEST_BYTES = 64 << 20
MOST_NAMED = 8
"""names of a loss in a sentence; `Loss.names` has them all"""

Reader = Callable[[bytes, str], Character]
"""from the bytes of one file, which refers to no other file, and the character's name"""
Writer = Callable[[Character], bytes]
ManyFilesWriter = Callable[[Character, str], Mapping[str, bytes]]
"""from the character and the stem of its files to their bytes by name, the main file first"""
Loader = Callable[[Path], Character]
"""from a file with the files beside it"""


class Loss(NamedTuple):
    """Something of a character that a format cannot hold: the kind of part, the names of the parts, and what
    the file has in their place, if anything.
    """

    part: str
    names: tuple[str, ...]
    instead: str = ""

    def __str__(self) -> str:
        listed = ", ".join(self.names[:MOST_NAMED])
        more = f" … and {len(self.names) - MOST_NAMED} more" if len(self.names) > MOST_NAMED else ""
        return f"{self.part}: {listed}{more}" + (f" ({self.instead})" if self.instead else "")


@dataclass(frozen=True)
class FileFormat:
    """A format of files that hold a character.

    read, write   None: the format is not read, or not written
    holds         the kinds of parts that a written file keeps, by the names in `held_parts.PARTS`
    instead       for a kind that is not kept: what the file has in its place
    begins        the first bytes, in capitals, of which a file has one; empty: no file is known by its start
    write_many    writes a character as several files beside each other
    load          reads a file with its neighbours; None: the file stands alone, and `read` reads its bytes
    """

    name: str
    suffixes: tuple[str, ...]
    read: Reader | None = None
    write: Writer | None = None
    holds: frozenset[str] = frozenset()
    instead: Mapping[str, str] = field(default_factory=dict)
    begins: tuple[bytes, ...] = ()
    media_type: str = "application/octet-stream"
    load: Loader | None = None
    write_many: ManyFilesWriter | None = None

    @property
    def is_written(self) -> bool:
        """Returns whether the format is written, as one file or several."""
        return self.write is not None or self.write_many is not None

    def files(self, character: Character, stem: str) -> Mapping[str, bytes]:
        """Returns the files of a character by name, the main file first.

        :raises ContentError: when the format is only read, or cannot hold the character at all.
        """
        if self.write_many is not None:
            return self.write_many(character, stem)
        if self.write is None:
            raise ContentError(f"statwalk does not write {self.name} files")
        return {f"{stem}{self.suffixes[0]}": self.write(character)}

    def load_file(self, path: Path) -> Character:
        """Reads the character of a file; it is called as the file without its suffix.

        :raises ContentError: when the file does not exist, is too large, or is refused.
        """
        if not path.is_file():
            raise ContentError("there is no such file", file=str(path))
        if path.stat().st_size > LARGEST_BYTES:
            raise ContentError(
                f"a {self.name} file may have {LARGEST_BYTES >> 20} MiB at most", file=str(path)
            )
        try:
            return self.load(path) if self.load else self.read_bytes(path.read_bytes(), path.stem)
        except ContentError as error:
            raise error.in_file(str(path)) from None

    def read_bytes(self, data: bytes, name: str) -> Character:
        """Reads the character in the bytes of a file.

        :raises ContentError: when the format cannot be read, or the bytes are refused.
        """
        if self.read is None:
            raise ContentError(f"statwalk does not read {self.name} files")
        return self.read(data, name)

    def losses(self, character: Character) -> tuple[Loss, ...]:
        """Returns what a file of this format cannot hold of a character."""
        return tuple(
            Loss(part, names, self.instead.get(part, ""))
            for part, names in parts_of(character).items()
            if part not in self.holds
        )

    def starts(self, start: bytes) -> bool:
        """Returns whether a file with these first bytes is of this format."""
        return start.removeprefix(b"\xef\xbb\xbf").lstrip().upper().startswith(self.begins or (b"\0never",))
