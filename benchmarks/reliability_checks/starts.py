"""R-16: pairs of processes that start on one data folder at the same instant; each race has one winner."""

from __future__ import annotations

import argparse
import tempfile
from collections import Counter
from pathlib import Path

from races import Racers


def add_options(parser: argparse.ArgumentParser) -> None:
    """Adds the options of this check."""
    parser.add_argument("--races", type=int, default=1_000)
    parser.add_argument("--file-as-lock", action="store_true", help="the control: a lock that is a file")


def main(options: argparse.Namespace) -> bool:
    """Prints how many processes won the races; returns whether each race had one winner."""
    with tempfile.TemporaryDirectory() as name, Racers(is_honest=not options.file_as_lock) as racers:
        winners = Counter(
            racers.run(Path(name) / str(race // 10), kills_winner=race % 2 == 0).count("")
            for race in range(options.races)
        )
    print(f"{options.races} races; winners: " + ", ".join(f"{n} in {races}" for n, races in winners.items()))
    return set(winners) == {1}
