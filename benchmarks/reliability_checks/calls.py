"""R-03: `kill -9` at each system call that changes the disk; what was acknowledged is there after a start."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from keeper import Plan
from killed import start_forks
from killed_calls import broken_after, killed_at, used
from power_cuts import MEMORY
from traced import why_not


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--first", type=int, default=1, help="the first call to kill at")
    command.add_argument("--last", type=int, default=2_000)
    command.add_argument("--every", type=int, default=1, help="kill at every so many calls")
    command.add_argument(
        "--before-the-disk", action="store_true", help="the control: it answers before the disk has the input"
    )


def main(options: argparse.Namespace) -> bool:
    """Prints how many processes were killed, and what a start did not find; returns whether it found all."""
    if reason := why_not():
        print(f"not checked: {reason}")
        return False
    start_forks()
    kills = inputs = broken = 0
    with tempfile.TemporaryDirectory(dir=MEMORY if MEMORY.is_dir() else None) as name:
        before = used(Path(name) / "used")
        for call in range(options.first, options.last + 1, options.every):
            with tempfile.TemporaryDirectory(dir=name) as one:
                folder = Path(one) / "data"
                plan = Plan(call + 1, call, weakness="before" if options.before_the_disk else "")
                promised, is_killed = killed_at(before.copied(folder), call, plan)
                problem = broken_after(folder, promised) if is_killed else "it was not killed"
            kills, inputs, broken = kills + is_killed, inputs + promised.inputs, broken + bool(problem)
            if problem:
                print(f"call {call} (--first {call} --last {call}): {problem}", flush=True)
    print(f"{kills:,} kills, {inputs:,} inputs acknowledged, {broken:,} starts that broke a promise")
    return not broken
