"""A client that sends events while something else is measured."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager

import httpx
from serving import PATIENCE


@contextmanager
def driving(address: str, stage: str, each: float) -> Iterator[list[int]]:
    """Posts an event to a stage (`/api/stages/ID`) every `each` seconds while the context is open; yields the
    statuses of the answers.
    """
    statuses: list[int] = []
    leaving = threading.Event()

    def post() -> None:
        with httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
            while not leaving.wait(each):
                event = "STOP" if len(statuses) % 2 else "FORWARD"
                try:
                    statuses.append(rest.post(f"{stage}/events", json={"event": event}).status_code)
                except httpx.TransportError:  # the server has ended
                    return

    thread = threading.Thread(target=post)
    thread.start()
    try:
        yield statuses
    finally:
        leaving.set()
        thread.join()
