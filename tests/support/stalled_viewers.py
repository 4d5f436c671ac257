"""Viewers that stop reading: silent ones, and ones that acknowledge without reading.

The server's log says how long it let each stay, and why it went.
"""

from __future__ import annotations

import json
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

import httpx
from raw_viewers import ACK, TEXT, masked, upgrade

STAY_SECONDS = 8.0
"""until a stalled viewer goes, and another one comes"""
BUFFER_BYTES = 4096
BEFORE = 60
"""ticks that have passed until it begins"""
UNSENT = 4
"""ticks whose frames may not be sent yet: to acknowledge them would count for nothing"""


class Cut(NamedTuple):
    """The end of a stalled viewer's connection, as the server's log has it."""

    seconds: float
    code: int
    limit: str


def stall(address: str, stage: str, name: str) -> socket.socket:
    """Opens a stream that nobody will read; `name` is its id in the server's log."""
    host, port = address.split(":")
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER_BYTES)
    client.connect((host, int(port)))
    client.sendall(upgrade(address, f"{stage}/stream", f"X-Request-ID: {name}\r\n"))
    assert b"101" in client.recv(16)
    return client


def acknowledge_all(
    client: socket.socket, address: str, stage: str, until: float, leaving: threading.Event
) -> None:
    """Acknowledges the frames of a stage as they are sent, without having read them."""
    with httpx.Client(base_url=f"http://{address}", timeout=60) as rest:
        told = rest.get(stage).json()["head"] - BEFORE
        while time.monotonic() < until and not leaving.wait(0.05):
            sent = rest.get(stage).json()["head"] - UNSENT
            try:
                client.sendall(b"".join(masked(TEXT, ACK % tick) for tick in range(told, sent)))
            except OSError:
                return
            told = sent


def _stay(address: str, stage: str, name: str, lies: bool, seconds: float, leaving: threading.Event) -> None:
    while not leaving.is_set():
        until = time.monotonic() + seconds
        with stall(address, stage, name) as client:
            if lies:
                acknowledge_all(client, address, stage, until, leaving)
            leaving.wait(until - time.monotonic())


@contextmanager
def stalled(
    count: int, address: str, stage: str, *, lies: bool = False, seconds: float = STAY_SECONDS
) -> Iterator[str]:
    """So many stalled viewers while the context is open, each replaced after so many seconds; yields their
    name in the server's log. `lies`: they acknowledge.
    """
    name, leaving = ("lying" if lies else "silent"), threading.Event()
    ask = address, stage, name, lies, seconds, leaving
    threads = [threading.Thread(target=_stay, args=ask) for _ in range(count)]
    for thread in threads:
        thread.start()
    try:
        yield name
    finally:
        leaving.set()
        for thread in threads:
            thread.join(timeout=10)


def cuts(log: Path, name: str) -> list[Cut]:
    """How the connections of the stalled viewers of a name ended so far (`serve --log json`)."""
    whole_lines, _, _ = log.read_text().rpartition("\n")  # the server may be writing one
    rows = [json.loads(line) for line in whole_lines.splitlines() if line.startswith("{")]
    return [
        Cut(row["milliseconds"] / 1000, row["closed"], row["limit"])
        for row in rows
        if row.get("request") == name and "milliseconds" in row
    ]
