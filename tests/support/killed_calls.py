"""Processes that are killed at a system call that changes the disk; what a start finds then."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from keeper import Plan, keep
from keeping import keeping, what_it_is
from promised import Promised, found_in
from statwalk.services.hosting.reopen import reopened
from statwalk.services.library.catalogue import Catalogue
from traced import Answer, traced

KILLED_AT = "pwrite64,fdatasync,fsync,ftruncate,unlink"
KILLED = -9


class Used(NamedTuple):
    """A folder with a database, and what was acknowledged of what is in it."""

    folder: Path
    answers: list[Answer]

    def copied(self, folder: Path) -> Used:
        """Returns a copy in a new folder."""
        return Used(shutil.copytree(self.folder, folder), self.answers)


def used(folder: Path) -> Used:
    """Keeps a few inputs in a folder, and ends in good order."""
    return Used(folder, traced(folder, keep, Plan(3, 1), "-o", "/dev/null").answers)


def killed_at(used: Used, call: int, plan: Plan) -> tuple[Promised, bool]:
    """Kills a process when one of its threads begins its nth such call. Returns what is acknowledged of the
    folder then, and whether the process was killed and not at its end before.

    The thread that opens a new database makes its first calls; of one that exists it makes a dozen, which
    write the lock and shared memory. All others are those of the thread that writes.
    """
    inject = f"inject={KILLED_AT}:signal=KILL:when={call}"
    done = traced(used.folder, keep, plan, "-o", "/dev/null", "-e", f"trace={KILLED_AT}", "-e", inject)
    promised = Promised()
    for answer in used.answers + done.answers:
        promised.add(answer)
    return promised, done.status == KILLED


def broken_after(folder: Path, promised: Promised) -> str:
    """Returns which promise a start breaks, or nothing: all is there, and each stage has the bits to which
    its log leads from the beginning.
    """
    if problem := promised.broken(found_in(folder)):
        return problem
    with keeping(folder, Catalogue()) as held:
        assert held.store is not None
        for name in promised.stages:
            host = held.stages.get(name)
            if host is None:
                return f"stage {name} is not brought back"
            record = replace(held.store.records.record(name), snapshots={})
            if reopened(record, held.catalogue).hash != what_it_is(host)["hash"]:
                return f"stage {name} is not what its log leads to"
    return ""
