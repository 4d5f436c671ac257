"""Examines a data folder: what is in it, and what is damaged."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from statwalk.errors import StatwalkError
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.services.hosting.store.read_records import KeptRecords
from statwalk.services.library.model_store import ModelStore


class Examined(NamedTuple):
    """A part of the data folder; `damage`: what is wrong with it, or empty."""

    part: str
    facts: str
    damage: str = ""


def examine(folder: Path) -> Iterator[Examined]:
    """Yields the parts of a data folder; a server may use it meanwhile.

    :raises StorageError: when the database cannot be read at all.
    """
    path = folder / FILE_NAME
    if path.is_file():
        records = KeptRecords(path)
        yield Examined("database", f"{path.stat().st_size:,} bytes", "; ".join(records.damage()[:3]))
        yield from (_stage(records, stage) for stage in records.ids())
        for machine, versions in records.versions().items():
            yield Examined(f"machine {machine}", f"{len(versions)} versions")
    yield from _models(ModelStore(folder))


def _stage(records: KeptRecords, stage: str) -> Examined:
    try:
        record, bad = records.record(stage), records.damaged_snapshots(stage)
    except StatwalkError as error:
        return Examined(f"stage {stage}", "", str(error))
    note = record.note
    held = f"{len(record.lines):,} inputs, {len(record.snapshots)} snapshots"
    ticks = ", ".join(map(str, bad[:5]))
    damage = f"snapshots of tick {ticks} (made again from the log)" if bad else ""
    return Examined(f"stage {stage}", f"tick {note.tick:,} of {note.head:,}, {held}", damage)


def _models(store: ModelStore) -> Iterator[Examined]:
    for name, upload in store.characters().items():
        data = store.model(upload.sha256).read_bytes()
        is_whole = hashlib.sha256(data).hexdigest() == upload.sha256
        yield Examined(
            f"character {name}", f"{len(data):,} bytes", "" if is_whole else "the model is damaged"
        )
