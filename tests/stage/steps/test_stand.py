"""New actors stand with their feet on the ground from the first picture on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from crossings import heights_at
from paths import MACHINES
from statwalk.character.role import Role
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage

WALKER, TERRAIN = load_role(MACHINES / "faq-walker"), load_role(MACHINES / "terrain")
FREE = Role.build("free", WALKER.character, replace(WALKER.definition, foot_lock=0.0), "Root")
PLACES = {"floor": -1.0, "stairs": 1.95, "landing": 3.4, "ramp": 5.9}
"""metres along z"""


@pytest.mark.parametrize("z", PLACES.values(), ids=PLACES)
def test_the_first_tick_moves_no_joint_by_a_millimetre(z: float) -> None:
    """Without `stand` a knee moves by 23 mm."""
    stage = Stage()
    actor = stage.add(TERRAIN, position=(0, 0, z))
    first = actor.world[:, :, 3].copy()
    stage.step()
    assert np.linalg.norm(actor.world[:, :, 3] - first, axis=-1).max() < 0.001


@pytest.mark.parametrize("z", PLACES.values(), ids=PLACES)
def test_both_soles_are_on_the_ground_at_once(z: float) -> None:
    actor = Stage().add(TERRAIN, position=(0, 0, z))
    for foot in TERRAIN.feet:
        points = foot.skin.at(actor.world)
        above = points[:, 1] - heights_at(TERRAIN.definition.ground, points[:, 0], points[:, 2])
        assert above.min() == pytest.approx(0, abs=0.003)


def test_actors_stand_alike_alone_and_among_others() -> None:
    stage = Stage()
    many = [stage.add(TERRAIN, position=(0, 0, z)) for z in np.linspace(-1, 8, 20)]
    alone = Stage().add(TERRAIN, position=(0, 0, float(np.linspace(-1, 8, 20)[17])))
    np.testing.assert_array_equal(many[17].world, alone.world)


def test_without_the_foot_lock_the_pose_is_the_motions() -> None:
    actor = Stage().add(FREE)
    motion = WALKER.character.clips["stand"].sample(np.zeros(1))
    np.testing.assert_allclose(actor.pose.rotation, motion.rotation[0], atol=1e-6)
