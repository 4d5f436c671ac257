"""Kernels find every number of a pose where `PoseBuffer` puts it; and nobody else knows where that is."""

import re

import numpy as np
import pytest
from late_kernel import late_kernel
from paths import ROOT
from statwalk.maths.compiling import FLOAT, LONG, read, write
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.pose_layout import (
    ROTATION_CHANNEL,
    SCALE_CHANNEL,
    channel_of,
    end_row,
    first_channels,
    first_row,
    index_at,
    indices_in_block,
    joint_channel,
    place_of,
    weight_channel,
)

ACTORS, JOINTS, WEIGHTS = 21, 3, 2
CHANCE = np.random.default_rng(31)
POSES = Pose(
    *(CHANCE.normal(size=(ACTORS, *shape)) for shape in ((JOINTS, 3), (JOINTS, 4), (JOINTS, 3), (WEIGHTS,)))
)
DEFINES_THE_LAYOUT = re.compile(
    r"\b(?:LANES|WIDTH|\w*CHANNELS) = \d|\b10 \* \w*joint|\bLANES \* \(?block"
    r"|\b(?:rows?|actors?) (?://|%) (?:16|LANES)\b"
)


@late_kernel(read(FLOAT, 3), LONG, LONG, write(FLOAT, 1))
def read_joint(values, row, joint, out):
    """Translation, rotation and scale of a joint of an actor, then the morph weights."""
    block, lane = place_of(row)
    first = joint_channel(joint)
    for k in range(3):
        out[k] = values[block, first + k, lane]
        out[7 + k] = values[block, first + SCALE_CHANNEL + k, lane]
    for k in range(4):
        out[3 + k] = values[block, first + ROTATION_CHANNEL + k, lane]
    for weight in range(2):
        out[10 + weight] = values[block, weight_channel(3, weight), lane]


@late_kernel(read(FLOAT, 3), LONG, LONG, write(LONG, 1))
def numbers_of_block(values, block, channel, out):
    out[0], out[1] = first_row(block), end_row(block, out.shape[0])
    out[2], out[3] = index_at(values, block, channel), channel_of(index_at(values, 0, channel))


@pytest.mark.parametrize("row", [0, 15, 16, 20])
@pytest.mark.parametrize("joint", range(JOINTS))
def test_a_kernel_reads_what_the_buffer_holds(row, joint):
    out = np.zeros(12, np.float32)
    read_joint(PoseBuffer.of(rest(JOINTS, WEIGHTS), POSES).values, row, joint, out)
    expected = *(array[row, joint] for array in POSES[:3]), POSES.weights[row]
    assert out.tolist() == np.concatenate(expected).astype(np.float32).tolist()


def test_a_block_has_the_rows_of_its_lanes():
    values, out = np.zeros((2, 48, 16), np.float32), np.zeros(ACTORS, np.int64)
    numbers_of_block(values, 1, 5, out)
    assert out[:4].tolist() == [16, ACTORS, np.ravel_multi_index((1, 5, 0), values.shape), 5]


@pytest.mark.parametrize("path", ["translation", "rotation", "scale", "weights"])
def test_numpy_finds_the_channels_of_a_property(path):
    pose = Pose(*(array[0] for array in POSES))
    rows = PoseBuffer.of(rest(JOINTS, WEIGHTS), POSES.take([0])).values[0, :, 0]
    first = first_channels(path, np.arange(WEIGHTS), JOINTS)
    assert (
        rows[first].tolist()
        == getattr(pose, path)[:WEIGHTS].reshape(WEIGHTS, -1)[:, 0].astype(np.float32).tolist()
    )
    assert (indices_in_block(first) == 16 * first).all()


def test_no_other_module_computes_a_position():
    package = ROOT / "server" / "statwalk"
    own = {package / "maths" / "simd" / name for name in ("lanes.py", "pose_layout.py")}
    lines = [
        f"{path.name}: {line.strip()}"
        for path in sorted(package.rglob("*.py"))
        for line in path.read_text().splitlines()
        if path not in own and DEFINES_THE_LAYOUT.search(line)
    ]
    assert lines == []
