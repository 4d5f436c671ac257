"""The operations that edit the other parts of a machine, and the list of operations that a client sends."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from statwalk.files.machine_yaml.edit import operations as edit
from statwalk.machine.definition.machine_definition import BASE
from statwalk.web.schemas import operations
from statwalk.web.schemas.base import Name, RequestModel
from statwalk.web.schemas.operation_fields import (
    MOST_ENTRIES,
    ColliderFields,
    DefaultsFields,
    KeyFields,
    LayerFields,
    MachineFields,
    ParameterFields,
    Point,
    SenseFields,
    Words,
)
from statwalk.web.schemas.operations import OperationModel

LONGEST_TEXT = 1 << 18
MOST_OPERATIONS = 200


class AddParameter(OperationModel):
    """Adds a parameter."""

    of = partial(edit.AddEntry, "parameters")
    kind: Literal["add_parameter"]
    name: Name
    fields: ParameterFields
    before: Name | None = None


class SetParameter(OperationModel):
    """Changes members of a parameter."""

    of = partial(edit.SetEntry, "parameters")
    kind: Literal["set_parameter"]
    name: Name
    fields: ParameterFields


class RenameParameter(OperationModel):
    """Renames a parameter everywhere."""

    of = edit.RenameParameter
    kind: Literal["rename_parameter"]
    name: Name
    to: Name


class AddSense(OperationModel):
    """Adds a sense; `name` is the event that it raises."""

    of = partial(edit.AddEntry, "senses")
    kind: Literal["add_sense"]
    name: Name
    fields: SenseFields
    before: Name | None = None


class SetSense(OperationModel):
    """Changes members of a sense."""

    of = partial(edit.SetEntry, "senses")
    kind: Literal["set_sense"]
    name: Name
    fields: SenseFields


class AddKey(OperationModel):
    """Gives a key events, or parameters that it moves; `name` as the browser names it, but `Space`."""

    of = partial(edit.AddEntry, "keys")
    kind: Literal["add_key"]
    name: Name
    fields: KeyFields
    before: Name | None = None


class SetKey(OperationModel):
    """Changes members of a key."""

    of = partial(edit.SetEntry, "keys")
    kind: Literal["set_key"]
    name: Name
    fields: KeyFields


class AddCollider(OperationModel):
    """Adds a collider."""

    of = partial(edit.AddEntry, "colliders")
    kind: Literal["add_collider"]
    name: Name
    fields: ColliderFields
    before: Name | None = None


class SetCollider(OperationModel):
    """Changes members of a collider."""

    of = partial(edit.SetEntry, "colliders")
    kind: Literal["set_collider"]
    name: Name
    fields: ColliderFields


class RenameCollider(OperationModel):
    """Renames a collider, also in touches of this machine."""

    of = edit.RenameCollider
    kind: Literal["rename_collider"]
    name: Name
    to: Name


class DeleteEntry(OperationModel):
    """Deletes a parameter, a sense (its event), a key or a collider; refused while something names it."""

    of = edit.DeleteEntry
    kind: Literal["delete_entry"]
    section: Literal["parameters", "senses", "keys", "colliders"]
    name: Name


class MoveEntry(OperationModel):
    """Moves a parameter, a sense, a key or a collider before another, or (null) to the end."""

    of = edit.MoveEntry
    kind: Literal["move_entry"]
    section: Literal["parameters", "senses", "keys", "colliders"]
    name: Name
    before: Name | None = None


# --- layers


class AddLayer(OperationModel):
    """Adds a layer with one state, which leaves the pose as it is, below the layer `before` or on top."""

    of = edit.AddLayer
    kind: Literal["add_layer"]
    layer: Name
    fields: LayerFields = LayerFields()
    state: Name = "OFF"
    before: Name | None = None


class SetLayer(OperationModel):
    """Changes members of a layer."""

    of = edit.SetLayer
    kind: Literal["set_layer"]
    layer: Name
    fields: LayerFields


class RenameLayer(OperationModel):
    """Renames a layer."""

    of = edit.RenameLayer
    kind: Literal["rename_layer"]
    layer: Name
    to: Name


class DeleteLayer(OperationModel):
    """Deletes a layer with its table."""

    of = edit.DeleteLayer
    kind: Literal["delete_layer"]
    layer: Name


class MoveLayer(OperationModel):
    """Moves a layer below the layer `before`, or (null) on top."""

    of = edit.MoveLayer
    kind: Literal["move_layer"]
    layer: Name
    before: Name | None = None


# --- the machine


class SetMachine(OperationModel):
    """Changes what a machine says of itself."""

    of = edit.SetMachine
    kind: Literal["set_machine"]
    fields: MachineFields


class SetDefaults(OperationModel):
    """Changes what cells take that say nothing."""

    of = edit.SetDefaults
    kind: Literal["set_defaults"]
    fields: DefaultsFields


class AddProperty(OperationModel):
    """Adds a property: `JUMP only after WALK`."""

    of = edit.AddProperty
    kind: Literal["add_property"]
    text: Words


class SetProperty(OperationModel):
    """Replaces a property, named by its text; null deletes it."""

    of = edit.SetProperty
    kind: Literal["set_property"]
    property: Words
    text: Words | None


class MoveProperty(OperationModel):
    """Moves a property before another, or (null) to the end."""

    of = edit.MoveProperty
    kind: Literal["move_property"]
    property: Words
    before: Words | None = None


class SetExpressions(OperationModel):
    """Replaces the machine's expressions, a line each; blank: none."""

    of = edit.SetExpressions
    kind: Literal["set_expressions"]
    text: Annotated[str, StringConstraints(max_length=LONGEST_TEXT)]


class SetView(OperationModel):
    """Keeps where states of a layer stand in the graph, x and y; null: where the page puts them."""

    of = edit.SetView
    kind: Literal["set_view"]
    layer: Name = BASE
    positions: Annotated[dict[Name, Point | None], Field(min_length=1, max_length=MOST_ENTRIES)]


AnyOperation = Annotated[
    operations.SetCell
    | operations.AddState
    | operations.SetState
    | operations.RenameState
    | operations.DeleteState
    | operations.MoveState
    | operations.SetInitial
    | operations.SetBlendClip
    | operations.DeleteBlendClip
    | operations.SetMarker
    | operations.AddEvent
    | operations.SetEvent
    | operations.RenameEvent
    | operations.DeleteEvent
    | operations.MoveEvent
    | AddParameter
    | SetParameter
    | RenameParameter
    | AddSense
    | SetSense
    | AddKey
    | SetKey
    | AddCollider
    | SetCollider
    | RenameCollider
    | DeleteEntry
    | MoveEntry
    | AddLayer
    | SetLayer
    | RenameLayer
    | DeleteLayer
    | MoveLayer
    | SetMachine
    | SetDefaults
    | AddProperty
    | SetProperty
    | MoveProperty
    | SetExpressions
    | SetView,
    Field(discriminator="kind"),
]


class NewOperations(RequestModel):
    """Operations on a machine, applied in their order; together they make one version."""

    operations: Annotated[list[AnyOperation], Field(min_length=1, max_length=MOST_OPERATIONS)]
