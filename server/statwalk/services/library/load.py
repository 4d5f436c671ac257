"""Loads a Character or a Role (a machine with its character) by path or name.

This module joins files and stage, which do not import each other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, get_args

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files import captures, model_formats
from statwalk.files.bvh.bvh_file import Position
from statwalk.files.character_file import TEXT_SUFFIXES, load_character_file
from statwalk.files.machine_yaml.capture_lines import with_captures
from statwalk.files.machine_yaml.machine_file import FILE_NAME as MACHINE_FILE
from statwalk.files.machine_yaml.machine_file import MachineFile, load_machine, machine_of
from statwalk.files.md2 import md2_file
from statwalk.files.without_meshes import without_meshes

PACKAGE = Path(__file__).resolve().parents[2]
GLTF_SUFFIXES = (".glb", ".gltf")
OPTIONS: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    ".bvh": {"position": get_args(Position), "scale": ()},
    ".trc": {"scale": ()},
    md2_file.SUFFIX: {"scale": (), "inbetween": get_args(md2_file.Inbetween)},
}
"""the options of `load` that the files of a suffix have, and their values; (): a number"""


def shipped_machines_folder() -> Path:
    """Returns the folder of the shipped machines: in the wheel, or in the checkout of an editable install."""
    inside = PACKAGE / "machines"
    return inside if inside.is_dir() else PACKAGE.parent.parent / "machines"


def shipped_machines() -> list[str]:
    """Returns the names of the shipped machines, sorted, without the machines of scenes."""
    return sorted(path.parent.name for path in shipped_machines_folder().glob("*/machine.yaml"))


def machine_folders() -> dict[str, Path]:
    """Returns the folders of all shipped machines by name, with the machines of scenes: `faq-walker`,
    `playground.door`.
    """
    top_level = {
        path.parent.name: path.parent for path in shipped_machines_folder().glob(f"*/{MACHINE_FILE}")
    }
    in_scenes = {
        f"{path.parent.parent.name}.{path.parent.name}": path.parent
        for path in shipped_machines_folder().glob(f"*/*/{MACHINE_FILE}")
    }
    return top_level | in_scenes


def load(
    source: str | Path,
    text: str = "",
    *,
    position: Position | None = None,
    scale: float | None = None,
    inbetween: md2_file.Inbetween | None = None,
    without: Sequence[str] = (),
) -> Character | Role:
    """Loads a Character from a model of any format (.glb, .gltf, .zip, .bvh, .trc …: `model_formats`), a
    folder with one model, or a character file (.yaml); loads a Role from a machine folder or a shipped
    machine's name.

    `text`: the text of another version of the machine, as `replay` finds it in a log under `name@2`. The
    others say how a capture or an .md2 is read (`OPTIONS`): `position` "replace" (the default: a joint's
    position channels replace its offset) or "add"; `scale` multiplies all lengths, 1 by default; `inbetween`
    "linear" (the default: vertices go from frame to frame) or "switched" (they switch half-way). `without`
    leaves meshes out of a character: `without_meshes`.

    :raises ContentError: when a file is refused, or an option that its format does not have is given.
    :raises UnknownNameError: when no file, folder or shipped machine has this name.
    """
    path = Path(source)
    options = {"position": position, "scale": scale, "inbetween": inbetween}
    given: dict[str, Any] = {name: value for name, value in options.items() if value is not None}
    _check_options("" if text else path.suffix.lower(), given, str(source))
    if without:
        return _without(load(source, text, **given), without, str(source))
    if text:
        return _load_version(str(source).partition("@")[0], text)
    if path.suffix.lower() in captures.SUFFIXES:
        return captures.load_capture(path, captures.Reading(**given))
    if path.suffix.lower() == md2_file.SUFFIX:
        read = partial(md2_file.read_md2, **given)
        return replace(model_formats.format_of(path), read=read).load_file(path)
    if path.suffix.lower() in (*model_formats.SUFFIXES, *TEXT_SUFFIXES):
        return load_character_file(path)
    if path.is_dir():
        return load_role(path) if (path / MACHINE_FILE).is_file() else _load_model_folder(path)
    if path.is_file():
        model_formats.format_of(path)  # says which formats there are
    return load_shipped(str(source), "model file, machine folder or shipped machine")


def _check_options(suffix: str, given: Mapping[str, Any], source: str) -> None:
    """Refuses options that a format does not have, and values that an option cannot take."""
    for name, value in given.items():
        homes = [home for home, options in OPTIONS.items() if name in options]
        if suffix not in homes:
            raise ContentError(
                f"{name}= is an option of {' and '.join(homes)} files: leave it out", file=source
            )
        values = OPTIONS[suffix][name]
        if values and value not in values:
            words = " or ".join(map(repr, values))
            raise ContentError(f"{name}= should be {words}, it is {str(value)[:40]!r}", file=source)


def _without(loaded: Character | Role, meshes: Sequence[str], source: str) -> Character:
    """Returns a character without some meshes; a machine's own file says what its character is."""
    if not isinstance(loaded, Character):
        raise ContentError("without= is an option of characters, not of machines: leave it out", file=source)
    try:
        return without_meshes(loaded, meshes)
    except ContentError as error:
        raise error.in_file(source) from None


