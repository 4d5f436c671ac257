"""Morph targets that a character gets: columns, names, keys and shared meshes stay in step."""

from dataclasses import replace

import numpy as np
from statwalk.character.added_targets import AddedTarget, with_targets
from statwalk.character.character import Character
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive

POINTS = np.eye(3, dtype=np.float32)


def targets(*sizes: float) -> np.ndarray:
    return np.stack([size * POINTS for size in sizes]).astype(np.float32)


def character() -> Character:
    """Two nodes: the first has the targets a and b, keyed; the second has c and shares its mesh with a third
    node.
    """
    pose = rest(3, 4)
    parts = (
        Primitive(0, 0, 0, 0, POINTS, target_positions=targets(1, 2), weight_first=0),
        Primitive(1, 1, 1, 0, POINTS, target_positions=targets(3), weight_first=2),
        Primitive(2, 2, 1, 0, POINTS, target_positions=targets(3), weight_first=3),
    )
    times = np.array([0, 1], np.float32)
    keys = Channel(0, "weights", times, np.array([[0.1, 0.2], [0.3, 0.4]], np.float32))
    later = Channel(1, "weights", times, np.array([[0.5], [0.6]], np.float32), weight_first=2)
    clip = Clip("nod", (keys, later), 1.0, pose)
    return Character(
        "x", Skeleton(("a", "b", "c"), np.array([-1, -1, -1], np.int32)), np.arange(3, dtype=np.int32), pose,
        {"nod": clip}, parts=parts, target_names=("a", "b", "c", "c"),
    )  # fmt: skip


NEW = AddedTarget("new", {0: 5 * POINTS, 1: 6 * POINTS}, {})


def test_new_columns_stand_after_the_nodes_own() -> None:
    made = with_targets(character(), [NEW])
    assert made.target_names == ("a", "b", "new", "c", "new", "c")
    assert [part.weight_first for part in made.parts] == [0, 3, 5]
    assert made.parts[0].target_positions is not None
    np.testing.assert_array_equal(made.parts[0].target_positions, targets(1, 2, 5))
    assert made.targets["new"] == (2, 4)


def test_columns_are_in_the_order_of_nodes_as_in_a_file() -> None:
    plain = replace(
        character(),
        bind_pose=rest(3, 2),
        clips={},
        parts=(
            Primitive(0, 0, 0, 0, POINTS),
            Primitive(1, 1, 1, 0, POINTS, target_positions=targets(3, 4)),
            Primitive(2, 2, 2, 0, POINTS),
        ),
        target_names=("c", "d"),
    )
    made = with_targets(plain, [AddedTarget(name, {row: POINTS}, {}) for name, row in (("z", 2), ("a", 0))])
    assert made.target_names == ("a", "c", "d", "z")
    assert [part.weight_first for part in made.parts] == [0, 1, 3]


def test_keys_keep_their_columns_and_get_zeros() -> None:
    made = with_targets(character(), [NEW])
    weights = made.clips["nod"].sample(1.0).weights
    np.testing.assert_allclose(weights, [0.3, 0.4, 0, 0.6, 0, 0], atol=1e-7)
    assert [channel.values.shape[-1] for channel in made.clips["nod"].channels] == [3, 2]


def test_a_shared_mesh_is_parted_where_one_node_alone_gets_targets() -> None:
    made = with_targets(character(), [NEW])
    assert [part.mesh for part in made.parts] == [0, 2, 1]


def test_the_other_columns_pose_what_they_posed() -> None:
    before, after = character(), with_targets(character(), [NEW])
    pose = before.clips["nod"].sample(0.5)
    later = after.clips["nod"].sample(0.5)
    for one, other in zip(before.vertices(pose), after.vertices(later), strict=True):
        np.testing.assert_allclose(one.positions, other.positions, atol=1e-6)
