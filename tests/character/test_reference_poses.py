"""Every sample and blend of every model against three.js, within the tolerance that each file of ground truth
states.
"""

import numpy as np
import pytest
from paths import needs_assets
from reference_poses import ALL, Truth, character, turn_between

pytestmark = needs_assets


@pytest.fixture(scope="module", params=ALL)
def truth(request: pytest.FixtureRequest) -> Truth:
    return Truth(request.param)


def test_all_models_are_held_against_the_truth() -> None:
    assert len(ALL) >= 67


def worst(errors: list[np.ndarray]) -> float:
    return max((float(np.abs(error).max()) for error in errors if error.size), default=0.0)


def in_file_order(truth: Truth) -> np.ndarray:
    return np.argsort(character(truth.model).node_index)


def relative(ours: np.ndarray, theirs: np.ndarray, size: float) -> np.ndarray:
    """The difference as a share of the model's size, or of the largest number where armatures are scaled."""
    return (ours - theirs) / max(size, float(np.abs(theirs).max(initial=0)))


def test_translations(truth: Truth) -> None:
    local, order = truth.arrays["local_trs"], in_file_order(truth)
    errors = [
        relative(row.pose.translation[order], local[row.number, :, :3], truth.size) for row in truth.rows
    ]
    assert worst(errors) <= truth.meta["tolerance_rel"]


def test_rotations(truth: Truth) -> None:
    local, order = truth.arrays["local_trs"], in_file_order(truth)
    assert (
        worst([turn_between(row.pose.rotation[order], local[row.number, :, 3:7]) for row in truth.rows])
        <= truth.meta["tolerance_rot_rad"]
    )


def test_scales(truth: Truth) -> None:
    local, order = truth.arrays["local_trs"], in_file_order(truth)
    errors = [relative(row.pose.scale[order], local[row.number, :, 7:], 1) for row in truth.rows]
    assert worst(errors) <= truth.meta["tolerance_rel"]


def test_world_matrices(truth: Truth) -> None:
    world, order = truth.arrays["world"], in_file_order(truth)
    ours = [(character(truth.model).world(row.pose)[order][:, :3], world[row.number]) for row in truth.rows]
    assert worst([relative(mine, theirs, truth.size) for mine, theirs in ours]) <= truth.meta["tolerance_rel"]


def test_morph_weights(truth: Truth) -> None:
    assert (
        worst([truth.morph(row) - truth.arrays["morph"][row.number] for row in truth.rows])
        <= truth.meta["tolerance_rel"]
    )


def test_vertices(truth: Truth) -> None:
    with_vertices = [row for row in truth.rows if truth.arrays["vert_row"][row.number] >= 0]
    errors = [(ours - theirs) / truth.size for row in with_vertices for ours, theirs in truth.points(row)]
    assert len(with_vertices) > 0
    assert worst(errors) <= truth.meta["tolerance_rel"]


def test_names_and_parents(truth: Truth) -> None:
    found = character(truth.model)
    parents = [-1 if joint < 0 else int(found.node_index[joint]) for joint in found.skeleton.parent]
    assert dict(zip(found.node_index.tolist(), parents, strict=True)) == dict(
        enumerate(truth.meta["node_parent"])
    )


def test_clips(truth: Truth) -> None:
    durations = [clip.duration for clip in character(truth.model).clips.values()]
    assert durations == pytest.approx([clip["duration"] for clip in truth.meta["clips"]], abs=1e-6)
