"""Normals of every model against the inverse transpose in float64, from the world matrices of the ground
truth.
"""

import numpy as np
import pytest
from paths import needs_assets
from reference_poses import ALL, Row, Truth, character
from statwalk.skin.primitive import Primitive

pytestmark = needs_assets
LARGEST_ANGLE = 2e-4  # radians
ROWS = 12


def linear_parts(part: Primitive, world: np.ndarray, joint_world: np.ndarray) -> np.ndarray:
    """(V,3,3) float64: the blended matrix of every vertex without its translation."""
    if part.skin is None:
        return np.broadcast_to(world[part.node][:, :3], (len(part.positions), 3, 3))
    return np.einsum("vi,vijk->vjk", part.weights.astype(float), joint_world[part.joints][:, :, :, :3])


def expected(
    model: str, part: Primitive, world: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Unit normals (V,3), and which of them a matrix that is not flat gives."""
    found = character(model)
    joint_world = np.zeros(())
    if part.skin is not None:
        skin = found.skins[part.skin]
        joint_world = np.einsum(
            "kab,kbc->kac", world[found.node_index[skin.joints]][:, :, :3], skin.inverse_bind.astype(float)
        )
    linear = linear_parts(part, world, joint_world)
    solid = np.abs(np.linalg.det(linear)) > 1e-6 * np.linalg.norm(linear, axis=(1, 2)) ** 3
    base = part.normals.astype(float)
    if part.target_normals is not None:
        base = base + np.tensordot(
            weights[part.weight_first :][: len(part.target_normals)], part.target_normals.astype(float), 1
        )
    turned = np.einsum("vba,vb->va", np.linalg.inv(np.where(solid[:, None, None], linear, np.eye(3))), base)
    length = np.linalg.norm(turned, axis=1)
    solid &= length > 1e-9
    return turned / np.where(length == 0, 1, length)[:, None], solid


def worst_angle(truth: Truth, row: Row) -> float:
    world = truth.arrays["world"][row.number].astype(float)
    found, worst = character(truth.model), 0.0
    for part, posed in zip(found.parts, found.vertices(row.pose), strict=True):
        if part.normals is not None:
            wanted, solid = expected(truth.model, part, world, row.pose.weights)
            distance = np.linalg.norm(posed.normals - wanted, axis=1)[solid]
            worst = max(worst, 2 * np.arcsin(distance.max(initial=0) / 2))
    return worst


@pytest.mark.parametrize("model", ALL)
def test_normals(model: str) -> None:
    truth = Truth(model)
    rows = truth.rows[:: max(1, len(truth.rows) // ROWS)]
    assert max(worst_angle(truth, row) for row in rows) <= LARGEST_ANGLE


@pytest.mark.parametrize("model", ALL)
def test_normals_have_unit_length(model: str) -> None:
    for part in character(model).vertices(character(model).bind_pose):
        assert part.normals is None or np.abs(np.linalg.norm(part.normals, axis=1) - 1).max() < 1e-5
