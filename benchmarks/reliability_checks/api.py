"""R-10: generated API calls, in rounds with one seed after the other."""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import Counter
from pathlib import Path

from api_fuzz import Findings, fuzz, fuzzed_app

EXAMPLES = 30
"""random requests of each operation in a round"""


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--cases", type=int, default=50_000, help="at least so many calls")
    command.add_argument("--seed", type=int, default=1, help="of the first round")
    command.add_argument("--minutes", type=float, default=600.0, help="starts no further round after them")
    command.add_argument("--quick", action="store_true", help="without the operations that take long")


def main(options: argparse.Namespace) -> bool:
    """Prints what came back; returns whether every answer was described, and none was a defect."""
    found, until, seed = Findings(), time.monotonic() + 60 * options.minutes, options.seed
    while found.cases < options.cases and time.monotonic() < until:
        with tempfile.TemporaryDirectory() as folder, fuzzed_app(Path(folder)) as app:
            round_ = fuzz(app, seed, EXAMPLES, quick=options.quick)
        found.add(round_)
        print(f"seed {seed}: {round_.cases} calls, {len(round_.failures)} failures", flush=True)
        for failure in sorted(set(round_.failures))[:20]:
            print(f"  {failure}")
        seed += 1
    statuses: Counter[int] = Counter()
    for (_, status), count in found.statuses.items():
        statuses[status] += count
    print(f"{found.cases} calls, {len(found.failures)} failures")
    print(f"answers by status: {dict(sorted(statuses.items()))}")
    return not found.failures
