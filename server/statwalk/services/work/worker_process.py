"""The server's side of one worker (`worker`)."""

from __future__ import annotations

import subprocess
import time
from contextlib import suppress
from multiprocessing import Pipe

from statwalk.errors import BusyError, StatwalkError
from statwalk.services.cancel import CancelToken
from statwalk.services.work.limited_process import started
from statwalk.services.work.messages import CANCEL, Outcome

POLL_SECONDS = 0.1
"""the time between two looks at the token"""
CANCEL_SECONDS = 1.0
"""in which a worker ends a job that is cancelled; if it does not, it is killed"""


class WorkerProcess:
    """A worker and the socket to it; one thread at a time uses it.

    `is_free`: it has answered, and takes another job. `about`: what its last job was about.
    """

    def __init__(self) -> None:
        self._connection, theirs = Pipe()
        with theirs:
            self._process = started(
                "statwalk.services.work.worker",
                [str(theirs.fileno())],
                pass_fds=[theirs.fileno()],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                process_group=0,  # Ctrl-C in a terminal is for the server
            )
        self.about, self.is_free, self.free_since = "", True, time.monotonic()

    @property
    def pid(self) -> int:
        """The id of the process."""
        return self._process.pid

    @property
    def is_alive(self) -> bool:
        """Whether the process runs."""
        return self._process.poll() is None

    def do(self, message: bytes, token: CancelToken) -> Outcome:
        """Has the process do a job, and returns what became of it.

        :raises BusyError: when the process ends.
        :raises CancelledError: when the token is cancelled.
        :raises OverdueError: when the time of the token is over.
        """
        self.is_free = False
        try:
            self._connection.send_bytes(message)
            while not self._connection.poll(POLL_SECONDS):
                token.check()
            return self._received()
        except StatwalkError:
            self._cancel()
            raise
        except (EOFError, OSError):
            self.end()
            status = self._process.returncode
            raise BusyError(f"the process that did this work ended (status {status}); try again") from None

    def end(self) -> None:
        """Ends the process, whatever it does."""
        self._connection.close()
        self._process.kill()
        self._process.wait()

    def _received(self) -> Outcome:
        done: Outcome = self._connection.recv()
        self.is_free, self.free_since = not done.is_spent, time.monotonic()
        return done

    def _cancel(self) -> None:
        """Has the process end its job, and waits a moment for that."""
        with suppress(EOFError, OSError):
            self._connection.send_bytes(CANCEL)
            if self._connection.poll(CANCEL_SECONDS):
                self._received()
