"""Rigging as a whole: what a mesh gets, and what is refused."""

import numpy as np
import pytest
import statwalk
from rig_shapes import boxes, cylinder, human, mammal, mesh
from statwalk.character.autorig.autorig import MOST_GRAPH_VOXELS
from statwalk.character.body_bones import NEEDED, body_bones
from statwalk.character.character import Character
from statwalk.character.feet import feet_of


def joints_of(character: Character) -> dict[str, np.ndarray]:
    """Where the joints of the skin are at rest, by name."""
    rows = character.skins[0].joints
    places = character.world(character.bind_pose)[:, :3, 3]
    return {character.skeleton.names[row]: places[row] for row in rows}


def check_weights(character: Character) -> None:
    for part in character.parts:
        assert part.joints is not None
        assert part.weights is not None
        assert part.weights.shape[1] <= 4
        assert part.weights.min() >= 0
        assert part.weights.sum(1) == pytest.approx(1, abs=1e-6)
        assert part.joints.max() < len(character.skins[part.skin].joints)


@pytest.mark.parametrize("weights", ["heat", "nearest"])
@pytest.mark.parametrize("skeleton", ["human", "parts"])
def test_a_figure_is_rigged_and_stands_as_before(skeleton: str, weights: str) -> None:
    plain = mesh(*human())
    character = plain.autorig(skeleton, weights)
    check_weights(character)
    before, after = (one.vertices(one.bind_pose)[0].positions for one in (plain, character))
    assert after == pytest.approx(before, abs=1e-5)


def test_a_human_has_its_joints_where_they_belong() -> None:
    places = joints_of(mesh(*human()).autorig("human"))
    assert places["LeftHand"][0] > places["LeftLowerArm"][0] > places["LeftUpperArm"][0] > 0.06
    assert places["LeftUpperArm"][1] == pytest.approx(1.42, abs=0.06)
    assert places["LeftLowerLeg"] == pytest.approx([0.12, 0.5, 0], abs=0.12)
    assert places["Head"][1] > places["Neck"][1] > places["Chest"][1] > places["Hips"][1] > 0.9
    for name, place in places.items():
        if name.startswith("Left"):
            mirrored = places[name.replace("Left", "Right")] * [-1, 1, 1]
            assert place == pytest.approx(mirrored, abs=0.08), name


def test_names_are_known_to_captures_and_feet() -> None:
    """So that a captured motion is carried over to it, and its feet hold."""
    character = mesh(*human()).autorig("human")
    assert set(NEEDED) <= body_bones(character.skeleton).keys()
    assert {foot.name for foot in feet_of(character)} == {"left", "right"}


def test_a_mammal_has_four_legs_a_head_and_a_tail() -> None:
    character = mesh(*mammal()).autorig("mammal")
    check_weights(character)
    places = joints_of(character)
    assert {foot.name for foot in feet_of(character)} == {
        "front-left",
        "front-right",
        "back-left",
        "back-right",
    }
    assert (
        places["Tail4"][2] < places["Tail1"][2] < places["Hips"][2] < places["Chest"][2] < places["Head"][2]
    )
    assert places["LeftFrontUpperLeg"][2] > 0.3
    assert places["RightBackFoot"][0] < 0


def test_a_figure_that_looks_along_x_is_turned() -> None:
    points, faces = human()
    turned = points @ np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0.0]])  # +z becomes +x, +x becomes -z
    places = joints_of(mesh(turned, faces).autorig("human", facing="+x"))
    assert places["LeftHand"][2] < -0.5
    assert places["LeftToes"][0] > places["LeftFoot"][0]


def test_parts_are_limbs() -> None:
    """A cross bar and one bar on top: a root and a limb in each bar."""
    points, faces = boxes(((0, 0, 0), (1, 0.1, 0.1)), ((0, 0.6, 0), (0.1, 0.6, 0.1)))
    places = joints_of(mesh(points, faces).autorig("parts"))
    outer = np.array([place for name, place in places.items() if name != "Root"])
    assert (outer[:, 0] > 0.15).any()
    assert (outer[:, 0] < -0.15).any()
    assert (outer[:, 1] > 0.15).any()


