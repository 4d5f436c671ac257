"""R-01, R-02, R-13 and R-14 under load: many viewers at 60 Hz beside stalled ones, one that is stopped and
woken, and one that floods; at the end SIGTERM with all of them.

A flood keeps a processor busy whomever it is for, so it is for another server first: what a flood of the
viewers' own server adds to that is the server's part.
"""

from __future__ import annotations

import argparse
import os
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import NamedTuple

import httpx
from driving import driving
from ends import ended
from flood import flooded
from load_process import LoadProcess, Seen, viewers_in_a_process
from processes import served
from stalled_viewers import cuts, stalled
from viewer_figures import Intervals, goes_back, intervals, resident_bytes, stale

MAIN = "/api/stages/main"
SETTLE_SECONDS = 2.0
"""between two phases"""
MORE_MILLISECONDS, LONGEST_MILLISECONDS = 3.0, 100.0
CUT_SECONDS = (4.0, 6.0)
STALE_FRAMES = 3
FLOOD, FLOOD_ELSEWHERE = "a flood from one client", "the same flood of another server"
COUNT_SECONDS = 60.0


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--viewers", type=int, default=200)
    command.add_argument("--processes", type=int, default=2, help="that hold the viewers")
    command.add_argument("--seconds", type=float, default=60, help="of each phase")
    command.add_argument("--stopped", type=float, default=30, help="seconds for which a viewer is stopped")
    command.add_argument("--flood", type=float, default=50_000, help="events a second from one client")
    command.add_argument("--actors", type=int, default=1, help="more of them make larger frames")


class Run(NamedTuple):
    """A server with its viewers, and the address of one without."""

    process: subprocess.Popen[str]
    address: str
    elsewhere: str
    loads: list[LoadProcess]
    sleeper: LoadProcess
    rest: httpx.Client
    options: argparse.Namespace
    faults: list[str]
    """what did not hold, in words"""

    def viewers(self) -> int:
        """The number of viewers that the server counts."""
        return int(self.rest.get(MAIN).json()["viewers"])

    def seen(self) -> list[Seen]:
        """What the viewers saw since the last call."""
        return [one for load in self.loads for one in load.seen()]


class Phase(NamedTuple):
    """The frames of the others in a phase."""

    name: str
    seen: list[Seen]
    figures: Intervals


def measured(run: Run, name: str, act: Callable[[], None]) -> Phase:
    """Runs a phase, prints its figures, and returns them."""
    time.sleep(SETTLE_SECONDS)
    run.seen()
    act()
    memory = resident_bytes(run.process.pid) / (1 << 20)
    seen = run.seen()
    phase = Phase(name, seen, intervals(seen))
    print(f"{name:32}{phase.figures}  RSS {memory:6.1f} MiB  viewers {run.viewers()}", flush=True)
    return phase


def among_stalled(run: Run, count: int, lies: bool = False) -> Callable[[], None]:
    """A phase with so many stalled viewers."""

    def act() -> None:
        with stalled(count, run.address, MAIN, lies=lies):
            time.sleep(run.options.seconds)

    return act


def stopped(run: Run) -> Phase:
    """Stops the sleeper for a while, and says what it saw when it woke up."""
    woken = 0.0
    pid = run.sleeper.process.pid

    def act() -> None:
        nonlocal woken
        run.sleeper.seen()
        os.kill(pid, signal.SIGSTOP)
        time.sleep(run.options.stopped)
        woken = time.monotonic()
        os.kill(pid, signal.SIGCONT)
        time.sleep(2)

    phase = measured(run, f"a viewer stopped for {run.options.stopped:g} s", act)
    saw = run.sleeper.seen()
    old = stale(saw, phase.seen, woken)
    current = [
        at - woken
        for one in saw
        for at in one.times
        if at > woken and at - woken not in [seconds for seconds, _ in old]
    ]
    codes = [one.code for one in saw]
    first = min(current, default=float("inf"))
    print(f"    woken: {len(old)} stale frames, a current one after {1000 * first:.0f} ms, closed {codes}")
    if len(old) > STALE_FRAMES or first > 1:
        run.faults.append("the woken viewer saw the past")
    return phase


def flood(run: Run, name: str, address: str) -> Phase:
    """Floods the main stage of a server, and says how that was answered."""
    found: dict[str, int] = {}
    phase = measured(
        run,
        name,
        lambda: found.update(flooded(address, MAIN, run.options.flood, run.options.seconds)),
    )
    print(f"    {found}")
    return phase


def quiet(run: Run) -> Phase:
    """A phase with which the ones beside it are compared."""
    return measured(run, "nobody stalled", lambda: time.sleep(run.options.seconds))