def character_from(source: str | Path) -> Character:
    """Returns the Character of whatever `load` reads: of a machine its character.

    :raises ContentError: when a file is refused.
    :raises UnknownNameError: when no file, folder or shipped machine has this name.
    """
    loaded = load(source)
    return loaded if isinstance(loaded, Character) else loaded.character


def load_shipped(name: str, kind: str = "shipped machine", text: str = "") -> Role:
    """Returns the Role of a shipped machine: `faq-walker`, or in a scene `playground.door`.

    Looks the name up in `machine_folders()`; a name from outside never becomes part of a path.

    :raises UnknownNameError: when no shipped machine has this name.
    """
    folders = machine_folders()
    if name not in folders:
        raise UnknownNameError(kind, name, sorted(folders))
    return load_role(folders[name], name, text)


def _load_version(name: str, text: str) -> Role:
    """Returns the Role of a machine folder or a shipped machine, with `text` in place of its machine file."""
    if (Path(name) / MACHINE_FILE).is_file():
        return load_role(Path(name), text=text)
    return load_shipped(name, text=text)


def _load_model_folder(folder: Path) -> Character:
    """Loads the Character of a folder with exactly one model and the files that the model needs."""
    models = sorted(
        path for path in folder.iterdir() if path.suffix.lower() in GLTF_SUFFIXES and path.is_file()
    )
    if not models:
        raise ContentError(f"the folder holds no {MACHINE_FILE}, and no .gltf or .glb", file=str(folder))
    if len(models) > 1:
        names = ", ".join(path.name[:60] for path in models[:5])
        raise ContentError(
            f"the folder holds {len(models)} models; name the one that you want: {names}", file=str(folder)
        )
    return load_character_file(models[0])


def character_of(file: MachineFile, folder: Path) -> Character:
    """Loads the character that a machine file in `folder` names, with its captured motions.

    :raises ContentError: when a file is refused.
    """
    return with_captures(load_character_file(character_path(file)), file.captures, folder)


def load_role(
    folder: Path,
    name: str = "",
    text: str = "",
    character_of: Callable[[MachineFile, Path], Character] = character_of,
) -> Role:
    """Loads the Role of a machine folder: its machine file, and the character that the file names.

    `name`: the role's name, by default the folder's; `text` replaces the machine file; `character_of` loads
    the character of a machine file in a folder.

    :raises ContentError: when a file is refused.
    """
    file = machine_of(text, folder) if text else load_machine(folder)
    character = character_of(file, folder)
    file.check_root(character.skeleton.names)
    return Role.build(name or folder.resolve().name, character, file.definition, file.root_joint)


def character_path(file: MachineFile) -> Path:
    """Returns the path of a machine's model or character file; if `character:` names a shipped machine, the
    path of the shipped machine's character.

    :raises ContentError: when no shipped machine has the name.
    """
    while not file.character_path.suffix:
        name = file.character_path.name
        if name not in shipped_machines() or shipped_machines_folder() / name == file.character_path.parent:
            raise ContentError(
                f"character: {UnknownNameError('shipped machine', name, shipped_machines())}",
                file=file.definition.file,
            )
        file = load_machine(shipped_machines_folder() / name)
    return file.character_path
