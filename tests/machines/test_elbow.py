"""The elbow in four ways of skinning: creases, gaps, the candy wrapper, and none of them."""

import numpy as np
import pytest
import statwalk
from closed_volume import volume
from dual_reference import posed
from statwalk.errors import UnknownNameError
from statwalk.rig.evaluate import world_from_local

ARM = statwalk.load("elbow").character
BENT, TWISTED = ARM.clip("bend").sample(1.5), ARM.clip("twist").sample(1.5)
MIDDLE = np.abs(ARM.parts[0].positions[:, 0]) < 0.01
RADIUS = 0.085


def drawn(pose, skinning):
    (part,) = ARM.vertices(pose, skinning)
    return part.positions


def kept(pose, skinning):
    """The volume as a part of that at rest."""
    faces = ARM.skinned(skinning).shown_parts[0].indices
    return volume(drawn(pose, skinning), faces) / volume(drawn(ARM.bind_pose, skinning), faces)


@pytest.mark.parametrize("skinning", ["linear", "dual-quaternion", "rigid", "parts"])
def test_all_ways_agree_at_rest(skinning):
    at_rest = np.unique(ARM.parts[0].positions.round(5), axis=0)
    assert np.unique(drawn(ARM.bind_pose, skinning).round(5), axis=0) == pytest.approx(at_rest, abs=2e-5)


@pytest.mark.parametrize("pose", [BENT, TWISTED], ids=["bent", "twisted"])
def test_dual_quaternions_are_those_of_the_textbook(pose):
    dual = ARM.skinned("dual-quaternion")
    (part,) = dual.vertices(pose)
    positions, normals = posed(dual.surface, world_from_local(ARM.skeleton, pose))
    assert part.positions == pytest.approx(positions, abs=1e-6)
    assert part.normals == pytest.approx(normals, abs=1e-5)


def test_a_twist_wraps_candy_in_the_linear_skin_alone():
    """Distances from the arm's axis, where both bones hold the skin alike."""
    from_axis = {
        name: np.linalg.norm((drawn(TWISTED, name) - [0, 0.9, 0])[MIDDLE, 1:], axis=1)
        for name in ("linear", "dual-quaternion")
    }
    assert from_axis["linear"].max() < 0.1 * RADIUS
    assert from_axis["dual-quaternion"] == pytest.approx(RADIUS, rel=1e-3)
    assert kept(TWISTED, "linear") < 0.9
    assert kept(TWISTED, "dual-quaternion") > 0.995


def test_rigid_skin_stays_one_and_pieces_open_gaps():
    rigid, pieces = drawn(BENT, "rigid"), drawn(BENT, "parts")
    assert len(rigid) == len(ARM.parts[0].positions)
    assert len(pieces) > len(rigid)
    corners = ARM.skinned("parts").shown_parts[0]
    edges = [
        np.linalg.norm(np.diff(points[corners.indices.reshape(-1, 3)], axis=1), axis=2)
        for points in (corners.positions, pieces)
    ]
    assert edges[0] == pytest.approx(edges[1], abs=1e-6)  # no triangle of a piece is stretched
    stretched = np.linalg.norm(np.diff(rigid[ARM.parts[0].indices.reshape(-1, 3)], axis=1), axis=2)
    assert stretched.max() > 2 * edges[0].max()


def test_an_actor_shows_them_too():
    stage = statwalk.Stage()
    actor = stage.add(statwalk.load("elbow"))
    stage.send(actor, "BEND")
    stage.step(120)
    assert actor.vertices("dual-quaternion")[0].positions == pytest.approx(
        drawn(BENT, "dual-quaternion"), abs=1e-3
    )


def test_another_way_is_refused():
    with pytest.raises(UnknownNameError, match="way of skinning"):
        ARM.vertices(BENT, "smooth")
