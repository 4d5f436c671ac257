"""The operations that edit a machine's parameters, senses, keys, colliders and layers."""

from __future__ import annotations

from functools import partial
from typing import Literal

from statwalk.files.machine_yaml.edit import operations as edit
from statwalk.web.schemas.base import Name
from statwalk.web.schemas.operation_fields import (
    ColliderFields,
    KeyFields,
    LayerFields,
    ParameterFields,
    SenseFields,
)
from statwalk.web.schemas.operations import OperationModel


class AddParameterOperation(OperationModel):
    """Adds a parameter."""

    of = partial(edit.AddEntry, "parameters")
    kind: Literal["add_parameter"]
    name: Name
    fields: ParameterFields
    before: Name | None = None


class SetParameterOperation(OperationModel):
    """Changes members of a parameter."""

    of = partial(edit.SetEntry, "parameters")
    kind: Literal["set_parameter"]
    name: Name
    fields: ParameterFields


class RenameParameterOperation(OperationModel):
    """Renames a parameter everywhere."""

    of = edit.RenameParameter
    kind: Literal["rename_parameter"]
    name: Name
    to: Name


class AddSenseOperation(OperationModel):
    """Adds a sense; `name` is the event that it raises."""

    of = partial(edit.AddEntry, "senses")
    kind: Literal["add_sense"]
    name: Name
    fields: SenseFields
    before: Name | None = None


class SetSenseOperation(OperationModel):
    """Changes members of a sense."""

    of = partial(edit.SetEntry, "senses")
    kind: Literal["set_sense"]
    name: Name
    fields: SenseFields


class AddKeyOperation(OperationModel):
    """Gives a key events, or parameters that it moves; `name` as the browser names it, but `Space`."""

    of = partial(edit.AddEntry, "keys")
    kind: Literal["add_key"]
    name: Name
    fields: KeyFields
    before: Name | None = None


class SetKeyOperation(OperationModel):
    """Changes members of a key."""

    of = partial(edit.SetEntry, "keys")
    kind: Literal["set_key"]
    name: Name
    fields: KeyFields


class AddColliderOperation(OperationModel):
    """Adds a collider."""

    of = partial(edit.AddEntry, "colliders")
    kind: Literal["add_collider"]
    name: Name
    fields: ColliderFields
    before: Name | None = None


class SetColliderOperation(OperationModel):
    """Changes members of a collider."""

    of = partial(edit.SetEntry, "colliders")
    kind: Literal["set_collider"]
    name: Name
    fields: ColliderFields


class RenameColliderOperation(OperationModel):
    """Renames a collider, also in touches of this machine."""

    of = edit.RenameCollider
    kind: Literal["rename_collider"]
    name: Name
    to: Name


class DeleteEntryOperation(OperationModel):
    """Deletes a parameter, a sense (its event), a key or a collider; refused while something names it."""

    of = edit.DeleteEntry
    kind: Literal["delete_entry"]
    section: Literal["parameters", "senses", "keys", "colliders"]
    name: Name


class MoveEntryOperation(OperationModel):
    """Moves a parameter, a sense, a key or a collider before another, or (null) to the end."""

    of = edit.MoveEntry
    kind: Literal["move_entry"]
    section: Literal["parameters", "senses", "keys", "colliders"]
    name: Name
    before: Name | None = None


# --- layers


class AddLayerOperation(OperationModel):
    """Adds a layer with one state, which leaves the pose as it is, below the layer `before` or on top."""

    of = edit.AddLayer
    kind: Literal["add_layer"]
    layer: Name
    fields: LayerFields = LayerFields()
    state: Name = "OFF"
    before: Name | None = None


class SetLayerOperation(OperationModel):
    """Changes members of a layer."""

    of = edit.SetLayer
    kind: Literal["set_layer"]
    layer: Name
    fields: LayerFields


class RenameLayerOperation(OperationModel):
    """Renames a layer."""

    of = edit.RenameLayer
    kind: Literal["rename_layer"]
    layer: Name
    to: Name


class DeleteLayerOperation(OperationModel):
    """Deletes a layer with its table."""

    of = edit.DeleteLayer
    kind: Literal["delete_layer"]
    layer: Name


class MoveLayerOperation(OperationModel):
    """Moves a layer below the layer `before`, or (null) on top."""

    of = edit.MoveLayer
    kind: Literal["move_layer"]
    layer: Name
    before: Name | None = None
