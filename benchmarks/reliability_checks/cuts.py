"""R-18: inputs through a proxy that cuts connections at random bytes; each counts once."""

from __future__ import annotations

import argparse
import asyncio

from processes import served
from retries import retried

LIMITS = ("inputs", "stage_inputs", "requests", "stage_requests", "entries", "tick_entries")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Adds the options of this check."""
    parser.add_argument("--inputs", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--without-keys", action="store_true", help="the control: some inputs count twice")


def main(options: argparse.Namespace) -> bool:
    """Prints what was sent and what counted; returns whether every input counted once."""
    limits = [word for name in LIMITS for word in ("--limit", f"{name}={10 * options.inputs}")]
    with served(*limits) as (_, address):
        outcome = asyncio.run(
            retried(address, options.inputs, options.seed, has_keys=not options.without_keys)
        )
    logged = set(outcome.logged)
    lost = sum(number not in logged for number in outcome.answered.values())
    print(
        f"{options.inputs:,} inputs in {outcome.sent:,} requests, {outcome.cuts:,} connections cut: "
        f"{len(outcome.logged):,} in the log, {lost} lost, {len(outcome.logged) - options.inputs} too many, "
        f"{outcome.different} answered with another number"
    )
    return sorted(outcome.logged) == sorted(outcome.answered.values()) and not outcome.different
