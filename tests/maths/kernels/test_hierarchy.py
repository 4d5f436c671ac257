"""Joint matrices in stage space against the tick's own hierarchy, in float64."""

import numpy as np
import pytest
from statwalk.maths import quat, transform
from statwalk.maths.kernels import hierarchy
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton

ACTORS, PARENTS = 3, np.array([-1, 0, 1, 0, -1, 4, 5], np.int32)


def test_every_joint_is_where_numpy_puts_it():
    chance = np.random.default_rng(3)
    shape = (ACTORS, len(PARENTS))
    turns = quat.normalize(chance.normal(size=(*shape, 4)))
    pose = Pose(
        chance.normal(size=(*shape, 3)), turns, chance.uniform(0.5, 2, (*shape, 3)), np.zeros((ACTORS, 0))
    )
    roots = transform.from_trs(
        chance.normal(size=(3, 1, 3)), quat.normalize(chance.normal(size=(3, 1, 4))), np.ones((3, 1, 3))
    )
    expected = transform.mul(roots, world_from_local(Skeleton(tuple("abcdefg"), PARENTS), pose))
    out = np.empty((*shape, 3, 4), np.float32)
    hierarchy.placed(PARENTS, *(np.ascontiguousarray(array, np.float32) for array in (*pose[:3], roots)), out)
    assert out == pytest.approx(expected, abs=1e-5)
