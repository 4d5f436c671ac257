"""From a path or a name to something that can be used: a Character, or a Role (a machine folder: character and machine).

Here files and stage meet; below this floor neither knows the other.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from statwalk.character import Character
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files import bundle
from statwalk.files.characterfile import load_character
from statwalk.files.glb import read_model
from statwalk.files.machinefile import load_machine
from statwalk.stage.role import Role

PACKAGE = Path(__file__).resolve().parent
MODEL_SUFFIXES = (".glb", ".gltf")
ZIP_SUFFIX = ".zip"
TEXT_SUFFIXES = (".yaml", ".yml")
LARGEST_MODEL_BYTES = 64 << 20


def shipped_machines_folder() -> Path:
    """Where the machines that come with statwalk are: in the wheel, or in the checkout of an editable install."""
    inside = PACKAGE / "machines"
    return inside if inside.is_dir() else PACKAGE.parent.parent / "machines"


def shipped_machines() -> list[str]:
    """The names of the machines that come with statwalk, sorted."""
    return sorted(path.parent.name for path in shipped_machines_folder().glob("*/machine.yaml"))


def load(source: str | Path) -> Character | Role:
    """A Character from a model (.glb, .gltf, .zip) or a character file (.yaml); a Role from a machine folder or a shipped machine's name.

    Raises ContentError where a file says something wrong and UnknownNameError where there is nothing of that name.
    """
    path = Path(source)
    if path.suffix.lower() in (*MODEL_SUFFIXES, ZIP_SUFFIX, *TEXT_SUFFIXES):
        return load_character_file(path)
    if path.is_dir():
        return load_role(path)
    if str(source) in shipped_machines():
        return load_role(shipped_machines_folder() / str(source))
    raise UnknownNameError("model file, machine folder or shipped machine", str(source), shipped_machines())


def load_character_file(path: Path) -> Character:
    """The Character of a model or character file."""
    if not path.is_file():
        raise ContentError("there is no such file", file=str(path))
    if path.suffix.lower() in TEXT_SUFFIXES:
        return load_character(path)
    if path.suffix.lower() == ZIP_SUFFIX:
        return load_zip(path)
    if path.stat().st_size > LARGEST_MODEL_BYTES:
        raise ContentError(f"the model is larger than {LARGEST_MODEL_BYTES >> 20} MiB", file=str(path))
    try:
        return read_model(path.read_bytes(), path.stem, path.parent)
    except ContentError as error:
        raise error.in_file(str(path)) from None


def load_zip(path: Path) -> Character:
    """The Character of a zip that holds a model and its files."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            model = bundle.unpack(path, Path(folder))
        except ContentError as error:
            raise error.in_file(str(path)) from None
        try:
            return read_model(model.read_bytes(), path.stem, model.parent)
        except ContentError as error:
            raise error.in_file(f"{path}/{model.relative_to(folder)}") from None


def load_role(folder: Path) -> Role:
    """The Role of a machine folder: its machine file, and the character that file names."""
    file = load_machine(folder)
    character = load_character_file(file.character_path)
    file.check_root(character.skeleton.names)
    return Role.build(folder.resolve().name, character, file.definition, file.root_joint)
