"""R-15: each system call that changes the disk fails, once or more often; what a store answers meanwhile."""

from __future__ import annotations

import argparse
import logging
import tempfile
from collections import Counter
from pathlib import Path

from disk_faults import FAILING, UNTIL_TOLD, Fault, outcome
from keeper import Plan
from killed import start_forks
from killed_calls import used
from power_cuts import MEMORY
from traced import why_not

LONG = 5
"""failures that follow each other"""
KINDS = [(error, times) for times in (1, LONG, UNTIL_TOLD) for error in ("EIO", "ENOSPC")]


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--first", type=int, default=1, help="the first call that fails")
    command.add_argument("--last", type=int, default=500)
    command.add_argument("--every", type=int, default=1)
    command.add_argument("--only", default=FAILING, help="the calls that fail; separated by commas")
    command.add_argument("--deaf", action="store_true", help="the control: a writer that hears no error")


def main(options: argparse.Namespace) -> bool:
    """Prints how many faults there were, and what they broke; returns whether they broke nothing.

    The nth call fails once, five times, or until the store has refused something, by turns, for want of room
    or with an error of the disk.
    """
    if reason := why_not():
        print(f"not checked: {reason}")
        return False
    logging.disable(logging.CRITICAL)
    start_forks()
    counts: Counter[str] = Counter()
    with tempfile.TemporaryDirectory(dir=MEMORY if MEMORY.is_dir() else None) as name:
        before = used(Path(name) / "used")
        for number in range(options.first, options.last + 1, options.every):
            error, times = KINDS[number % len(KINDS)]
            fault = Fault(error, number, times, options.only)
            plan = Plan(number // 5 + 10, number, weakness="deaf" if options.deaf else "")
            with tempfile.TemporaryDirectory(dir=name) as one:
                found = outcome(before.copied(Path(one) / "data"), fault, plan)
            counts.update(faults=1, inputs=found.inputs, refusals=found.refusals, broken=bool(found.broken))
            if found.broken:
                print(f"{fault} (--first {number} --last {number}): {found.broken}", flush=True)
    print(
        f"{counts['faults']:,} faults, {counts['inputs']:,} inputs acknowledged, "
        f"{counts['refusals']:,} refusals, {counts['broken']:,} faults that broke a promise"
    )
    return not counts["broken"]
