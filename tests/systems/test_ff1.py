"""FF1 glTF 2.0: any model in, what is broken refused with its place, posed frames out that the Khronos
validator accepts.
"""

from pathlib import Path

import khronos
import numpy as np
import pytest
from paths import GLTF, needs_assets
from statwalk.character.character import Character
from statwalk.errors import ModelError
from statwalk.files.gltf.template import FrameTemplate, PosedCast
from statwalk.maths.pose import Pose
from statwalk.services.library.load import load
from tiny_model import changed, gltf, model

MODELS = sorted(path.name for path in GLTF.glob("*.gl*"))


@pytest.mark.parametrize(("name", "data"), [("a.glb", model()), ("a.gltf", gltf())])
def test_both_forms_load(tmp_path: Path, name: str, data: bytes) -> None:
    (tmp_path / name).write_bytes(data)
    character = load(tmp_path / name)
    assert isinstance(character, Character)
    assert list(character.clips) == ["Bend"]


def test_a_broken_file_is_refused_with_file_and_place(tmp_path: Path) -> None:
    (tmp_path / "bad.glb").write_bytes(changed("/nodes/2/mesh", 5))
    with pytest.raises(
        ModelError, match=r"bad\.glb, /nodes/2/mesh: 5 is not the index of a mesh; there are 1"
    ):
        load(tmp_path / "bad.glb")


def at_rest(character: Character) -> PosedCast:
    return PosedCast(Pose(*(array[None] for array in character.bind_pose)), np.zeros((1, 3)), np.zeros(1))


@needs_assets
@pytest.mark.parametrize("name", MODELS)
def test_a_posed_frame_of_every_model_is_valid(name: str) -> None:
    character = load(GLTF / name)
    assert (
        khronos.errors(FrameTemplate([(character, 1)], images=True).frame(0, "0", [at_rest(character)])) == []
    )
