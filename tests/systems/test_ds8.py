"""DS8 muscle bulge (FAQ Q22): the angle of a joint, a cubic, a scale factor, chosen vertices."""

from pathlib import Path

import numpy as np
import pytest
import statwalk
from statwalk.character.character import Character
from statwalk.errors import TextError
from statwalk.services.library.load import load
from tiny_model import document, glb

SKELETON = "Upper --- 0.3 1 0 0\nLower Upper 0.3 1 0 0\n"
SKIN = """\
digital_skin: |
  #vertices Upper
  0.0 0.1 0
  0.1 0.1 0
  0.2 0.1 0
  0.1 0.05 0.05
  #vertices Lower
  0.1 0.1 0
  #polygons
  0 1 3
  1 2 3
  2 4 3
"""
BULGE = """\
bulges:
  biceps:
    angle: Lower.rotate_z
    cubic: [1, 0.001, 0.00004, -0.0000002]
    bone: Upper
    point: [0.1, 0, 0]
"""
FACTORS = {0: 1.0, 45: 1.107775, 90: 1.2682}
"""by hand: 1 + 0.045 + 0.081 - 0.018225, and 1 + 0.09 + 0.324 - 0.1458"""
AXIS = "    axis: [2, 0, 0]\n"
REST = np.array([[0, 0.1, 0], [0.1, 0.1, 0], [0.2, 0.1, 0], [0.1, 0.05, 0.05]])


def made(folder: Path, bulge: str) -> Character:
    (folder / "arm.txt").write_text(SKELETON)
    (folder / "arm.yaml").write_text("skeleton: arm.txt\n" + SKIN + BULGE + bulge)
    return load(folder / "arm.yaml")


def upper(character: Character, angle: float) -> np.ndarray:
    """The vertices of the upper arm when the elbow has an angle in degrees, and the expressions ran."""
    turned = statwalk.express(character, f"Lower.rotate_z = {angle}").pose
    (part,) = character.vertices(statwalk.express(character, pose=turned).pose)
    return part.positions[:4]


@pytest.mark.parametrize(("angle", "factor"), FACTORS.items())
def test_chosen_vertices_move_away_from_an_axis(tmp_path: Path, angle: float, factor: float) -> None:
    arm = made(tmp_path, AXIS + "    vertices: [1, 3]\n")
    expected = REST.copy()
    expected[[1, 3], 1:] *= factor
    assert upper(arm, angle) == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize(("angle", "factor"), FACTORS.items())
def test_chosen_vertices_move_away_from_a_point(tmp_path: Path, angle: float, factor: float) -> None:
    arm = made(tmp_path, "    vertices: [0-2]\n")
    expected = REST.copy()
    centre = np.array([0.1, 0, 0])
    expected[:3] = centre + factor * (expected[:3] - centre)
    assert upper(arm, angle) == pytest.approx(expected, abs=1e-6)


def test_the_bulge_fades_out_inside_an_ellipsoid(tmp_path: Path) -> None:
    """At 0.1 0.1 0 the share of the way out is e = 0.1/0.2, and (1 - e²)² = 0.5625; at the ends e > 1."""
    arm = made(tmp_path, "    radius: [0.1, 0.2, 0.2]\n")
    bulged = upper(arm, 90)
    assert bulged[[0, 2]] == pytest.approx(REST[[0, 2]], abs=1e-6)
    assert bulged[1] == pytest.approx([0.1, 0.1 * (1 + 0.2682 * 0.5625), 0], abs=1e-6)


def test_a_stage_bulges_the_muscle_in_every_tick(tmp_path: Path) -> None:
    made(tmp_path, AXIS + "    vertices: [1]\n")
    (tmp_path / "machine.yaml").write_text(
        "semantics: 1\ncharacter: arm.yaml\ninitial: HOLD\nstates:\n"
        '  HOLD: {motion: {expressions: ["Lower.rotate_z = 90"]}}\n'
        "table: |\n  state | END\n  HOLD  |\n"
    )
    stage = statwalk.Stage(seed=1)
    actor = stage.add(statwalk.load(tmp_path))
    stage.step(2)
    (part,) = actor.vertices()
    assert part.positions[1] == pytest.approx([0.1, 0.12682, 0], abs=1e-6)


def test_normals_are_those_of_the_bulged_surface(tmp_path: Path) -> None:
    """The slope of the triangle 0 1 3, of which only vertex 1 is raised, turns its normal."""
    arm = made(tmp_path, AXIS + "    vertices: [1]\n")
    pose = arm.bind_pose._replace(weights=np.array([0.3], np.float32))
    (part,) = arm.vertices(pose)
    corners = part.positions[[0, 1, 3]].astype(float)
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    assert part.normals is not None
    assert part.normals[0] == pytest.approx(normal / np.linalg.norm(normal), abs=1e-5)


