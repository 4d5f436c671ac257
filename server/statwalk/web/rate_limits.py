"""Limits requests and inputs a second, by client and by stage; keeps flooding sockets away for a while."""

from __future__ import annotations

import re
import time
from typing import NamedTuple

from starlette.types import ASGIApp, Receive, Scope, Send

from statwalk.services.hosting.registry import Registry
from statwalk.services.limits import BURST_SECONDS, Limits
from statwalk.services.threads import Now
from statwalk.web.client_address import address_of
from statwalk.web.dependencies import ENDING
from statwalk.web.errors import Problem, answer
from statwalk.web.gate import sender_of
from statwalk.web.request_log import note_limit, note_scope
from statwalk.web.token_bucket import MOST_BUCKETS, TokenBuckets
from statwalk.web.turns import Turns

UNLIMITED = frozenset({"/healthz", "/readyz"})
STAGE = re.compile(r"/api/stages/([^/]+)(?:/(events|parameters|actors/[^/]+/travel))?(?:/.*)?")


class Rate(NamedTuple):
    """A limit of a rate: its name in docs/limits.md, its buckets, and whom it counts, in words."""

    limit: str
    buckets: TokenBuckets
    whose: str

    def spend(self, key: str) -> None:
        """Counts one request or input.

        :raises Problem: 429, when too many came; its Retry-After says when the next may.
        """
        bucket = self.buckets.of(key)
        if not bucket.spend():
            detail = f"{self.whose}: more than {bucket.rate:g} a second; send fewer, or wait"
            raise too_many(detail, bucket.seconds_left(), self.limit)


def too_many(detail: str, seconds: int, limit: str) -> Problem:
    """Returns the 429 that asks a client to wait."""
    return Problem(429, detail, headers={"Retry-After": str(seconds)}, limit=limit)


class RateLimits:
    """The rates of one server. Use it in the thread of the event loop only.

    A client is an address; with `proxied`, where all clients come through one proxy, a token.
    """

    def __init__(self, limits: Limits, now: Now = time.perf_counter, *, proxied: bool = False) -> None:
        def rate(limit: str, whose: str) -> Rate:
            most = getattr(limits, limit)
            return Rate(limit, TokenBuckets(most, most * BURST_SECONDS, now), whose)

        self.client_of = sender_of if proxied else address_of
        self._source = source = "with your token" if proxied else "from your address"
        self._requests = rate("requests", f"requests {source}")
        self._stage_requests = rate("stage_requests", "requests about this stage")
        self._inputs = rate("inputs", f"inputs {source}")
        self._stage_inputs = rate("stage_inputs", "inputs to this stage")
        self._now, self._cooling_seconds = now, limits.cooling_seconds
        self._cooling: dict[str, float] = {}

    def request(self, client: str, stage: str) -> None:
        """Counts a request; `client` and `stage` are empty if it has none.

        :raises Problem: 429, when too many came.
        """
        if client:
            self._requests.spend(client)
        if stage:
            self._stage_requests.spend(stage)

    def input(self, client: str, stage: str) -> None:
        """Counts an input to a stage.

        :raises Problem: 429, when too many came.
        """
        if client:
            self._inputs.spend(client)
        self._stage_inputs.spend(stage)

    def cool(self, client: str) -> None:
        """Keeps new sockets of a client away for a while."""
        now = self._now()
        self._cooling = {one: until for one, until in self._cooling.items() if until > now}
        if client and len(self._cooling) < MOST_BUCKETS:
            self._cooling[client] = now + self._cooling_seconds

    def check_cooled(self, client: str) -> None:
        """Checks whether a client may open a socket.

        :raises Problem: 429, when a socket of it was just closed because of too many messages.
        """
        seconds = self._cooling.get(client, 0.0) - self._now()
        if seconds > 0:
            detail = f"a socket {self._source} was closed because of too many messages; wait a little"
            raise too_many(detail, int(seconds) + 1, "cooling_seconds")


class RateGuard:
    """The middleware that refuses what comes too often, before any route runs, and lets the requests of one
    client begin one after another.
    """

    def __init__(self, app: ASGIApp, rates: RateLimits, registry: Registry) -> None:
        self.app, self.rates, self.registry = app, rates, registry
        self.turns = Turns()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Counts a request, and passes it on when it is its turn; answers a refused request itself."""
        if scope["type"] != "lifespan":
            note_scope(scope)
            try:
                self.check(scope)
            except Problem as problem:
                note_limit(scope, problem.limit)
                await answer(problem.body(), dict(problem.headers or {}))(scope, receive, send)
                return
        waits = scope["type"] == "http" and scope["path"] not in UNLIMITED
        async with self.turns.of(self.rates.client_of(scope) if waits else ""):
            await self.app(scope, receive, send)

    def check(self, scope: Scope) -> None:
        """Counts a request, and its input if it has one.

        :raises Problem: 429, when too many came; 503, when the server stops.
        """
        if scope["path"] in UNLIMITED:
            return
        if ENDING in scope and scope[ENDING].is_set():
            raise Problem(503, "the server stops; try again", headers={"Retry-After": "1"})
        client, match = self.rates.client_of(scope), STAGE.fullmatch(scope["path"])
        stage = (
            match[1] if match and match[1] in self.registry.stages else ""
        )  # names of no stage fill no bucket
        if scope["type"] == "websocket":
            self.rates.check_cooled(client)
        self.rates.request(client, stage)
        if match and match[2] and stage and scope.get("method") in ("POST", "DELETE"):
            self.rates.input(client, stage)
