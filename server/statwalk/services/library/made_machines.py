"""Makes machines in the data folder: from a character, as a copy, from a zip; and packs any machine."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from shutil import copyfile

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.character_archive import write_character
from statwalk.files.character_file import load_character_file
from statwalk.files.gltf import read_model
from statwalk.files.machine_yaml.machine_file import FILE_NAME, MachineFile, load_machine, machine_of
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.machine_yaml.new_machine import named_motions, write_folder
from statwalk.files.machine_zip import machine_zip, read_machine_zip
from statwalk.files.yaml.yaml_edit import with_value, without
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.entry import Entry
from statwalk.services.library.load import character_path, load_role
from statwalk.services.library.made_keys import NewPlace, sign
from statwalk.services.library.model_store import ModelStore
from statwalk.services.library.upload_sandbox import checked_beside, read_in_child

Files = Mapping[str, Path]
CharacterOf = Callable[[MachineFile, Path], Character]


def write(
    place: NewPlace, states: Mapping[str, str], character: Character, root: str = ""
) -> tuple[Path, Role]:
    """Writes a machine folder, loads it once, and moves it to its place in the store; returns its folder and
    the role.

    :raises ContentError: when the machine is refused.
    :raises UnknownNameError: when the character has no clip with a name in `states`.
    """
    store = place.store
    with store.working() as folder, store.working() as written:
        sha256 = _keep_character(character, folder, store)
        write_folder("", named_motions(character, states), _model(store, sha256), written, root)
        return _kept(place, written, lambda *_: character)


def copy(place: NewPlace, entry: Entry, catalogue: Catalogue) -> tuple[Path, Role]:
    """Writes a copy of a machine, as it is now but without its title, and moves it to its place in the store.

    :raises ContentError: when the machine's character is refused.
    """
    text, files = MachineText.of(entry.file.text), captured_files(entry)
    if entry.made:
        sha256 = entry.file.character_path.stem
    else:
        with place.store.working() as folder:
            sha256 = _keep_character(load_character_file(character_path(entry.file)), folder, place.store)
    untitled = text._replace(yaml=without(text.yaml, ("title",)))
    return _put(place, untitled, sha256, files, catalogue)


def unpack(
    place: NewPlace, upload: Path, catalogue: Catalogue, token: CancelToken = NEVER
) -> tuple[Path, Role]:
    """Writes the machine of a zip, and moves it to its place in the store; a child process reads its model.

    :raises ContentError: when the zip, its machine or its model is refused.
    :raises CancelledError: when the token is cancelled.
    """
    store = place.store
    with store.working() as folder, store.working() as unpacked:
        text, captures, has_model = read_machine_zip(upload, unpacked)
        if has_model:
            read_in_child(upload, folder / "model.glb", place.name, token)
            sha256, _ = store.keep_model(folder / "model.glb")
        else:
            (folder / FILE_NAME).write_text(text.yaml, encoding="utf-8")
            for table, content in text.tables.items():
                (folder / table).write_text(content, encoding="utf-8")
            sha256 = _keep_character(_shipped_character(load_machine(folder)), folder, store)
        return _put(place, text, sha256, captures, catalogue, token)


def pack(entry: Entry, store: ModelStore | None) -> bytes:
    """Returns a machine, as it is now, as a zip.

    :raises ContentError: when its character is refused.
    :raises StorageError: when its model in the data folder is damaged.
    """
    if entry.made and store is not None:
        model = store.read_model(entry.file.character_path.stem)
    else:
        model = load_character_file(character_path(entry.file)).model_glb
    captures = {path: file.read_bytes() for path, file in captured_files(entry).items()}
    return machine_zip(MachineText.of(entry.file.text), model, captures)


def captured_files(entry: Entry) -> dict[str, Path]:
    """Returns the captures that a machine's file names, by the paths in it."""
    return {line.path: entry.folder / line.path for line in entry.file.captures}


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
    """Keeps a character as its model says, so that it is the same when the model is read again. That of an
    upload is kept already.
    """
    sha256 = hashlib.sha256(character.model_glb).hexdigest()
    if not checked_beside(store.model(sha256)).is_file():
        model = folder / "model.glb"
        model.write_bytes(character.model_glb)
        write_character(read_model(character.model_glb, character.name), checked_beside(model))
        store.keep_model(model)
    return sha256


def _put(
    place: NewPlace,
    text: MachineText,
    sha256: str,
    files: Files,
    catalogue: Catalogue,
    token: CancelToken = NEVER,
) -> tuple[Path, Role]:
    """Writes a machine whose character is a model of the store."""
    model = str(_model(place.store, sha256))
    with place.store.working() as written:
        whole = text._replace(yaml=with_value(text.yaml, ("character",), model)).whole()
        machine = machine_of(whole, written)
        used = MachineText.of(machine.text)  # without tables that it does not name
        for path, content in {FILE_NAME: used.yaml, **used.tables}.items():
            (written / path).write_bytes(content.encode())
        for path in {line.path for line in machine.captures} & files.keys():
            (written / path).parent.mkdir(parents=True, exist_ok=True)
            copyfile(files[path], written / path)
        return _kept(place, written, partial(catalogue.checked.of_machine, place.store, token=token))


def _kept(place: NewPlace, written: Path, character_of: CharacterOf) -> tuple[Path, Role]:
    """Loads a machine once, and moves its folder to its place."""
    role = load_role(written, place.name, character_of=character_of)
    sign(written, place.key)
    return place.store.keep_machine(place.name, written), role
