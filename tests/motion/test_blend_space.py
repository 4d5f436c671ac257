"""Blend spaces: laws of the weights, clips in step, and the way that is gone."""

import gaits
import locked_arrays
import numpy as np
import pytest
from scipy.interpolate import interp1d
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation
from statwalk.errors import ContentError
from statwalk.motion.blend_space import BlendSpace, check_places
from statwalk.motion.root import STANDING, extract
from statwalk.motion.single import Single

LINE = np.array([1.4, 0.0, 3.2])
PLANE = np.array([[0, 0], [0, 1.4], [0, 3.2], [-1, 0.5], [1.2, 0.4], [0, -1.0]])
GRID = np.stack(np.meshgrid(np.linspace(-2, 2, 81), np.linspace(-2, 4, 81)), -1).reshape(-1, 2)
TICK = 1 / 60


def single(clip):
    return Single(*extract(clip, gaits.HIPS, True))


def marks(downs):
    return tuple(zip(("left", "right"), downs, strict=True))


SPACE = BlendSpace(
    (single(gaits.WALK), single(gaits.RUN)),
    np.array([[1.2], [4.0]]),
    (0,),
    (marks(gaits.WALK_DOWN), marks(gaits.RUN_DOWN)),
    True,
)


def weights(points, places):
    """(N, K) of still clips at places (K, A), at points (N, A)."""
    still = Single(gaits.Clip("still", (), 0.0, gaits.REST), STANDING)
    count, axes = places.shape
    return BlendSpace((still,) * count, places, tuple(range(axes)), ((),) * count, True).weights(points)


def at(speed, count=1):
    return np.full((count, 1), float(speed))


def test_weights_along_a_line_are_linear_interpolation():
    points = np.linspace(-1, 5, 301)
    expected = interp1d(LINE, np.eye(3), axis=0)(points.clip(0, 3.2))
    assert weights(points[:, None], LINE[:, None]) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("k", range(3))
def test_on_a_place_of_the_line_its_clip_has_all_the_weight(k):
    assert weights(LINE[k : k + 1, None], LINE[:, None])[0].tolist() == np.eye(3)[k].tolist()


@pytest.mark.parametrize("k", range(len(PLANE)))
def test_on_a_place_of_the_plane_its_clip_has_all_the_weight(k):
    assert weights(PLANE[k : k + 1], PLANE)[0].tolist() == np.eye(len(PLANE))[k].tolist()


def test_weights_over_the_plane_are_not_negative_and_sum_to_1():
    found = weights(GRID, PLANE)
    assert (found >= 0).all()
    assert found.sum(1) == pytest.approx(1, abs=1e-12)


def test_weights_over_the_plane_are_continuous():
    """A hundredth of the way gives a hundredth of the change: no more than a slope that the nearest two
    places explain.
    """
    step = np.array([1e-4, 7e-5])
    change = np.abs(weights(GRID + step, PLANE) - weights(GRID, PLANE)).max()
    assert change < 4 * np.linalg.norm(step)


def test_weights_over_the_plane_are_those_of_johansens_formula():
    def influence(point, k):
        return min(
            1 - np.clip((point - PLANE[k]) @ (PLANE[j] - PLANE[k]) / np.sum((PLANE[j] - PLANE[k]) ** 2), 0, 1)
            for j in range(len(PLANE))
            if j != k
        )

    points = GRID[::97].clip(PLANE.min(0), PLANE.max(0))
    expected = np.array([[influence(point, k) for k in range(len(PLANE))] for point in points])
    assert weights(GRID[::97], PLANE) == pytest.approx(expected / expected.sum(1, keepdims=True))


def test_beyond_the_places_the_ends_hold():
    assert SPACE.weights(np.array([[-1e308], [1e308]])).tolist() == [[1, 0], [0, 1]]


@pytest.mark.parametrize("speed", [1.2, 1.7, 2.6, 3.9])
def test_a_lap_ends_when_the_mean_of_the_clips_says_to_the_tick(speed):
    """Through all markers: where the phase is after the whole ticks of a lap, by SciPy's root finder."""
    weight = (speed - 1.2) / 2.8
    lap = (1 - weight) * gaits.WALK.duration + weight * gaits.RUN.duration
    ticks, time, axes = int(lap / TICK), 0.0, at(speed)
    for _ in range(ticks):
        time += TICK * float(SPACE.rate(np.array([time]), np.array([TICK]), axes)[0])
    walk, run = (
        np.array([*downs, downs[0] + 1, downs[1] + 1]) for downs in (gaits.WALK_DOWN, gaits.RUN_DOWN)
    )
    lifted = interp1d(np.concatenate([walk - 1, walk[1:]]), np.concatenate([run - 1, run[1:]]))

    def mean(phase):
        return (1 - weight) * phase + weight * float(lifted(phase))

    gone = ticks * TICK / lap
    wanted = brentq(lambda phase: mean(phase) - mean(0.0) - gone, 0.0, 1.0 + 1e-9, xtol=1e-14)
    assert time / SPACE.duration == pytest.approx(wanted, abs=1e-9)


