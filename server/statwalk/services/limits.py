"""The most that one server holds: stages, actors, viewers, uploads; and how long it keeps an idle stage."""

from __future__ import annotations

from dataclasses import dataclass

MOST_STAGES = 64
MOST_ACTORS = 2_000
"""the most actors on one stage"""
MOST_TICKS = 36_000
"""the most ticks in one `step`"""
MOST_VIEWERS = 256
"""the most viewers of one stage"""
MOST_UPLOADS = 200
IDLE_SECONDS = 600.0


@dataclass(frozen=True)
class Limits:
    """The limits that you choose when you start a server."""

    stages: int = MOST_STAGES
    actors: int = MOST_ACTORS
    idle_seconds: float = IDLE_SECONDS
