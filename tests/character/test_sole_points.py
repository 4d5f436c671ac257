"""The points of a foot that a tick looks at, against the whole skin of the foot."""

from __future__ import annotations

import numpy as np
import pytest
from paths import MACHINES
from statwalk.character import sole_points as module
from statwalk.character.feet import Foot, feet_of
from statwalk.character.skin_points import bound_points
from statwalk.character.sole_points import HIGHEST, SPACING, sole_points
from statwalk.rig.evaluate import world_from_local
from statwalk.services.library.load import load_role

CHARACTER = load_role(MACHINES / "faq-walker").character
REST = world_from_local(CHARACTER.skeleton, CHARACTER.bind_pose).astype(np.float64)
FOOT: Foot = feet_of(CHARACTER)[0]
SKIN = bound_points(CHARACTER, FOOT.joints).at(REST)


def chosen(unit: float | None) -> np.ndarray:
    """(K, 3) the chosen points where they are at rest."""
    sole = sole_points(CHARACTER, FOOT, REST, unit)
    frames = REST[sole.carriers]
    return np.einsum("kab,kb->ka", frames[:, :, :3], sole.places) + frames[:, :, 3]


def farthest(points: np.ndarray) -> float:
    low = SKIN[SKIN[:, 1] < SKIN[:, 1].min() + HIGHEST]
    return float(np.linalg.norm(low[:, None] - points, axis=-1).min(1).max())


def test_on_uneven_ground_all_skin_near_the_ground_has_a_point_beside_it() -> None:
    assert farthest(chosen(1.0)) <= SPACING + 1e-6


def test_on_a_floor_the_lowest_points_are_enough() -> None:
    points = chosen(None)
    assert len(points) < 20
    assert farthest(points) > SPACING
    assert points[:, 1].min() == pytest.approx(SKIN[:, 1].min(), abs=1e-9)


def test_smaller_characters_have_their_points_closer_together() -> None:
    assert len(chosen(1.0)) < len(chosen(0.5))


def test_the_lowest_come_first() -> None:
    sole, points = sole_points(CHARACTER, FOOT, REST, 1.0), chosen(1.0)
    assert points[: sole.lowest, 1].min() == pytest.approx(SKIN[:, 1].min(), abs=1e-9)
    assert 20 < sole.lowest < len(points)


def test_the_foremost_skin_of_a_steep_foot_has_its_own_point() -> None:
    points, low = chosen(1.0), SKIN[SKIN[:, 1] < SKIN[:, 1].min() + HIGHEST]
    steep = np.array([0.0, 1.0, 1.2])  # what is foremost in a foot whose toes point down by 40 degrees
    spread = points[: sole_points(CHARACTER, FOOT, REST, 1.0).spread]
    assert (points @ steep).max() == pytest.approx((low @ steep).max(), abs=1e-6)
    assert (spread @ steep).max() < (low @ steep).max() - 1e-3


def test_a_foot_never_has_more_points_than_the_most(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST", 40)
    assert len(chosen(1.0)) == 40
