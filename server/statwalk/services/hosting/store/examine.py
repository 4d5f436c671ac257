"""Examines a data folder: what is in it, and what is damaged."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from statwalk.errors import StatwalkError
from statwalk.services.hosting.store.database import FILE_NAME, FORMAT, opened
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
    :raises ContentError: when a newer version of statwalk wrote it.
    """
    path = folder / FILE_NAME
    if path.is_file():
        damage = "; ".join(KeptRecords(path).damage()[:3])
        yield Examined("database", f"{path.stat().st_size:,} bytes", damage)
        with _up_to_date(path) as records:
            yield from (_stage(records, stage) for stage in records.ids())
            yield from _machines(records)
    yield from _models(ModelStore(folder))


@contextmanager
def _up_to_date(path: Path) -> Iterator[KeptRecords]:
    """Yields a database, or a copy of it in the present format if it has an older one.

    :raises ContentError: when it has a newer format.
    """
    records = KeptRecords(path)
    if records.format == FORMAT:
        yield records
        return
    with TemporaryDirectory() as folder:
        copy = Path(folder) / FILE_NAME
        records.copy(copy)
        opened(copy).close()
        yield KeptRecords(copy)


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


def _machines(records: KeptRecords) -> Iterator[Examined]:
    whole, damaged = records.versions(), records.damaged_versions()
    for machine in sorted({*whole, *damaged}):
        numbers = ", ".join(map(str, damaged.get(machine, ())))
        count = len(whole.get(machine, ()))
        facts = f"{count} version{'' if count == 1 else 's'}"
        yield Examined(f"machine {machine}", facts, f"version {numbers}" if numbers else "")


def _models(store: ModelStore) -> Iterator[Examined]:
    for name, upload in store.characters().items():
        data = store.model(upload.sha256).read_bytes()
        is_whole = hashlib.sha256(data).hexdigest() == upload.sha256
        yield Examined(
            f"character {name}", f"{len(data):,} bytes", "" if is_whole else "the model is damaged"
        )