@pytest.mark.parametrize("suffix", ["glb", "gltf", "zip", "chunk"])
def test_a_bulge_survives_in_other_formats(tmp_path: Path, suffix: str) -> None:
    arm = made(tmp_path, AXIS + "    vertices: [1, 3]\n")
    statwalk.convert(arm, tmp_path / f"other.{suffix}")
    again = load(tmp_path / f"other.{suffix}")
    assert again.targets.keys() == {"biceps"}
    assert upper(again, 90) == pytest.approx(upper(arm, 90), abs=1e-6)
    assert (again.bulges, again.notes) == (arm.bulges, ())
    (bulge,) = again.bulges.values()
    assert bulge.cubic == (1, 0.001, 0.00004, -0.0000002)
    assert (bulge.bone, bulge.point, bulge.axis, bulge.vertices) == ("Upper", (0.1, 0, 0), (2, 0, 0), {1, 3})
    assert [line.text for line in again.expressions] == [line.text for line in arm.expressions]
    statwalk.convert(again, tmp_path / f"third.{suffix}")
    assert load(tmp_path / f"third.{suffix}").bulges == arm.bulges


@pytest.mark.parametrize("suffix", ["gltf", "chunk"])
def test_a_bulge_that_is_changed_in_a_file_moves_as_it_says(tmp_path: Path, suffix: str) -> None:
    statwalk.convert(made(tmp_path, AXIS + "    vertices: [1]\n"), tmp_path / f"arm.{suffix}")
    data = (tmp_path / f"arm.{suffix}").read_bytes()
    for text in (b'"cubic":[1.0,', b'"cubic": [1.0,'):
        data = data.replace(text, text.replace(b"1.0", b"3.0"))
    (tmp_path / f"arm.{suffix}").write_bytes(data)
    assert upper(load(tmp_path / f"arm.{suffix}"), 0)[1] == pytest.approx([0.1, 0.3, 0], abs=1e-6)


def test_a_format_without_bulges_says_so(tmp_path: Path) -> None:
    report = statwalk.convert(made(tmp_path, AXIS + "    vertices: [1]\n"), tmp_path / "arm.x")
    assert ("bulges", ("biceps",)) in [(loss.part, loss.names) for loss in report.lost]


def test_a_model_keeps_its_own_morph_targets_and_their_keys(tmp_path: Path) -> None:
    """The small model has a target, and a clip that keys it."""
    (tmp_path / "leg.glb").write_bytes(glb(*document()))
    plain = load(tmp_path / "leg.glb")
    bone = plain.skeleton.names[0]
    (tmp_path / "leg.yaml").write_text(
        f"model: leg.glb\nbulges:\n  calf: {{angle: {bone}.rotate_z, cubic: [1.5, 0, 0, 0], bone: {bone}, "
        "point: [0, 0, 0], vertices: [1]}\n"
    )
    both = load(tmp_path / "leg.yaml")
    width = plain.bind_pose.weights.shape[-1]
    assert both.bind_pose.weights.shape[-1] == width + 1
    for name, clip in plain.clips.items():
        times = np.linspace(0, clip.duration, 5)
        before, after = clip.sample(times).weights, both.clips[name].sample(times).weights
        np.testing.assert_array_equal(after[:, :width], before)
    (tmp_path / "again.glb").write_bytes(both.model_glb)
    again = load(tmp_path / "again.glb")
    pose = statwalk.express(again, pose=next(iter(again.clips.values())).sample(0.2)).pose
    assert pose.weights[again.target("calf")[0]] == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("wrong", "line", "message"),
    [
        (BULGE, 16, "needs vertices, or a radius"),
        (BULGE + "    vertices: [9]\n", 16, "there is no vertex 9; the last is 4"),
        (BULGE + "    vertices: [2-1]\n", 20, "the smaller first"),
        (BULGE + "    radius: [0.001, 0.001, 0.001]\n", 16, "no vertex is chosen"),
        (BULGE.replace("Lower.rotate_z", "Lower.trans_z") + "    vertices: [1]\n", 16, "an angle is"),
        (BULGE.replace("Lower.r", "Hand.r") + "    vertices: [1]\n", 16, "no joint is called 'Hand'"),
        (BULGE.replace("[1, 0.001, ", "[1, ") + "    vertices: [1]\n", 17, "a list of 4 numbers"),
        (BULGE + "    vertices: [1]\n    axis: [0, 0, 0]\n", 21, "an axis is a direction"),
    ],
)
def test_a_wrong_bulge_is_refused_with_its_line(tmp_path: Path, wrong: str, line: int, message: str) -> None:
    (tmp_path / "arm.txt").write_text(SKELETON)
    (tmp_path / "arm.yaml").write_text("skeleton: arm.txt\n" + SKIN + wrong)
    with pytest.raises(TextError, match=message) as caught:
        load(tmp_path / "arm.yaml")
    assert caught.value.place == f"line {line}"
