"""The bodies about the versions of a machine."""

from __future__ import annotations

from typing import Literal

from statwalk.web.schemas.base import ResponseModel


class VersionView(ResponseModel):
    """A version of a machine; `at` in seconds since 1970; `what` says in a few words what the edit changed,
    and `author` who made it, if the server asks for tokens.
    """

    version: int
    at: float
    what: str
    before: int
    """the version that an undo brings back; 0: none"""
    after: int
    """the version that a redo brings back; 0: none"""
    author: str


class VersionText(VersionView):
    """A version with its text: the machine file, and its .csv tables by the names of their files."""

    text: str
    tables: dict[str, str]


class CellDifferenceView(ResponseModel):
    """A cell in both versions, as in the table and with its fields; null: it is blank."""

    layer: str
    state: str
    event: str
    before: str | None
    after: str | None


class NameDifferenceView(ResponseModel):
    """A state of a layer, or an event (its layer is empty); `before` null: it is new; `after` null: it is
    gone; both: it was renamed.
    """

    kind: Literal["state", "event"]
    layer: str
    before: str | None
    after: str | None


class PartDifferenceView(ResponseModel):
    """Another part of the machine: `["parameter", "pace", "max"]`; null: it is not there."""

    part: list[str]
    before: str | None
    after: str | None


class VersionDifferencesView(ResponseModel):
    """What differs between two versions; states and events by their names in the newer one."""

    version: int
    since: int
    names: list[NameDifferenceView]
    cells: list[CellDifferenceView]
    parts: list[PartDifferenceView]
