"""Work that keeps stages and machines in a folder, and says of each change when it was acknowledged."""

import os
import random
import sqlite3
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from keeping import keeping
from killed import CATALOGUE, EVENTS
from statwalk.errors import StorageError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_replies import Posted
from statwalk.services.hosting.store import writer
from statwalk.services.hosting.store.kept_log import KeptLog
from system_calls import WRITING
from traced import CHANGES, Answer, traced

MACHINE = "elbow"
MOST_STAGES = 3
WAIT_SECONDS = 0.02
"""until a client and the writer try again"""
STEPS = 1, 5, 90
OTHERS: Sequence[tuple[str, int]] = (("step", 24), ("save", 8), ("open", 6), ("delete", 4), ("edit", 2))
"""what is done besides inputs, and how often in a hundred"""


class Plan(NamedTuple):
    """What a process does: `inputs` inputs, and other changes as the seed has it.

    `weakness`: "" is the product; `NORMAL` and `OFF` are modes of SQLite that promise less; `before` answers
    before the disk has the input; `deaf` does not hear what the disk refuses.
    """

    inputs: int
    seed: int
    closes: bool = True
    weakness: str = ""


class _Weaker(sqlite3.Connection):
    """Flushes less than it was told to, from its first commit on."""

    mode = ""

    def execute(self, sql: str, *values: Any) -> sqlite3.Cursor:
        if sql.startswith("BEGIN"):
            super().execute(f"PRAGMA synchronous={self.mode}")
        return super().execute(sql, *values)


class _Deaf(sqlite3.Connection):
    """Takes each error of the disk for a success."""

    def execute(self, sql: str, *values: Any) -> sqlite3.Cursor:
        try:
            return super().execute(sql, *values)
        except sqlite3.OperationalError:
            return super().execute("SELECT 0")


def keep(folder: Path, plan: Plan, answer: Callable[[Answer], None]) -> None:
    """Does what the plan says, and answers as the product does; without `closes` it ends like a crash."""
    if plan.weakness == "before":
        KeptLog.durable = lambda *_: True  # type: ignore[method-assign]
    elif plan.weakness == "deaf":
        sqlite3.connect = partial(sqlite3.connect, factory=_Deaf)  # type: ignore[assignment]
    elif plan.weakness:
        _Weaker.mode = plan.weakness
        sqlite3.connect = partial(sqlite3.connect, factory=_Weaker)  # type: ignore[assignment]
    writer.RETRY_SECONDS = WAIT_SECONDS
    with keeping(folder, CATALOGUE) as held:
        keeper = Keeper(held, answer, plan.seed)
        keeper.work(plan.inputs)
        if not plan.closes:
            os._exit(0)


class Keeper:
    """Changes stages and machines at random, one change at a time."""

    def __init__(self, held: Registry, answer: Callable[[Answer], None], seed: int) -> None:
        self.held, self.answer, self.random, self.posts = held, answer, random.Random(seed), 0
        self.name = f"{seed}"

    def work(self, inputs: int) -> None:
        """Does other changes between its inputs."""
        others = [name for name, times in OTHERS for _ in range(times)]
        while self.posts < inputs:
            number = self.random.randrange(100)
            change = others[number] if number < len(others) else "post"
            try:
                getattr(self, change)()
            except StorageError as error:
                self.answer({"disk": str(error)})

    def stage(self) -> StageHost:
        """Returns one of the stages; opens one if there is none."""
        if not self.held.stages:
            self.open()
        return self.random.choice(self.held.all())

    def post(self) -> None:
        """Sends an event, mostly with a key."""
        host, self.posts = self.stage(), self.posts + 1
        key = f"{self.name}/{self.posts}" if self.posts % 4 else ""
        post = ask.Post((SendEvent(EVENTS[self.posts % 2], 1),), key=key)
        while (posted := self.posted(host, post)) is None:
            self.answer({"stage": host.id, "refused": key})
        self.answer({"stage": host.id, "input": posted.seq, "key": key})

    def posted(self, host: StageHost, post: ask.Post) -> Posted | None:
        """Posts; returns None when the disk refuses, and it can be tried again."""
        try:
            return host.handle(post)
        except StorageError:
            time.sleep(WAIT_SECONDS)  # as a client does that tries again
            return None

    def step(self) -> None:
        """Steps a stage; with the longest steps it comes to a snapshot."""
        host = self.stage()
        status = host.handle(ask.Step(self.random.choice(STEPS)))
        self.answer({"stage": host.id, "tick": status.tick})

    def save(self) -> None:
        """Writes the places of the stages down, as the server does from time to time; nobody is answered."""
        self.held.save()

    def open(self) -> None:
        """Opens a stage, if there may be one more."""
        if len(self.held.stages) < MOST_STAGES:
            host = self.held.open(StageSetup(clock="manual", actors=(AddActor(MACHINE),)))
            self.answer({"stage": host.id, "is": "open"})

    def delete(self) -> None:
        """Deletes a stage; from the question on it may be gone, and from the answer on it is."""
        host = self.stage()
        self.answer({"stage": host.id, "is": "going"})
        self.held.close(host.id)
        self.answer({"stage": host.id, "is": "gone"})

    def edit(self) -> None:
        """Makes a new version of the machine, which is shipped: no file is written."""
        current = self.held.versions.current(MACHINE)
        text = f"{current.version.text}# {self.posts}\n"
        edited = self.held.versions.change(current, text, "a comment", write=False)
        self.answer({"machine": MACHINE, "version": edited.version.number})


def recorded(folder: Path, rounds: int, plan: Plan) -> list[Path]:
    """Keeps stages in `folder`/data, in processes that follow each other, each of which does the plan;
    returns their traces. All but the last end like a crash and in good order by turns.
    """
    traces = []
    for number in range(rounds):
        trace = folder / f"trace {number}"
        this = plan._replace(seed=plan.seed * 1_000 + number, closes=bool(number % 2) or number == rounds - 1)
        done = traced(folder / "data", keep, this, *WRITING, "-e", f"trace={CHANGES}", "-o", str(trace))
        assert done.status == 0, done
        traces.append(trace)
    return traces
