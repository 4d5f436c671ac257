"""R-03: `kill -9` at random instants; what was acknowledged is there after a start."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from killed import killed, logged, start_forks


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--kills", type=int, default=1_000)
    command.add_argument("--seed", type=int, default=1, help="of the first kill")
    command.add_argument(
        "--before-the-disk", action="store_true", help="the control: it answers before the disk has the input"
    )


def main(options: argparse.Namespace) -> bool:
    """Prints how many inputs were acknowledged, and how many of them are missing; returns whether none is."""
    start_forks()
    acknowledged = missing = more = 0
    for seed in range(options.seed, options.seed + options.kills):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            kill = killed(folder, seed, is_honest=not options.before_the_disk)
            found = logged(folder, kill.stage)
        acknowledged += len(kill.acknowledged)
        lost = len(set(kill.acknowledged) - set(found))
        missing += lost
        more += len(found) != len(set(found)) or len(found) > len(kill.acknowledged) + 1
        if lost:
            print(f"seed {seed}: {lost} of {len(kill.acknowledged)} are missing", flush=True)
    print(f"{options.kills} kills, {acknowledged:,} inputs acknowledged, {missing} missing, {more} repeated")
    return not missing and not more
