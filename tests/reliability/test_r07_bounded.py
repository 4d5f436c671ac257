"""R-07: a stage that lives long takes no more of the disk, and comes back as fast, whatever its age."""

from pathlib import Path

from long_life import Life, Restart, Sample, lived

LIFE = Life(ticks=12_000, every=2, entries=600)


def life(folder: Path, forgets: bool) -> tuple[list[Sample], Restart]:
    *samples, restart = lived(folder, LIFE._replace(forgets=forgets))
    assert isinstance(restart, Restart)
    return [sample for sample in samples if isinstance(sample, Sample)], restart


def growth(samples: list[Sample]) -> int:
    """Bytes on the disk in the last quarter of a life beyond those in the second one, at most."""
    quarter = len(samples) // 4
    early, late = samples[quarter : 2 * quarter], samples[-quarter:]
    return max(each.disk for each in late) - max(each.disk for each in early)


def test_the_log_and_the_disk_stay_bounded_and_the_stage_comes_back(tmp_path: Path) -> None:
    samples, restart = life(tmp_path, forgets=True)
    assert all(sample.held <= LIFE.entries for sample in samples)
    assert samples[-1].inputs > 9 * LIFE.entries
    assert growth(samples) < 20_000
    assert restart.is_the_same


def test_a_server_that_never_forgets_on_the_disk_is_found_out(tmp_path: Path) -> None:
    samples, restart = life(tmp_path, forgets=False)
    assert growth(samples) > 200_000
    assert not restart.is_the_same
