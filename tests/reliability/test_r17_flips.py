"""R-17: a bit of the database flips, or its end is gone: no stage is silently another one."""

from pathlib import Path

import pytest
from flips_folder import REPORTED, WHOLE, outcomes
from statwalk.services.library.catalogue import Catalogue

DAMAGES = range(24)


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


def test_r17_each_stage_is_what_it_was_or_reported(tmp_path: Path, catalogue: Catalogue) -> None:
    found = list(outcomes(tmp_path, DAMAGES, catalogue))
    assert [(seed, wrong) for seed, _, wrong in found if wrong] == []
    assert {what for _, what, _ in found} == {REPORTED, WHOLE}
