"""The most that one server holds and does; docs/limits.md has them all in one table."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields, replace

from statwalk.errors import ContentError, existing

MOST_ACTORS = 2_000
"""the most actors on one stage, unless you choose fewer"""
MOST_TICKS = 36_000
"""the most ticks in one `step`"""
MOST_UPLOADS = 200
BURST_SECONDS = 2.0
"""a rate may be exceeded until what came is as much as in this time"""


@dataclass(frozen=True)
class Limits:
    """The limits that you choose when you start a server. An address is one of IPv4, or 64 bits of IPv6."""

    stages: int = 64
    actors: int = MOST_ACTORS
    """on one stage"""
    viewers: int = 256
    """of one stage"""
    entries: int = 100_000
    """in the log of one stage; the oldest are forgotten"""
    tick_entries: int = 20_000
    """that come to one stage between two ticks"""
    tick_share: float = 0.8
    """of the time of the thread that steps the stages; 1 is all of it"""
    rest_seconds: float = 30.0
    """until a real-time stage without viewers and requests falls asleep"""
    idle_seconds: float = 600.0
    """until a stage without viewers and requests is closed"""
    requests: float = 600.0
    """a second from one address"""
    stage_requests: float = 1_200.0
    """a second about one stage"""
    inputs: float = 1_000.0
    """events, parameters and travels a second from one address, over REST and sockets"""
    stage_inputs: float = 2_000.0
    """the same to one stage"""
    work_seconds: float = 60.0
    """of one long request, from when it runs"""
    connections: int = 512
    """from one address; an idle one makes room for a new one"""
    header_seconds: float = 10.0
    """from the first moment of a connection, or of its next request, to the end of the header"""
    body_rate: float = 1_024.0
    """bytes a second that a body must bring"""
    cooling_seconds: float = 10.0
    """for which an address opens no socket after one was closed because of too many messages"""


def chosen(words: Iterable[str]) -> Limits:
    """Returns the limits, with the values that words like `stages=8` choose.

    :raises UnknownNameError: when no limit has the name.
    :raises ContentError: when a value is no positive number, or more actors than a stage may have.
    """
    defaults = Limits()
    known = {field.name: type(getattr(defaults, field.name)) for field in fields(Limits)}
    values = {}
    for word in words:
        name, _, text = word.partition("=")
        kind = existing("limit", name, known)
        try:
            value = kind(text)
        except ValueError:
            value = 0
        if not 0 < value < float("inf") or (name == "actors" and value > MOST_ACTORS):
            most = f", at most {MOST_ACTORS}" if name == "actors" else ""
            raise ContentError(
                f"write a positive number{most}, as in {name}={known[name](getattr(defaults, name))}",
                place=name,
            )
        values[name] = value
    return replace(defaults, **values)
