"""Chunks: four letters, the length of the content, the content, and zeros up to a multiple of four.

A chunk's content may begin with a fixed record; then follow the chunks inside it. Lengths are checked against
the chunk outside before anything is read.
"""

from __future__ import annotations

import struct
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from statwalk.errors import ModelError
from statwalk.files.chunk.records import CHUNK, FILE, LARGEST_BYTES, MAGIC, MOST_CHUNKS, VERSION, Tag

LONGEST_TEXT = 1 << 20


class Chunk(NamedTuple):
    """A chunk in a file; `place` is the byte where it begins."""

    tag: str
    content: memoryview
    place: int

    def record(self, form: struct.Struct) -> tuple[Any, ...]:
        """Returns the fixed record at the content's beginning.

        :raises ModelError: when the chunk is too short.
        """
        if len(self.content) < form.size:
            raise refuse(self, f"it has {len(self.content)} bytes; its record has {form.size}")
        return form.unpack_from(self.content)

    def numbers(self, start: int, count: int) -> list[int]:
        """Returns `count` u32 from byte `start` of the content.

        :raises ModelError: when the chunk is too short.
        """
        if start + 4 * count > len(self.content):
            raise refuse(
                self, f"{count} numbers from byte {start} are more than its {len(self.content)} bytes"
            )
        return [int(number) for number in np.frombuffer(self.content[start : start + 4 * count], "<u4")]

    def text(self, start: int = 0) -> str:
        """Returns the UTF-8 text from byte `start` of the content.

        :raises ModelError: when it is too long, or no text.
        """
        if len(self.content) - start > LONGEST_TEXT:
            raise refuse(self, f"a text may have {LONGEST_TEXT} bytes at most")
        try:
            return bytes(self.content[start:]).decode()
        except UnicodeDecodeError as error:
            raise refuse(self, f"the text is no UTF-8 at byte {start + error.start}") from None


def refuse(chunk: Chunk, message: str) -> ModelError:
    """Returns the error about a chunk."""
    return ModelError(f"{chunk.tag}: {message}", place=f"byte {chunk.place}")


@dataclass
class ChunkReader:
    """Walks through the chunks of a file; counts the chunks, and the chunks of unknown types."""

    data: bytes
    count: int = 0
    unknown: Counter[str] = field(default_factory=Counter)

    def head(self) -> Chunk:
        """Returns the chunk of the file, after magic and version.

        :raises ModelError: when the file is no chunk file, of another version, or too large.
        """
        if len(self.data) < FILE.size or self.data[:8] != MAGIC:
            raise ModelError("this is no chunk file; it begins with 89 43 48 55 4E 4B 0D 0A", place="byte 0")
        if len(self.data) > LARGEST_BYTES:
            raise ModelError(f"a chunk file may have {LARGEST_BYTES >> 20} MiB at most", place="byte 0")
        _, version = FILE.unpack_from(self.data)
        if version != VERSION:
            raise ModelError(f"this is version {version}; statwalk reads version {VERSION}", place="byte 8")
        chunks = list(self._chunks(memoryview(self.data)[FILE.size :], FILE.size))
        heads = [chunk for chunk in chunks if chunk.tag == "HEAD"]
        if len(heads) != 1:
            raise ModelError(f"a file has one HEAD chunk, not {len(heads)}", place=f"byte {FILE.size}")
        self.unknown.update(chunk.tag for chunk in chunks if chunk.tag != "HEAD")
        return heads[0]

    def inside(self, chunk: Chunk, start: int, tags: Sequence[Tag]) -> Iterator[Chunk]:
        """Yields the chunks of the tags inside a chunk, from byte `start` of its content; others are counted
        as unknown.

        :raises ModelError: when a chunk is longer than the one outside, or there are too many.
        """
        for below in self._chunks(chunk.content[start:], chunk.place + CHUNK.size + start):
            if below.tag in tags:
                yield below
            else:
                self.unknown[below.tag] += 1

    def each(self, chunk: Chunk, start: int, take: Mapping[Tag, Callable[[Chunk], None]]) -> None:
        """Calls a function for each chunk inside a chunk, by its tag.

        :raises ModelError: as `inside`.
        """
        for below in self.inside(chunk, start, tuple(take)):
            take[below.tag](below)  # type: ignore[index]

    def name(self, chunk: Chunk, start: int, tags: Sequence[Tag] = ()) -> tuple[str, list[Chunk]]:
        """Returns the text of the NAME chunk inside a chunk, and the chunks of other tags.

        :raises ModelError: as `inside`.
        """
        below = list(self.inside(chunk, start, ("NAME", *tags)))
        names = [part.text() for part in below if part.tag == "NAME"]
        if len(names) > 1:
            raise refuse(chunk, f"it has one NAME, not {len(names)}")
        return names[0] if names else "", [part for part in below if part.tag != "NAME"]

    def _chunks(self, content: memoryview, place: int) -> Iterator[Chunk]:
        at = 0
        while at < len(content):
            if at + CHUNK.size > len(content):
                raise ModelError("the file is cut within the head of a chunk", place=f"byte {place + at}")
            tag, length = CHUNK.unpack_from(content, at)
            start = at + CHUNK.size
            if length > len(content) - start:
                raise ModelError(
                    f"the chunk {_word(tag)} says {length} bytes, but only {len(content) - start} are left",
                    place=f"byte {place + at}",
                )
            self.count += 1
            if self.count > MOST_CHUNKS:
                raise ModelError(f"a file may have {MOST_CHUNKS} chunks at most", place=f"byte {place + at}")
            yield Chunk(_word(tag), content[start : start + length], place + at)
            at = start + length + -length % 4


def _word(tag: bytes) -> str:
    return "".join(chr(letter) if 32 < letter < 127 else "?" for letter in tag)


def joined(tag: Tag, *content: bytes) -> bytes:
    """Returns a chunk of its content: a record, and the chunks inside, each at a multiple of four."""
    padded = [part + b"\0" * (-len(part) % 4) for part in content[:-1]]
    whole = b"".join([*padded, *content[-1:]])
    return CHUNK.pack(tag.encode(), len(whole)) + whole + b"\0" * (-len(whole) % 4)
