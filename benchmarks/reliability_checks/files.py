"""R-09: mutated files of all formats are read whole or refused with a place, in this process and by a server
whose viewers must not notice.

    python benchmarks/reliability.py files --formats bvh x --each 500
    python benchmarks/reliability.py files --formats bvh --each 1 --first 4711 --uploads 0
"""

from __future__ import annotations

import argparse
import time
import traceback
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import ExitStack
from functools import partial
from typing import NamedTuple

import httpx
import numpy as np
from driving import driving
from hostile_captures import HOSTILE_CAPTURES
from load_process import LoadProcess, Seen, viewers_in_a_process
from paths import ASSETS
from processes import served
from serving import PATIENCE
from torture.mutators import MUTATORS
from torture.outcomes import memory
from viewer_figures import intervals

MAIN = "/api/stages/main"
WARM = 200
"""files after which memory is measured first"""
UPLOADED = ("gltf", "gltf-detail", "chunk", "chunk-detail", "x", "md2", "bvh", "trc")
"""the formats of files that the server takes as characters"""
AT_A_TIME = 4
QUIET_SECONDS = 20.0
MORE_MILLISECONDS, MORE_BYTES, LONGEST_SECONDS = 5.0, 64 << 20, 10.0
BINARY = {"content-type": "application/octet-stream"}


class Read(NamedTuple):
    """What came of the mutated files of a format."""

    name: str
    results: Counter[str]
    slowest: tuple[float, int]
    """seconds, and the seed"""
    more: int
    """bytes of memory, after the first `WARM` files"""
    broken: list[str]


class Put(NamedTuple):
    """How a server answered one file."""

    status: int
    seconds: float
    fault: str


def add_options(command: argparse.ArgumentParser) -> None:
    """Adds the options of the check."""
    command.add_argument("--formats", nargs="*", choices=MUTATORS, default=list(MUTATORS))
    command.add_argument("--each", type=int, default=7_000, help="files of each format")
    command.add_argument("--first", type=int, default=0, help="the first seed")
    command.add_argument("--processes", type=int, default=2)
    command.add_argument("--uploads", type=int, default=1_000, help="files that are put to a server")
    command.add_argument("--viewers", type=int, default=50)


def main(options: argparse.Namespace) -> bool:
    """Prints what came of the files, and returns whether each was read whole or refused with a place."""
    with ProcessPoolExecutor(options.processes) as pool:
        read_them = partial(read_all, first=options.first, count=options.each)
        broken = sum([_said(one) for one in pool.map(read_them, options.formats)])
    print(f"{options.each * len(options.formats):,} files read, {broken} broken")
    return not broken + (_put_beside_viewers(options) if options.uploads else 0)


def read_all(name: str, first: int, count: int) -> Read:
    """Reads the files of so many seeds."""
    mutator, results, slowest, broken = MUTATORS[name], Counter[str](), (0.0, 0), list[str]()
    before = memory()
    for seed in range(first, first + count):
        data, start = mutator.mutated(seed), time.perf_counter()
        try:
            with np.errstate(all="ignore"):
                results[mutator.outcome(data)] += 1
        except Exception:
            broken.append(f"{name}, seed {seed}:\n{traceback.format_exc(limit=-4)}")
        slowest = max(slowest, (time.perf_counter() - start, seed))
        before = memory() if seed == first + WARM else before
    return Read(name, results, slowest, memory() - before, broken)


def _said(read: Read) -> int:
    for text in read.broken:
        print(text)
    print(
        f"{read.name:16}{dict(read.results)}, {len(read.broken)} broken; slowest {read.slowest[0]:.2f} s "
        f"(seed {read.slowest[1]}); memory {read.more / 2**20:+.0f} MiB",
        flush=True,
    )
    return len(read.broken)


def _files(count: int, first: int) -> list[bytes]:
    """Returns malformed files from the assets, if they are there, hostile captures, and mutated files."""
    kinds = (".glb", ".gltf", ".md2", ".bvh")
    listed = [path.read_bytes() for path in sorted(ASSETS.glob("invalid/**/*")) if path.suffix in kinds]
    by_hand = [data for data, _ in HOSTILE_CAPTURES.values()]
    seeds = range(first, first + count // len(UPLOADED))
    mutated = [MUTATORS[name].mutated(seed) for seed in seeds for name in UPLOADED]
    return [*listed, *by_hand, *mutated]


def put(rest: httpx.Client, address: str, content: bytes) -> Put:
    """Puts a file, and returns how that was answered; `fault` is empty if it was answered in order."""
    began = time.perf_counter()
    answer = rest.put(address, content=content, headers=BINARY)
    seconds, fault = time.perf_counter() - began, ""
    if answer.status_code // 100 not in (2, 4) or seconds > LONGEST_SECONDS:
        fault = f"{answer.status_code} after {seconds:.1f} s"
    elif answer.is_error and "problem+json" not in answer.headers["content-type"]:
        fault = f"{answer.status_code} without a problem"
    return Put(answer.status_code, seconds, fault)


def _put_beside_viewers(options: argparse.Namespace) -> int:
    """Puts files to a server while others watch; prints how it went, and returns the number of faults."""
    files = _files(options.uploads, options.first)
    with ExitStack() as opened:
        process, address = opened.enter_context(served())
        rest = opened.enter_context(httpx.Client(base_url=f"http://{address}", timeout=PATIENCE))
        viewers = opened.enter_context(viewers_in_a_process(address, MAIN, options.viewers))
        opened.enter_context(driving(address, MAIN, 0.05))
        rest.get(f"{MAIN}/frame.glb").raise_for_status()  # compiles what memory is measured with
        with ThreadPoolExecutor(AT_A_TIME) as clients:
            put_one = lambda row: put(rest, f"/api/characters/x{row % AT_A_TIME}", files[row])  # noqa: E731
            list(clients.map(put_one, range(min(WARM, len(files)) // 10)))
            quiet, before = [_quiet(viewers)], memory(process.pid)
            answers = list(clients.map(put_one, range(len(files))))
            busy, after = viewers.seen(), memory(process.pid)
            quiet.append(_quiet(viewers))
        is_alive = process.poll() is None
    return _judged(answers, quiet, busy, after - before, is_alive)


def _quiet(viewers: LoadProcess) -> list[Seen]:
    """Returns what viewers see while no file is put."""
    viewers.seen()
    time.sleep(QUIET_SECONDS)
    return viewers.seen()


def _judged(
    answers: Sequence[Put], quiet: Sequence[list[Seen]], busy: list[Seen], more: int, is_alive: bool
) -> int:
    figures = intervals(busy)
    beside = [intervals(seen) for seen in quiet]
    late = figures.p99 - sum(one.p99 for one in beside) / len(beside)
    faults = [answer.fault for answer in answers if answer.fault]
    faults += ["the server is gone"] * (not is_alive)
    faults += [f"{more / 2**20:+.0f} MiB"] * (more > MORE_BYTES)
    faults += [f"frames {late:+.1f} ms late"] * (late > MORE_MILLISECONDS)
    statuses, slowest = Counter(answer.status for answer in answers), max(one.seconds for one in answers)
    print(
        f"{len(answers):,} files put: {dict(statuses)}, the slowest after {slowest:.1f} s; "
        f"memory {more / 2**20:+.0f} MiB\n"
        f"frames of others meanwhile {figures}, p99 {late:+.1f} ms beside the quiet ones\n"
        f"{'; '.join(faults) or 'all held'}"
    )
    return len(faults)
