"""Offsets of the pose in lanes against the NumPy form, through random lives in which one layer of an actor
changes at a time, and their laws. (Layers that change together: `tests/stage/test_layers_change_together`.)
"""

import lane_kernels
import numpy as np
import pytest
import slow_inertialize
import slow_layers
from crowds import (
    ACTORS,
    DT,
    JOINTS,
    LAYER_MASKS,
    LAYERS,
    MASKS,
    NEVER,
    REST,
    SIZE,
    WEIGHTS,
    Crowd,
    life,
    lived,
    poses,
)
from scipy.spatial.transform import Rotation
from slow_offsets import Beginning, Fading
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.stage.state.pose_offsets import PoseOffsets, Transitions
from statwalk.stage.steps import offset_begin

MOVED = np.stack([slow_layers.offsets(mask, JOINTS, WEIGHTS) for mask in MASKS])


class Reference:
    """The same with NumPy."""

    def __init__(self, shown, before):
        self.shown, self.before, self.fading = shown, before, Fading.none(len(shown.rotation), LAYERS, SIZE)
        self.way = np.zeros((len(shown.rotation), 3))

    def tick(self, new, following, seconds, quintic, way):
        rows = np.flatnonzero((seconds > 0).any(1))
        if len(rows):
            taken = (pose.take(rows) for pose in (self.before, self.shown, new, following))
            offset, rate = slow_inertialize.transition(*taken, DT)
            beginning = Beginning(rows, np.maximum(seconds[rows], 0), quintic[rows], offset, rate)
            self.fading = self.fading.begun(beginning, MOVED, self.way[rows], DT)
        self.fading = self.fading.advanced(DT)
        self.way = self.fading.blended_way(way)
        self.before, self.shown = self.shown, self.fading.on(new)
        return self.shown


@pytest.mark.parametrize("seed", range(3))
def test_random_lives_are_those_of_numpy(seed):
    rng = np.random.default_rng(seed)
    shown, before = poses(rng), poses(rng)
    crowd, reference = Crowd(shown, before), Reference(shown, before)
    for coming in life(rng, 60):
        found, expected = crowd.tick(*coming), reference.tick(*coming)
        for ours, theirs in zip(found, expected, strict=True):
            sign = np.sign((ours * theirs).sum(-1, keepdims=True)) if ours.shape[-1] == 4 else 1
            assert ours == pytest.approx(sign * theirs, abs=2e-4)
        assert crowd.way == pytest.approx(reference.way, abs=1e-12)


@pytest.mark.parametrize("rows", [[18], [3, 18, 7], list(range(20, -1, -1))])
def test_a_lane_and_its_neighbours_do_not_matter(rows):
    crowd, own = lived(np.arange(ACTORS)), lived(np.array(rows))
    assert own.shown.rows().tobytes() == crowd.shown.take(np.array(rows)).rows().tobytes()
    kept = crowd.offsets.take(np.array(rows))
    assert [array.tobytes() for array in own.offsets.rows()] == [array.tobytes() for array in kept.rows()]


def at_rest(actors=1):
    rng = np.random.default_rng(3)
    return poses(rng, actors), poses(rng, actors)


def test_an_offset_at_its_beginning_shows_what_was_shown():
    """At the tick before, new motion and offset together are what was shown."""
    shown, new = at_rest(ACTORS)
    crowd = Crowd(shown, shown)
    seconds = np.tile([0.2, NEVER, NEVER], (ACTORS, 1))
    arguments = Transitions(seconds, seconds > 9), LAYER_MASKS
    buffers = (crowd.before.values, crowd.shown.values, *(PoseBuffer.of(REST, new).values for _ in range(2)))
    crowd.offsets = crowd.offsets.grown(6)
    offset_begin.begin(crowd.offsets, *arguments, *buffers, crowd.way, DT, 0, crowd.scratch)
    coming = PoseBuffer.of(REST, new)
    lane_kernels.add(crowd.offsets, LAYER_MASKS, coming.values, crowd.scratch)
    found = coming.poses()
    assert found.translation == pytest.approx(shown.translation, abs=1e-6)
    turns = (
        Rotation.from_quat(found.rotation.reshape(-1, 4))
        * Rotation.from_quat(shown.rotation.reshape(-1, 4)).inv()
    )
    assert turns.magnitude().max() < 2e-6
    assert np.linalg.norm(found.rotation, axis=-1) == pytest.approx(1, abs=1e-6)


def test_when_it_is_over_only_the_motion_is_shown_bit_for_bit_and_the_slot_is_free_again():
    shown, new = at_rest()
    crowd = Crowd(shown, shown)
    crowd.tick(new, new, np.array([[0.1, NEVER, NEVER]]))
    assert (crowd.offsets.slot >= 0).sum() == 1
    for _ in range(6):
        found = crowd.tick(new, new, np.full((1, 3), NEVER))
    assert all((ours == theirs).all() for ours, theirs in zip(found, new, strict=True))
    assert (crowd.offsets.slot < 0).all()
    assert crowd.offsets.free_count[0] == len(crowd.offsets.start)


