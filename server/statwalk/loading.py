"""From a path or a name to something that can be used: a Character, a Role (a machine folder: character and machine), a Scene.

Here files and stage meet; below this floor neither knows the other.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from math import radians
from pathlib import Path

from statwalk.character import Character
from statwalk.errors import ContentError, MachineError, UnknownNameError
from statwalk.files import bundle
from statwalk.files.characterfile import load_character
from statwalk.files.glb import read_model
from statwalk.files.machinefile import FILE_NAME as MACHINE_FILE
from statwalk.files.machinefile import MachineFile, load_machine, machine_of
from statwalk.files.scenefile import FILE_NAME as SCENE_FILE
from statwalk.files.scenefile import ActorLine, SceneFile, load_scene_file
from statwalk.stage.actor import Actor
from statwalk.stage.role import Role
from statwalk.stage.stage import Stage

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


def machine_folders() -> dict[str, Path]:
    """The folders of all shipped machines by name, those of scenes among them: `faq-walker`, `playground.door`."""
    alone = {path.parent.name: path.parent for path in shipped_machines_folder().glob(f"*/{MACHINE_FILE}")}
    of_scenes = {
        f"{path.parent.parent.name}.{path.parent.name}": path.parent for path in shipped_machines_folder().glob(f"*/*/{MACHINE_FILE}")
    }
    return alone | of_scenes


def load(source: str | Path, text: str = "") -> Character | Role:
    """A Character from a model (.glb, .gltf, .zip), a folder with one, or a character file (.yaml); a Role from a machine folder or a
    shipped machine's name. `text`: the machine file of another version of it, as `replay` finds it in a log, under `name@2`.

    Raises ContentError where a file says something wrong and UnknownNameError where there is nothing of that name.
    """
    if text:
        return load_version(str(source).partition("@")[0], text)
    path = Path(source)
    if path.suffix.lower() in (*MODEL_SUFFIXES, ZIP_SUFFIX, *TEXT_SUFFIXES):
        return load_character_file(path)
    if path.is_dir():
        return load_role(path) if (path / MACHINE_FILE).is_file() else load_model_folder(path)
    return load_shipped(str(source), "model file, machine folder or shipped machine")


def load_shipped(name: str, kind: str = "shipped machine", text: str = "") -> Role:
    """The Role of a shipped machine, `faq-walker`, or of one that belongs to a shipped scene, `playground.door`.

    A name is looked up among those there are, never put together to a path. Raises UnknownNameError.
    """
    folders = machine_folders()
    if name not in folders:
        raise UnknownNameError(kind, name, sorted(folders))
    return load_role(folders[name], name, text)


def load_version(name: str, text: str) -> Role:
    """The Role of a machine folder or a shipped machine, with another text in the place of its machine file."""
    return load_role(Path(name), text=text) if (Path(name) / MACHINE_FILE).is_file() else load_shipped(name, text=text)


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


def load_model_folder(folder: Path) -> Character:
    """The Character of a folder that holds one model, beside the files it needs. Raises ContentError for none and for several."""
    found = sorted(path for path in folder.iterdir() if path.suffix.lower() in MODEL_SUFFIXES and path.is_file())
    if not found:
        raise ContentError(f"the folder holds no {MACHINE_FILE}, and no .gltf or .glb", file=str(folder))
    if len(found) > 1:
        names = ", ".join(path.name[:60] for path in found[:5])
        raise ContentError(f"the folder holds {len(found)} models; name the one that is wanted: {names}", file=str(folder))
    return load_character_file(found[0])


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


def load_role(folder: Path, name: str = "", text: str = "") -> Role:
    """The Role of a machine folder: its machine file, and the character that file names.

    `name`: where it is not the folder's; `text`: what counts in the place of the machine file.
    """
    file = machine_of(text, folder) if text else load_machine(folder)
    character = load_character_file(character_path(file))
    file.check_root(character.skeleton.names)
    return Role.build(name or folder.resolve().name, character, file.definition, file.root_joint)


def character_path(file: MachineFile) -> Path:
    """The model or character file of a machine; where it names another shipped machine, that one's. Raises ContentError."""
    while not file.character_path.suffix:
        name = file.character_path.name
        if name not in shipped_machines() or shipped_machines_folder() / name == file.character_path.parent:
            raise ContentError(f"character: {UnknownNameError('shipped machine', name, shipped_machines())}", file=file.definition.file)
        file = load_machine(shipped_machines_folder() / name)
    return file.character_path


@dataclass(frozen=True)
class Scene:
    """Who stands where on a stage when it opens."""

    name: str
    title: str
    description: str
    seed: int
    lines: tuple[tuple[Role, ActorLine], ...]

    def enter(self, stage: Stage) -> list[Actor]:
        """All of them come to a stage; in the order of the file."""
        found: list[Actor] = []
        for role, line in self.lines:
            names, positions = zip(*line.places(), strict=True)
            heading = radians(line.heading_deg)
            found += stage.add_many(role, [(position, heading) for position in positions], names)
        return found

    def open(self, rate: int = 60) -> Stage:
        """A new stage with all of them."""
        stage = Stage(self.seed, rate)
        self.enter(stage)
        return stage


def shipped_scenes() -> list[str]:
    """The names of the scenes that come with statwalk, sorted."""
    return sorted(path.parent.name for path in shipped_machines_folder().glob(f"*/{SCENE_FILE}"))


def load_scene(source: str | Path) -> Scene:
    """A scene, from its folder or a shipped one's name; each machine is a sub-folder of it, or a shipped machine.

    Raises ContentError where a file says something wrong and UnknownNameError where there is no such scene.
    """
    known = {name: shipped_machines_folder() / name for name in shipped_scenes()}
    folder = Path(source) if (Path(source) / SCENE_FILE).is_file() else known.get(str(source))
    if folder is None:
        raise UnknownNameError("scene", str(source), known)
    file = load_scene_file(folder)
    roles: dict[str, Role] = {}
    for line in file.actors:
        if line.machine not in roles:
            roles[line.machine] = _role_of(file, folder, line)
    return Scene(file.name, file.title, file.description, file.seed, tuple((roles[line.machine], line) for line in file.actors))


def _role_of(file: SceneFile, folder: Path, line: ActorLine) -> Role:
    own = sorted(path.parent.name for path in folder.glob(f"*/{MACHINE_FILE}"))
    if line.machine in own:
        return load_role(folder / line.machine, f"{file.name}.{line.machine}")
    if line.machine in shipped_machines():
        return load_shipped(line.machine)
    raise MachineError(
        str(UnknownNameError("machine", line.machine, [*own, *shipped_machines()])), file=file.file, place=f"line {line.line}"
    )
