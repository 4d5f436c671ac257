"""R-08: the server in a simulated world; one seed decides when its disk, network, clocks and power fail."""

from __future__ import annotations

import argparse
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial

from simulated.planted import PLANTS
from simulated.simulate import Outcome, simulate

CHUNK = 20


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--seeds", type=int, default=10_000)
    command.add_argument("--first", type=int, default=1, help="the first seed")
    command.add_argument("--minutes", type=float, default=10.0, help="simulated minutes of each seed")
    command.add_argument("--processes", type=int, default=1)
    command.add_argument("--planted", choices=PLANTS, help="the control: a fault that must be found")
    command.add_argument(
        "--all-planted", action="store_true", help="plants one fault after another; each must be found"
    )


def main(options: argparse.Namespace) -> bool:
    """Prints what happened, and of each seed with a fault its last events; returns whether no seed has one,
    or, with planted faults, whether each was found.
    """
    if options.all_planted:
        return [_finds(name, options) for name in PLANTS] == [True] * len(PLANTS)
    if options.planted:
        return _finds(options.planted, options)
    began, counts, faults, most = time.monotonic(), Counter[str](), 0, 0
    seeds = range(options.first, options.first + options.seeds)
    with ProcessPoolExecutor(options.processes) as pool:
        outcomes = pool.map(partial(simulate, minutes=options.minutes), seeds, chunksize=CHUNK)
        for done, outcome in enumerate(outcomes, 1):
            counts, most = counts + outcome.counts, max(most, outcome.most_waiting)
            if outcome.faults:
                faults += 1
                print(outcome.report, flush=True)
            if done % 500 == 0:
                print(f"{done:,} seeds, {faults} with a fault, {time.monotonic() - began:.0f} s", flush=True)
    hours = options.seeds * options.minutes / 60
    print(
        f"{options.seeds:,} seeds from {options.first}, {hours:,.0f} simulated hours in "
        f"{time.monotonic() - began:,.0f} s: {faults} with a fault; at most {most} writes waited; "
        f"{_words(counts)}"
    )
    return not faults


def _finds(name: str, options: argparse.Namespace) -> bool:
    """Prints after how many seeds, and seconds, a planted fault is found."""
    minutes, plant, _ = PLANTS[name]
    began = time.monotonic()
    with plant():
        for seed in range(options.first, options.first + options.seeds):
            outcome = simulate(seed, minutes)
            if outcome.faults:
                print(
                    f"{name}: seed {seed}, after {time.monotonic() - began:.1f} s: {_short(outcome)}",
                    flush=True,
                )
                return True
    print(f"{name}: not found in {options.seeds} seeds")
    return False


def _short(outcome: Outcome) -> str:
    return outcome.faults[0][:100]


def _words(counts: Counter[str]) -> str:
    return ", ".join(f"{count:,} {what}" for what, count in sorted(counts.items()))
