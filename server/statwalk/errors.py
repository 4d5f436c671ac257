"""The errors that statwalk raises on purpose, as one class tree.

    StatwalkError
    +- ContentError          a file is wrong; carries the file, the place (line, JSON pointer or byte offset)
    |  |                     and the message
    |  +- ModelError         a glTF model
    |  +- TextError          the FAQ's skeleton and key-frame text, a character file
    |  +- MachineError       a machine file or its table
    +- UnknownNameError      a name does not exist; carries the existing names
    +- StageError            a stage cannot do what is asked (a tick out of range, an event in the past)
    +- RefusedEditError      an edit would break a machine; carries the verifier's new findings
    +- ConflictError         a request conflicts with the current state
    |  +- LimitError         the maximum number is reached
    |  +- VersionConflictError  another client has changed the resource since it was read
    +- BusyError             the server is busy: the same request may succeed later
    +- StorageError          the disk is full or refuses: nothing can be kept until it takes writes again
    +- CancelledError        long work was cancelled, because no client waits for the result
    +- OverdueError          long work took longer than it may

Each message says what is wrong, where, and what would be right.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from errno import EDQUOT, ENOSPC
from functools import partial
from itertools import islice
from pathlib import PurePath
from typing import Any, TypeVar

Thing = TypeVar("Thing")
MOST_NAMES, MOST_LETTERS = 300, 40
"""how many existing names, and letters of each, are compared with an unknown name"""
LONGEST_NAME = 80
"""letters of an unknown name that a message repeats"""
MOST_LISTED = 40
"""existing names in a message; `UnknownNameError.known` has them all"""


class StatwalkError(Exception):
    """The base class: catch StatwalkError to catch every error that a user's input can cause."""


class ContentError(StatwalkError):
    """A file is wrong: `message` says what, `file` and `place` say where (`line 12`, `/nodes/3/mesh`, `byte
    20`).
    """

    def __init__(self, message: str, *, file: str = "", place: str = "") -> None:
        self.message, self.file, self.place = message, file, place
        where = ", ".join(part for part in (file, place) if part)
        super().__init__(f"{where}: {message}" if where else message)

    def in_file(self, file: str) -> ContentError:
        """Returns the same error with the file's name, for readers that get bytes or text without a name."""
        return type(self)(self.message, file=self.file or file, place=self.place)

    def without_folder(self) -> ContentError:
        """Returns the same error with the last part of an absolute path as its file, for readers who need not
        know where a server keeps its files; a relative path, as in a zip, stays.
        """
        name = PurePath(self.file).name if PurePath(self.file).is_absolute() else self.file
        return type(self)(self.message, file=name, place=self.place)


class ModelError(ContentError):
    """A glTF model is refused; `place` is a JSON pointer or a byte offset."""


class TextError(ContentError):
    """A skeleton, key-frame or character file is refused; `place` is a line."""


class MachineError(ContentError):
    """A machine file or a table is refused; `place` is a line."""


def nearest(name: str, names: Iterable[str]) -> str:
    """Returns `; did you mean WALK?` with the name most like `name`, or the empty string if no name is
    similar.

    Compares at most MOST_NAMES names and MOST_LETTERS letters, so that the search stays cheap.
    """
    short = {candidate[:MOST_LETTERS]: candidate for candidate in islice(names, MOST_NAMES)}
    matches = get_close_matches(name[:MOST_LETTERS], list(short), n=1)
    return f"; did you mean {short[matches[0]]}?" if matches else ""


def abridged(names: tuple[str, ...]) -> str:
    """Returns the first MOST_LISTED names with commas, and how many more there are."""
    more = len(names) - MOST_LISTED
    listed = ", ".join(names[:MOST_LISTED]) or "none"
    return f"{listed} … and {more:,} more" if more > 0 else listed


class UnknownNameError(StatwalkError):
    """No `kind` (state, event, clip, machine …) has the name `name`; `known` lists the existing names; `why`
    may say where it went.
    """

    def __init__(self, kind: str, name: str, known: Iterable[str], why: str = "") -> None:
        self.kind, self.name, self.known, self.why = kind, name, tuple(known), why
        suggestion = nearest(name, self.known) or "."
        super().__init__(
            f"no {kind} is called {name[:LONGEST_NAME]!r}{suggestion} There are: {abridged(self.known)}"
            + (why and f". {why}")
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.kind, self.name, self.known, self.why)


class StageError(StatwalkError):
    """A stage cannot do what is asked."""


def existing(kind: str, name: str, known: Mapping[str, Thing]) -> Thing:
    """Returns what has a name.

    :raises UnknownNameError: when nothing of the `kind` has the name; the error lists the names.
    """
    if name not in known:
        raise UnknownNameError(kind, name, known)
    return known[name]


class RefusedEditError(StatwalkError):
    """An edit is refused: `field` says where, `findings` are the verifier's findings that the edit
    would add.
    """

    def __init__(self, message: str, *, field: str, findings: Iterable[Any] = ()) -> None:
        self.field, self.findings = field, tuple(findings)
        super().__init__(message)

    def __reduce__(self) -> tuple[Any, ...]:
        return partial(type(self), field=self.field, findings=self.findings), self.args


class ConflictError(StatwalkError):
    """A request conflicts with the current state; `field` names the part of the request that conflicts, if
    any.
    """

    def __init__(self, message: str, *, field: str = "") -> None:
        self.field = field
        super().__init__(message)


class LimitError(ConflictError):
    """The maximum number is reached; `limit` is its name in docs/limits.md."""

    def __init__(self, message: str, *, field: str = "", limit: str = "") -> None:
        self.limit = limit
        super().__init__(message, field=field)


class VersionConflictError(ConflictError):
    """Another client has changed the resource since it was read."""


class BusyError(StatwalkError):
    """The server is busy: the same request may succeed later."""


class StorageError(StatwalkError):
    """The disk refuses to write, `is_full`: because it has no room left."""

    def __init__(self, message: str, *, is_full: bool = False) -> None:
        self.is_full = is_full
        super().__init__(message)

    @classmethod
    def of(cls, error: OSError, what: str) -> StorageError:
        """Returns the error for a file, or something else, that cannot be written."""
        return cls(
            f"{what} cannot be written: {error.strerror or error}", is_full=error.errno in (ENOSPC, EDQUOT)
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return partial(type(self), is_full=self.is_full), self.args


class CancelledError(StatwalkError):
    """Long work was cancelled: no client waits for the result."""


class OverdueError(StatwalkError):
    """Long work took longer than it may, and was stopped."""
