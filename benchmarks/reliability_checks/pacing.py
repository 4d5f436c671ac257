"""R-20: a server that runs for long keeps its pace and grows by nothing."""

from __future__ import annotations

import argparse
import time
from contextlib import ExitStack
from typing import NamedTuple

import httpx
import numpy as np
from load_process import LoadProcess, viewers_in_a_process
from pacing_figures import Held, Pace, held, late_counts, late_within, pace
from processes import served

MAIN = "/api/stages/main"
VIEWERS = 4
RATE, TOLERANCE = 60.0, 0.02
MOST_GROWTH = 1 << 20
"""bytes an hour"""
WARM_MINUTES = 2
"""in which memory may still grow: pools fill, and the history of a stage reaches its length"""


class Minute(NamedTuple):
    """What was seen in a minute."""

    pace: Pace
    held: Held
    first: tuple[float, int]
    last: tuple[float, int]
    """time (s) and tick of the first and of the last frame"""


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--minutes", type=int, default=60)


def minute(process: int, load: LoadProcess) -> Minute:
    """Watches for a minute."""
    time.sleep(60)
    seen = load.seen()[0]
    ends = [(seen.times[place], seen.ticks[place]) for place in (0, -1)]
    return Minute(pace(seen.times, seen.ticks), held(process), ends[0], ends[1])


def judge(minutes: list[Minute]) -> list[str]:
    """Prints the figures over all minutes; returns what did not hold, in words."""
    (began, first), (ended, last) = minutes[0].first, minutes[-1].last
    hz, drift = (last - first) / (ended - began), (ended - began) - (last - first) / RATE
    print(f"{hz:.4f} Hz over {len(minutes)} minutes, {1000 * drift:+.1f} ms drift")
    faults = [] if abs(hz - RATE) <= TOLERANCE else ["the pace is wrong"]
    warm = minutes[WARM_MINUTES:]
    if len(warm) > 1:
        memory = [one.held.resident for one in warm]
        growth = float(np.polyfit(range(len(warm)), memory, 1)[0]) * 60
        print(
            f"memory grows by {growth / (1 << 20):+.2f} MiB an hour, after the first {WARM_MINUTES} minutes"
        )
        faults += ["memory grows"] if growth > MOST_GROWTH else []
        for what in ("files", "threads"):
            counts = [getattr(one.held, what) for one in warm]
            print(f"{what}: {counts[0]} to {counts[-1]}, {max(counts)} at most")
            faults += [f"there are more {what}"] if counts[-1] > counts[0] else []
    return faults


def main(options: argparse.Namespace) -> bool:
    """Prints a line for each minute, and returns whether pace and size held."""
    minutes: list[Minute] = []
    with ExitStack() as stack:
        process, address = stack.enter_context(served())
        rest = stack.enter_context(httpx.Client(base_url=f"http://{address}"))
        load = stack.enter_context(viewers_in_a_process(address, MAIN, VIEWERS))
        time.sleep(2)
        load.seen()
        before = late_counts(rest.get("/metrics").text)
        for number in range(options.minutes):
            minutes.append(minute(process.pid, load))
            at, has = minutes[-1].pace, minutes[-1].held
            print(
                f"minute {number + 1:4}: {at.hz:.4f} Hz, drift {1000 * at.drift:+6.1f} ms, "
                f"RSS {has.resident / (1 << 20):.1f} MiB, {has.files} files, {has.threads} threads",
                flush=True,
            )
        after = late_counts(rest.get("/metrics").text)
    for part in (0.5, 0.99, 0.999):
        print(f"{100 * part:g} % of the ticks at most {1000 * late_within(before, after, part):g} ms late")
    faults = judge(minutes)
    print("\n".join(faults) or "all held")
    return not faults
