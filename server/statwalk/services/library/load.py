"""Loads a Character, a Role (a machine with its character) or a Scene by path or name.

This module joins files and stage, which do not import each other.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import radians
from pathlib import Path

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import ContentError, MachineError, UnknownNameError
from statwalk.files import captures
from statwalk.files.bvh.bvh_file import Position
from statwalk.files.character_yaml import load_character
from statwalk.files.gltf import read_model
from statwalk.files.machine_yaml.capture_lines import with_captures
from statwalk.files.machine_yaml.machine_file import FILE_NAME as MACHINE_FILE
from statwalk.files.machine_yaml.machine_file import MachineFile, load_machine, machine_of
from statwalk.files.scene import FILE_NAME as SCENE_FILE
from statwalk.files.scene import ActorLine, SceneFile, load_scene_file
from statwalk.files.zipped_model import load_zip
from statwalk.stage.actor import Actor
from statwalk.stage.stage import Stage

PACKAGE = Path(__file__).resolve().parents[2]
MODEL_SUFFIXES = (".glb", ".gltf")
ZIP_SUFFIX = ".zip"
TEXT_SUFFIXES = (".yaml", ".yml")
LARGEST_MODEL_BYTES = 64 << 20


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
    source: str | Path, text: str = "", *, position: Position = "replace", scale: float = 1.0
) -> Character | Role:
    """Loads a Character from a model (.glb, .gltf, .zip), a folder with one model, a motion capture (.bvh,
    .trc) or a character file (.yaml); loads a Role from a machine folder or a shipped machine's name.

    `text`: the text of another version of the machine, as `replay` finds it in a log under `name@2`. For a
    capture: `position` "replace" (a joint's position channels replace its offset) or "add", and `scale`,
    which multiplies all lengths; the file's units are kept otherwise.

    :raises ContentError: when a file is refused.
    :raises UnknownNameError: when no file, folder or shipped machine has this name.
    """
    if text:
        return _load_version(str(source).partition("@")[0], text)
    path = Path(source)
    if path.suffix.lower() in captures.SUFFIXES:
        return captures.load_capture(path, captures.Reading(position, scale))
    if path.suffix.lower() in (*MODEL_SUFFIXES, ZIP_SUFFIX, *TEXT_SUFFIXES):
        return load_character_file(path)
    if path.is_dir():
        return load_role(path) if (path / MACHINE_FILE).is_file() else _load_model_folder(path)
    return _load_shipped(str(source), "model file, machine folder or shipped machine")


def _load_shipped(name: str, kind: str = "shipped machine", text: str = "") -> Role:
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
    return _load_shipped(name, text=text)


def load_character_file(path: Path) -> Character:
    """Loads the Character of a model or character file.

    :raises ContentError: when the file does not exist, is too large, or is refused.
    """
    if not path.is_file():
        raise ContentError("there is no such file", file=str(path))
    if path.suffix.lower() in TEXT_SUFFIXES:
        return load_character(path)
    if path.suffix.lower() in captures.SUFFIXES:
        return captures.load_capture(path)
    if path.suffix.lower() == ZIP_SUFFIX:
        return load_zip(path)
    if path.stat().st_size > LARGEST_MODEL_BYTES:
        raise ContentError(f"a model may have {LARGEST_MODEL_BYTES >> 20} MiB at most", file=str(path))
    try:
        return read_model(path.read_bytes(), path.stem, path.parent)
    except ContentError as error:
        raise error.in_file(str(path)) from None


def _load_model_folder(folder: Path) -> Character:
    """Loads the Character of a folder with exactly one model and the files that the model needs.

    :raises ContentError: when the folder has no model or more than one, or the model is refused.
    """
    models = sorted(
        path for path in folder.iterdir() if path.suffix.lower() in MODEL_SUFFIXES and path.is_file()
    )
    if not models:
        raise ContentError(f"the folder holds no {MACHINE_FILE}, and no .gltf or .glb", file=str(folder))
    if len(models) > 1:
        names = ", ".join(path.name[:60] for path in models[:5])
        raise ContentError(
            f"the folder holds {len(models)} models; name the one that you want: {names}", file=str(folder)
        )
    return load_character_file(models[0])


def load_role(
    folder: Path,
    name: str = "",
    text: str = "",
    character_at: Callable[[Path], Character] = load_character_file,
) -> Role:
    """Loads the Role of a machine folder: its machine file, and the character that the file names.

    `name`: the role's name, by default the folder's; `text` replaces the machine file; `character_at` loads
    the character of a path.

    :raises ContentError: when a file is refused.
    """
    file = machine_of(text, folder) if text else load_machine(folder)
    character = with_captures(character_at(character_path(file)), file.captures, folder)
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


@dataclass(frozen=True)
class Scene:
    """The actors of a stage when it opens: for each line of the scene file its role and its places."""

    name: str
    title: str
    description: str
    seed: int
    lines: tuple[tuple[Role, ActorLine], ...]

    def enter(self, stage: Stage) -> list[Actor]:
        """Adds the actors to a stage; returns them in the order of the scene file."""
        actors: list[Actor] = []
        for role, line in self.lines:
            names, positions = zip(*line.places(), strict=True)
            heading = radians(line.heading_deg)
            actors += stage.add_many(role, [(position, heading) for position in positions], names)
        return actors

    def open(self, rate: int = 60) -> Stage:
        """Returns a new stage with the actors of the scene."""
        stage = Stage(self.seed, rate)
        self.enter(stage)
        return stage


def shipped_scenes() -> list[str]:
    """Returns the names of the shipped scenes, sorted."""
    return sorted(path.parent.name for path in shipped_machines_folder().glob(f"*/{SCENE_FILE}"))


def load_scene(source: str | Path) -> Scene:
    """Loads a scene from its folder or by a shipped scene's name; each of its machines is a sub-folder, or a
    shipped machine.

    :raises ContentError: when a file is refused.
    :raises UnknownNameError: when no folder and no shipped scene has this name.
    """
    shipped_folders = {name: shipped_machines_folder() / name for name in shipped_scenes()}
    folder = Path(source) if (Path(source) / SCENE_FILE).is_file() else shipped_folders.get(str(source))
    if folder is None:
        raise UnknownNameError("scene", str(source), shipped_folders)
    file = load_scene_file(folder)
    roles: dict[str, Role] = {}
    for line in file.actors:
        if line.machine not in roles:
            roles[line.machine] = _role_of(file, folder, line)
    return Scene(
        file.name,
        file.title,
        file.description,
        file.seed,
        tuple((roles[line.machine], line) for line in file.actors),
    )


def _role_of(file: SceneFile, folder: Path, line: ActorLine) -> Role:
    scene_machines = sorted(path.parent.name for path in folder.glob(f"*/{MACHINE_FILE}"))
    if line.machine in scene_machines:
        return load_role(folder / line.machine, f"{file.name}.{line.machine}")
    if line.machine in shipped_machines():
        return _load_shipped(line.machine)
    raise MachineError(
        str(UnknownNameError("machine", line.machine, [*scene_machines, *shipped_machines()])),
        file=file.file,
        place=f"line {line.line}",
    )
