"""A stage that lives long under a rain of inputs, kept in a folder, without a server."""

import random
import sqlite3
import time
from collections.abc import Iterator
from contextlib import closing, nullcontext
from pathlib import Path
from typing import NamedTuple
from unittest.mock import patch

from keeping import keeping, what_it_is
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.services.hosting.store.kept_stage import KeptStage
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits

EVENTS = [SendEvent(name, 1) for name in ("FORWARD", "STOP", "LEFT", "RIGHT", "JUMP")]
SAVE_TICKS = 60
"""as a server saves once a second"""
LOOK_TICKS = 1_000


class Life(NamedTuple):
    """A stage to be lived: an input about `every` ticks, at most `entries` in its log; `forgets` on the disk,
    unless it is the control.
    """

    ticks: int
    every: int
    entries: int
    forgets: bool = True


class Sample(NamedTuple):
    """What there is at a tick: inputs so far, inputs in the log, the first tick, bytes on the disk, and the
    slowest input since the last sample in seconds.
    """

    tick: int
    inputs: int
    held: int
    first: int
    disk: int
    slowest: float


class Restart(NamedTuple):
    """How long a start took that brought the stage back, whether the stage is what it was, and the slowest of
    ten seeks into its past.
    """

    seconds: float
    is_the_same: bool
    slowest_seek: float


def lived(folder: Path, life: Life) -> Iterator[Sample | Restart]:
    """Lives a life; yields a sample every thousand ticks, and at last how the stage came back."""
    catalogue = Catalogue()
    control = patch.object(KeptStage, "forget", lambda *_: None)
    limits = Limits(entries=life.entries)
    with nullcontext() if life.forgets else control, keeping(folder, catalogue, limits) as held:
        host = held.open(StageSetup(clock="manual", actors=(AddActor("faq-walker"),)))
        yield from _samples(folder, life, held, host)
        before = what_it_is(host)
    began = time.perf_counter()
    with keeping(folder, catalogue, limits) as held:
        seconds = time.perf_counter() - began
        host = held.find(host.id)
        yield Restart(seconds, what_it_is(host) == before, max(_seeks(host)))


def _seeks(host: StageHost) -> Iterator[float]:
    """Seconds that seeks take to ticks all over the past."""
    status, dice = host.handle(ask.Status()), random.Random(7)
    for _ in range(10):
        tick = dice.randint(status.first, status.head)
        began = time.perf_counter()
        host.handle(ask.Seek(tick))
        yield time.perf_counter() - began


def _samples(folder: Path, life: Life, held: Registry, host: StageHost) -> Iterator[Sample]:
    dice, live, inputs, slowest = random.Random(7), host._live, 0, 0.0
    for tick in range(1, life.ticks + 1):
        if dice.randrange(life.every) == 0:
            began = time.perf_counter()
            live.apply(ask.Post((dice.choice(EVENTS),)), {})  # nobody waits for the disk
            slowest, inputs = max(slowest, time.perf_counter() - began), inputs + 1
        live.tick()
        if tick % SAVE_TICKS == 0:
            held.save()
        if tick % LOOK_TICKS == 0:
            held.flush()
            yield Sample(tick, inputs, live.stage.held, live.stage.first, _disk(folder), slowest)
            slowest = 0.0


def _disk(folder: Path) -> int:
    """Bytes in a folder once SQLite's log is written into the database: how full the log is by itself depends
    on how many writes went into one commit, and so on the machine's pace.
    """
    with closing(sqlite3.connect(folder / FILE_NAME)) as database:
        database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    return sum(path.stat().st_size for path in folder.iterdir())
