"""Snapshots thin out with age, so that a night costs little memory and going back costs little time."""

import pytest
from builders import role
from statwalk.stage.fold import StageState
from statwalk.stage.past.snapshot import EVERY, Snapshots, size
from statwalk.stage.stage import Stage

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


@pytest.fixture(scope="module")
def crowd():
    stage = Stage()
    stage.add_many(role(), [((0, 0, number), 0) for number in range(50)])
    return stage.state


def of(state, ticks, most_bytes):
    snapshots = Snapshots(StageState(), most_bytes)
    for tick in range(0, ticks + 1, EVERY):
        snapshots.offer(StageState(tick=tick, casts=state.casts))
    return snapshots


def test_a_state_weighs_what_its_actors_do(crowd):
    poses = sum(array.nbytes for array in crowd.casts[0].shown)
    assert poses < size(crowd) < 20 * poses


def test_a_crowd_keeps_fewer_and_they_stay_within_bounds(crowd):
    snapshots = of(crowd, 100 * EVERY, 10 * size(crowd))
    assert snapshots.bytes <= 10 * size(crowd)
    assert len(snapshots) >= 5


def test_the_newest_stays_however_large(crowd):
    snapshots = of(crowd, 100 * EVERY, 1)
    assert snapshots.nearest(100 * EVERY + 7).tick == 100 * EVERY
    assert len(snapshots) == 2


def test_a_fork_knows_what_its_past_weighs(crowd):
    assert of(crowd, 10 * EVERY, 1 << 30).until(5 * EVERY).bytes == 5 * size(crowd)
