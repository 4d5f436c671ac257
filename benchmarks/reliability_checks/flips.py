"""R-17: bits of the database flip, or its end is gone; no stage may silently be another one."""

from __future__ import annotations

import argparse
import logging
import tempfile
from collections import Counter
from pathlib import Path

from flips_folder import outcomes
from statwalk.services.library.catalogue import Catalogue


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--flips", type=int, default=10_000)
    command.add_argument("--first", type=int, default=0, help="the seed of the first damage")


def main(options: argparse.Namespace) -> bool:
    """Prints what became of the damages; returns whether none was silent."""
    logging.disable(logging.CRITICAL)
    counts: Counter[str] = Counter()
    seeds = range(options.first, options.first + options.flips)
    with tempfile.TemporaryDirectory() as folder:
        for seed, what, wrong in outcomes(Path(folder), seeds, Catalogue()):
            counts.update([what, *["silent"] * bool(wrong)])
            if wrong:
                print(f"--first {seed} --flips 1: {', '.join(wrong)} came back as something else", flush=True)
    print(", ".join(f"{what}: {count:,}" for what, count in sorted(counts.items())))
    return not counts["silent"]
