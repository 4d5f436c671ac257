"""DS6 muscle bones (RTCA 2.3.2): joints that only deform the skin, and follow the others by expressions."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import statwalk
from rig_shapes import cylinder, mesh
from statwalk.character.body_bones import body_bones
from statwalk.character.character import Character
from statwalk.errors import ContentError, TextError
from statwalk.files.drawn_bones import drawn_bones
from statwalk.maths.pose import rest
from statwalk.rig.skeleton import Skeleton
from statwalk.services.library.load import load

SKELETON = """\
LeftUpperArm --- 0.3 1 0 0
LeftLowerArm LeftUpperArm 0.3 1 0 0
LeftHand LeftUpperArm 0 0 1 0
"""
FILE = """\
skeleton: arm.txt
digital_skin: |
  #vertices LeftHand
  0 0.1 0
  0.1 0.1 0
  0 0.1 0.1
  #vertices LeftUpperArm
  0 0 0
  #vertices LeftLowerArm
  0 0 0
  #polygons
  0 1 2
  2 3 4
expressions: |
  LeftHand.trans_x = 0.12 - 0.0005 * LeftLowerArm.rotate_z
  LeftHand.scale_y = 1 + LeftLowerArm.rotate_z / 180
muscle_bones: [LeftHand]
"""
"""the hand is a muscle: a name that would be taken for a hand's"""


def boned_rod(names: tuple[str, ...]) -> Character:
    """A cylinder from y = -1 to 1 with joints in it, one below the other; Muscle is a muscle bone."""
    plain = mesh(*cylinder())
    parents = np.array([-1, *range(-1, len(names) - 1)], np.int32)
    pose = rest(1 + len(names), 0)
    pose.translation[1:, 1] = [-0.9, *[0.6] * (len(names) - 1)]
    return replace(
        plain,
        skeleton=Skeleton(
            (*plain.skeleton.names, *names),
            np.where(parents < 0, -1, parents + 1).astype(np.int32),
            frozenset({"Muscle"} & set(names)),
        ),
        node_index=np.arange(1 + len(names), dtype=np.int32),
        bind_pose=pose,
    )


@pytest.fixture
def arm(tmp_path: Path) -> Character:
    (tmp_path / "arm.txt").write_text(SKELETON)
    (tmp_path / "arm.yaml").write_text(FILE)
    return load(tmp_path / "arm.yaml")


@pytest.mark.parametrize(("angle", "x", "y"), [(0, 0.12, 0.1), (45, 0.0975, 0.125), (90, 0.075, 0.15)])
def test_a_muscle_bone_follows_the_elbow_by_expressions(
    arm: Character, angle: float, x: float, y: float
) -> None:
    turned = statwalk.express(arm, f"LeftLowerArm.rotate_z = {angle}").pose
    (part,) = arm.vertices(statwalk.express(arm, pose=turned).pose)
    assert part.positions[:3] == pytest.approx(np.array([[x, y, 0], [x + 0.1, y, 0], [x, y, 0.1]]), abs=1e-6)


def test_a_muscle_bone_is_no_bone_of_the_body(arm: Character) -> None:
    assert "LeftHand" not in body_bones(arm.skeleton)
    with pytest.raises(ContentError, match="LeftHand is a muscle bone"):
        arm.solve(arm.bind_pose, ["LeftUpperArm", "LeftHand"], (0, 0, 1), "ccd")


def test_a_muscle_bone_is_drawn_without_a_line(arm: Character) -> None:
    bones = drawn_bones(arm)
    names = [arm.skeleton.names[joint] for joint in bones.joints]
    assert set(names) == {"LeftUpperArm", "LeftLowerArm", "LeftHand"}
    lines = [(names[start], names[end]) for start, end in bones.segments]
    assert lines == [("LeftUpperArm", "LeftLowerArm")]


@pytest.mark.parametrize("suffix", ["glb", "gltf", "chunk"])
def test_muscle_bones_survive_in_other_formats(arm: Character, tmp_path: Path, suffix: str) -> None:
    report = statwalk.convert(arm, tmp_path / f"other.{suffix}")
    again = load(tmp_path / f"other.{suffix}")
    assert again.skeleton.muscle_bones == {"LeftHand"}
    assert "muscle bones" not in [loss.part for loss in report.lost]
    assert [line.text for line in again.expressions] == [line.text for line in arm.expressions]


def test_formats_without_muscle_bones_say_so(arm: Character, tmp_path: Path) -> None:
    report = statwalk.convert(arm, tmp_path / "arm.bvh")
    assert ("muscle bones", ("LeftHand",)) in [(loss.part, loss.names) for loss in report.lost]


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ("[Hand]", "no joint is called 'Hand'"),
        ("[LeftUpperArm]", "LeftLowerArm hangs on LeftUpperArm: only muscle bones hang on a muscle bone"),
    ],
)
def test_what_is_no_muscle_bone_is_refused(arm: Character, tmp_path: Path, names: str, message: str) -> None:
    (tmp_path / "arm.yaml").write_text(FILE.replace("[LeftHand]", names))
    with pytest.raises(TextError, match=message) as caught:
        load(tmp_path / "arm.yaml")
    assert caught.value.place == "line 17"


@pytest.mark.parametrize("weights", ["heat", "nearest"])
def test_rigging_gives_a_muscle_bone_no_vertices(weights: str) -> None:
    """A rod along y, which two bones and a muscle bone at its upper end share: the same weights as if the
    muscle bone were not there.
    """
    rod = boned_rod(("Low", "High", "Muscle"))
    rigged = rod.autorig("own", weights)
    plain = boned_rod(("Low", "High")).autorig("own", weights)
    names = [rigged.skeleton.names[joint] for joint in rigged.skins[0].joints]
    assert names == ["Low", "High"]
    assert rigged.skeleton.muscle_bones == {"Muscle"}
    np.testing.assert_array_equal(rigged.parts[0].weights, plain.parts[0].weights)
    np.testing.assert_array_equal(rigged.parts[0].joints, plain.parts[0].joints)


def test_a_template_leaves_muscle_bones_as_they_are() -> None:
    assert boned_rod(("Low", "High", "Muscle")).autorig("parts").skeleton.muscle_bones == {"Muscle"}


def test_rigging_needs_bones_besides_muscle_bones() -> None:
    with pytest.raises(ContentError, match="no skeleton of its own besides its muscle bones"):
        boned_rod(("Low", "Muscle")).autorig("own")
