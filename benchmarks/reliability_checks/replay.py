"""R-05: recorded sessions played again in other circumstances: each tick must have the hash that it had."""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

from live_sessions import live
from planted import FAULTS
from random_sessions import CONTENTS, session
from replay_rows import (
    ROWS,
    Hashes,
    Row,
    crowd_differences,
    differences,
    elsewhere,
    in_threads,
    logs,
    one_by_one,
)

OF_A_SERVER = 20
"""live stages of one server"""


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--sessions", type=int, default=1_000)
    command.add_argument("--ticks", type=int, default=300, help="of a session, at least")
    command.add_argument("--seed", type=int, default=1, help="of the first session of each machine")
    command.add_argument(
        "--live", type=int, default=100, help="stages in real time, killed and started again"
    )
    command.add_argument("--viewers", type=int, default=50, help="of the first stage of each server")
    command.add_argument(
        "--fault", default="", choices=("", *FAULTS), help="the control: a step that is wrong"
    )
    command.add_argument("--row", action="append", choices=[*ROWS, "crowd", "live"], help="only these rows")


def main(options: argparse.Namespace) -> bool:
    """Prints for each row how many sessions differ; returns whether none does."""
    wanted = options.row or [*ROWS, "crowd", "live"]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        hashes = _recorded(folder, options)
        found = [_row(row, folder, hashes, options.fault) for row in ROWS if row in wanted]
        found += [_crowd(folder)] if "crowd" in wanted else []
    found += [_live(options)] if "live" in wanted else []
    return not any(found)


def _recorded(folder: Path, options: argparse.Namespace) -> Hashes:
    """Records the sessions; what they are compared with is played by a process like those of the rows."""
    for number in range(options.sessions):
        content, seed = CONTENTS[number % len(CONTENTS)], options.seed + number // len(CONTENTS)
        lines = session(content, seed, options.ticks).dump()
        (folder / f"{content}-{seed}.jsonl").write_text("\n".join(lines))
    hashes = elsewhere(folder, Row(), options.fault) if options.fault else one_by_one(logs(folder))
    ticks = sum(map(len, hashes.values()))
    print(f"{len(hashes)} sessions, {ticks:,} ticks; the seed of the first is {options.seed}", flush=True)
    return hashes


def _row(name: str, folder: Path, hashes: Hashes, fault: str) -> int:
    begun, row = time.monotonic(), ROWS[name]
    is_here = row.how == "threads" and not fault
    found = differences(in_threads(logs(folder)) if is_here else elsewhere(folder, row, fault), hashes)
    return _said(name, len(hashes), found, begun)


def _crowd(folder: Path) -> int:
    begun, sessions = time.monotonic(), logs(folder)
    return _said("alone and in a crowd", len(sessions), crowd_differences(sessions.items()), begun)


def _live(options: argparse.Namespace) -> int:
    """Servers one after the other, each with machines in turn; scenes are left to the other rows."""
    begun, machines = time.monotonic(), [name for name in CONTENTS if not name.startswith("scene-")]
    wrong, stages, frames = [], 0, 0
    while stages < options.live:
        count = min(OF_A_SERVER, options.live - stages)
        contents = [machines[(stages + k) % len(machines)] for k in range(count)]
        with tempfile.TemporaryDirectory() as folder:
            found = live(Path(folder), contents, options.seed + stages, options.viewers)
        wrong, stages, frames = wrong + found.wrong, stages + found.stages, frames + found.frames
    return _said(f"live, killed, {options.viewers} viewers or one, {frames:,} frames", stages, wrong, begun)


def _said(name: str, count: int, found: list[str], begun: float) -> int:
    seconds = time.monotonic() - begun
    print(f"{name}: {count} sessions, {len(found)} differ ({seconds:.0f} s)", flush=True)
    for each in found[:10]:
        print(f"  {each}")
    return len(found)
