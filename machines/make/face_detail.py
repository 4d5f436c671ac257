"""Stores the order in which the vertices of face.glb collapse (docs/detail.md). It is found on the face with
the muscles of face.yaml, so that its errors hold for expressions, too.
"""

from dataclasses import replace
from pathlib import Path

import statwalk
from statwalk.character.detail.find_detail import find_detail
from statwalk.files.character_file import load_character_file
from statwalk.files.gltf.detailed_model import model_with_detail

DESCRIBED = Path(__file__).resolve().parents[1] / "face" / "face.yaml"


def store(folder: Path) -> None:
    """Stores the order in the folder's face.glb; the folder gets face.yaml."""
    path, text = folder / "face.glb", DESCRIBED.read_bytes()
    (folder / "face.yaml").write_bytes(text)
    found = find_detail(load_character_file(folder / "face.yaml"))
    plain = statwalk.load(path)
    parts = tuple(
        replace(part, collapses=other.collapses) for part, other in zip(plain.parts, found.parts, strict=True)
    )
    path.write_bytes(model_with_detail(replace(plain, parts=parts, levels=found.levels)))
