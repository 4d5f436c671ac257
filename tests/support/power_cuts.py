"""What a store acknowledged must be there after each power cut that the trace of a run allows."""

from __future__ import annotations

import json
import random
import struct
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from disk_model import Cut, Disk
from promised import Kept, Promised, found_in
from system_calls import Call
from traced import Answer

MEMORY = Path("/dev/shm")
"""a folder in memory, where there is one: to be fast"""
CHUNK = 64
"""boundaries that follow each other, for one worker"""
MOST_KNOWN = 3_000
HEADER = struct.Struct("!i")


def answers_of(call: Call) -> Iterator[Answer]:
    """Yields the answers that a write to a pipe holds, each behind its length; other lines are a log's."""
    rest = call.data
    while call.path.startswith("pipe:") and rest[HEADER.size :].startswith(b"{"):
        (length,) = HEADER.unpack_from(rest)
        yield json.loads(rest[HEADER.size : HEADER.size + length])
        rest = rest[HEADER.size + length :]


@dataclass
class Counts:
    """How many states were looked at; `opened`: those that differ. `broken`: where and why."""

    states: int = 0
    opened: int = 0
    boundaries: int = 0
    inputs: int = 0
    broken: list[str] = field(default_factory=list)

    def add(self, other: Counts) -> None:
        """Adds the counts of other boundaries of the same run."""
        self.states, self.opened = self.states + other.states, self.opened + other.opened
        self.boundaries += other.boundaries
        self.inputs = max(self.inputs, other.inputs)
        self.broken += other.broken


class Sample(NamedTuple):
    """Which states are looked at: what is sure at each boundary, and at each `every`th `draws` at random.

    Of `workers` that share the work this is the one of number `worker`.
    """

    seed: int
    draws: int
    every: int = 1
    workers: int = 1
    worker: int = 0

    def draws_at(self, boundary: int) -> int:
        """Returns the number of states at a boundary."""
        if boundary // CHUNK % self.workers != self.worker:
            return 0
        return 1 if boundary % self.every else 1 + self.draws


class Before(NamedTuple):
    """What was in the folder before the run, and what was acknowledged of it."""

    files: Mapping[str, bytes] = {}
    answers: Sequence[Answer] = ()


EMPTY = Before()


def check(run: Iterable[Call], folder: Path, sample: Sample, before: Before = EMPTY) -> Counts:
    """Cuts the power after each call of a run: with only what is sure, and then with parts of the rest."""
    disk, promised, counts = Disk(folder, before.files), Promised(), Counts()
    for answer in before.answers:
        promised.add(answer)
    known: dict[tuple[object, ...], Kept] = {}
    with tempfile.TemporaryDirectory(dir=MEMORY if MEMORY.is_dir() else None) as name:
        for boundary, call in enumerate(run):
            disk.does(call)
            for answer in answers_of(call):
                promised.add(answer)
            states = sample.draws_at(boundary)
            counts.boundaries += bool(states)
            for draw in range(min(states, 1) if disk.is_sure else states):
                cut = disk.cut(random.Random(f"{sample.seed}/{boundary}/{draw}") if draw else None)
                counts.states += 1
                if cut.name not in known:
                    counts.opened += 1
                    if len(known) > MOST_KNOWN:
                        known.clear()
                    known[cut.name] = found_in(_made(cut, Path(name)))
                if problem := promised.broken(known[cut.name]):
                    counts.broken.append(f"boundary {boundary}, draw {draw}: {problem}")
    counts.inputs = promised.inputs
    return counts


def _made(cut: Cut, folder: Path) -> Path:
    for old in folder.iterdir():
        old.unlink()
    for name, content in cut.files().items():
        (folder / name).write_bytes(content)
    return folder
