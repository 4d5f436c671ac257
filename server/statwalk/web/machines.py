"""GET /api/machines: what a table says, cell by cell, and what is proved about it."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated, Any

from fastapi import APIRouter, Depends

from statwalk.machine.build import MotionFacts
from statwalk.machine.graph import edges, full_table
from statwalk.machine.verify import verify
from statwalk.stage.role import Role
from statwalk.web.door import library_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.library import Entry, Library

router = APIRouter(prefix="/api/machines", tags=["machines"], route_class=BoundedRoute)
Shelf = Annotated[Library, Depends(library_of)]


def summary(entry: Entry) -> dict[str, Any]:
    """A machine in the list; its character need not be loaded for that."""
    definition = entry.file.definition
    return {
        "name": entry.name,
        "title": definition.title or entry.name,
        "description": definition.description,
        "character": entry.character,
        "states": list(definition.states),
        "events": list(definition.columns),
    }


def states(role: Role) -> list[dict[str, Any]]:
    """The states with their motions; seconds."""
    machine = role.machine
    return [
        {
            "name": name,
            "motion": machine.motions[machine.motion[row]],
            "loop": bool(machine.loop[row]),
            "duration": float(machine.duration[row]),
        }
        for row, name in enumerate(machine.states)
    ]


@router.get("")
def list_machines(library: Shelf) -> list[dict[str, Any]]:
    """The machines, the default one first."""
    names = sorted(library.entries, key=lambda name: name != library.default)
    return [summary(library.entries[name]) for name in names]


@router.get("/{name}")
def get_machine(name: str, library: Shelf) -> dict[str, Any]:
    """The full table and where each cell of it comes from, keys, parameters, the edges of its graph, and its file."""
    entry, role = library.entry(name), library.role(name)
    definition = entry.file.definition
    return summary(entry) | {
        "initial": definition.initial,
        "idle": definition.idle,
        "states": states(role),
        "table": full_table(definition),
        "rows": [list(row) for row in definition.rows],
        "keys": {key: {"press": sent.press, "release": sent.release, "hold": sent.hold} for key, sent in definition.keys.items()},
        "parameters": [asdict(parameter) for parameter in role.machine.parameters],
        "edges": edges(definition),
        "text": entry.file.text,
    }


@router.get("/{name}/verify")
def verify_machine(name: str, library: Shelf) -> dict[str, Any]:
    """What is proved about the table: undefined names, states that cannot be reached or left, cells that never fire."""
    entry, clips = library.entry(name), library.role(name).character.clips.values()
    motions = {clip.name: MotionFacts(clip.duration, clip.loop) for clip in clips}
    return {"findings": [asdict(finding) for finding in verify(entry.file.definition, motions)]}