def test_own_joints_are_kept_and_their_clips(tmp_path: object) -> None:
    plain = mesh(*human())
    rigged = plain.autorig("human")
    again = rigged.autorig("own", "nearest")
    assert again.skeleton is rigged.skeleton
    assert again.clips.keys() == rigged.clips.keys()
    assert {len(part.weights[part.weights > 0]) for part in again.parts} == {len(human()[0])}


def test_a_new_skeleton_bends_in_a_clip() -> None:
    character = mesh(*human()).autorig("human")
    clip = character.clip("Bend")
    rest = character.vertices(character.bind_pose)[0].positions
    moved = [
        np.abs(character.vertices(clip.sample(time))[0].positions - rest).max()
        for time in np.arange(0.2, clip.duration, 0.8)
    ]
    assert min(moved) > 0.01
    assert character.vertices(clip.sample(clip.duration))[0].positions == pytest.approx(rest, abs=1e-4)


POINTS, FACES = cylinder()
AWKWARD = {
    "an edge of four triangles": boxes(((0, 0, 0), (1, 1, 1)), ((2, 2, 0), (1, 1, 1))),
    "two shells apart": boxes(((0, 0, 0), (1, 1, 1)), ((9, 0, 0), (1, 1, 1))),
    "triangles without area": (POINTS, np.concatenate([FACES, [[0, 1, 1], [5, 5, 5], [0, 24, 48]]])),
    "a sheet": (np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]]), np.array([[0, 1, 2], [0, 2, 3]])),
    "every triangle twice, and turned": (POINTS, np.concatenate([FACES, FACES, FACES[:, ::-1]])),
    "a vertex that no triangle has": (np.concatenate([POINTS, [[3, 3, 3]]]), FACES),
    "a needle": (POINTS * [1e-4, 1, 1e-4], FACES),
    "microscopic": (POINTS * 1e-6, FACES),
    "astronomic": (POINTS * 1e6, FACES),
}


@pytest.mark.parametrize("weights", ["heat", "nearest"])
@pytest.mark.parametrize("name", AWKWARD)
def test_awkward_meshes_are_rigged(name: str, weights: str) -> None:
    character = mesh(*AWKWARD[name]).autorig("parts", weights)
    check_weights(character)
    assert np.isfinite(character.vertices(character.clips["Bend"].sample(0.2))[0].positions).all()


def test_points_have_no_surface() -> None:
    with pytest.raises(statwalk.ContentError, match="no triangles"):
        mesh(POINTS, np.arange(len(POINTS)), mode=0).autorig()


def test_one_place_has_no_size() -> None:
    with pytest.raises(statwalk.ContentError, match="no size"):
        mesh(POINTS * 0, FACES).autorig()


def test_a_mesh_without_joints_has_none_of_its_own() -> None:
    with pytest.raises(statwalk.ContentError, match="no skeleton of its own"):
        mesh(POINTS, FACES).autorig("own")


def test_a_ball_is_no_animal() -> None:
    with pytest.raises(statwalk.ContentError, match="the skeleton parts fits any mesh"):
        mesh(*boxes(((0, 0, 1), (0.1, 0.1, 1)))).autorig("mammal")


def test_a_choice_that_does_not_exist_is_refused() -> None:
    with pytest.raises(statwalk.ContentError, match="did you mean human"):
        mesh(POINTS, FACES).autorig("humn")


def test_too_many_triangles_are_refused_before_any_work() -> None:
    faces = np.tile(FACES, (1 + 400_000 // len(FACES), 1))
    work: list[str] = []
    with pytest.raises(statwalk.ContentError, match="make it simpler"):
        mesh(POINTS, faces).autorig("parts", progress=lambda name, _share: work.append(name))
    assert work == ["reading the mesh"]


def test_progress_names_the_work_and_ends() -> None:
    seen: list[tuple[str, float]] = []
    mesh(POINTS, FACES).autorig("parts", progress=lambda work, share: seen.append((work, share)))
    shares = [share for _, share in seen]
    assert shares == sorted(shares)
    assert shares[-1] == 1
    assert seen[-1][0] == "weighing vertices"


def test_a_bulky_body_has_coarser_voxels() -> None:
    """A cube fills all its voxels: the ways through it are still found in time."""
    assert MOST_GRAPH_VOXELS < 64**3
    check_weights(mesh(*boxes(((0, 0, 0), (1, 1, 1)))).autorig("parts"))
