"""How long stages are kept that nobody uses, and which one makes room when the server is full."""

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
    """Returns the seconds without viewers and requests after which a stage is closed; infinite for one that
    stays awake, and in a data folder (`is_stored`) for all but unclaimed forks.
    """
    if host.is_unclaimed:
        return limits.idle_seconds * UNCLAIMED_PATIENCE
    if is_stored or host.identity.stays_awake:
        return float("inf")
    return limits.idle_seconds * (MANUAL_PATIENCE if host.clock_kind == "manual" else 1)


def unmissed(hosts: Sequence[StageHost], limits: Limits, now: float) -> StageHost | None:
    """Returns the stage that nobody misses, so that another one may take its place; None if there is none.
    Nobody uses it, nobody has changed or named it since it was opened, and no fork began in it: who opens
    the same again has it back.

    A real-time stage must sleep; one with a manual clock must be idle for so long that it would be closed
    without a data folder. Of several it is the one that has been idle for longest.

    `now`: seconds of the server's clock.
    """
    origins = {host.identity.origin.stage for host in hosts if host.identity.origin}
    for host in sorted(hosts, key=lambda host: -host.idle_for(now)):
        least = limits.rest_seconds if host.identity.may_sleep else patience(host, limits, is_stored=False)
        if host.idle_for(now) > least and host.id not in origins and _is_as_opened(host):
            return host
    return None


def _is_as_opened(host: StageHost) -> bool:
    """Whether nothing came to the stage but the actors that it was opened with."""
    with suppress(BusyError):
        facts = host.look(ask.Describe())
        place, newest = facts.place, facts.place.newest_input
        is_new = not place.name and place.origin is None and (newest is None or newest.tick == 0)
        return is_new and place.inputs == len(facts.actors)
    return False
