"""The compiled tables of motions against the slow form in NumPy: poses, pace and root motion, alone and in a
block.
"""

import os
import subprocess
import sys

import gaits
import numpy as np
import pytest
import slow_motions as slow
from random_motions import ACTORS, REST, blocks, crowd, motions, walks
from statwalk.maths.pose import Pose
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.motion.clip import Channel, Clip
from statwalk.motion.keys.segment_kinds import LOOSE
from statwalk.motion.root import STANDING
from statwalk.motion.sampling.poses import poses_at
from statwalk.motion.single import Single
from statwalk.motion.tables import lane_groups
from statwalk.motion.tables.build import tables_of


def assert_alike(got: Pose, expected: Pose) -> None:
    for one, other in zip(got, expected, strict=True):
        assert np.abs(one - other).max(initial=0) <= 2e-6 * max(1, np.abs(other).max(initial=0))


@pytest.mark.parametrize("in_step", [True, False], ids=["the same key times", "different key times"])
def test_actors_in_blocks_have_the_poses_of_their_motions(in_step):
    played, (states, times, parameters) = motions(in_step), crowd()
    poses = blocks(tables_of(played, REST), states, times, parameters).poses()
    for row, state in enumerate(states[:, 1]):
        motion = None if state < 0 else played[state]
        if motion is None:
            expected = Pose(*(array[None] for array in REST))
        else:
            expected = slow.pose(motion, times[row : row + 1, 1], parameters[row : row + 1])
        assert_alike(poses.take(slice(row, row + 1)), expected)


@pytest.mark.parametrize("state", [0, 1, 2, 4, 5])
def test_a_motion_begins_with_its_first_pose(state):
    motion, parameters = motions(in_step=True)[state], crowd()[2]
    got = poses_at(motion.tables, REST, np.zeros(ACTORS), parameters, start=True)
    assert_alike(got, slow.first(motion, parameters))


def test_lanes_that_share_no_key_times_take_little_memory_and_the_same_poses(monkeypatch):
    """As if there were no room: every group whose lanes have different key times is searched lane by lane."""
    roomy = tables_of(motions(in_step=False), REST)
    monkeypatch.setattr(lane_groups, "ROOM", 0)
    tables = tables_of(motions(in_step=False), REST)
    assert (tables.groups[:, 5] == LOOSE).sum() > 20
    assert tables.values.nbytes < roomy.values.nbytes / 2
    assert_alike(blocks(tables, *crowd()).poses(), blocks(roomy, *crowd()).poses())


def test_an_actor_has_the_same_bits_in_every_lane_of_every_block():
    tables, (states, times, parameters) = tables_of(motions(in_step=False), REST), crowd()
    together = blocks(tables, states, times, parameters).rows()
    order = np.random.default_rng(2).permutation(ACTORS)
    mixed = blocks(
        tables, *(np.ascontiguousarray(part[order]) for part in (states, times, parameters))
    ).rows()
    assert mixed.tobytes() == together[order].tobytes()
    for row in range(ACTORS):
        alone = blocks(tables, states[row : row + 1], times[row : row + 1], parameters[row : row + 1])
        assert alone.rows().tobytes() == together[row].tobytes()


def test_lanes_without_an_actor_rest():
    values = blocks(tables_of(motions(in_step=True), REST), *crowd()).values
    at_rest = PoseBuffer.at_rest(REST, 1).values[0]
    assert values[-1][:, ACTORS % 16 :].tobytes() == at_rest[:, ACTORS % 16 :].tobytes()


def test_what_no_motion_changes_is_in_no_packed_row():
    one = Channel(
        1, "translation", np.array([0, 1], np.float32), np.array([[0, 0, 0], [3, 0, 0]], np.float32)
    )
    tables = tables_of((Single(Clip("one", (one,), 1.0, REST), STANDING),), REST)
    assert tables.width == 16
    assert set((tables.layout[2:] // 16).tolist()) == {10, 11, 12}


@pytest.mark.parametrize("state", [4, 5])
def test_rates_are_those_of_the_slow_form_to_the_bit(state):
    motion, (_, times, parameters) = motions(in_step=True)[state], crowd()
    seconds = np.full(ACTORS, 1 / 60)
    assert (
        motion.rate(times[:, 0], seconds, parameters).tobytes()
        == slow.rate(motion, times[:, 0], seconds, parameters).tobytes()
    )


@pytest.mark.parametrize("number", range(3), ids=["blend space", "loop", "once"])
def test_ways_are_those_of_the_slow_form_to_the_bit(number):
    rng, motion = np.random.default_rng(4), walks()[number]
    given = rng.random(200), rng.random(200), rng.integers(0, 4, 200), rng.uniform(0, 5, (200, 1))
    assert motion.way(*given).tobytes() == slow.way(motion, *given).tobytes()


def test_the_same_clip_twice_is_stored_once():
    walk = walks()[1]
    tables = tables_of((walk, walk, None), gaits.REST)
    assert len(tables.clips) == 2  # the rest pose and the walk
    assert tables.states[:, 1].tolist() == [1, 1, 0]


def test_tables_cannot_be_written():
    assert not any(array.flags.writeable for array in tables_of(walks(), gaits.REST))


PLAIN = """
import sys
import numpy as np
from statwalk.maths.blending import rate
from statwalk.motion.sampling.root_motion import way
from statwalk.motion.tables.motion_tables import MotionTables

with np.load(sys.argv[1]) as file:
    tables, given = MotionTables(*(file[name] for name in MotionTables._fields)), file["given"]
memory = np.zeros(2)
for start, end, wraps, speed in given.tolist():
    row = tables, 0, start, 1 / 60, np.array([[speed]]), 0, memory
    parts = way(tables, 0, start, end, int(wraps), *row[4:])
    print(float(rate(*row)).hex(), *(float(part).hex() for part in parts))
"""


def test_pace_and_root_motion_are_the_same_without_a_compiler(tmp_path):
    """What is written per actor runs as plain Python, too, and gives the same bits."""
    rng, motion = np.random.default_rng(8), walks()[0]
    given = np.stack([rng.random(20), rng.random(20), rng.integers(0, 3, 20), rng.uniform(0, 5, 20)], -1)
    np.savez(tmp_path / "motions.npz", given=given, **motion.tables._asdict())
    environment = {
        **os.environ,
        "STATWALK_COMPILED": "0",
        "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
    }
    command = [sys.executable, "-c", PLAIN, str(tmp_path / "motions.npz")]
    told = subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout.split()
    start, end, wraps, speeds = given.T
    factors = motion.rate(start, np.full(20, 1 / 60), speeds[:, None])
    ways = motion.way(start, end, wraps.astype(np.int64), speeds[:, None])
    assert told == [float(number).hex() for number in np.column_stack([factors, ways]).ravel()]
