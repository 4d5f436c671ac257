"""R-07: a day of a stage at 60 Hz with ten inputs a second, as fast as it goes; prints what it takes."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from long_life import Life, Restart, lived
from statwalk.services.limits import Limits

DAY_TICKS = 24 * 60 * 60 * 60
PRINT_TICKS = 200_000
LONGEST_RESTART_SECONDS = 2.0


def add_options(parser: argparse.ArgumentParser) -> None:
    """Adds the options of this check."""
    parser.add_argument("--ticks", type=int, default=DAY_TICKS)
    parser.add_argument("--every", type=int, default=6, help="ticks from an input to the next, about")
    parser.add_argument("--entries", type=int, default=Limits().entries, help="that the log holds at most")
    parser.add_argument("--never-forgets", action="store_true", help="the control: the disk fills up")


def main(options: argparse.Namespace) -> bool:
    """Lives a day; returns whether the log stayed bounded, and the stage came back in 2 s as it was."""
    life = Life(options.ticks, options.every, options.entries, not options.never_forgets)
    disk, is_bounded = 0, True
    with tempfile.TemporaryDirectory() as folder:
        for each in lived(Path(folder), life):
            if isinstance(each, Restart):
                print(
                    f"back after {each.seconds:.2f} s, {'as' if each.is_the_same else 'NOT as'} it was; the "
                    f"slowest of ten seeks took {each.slowest_seek:.2f} s"
                )
                return is_bounded and each.is_the_same and each.seconds <= LONGEST_RESTART_SECONDS
            is_bounded, disk = is_bounded and each.held <= life.entries, max(disk, each.disk)
            if each.tick % PRINT_TICKS == 0:
                print(
                    f"tick {each.tick:,}: {each.inputs:,} inputs, {each.held:,} in the log, which begins at "
                    f"{each.first:,}; at most {disk / 1e6:.1f} MB on the disk; slowest input "
                    f"{each.slowest * 1e3:.0f} ms",
                    flush=True,
                )
    return False
