"""A few worker processes for long work: it must not hold the interpreter of the threads that step the stages.

A worker starts when it is needed first, keeps the machines that it has loaded, and ends after IDLE_SECONDS
without a job.
"""

from __future__ import annotations

import os
import pickle
import threading
from collections.abc import Callable
from io import BytesIO
from typing import Any

from statwalk.errors import CancelledError
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.work.job import Answer, Job
from statwalk.services.work.messages import StandIn
from statwalk.services.work.worker_process import WorkerProcess

MOST_WORKERS = max(1, min(4, os.cpu_count() or 1))
IDLE_SECONDS = 300.0
"""without a job, after which a worker ends"""
WAIT_SECONDS = 0.1
"""the time between two looks at the token while all workers are busy"""
ReferenceTo = Callable[[Any], StandIn | None]
"""returns what stands for an argument in a message; None: the argument itself is sent"""


class Workers:
    """The workers of a server, at most `most`. Thread-safe."""

    def __init__(self, reference_to: ReferenceTo, most: int = MOST_WORKERS) -> None:
        self._reference_to, self._most = reference_to, most
        self._changed, self._is_closed = threading.Condition(), False
        self._free: list[WorkerProcess] = []
        """the one that was used last comes last"""
        self._busy: list[WorkerProcess] = []

    def do(self, about: str, job: Job[Answer], *arguments: Any, token: CancelToken = NEVER) -> Answer:
        """Has a worker do a job (`DoJob`), as soon as one is free.

        :raises BusyError: when the worker ends before it has answered.
        :raises CancelledError: when the token is cancelled, or the workers are closed.
        :raises OverdueError: when the time of the token is over.
        """
        message = _message((job, arguments), self._reference_to)
        worker = self._taken(about, token)
        try:
            done = worker.do(message, token)
        finally:
            self._give_back(worker)
        if done.error:
            raise done.error
        answer: Answer = done.answer
        return answer

    @property
    def processes(self) -> list[int]:
        """The ids of the processes."""
        with self._changed:
            return [worker.pid for worker in (*self._free, *self._busy)]

    def end_idle(self, now: float) -> None:
        """Ends the workers that had no job for IDLE_SECONDS; `now`: seconds of `time.monotonic`."""
        with self._changed:
            idle = [worker for worker in self._free if now - worker.free_since > IDLE_SECONDS]
            self._free = [worker for worker in self._free if worker not in idle]
        for worker in idle:
            worker.end()

    def close(self) -> None:
        """Ends the workers; those at work end as soon as their jobs are cancelled."""
        with self._changed:
            self._is_closed, free, self._free = True, self._free, []
        for worker in free:
            worker.end()

    def _taken(self, about: str, token: CancelToken) -> WorkerProcess:
        """Returns a worker that no other thread has, if possible one that has loaded the machine `about`."""
        with self._changed:
            while not (self._free or len(self._busy) < self._most):
                self._changed.wait(WAIT_SECONDS)
                token.check()
            if self._is_closed:
                raise CancelledError("the work is cancelled: the server stops")
            self._busy.append(chosen := self._free_worker(about) or WorkerProcess())
            chosen.about = about
            return chosen

    def _free_worker(self, about: str) -> WorkerProcess | None:
        """Takes a free worker: the one whose last job was about the same machine, else the one used last;
        removes workers whose process has ended.
        """
        for worker in [worker for worker in self._free if not worker.is_alive]:
            self._free.remove(worker)
            worker.end()
        if not self._free:
            return None
        chosen = max(self._free, key=lambda worker: (worker.about == about, worker.free_since))
        self._free.remove(chosen)
        return chosen

    def _give_back(self, worker: WorkerProcess) -> None:
        with self._changed:
            self._busy.remove(worker)
            is_kept = worker.is_free and not self._is_closed
            if is_kept:
                self._free.append(worker)
            self._changed.notify()
        if not is_kept:
            worker.end()


def _message(content: object, reference_to: ReferenceTo) -> bytes:
    class Pickler(pickle.Pickler):
        def persistent_id(self, value: Any) -> StandIn | None:
            return reference_to(value)

    buffer = BytesIO()
    Pickler(buffer, pickle.HIGHEST_PROTOCOL).dump(content)
    return buffer.getvalue()
