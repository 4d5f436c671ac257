"""A stage from its log: the same states, bit for bit, in whatever process and however its time was cut."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from statwalk.errors import StageError, UnknownNameError
from statwalk.stage.past.log import LogEntry, MemoryLog
from statwalk.stage.past.loglines import Loaded, load
from statwalk.stage.role import Role
from statwalk.stage.stage import Stage

Roles = Callable[..., Role]
"""gives the role of a name; where the log edits one it is called with `name@version` and the text of the machine file"""


def replay(source: Path | Iterable[str], roles: Roles, until: int | None = None) -> Stage:
    """The stage that the JSON lines of `source` tell of, at tick `until` (default: where its log was written).

    Raises StageError, with the line, where the log cannot be read or asks for what is not there.
    """
    lines = source.read_text(encoding="utf-8").splitlines() if isinstance(source, Path) else source
    loaded = load(lines)
    catalog = _catalog(loaded, roles)
    _check_names(loaded, catalog)
    header = loaded.header
    stage = Stage.of(MemoryLog(loaded.entries), catalog, header.get("seed", 0), header.get("rate", 60))
    stage.step(header.get("head", 0) if until is None else until)
    return stage


def _catalog(loaded: Loaded, roles: Roles) -> dict[str, Role]:
    """All versions of all roles, by the names that the entries use."""
    edits: dict[str, tuple[LogEntry, int]] = {}
    for entry, line in _numbered(loaded):
        if entry.kind == "edit" and edits.setdefault(entry.value["role"], (entry, line))[0].value != entry.value:
            raise StageError(f"line {line}: {entry.value['role']} says something else in line {edits[entry.value['role']][1]}")
    names = {entry.value["role"] for entry in loaded.entries if entry.kind == "add"}
    catalog = {name: roles(name) for name in sorted(names - set(edits))}
    for key, (entry, line) in edits.items():
        catalog[key] = roles(key, entry.value["text"])
        if catalog[key].name != entry.name:
            raise StageError(f"line {line}: {key} is a version of {catalog[key].name}, not of {entry.name}")
    return catalog


def _check_names(loaded: Loaded, catalog: Mapping[str, Role]) -> None:
    """Raises StageError for entries about actors, events, parameters or states that there never were."""
    role_of: dict[int, str] = {}
    for entry, line in sorted(_numbered(loaded), key=lambda pair: pair[0].tick):
        try:
            if entry.kind == "add":
                if entry.actor <= max(role_of, default=0):
                    raise StageError(f"line {line}: the actors' numbers rise from 1; {entry.actor} comes too late")
                role_of[entry.actor] = catalog[entry.value["role"]].name
            elif entry.kind != "edit":
                _check(entry, role_of, catalog)
        except UnknownNameError as error:
            raise StageError(f"line {line}: {error}") from None


def _check(entry: LogEntry, role_of: Mapping[int, str], catalog: Mapping[str, Role]) -> None:
    if entry.actor not in role_of:
        raise UnknownNameError("actor", str(entry.actor), map(str, role_of))
    versions = [role for role in catalog.values() if role.name == role_of[entry.actor]]
    kind, known = {
        "remove": ("", [""]),
        "set": ("parameter", [one.name for role in versions for one in role.machine.parameters]),
        "travel": ("state", ["", *(state for role in versions for state in role.machine.states)]),
    }.get(entry.kind, ("event", [event for role in versions for event in role.machine.events[:-1]]))
    if kind and entry.name not in known:
        raise UnknownNameError(kind, entry.name, dict.fromkeys(known))


def _numbered(loaded: Loaded) -> Iterable[tuple[LogEntry, int]]:
    return zip(loaded.entries, loaded.lines, strict=True)
