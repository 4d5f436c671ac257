"""DS7 digital skin (FAQ Q20, Q21): vertex lists of bones, one list of polygons, glue between the bones."""

from pathlib import Path

import numpy as np
import pytest
import statwalk
from statwalk.character.character import Character
from statwalk.errors import TextError
from statwalk.services.library.load import load

SKELETON = "Upper --- 0.3 1 0 0\nLower Upper 0.3 1 0 0\n"
SKIN = """\
# a bar: two squares, and the glue between them
#vertices Upper
0 -0.1 0
0.2 -0.1 0
0.2 0.1 0
0 0.1 0
#vertices Lower #ff0000
0.1 -0.1 0
0.3 -0.1 0
0.3 0.1 0
0.1 0.1 0
#polygons
0 1 2 3
1 4 7 2
4 5 6 7
"""
BENT = [[0, -0.1], [0.2, -0.1], [0.2, 0.1], [0, 0.1], [0.4, 0.1], [0.4, 0.3], [0.2, 0.3], [0.2, 0.1]]
"""the corners when the lower bone, which begins at 0.3 0 0, is turned by 90 degrees: x y becomes -y x"""


@pytest.fixture
def bar(tmp_path: Path) -> Character:
    (tmp_path / "bar.txt").write_text(SKELETON)
    (tmp_path / "bar.skin.txt").write_text(SKIN)
    (tmp_path / "bar.yaml").write_text("skeleton: bar.txt\ndigital_skin: bar.skin.txt\n")
    return load(tmp_path / "bar.yaml")


def bent(character: Character) -> np.ndarray:
    pose = statwalk.express(character, "Lower.rotate_z = 90").pose
    (part,) = character.vertices(pose)
    return part.positions


def test_each_vertex_moves_with_its_own_bone(bar: Character) -> None:
    assert bent(bar) == pytest.approx(np.c_[BENT, np.zeros(8)], abs=1e-6)


def test_glue_polygons_stretch_between_the_bones(bar: Character) -> None:
    (glue,) = bar.glue_triangles
    assert glue.tolist() == [[1, 4, 7], [1, 7, 2]]
    (rest,) = bar.vertices(bar.bind_pose)
    edges = [np.linalg.norm(positions[4] - positions[1]) for positions in (rest.positions, bent(bar))]
    assert edges == pytest.approx([0.2, 0.2 * np.sqrt(2)], abs=1e-6)


def test_the_skin_is_one_seamless_list_of_polygons(bar: Character) -> None:
    (part,) = bar.parts
    assert part.indices is not None
    assert len(part.indices) == 3 * 6
    assert len(part.positions) == 8


def test_the_skin_may_stand_in_the_character_file_itself(bar: Character, tmp_path: Path) -> None:
    block = "".join(f"  {line}\n" for line in SKIN.splitlines())
    (tmp_path / "bar.yaml").write_text("skeleton: bar.txt\ndigital_skin: |\n" + block)
    again = load(tmp_path / "bar.yaml")
    np.testing.assert_array_equal(again.parts[0].positions, bar.parts[0].positions)


def test_a_wrong_line_of_a_block_has_its_line_in_the_file(bar: Character, tmp_path: Path) -> None:
    (tmp_path / "bar.yaml").write_text("skeleton: bar.txt\ndigital_skin: |\n  #vertices Hand\n  0 0 0\n")
    with pytest.raises(TextError, match="needs vertices and polygons"):
        load(tmp_path / "bar.yaml")
    block = "".join(f"  {line}\n" for line in SKIN.replace("Lower", "Hand").splitlines())
    (tmp_path / "bar.yaml").write_text("skeleton: bar.txt\ndigital_skin: |\n" + block)
    with pytest.raises(TextError, match="no joint is called 'Hand'") as caught:
        load(tmp_path / "bar.yaml")
    assert caught.value.place == "line 9"


@pytest.mark.parametrize("suffix", ["glb", "gltf", "zip", "chunk", "x"])
def test_the_skin_survives_in_other_formats(bar: Character, tmp_path: Path, suffix: str) -> None:
    statwalk.convert(bar, tmp_path / f"other.{suffix}")
    again = load(tmp_path / f"other.{suffix}")
    assert bent(again) == pytest.approx(bent(bar), abs=1e-6)
    assert [glue.tolist() for glue in again.glue_triangles] == [[[1, 4, 7], [1, 7, 2]]]


def test_the_faqs_text_keeps_the_digital_skin(bar: Character, tmp_path: Path) -> None:
    report = statwalk.convert(bar, tmp_path / "other.yaml")
    assert {loss.part for loss in report.lost} <= {"normals", "vertex colours"}
    again = load(tmp_path / "other.yaml")
    assert bent(again) == pytest.approx(bent(bar), abs=1e-6)
    assert [glue.tolist() for glue in again.glue_triangles] == [[[1, 4, 7], [1, 7, 2]]]
    ours, theirs = (one.parts[0].attributes["COLOR_0"] for one in (bar, again))
    np.testing.assert_array_equal(ours, theirs)
    text = (tmp_path / "other.skin.txt").read_text().splitlines()
    assert text[:2] == ["#vertices Upper", "0 -0.1 0"]
    assert "#vertices Lower #ff0000" in text


def test_a_format_without_skins_names_the_bones_of_the_digital_skin(bar: Character, tmp_path: Path) -> None:
    report = statwalk.convert(bar, tmp_path / "other.bvh")
    lost = {loss.part: loss.names for loss in report.lost}
    assert lost["digital skin"] == ("Upper", "Lower")
    assert "meshes" not in lost


def test_a_model_gets_a_digital_skin_beside_its_parts(bar: Character, tmp_path: Path) -> None:
    statwalk.convert(bar, tmp_path / "bar.glb")
    (tmp_path / "two.yaml").write_text("model: bar.glb\ndigital_skin: bar.skin.txt\n")
    two = load(tmp_path / "two.yaml")
    assert len(two.parts) == 2
    np.testing.assert_allclose(two.parts[1].positions, bar.parts[0].positions, atol=1e-7)
    (tmp_path / "again.glb").write_bytes(two.model_glb)
    assert len(load(tmp_path / "again.glb").parts) == 2