def test_what_a_fading_layer_does_not_move_keeps_its_bits():
    shown, new = at_rest(ACTORS)
    found = Crowd(shown, shown).tick(new, new, np.tile([NEVER, NEVER, 0.2], (ACTORS, 1)))
    for ours, theirs in zip(found[:3], new[:3], strict=True):
        assert (ours[:, :3] == theirs[:, :3]).all()
        assert (ours[:, 3] != theirs[:, 3]).any()
    assert (found.weights == new.weights).all()


def test_position_and_velocity_go_on():
    rng = np.random.default_rng(2)
    shown, new = at_rest()
    velocity, other = rng.normal(size=(2, 1, SIZE)).astype(np.float32)
    crowd = Crowd(shown, slow_inertialize.add(shown, -velocity * np.float32(DT)))
    found = crowd.tick(
        new, slow_inertialize.add(new, other * np.float32(DT)), np.array([[0.2, NEVER, NEVER]])
    )
    difference = slow_inertialize.difference(found, shown)
    left = np.abs(slow_inertialize.difference(shown, new)).max() * 4 / 0.04 + 60
    assert np.abs(difference / DT - velocity).max() < left * DT


def test_taken_appended_and_stored_offsets_are_the_same():
    crowd = lived(np.arange(ACTORS))
    parts = [crowd.offsets.take(rows) for rows in (np.arange(9), np.arange(9, ACTORS))]
    whole = parts[0].append(parts[1])
    stored = PoseOffsets.of_rows(crowd.offsets[5:], *crowd.offsets.rows())
    for other in (
        whole,
        stored,
        crowd.offsets.copy(),
        crowd.offsets.grown(),
        crowd.offsets.with_layers(range(LAYERS)),
    ):
        assert [array.tobytes() for array in other.rows()] == [
            array.tobytes() for array in crowd.offsets.rows()
        ]
        shown = [PoseBuffer.of(REST, poses(np.random.default_rng(1))) for _ in range(2)]
        for offsets, buffer in zip((other, crowd.offsets), shown, strict=True):
            lane_kernels.add(offsets, LAYER_MASKS, buffer.values, crowd.scratch)
        assert shown[0].rows().tobytes() == shown[1].rows().tobytes()


def test_one_transition_in_the_place_of_all():
    """As at an edit: what was fading is ended, and the base fades from what was shown, on all joints."""
    crowd = lived(np.arange(ACTORS))
    reference = Fading.none(ACTORS, LAYERS, SIZE)
    before, shown, new = crowd.before.poses(), crowd.shown.poses(), poses(np.random.default_rng(9))
    crowd.offsets.end(np.arange(ACTORS))
    found = crowd.tick(new, new, np.tile([0.2, NEVER, NEVER], (ACTORS, 1)))
    jump = slow_inertialize.transition(before, shown, new, new, DT)
    expected = (
        reference.replaced(np.arange(ACTORS), np.full(ACTORS, 0.2), jump, crowd.way).advanced(DT).on(new)
    )
    assert found.translation == pytest.approx(expected.translation, abs=1e-4)
    assert np.abs((found.rotation * expected.rotation).sum(-1)) == pytest.approx(1, abs=1e-5)


def test_layers_may_change_places():
    crowd = lived(np.arange(ACTORS))
    turned = crowd.offsets.with_layers([0, 2, -1, 1])
    assert turned.elapsed[:, [0, 1, 3]].tolist() == crowd.offsets.elapsed[:, [0, 2, 1]].tolist()
    assert not turned.is_under_way[:, 2].any()
    back = turned.with_layers([0, 3, 1])
    assert [array.tobytes() for array in back.rows()] == [array.tobytes() for array in crowd.offsets.rows()]


def test_there_is_room_for_all_that_may_begin():
    """Forty actors are three blocks; in each of theirs, actors may begin a transition in both layers."""
    none = PoseOffsets.none(40, 2, SIZE)
    two_blocks = none.with_room(np.array([0, 1, 17]))
    assert (len(two_blocks.start), two_blocks.free_count.tolist()) == (4, [4])
    assert two_blocks.with_room(np.array([3, 39, 39, 2])) is two_blocks
    two_blocks.free_count[0] = 1  # three slots are taken
    more = two_blocks.with_room(np.array([5]))
    assert (len(more.start), more.free_count.tolist()) == (8, [5])
    assert sorted(more.free[:5].tolist()) == [0, 4, 5, 6, 7]