def phases(run: Run) -> list[Phase]:
    """Runs all phases, each between two undisturbed ones: other work on the computer comes and goes."""
    done = [quiet(run)]
    for disturbed in (
        lambda: measured(run, "1 stalled", among_stalled(run, 1)),
        lambda: measured(run, "5 stalled", among_stalled(run, 5)),
        lambda: measured(run, "20 stalled", among_stalled(run, 20)),
        lambda: measured(run, "1 that acknowledges unread", among_stalled(run, 1, lies=True)),
        lambda: stopped(run),
        lambda: flood(run, FLOOD_ELSEWHERE, run.elsewhere),
        lambda: flood(run, FLOOD, run.address),
    ):
        done += [disturbed(), quiet(run)]
    return done


def judge_frames(run: Run, done: list[Phase]) -> None:
    """Compares each phase with the undisturbed ones before and after it; a flood may add what it adds
    elsewhere.
    """
    more: dict[str, float] = {}
    for before, phase, after in zip(done[::2], done[1::2], done[2::2], strict=False):
        name, quiet_p99 = phase.name, (before.figures.p99 + after.figures.p99) / 2
        more[name] = phase.figures.p99 - quiet_p99
        longest = max(before.figures.longest, after.figures.longest)
        print(f"{name:32}p99 {more[name]:+.1f} ms beside the two around it, max {longest:.1f} ms in these")
        allowed = MORE_MILLISECONDS + (max(0.0, more[FLOOD_ELSEWHERE]) if name == FLOOD else 0.0)
        is_late = more[name] > allowed or phase.figures.longest > LONGEST_MILLISECONDS
        if is_late and name != FLOOD_ELSEWHERE:
            run.faults.append(f"{name}: frames came late")
    for phase in done:
        if goes_back(phase.seen) or any(one.code for one in phase.seen):
            run.faults.append(f"{phase.name}: a frame went back, or a viewer was cut")


def judge_viewers(run: Run, log: Path) -> None:
    """Checks what the viewers saw, and when the stalled ones were cut."""
    last = run.seen()
    print(f"{last[0].facts} facts, the same for {len(last)} viewers of frames of {last[0].frame_bytes} bytes")
    if len({(one.facts, one.digest) for one in last}) != 1:
        run.faults.append("the viewers did not see the same facts")
    for name in ("silent", "lying"):
        ends = [cut for cut in cuts(log, name) if cut.code]
        least, most = min(ends).seconds, max(ends).seconds
        print(f"{len(ends)} {name} viewers cut after {least:.1f} to {most:.1f} s")
        if not CUT_SECONDS[0] < least <= most < CUT_SECONDS[1] or {cut.code for cut in ends} != {4008}:
            run.faults.append(f"{name} viewers were not cut in time")


def count_again(run: Run, before: int) -> None:
    """Waits until the server counts as many viewers as before: it still reads what the flood has sent."""
    began = time.monotonic()
    while (now := run.viewers()) != before and time.monotonic() < began + COUNT_SECONDS:
        time.sleep(0.1)
    print(f"{now} viewers, {before} before; so again after {time.monotonic() - began:.1f} s")
    if now != before:
        run.faults.append("the count of viewers is not what it was")


def main(options: argparse.Namespace) -> bool:
    """Prints the figures of each phase, and returns whether the promises held."""
    each = options.viewers // options.processes
    with tempfile.TemporaryDirectory() as folder, ExitStack() as opened:
        log = Path(folder) / "log"
        process, address = opened.enter_context(served("--log", "json", "--data", folder, log=log))
        _, elsewhere = opened.enter_context(served())
        rest = opened.enter_context(httpx.Client(base_url=f"http://{address}", timeout=30))
        for _ in range(options.actors - 1):
            rest.post(f"{MAIN}/actors", json={"machine": "faq-walker"}).raise_for_status()
        loads = [
            opened.enter_context(viewers_in_a_process(address, MAIN, each)) for _ in range(options.processes)
        ]
        sleeper = opened.enter_context(viewers_in_a_process(address, MAIN, 1))
        run = Run(process, address, elsewhere, loads, sleeper, rest, options, [])
        before = run.viewers()
        with driving(address, MAIN, 0.05) as statuses:
            done = phases(run)
        time.sleep(SETTLE_SECONDS)
        judge_frames(run, done)
        judge_viewers(run, log)
        count_again(run, before)
        print(f"{len(statuses)} events posted beside, {statuses.count(202)} accepted")
        run.faults.extend(ended(process, address, loads))
    print("\n".join(run.faults) or "all held")
    return not run.faults
