"""R-05: the same inputs give the same states, bit for bit, in whatever circumstances they are played.

`python benchmarks/reliability.py replay` does the same with a thousand sessions and all rows.
"""

from pathlib import Path

import pytest
from live_sessions import live
from numpy._core._multiarray_umath import __cpu_features__
from planted import planted
from random_sessions import session
from replay_rows import (
    NO_AVX2,
    NO_AVX512,
    Hashes,
    Row,
    crowd_differences,
    differences,
    elsewhere,
    in_threads,
    logs,
    one_by_one,
)

SESSIONS = {"elbow": 5, "hand": 6, "tentacle": 7, "anchor-chain": 8, "scene-joints": 9, "faq-walker": 10}
TICKS = 120
OTHERWISE = {
    "PYTHONHASHSEED": "1",
    "NPY_DISABLE_CPU_FEATURES": NO_AVX2,
    "OPENBLAS_CORETYPE": "Nehalem",
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F",
}
"""an older processor, and another order of sets"""


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Hashes]:
    """Logs in a folder, and the hash of each of their ticks."""
    folder = tmp_path_factory.mktemp("sessions")
    for content, seed in SESSIONS.items():
        (folder / f"{content}.jsonl").write_text("\n".join(session(content, seed, TICKS).dump()))
    return folder, one_by_one(logs(folder))


def test_r05_another_processor_and_another_order_of_sets(recorded: tuple[Path, Hashes]) -> None:
    folder, hashes = recorded
    assert not differences(elsewhere(folder, Row(environment=OTHERWISE)), hashes)


def test_r05_eight_threads(recorded: tuple[Path, Hashes]) -> None:
    folder, hashes = recorded
    assert not differences(in_threads(logs(folder)), hashes)


def test_r05_alone_and_in_a_crowd(recorded: tuple[Path, Hashes]) -> None:
    assert not crowd_differences(logs(recorded[0]).items(), 40)


def test_r05_real_time_with_many_viewers_killed_and_started_again(tmp_path: Path) -> None:
    found = live(tmp_path, ["elbow", "hand"], seed=3, viewers=12)
    assert found.frames > 100
    assert not found.wrong


# --- controls


@pytest.fixture(scope="module")
def one_log(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("one")
    (folder / "elbow.jsonl").write_text("\n".join(session("elbow", 5, TICKS).dump()))
    return folder


def is_found_out(folder: Path, fault: str, **environment: str) -> bool:
    """Whether a step with a fault gives other states in another environment."""
    with planted(fault):
        hashes = one_by_one(logs(folder))
    return bool(differences(elsewhere(folder, Row(environment=environment), fault), hashes))


@pytest.mark.skipif(not __cpu_features__["X86_V4"], reason="this processor has no AVX-512 to switch off")
def test_r05_a_step_with_numpys_exponential_is_found_out(one_log: Path) -> None:
    assert is_found_out(one_log, "exp", NPY_DISABLE_CPU_FEATURES=NO_AVX512)


def test_r05_a_step_in_the_order_of_a_set_is_found_out(one_log: Path) -> None:
    """By at least one of three orders: one alone may happen to be that of this process."""
    assert any(is_found_out(one_log, "set", PYTHONHASHSEED=seed) for seed in ("1", "7731", "52"))
