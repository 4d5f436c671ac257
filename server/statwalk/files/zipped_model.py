"""Loads a model with its files from a zip."""

from __future__ import annotations

import tempfile
from pathlib import Path

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files import archive
from statwalk.files.gltf import read_model


def load_zip(path: Path) -> Character:
    """Loads the Character of the only model in a zip.

    :raises ContentError: when the zip or its model is refused.
    """
    with tempfile.TemporaryDirectory() as folder:
        try:
            model = archive.unpack(path, Path(folder))
        except ContentError as error:
            raise error.in_file(str(path)) from None
        try:
            return read_model(model.read_bytes(), path.stem, model.parent)
        except ContentError as error:
            raise error.in_file(f"{path}/{model.relative_to(folder)}") from None
