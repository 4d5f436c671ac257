"""POST and DELETE /api/machines, …/rename, …/unused: make a machine, rename it, delete it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Depends, Query, Response

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import ContentError
from statwalk.files.machine_yaml.new_machine import idle_clip
from statwalk.files.machine_yaml.state_names import proposed
from statwalk.files.simple_character import simple_character
from statwalk.machine.definition.name_rule import NAME, refused_name
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_messages import Machines
from statwalk.services.library import made_machines
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.disk import room_on_disk
from statwalk.services.library.made_keys import MadeKey, NewPlace, made_by, sign
from statwalk.services.library.model_store import ModelStore
from statwalk.services.limits import MOST_UPLOADS
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, registry_of
from statwalk.web.errors import Problem
from statwalk.web.routes.edits import Key
from statwalk.web.routes.machines import machine_members
from statwalk.web.routes.uploads import check_name, model_store_of
from statwalk.web.schemas.machine import MachineView, NewMachine, NewName

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
        if not NAME.fullmatch(state):
            raise Problem(422, refused_name(state, "state"), field=f"mapping.{clip[:80]}")
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


def check_free_machine(name: str, catalogue: Catalogue, store: ModelStore) -> None:
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


def _make(new: NewMachine, catalogue: Catalogue, place: NewPlace) -> tuple[Path, Role]:
    """Writes the machine that a client asks for; returns its folder and its role."""
    if new.copy_of is not None:
        if new.character is not None or new.mapping is not None or new.empty:
            raise Problem(422, "a copy has the states and the character of its origin", field="copy_of")
        return made_machines.copy(place, catalogue.entry(new.copy_of), catalogue)
    character = simple_character() if new.character is None else catalogue.character(new.character)
    states = {idle_clip(character): "STAND"} if new.empty and character.clips else _states_of(new, character)
    return made_machines.write(place, states, character, new.root)


@router.post("", status_code=201)
def make_machine(
    new: NewMachine, registry: RegistryDep, response: Response, _: LongWorkToken, key: Key = ""
) -> MachineView:
    """Makes a machine: a copy of another (`copy_of`); from a character, with a state for each clip, a
    complete table, an event on a key for each state, or (`empty`) with one state; or, with neither, from
    nothing: a simple skeleton at rest, in one state.

    You can play it at once.
    """
    catalogue = registry.catalogue
    store = model_store_of(catalogue)
    place = NewPlace(new.name, store, MadeKey.of(key, "make", new.model_dump_json()))
    with store.lock, room_on_disk():
        name = made_by(place.key, store.machine_folders())
        if name is None:
            check_free_machine(check_name(new.name), catalogue, store)
            name = new.name
            registry.versions.forget(name)  # that a server left behind which was killed
            try:
                catalogue.adopt(*_make(new, catalogue, place))
            except ContentError as error:
                raise Problem(422, error.message, field=error.place) from None
    response.headers["Location"] = f"/api/machines/{name}"
    return MachineView(**machine_members(*registry.versions.current(name)))


@router.delete("/{name}", status_code=204)
def delete_machine(name: str, registry: RegistryDep) -> None:
    """Deletes a machine that POST made.

    409 for other machines, and while a stage plays the machine or has it in its past.
    """
    catalogue = registry.catalogue
    check_unused(name, registry)
    store = model_store_of(catalogue)
    with store.lock, room_on_disk():
        registry.versions.check_storage()
        store.forget_machine(name)
        catalogue.drop(name)
        registry.versions.forget(name)


@router.post("/{name}/rename")
def rename_machine(name: str, new: NewName, registry: RegistryDep, key: Key = "") -> MachineView:
    """Gives a machine that POST made another name; its versions come along.

    409 for other machines, and while a stage plays the machine or has it in its past.
    """
    store = model_store_of(registry.catalogue)
    made = MadeKey.of(key, "rename", name, new.to)
    with store.lock, room_on_disk():
        present = made_by(made, store.machine_folders())
        if present in (None, name):
            check_unused(name, registry)
            present = new.to
            if new.to != name:
                check_free_machine(check_name(new.to), registry.catalogue, store)
                _rename(name, new.to, registry, made)
    return MachineView(**machine_members(*registry.versions.current(present)))


def _rename(name: str, new: str, registry: Registry, key: MadeKey | None) -> None:
    catalogue = registry.catalogue
    store = model_store_of(catalogue)
    registry.versions.check_storage()
    sign(catalogue.entry(name).folder, key)
    registry.versions.copy(name, new)  # before: a server that is killed in between loses none
    folder = store.rename_machine(name, new)
    catalogue.drop(name)
    catalogue.adopt(folder)
    registry.versions.rename(name, new)


@router.get("/{name}/unused", status_code=204)
def check_machine_is_unused(
    name: str, registry: RegistryDep, besides: Annotated[str, Query(max_length=64)] = ""
) -> None:
    """Checks that a machine can be renamed or deleted, once the stage `besides` is deleted.

    409 for machines that POST did not make, and while another stage plays the machine or has it in its past.
    """
    check_unused(name, registry, besides)


def check_unused(name: str, registry: Registry, besides: str = "") -> None:
    """Checks that a machine can go.

    :raises Problem: 409, when it belongs to the server, or a stage other than `besides` plays it or has it in
        its past.
    """
    if not registry.catalogue.entry(name).made:
        raise Problem(
            409,
            f"the machine {name!r} belongs to the server; you can rename and delete only machines that you "
            "made",
            field="name",
        )
    others = [host for host in registry.all() if host.id != besides]
    stages = [host.id for host in others if name in host.look(Machines())]
    if stages:
        raise Problem(
            409, f"first delete the stages that play {name!r}: {', '.join(stages[:20])}", field="name"
        )
