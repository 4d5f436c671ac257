from pathlib import Path

import pytest
import statwalk
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files.gltf import read_model
from statwalk.services.library.convert import convert
from tiny_model import model


def test_a_conversion_says_what_was_written_and_what_was_lost(tmp_path: Path) -> None:
    report = convert("faq-walker", tmp_path / "walker.bvh", clip="walk")
    back = statwalk.load(tmp_path / "walker.bvh")
    assert isinstance(back, statwalk.Character)
    assert report.format == "BVH"
    assert {"skins", "meshes", "clips after the first"} <= {loss.part for loss in report.lost}
    assert "BVH cannot hold" in str(report)
    source = statwalk.load("faq-walker")
    assert isinstance(source, statwalk.Role)
    assert back.clips["walker"].duration == pytest.approx(source.character.clips["walk"].duration)


def test_what_the_target_holds_is_no_loss(tmp_path: Path) -> None:
    assert convert(read_model(model(), "tiny"), tmp_path / "tiny.glb").lost == ()
    assert (tmp_path / "tiny.glb").read_bytes() == model()


def test_what_cannot_be_written_is_refused(tmp_path: Path) -> None:
    source = read_model(model(), "tiny")
    with pytest.raises(ContentError, match="reads TRC files, but does not write"):
        convert(source, tmp_path / "tiny.trc")
    with pytest.raises(ContentError, match="no format has the suffix"):
        convert(source, tmp_path / "tiny.fbx")
    with pytest.raises(UnknownNameError, match="clip"):
        convert(source, tmp_path / "tiny.bvh", clip="Run")
    assert list(tmp_path.iterdir()) == []
