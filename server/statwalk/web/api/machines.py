"""GET /api/machines: what a table says, cell by cell and layer by layer, and what is proved about it."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated, Any

from fastapi import APIRouter, Depends

from statwalk.machine.authored.definition import BlendDefinition, MachineDefinition, TouchDefinition
from statwalk.machine.authored.graph import edges, full_table
from statwalk.stage.role import Role
from statwalk.web.door import catalogue_of, registry_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.catalogue import Catalogue, Entry
from statwalk.web.keeping.editions import Edition, findings_of, saved
from statwalk.web.keeping.registry import Registry

router = APIRouter(prefix="/api/machines", tags=["machines"], route_class=BoundedRoute)
Shelf = Annotated[Catalogue, Depends(catalogue_of)]


def summary(entry: Entry) -> dict[str, Any]:
    """A machine in the list; its character need not be loaded for that."""
    definition = entry.file.definition
    return {
        "name": entry.name,
        "title": definition.title or entry.name,
        "description": definition.description,
        "character": entry.character,
        "scene": entry.scene,
        "states": list(definition.states),
        "events": list(definition.columns),
    }


def states(role: Role, layer: int) -> list[dict[str, Any]]:
    """The states of a layer with their motions; seconds. `motion` is None where there is none, `over` names what a blend is over."""
    machine, found = role.machine, []
    tables = role.definition.tables()
    for row in machine.rows(layer):
        name, blend = machine.states[row], machine.blends[row]
        authored = tables[machine.layers[layer].name].states[name]
        has_motion = machine.motion[row] >= 0
        found.append(
            {
                "name": name,
                "motion": machine.motions[machine.motion[row]] if has_motion else None,
                "over": list(blend.over) if isinstance(blend, BlendDefinition) else [],
                "clips": list(authored.clips),
                "loop": bool(machine.loop[row]),
                "duration": float(machine.duration[row]) if has_motion else 0.0,
                "outer": authored.outer,
                "final": authored.final,
                "markers": [{"name": marker, "phase": phase} for marker, phase in machine.markers[row]],
            }
        )
    return found


def layers(role: Role) -> list[dict[str, Any]]:
    """The tables of the machine, the base first."""
    machine = role.machine
    markers = {name for several in machine.markers for name, _ in several}
    return [
        {
            "name": layer.name,
            "mode": layer.mode,
            "mask": list(layer.mask),
            "weight": layer.weight if layer.weight_parameter < 0 else machine.parameters[layer.weight_parameter].name,
            "initial": machine.states[machine.initials[number]],
            "states": states(role, number),
            "table": full_table(table, markers),
            "rows": [list(row) for row in table.rows],
            "edges": edges(table, markers),
        }
        for number, (layer, table) in enumerate(zip(machine.layers, role.definition.tables().values(), strict=True))
    ]


def senses(definition: MachineDefinition) -> dict[str, Any]:
    """What raises events of itself: thresholds and touches, by event."""
    return {
        event: {"touch": [one.own, one.other], "on": one.on}
        if isinstance(one, TouchDefinition)
        else {"when": one.when, "release": one.release}
        for event, one in definition.senses.items()
    }


def parameters(role: Role) -> list[dict[str, Any]]:
    """The parameters with their bounds; `driven`: a flock sets it, whatever comes from outside."""
    flock = role.definition.flock
    driven = flock.sets.values() if flock else ()
    return [asdict(parameter) | {"driven": parameter.name in driven} for parameter in role.machine.parameters]


def view_machine(entry: Entry, role: Role, edition: Edition) -> dict[str, Any]:
    """The full tables and where each cell comes from, keys, parameters, senses, the edges of the graphs, and the file."""
    definition, every = role.definition, layers(role)
    base = {name: every[0][name] for name in ("states", "table", "rows", "edges")}
    return (
        summary(entry)
        | {"states": list(definition.states), "events": list(definition.columns)}
        | {
            "version": edition.version,
            "saved": saved(entry),
            "initial": definition.initial,
            "idle": definition.idle,
            "keys": {key: {"press": sent.press, "release": sent.release, "hold": sent.hold} for key, sent in definition.keys.items()},
            "parameters": parameters(role),
            "variables": list(role.machine.variables),
            "senses": senses(definition),
            "colliders": {name: asdict(one) for name, one in definition.colliders.items()},
            "layers": every,
            "text": edition.text,
        }
        | base
    )


@router.get("")
def list_machines(catalogue: Shelf) -> list[dict[str, Any]]:
    """The machines, the default one first."""
    names = sorted(catalogue.entries, key=lambda name: name != catalogue.default)
    return [summary(catalogue.entries[name]) for name in names]


@router.get("/{name}")
def get_machine(name: str, registry: Annotated[Registry, Depends(registry_of)]) -> dict[str, Any]:
    """The machine as it is now."""
    catalogue, editions = registry.catalogue, registry.editions
    with editions.lock:
        return view_machine(catalogue.entry(name), catalogue.role(name), editions.of(name)[-1])


@router.get("/{name}/verify")
def verify_machine(name: str, catalogue: Shelf) -> dict[str, Any]:
    """What is proved about the table: undefined names, states that cannot be reached or left, cells that never fire."""
    entry, role = catalogue.entry(name), catalogue.role(name)
    return {"findings": [asdict(finding) for finding in findings_of(entry.file, role)]}
