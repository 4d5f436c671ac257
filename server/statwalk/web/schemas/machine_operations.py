"""The operations that edit what a machine says of itself, and the list of operations that a client sends."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from statwalk.files.machine_yaml.edit import operations as edit
from statwalk.machine.definition.machine_definition import BASE
from statwalk.web.schemas import operations, part_operations
from statwalk.web.schemas.base import Name, RequestModel
from statwalk.web.schemas.operation_fields import (
    MOST_ENTRIES,
    DefaultsFields,
    MachineFields,
    Point,
    Words,
)
from statwalk.web.schemas.operations import OperationModel

LONGEST_TEXT = 1 << 18
MOST_OPERATIONS = 200


class SetMachineOperation(OperationModel):
    """Changes what a machine says of itself."""

    of = edit.SetMachine
    kind: Literal["set_machine"]
    fields: MachineFields


class SetDefaultsOperation(OperationModel):
    """Changes what cells take that say nothing."""

    of = edit.SetDefaults
    kind: Literal["set_defaults"]
    fields: DefaultsFields


class AddPropertyOperation(OperationModel):
    """Adds a property: `JUMP only after WALK`."""

    of = edit.AddProperty
    kind: Literal["add_property"]
    text: Words


class SetPropertyOperation(OperationModel):
    """Replaces a property, named by its text; null deletes it."""

    of = edit.SetProperty
    kind: Literal["set_property"]
    property: Words
    text: Words | None


class MovePropertyOperation(OperationModel):
    """Moves a property before another, or (null) to the end."""

    of = edit.MoveProperty
    kind: Literal["move_property"]
    property: Words
    before: Words | None = None


class SetExpressionsOperation(OperationModel):
    """Replaces the machine's expressions, a line each; blank: none."""

    of = edit.SetExpressions
    kind: Literal["set_expressions"]
    text: Annotated[str, StringConstraints(max_length=LONGEST_TEXT)]


class SetViewOperation(OperationModel):
    """Keeps where states of a layer stand in the graph, x and y; null: where the page puts them."""

    of = edit.SetView
    kind: Literal["set_view"]
    layer: Name = BASE
    positions: Annotated[dict[Name, Point | None], Field(min_length=1, max_length=MOST_ENTRIES)]


AnyOperation = Annotated[
    operations.SetCellOperation
    | operations.AddStateOperation
    | operations.SetStateOperation
    | operations.RenameStateOperation
    | operations.DeleteStateOperation
    | operations.MoveStateOperation
    | operations.NestStateOperation
    | operations.UnnestStateOperation
    | operations.SetInitialOperation
    | operations.SetBlendClipOperation
    | operations.DeleteBlendClipOperation
    | operations.MoveBlendClipOperation
    | operations.SetMarkerOperation
    | operations.SetContactsOperation
    | operations.AddEventOperation
    | operations.SetEventOperation
    | operations.RenameEventOperation
    | operations.DeleteEventOperation
    | operations.MoveEventOperation
    | part_operations.AddParameterOperation
    | part_operations.SetParameterOperation
    | part_operations.RenameParameterOperation
    | part_operations.AddSenseOperation
    | part_operations.SetSenseOperation
    | part_operations.AddKeyOperation
    | part_operations.SetKeyOperation
    | part_operations.AddColliderOperation
    | part_operations.SetColliderOperation
    | part_operations.RenameColliderOperation
    | part_operations.DeleteEntryOperation
    | part_operations.MoveEntryOperation
    | part_operations.AddLayerOperation
    | part_operations.SetLayerOperation
    | part_operations.RenameLayerOperation
    | part_operations.DeleteLayerOperation
    | part_operations.MoveLayerOperation
    | SetMachineOperation
    | SetDefaultsOperation
    | AddPropertyOperation
    | SetPropertyOperation
    | MovePropertyOperation
    | SetExpressionsOperation
    | SetViewOperation,
    Field(discriminator="kind"),
]


class NewOperations(RequestModel):
    """Operations on a machine, applied in their order; together they make one version."""

    operations: Annotated[list[AnyOperation], Field(min_length=1, max_length=MOST_OPERATIONS)]
