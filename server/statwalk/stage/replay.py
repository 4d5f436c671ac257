"""A stage from its log: the same states, bit for bit, in whatever process and however its time was cut."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from statwalk.errors import StageError
from statwalk.stage.log import LogEntry, MemoryLog, load
from statwalk.stage.role import Role
from statwalk.stage.stage import Stage


def replay(source: Path | Iterable[str], roles: Callable[[str], Role], until: int | None = None) -> Stage:
    """The stage that the JSON lines of `source` tell of, at tick `until` (default: where its log was written).

    `roles` gives the role of a name. Raises StageError where the log cannot be read or asks for what is not there.
    """
    lines = source.read_text(encoding="utf-8").splitlines() if isinstance(source, Path) else source
    header, entries = load(lines)
    cast = {name: roles(name) for name in sorted({_role_of(entry) for entry in entries if entry.kind == "add"})}
    stage = Stage.of(MemoryLog(entries), cast, int(header.get("seed", 0)), int(header.get("rate", 60)))
    stage.step(int(header.get("head", 0)) if until is None else until)
    return stage


def _role_of(entry: LogEntry) -> str:
    if not isinstance(entry.value, dict) or set(entry.value) != {"role", "position", "heading"}:
        raise StageError(f"the log adds actor {entry.actor} at tick {entry.tick} without role, position and heading")
    return str(entry.value["role"])
