"""Snapshots thin out with age, so that a night costs little memory and going back costs little time."""

from statwalk.stage.fold import StageState
from statwalk.stage.snapshot import EVERY, Snapshots

NIGHT = 8 * 60 * 60 * 60  # ticks of eight hours


def after(ticks):
    snapshots = Snapshots(StageState())
    for tick in range(0, ticks + 1, EVERY):
        snapshots.offer(StageState(tick=tick))
    return snapshots


def test_a_night_leaves_few():
    assert len(after(NIGHT)) < 150


def test_the_last_quarter_of_a_minute_is_dense():
    snapshots = after(NIGHT)
    assert all(tick - snapshots.nearest(tick).tick < EVERY for tick in range(NIGHT - 15 * EVERY, NIGHT, 7))


def test_the_gap_grows_with_age_only():
    snapshots = after(NIGHT)
    for age in (10_000, 100_000, NIGHT - 5):
        tick = NIGHT - age
        assert tick - snapshots.nearest(tick).tick <= max(EVERY, age / 7)


def test_tick_zero_is_always_there():
    assert after(NIGHT).nearest(1).tick == 0


def test_a_fork_has_only_its_past():
    fork = after(600).until(300)
    assert fork.nearest(600).tick == 240
