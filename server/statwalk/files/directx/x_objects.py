"""Reads the data objects of a .x text into a tree, without recursion.

    Frame Arm {                      a kind and a name, which may be missing
        FrameTransformMatrix { … }   numbers, strings, and objects inside
        {Hand_mesh}                  a reference to an object elsewhere
    }

Semicolons and commas separate numbers, and mean nothing else here: the counts in the file say how many
numbers an array has. Templates are skipped.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from statwalk.errors import TextError

DEEPEST, MOST_OBJECTS, LONGEST_NAME = 4_200, 300_000, 200
TEMPLATE, REFERENCE = "template", ""
_STRUCTURE = re.compile(r'\{|\}|"[^"\n]*"')
_KIND = re.compile(r"[A-Za-z_][\w.-]*", re.ASCII)
_GUID = re.compile(r"<\s{0,9}[0-9A-Fa-f-]{0,40}\s{0,9}>")


@dataclass(slots=True)
class DataObject:
    """An object of the file.

    kind      in small letters; "" is a reference to the object called `name`
    line      where it begins
    pieces    (line, text) of its numbers, between the objects inside
    strings   its quoted texts
    parts     the objects inside and references to others, in order
    """

    kind: str
    name: str
    line: int
    pieces: list[tuple[int, str]] = field(default_factory=list)
    strings: list[str] = field(default_factory=list)
    parts: list[DataObject] = field(default_factory=list)

    @property
    def place(self) -> str:
        """Returns the place for errors."""
        return f"line {self.line}"

    @property
    def title(self) -> str:
        """Returns the kind and the name as a message shows them."""
        return f"{self.kind} {self.name[:60]}".strip()

    def of_kind(self, kind: str) -> Iterator[DataObject]:
        """Yields the objects of a kind directly inside."""
        return (part for part in self.parts if part.kind == kind)


def read_objects(text: str) -> DataObject:
    """Returns a nameless object that holds the objects of the file.

    :raises TextError: when braces do not match, or there are too many objects; `place` is the line.
    """
    reading = _Reading()
    last = 0
    for match in _STRUCTURE.finditer(text):
        reading.take(text[last : match.start()], match[0])
        last = match.end()
    return reading.finished(text[last:])


class _Reading:
    """The objects whose braces are open, from the outside in, and the line that is reached."""

    def __init__(self) -> None:
        self.opened = [DataObject("file", "", 1)]
        self.line, self.count = 1, 0

    def take(self, before: str, mark: str) -> None:
        """Reads a brace or a string, and the text before it."""
        start = self.line
        self.line += before.count("\n")
        before = _GUID.sub(" ", before) if "<" in before else before
        if mark == "{":
            self._open(before, start)
        elif mark == "}":
            self._text(before, start)
            self._close()
        else:
            self._text(before, start)
            self._count()
            self.opened[-1].strings.append(mark[1:-1])

    def finished(self, rest: str) -> DataObject:
        """Returns the outermost object at the end of the file."""
        self._text(rest, self.line)
        if len(self.opened) > 1:
            inner = self.opened[-1]
            raise TextError(
                f"the file ends before this {inner.title or 'reference'} is closed with }}", place=inner.place
            )
        return self.opened[0]

    def _open(self, before: str, start: int) -> None:
        cut = max(before.rfind(";"), before.rfind(",")) + 1
        words = before[cut:].split()
        numbers = next((row for row, word in enumerate(words) if not _is_number(word)), len(words))
        if cut or numbers:
            self._text(f"{before[:cut]} {' '.join(words[:numbers])}", start)
        parent = self.opened[-1]
        inner = self._headed(words[numbers:])
        self._count()
        if parent.kind == REFERENCE:
            raise TextError("{ cannot stand inside a reference like {Arm}", place=f"line {self.line}")
        if len(self.opened) > DEEPEST:
            raise TextError(f"objects are nested deeper than {DEEPEST}", place=f"line {self.line}")
        if parent.kind != TEMPLATE and inner.kind != TEMPLATE:
            parent.parts.append(inner)
        self.opened.append(inner)

    def _count(self) -> None:
        self.count += 1
        if self.count > MOST_OBJECTS:
            raise TextError(
                f"the file has more than {MOST_OBJECTS} objects and texts", place=f"line {self.line}"
            )

    def _headed(self, head: Sequence[str]) -> DataObject:
        """Returns the object that begins with these words before its brace."""
        if not head:
            return DataObject(REFERENCE, "", self.line)
        name = " ".join(head[1:])
        if not _KIND.fullmatch(head[0]) or len(name) > LONGEST_NAME or len(head[0]) > LONGEST_NAME:
            raise TextError(
                f"before {{ stand the kind of an object and its name, not {' '.join(head)[:80]!r}",
                place=f"line {self.line}",
            )
        return DataObject(head[0].lower(), name, self.line)

    def _text(self, text: str, start: int) -> None:
        """Keeps numbers with the object that they belong to."""
        owner = self.opened[-1]
        if owner.kind == TEMPLATE or not text.strip(" \t\n;,"):
            return
        if len(self.opened) == 1:
            line = start + text[: len(text) - len(text.lstrip())].count("\n")
            raise TextError(f"{text.strip()[:80]!r} stands outside any object", place=f"line {line}")
        owner.pieces.append((start, text))

    def _close(self) -> None:
        if len(self.opened) == 1:
            raise TextError("this } closes no object", place=f"line {self.line}")
        inner = self.opened.pop()
        if inner.kind == REFERENCE:
            _name_reference(inner)


def _name_reference(reference: DataObject) -> None:
    """Gives a reference the name between its braces; a GUID beside the name is not needed."""
    texts = [*(text for _, text in reference.pieces), *reference.strings]
    reference.name = " ".join(" ".join(texts).split()).strip(" ;,")
    reference.pieces.clear()
    if not 0 < len(reference.name) <= LONGEST_NAME:
        raise TextError("a reference holds the name of an object, as in {Arm}", place=reference.place)


def _is_number(word: str) -> bool:
    return word[0] in "+-.0123456789"
