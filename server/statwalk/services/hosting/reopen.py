"""Brings the stages and the versions of machines back that the store has kept, when the server starts."""

from __future__ import annotations

import logging
import time
from collections.abc import Mapping
from dataclasses import replace
from functools import partial

from statwalk.character.role import Role
from statwalk.errors import ContentError, StageError, StatwalkError
from statwalk.files.machine_yaml.machine_file import FILE_NAME, machine_of
from statwalk.services.hosting.edited_file import saved
from statwalk.services.hosting.machine_versions import MOST_VERSIONS, MachineVersions
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_messages import Edit
from statwalk.services.hosting.store.database import KEYS, VERSIONS
from statwalk.services.hosting.store.records import MAIN, MachineVersion, StageRecord
from statwalk.services.hosting.store.store import Store
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.role_reference import model_digest
from statwalk.stage.history.engine import ENGINE, RELEASE
from statwalk.stage.history.log_codec import Beginning, Loaded, load, log_header
from statwalk.stage.replay import at_beginning
from statwalk.stage.stage import Stage
from statwalk.stage.state import commands

log = logging.getLogger("statwalk.store")
AT_ONCE = (commands.Add, commands.Remove, commands.Edit)
"""commands that count at the end of the tick in which they come; the others count in the next tick"""


def reopen(registry: Registry, main: str) -> None:
    """Brings everything back; `main`: what the stage `main` is to open with. A `main` that was opened with
    something else goes on under another id. What cannot come back is logged, and stays in the store.

    :raises StorageError: when the database is damaged.
    """
    store = registry.store
    if store is None:
        return
    _check_answers(registry, store)
    _reopen_versions(registry, store)
    names: dict[str, str] = {}  # new ids by the old ones; a fork comes after the stage that it left
    for stage_id in store.records.ids():
        try:
            record = store.records.record(stage_id)
            if stage_id == MAIN and record.identity.opened != main:
                names[MAIN] = _rename_main(registry, store)
            _reopen_stage(registry, store, _renamed(record, names))
        except StatwalkError as error:
            log.error("the stage %s is not brought back, and its record is kept: %s", stage_id, error)
            if stage_id == MAIN and MAIN not in names:
                names[MAIN] = _rename_main(
                    registry, store
                )  # the server opens a new stage that is called main
            kept = names.get(stage_id, stage_id)
            why = error.without_folder() if isinstance(error, ContentError) else error
            registry.left[kept] = f"{kept} is kept, and did not come back: {why}"


def _check_answers(registry: Registry, store: Store) -> None:
    """A damaged page may hide answers, which have no end as logs have: the stages come back without them."""
    if damage := _damage(store, KEYS):
        again = "a request that is sent again may count again"
        _report(registry, f"answers to requests are damaged, and {again}: {damage}")


def _damage(store: Store, table: str) -> str:
    """What is wrong with the pages of a table; empty: nothing."""
    return "; ".join(store.records.damage(table)[:3])


def _report(registry: Registry, damage: str) -> None:
    log.error("%s", damage)
    registry.damage.append(damage)


# --- stages


def _renamed(record: StageRecord, names: Mapping[str, str]) -> StageRecord:
    """The record with the present ids of the stage and of the stage that it left."""
    identity, origin = record.identity, record.identity.origin
    if origin:
        origin = replace(origin, stage=names.get(origin.stage, origin.stage))
    return replace(record, identity=replace(identity, id=names.get(identity.id, identity.id), origin=origin))


def _rename_main(registry: Registry, store: Store) -> str:
    """Gives the kept `main` another id, and returns the id."""
    name = registry.new_id()
    store.rename(MAIN, name)
    log.warning("the stage that was %s is now %s", MAIN, name)
    return name


def _reopen_stage(registry: Registry, store: Store, record: StageRecord) -> None:
    stage = reopened(record, registry.catalogue)
    host = StageHost(record.identity, stage, registry)
    kept = store.stage(record.identity)
    kept.resume(stage, record)
    host.resume(kept, paused=record.note.paused, speed=record.note.speed)
    registry.stages[host.id] = host
    for name in {role.name for role in stage.roles.values()}:
        text = registry.catalogue.entry(name).file.text
        if registry.catalogue.texts[stage.role(name)] != text:
            host.handle(Edit(name, text))  # its file was saved while no server ran


