"""POST and DELETE /api/machines: a machine made of a character on the spot."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Response
from pydantic import Field, StringConstraints

from statwalk.character import Character
from statwalk.errors import ContentError
from statwalk.files.faqnames import proposed
from statwalk.files.machinefile import load_machine
from statwalk.files.newmachine import named_motions, write_folder
from statwalk.machine.authored.table import NAME as STATE
from statwalk.stage.role import Role
from statwalk.web.api.machines import get_machine
from statwalk.web.api.uploads import check_name, depot_of, room_on_disk
from statwalk.web.door import registry_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.depot import Depot
from statwalk.web.keeping.registry import Registry
from statwalk.web.problem import Problem
from statwalk.web.schemas import Asked, Name
from statwalk.web.settings import MOST_UPLOADS

router = APIRouter(prefix="/api/machines", tags=["machines"], route_class=BoundedRoute)
Stages = Annotated[Registry, Depends(registry_of)]
State = Annotated[str, StringConstraints(max_length=80)]


class NewMachine(Asked):
    """A machine to make of a character; `mapping` from clips to states (clips without one are left out), else as proposed."""

    name: Name
    character: Name
    mapping: Annotated[dict[str, State | None], Field(max_length=1_000)] | None = None


def states_of(new: NewMachine, character: Character) -> dict[str, str]:
    """The state of each clip that is to have one.

    :raises Problem: 422, if a state cannot be called so, is there twice, or there is none.
    """
    if new.mapping is None:
        return proposed(character.clips)
    states = {clip: state for clip, state in new.mapping.items() if state}
    clip_of: dict[str, str] = {}
    for clip, state in states.items():
        if not STATE.fullmatch(state):
            raise Problem(422, f"{state!r} is no name for a state: letters, digits and _, then also . -", field=f"mapping.{clip[:80]}")
        if state in clip_of:
            raise Problem(422, f"{state!r} is the state of {clip_of[state][:80]!r} already", field=f"mapping.{clip[:80]}")
        clip_of[state] = clip
    if not states and character.clips:
        raise Problem(422, "no clip has a state", field="mapping", known=list(character.clips)[:40])
    return states


def check_free(name: str, catalogue: Catalogue, depot: Depot) -> None:
    """409 where there is a machine of that name, or there are too many."""
    if name in catalogue.entries:
        raise Problem(409, f"there is a machine {name!r} already; delete it first, or choose another name", field="name")
    if len(depot.machine_folders()) >= MOST_UPLOADS:
        raise Problem(409, f"the data folder holds {MOST_UPLOADS} machines, which is the most it may; delete one")


def write(name: str, states: Mapping[str, str], character: Character, depot: Depot) -> tuple[Path, Role]:
    """The machine folder in its place, after it was read and checked once; the machine, ready to run.

    :raises ContentError: if the machine would have to be refused.
    :raises UnknownNameError: if a clip is none of the character's.
    """
    with depot.working() as folder, depot.working() as written:
        (folder / "model.glb").write_bytes(character.model_glb)
        sha256, _ = depot.keep_model(folder / "model.glb")
        model = Path("..", "..", depot.models.name, f"{sha256}.glb")  # from the folder's place as from the one it is written in
        write_folder(name, named_motions(character, states), model, written)
        file = load_machine(written)
        role = Role.build(name, character, file.definition, file.root_joint)
        return depot.keep_machine(name, written), role


@router.post("", status_code=201)
def make_machine(new: NewMachine, registry: Stages, response: Response) -> dict[str, Any]:
    """Makes a machine: a state for each clip, a complete table, an event on a key for each state. It is there at once."""
    catalogue = registry.catalogue
    depot = depot_of(catalogue)
    character = catalogue.character(new.character, status=422)
    with depot.lock, room_on_disk():
        check_free(check_name(new.name), catalogue, depot)
        states = states_of(new, character)
        try:
            catalogue.adopt(*write(new.name, states, character, depot))
        except ContentError as error:
            raise Problem(422, error.message, field=error.place) from None
    response.headers["Location"] = f"/api/machines/{new.name}"
    return get_machine(new.name, registry)


@router.delete("/{name}", status_code=204)
def delete_machine(name: str, registry: Stages) -> None:
    """Deletes a machine that was made here. 409 for others, and while a stage has it in its present or past."""
    catalogue = registry.catalogue
    if not catalogue.entry(name).made:
        raise Problem(409, f"the machine {name!r} belongs to a machine folder of the server", field="name")
    stages = [hosted.id for hosted in registry.all() if name in hosted.stage.roles]
    if stages:
        raise Problem(409, f"delete the stages that it is played on first: {', '.join(stages[:20])}", field="name")
    depot = depot_of(catalogue)
    with depot.lock:
        catalogue.drop(name)
        depot.forget_machine(name)
