"""R-04: the power is cut after each system call of a run; what was acknowledged is there after a start."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from keeper import Plan, recorded
from killed import CONTEXT, start_forks
from power_cuts import MEMORY, Counts, Sample, check
from system_calls import calls
from traced import why_not

ROUNDS = 4
SHOWN = 5


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--inputs", type=int, default=2_000)
    command.add_argument("--draws", type=int, default=20, help="states at random after a system call")
    command.add_argument("--every", type=int, default=6, help="draw after every so many system calls")
    command.add_argument("--seed", type=int, default=1)
    command.add_argument("--workers", type=int, default=2)
    command.add_argument(
        "--weakness", choices=["NORMAL", "OFF", "before"], default="", help="the control: it promises less"
    )


def _part(traces: list[Path], folder: Path, sample: Sample) -> Counts:
    return check(calls(traces), folder, sample)


def main(options: argparse.Namespace) -> bool:
    """Prints how many states were looked at, and how many lost something; returns whether none did."""
    if reason := why_not():
        print(f"not checked: {reason}")
        return False
    start_forks()
    counts = Counts()
    with tempfile.TemporaryDirectory(dir=MEMORY if MEMORY.is_dir() else None) as name:
        plan = Plan(-(-options.inputs // ROUNDS), options.seed, weakness=options.weakness)
        traces = recorded(Path(name), ROUNDS, plan)
        samples = [
            Sample(options.seed, options.draws, options.every, options.workers, worker)
            for worker in range(options.workers)
        ]
        with CONTEXT.Pool(options.workers) as pool:
            for part in pool.starmap(_part, [(traces, Path(name) / "data", sample) for sample in samples]):
                counts.add(part)
    for line in counts.broken[:SHOWN]:
        print(f"seed {options.seed}: {line}")
    print(
        f"{counts.inputs:,} inputs acknowledged, {counts.boundaries:,} system calls, "
        f"{counts.states:,} power cuts ({counts.opened:,} states differ), "
        f"{len(counts.broken):,} of them lost or damaged something"
    )
    return not counts.broken
