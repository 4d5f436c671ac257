"""Says how long an unused stage is kept, and which one a new stage replaces when the server is full."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

from statwalk.errors import BusyError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.limits import Limits

MANUAL_PATIENCE = 6
"""how many times longer an idle stage is kept if its clock is manual"""
UNCLAIMED_PATIENCE = 0.1
"""the part of `idle_seconds` for which an unclaimed fork is kept"""


def patience(host: StageHost, limits: Limits, *, is_stored: bool) -> float:
    """Returns the seconds without viewers and requests after which a stage is closed. They are infinite for a
    stage that stays awake, and in a data folder (`is_stored`) for every stage but unclaimed forks.
    """
    if host.is_unclaimed:
        return limits.idle_seconds * UNCLAIMED_PATIENCE
    if is_stored or host.identity.stays_awake:
        return float("inf")
    return limits.idle_seconds * (MANUAL_PATIENCE if host.clock_kind == "manual" else 1)


def replaceable(hosts: Sequence[StageHost], limits: Limits, now: float) -> StageHost | None:
    """Returns the stage that a new stage may replace; None if no stage is replaceable.

    A replaceable stage is unused, and is as it was opened: it has no input but its first actors, no name and
    no fork, and is no fork itself. So opening the same again makes the same stage. Unused means: a real-time
    stage sleeps, and a stage with a manual clock has been idle for as long as it is kept without a data
    folder. Of several stages the one that has been idle for longest is returned.

    `now`: seconds of the server's clock.
    """
    origins = {host.identity.origin.stage for host in hosts if host.identity.origin}
    for host in sorted(hosts, key=lambda host: -host.idle_for(now)):
        least = limits.rest_seconds if host.identity.may_sleep else patience(host, limits, is_stored=False)
        if host.idle_for(now) > least and host.id not in origins and _is_as_opened(host):
            return host
    return None


def _is_as_opened(host: StageHost) -> bool:
    """Whether the stage has no name, is no fork, and has no input but its first actors."""
    with suppress(BusyError):
        facts = host.look(ask.Describe())
        place, newest = facts.place, facts.place.newest_input
        is_new = not place.name and place.origin is None and (newest is None or newest.tick == 0)
        return is_new and place.inputs == len(facts.actors)
    return False
