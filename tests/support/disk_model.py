"""A model of a disk: what of the files is sure to be there after a power cut, and what may be.

- What a file was told is sure once a flush of the file that began later has ended.
- Of what was told since, each write may be there, missing, or torn: some of its sectors, in any order. A size
  that was set may count or not; where a write is missing before one that is there, the file has zeros.
- Files are made, and deleted, in the order in which they were; this is sure once a flush of the folder that
  began later has ended, and until then any number of the first may have happened.
- A flush that fails flushes nothing, and what waited for it is never written any more, as on Linux: the
  process reads what the disk will not have.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from system_calls import Call

SECTOR_BYTES = 512
Masks = tuple[tuple[int, int], ...]
"""each write that is there, by its order, with a bit for each of its sectors"""
NOT_ON_THE_DISK = "-shm"
"""the end of the name of the file that SQLite shares in memory, and makes again"""


class _Told(NamedTuple):
    """A write, or a new size (`data` is None)."""

    order: int
    place: int
    data: bytes | None

    def sectors(self) -> int:
        """The number of sectors that it touches; 1 for a new size."""
        if not self.data:
            return 1
        return (self.place + len(self.data) - 1) // SECTOR_BYTES - self.place // SECTOR_BYTES + 1


@dataclass
class _File:
    sure: bytearray = field(default_factory=bytearray)
    told: list[_Told] = field(default_factory=list)
    number: int = field(default_factory=itertools.count().__next__)
    version: int = 0
    """rises when what is sure changes"""


class Cut(NamedTuple):
    """What a power cut leaves, until the disk is told more. Cuts of the same content have the same `name`."""

    name: tuple[object, ...]
    parts: dict[str, tuple[_File, Masks]]

    def files(self) -> dict[str, bytes]:
        """Returns the content of each file."""
        return {name: _content(*part) for name, part in self.parts.items()}


class Disk:
    """The files of one folder, with what was in them before."""

    def __init__(self, folder: Path, before: Mapping[str, bytes]) -> None:
        self.folder = str(folder)
        self._now = {name: _File(bytearray(content)) for name, content in before.items()}
        self._sure = dict(self._now)
        self._moves: list[tuple[int, str, _File | None]] = []

    def does(self, call: Call) -> None:
        """Follows a call; one of another folder changes nothing."""
        if call.path == self.folder and call.kind == "flush" and not call.failed:
            self._settle(sum(order < call.begun for order, *_ in self._moves))
        folder, _, name = call.path.rpartition("/")
        if folder != self.folder or name.endswith(NOT_ON_THE_DISK):
            return
        if call.kind == "flush":
            self._flush(self._now[name], call)
        elif call.failed:
            return
        elif call.kind == "make":
            if name not in self._now:
                self._move(call.order, name, _File())
        elif call.kind == "unlink":
            self._move(call.order, name, None)
        else:
            assert call.kind in ("write", "truncate"), call.kind
            data = call.data if call.kind == "write" else None
            self._now[name].told.append(_Told(call.order, call.place, data))

    def _move(self, order: int, name: str, file: _File | None) -> None:
        _put(self._now, name, file)
        self._moves.append((order, name, file))

    def _settle(self, moves: int) -> None:
        for _, name, file in self._moves[:moves]:
            _put(self._sure, name, file)
        del self._moves[:moves]

    def _flush(self, file: _File, call: Call) -> None:
        covered = [told for told in file.told if told.order < call.begun]
        file.told = [told for told in file.told if told.order >= call.begun]
        if covered and not call.failed:
            for told in covered:
                _apply(file.sure, told, (1 << told.sectors()) - 1)
            file.version += 1

    @property
    def is_sure(self) -> bool:
        """Whether a power cut can leave only one state."""
        return not self._moves and not any(file.told for file in self._now.values())

    def cut(self, rng: random.Random | None = None) -> Cut:
        """Returns what a power cut leaves: only what is sure, or with a part of the rest at random."""
        folder, moves = dict(self._sure), rng.randint(0, len(self._moves)) if rng else 0
        for _, name, file in self._moves[:moves]:
            _put(folder, name, file)
        parts = {
            name: (file, _chosen(file.told, rng) if rng else ()) for name, file in sorted(folder.items())
        }
        known = ((name, file.number, file.version, masks) for name, (file, masks) in parts.items())
        return Cut(tuple(known), parts)


def _put(folder: dict[str, _File], name: str, file: _File | None) -> None:
    if file is None:
        folder.pop(name, None)
    else:
        folder[name] = file


def _chosen(told: list[_Told], rng: random.Random) -> Masks:
    """Draws what is there of what was told.

    Half of the draws are the first writes, of which the last is torn; the others are any.
    """
    most, likely = rng.randint(0, len(told)), rng.choice((0.2, 0.5, 0.8))
    is_prefix, chosen = rng.random() < 0.5, []
    for index, each in enumerate(told):
        whole = (1 << each.sectors()) - 1
        torn = rng.randint(0, whole)
        if is_prefix:
            mask = whole if index < most else torn if index == most else 0
        else:
            mask = 0 if rng.random() > likely else whole if rng.random() < 0.7 else torn
        if mask:
            chosen.append((each.order, mask))
    return tuple(chosen)


def _content(file: _File, masks: Masks) -> bytes:
    if not masks:
        return bytes(file.sure)
    content, chosen = bytearray(file.sure), dict(masks)
    for told in file.told:
        if mask := chosen.get(told.order):
            _apply(content, told, mask)
    return bytes(content)


def _apply(content: bytearray, told: _Told, mask: int) -> None:
    """Writes the sectors whose bits are set, or sets the size."""
    if told.data is None:
        del content[told.place :]
        content.extend(bytes(told.place - len(content)))
        return
    end = told.place + len(told.data)
    first = told.place // SECTOR_BYTES
    for bit in range(told.sectors()):
        if mask >> bit & 1:
            start = max(told.place, (first + bit) * SECTOR_BYTES)
            stop = min(end, (first + bit + 1) * SECTOR_BYTES)
            content.extend(bytes(max(0, stop - len(content))))
            content[start:stop] = told.data[start - told.place : stop - told.place]
