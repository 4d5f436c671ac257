"""Clients that post inputs through a proxy that cuts connections, and send again until they are answered."""

import asyncio
import json
import random
from typing import NamedTuple

import httpx
from cutting_proxy import CuttingProxy
from serving import PATIENCE

LONGEST_BYTES = 1_500
"""of a connection in one direction: about five requests, or eight answers"""
WORKERS = 4
MAIN = "/api/stages/main"


class Retries(NamedTuple):
    """What came of posting inputs: requests sent, cuts, numbers of the answers by key, and the numbers in the
    log of the stage.
    """

    sent: int
    cuts: int
    answered: dict[str, int]
    different: int
    """requests that were answered before, and then with another number"""
    logged: list[int]


class _Poster:
    def __init__(self, client: httpx.AsyncClient, seed: int, *, has_keys: bool) -> None:
        self.client, self.dice, self.has_keys = client, random.Random(seed), has_keys
        self.answered: dict[str, int] = {}
        self.sent = self.different = 0

    async def post(self, key: str) -> None:
        """Sends until it is answered; one in twenty once more, although it was answered."""
        self.answered[key] = await self._answer(key)
        if self.has_keys and self.dice.randrange(20) == 0:
            self.different += await self._answer(key) != self.answered[key]

    async def _answer(self, key: str) -> int:
        headers = {"Idempotency-Key": key} if self.has_keys else {}
        while True:
            self.sent += 1
            try:
                answer = await self.client.post(f"{MAIN}/events", json={"event": "FORWARD"}, headers=headers)
            except httpx.TransportError:
                continue
            assert answer.status_code == 202, answer.text
            number: int = answer.json()["seq"]
            return number


async def retried(address: str, inputs: int, seed: int, *, has_keys: bool = True) -> Retries:
    """Posts inputs to the stage `main` of a server; `has_keys`: False is the control."""
    keys = iter(range(inputs))
    proxy = CuttingProxy(address, LONGEST_BYTES, seed)
    async with (
        proxy.open() as through,
        httpx.AsyncClient(base_url=f"http://{through}", timeout=PATIENCE) as client,
    ):
        poster = _Poster(client, seed, has_keys=has_keys)

        async def work() -> None:
            for key in keys:
                await poster.post(f"input {key}")

        await asyncio.gather(*(work() for _ in range(WORKERS)))
    async with httpx.AsyncClient(base_url=f"http://{address}", timeout=60.0) as direct:
        lines = (await direct.get(f"{MAIN}/log")).text.splitlines()[1:]
    entries = [json.loads(line) for line in lines]
    logged = [entry["number"] for entry in entries if entry["kind"] == "press"]
    return Retries(poster.sent, proxy.cuts, poster.answered, poster.different, logged)
