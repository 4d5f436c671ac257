from dataclasses import replace
from pathlib import Path

import pytest
from statwalk.errors import ContentError
from statwalk.files.character_file import load_character_file
from statwalk.files.file_format import FileFormat, Loss
from statwalk.files.gltf import read_model
from statwalk.files.held_parts import EVERY_PART
from statwalk.files.model_formats import FORMATS, format_of, format_that_starts
from tiny_model import model

WRITTEN = [row for row in FORMATS if row.write is not None]


def test_no_two_formats_have_a_suffix() -> None:
    suffixes = [suffix for row in FORMATS for suffix in row.suffixes]
    assert len(set(suffixes)) == len(suffixes)


@pytest.mark.parametrize("row", FORMATS, ids=lambda row: row.name)
def test_a_format_names_kinds_of_parts_that_exist(row: FileFormat) -> None:
    assert row.holds <= EVERY_PART
    assert row.instead.keys() <= EVERY_PART - row.holds


@pytest.mark.parametrize("row", WRITTEN, ids=lambda row: row.name)
def test_a_written_file_is_known_by_its_start_and_read_again(row: FileFormat, tmp_path: Path) -> None:
    assert row.write is not None
    path = tmp_path / f"tiny{row.suffixes[0]}"
    path.write_bytes(row.write(read_model(model(), "tiny")))
    assert format_that_starts(path.read_bytes()[:64]) is row
    back = load_character_file(path)
    joints = {"model"} if row.name == "MD2" else {"hip", "knee"}  # MD2 has frames, and no joints
    assert joints <= set(back.skeleton.names)
    assert back.name == "tiny"
    assert back.model_glb


def test_a_vrm_is_read_as_the_glb_that_it_is(tmp_path: Path) -> None:
    (tmp_path / "tiny.vrm").write_bytes(model())
    assert {"hip", "knee"} <= set(load_character_file(tmp_path / "tiny.vrm").skeleton.names)


def test_an_unknown_suffix_lists_the_known_ones() -> None:
    with pytest.raises(ContentError, match=r"\.glb.*\.bvh"):
        format_of(Path("fox.fbx"))


def test_a_loss_says_what_and_what_instead() -> None:
    source = replace(read_model(model(), "tiny"), notes=())
    lost = format_of(Path("x.bvh")).losses(source)
    assert Loss("skins", ("skin 0",)) in lost
    assert str(Loss("clips", ("a", "b"), "as frames")) == "clips: a, b (as frames)"
    assert str(Loss("x", tuple("abcdefghij"))) == "x: a, b, c, d, e, f, g, h … and 2 more"


def test_what_a_gltf_model_has_a_glb_holds() -> None:
    assert format_of(Path("x.glb")).losses(read_model(model(), "tiny")) == ()


def test_a_missing_and_a_large_file_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ContentError, match="no such file"):
        format_of(Path("x.bvh")).load_file(tmp_path / "x.bvh")
    with (tmp_path / "x.bvh").open("wb") as file:
        file.truncate((64 << 20) + 1)
    with pytest.raises(ContentError, match="64 MiB"):
        format_of(Path("x.bvh")).load_file(tmp_path / "x.bvh")
