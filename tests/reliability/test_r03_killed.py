"""R-03: what was acknowledged survives `kill -9` at any instant: each input once, and in order.

`python benchmarks/reliability.py kills` does the same a thousand times.
"""

from pathlib import Path

import pytest
from killed import killed, logged, start_forks

KILLS = 12


@pytest.fixture(scope="module", autouse=True)
def _forks() -> None:
    start_forks()


@pytest.mark.parametrize("seed", range(KILLS))
def test_r03_what_was_acknowledged_is_there_once_and_in_order(tmp_path: Path, seed: int) -> None:
    stage, acknowledged = killed(tmp_path, seed)
    found = logged(tmp_path, stage)
    assert found[: len(acknowledged)] == acknowledged
    assert len(found) <= len(acknowledged) + 1  # the one whose answer was on its way


def test_r03_an_answer_before_the_disk_has_it_is_found_out(tmp_path: Path) -> None:
    """The control: of some kills at least one loses something."""

    def loses(seed: int) -> bool:
        folder = tmp_path / str(seed)
        stage, acknowledged = killed(folder, seed, is_honest=False)
        return logged(folder, stage)[: len(acknowledged)] != acknowledged

    assert any(map(loses, range(40)))
