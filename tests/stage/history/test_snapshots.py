"""Snapshots thin out with age, so that a night costs little memory and going back costs little time."""

import pytest
from builders import role
from statwalk.stage.history.snapshots import EVERY, Snapshots
from statwalk.stage.history.state_codec import to_bytes
from statwalk.stage.stage import Stage
from statwalk.stage.state.stage_state import StageState

NIGHT = 8 * 60 * 60 * 60  # ticks of eight hours


def after(ticks):
    snapshots = Snapshots(StageState())
    for tick in range(0, ticks + 1, EVERY):
        snapshots.offer(StageState(tick=tick))
    return snapshots


@pytest.fixture(scope="module")
def night():
    return after(NIGHT)


def test_a_night_leaves_few(night):
    assert len(night) < 450


def test_the_last_quarter_of_a_minute_is_dense(night):
    assert all(tick - night.nearest(tick) < EVERY for tick in range(NIGHT - 15 * EVERY, NIGHT, 7))


def test_the_gap_grows_with_age_only(night):
    for age in (10_000, 100_000, NIGHT - 5):
        tick = NIGHT - age
        assert tick - night.nearest(tick) <= max(EVERY, age / 31)


def test_tick_zero_is_always_there(night):
    assert night.nearest(1) == 0


def test_a_fork_has_only_its_past():
    fork = after(600).until(300)
    assert fork.nearest(600) == 240


@pytest.fixture(scope="module")
def crowd():
    stage = Stage()
    stage.add_many(role(), [((0, 0, number), 0) for number in range(50)])
    return stage.state.copy()


def of(state, ticks, most_bytes):
    snapshots = Snapshots(StageState(), most_bytes)
    for tick in range(0, ticks + 1, EVERY):
        snapshots.offer(StageState(tick=tick, casts=state.casts))
    return snapshots


def weight(actors):
    """What a snapshot of so many actors adds to the empty one of tick 0."""
    stage = Stage()
    stage.add_many(role(), [((0, 0, number), 0) for number in range(actors)], ["Ada"] * actors)
    return of(stage.state, EVERY, 1 << 30).size - of(StageState(), EVERY, 1 << 30).size


def test_the_first_half_of_a_block_weighs_no_more_than_the_second():
    """Sixteen actors fill a block of poses; the seventeenth begins another."""
    first, second = weight(24) - weight(16), weight(32) - weight(24)
    assert abs(first - second) <= 8  # the header fills up to a multiple of 8 bytes


def test_a_snapshot_opens_to_the_state_that_was_kept(crowd):
    snapshots = of(crowd, EVERY, 1 << 30)
    opened = snapshots.open(EVERY, {role().name: role()})
    assert to_bytes(opened) == to_bytes(StageState(tick=EVERY, casts=crowd.casts))


def test_what_is_written_into_an_opened_snapshot_does_not_reach_it(crowd):
    snapshots, roles = of(crowd, EVERY, 1 << 30), {role().name: role()}
    before = snapshots.open(EVERY, roles)
    before.casts[role().name].machine.state[:] = 3
    before.casts[role().name].shown.values[:] = 0
    assert to_bytes(snapshots.open(EVERY, roles)) == to_bytes(StageState(tick=EVERY, casts=crowd.casts))


def test_a_crowd_keeps_fewer_and_they_stay_within_bounds(crowd):
    snapshots = of(crowd, 100 * EVERY, 10 * len(to_bytes(crowd)))
    assert snapshots.size <= 10 * len(to_bytes(crowd))
    assert len(snapshots) >= 5


def test_the_newest_stays_however_large(crowd):
    snapshots = of(crowd, 100 * EVERY, 1)
    assert snapshots.nearest(100 * EVERY + 7) == 100 * EVERY
    assert len(snapshots) == 2


def test_a_fork_knows_what_its_past_weighs(crowd):
    stage = of(crowd, 10 * EVERY, 1 << 30)
    written = [len(to_bytes(StageState(tick=tick, casts=crowd.casts))) for tick in range(0, 5 * EVERY, EVERY)]
    assert stage.until(5 * EVERY).size == sum(written)
