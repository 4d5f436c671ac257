"""All operations on a machine's text."""

from statwalk.files.machine_yaml.edit.cells import SetCell
from statwalk.files.machine_yaml.edit.deleted_event import DeleteEvent
from statwalk.files.machine_yaml.edit.deleted_state import DeleteState
from statwalk.files.machine_yaml.edit.entries import AddEntry, DeleteEntry, MoveEntry, SetEntry
from statwalk.files.machine_yaml.edit.events import AddEvent, MoveEvent, RenameEvent, SetEvent
from statwalk.files.machine_yaml.edit.layers import AddLayer, DeleteLayer, MoveLayer, RenameLayer, SetLayer
from statwalk.files.machine_yaml.edit.motions import DeleteBlendClip, SetBlendClip, SetMarker
from statwalk.files.machine_yaml.edit.operation import Operation
from statwalk.files.machine_yaml.edit.parameter_names import RenameCollider, RenameParameter
from statwalk.files.machine_yaml.edit.settings import (
    AddProperty,
    MoveProperty,
    SetDefaults,
    SetExpressions,
    SetInitial,
    SetMachine,
    SetProperty,
    SetView,
)
from statwalk.files.machine_yaml.edit.states import AddState, MoveState, RenameState, SetState

__all__ = [
    "AddEntry",
    "AddEvent",
    "AddLayer",
    "AddProperty",
    "AddState",
    "DeleteBlendClip",
    "DeleteEntry",
    "DeleteEvent",
    "DeleteLayer",
    "DeleteState",
    "MoveEntry",
    "MoveEvent",
    "MoveLayer",
    "MoveProperty",
    "MoveState",
    "Operation",
    "RenameCollider",
    "RenameEvent",
    "RenameLayer",
    "RenameParameter",
    "RenameState",
    "SetBlendClip",
    "SetCell",
    "SetDefaults",
    "SetEntry",
    "SetEvent",
    "SetExpressions",
    "SetInitial",
    "SetLayer",
    "SetMachine",
    "SetMarker",
    "SetProperty",
    "SetState",
    "SetView",
]
