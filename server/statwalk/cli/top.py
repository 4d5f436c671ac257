"""`statwalk top`: what a running server does, as a table that is drawn anew every second."""

from __future__ import annotations

import json
import time
from collections.abc import Iterable, Mapping
from http.client import HTTPConnection, HTTPException, HTTPSConnection
from typing import Annotated, Any, NamedTuple
from urllib.parse import urlsplit

import typer
from prometheus_client.parser import text_string_to_metric_families
from rich.console import Console, Group
from rich.live import Live
from rich.table import Table

EXAMPLES = """Examples:

  statwalk top

  statwalk top http://127.0.0.1:9000 --once
"""
PATIENCE_SECONDS = 10.0
LATE = "statwalk_tick_late_seconds_bucket"
console = Console(highlight=False)
errors = Console(stderr=True, highlight=False)
Samples = Mapping[tuple[str, tuple[str, ...]], float]
"""the value of each sample, by its name and the values of its labels in the order of the labels' names"""


class ServerLook(NamedTuple):
    """What a server said of itself at a time in seconds of the monotonic clock."""

    at: float
    samples: Samples
    stages: list[dict[str, Any]]


class Address(NamedTuple):
    """Where a server listens, and the token that it asks for; empty if it asks for none."""

    secure: bool
    host: str
    port: int | None
    token: str = ""

    def get(self, path: str) -> bytes:
        """Returns the body of an answer.

        :raises OSError: when the server cannot be reached, or refuses.
        """
        kind = HTTPSConnection if self.secure else HTTPConnection
        connection = kind(self.host, self.port, timeout=PATIENCE_SECONDS)
        try:
            headers = {"Authorization": f"Bearer {self.token}"} if self.token else {}
            connection.request("GET", path, headers=headers)
            answer = connection.getresponse()
            body = answer.read()
        except HTTPException as error:
            raise OSError(f"{self.host} does not answer as a server: {error!r}") from None
        finally:
            connection.close()
        if answer.status != 200:
            raise OSError(f"{path} answers {answer.status}")
        return body


def _address(url: str) -> Address:
    parts = urlsplit(url if "://" in url else f"http://{url}")
    try:
        host, port = parts.hostname, parts.port
    except ValueError:
        host = port = None
    if not host or parts.scheme not in ("http", "https"):
        raise typer.BadParameter(f"{url!r} is no address of a server; write one like http://127.0.0.1:8000")
    return Address(parts.scheme == "https", host, port)


def read_samples(text: str) -> Samples:
    """Returns the samples of a text in the format of Prometheus."""
    return {
        (sample.name, tuple(sample.labels[label] for label in sorted(sample.labels))): sample.value
        for family in text_string_to_metric_families(text)
        for sample in family.samples
    }


def look(address: Address) -> ServerLook:
    """Asks a server for its metrics and its stages.

    :raises OSError: when the server cannot be reached, or refuses.
    """
    samples = read_samples(address.get("/metrics").decode())
    return ServerLook(time.monotonic(), samples, json.loads(address.get("/api/stages")))


def late_quantile(samples: Samples, share: float) -> float:
    """Returns the upper bound, in seconds, of the bucket in which this share of all ticks is reached; 0
    without ticks.
    """
    buckets = sorted((float(labels[0]), count) for (name, labels), count in samples.items() if name == LATE)
    total = buckets[-1][1] if buckets else 0
    return next((bound for bound, count in buckets if total and count >= share * total), 0.0)


def _change(name: str, now: ServerLook, before: ServerLook | None) -> Samples:
    """Returns the samples of a counter since the look before; since the start if there was none."""
    old = before.samples if before else {}
    return {key: value - old.get(key, 0.0) for key, value in now.samples.items() if key[0] == name}


def _count(name: str, now: ServerLook, before: ServerLook | None) -> str:
    return f"{sum(_change(name, now, before).values()):g}"


def server_table(now: ServerLook, before: ServerLook | None) -> Table:
    """Returns what the server does as a whole: sums since the look before, or since its start."""
    held = {labels[0]: value for (name, labels), value in now.samples.items() if name == "statwalk_held"}
    late = _change(LATE, now, before)
    lateness = [f"{late_quantile(late, share) * 1e3:g}" for share in (0.5, 0.99)]
    frames = [_count(f"statwalk_frames_{what}_total", now, before) for what in ("sent", "skipped")]
    lines = {
        "stages, actors, viewers": f"{held['stages']:g}, {held['actors']:g}, {held['viewers']:g}",
        "ticks late, ms (half, 99 %)": ", ".join(lateness),
        "ticks left out": _count("statwalk_ticks_left_out_total", now, before),
        "frames sent, skipped": ", ".join(frames),
        "refused": _refused(_change("statwalk_refusals_total", now, before).items()),
    }
    table = Table(box=None, show_header=False)
    for name, value in lines.items():
        table.add_row(name, value)
    return table


def _refused(changes: Iterable[tuple[tuple[str, tuple[str, ...]], float]]) -> str:
    words = [
        f"{status}{f' ({limit})' if limit else ''}: {count:g}"
        for (_, (limit, status)), count in changes
        if count
    ]
    return ", ".join(words) or "none"


def stage_table(now: ServerLook, before: ServerLook | None) -> Table:
    """Returns a line for each stage; its ticks a second are those since the look before."""
    old = {stage["id"]: stage["head"] for stage in before.stages} if before else {}
    table = Table(box=None)
    for heading in ("stage", "clock", "tick", "ticks/s", "actors", "viewers"):
        table.add_column(heading, justify="left" if heading in ("stage", "clock") else "right")
    for stage in now.stages:
        rate = "-"
        if before and stage["id"] in old:
            rate = f"{(stage['head'] - old[stage['id']]) / (now.at - before.at):.1f}"
        clock = "paused" if stage["paused"] else stage["clock"]
        if stage["pace"] < 1:
            clock = f"slow, {stage['pace']:.0%}"
        numbers = (stage["tick"], rate, len(stage["actors"]), stage["viewers"])
        table.add_row(stage["id"], clock, *map(str, numbers))
    return table


def top(
    url: Annotated[str, typer.Argument(help="The server.")] = "http://127.0.0.1:8000",
    once: Annotated[bool, typer.Option("--once", help="Print the numbers since the start, and end.")] = False,
    token: Annotated[
        str,
        typer.Option(
            envvar="STATWALK_TOKEN", help="Your token, if the server asks for one.", show_default=False
        ),
    ] = "",
    seconds: Annotated[float, typer.Option(help="The time between two looks.", min=0.2, max=3600.0)] = 1.0,
) -> None:
    """Shows the stages of a running server, how late its ticks are, and what it refuses."""
    address = _address(url)._replace(token=token)
    before = look(address)
    if once:
        console.print(Group(server_table(before, None), stage_table(before, None)))
        return
    with Live(console=console, screen=True, auto_refresh=False) as live:
        while True:
            time.sleep(seconds)
            now = look(address)
            live.update(Group(server_table(now, before), stage_table(now, before)), refresh=True)
            before = now
