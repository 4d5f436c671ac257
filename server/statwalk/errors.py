"""Every error statwalk raises on purpose, in one tree.

    StatwalkError
    +- ContentError          a file says something wrong; carries file, place (line, JSON pointer or byte) and name
    |  +- ModelError         a glTF model
    |  +- TextError          the FAQ's skeleton and key-frame text, a character file
    |  +- MachineError       a machine file or its table
    +- UnknownNameError      a name that does not exist; carries the names that do
    +- StageError            a stage was asked for something it cannot do (a tick that is not there, an event in the past)

Each message says what is wrong, where, and what would be right.
"""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from itertools import islice

MOST_NAMES, MOST_LETTERS = 300, 40
"""that are compared with a name that does not exist"""


class StatwalkError(Exception):
    """The root: catch this to catch all that a user's input can cause."""


class ContentError(StatwalkError):
    """A file says something wrong: `message` what, `file` and `place` where (`line 12`, `/nodes/3/mesh`, `byte 20`)."""

    def __init__(self, message: str, *, file: str = "", place: str = "") -> None:
        self.message, self.file, self.place = message, file, place
        where = ", ".join(part for part in (file, place) if part)
        super().__init__(f"{where}: {message}" if where else message)

    def in_file(self, file: str) -> ContentError:
        """The same error with the file's name, for readers that were given bytes or text."""
        return type(self)(self.message, file=self.file or file, place=self.place)


class ModelError(ContentError):
    """A glTF model that must be refused; `place` is a JSON pointer or a byte offset."""


class TextError(ContentError):
    """A skeleton, key-frame or character file that must be refused; `place` is a line."""


class MachineError(ContentError):
    """A machine file or table that must be refused; `place` is a line."""


def nearest(name: str, known: Iterable[str]) -> str:
    """`; did you mean WALK?`, or nothing where no name is near; looks at no more names and letters than cost next to nothing."""
    short = {one[:MOST_LETTERS]: one for one in islice(known, MOST_NAMES)}
    near = get_close_matches(name[:MOST_LETTERS], list(short), n=1)
    return f"; did you mean {short[near[0]]}?" if near else ""


class UnknownNameError(StatwalkError):
    """`name` is no `kind` (state, event, clip, machine …) here; `known` lists those that exist."""

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        self.kind, self.name, self.known = kind, name, tuple(known)
        super().__init__(f"no {kind} is called {name!r}{nearest(name, self.known) or '.'} There are: {', '.join(self.known) or 'none'}")


class StageError(StatwalkError):
    """A stage was asked for something it cannot do."""
