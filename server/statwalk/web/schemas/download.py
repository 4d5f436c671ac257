"""The formats in which a character can be downloaded."""

from __future__ import annotations

from statwalk.web.schemas.base import ResponseModel


class LossView(ResponseModel):
    """Something that a file cannot hold: the kind of part, the number of parts, the names of the first of
    them, and what the file has in their place.
    """

    part: str
    count: int
    names: list[str]
    instead: str


class FormatView(ResponseModel):
    """A format of files: its name and suffix, the address of the character in it, and what it cannot hold."""

    format: str
    suffix: str
    file: str
    lost: list[LossView]
