"""Measures 100,000 actors of 67 joints on two cores: `python benchmarks/crowd.py`.

Two stages of 50,000 actors each are stepped at the same time, in two threads; compiled code holds no lock of
Python's. The script prints ticks a second, and the memory of an actor: what the process grew by, with the
snapshots that the ticks keep.
"""

from __future__ import annotations

import resource
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from time import perf_counter

from models import figure
from statwalk.character.role import Role
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage
from tick import MACHINE

ACTORS, THREADS, TICKS = 100_000, 2, 60


def half(role: Role) -> Stage:
    """Returns a stage of 50,000 actors; every second actor walks."""
    stage = Stage()
    count = ACTORS // THREADS
    actors = stage.add_many(
        role, [((float(place % 300), 0.0, float(place // 300)), 0.0) for place in range(count)]
    )
    for actor in actors[::2]:
        stage.send(actor, "GO")
    stage.step(3)
    return stage


def resident() -> int:
    """Returns the bytes that the process has in memory."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def main() -> None:
    """Prints the table."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        (folder / "figure.glb").write_bytes(figure(100))
        (folder / "machine.yaml").write_text(MACHINE)
        role = load_role(folder)
        before = resident()
        stages = [half(role) for _ in range(THREADS)]
        with ThreadPoolExecutor(THREADS) as pool:
            for threads, steps in ((1, stages[:1]), (THREADS, stages)):
                start = perf_counter()
                list(pool.map(lambda stage: stage.step(TICKS), steps))
                seconds = (perf_counter() - start) / TICKS
                actors = len(steps) * ACTORS // THREADS
                print(
                    f"{actors:,} actors of {len(role.character.skeleton)} joints on {threads} core"
                    f"{'s' * (threads > 1)}: {1 / seconds:.1f} ticks a second, "
                    f"{seconds / actors * 1e9 * threads:.0f} ns an actor and core"
                )
        print(f"memory: {(resident() - before) / ACTORS / 1024:.1f} KiB an actor, snapshots included")


if __name__ == "__main__":
    main()
