"""A log as JSON lines. Every line is checked when it is read."""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import fields
from itertools import chain
from math import isfinite
from typing import Any, NamedTuple

import orjson

from statwalk.errors import StageError
from statwalk.stage.history.engine import ENGINE, RELEASE, check_engine
from statwalk.stage.state.commands import (
    Add,
    Command,
    Edit,
    Hold,
    LogEntry,
    Press,
    Release,
    Remove,
    Set,
    Travel,
)

SEMANTICS = 1
LARGEST = (1 << 63) - 1


class Beginning(NamedTuple):
    """What a log goes on from whose oldest entries were forgotten."""

    state: bytes
    texts: Mapping[str, str]
    """of the machine files of the roles that play, by the key of the role; empty: the file itself says it"""
    number: int
    """the sequence number of the newest entry that was forgotten"""


class Loaded(NamedTuple):
    """The contents of a log file; `lines` are the line numbers of the entries."""

    header: dict[str, Any]
    entries: list[LogEntry]
    lines: list[int]
    beginning: Beginning | None = None


def dump(
    log: Iterable[LogEntry], header: Mapping[str, Any], beginning: Beginning | None = None
) -> Iterator[str]:
    """Yields a log as JSON lines, the header first."""
    return chain([log_header(header, beginning)], map(line_of, log))


def log_header(header: Mapping[str, Any], beginning: Beginning | None = None) -> str:
    """Returns the first line of a log."""
    made_by = {"engine": ENGINE, "version": RELEASE}
    first = {"statwalk": "log", "semantics": SEMANTICS, **made_by, **header}
    if beginning:
        state = b64encode(beginning.state).decode()
        first["beginning"] = {**beginning._asdict(), "state": state}
    return orjson.dumps(first).decode()


def line_of(entry: LogEntry) -> str:
    """Returns an entry as a JSON line."""
    kind = type(entry.command).__name__.lower()
    line = {"number": entry.number, "tick": entry.tick, "kind": kind, **vars(entry.command)}
    return orjson.dumps(line).decode()


def load(lines: Iterable[str]) -> Loaded:
    """Returns header and entries of JSON lines.

    :raises StageError: when a line cannot be read; the message names the line and what it should say.
    """
    records = [(number, _record(number, line)) for number, line in enumerate(lines, 1) if line.strip()]
    header = _header(records[0][1] if records else {})
    return Loaded(
        header,
        [_entry(number, record) for number, record in records[1:]],
        [number for number, _ in records[1:]],
        _beginning(header["beginning"]) if "beginning" in header else None,
    )


def _record(number: int, line: str) -> dict[str, Any]:
    try:
        record = orjson.loads(line)
    except orjson.JSONDecodeError as error:
        raise StageError(f"line {number}: {error}") from None
    if not isinstance(record, dict):
        raise StageError(f"line {number}: a JSON object is needed")
    return record


def _header(header: dict[str, Any]) -> dict[str, Any]:
    if header.get("statwalk") != "log":
        raise StageError('line 1: not a statwalk log; its first line says {"statwalk": "log", …}')
    if header.get("semantics") != SEMANTICS:
        raise StageError(
            f"line 1: the log has semantics {header.get('semantics')!r}, this build reads {SEMANTICS}"
        )
    check_engine(header)
    if not _is_text(header.get("hash", "")):
        raise StageError("line 1: hash is text")
    for name, least in (("seed", -1 << 63), ("rate", 1), ("head", 0)):
        if name in header and not _is_whole(header[name], least):
            raise StageError(f"line 1: {name} is a whole number of at least {least}, not {header[name]!r}")
    return header


def _beginning(written: object) -> Beginning:
    match written:
        case {"state": str(state), "texts": dict(texts), "number": number} if all(
            map(_is_text, texts.values())
        ) and _is_whole(number):
            try:
                return Beginning(b64decode(state, validate=True), texts, number)
            except ValueError as error:
                raise StageError(f"line 1: the state of the beginning is no base64: {error}") from None
    raise StageError("line 1: a beginning has a state (base64), texts (by the keys of roles) and a number")


def _entry(number: int, record: dict[str, Any]) -> LogEntry:
    place = [record.pop(name, None) for name in ("number", "tick")]
    kind = KINDS.get(str(record.pop("kind", "")))
    if kind is None or not all(map(_is_whole, place)):
        raise StageError(
            f"line {number}: an entry has number and tick, whole numbers of at least 0, and kind "
            f"({', '.join(KINDS)})"
        )
    checks = CHECKS_OF[kind]
    if record.keys() != checks.keys():
        raise StageError(
            f"line {number}: {kind.__name__.lower()} has {', '.join(checks)} beside number, tick and kind"
        )
    for name, (is_right, wanted) in checks.items():
        if not is_right(record[name]):
            raise StageError(f"line {number}: {name} is {wanted}, not {str(record[name])[:80]}")
    if kind is Add:
        record["position"] = tuple(record["position"])
    return LogEntry(place[0], place[1], kind(**record))


def _is_whole(value: object, least: int = 0) -> bool:
    return type(value) is int and least <= value <= LARGEST


def _is_number(value: object) -> bool:
    return type(value) in (int, float) and isfinite(value)  # type: ignore[arg-type]  # looked at just before


def _is_text(value: object) -> bool:
    return isinstance(value, str)


def _is_place(value: object) -> bool:
    return isinstance(value, list) and len(value) == 3 and all(map(_is_number, value))


KINDS: Mapping[str, type[Command]] = {
    kind.__name__.lower(): kind for kind in (Add, Remove, Press, Hold, Release, Set, Travel, Edit)
}
TEXT: tuple[Callable[[object], bool], str] = (_is_text, "text")
NUMBER: tuple[Callable[[object], bool], str] = (_is_number, "a finite number")
CHECKS: Mapping[str, tuple[Callable[[object], bool], str]] = {
    **dict.fromkeys(("name", "role", "event", "parameter", "state", "text"), TEXT),
    **dict.fromkeys(("value", "heading"), NUMBER),
    "actor": (_is_whole, "a whole number of at least 0"),
    "position": (_is_place, "three finite numbers"),
}
"""for each field of a command its check, and the value it needs in words"""
CHECKS_OF = {kind: {field.name: CHECKS[field.name] for field in fields(kind)} for kind in KINDS.values()}
