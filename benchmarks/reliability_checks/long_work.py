"""Long work harms no other stage: how evenly a viewer's frames come while each kind of long request runs."""

from __future__ import annotations

import argparse
import asyncio
import itertools
import time
from collections import Counter
from collections.abc import Awaitable, Callable
from contextlib import ExitStack, suppress
from typing import NamedTuple

import httpx
from load_process import LoadProcess, viewers_in_a_process
from processes import served
from viewer_figures import Intervals, intervals

MAIN = "/api/stages/main"
WALKER = {"machine": "faq-walker"}
VIEWERS = 4
AT_ONCE = 4
MANY_STEPS = 45
TICKS = 3_600
MOST_TICKS = 36_000
SETTLE_SECONDS = 1.0
TIMES = 2.5
"""how many times the p99 of the quiet phases beside it a phase may have, if it is over a frame's time more"""
Ask = Callable[[httpx.AsyncClient], Awaitable[httpx.Response]]


class Kind(NamedTuple):
    """A kind of long work: requests that `at_once` clients repeat."""

    name: str
    ask: Ask
    at_once: int = AT_ONCE


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--seconds", type=float, default=20, help="of each phase")
    command.add_argument("--only", default="", help="the kinds whose names have this word")


async def repeated(address: str, kind: Kind, seconds: float) -> Counter[int]:
    """Repeats the requests of a kind for a while, then leaves; returns how often which status came back."""
    statuses = Counter[int]()

    async def repeat() -> None:
        async with httpx.AsyncClient(base_url=f"http://{address}", timeout=90) as rest:
            while True:
                answer = await kind.ask(rest)
                statuses[answer.status_code] += 1
                await asyncio.sleep(float(answer.headers.get("retry-after", 0)))

    with suppress(TimeoutError):
        async with asyncio.timeout(seconds):
            await asyncio.gather(*(repeat() for _ in range(kind.at_once)))
    return statuses


def opened(rest: httpx.Client, **setup: object) -> str:
    """Opens a stage of one walker."""
    return rest.post("/api/stages", json={"actors": [WALKER], **setup}).raise_for_status().headers["location"]


async def open_and_delete(rest: httpx.AsyncClient) -> httpx.Response:
    """Opens fifteen real-time stages (sixty, with three other clients), and deletes them."""
    answers = [await rest.post("/api/stages", json={"actors": [WALKER]}) for _ in range(15)]
    for answer in answers:
        if answer.is_success:
            await rest.delete(answer.headers["location"])
    return answers[-1]


async def fork_and_delete(rest: httpx.AsyncClient, stage: str) -> httpx.Response:
    """Forks a stage, and deletes the fork."""
    answer = await rest.post(f"{stage}/fork")
    if answer.is_success:
        await rest.delete(answer.headers["location"])
    return answer


def kinds(rest: httpx.Client) -> list[Kind]:
    """All kinds, about stages that are made for them."""
    past, stepped = opened(rest, clock="manual"), opened(rest, clock="manual")
    rest.post(f"{past}/step", json={"ticks": TICKS}, timeout=90).raise_for_status()
    ends, numbers = itertools.cycle((0, TICKS)), itertools.count()
    machine = rest.get("/api/machines/faq-walker").json()

    async def verify(rest: httpx.AsyncClient) -> httpx.Response:
        """Verifies a text that the server has not seen yet: it remembers the findings of each."""
        new = {"text": f"{machine['text']}\n# {next(numbers)}\n"}
        version = {"If-Match": str(machine["version"])}
        return await rest.put("/api/machines/faq-walker?dry=true", json=new, headers=version)

    return [
        Kind("verify", verify),
        Kind("measure", lambda rest: rest.get("/api/machines/faq-walker/measure")),
        Kind("recording.glb of a minute", lambda rest: rest.get(f"{past}/recording.glb?from=1&to={TICKS}")),
        Kind("frame.glb", lambda rest: rest.get(f"{past}/frame.glb?tick={TICKS // 2}")),
        Kind("whynot", lambda rest: rest.get(f"{past}/actors/1/whynot?event=JUMP&tick=100")),
        Kind("seek far", lambda rest: rest.post(f"{past}/seek", json={"tick": next(ends)})),
        Kind("step 36,000", lambda rest: rest.post(f"{stepped}/step", json={"ticks": MOST_TICKS})),
        Kind(
            "45 x step 36,000",
            lambda rest: rest.post(f"{stepped}/step", json={"ticks": MOST_TICKS}),
            MANY_STEPS,
        ),
        Kind("60 stages being opened", open_and_delete),
        Kind("forks in a loop", lambda rest: fork_and_delete(rest, past)),
    ]


def quiet(load: LoadProcess, seconds: float) -> Intervals:
    """The viewers' intervals without long work."""
    time.sleep(SETTLE_SECONDS)
    load.seen()
    time.sleep(seconds)
    return intervals(load.seen())


def close_others(rest: httpx.Client, kept: set[str]) -> None:
    """Closes the stages that the clients left open."""
    for stage in rest.get("/api/stages").raise_for_status().json():
        if stage["id"] not in kept:
            rest.delete(f"/api/stages/{stage['id']}")


def beside(
    load: LoadProcess, address: str, kind: Kind, seconds: float
) -> tuple[Intervals, Counter[int], bool]:
    """The viewers' intervals beside long work, how it was answered, and whether a viewer was cut."""
    load.seen()
    statuses = asyncio.run(repeated(address, kind, seconds))
    seen = load.seen()
    return intervals(seen), statuses, any(one.code for one in seen)


def main(options: argparse.Namespace) -> bool:
    """Prints a line for each kind, and returns whether no kind harmed the viewers."""
    harmed = []
    with ExitStack() as stack:
        _, address = stack.enter_context(served("--limit", "requests=100000"))
        rest = stack.enter_context(httpx.Client(base_url=f"http://{address}", timeout=90))
        every = [kind for kind in kinds(rest) if options.only in kind.name]
        kept = {stage["id"] for stage in rest.get("/api/stages").json()}
        load = stack.enter_context(viewers_in_a_process(address, MAIN, VIEWERS))
        before = quiet(load, options.seconds)
        print(f"{'quiet':26}{before}", flush=True)
        for kind in every:
            figures, statuses, cut = beside(load, address, kind, options.seconds)
            close_others(rest, kept)
            after = quiet(load, options.seconds / 2)
            usual = (before.p99 + after.p99) / 2
            print(
                f"{kind.name:26}{figures}  {figures.p99 / usual:4.1f} x quiet  {dict(statuses)}", flush=True
            )
            if cut or (figures.p99 > TIMES * usual and figures.p99 > usual + 1000 / 60):
                harmed.append(kind.name)
            before = after
        print(f"{'quiet':26}{before}")
    print("harmed: " + ", ".join(harmed) if harmed else "no kind harmed the viewers")
    return not harmed
