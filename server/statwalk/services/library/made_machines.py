"""Makes machines in the data folder: from a character, as a copy, from a zip; and packs any machine."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.character_archive import write_character
from statwalk.files.character_file import load_character_file
from statwalk.files.gltf import read_model
from statwalk.files.machine_yaml.capture_lines import with_captures
from statwalk.files.machine_yaml.machine_file import FILE_NAME, MachineFile, load_machine, machine_of
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.machine_yaml.new_machine import named_motions, write_folder
from statwalk.files.machine_zip import machine_zip, read_machine_zip
from statwalk.files.yaml.yaml_edit import with_value
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.entry import Entry
from statwalk.services.library.load import character_path
from statwalk.services.library.model_store import ModelStore
from statwalk.services.library.upload_sandbox import checked_beside, read_in_child

Files = Mapping[str, bytes]


def write(
    name: str, states: Mapping[str, str], character: Character, store: ModelStore, root: str = ""
) -> tuple[Path, Role]:
    """Writes a machine folder, loads it once, and moves it to its place in the store; returns the place and
    the role.

    :raises ContentError: when the machine is refused.
    :raises UnknownNameError: when the character has no clip with a name in `states`.
    """
    with store.working() as folder, store.working() as written:
        (folder / "model.glb").write_bytes(character.model_glb)
        sha256, _ = store.keep_model(folder / "model.glb")
        write_folder(name, named_motions(character, states), _model(store, sha256), written, root)
        return _kept(name, written, character, store)


def copy(name: str, entry: Entry, catalogue: Catalogue, store: ModelStore) -> tuple[Path, Role]:
    """Writes a copy of a machine, as it is now, and moves it to its place in the store.

    :raises ContentError: when the machine's character is refused.
    """
    text, files = MachineText.of(entry.file.text), captured_files(entry)
    if entry.made:
        sha256 = entry.file.character_path.stem
    else:
        with store.working() as folder:
            sha256 = _keep_character(load_character_file(character_path(entry.file)), folder, store)
    return _put(name, text, sha256, files, catalogue, store)


def unpack(
    name: str, upload: Path, catalogue: Catalogue, store: ModelStore, token: CancelToken = NEVER
) -> tuple[Path, Role]:
    """Writes the machine of a zip, and moves it to its place in the store; a child process reads its model.

    :raises ContentError: when the zip, its machine or its model is refused.
    :raises CancelledError: when the token is cancelled.
    """
    text, has_model = read_machine_zip(upload)
    with store.working() as folder:
        if has_model:
            read_in_child(upload, folder / "model.glb", name, token)
            sha256, _ = store.keep_model(folder / "model.glb")
        else:
            (folder / FILE_NAME).write_text(text.yaml, encoding="utf-8")
            for table, content in text.tables.items():
                (folder / table).write_text(content, encoding="utf-8")
            sha256 = _keep_character(_shipped_character(load_machine(folder)), folder, store)
    return _put(name, text, sha256, {}, catalogue, store)


def pack(entry: Entry, store: ModelStore | None) -> bytes:
    """Returns a machine, as it is now, as a zip.

    :raises ContentError: when its character is refused.
    :raises StorageError: when its model in the data folder is damaged.
    """
    if entry.made and store is not None:
        model = store.read_model(entry.file.character_path.stem)
    else:
        model = load_character_file(character_path(entry.file)).model_glb
    return machine_zip(MachineText.of(entry.file.text), model, captured_files(entry))


def captured_files(entry: Entry) -> dict[str, bytes]:
    """Returns the captures that a machine's file names, by their paths."""
    return {line.path: (entry.folder / line.path).read_bytes() for line in entry.file.captures}


def _shipped_character(file: MachineFile) -> Character:
    """The character of a shipped machine that a machine file names.

    :raises MachineError: when it names a file.
    """
    if file.character_path.suffix:
        raise MachineError(
            f"the zip holds no {file.character_path.name[:80]}; "
            "put the character beside machine.yaml, as one .glb, or as a .gltf with its files"
        )
    return load_character_file(character_path(file))


def _model(store: ModelStore, sha256: str) -> Path:
    # the same relative path from the working folder and from the folder's place
    return Path("..", "..", store.models.name, f"{sha256}.glb")


def _keep_character(character: Character, folder: Path, store: ModelStore) -> str:
    """Keeps a character as its model says, so that it is the same when the model is read again."""
    model = folder / "model.glb"
    model.write_bytes(character.model_glb)
    write_character(read_model(character.model_glb, character.name), checked_beside(model))
    return store.keep_model(model)[0]


def _put(
    name: str, text: MachineText, sha256: str, files: Files, catalogue: Catalogue, store: ModelStore
) -> tuple[Path, Role]:
    """Writes a machine whose character is a model of the store."""
    if any("/" in path for path in files):
        raise MachineError("its captures are in a folder of their own; put them beside machine.yaml first")
    model = str(_model(store, sha256))
    with store.working() as written:
        whole = text._replace(yaml=with_value(text.yaml, ("character",), model)).whole()
        used = MachineText.of(machine_of(whole, written).text)  # without tables that it does not name
        texts = {FILE_NAME: used.yaml.encode()} | {path: data.encode() for path, data in used.tables.items()}
        for path, data in {**texts, **files}.items():
            (written / path).write_bytes(data)
        return _kept(name, written, catalogue.checked.character(store, sha256), store)


def _kept(name: str, written: Path, character: Character, store: ModelStore) -> tuple[Path, Role]:
    """Loads a machine once, and moves its folder to its place."""
    file = load_machine(written)
    whole = with_captures(character, file.captures, written)
    file.check_root(whole.skeleton.names)
    role = Role.build(name, whole, file.definition, file.root_joint)
    return store.keep_machine(name, written), role
