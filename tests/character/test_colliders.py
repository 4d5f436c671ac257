"""Where the colliders of actors are, against the matrices of the joints they ride on."""

from dataclasses import replace

import locked_arrays
import numpy as np
import pytest
import slow_hierarchy
from builders import character, definition
from scipy.spatial.transform import Rotation
from statwalk.character.colliders import MOST
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.machine.definition.sense_definition import ColliderDefinition
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.rig.model_buffer import ModelBuffer

TIP = ColliderDefinition("sphere", 3, "arm", (0.2, 0.1, 0), 0.5)
WIRE = ColliderDefinition("plane", 4, "", (0, 1, 2), 0.7, (0, 0, 1))
SHIELD = ColliderDefinition("plane", 5, "chest", (0, 0, 0.1), 0.3, (0, 0.6, 0.8))


def colliders_of(**colliders):
    return Role.build("tiny", character(), replace(definition(), colliders=colliders), "hips").colliders


def poses(count=4):
    chance = np.random.default_rng(3)
    pose = character().clips["hop"].sample(np.linspace(0, 0.5, count))
    turned = (
        Rotation.from_quat(chance.normal(size=(count * 3, 4)))
        .as_quat()
        .reshape(count, 3, 4)
        .astype(np.float32)
    )
    return pose._replace(rotation=turned), chance.uniform(-5, 5, (count, 3)), chance.uniform(-4, 4, count)


def placed_of(colliders, pose, position, heading):
    model = ModelBuffer.room(colliders.joints, len(position))
    model.fill(PoseBuffer.of(character().bind_pose, pose))
    return colliders.placed(model, position, heading)


def test_they_ride_on_their_joints():
    pose, position, heading = poses()
    placed = placed_of(colliders_of(tip=TIP, wire=WIRE, shield=SHIELD), pose, position, heading)
    world = slow_hierarchy.worlds(character().skeleton.parent, pose)
    for actor in range(4):
        turn = Rotation.from_euler("y", heading[actor])
        arm, chest = world[actor, 2], world[actor, 1]
        centers = [arm @ [0.2, 0.1, 0, 1], [0, 1, 2], chest @ [0, 0, 0.1, 1]]
        np.testing.assert_allclose(placed.center[actor], turn.apply(centers) + position[actor], atol=1e-5)
        np.testing.assert_allclose(
            placed.normal[actor, 1:], turn.apply([[0, 0, 1], chest[:, :3] @ [0, 0.6, 0.8]]), atol=1e-5
        )
    np.testing.assert_allclose(placed.radius, np.tile([0.5, 0.7, 0.3], (4, 1)), rtol=1e-5)


def test_they_grow_with_the_scale_of_the_joint_and_are_gone_where_it_is_nothing():
    pose, position, heading = poses(2)
    scale = pose.scale.copy()
    scale[0, 1], scale[1, 2] = 3, 0
    placed = placed_of(colliders_of(tip=TIP), pose._replace(scale=scale), position, heading)
    assert placed.radius[0, 0] == pytest.approx(1.5, rel=1e-5)
    assert placed.is_there[:, 0].tolist() == [True, False]


def test_only_the_joints_needed_are_worked_out():
    assert colliders_of(wire=WIRE).joints.joints.tolist() == []
    assert colliders_of(shield=SHIELD).joints.joints.tolist() == [0, 1]


def test_too_many_are_refused():
    with pytest.raises(MachineError, match=rf"65 colliders; at most {MOST}"):
        colliders_of(**{f"c{number}": TIP for number in range(65)})


def test_one_of_many_has_the_bits_of_one_alone():
    colliders = colliders_of(tip=TIP, shield=SHIELD)
    pose, position, heading = poses(9)
    many = placed_of(colliders, pose, position, heading)
    for row in range(9):
        alone = placed_of(colliders, pose.take([row]), position[[row]], heading[[row]])
        for one, other in zip(alone, many, strict=True):
            np.testing.assert_array_equal(one[0], other[row])


def test_their_arrays_cannot_be_written():
    locked_arrays.check(colliders_of(tip=TIP, wire=WIRE, shield=SHIELD))
