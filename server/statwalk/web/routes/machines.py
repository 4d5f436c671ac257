"""GET /api/machines: the tables of a machine, cell by cell and layer by layer, and the verifier's
findings.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query, Response

from statwalk.character.expressions import OWN
from statwalk.character.role import Role
from statwalk.files.machine_yaml.expression_text import expression_text
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.machine.definition.cell_definition import Defaults
from statwalk.machine.definition.sense_definition import SenseDefinition, TouchDefinition
from statwalk.services.hosting.edited_file import saved
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.entry import Entry
from statwalk.services.library.measuring import findings_of, measured
from statwalk.stage.measure.figures import UNITS
from statwalk.stage.measure.over_budget import over_budget
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, catalogue_of, registry_of
from statwalk.web.routes.layer_views import layer_views
from statwalk.web.routes.limit_views import limit_views
from statwalk.web.routes.solver_views import chain_views, solver_views
from statwalk.web.schemas.base import ResponseModel
from statwalk.web.schemas.finding import FindingsView, finding_views
from statwalk.web.schemas.machine import ExpressionView, MachineSummary, MachineView
from statwalk.web.schemas.measured import FeetView, MeasurementsView, feet_view, measured_view
from statwalk.web.schemas.table import (
    ColliderView,
    DefaultsView,
    GroundView,
    KeyView,
    ParameterView,
    SenseView,
    ThresholdView,
    TouchView,
)

router = APIRouter(prefix="/api/machines", tags=["machines"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]
RegistryDep = Annotated[Registry, Depends(registry_of)]


def summary(entry: Entry) -> MachineSummary:
    """Returns the summary of a machine, without loading its character."""
    definition = entry.file.definition
    return MachineSummary(
        name=entry.name,
        title=definition.title or entry.name,
        description=definition.description,
        character=entry.character,
        scene=entry.scene,
        states=list(definition.states),
        events=list(definition.columns),
    )


def _sense_view(sense: SenseDefinition | TouchDefinition) -> SenseView:
    if isinstance(sense, TouchDefinition):
        return TouchView(touch=(sense.own, sense.other), on=sense.on)
    return ThresholdView(when=sense.when, release=sense.release)


def _parameter_views(role: Role) -> list[ParameterView]:
    flock = role.definition.flock
    driven = flock.sets.values() if flock else ()
    return [
        ParameterView(**asdict(parameter), driven=parameter.name in driven)
        for parameter in role.machine.parameters
    ]


def _expression_views(role: Role) -> list[ExpressionView]:
    machines = {line.target for line in role.definition.expressions}
    return [
        ExpressionView(
            line=line.line,
            name=line.target.removeprefix(OWN),
            formula=line.formula.text.strip(),
            source="machine" if line.target in machines else "character",
        )
        for line in role.expressions.lines
    ]


def _defaults_view(defaults: Defaults) -> DefaultsView:
    return DefaultsView(
        when=str(defaults.when), blend=defaults.blend, curve=defaults.curve, buffer=defaults.buffer
    )


def machine_members(entry: Entry, role: Role, version: MachineVersion) -> dict[str, Any]:
    """Returns the members of `MachineView`."""
    definition, layers, text = role.definition, layer_views(role), MachineText.of(version.text)
    return {
        **dict(summary(entry)),
        "version": version.number,
        "saved": saved(entry),
        "initial": definition.initial,
        "idle": definition.idle,
        "fallback": definition.fallback,
        "foot_lock": definition.foot_lock,
        "defaults": _defaults_view(definition.defaults),
        "properties": [question.text for question in definition.properties],
        "keys": {key: KeyView.model_validate(events) for key, events in definition.keys.items()},
        "events": list(definition.columns),
        "parameters": _parameter_views(role),
        "variables": list(role.machine.variables),
        "senses": {event: _sense_view(sense) for event, sense in definition.senses.items()},
        "colliders": {
            name: ColliderView.model_validate(collider) for name, collider in definition.colliders.items()
        },
        "ground": [
            GroundView(corner=list(piece.corner), opposite=list(piece.opposite), heights=piece.heights)
            for piece in definition.ground
        ],
        "limits": limit_views(role),
        "solvers": solver_views(definition),
        "chains": chain_views(definition),
        "layers": layers,
        "expressions": _expression_views(role),
        "expression_text": expression_text(text.yaml),
        "text": text.yaml,
        "tables": dict(text.tables),
        "view": {layer: dict(places) for layer, places in definition.view.items()},
        "undo": version.before,
        "redo": version.after,
        **{name: getattr(layers[0], name) for name in ("states", "table", "rows", "edges")},
    }


@router.get("")
def list_machines(catalogue: CatalogueDep) -> list[MachineSummary]:
    """Lists the machines, the default machine first."""
    names = sorted(catalogue.entries, key=lambda name: name != catalogue.default)
    return [summary(catalogue.entries[name]) for name in names]


def encoded(view: ResponseModel, headers: Mapping[str, str] | None = None) -> Response:
    """Returns a machine as an answer. It may have megabytes, which FastAPI would encode in the event loop,
    where frames are sent; this route's thread encodes them.
    """
    return Response(view.model_dump_json(), headers=headers, media_type="application/json")


@router.get("/{name}", response_model=MachineView)
def get_machine(name: str, registry: RegistryDep) -> Response:
    """Returns the newest version of a machine."""
    return encoded(MachineView(**machine_members(*registry.versions.current(name))))


@router.get("/{name}/verify")
def verify_machine(name: str, registry: RegistryDep, token: LongWorkToken) -> FindingsView:
    """Returns the verifier's findings: errors and warnings about the tables, and the properties it proved or
    refuted.
    """
    role = registry.catalogue.role(name)
    return FindingsView(findings=finding_views(findings_of(role, registry.work, token)))


@router.get("/{name}/measure")
def measure_machine(
    name: str, registry: RegistryDep, token: LongWorkToken, cell: Annotated[str, Query(max_length=200)] = ""
) -> MeasurementsView:
    """Plays every transition of a machine from ten phases and through interruptions, or one
    (`?cell=WALK/STOP`), and returns what feet, knees, hands and joints do, and what is over the budgets of
    the machine's file.
    """
    role = registry.catalogue.role(name)
    rows = measured(role, cell, registry.work, token)
    return MeasurementsView(
        units=dict(UNITS),
        budgets={figure: budget.most for figure, budget in role.definition.budgets.items()},
        measured=[measured_view(row) for row in rows],
        findings=finding_views(list(over_budget(role.definition, rows))),
    )


@router.get("/{name}/feet")
def get_feet(name: str, catalogue: CatalogueDep) -> FeetView:
    """Returns the feet of a machine's character, and the spans of its clips in which they stand on the
    ground, with the corrections of the machine's file.
    """
    role = catalogue.role(name)
    return feet_view(role.character.skeleton, role.feet, role.contacts)