def reopened(record: StageRecord, catalogue: Catalogue) -> Stage:
    """Returns a stage as it was kept: at its playhead, or after the newest command that was acknowledged.

    :raises StageError: when the log does not lead to the state that was kept.
    :raises StatwalkError: when a machine or a character is not there any more, or another one.
    """
    identity, note = record.identity, record.note
    header = log_header({"seed": identity.seed, "rate": identity.rate}, _beginning(record))
    loaded = load([header, *record.lines])
    role_of = partial(_role, record, catalogue)
    number = identity.origin.number if identity.origin else 0
    try:
        stage = at_beginning(loaded, role_of, number)
        stage.resume(note.head, record.snapshots)
    except StageError:  # snapshots of another engine: its states may be others, the hash below decides
        stage = at_beginning(loaded, role_of, number)
        stage.resume(note.head, {})
    stage.seek(note.tick)
    if stage.hash != note.hash:
        raise StageError(
            f"its log leads to another state at tick {note.tick} than the one it had: another engine played "
            f"it. This is engine {ENGINE} (statwalk {RELEASE}): open it with the version that made it"
        )
    if (acknowledged := _newest_tick(loaded)) > note.head:
        stage.seek(note.head)
        stage.step(acknowledged - note.head)
    return stage


def _beginning(record: StageRecord) -> Beginning | None:
    if record.beginning is None:
        return None
    tick, number = record.beginning
    return Beginning(record.snapshots[tick], dict.fromkeys(record.roles, ""), number)


def _newest_tick(loaded: Loaded) -> int:
    """The tick at which the newest command was posted."""
    return max((entry.tick - (not isinstance(entry.command, AT_ONCE)) for entry in loaded.entries), default=0)


def _role(record: StageRecord, catalogue: Catalogue, key: str, text: str = "") -> Role:
    """The role of a key of the log; `text`: of an edit."""
    name = key.partition("@")[0]
    kept = record.roles.get(key)
    if kept is None and not text:
        raise StageError(f"the text of {key} is missing")
    role = catalogue.version(name, text or (kept.text if kept else ""))
    if kept is not None and model_digest(role) != kept.model:
        raise StageError(f"the model of {name} is another one now")
    return role


# --- versions of machines


def _reopen_versions(registry: Registry, store: Store) -> None:
    versions, damaged = registry.versions, store.records.damaged_versions()
    if damage := _damage(store, VERSIONS):
        _report(registry, f"versions of machines are damaged, and some may not come back: {damage}")
    for machine, numbers in damaged.items():
        _report(registry, f"{machine} comes back without version {_listed(numbers)}: damaged")
    for machine, kept in store.records.versions().items():
        if machine not in versions.catalogue.entries:
            continue
        try:
            _reopen_machine(versions, machine, kept, damaged.get(machine, []))
        except StatwalkError as error:
            log.error("%s keeps the text of its file: %s", machine, error)


def _reopen_machine(
    versions: MachineVersions, machine: str, kept: list[MachineVersion], damaged: list[int]
) -> None:
    """A shipped machine plays its newest edit again; another machine has its file, which may be newer."""
    catalogue = versions.catalogue
    entry = catalogue.entry(machine)
    text = kept[-1].text if saved(entry) == "memory" else entry.file.text
    if version := _new_version(kept[-1], text, _newer(damaged, kept[-1].number)):
        kept = [*kept, version]
        versions.keep(machine, kept)
    if text != entry.file.text:
        role = catalogue.version(machine, text)
        catalogue.renew(replace(entry, file=machine_of(text, entry.folder, FILE_NAME)), role)
    versions.versions_of[machine] = kept


def _newer(damaged: list[int], number: int) -> list[int]:
    """The numbers of the damaged versions that came after a version; a number may be damaged itself."""
    return [lost for lost in damaged if number < lost <= number + MOST_VERSIONS]


def _new_version(newest: MachineVersion, text: str, lost: list[int]) -> MachineVersion | None:
    """The version that says why a machine has `text` now, if that is not just the text of its newest version;
    `lost`: the numbers of newer versions, which are damaged.
    """
    is_newest = text == newest.text
    if lost:
        instead = f"version {newest.number} again" if is_newest else "the text of the file"
        what = f"version {_listed(lost)} is damaged: {instead}"
    elif not is_newest:
        what = "the file was saved while no server ran"
    else:
        return None
    before = newest.before if is_newest else newest.number
    return MachineVersion(max([newest.number, *lost]) + 1, time.time(), what, text, before)


def _listed(numbers: list[int]) -> str:
    return ", ".join(map(str, numbers))
