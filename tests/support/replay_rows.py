"""R-05: logs are played again in other circumstances, and every tick must have the hash that it had.

As a script, `python replay_rows.py FOLDER HOW [FAULT]`, it plays the logs of a folder and prints their
hashes.
"""

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from golden import hashes_of
from planted import planted
from random_sessions import role_of
from statwalk.stage.history.log_codec import load
from statwalk.stage.stage import Stage
from statwalk.stage.state.commands import Add, Edit

Hashes = dict[str, list[str]]
"""for each session its hash at every tick from 1 on"""
THREADS = 8
CROWD = 100
FAR = 1_000.0
"""metres between the actors of a crowd, so many that no actor touches or sees another"""
NO_AVX512 = "X86_V4 AVX512_ICL"
NO_AVX2 = f"X86_V3 {NO_AVX512}"


class Row(NamedTuple):
    """What is other than when the sessions were recorded."""

    how: str = "one"
    environment: dict[str, str] = {}  # noqa: RUF012 - nobody writes it


ROWS = {
    **{f"PYTHONHASHSEED={seed}": Row(environment={"PYTHONHASHSEED": seed}) for seed in ("0", "1", "random")},
    "8 threads": Row("threads"),
    "NumPy without AVX-512": Row(environment={"NPY_DISABLE_CPU_FEATURES": NO_AVX512}),
    "NumPy without AVX2": Row(environment={"NPY_DISABLE_CPU_FEATURES": NO_AVX2}),
    **{
        f"OPENBLAS_CORETYPE={core}": Row(environment={"OPENBLAS_CORETYPE": core})
        for core in ("Nehalem", "Haswell", "SkylakeX")
    },
    **{
        # empty, or numba adds the features of this processor
        f"compiled for {name}": Row(environment={"NUMBA_CPU_NAME": name, "NUMBA_CPU_FEATURES": ""})
        for name in ("generic", "haswell", "skylake-avx512")
    },
}


def logs(folder: Path) -> dict[str, list[str]]:
    return {
        path.stem: path.read_text(encoding="utf-8").splitlines() for path in sorted(folder.glob("*.jsonl"))
    }


def played(lines: list[str]) -> list[str]:
    """The hash of each tick of a log."""
    return [found for _, found in hashes_of(lines, role_of, every=1)]


def one_by_one(sessions: dict[str, list[str]]) -> Hashes:
    return {name: played(lines) for name, lines in sessions.items()}


def in_threads(sessions: dict[str, list[str]]) -> Hashes:
    """All sessions side by side in one process, with the same roles."""
    with ThreadPoolExecutor(THREADS) as threads:
        return dict(zip(sessions, threads.map(played, sessions.values()), strict=True))


HOW: dict[str, Callable[[dict[str, list[str]]], Hashes]] = {"one": one_by_one, "threads": in_threads}


def elsewhere(folder: Path, row: Row, fault: str = "") -> Hashes:
    """What a new process finds in the circumstances of a row."""
    environment = os.environ | row.environment | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    command = [sys.executable, __file__, str(folder), row.how, fault]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def differences(found: Hashes, expected: Hashes) -> list[str]:
    """Which sessions differ, and from which tick on."""
    assert found.keys() == expected.keys()
    return [
        f"{name} from tick {first_difference(found[name], hashes)} on"
        for name, hashes in expected.items()
        if found[name] != hashes
    ]


def first_difference(found: list[str], expected: list[str]) -> int:
    same = (k for k, pair in enumerate(zip(found, expected, strict=False), 1) if pair[0] != pair[1])
    return next(same, min(len(found), len(expected)) + 1)


# --- alone, and in a crowd


def can_be_alone(lines: list[str]) -> bool:
    """Whether its first actor is nobody's neighbour: flocks steer by each other."""
    names = {entry.command.role for entry in load(lines).entries if isinstance(entry.command, Add)}
    return all(role_of(name).definition.flock is None for name in names)


def actor_hashes(lines: list[str], crowd: int) -> list[str]:
    """The hashes of the first actor of a log with its inputs, alone or with a crowd far away of its role."""
    loaded = load(lines)
    first = loaded.entries[0].command
    assert isinstance(first, Add)
    stage = Stage(loaded.header["seed"], loaded.header["rate"])
    places = [((FAR * number, 0.0, FAR), float(number)) for number in range(crowd)]
    stage.add_many(role_of(first.role), [(first.position, first.heading), *places])
    inputs = [e for e in loaded.entries if e.actor == first.actor and not isinstance(e.command, (Add, Edit))]
    found = []
    for tick in range(1, loaded.header["head"] + 1):
        for entry in (entry for entry in inputs if entry.tick == tick):
            if type(entry.command).__name__ == "Remove":
                return found
            stage.keep(tick, entry.command)
        stage.step()
        found.append(stage.actor(1).hash)
    return found


def crowd_differences(sessions: Iterable[tuple[str, list[str]]], crowd: int = CROWD) -> list[str]:
    return [
        f"{name}, alone and among {crowd}"
        for name, lines in sessions
        if can_be_alone(lines) and actor_hashes(lines, 0) != actor_hashes(lines, crowd)
    ]


def main(folder: str, how: str, fault: str = "") -> None:
    with planted(fault):
        json.dump(HOW[how](logs(Path(folder))), sys.stdout)


if __name__ == "__main__":
    main(*sys.argv[1:])
