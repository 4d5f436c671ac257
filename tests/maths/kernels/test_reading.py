"""What a reader of files asks of all numbers of a model."""

import numpy as np
import pytest
from statwalk.files.gltf import attributes, plain
from statwalk.motion.keys import segments
from statwalk.motion.keys.channel import Channel
from statwalk.motion.keys.channel_table import gathered
from statwalk.motion.keys.key_set import key_set_of
from statwalk.skin.weights import used_where_normalised

CHANCE = np.random.default_rng(3)
UNIT = CHANCE.normal(size=(77, 3))
UNIT = (UNIT / np.linalg.norm(UNIT, axis=1, keepdims=True)).astype(np.float32)


def with_one(values, row, value):
    changed = values.copy()
    changed[row] = value
    return changed


@pytest.mark.parametrize("count", [1, 15, 16, 33, 100_000])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 2e24, -2e24])
def test_an_unusable_number_is_found(count, value):
    numbers = CHANCE.normal(size=count).astype(np.float32)
    assert plain.is_usable(numbers)
    assert not plain.is_usable(with_one(numbers, count // 2, value))


@pytest.mark.parametrize("value", [1e24, -1e24])
def test_the_largest_number_is_usable(value):
    assert plain.is_usable(np.full(20, value, np.float32))


@pytest.mark.parametrize("row", [3, 40, 76])
@pytest.mark.parametrize("value", [(0, 0, 0), (1, 1e-2, 0), (0, 1, 1e-2), (np.nan, 0, 0)])
def test_what_is_not_of_unit_length_is_found(value, row):
    assert attributes.are_unit(UNIT)
    assert not attributes.are_unit(with_one(UNIT, row, value))


@pytest.mark.parametrize(
    ("row", "used"),
    [
        ([1, 0, 0, 0], 1),
        ([0.5, 0.5, 0, 0], 2),
        ([0.4, 0.3, 0.3, 0], 3),
        ([0.25, 0.25, 0.25, 0.25], 4),
        ([0.5, 0, 0.5, 0], 0),
        ([1.5, -0.5, 0, 0], 0),
        ([0.5, 0.4, 0, 0], 0),
        ([1.25, 0, 0, -0.25], 0),
        ([np.nan, 0, 0, 0], 0),
    ],
)
@pytest.mark.parametrize("after", [0, 30])
def test_weights_that_are_right_already(row, used, after):
    right = [[1, 0, 0, 0]]
    assert used_where_normalised(np.float32([*right * 5, row, *right * after])) == used


def test_numbers_are_gathered():
    numbers = np.arange(50, dtype=np.float32)
    assert gathered(numbers, np.array([7, 0, 30]), np.array([2, 3, 20])).tolist() == [
        7,
        8,
        0,
        1,
        2,
        *range(30, 50),
    ]


@pytest.mark.parametrize("column", [0, 2])
def test_a_channel_that_changes_at_its_last_key_is_not_constant(column):
    times = np.arange(4, dtype=np.float32)
    still, moving = np.ones((2, 4, 3), np.float32)
    moving[3, column] = 2
    channels = [
        Channel(joint, "scale", times, values) for joint, values in enumerate((still, moving, still[:4]))
    ]
    assert key_set_of(channels).is_constant.tolist() == [True, False, True]


def keys(path, width):
    """Channels of one, two and five keys; a quaternion of no length among them."""
    times = [np.arange(count, dtype=np.float32) for count in (1, 2, 5)]
    values = [CHANCE.normal(size=(len(time), width)).astype(np.float32) for time in times]
    values[2][1] = 0
    return key_set_of(
        [Channel(joint, path, *pair) for joint, pair in enumerate(zip(times, values, strict=True))]
    )


@pytest.mark.parametrize(
    ("path", "width", "slowly"), [("translation", 3, segments._lines), ("rotation", 4, segments._arcs)]
)
def test_straight_keys_get_the_same_bits(path, width, slowly):
    listed = keys(path, width)
    assert segments.pack(listed, loop=False)[1].tobytes() == slowly(listed).tobytes()


def test_numbers_need_not_lie_as_kernels_want_them():
    room = np.zeros(4 * 40 + 1, np.uint8)[1:].view(np.float32)
    assert not room.flags.aligned
    assert plain.is_usable(room)
    assert gathered(room, np.array([3]), np.array([2])).tolist() == [0, 0]
    assert attributes.are_unit(np.asfortranarray(UNIT))
