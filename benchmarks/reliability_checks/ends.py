"""R-14: a server with viewers, stalled ones among them, with inputs and an upload under way, ends in good
order, again and again.
"""

from __future__ import annotations

import argparse
import signal
import socket
import subprocess
import tempfile
import time
from collections.abc import Sequence
from contextlib import ExitStack

import httpx
from driving import driving
from load_process import LoadProcess, viewers_in_a_process
from processes import served
from stalled_viewers import stall

MAIN = "/api/stages/main"
STALLED = 5
INPUT_SECONDS = 0.01
END_SECONDS = 5.0
UPLOAD = (
    "PUT /api/characters/robot HTTP/1.1\r\nHost: localhost\r\nContent-Type: model/gltf-binary\r\n"
    "Content-Length: 1000\r\n\r\nglT"
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--runs", type=int, default=100)
    command.add_argument("--viewers", type=int, default=200)


def main(options: argparse.Namespace) -> bool:
    """Prints how each run ended, and returns whether all ended in good order."""
    faults = [fault for _ in range(options.runs) for fault in _run(options.viewers)]
    print(f"{options.runs} runs: {'; '.join(faults) or 'all ended in good order'}")
    return not faults


def _run(viewers: int) -> list[str]:
    """Starts a server with viewers and inputs, ends it, and starts it again; returns what went wrong."""
    with tempfile.TemporaryDirectory() as folder:
        with ExitStack() as opened:
            process, address = opened.enter_context(served("--data", folder))
            loads = [opened.enter_context(viewers_in_a_process(address, MAIN, viewers))]
            statuses = opened.enter_context(driving(address, MAIN, INPUT_SECONDS))
            faults = ended(process, address, loads)
        accepted = statuses.count(202)
        with served("--data", folder) as (_, address):
            kept = httpx.get(f"http://{address}{MAIN}/log").text.count('"event"')
    print(f"    {accepted} inputs accepted, {kept} in the log")
    return [*faults, *[f"{accepted} inputs accepted, {kept} kept"] * (kept < accepted)]


def ended(process: subprocess.Popen[str], address: str, loads: Sequence[LoadProcess]) -> list[str]:
    """Ends a server with its viewers, stalled ones and an upload under way; prints how, and returns what was
    not in good order.
    """
    host, port = address.split(":")
    with ExitStack() as opened:
        for _ in range(STALLED):
            opened.enter_context(stall(address, MAIN, "at the end"))
        upload = opened.enter_context(socket.create_connection((host, int(port))))
        upload.sendall(UPLOAD.encode())
        time.sleep(1)
        process.send_signal(signal.SIGTERM)
        asked = time.monotonic()
        readiness = httpx.get(f"http://{address}/readyz").status_code
        status = process.wait(timeout=30)
        seconds = time.monotonic() - asked
    codes = {one.code for load in loads for one in load.seen() if one.code}
    print(
        f"SIGTERM: /readyz {readiness}, gone after {seconds:.1f} s, exit code {status}, closed {codes}",
        flush=True,
    )
    in_order = (status, codes, readiness) == (0, {1012}, 503) and seconds <= END_SECONDS
    return [] if in_order else ["the server did not end in good order"]
