"""Step 7 of the tick: the joints of colliders in model space, against the slow hierarchy; only where
somebody looks at them.
"""

from dataclasses import replace

import numpy as np
import pytest
import slow_hierarchy
from builders import character, definition
from statwalk.character.role import Role
from statwalk.machine.definition.sense_definition import ColliderDefinition
from statwalk.machine.runtime.surroundings import NOTHING
from statwalk.stage.stage import Stage
from statwalk.stage.tick import tick

DT, ACTORS = 1 / 60, 20
COLLIDERS = {"tip": ColliderDefinition("sphere", 3, "arm", (0.2, 0.1, 0), 0.5)}


def cast_after(ticks):
    """Actors that came one after the other."""
    role = Role.build("tiny", character(), replace(definition(), colliders=COLLIDERS), "hips")
    stage = Stage()
    for number in range(ACTORS):
        stage.step(number % 3)
        stage.send(stage.add(role), "GO")
    stage.step(ticks)
    return stage.casts[0]


@pytest.mark.parametrize("ticks", [1, 9])
def test_the_joints_are_where_numpy_puts_those_of_the_new_poses(ticks):
    cast, _ = tick(cast_after(ticks), NOTHING, DT, 100, 0, is_looked_at=True)
    expected = slow_hierarchy.worlds(character().skeleton.parent, cast.shown.poses())
    assert cast.model.joints.joints.tolist() == [0, 1, 2]
    np.testing.assert_allclose(cast.model.matrices(), expected[:, :3], atol=1e-6)


def test_they_are_not_worked_out_where_nobody_looks():
    cast, _ = tick(cast_after(1), NOTHING, DT, 100, 0)
    assert cast.model is None


def test_looking_changes_no_bit_of_the_state():
    cast = cast_after(3)
    seen, _ = tick(cast.copy(), NOTHING, DT, 100, 0, is_looked_at=True)
    unseen, _ = tick(cast, NOTHING, DT, 100, 0)
    assert seen.hash.tolist() == unseen.hash.tolist()
    assert seen.shown.values.tobytes() == unseen.shown.values.tobytes()
