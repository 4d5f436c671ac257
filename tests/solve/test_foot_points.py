"""Where a foot points, against SciPy's rotations."""

from __future__ import annotations

import numpy as np
import pytest
from foot_at_step import FEET, LEGS, legs_at
from foot_kernels import yaw
from paths import MACHINES
from scipy.spatial.transform import Rotation
from statwalk.services.library.load import load_role

TERRAIN = load_role(MACHINES / "terrain")
LEFT_FOOT = TERRAIN.feet[0]
REST = TERRAIN.character.world(TERRAIN.character.bind_pose)
BALL = LEFT_FOOT.skin.at(REST)[LEFT_FOOT.is_front].mean(0) - REST[LEFT_FOOT.ankle, :3, 3]
AT_REST = np.arctan2(BALL[0], BALL[2])


def turned(yaw_deg: float, pitch_deg: float) -> float:
    """The yaw in degrees that is found of the left foot, pitched (toes down) and then turned from its pose at
    rest.
    """
    along = Rotation.from_euler("y", AT_REST)
    pitched = along * Rotation.from_euler("x", pitch_deg, degrees=True) * along.inv()
    turn = Rotation.from_euler("y", yaw_deg, degrees=True) * pitched
    legs = np.array(legs_at(0.1, 0.0))
    matrix = turn.as_matrix() @ REST[LEFT_FOOT.ankle, :3, :3]
    legs[0, LEGS.ankle[0]].reshape(3, 4, 16)[:, :3] = matrix[..., None]
    legs.flags.writeable = False
    return float(np.degrees(yaw(FEET, legs)))


@pytest.mark.parametrize("pitch", [-40, 0, 60, 89, 91, 120])
def test_a_foot_points_where_it_points_however_steep_it_is(pitch: float) -> None:
    """A runner's foot behind him is steeper than upright."""
    assert turned(25, pitch) == pytest.approx(25 + np.degrees(AT_REST), abs=1e-3)