def test_a_lap_takes_the_weighted_mean_of_the_clips():
    mean = 0.75 * 1.0 + 0.25 * 0.6
    for time in (0.0, 0.3, 0.7):
        assert SPACE.rate(np.array([time]), np.array([mean]), at(1.9)) * mean == pytest.approx(SPACE.duration)


@pytest.mark.parametrize("time", [0.0, 0.3, 0.49, 0.7, 0.99])
def test_a_clip_that_is_alone_keeps_its_pace(time):
    """In a tick the run goes on by a tick, wherever the markers of the first clip lie."""
    after = time + TICK * SPACE.rate(np.array([time]), np.array([TICK]), at(4.0))[0]
    phases = SPACE.warps[1].lift(np.array([time, after]) / SPACE.duration)
    assert np.diff(phases) * 0.6 == pytest.approx([TICK], rel=1e-3)


@pytest.mark.parametrize("speed", [1.2, 1.9, 2.6, 3.7, 4.0])
@pytest.mark.parametrize(("foot", "down"), [(gaits.LEFT, 0.0), (gaits.RIGHT, 0.5)])
def test_feet_are_down_where_the_first_clip_says(speed, foot, down):
    times = np.arange(0, 1, 1e-3) * SPACE.duration
    height = SPACE.pose(times, at(speed, len(times))).translation[:, foot, 1]
    late = (times[height.argmin()] / SPACE.duration - down + 0.5) % 1 - 0.5
    assert abs(late) * SPACE.duration < TICK


def test_without_markers_the_same_gaits_are_out_of_step():
    deaf = BlendSpace(SPACE.motions, SPACE.places, SPACE.columns, ((), ()), True)
    times = np.arange(0, 1, 1e-3)
    height = deaf.pose(times, at(3.7, len(times))).translation[:, gaits.LEFT, 1]
    assert times[height.argmin()] > 3 * TICK


def test_at_a_place_the_pose_is_that_of_its_clip():
    pose = SPACE.pose(np.array([0.3]), at(1.2))
    expected = gaits.WALK.sample(0.3)
    assert pose.translation[0, 1:] == pytest.approx(expected.translation[1:], abs=1e-6)
    assert pose.rotation[0] == pytest.approx(expected.rotation, abs=1e-6)


def test_half_way_a_joint_is_turned_half_way():
    """Between two turns about one axis a normalised mean lies half way."""
    walk, run = (
        motion.clip.sample(phase * motion.clip.duration)
        for motion, phase in zip(SPACE.motions, (0.0, 0.2), strict=True)
    )
    angles = [Rotation.from_quat(pose.rotation[gaits.ARM]).as_euler("xyz")[0] for pose in (walk, run)]
    got = Rotation.from_quat(SPACE.pose(np.zeros(1), at(2.6)).rotation[0, gaits.ARM]).as_euler("xyz")[0]
    assert got == pytest.approx(sum(angles) / 2, abs=1e-5)


def test_three_rotations_do_not_depend_on_their_signs():
    angles = (-80, 10, 100)

    def clip(angle, sign):
        key = sign * gaits.turns("y", [angle])
        return single(
            gaits.Clip(
                "held", (gaits.Channel(gaits.ARM, "rotation", np.ones(1, np.float32), key),), 1.0, gaits.REST
            )
        )

    places = np.array([[0.0, 0], [1, 0], [0, 1]])
    poses = [
        BlendSpace(tuple(map(clip, angles, signs)), places, (0, 1), ((), (), ()), True).pose(
            np.zeros(1), np.array([[0.3, 0.4]])
        )
        for signs in ((1, 1, 1), (1, -1, -1))
    ]
    assert abs((poses[0].rotation * poses[1].rotation).sum(-1)) == pytest.approx(1, abs=1e-6)


def test_the_way_of_a_lap_is_the_weighted_mean_of_the_strides():
    way = SPACE.way(np.array([0.4]), np.array([0.4]), np.array([1]), at(1.9))
    assert way[0] == pytest.approx([0, 0.75 * 1.2 + 0.25 * 2.4, 0], abs=1e-6)


def test_ways_add_up():
    times = np.array([0.1, 0.35, 0.62, 0.99])
    parts = SPACE.way(times[:-1], times[1:], np.zeros(3, int), at(3, 3))
    whole = SPACE.way(times[:1], times[-1:], np.zeros(1, int), at(3))
    assert parts.sum(0) == pytest.approx(whole[0], abs=1e-9)


def test_one_actor_is_the_same_alone_and_in_a_crowd():
    rng = np.random.default_rng(3)
    times, speeds = rng.random(200), rng.uniform(0, 5, (200, 1))
    crowd = SPACE.pose(times, speeds)
    for row in (0, 77, 199):
        alone = SPACE.pose(times[row : row + 1], speeds[row : row + 1])
        assert all(one[0].tobytes() == many[row].tobytes() for one, many in zip(alone, crowd, strict=True))


def test_two_clips_at_one_place_are_refused():
    with pytest.raises(ContentError, match="walk and run stand at the same place"):
        check_places(np.array([[1.0], [1.0]]), ("walk", "run"))


def test_one_clip_is_no_blend():
    with pytest.raises(ContentError, match="two clips or more, not 1"):
        check_places(np.array([[1.0]]), ("walk",))


def test_its_places_cannot_be_written():
    locked_arrays.check(SPACE)
