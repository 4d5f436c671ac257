"""The file of a machine that is edited."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from typing import Literal

from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.services.library.entry import Entry
from statwalk.services.library.load import shipped_machines_folder
from statwalk.services.library.put_in_place import put_machine_in_place

Saved = Literal["file", "memory"]


def saved(entry: Entry) -> Saved:
    """Returns where edits of a machine are kept: in its `file`, or, for a shipped machine, in `memory`, and
    in the store if there is one.
    """
    return "memory" if entry.folder.is_relative_to(shipped_machines_folder()) else "file"


@contextmanager
def written(entry: Entry, version: MachineVersion) -> Iterator[None]:
    """Writes a version to the machine's file, if edits are kept there.

    :raises StorageError: when the disk refuses, or the context raises it; the file is as it was then.
    """
    with (
        put_machine_in_place(entry.folder, MachineText.of(version.text))
        if saved(entry) == "file"
        else nullcontext()
    ):
        yield
