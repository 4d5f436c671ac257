"""Replay: a stage from its log, with the same states, bit for bit, in any process and in any slices
of time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from statwalk.character.role import Role
from statwalk.errors import StageError, UnknownNameError
from statwalk.stage.history.log import MemoryLog
from statwalk.stage.history.log_codec import Loaded, load
from statwalk.stage.stage import Stage
from statwalk.stage.state.commands import (
    Add,
    Edit,
    Hold,
    Input,
    LogEntry,
    Press,
    Release,
    Remove,
    Set,
    Travel,
)

Roles = Callable[..., Role]
"""returns the role of a name; for a version that the log edits it is called with `name@version` and the text
of the machine file
"""


def replay(source: Path | Iterable[str], roles: Roles, until: int | None = None) -> Stage:
    """Returns the stage of the JSON lines in `source`, at tick `until` (default: the head when the log was
    written).

    :raises StageError: when the log cannot be read, or names what does not exist; the message names the line.
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
    """All versions of all roles, by the keys of the commands."""
    edits: dict[str, tuple[Edit, int]] = {}
    for entry, line in _numbered(loaded):
        command = entry.command
        if isinstance(command, Edit) and edits.setdefault(command.role, (command, line))[0] != command:
            raise StageError(
                f"line {line}: {command.role} says something else in line {edits[command.role][1]}"
            )
    names = {entry.command.role for entry in loaded.entries if isinstance(entry.command, Add)}
    catalog = {name: roles(name) for name in sorted(names - set(edits))}
    for key, (edit, line) in edits.items():
        catalog[key] = roles(key, edit.text)
        if catalog[key].name != edit.name:
            raise StageError(f"line {line}: {key} is a version of {catalog[key].name}, not of {edit.name}")
    return catalog


def _check_names(loaded: Loaded, catalog: Mapping[str, Role]) -> None:
    """:raises StageError: when a command names an actor, event, parameter or state that never existed."""
    role_of: dict[int, str] = {}
    for entry, line in sorted(_numbered(loaded), key=lambda pair: pair[0].tick):
        command = entry.command
        try:
            if isinstance(command, Add):
                if command.actor <= max(role_of, default=0):
                    raise StageError(
                        f"line {line}: the actors' numbers rise from 1; {command.actor} comes too late"
                    )
                role_of[command.actor] = catalog[command.role].name
            elif not isinstance(command, Edit):
                _check(command, role_of, catalog)
        except UnknownNameError as error:
            raise StageError(f"line {line}: {error}") from None


def _check(command: Input | Remove, role_of: Mapping[int, str], catalog: Mapping[str, Role]) -> None:
    if command.actor not in role_of:
        raise UnknownNameError("actor", str(command.actor), map(str, role_of))
    machines = [role.machine for role in catalog.values() if role.name == role_of[command.actor]]
    match command:
        case Set(parameter=name):
            kind, known_names = (
                "parameter",
                [parameter.name for machine in machines for parameter in machine.parameters],
            )
        case Travel(state=name):
            kind, known_names = "state", ["", *(state for machine in machines for state in machine.states)]
        case Press(event=name) | Hold(event=name) | Release(event=name):
            kind, known_names = "event", [event for machine in machines for event in machine.events[:-1]]
        case Remove():
            return
    if name not in known_names:
        raise UnknownNameError(kind, name, dict.fromkeys(known_names))


def _numbered(loaded: Loaded) -> Iterable[tuple[LogEntry, int]]:
    return zip(loaded.entries, loaded.lines, strict=True)
