"""Processes that rename a machine, and are killed before their nth change of a file or of the database."""

import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

from keeping import keeping
from killed import CONTEXT
from statwalk.files.machine_yaml.edit.operations import RenameState
from statwalk.services.hosting.machine_edits import EditRequest, change
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.services.hosting.store.writer import Writer
from statwalk.services.library import made_machines
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.made_keys import NewPlace
from statwalk.services.library.model_store import ModelStore
from statwalk.web.routes import new_machines

OLD, NEW = "old", "new"


def catalogue_of(folder: Path) -> Catalogue:
    return Catalogue(store=ModelStore(folder))


def edited(folder: Path) -> list[MachineVersion]:
    """Makes a machine in a new data folder, and edits it; returns its versions."""
    catalogue = catalogue_of(folder)
    assert catalogue.store is not None
    catalogue.adopt(*made_machines.copy(NewPlace(OLD, catalogue.store), catalogue.entry("elbow"), catalogue))
    with keeping(folder, catalogue) as held:
        for number, name in enumerate(("STRAIGHT", "STRETCHED"), 1):
            state = held.catalogue.entry(OLD).file.definition.initial
            change(held.versions, EditRequest(OLD, number), [RenameState(state, name)])
        return held.versions.of(OLD)


def rename(folder: Path, nth: int) -> None:
    """Renames the machine, and is killed before the nth change, 0 the first."""
    with keeping(folder, catalogue_of(folder)) as held:
        left = nth

        def killing(call: Callable[..., Any]) -> Callable[..., Any]:
            def counted(*arguments: Any, **options: Any) -> Any:
                nonlocal left
                if left == 0:
                    os.kill(os.getpid(), signal.SIGKILL)
                left -= 1
                return call(*arguments, **options)

            return counted

        os.rename, os.fsync = killing(os.rename), killing(os.fsync)
        Writer.put, Writer.flush = killing(Writer.put), killing(Writer.flush)  # type: ignore[method-assign]
        new_machines._rename(OLD, NEW, held, None)


def is_killed(folder: Path, nth: int) -> bool:
    """Whether the process was killed, and not at its end before."""
    process = CONTEXT.Process(target=rename, args=(folder, nth))
    process.start()
    process.join()
    assert process.exitcode in (0, -signal.SIGKILL)
    return process.exitcode != 0


def found(held: Registry) -> dict[str, list[MachineVersion]]:
    """The versions of the machine, by each name that it has."""
    return {name: held.versions.of(name) for name in (OLD, NEW) if name in held.catalogue.entries}
