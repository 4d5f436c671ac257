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
from statwalk.stage.history.state_codec import from_bytes
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
from statwalk.stage.state.stage_state import StageState

Roles = Callable[..., Role]
"""returns the role of a name; for a version that the log edits it is called with `name@version` and the text
of the machine file
"""


def replay(source: Path | Iterable[str], roles: Roles, until: int | None = None) -> Stage:
    """Returns the stage of the JSON lines in `source`, at tick `until` (default: the head when the log was
    written).

    :raises StageError: when the log cannot be read, or names what does not exist; the message names the line;
        when another engine played it, or it leads to another state at its head than it did.
    """
    lines = source.read_text(encoding="utf-8").splitlines() if isinstance(source, Path) else source
    loaded = load(lines)
    stage = at_beginning(loaded, roles)
    last = loaded.header.get("head", stage.first) if until is None else until
    if last < stage.first:
        raise StageError(f"the past of the log was forgotten: it begins at tick {stage.first}, not {last}")
    stage.step(last - stage.first)
    if last == loaded.header.get("head") and loaded.header.get("hash", stage.hash) != stage.hash:
        raise StageError(
            f"the log leads to another state at tick {last} ({stage.hash}) than the one it had "
            f"({loaded.header['hash'][:16]}): a machine, a model or the log was changed since"
        )
    return stage


def at_beginning(loaded: Loaded, roles: Roles, newest: int = 0) -> Stage:
    """Returns a stage at the first tick of a log, whose steps follow the log; the numbers of its next entries
    are above `newest`.

    :raises StageError: when the log names what does not exist; the message names the line.
    """
    catalog = _catalog(loaded, roles)
    beginning = loaded.beginning
    start = from_bytes(beginning.state, catalog) if beginning else StageState()
    _check_names(loaded, catalog, start)
    log = MemoryLog(loaded.entries, max(newest, beginning.number if beginning else 0))
    seed, rate = loaded.header.get("seed", 0), loaded.header.get("rate", 60)
    return Stage.of(log, catalog, start, seed, rate, beginning)


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
    texts = loaded.beginning.texts if loaded.beginning else {}
    catalog = {key: roles(key, text) if text else roles(key) for key, text in texts.items()}
    catalog |= {name: roles(name) for name in sorted(names - set(edits) - set(catalog))}
    for key, (edit, line) in edits.items():
        catalog[key] = roles(key, edit.text)
        if catalog[key].name != edit.name:
            raise StageError(f"line {line}: {key} is a version of {catalog[key].name}, not of {edit.name}")
    return catalog


def _check_names(loaded: Loaded, catalog: Mapping[str, Role], start: StageState) -> None:
    """:raises StageError: when a command names an actor, event, parameter or state that never existed."""
    role_of = {actor: catalog[key].name for key, cast in start.casts.items() for actor in cast.ids.tolist()}
    newest = start.next_id - 1
    for entry, line in sorted(_numbered(loaded), key=lambda pair: pair[0].tick):
        command = entry.command
        try:
            if isinstance(command, Add):
                if command.actor <= newest:
                    raise StageError(
                        f"line {line}: the actors' numbers rise from 1; {command.actor} comes too late"
                    )
                role_of[command.actor], newest = catalog[command.role].name, command.actor
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
