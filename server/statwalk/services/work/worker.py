"""A worker: a process that does one job after the other for the server that started it.

`python -m statwalk.services.work.worker DESCRIPTOR` reads jobs from a socket and writes what became of them.
It ends when the server does, however the server ends.
"""

from __future__ import annotations

import logging
import os
import pickle
import signal
import sys
import threading
from collections.abc import Callable
from io import BytesIO
from multiprocessing.connection import Connection
from queue import SimpleQueue
from typing import Any

from statwalk.errors import CancelledError, LimitError, StatwalkError
from statwalk.services.work.limited_process import limit_self, run_last
from statwalk.services.work.messages import CANCEL, Outcome, StandIn

MOST_MEMORY = 2 << 30
FILE_BYTES = 1 << 28
log = logging.getLogger(__name__)


class _Jobs(pickle.Unpickler):
    def persistent_load(self, pid: StandIn) -> Any:
        return pid.load(*pid.arguments)


class JobInbox:
    """The jobs that the server sends, read by a thread of its own: it notices at once when the server
    cancels a job, or ends.
    """

    def __init__(self, connection: Connection) -> None:
        self._connection, self._cancelled = connection, threading.Event()
        self.jobs: SimpleQueue[bytes] = SimpleQueue()
        threading.Thread(target=self._read, name="inbox", daemon=True).start()

    def check(self) -> None:
        """:raises CancelledError: when the server has cancelled the job."""
        if self._cancelled.is_set():
            raise CancelledError("the work is cancelled")

    def _read(self) -> None:
        try:
            while True:
                message = self._connection.recv_bytes()
                if message == CANCEL:
                    self._cancelled.set()
                else:
                    self._cancelled.clear()
                    self.jobs.put(message)
        finally:
            os._exit(0)  # the server has ended and closed the socket: nobody waits for an answer


def outcome(message: bytes, checkpoint: Callable[[], None]) -> Outcome:
    """Does a job, and returns what became of it."""
    try:
        job, arguments = _Jobs(BytesIO(message)).load()
        run_last()  # not before: who waits for the first job waits for all modules, too
        return Outcome(job(*arguments, checkpoint))
    except StatwalkError as error:
        return Outcome(error=error)
    except MemoryError:
        return Outcome(error=LimitError(TOO_MUCH, limit="memory of long work"), is_spent=True)
    except Exception as error:
        log.exception("a job failed")
        return Outcome(error=RuntimeError(f"{type(error).__name__} in a worker: {error}"))


TOO_MUCH = f"the work takes more than {MOST_MEMORY >> 20} MiB of memory: ask for less at once"


def main(descriptor: str) -> None:
    """Runs the worker."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # of a terminal; the server decides when its workers end
    limit_self(MOST_MEMORY, FILE_BYTES)
    connection = Connection(int(descriptor))
    inbox = JobInbox(connection)
    while True:
        done = outcome(inbox.jobs.get(), inbox.check)
        connection.send(done)


if __name__ == "__main__":
    main(*sys.argv[1:])
