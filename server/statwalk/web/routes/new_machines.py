"""POST and DELETE /api/machines: make a machine from a character, and delete it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Depends, Response

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import ContentError
from statwalk.files.machine_yaml.machine_file import load_machine
from statwalk.files.machine_yaml.new_machine import named_motions, write_folder
from statwalk.files.machine_yaml.state_names import proposed
from statwalk.machine.definition.state_table import NAME as STATE
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_messages import Machines
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.model_store import ModelStore
from statwalk.services.limits import MOST_UPLOADS
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, registry_of
from statwalk.web.errors import Problem
from statwalk.web.routes.machines import machine_members
from statwalk.web.routes.uploads import check_name, model_store_of, room_on_disk
from statwalk.web.schemas.machine import MachineView, NewMachine

router = APIRouter(prefix="/api/machines", tags=["machines"], route_class=BoundedRoute)
RegistryDep = Annotated[Registry, Depends(registry_of)]


def _states_of(new: NewMachine, character: Character) -> dict[str, str]:
    """Returns the state of each clip that gets a state.

    :raises Problem: 422, when a state's name is invalid or stands twice, or when no clip gets a state.
    """
    if new.mapping is None:
        return proposed(character.clips)
    states = {clip: state for clip, state in new.mapping.items() if state}
    clip_of: dict[str, str] = {}
    for clip, state in states.items():
        if not STATE.fullmatch(state):
            raise Problem(
                422,
                f"{state!r} is no name for a state; use letters, digits, _ . and -, begin without . and -",
                field=f"mapping.{clip[:80]}",
            )
        if state in clip_of:
            raise Problem(
                422,
                f"{state!r} is already the state of {clip_of[state][:80]!r}; choose another name",
                field=f"mapping.{clip[:80]}",
            )
        clip_of[state] = clip
    if not states and character.clips:
        clips = list(character.clips)[:40]
        raise Problem(422, "no clip has a state; give a state to at least one", field="mapping", known=clips)
    return states


def _check_free(name: str, catalogue: Catalogue, store: ModelStore) -> None:
    """Checks that a machine may be made.

    :raises Problem: 409, when a machine or scene has this name, or the data folder holds too many machines.
    """
    if name in catalogue.scene_folders:
        raise Problem(409, f"the scene {name!r} belongs to the server; choose another name", field="name")
    if name in catalogue.entries:
        raise Problem(
            409, f"a machine is called {name!r} already; delete it, or choose another name", field="name"
        )
    if len(store.machine_folders()) >= MOST_UPLOADS:
        raise Problem(409, f"the data folder holds {MOST_UPLOADS} machines, and no more; delete one first")


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
        # the same relative path from the working folder and from the folder's place
        model = Path("..", "..", store.models.name, f"{sha256}.glb")
        write_folder(name, named_motions(character, states), model, written, root)
        file = load_machine(written)
        file.check_root(character.skeleton.names)
        role = Role.build(name, character, file.definition, file.root_joint)
        return store.keep_machine(name, written), role


@router.post("", status_code=201)
def make_machine(new: NewMachine, registry: RegistryDep, response: Response, _: LongWorkToken) -> MachineView:
    """Makes a machine from a character: a state for each clip, a complete table, an event on a key for each
    state. A character without clips gets one state, its pose at rest.

    You can play it at once.
    """
    catalogue = registry.catalogue
    store = model_store_of(catalogue)
    character = catalogue.character(new.character)
    with store.lock, room_on_disk():
        _check_free(check_name(new.name), catalogue, store)
        states = _states_of(new, character)
        try:
            catalogue.adopt(*write(new.name, states, character, store, new.root))
        except ContentError as error:
            raise Problem(422, error.message, field=error.place) from None
    response.headers["Location"] = f"/api/machines/{new.name}"
    return MachineView(**machine_members(*registry.versions.current(new.name)))


@router.delete("/{name}", status_code=204)
def delete_machine(name: str, registry: RegistryDep) -> None:
    """Deletes a machine that POST made.

    409 for other machines, and while a stage plays the machine or has it in its past.
    """
    catalogue = registry.catalogue
    if not catalogue.entry(name).made:
        raise Problem(
            409,
            f"the machine {name!r} belongs to the server; you can delete only machines that you made",
            field="name",
        )
    stages = [host.id for host in registry.all() if name in host.look(Machines())]
    if stages:
        raise Problem(
            409, f"first delete the stages that play {name!r}: {', '.join(stages[:20])}", field="name"
        )
    store = model_store_of(catalogue)
    with store.lock, room_on_disk():
        store.forget_machine(name)
        catalogue.drop(name)
        registry.versions.forget(name)
