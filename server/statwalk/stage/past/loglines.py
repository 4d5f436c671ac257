"""A log as JSON lines: written, read again, and every line looked at before anything is done with it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from math import isfinite
from typing import Any, NamedTuple

import orjson

from statwalk.errors import StageError
from statwalk.stage.past.log import KINDS, LogEntry

SEMANTICS = 1
LARGEST = (1 << 63) - 1


class Loaded(NamedTuple):
    """What a file of lines says; `lines` are the numbers of those that the entries stand in."""

    header: dict[str, Any]
    entries: list[LogEntry]
    lines: list[int]


def dump(log: Iterable[LogEntry], header: Mapping[str, Any]) -> list[str]:
    """A log as JSON lines, the header first."""
    first = {"statwalk": "log", "semantics": SEMANTICS, "kernels": "numpy", **header}
    return [orjson.dumps(line).decode() for line in (first, *(vars(entry) for entry in log))]


def load(lines: Iterable[str]) -> Loaded:
    """Header and entries of JSON lines. Raises StageError that names the line which cannot be read, and what it should say."""
    records = [(number, _record(number, line)) for number, line in enumerate(lines, 1) if line.strip()]
    header = _header(records[0][1] if records else {})
    return Loaded(header, [_entry(number, record) for number, record in records[1:]], [number for number, _ in records[1:]])


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
        raise StageError(f"line 1: the log has semantics {header.get('semantics')!r}, this build reads {SEMANTICS}")
    for name, least in (("seed", -1 << 63), ("rate", 1), ("head", 0)):
        if name in header and not _is_whole(header[name], least):
            raise StageError(f"line 1: {name} is a whole number of at least {least}, not {header[name]!r}")
    return header


def _entry(number: int, record: dict[str, Any]) -> LogEntry:
    if set(record) != {"tick", "kind", "actor", "name", "value"} or record["kind"] not in KINDS:
        raise StageError(f"line {number}: an entry has tick, kind ({', '.join(KINDS)}), actor, name and value")
    if not _is_whole(record["tick"]) or not _is_whole(record["actor"]) or not isinstance(record["name"], str):
        raise StageError(f"line {number}: tick and actor are whole numbers of at least 0, name is text")
    is_right, wanted = VALUES.get(record["kind"], NO_VALUE)
    if not is_right(record["value"]):
        raise StageError(f"line {number}: the value of {record['kind']} is {wanted}, not {str(record['value'])[:80]}")
    return LogEntry(**record)


def _is_whole(value: object, least: int = 0) -> bool:
    return type(value) is int and least <= value <= LARGEST


def _is_number(value: object) -> bool:
    return type(value) in (int, float) and isfinite(value)  # type: ignore[arg-type]  # looked at just before


def _is_place(value: object) -> bool:
    if not isinstance(value, dict) or set(value) != {"role", "position", "heading"} or not isinstance(value["position"], list):
        return False
    numbers = (*value["position"], value["heading"])
    return isinstance(value["role"], str) and len(numbers) == 4 and all(map(_is_number, numbers))


def _is_version(value: object) -> bool:
    return isinstance(value, dict) and set(value) == {"role", "text"} and all(isinstance(part, str) for part in value.values())


NO_VALUE: tuple[Callable[[object], bool], str] = (lambda value: value is None, "null")
VALUES: Mapping[str, tuple[Callable[[object], bool], str]] = {
    "set": (_is_number, "a finite number"),
    "add": (_is_place, "role, position (x, y, z) and heading, all finite"),
    "edit": (_is_version, "role (`name@version`) and text"),
}
"""for each kind of entry what its value must be"""
