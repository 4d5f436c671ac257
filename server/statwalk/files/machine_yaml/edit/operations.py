"""All operations on a machine's text."""

from statwalk.files.machine_yaml.edit.cell_edits import SetCell
from statwalk.files.machine_yaml.edit.deleted_event import DeleteEvent
from statwalk.files.machine_yaml.edit.deleted_state import DeleteState
from statwalk.files.machine_yaml.edit.entry_edits import AddEntry, DeleteEntry, MoveEntry, SetEntry
from statwalk.files.machine_yaml.edit.event_edits import AddEvent, MoveEvent, RenameEvent, SetEvent
from statwalk.files.machine_yaml.edit.layer_edits import (
    AddLayer,
    DeleteLayer,
    MoveLayer,
    RenameLayer,
    SetLayer,
)
from statwalk.files.machine_yaml.edit.motion_edits import (
    DeleteBlendClip,
    MoveBlendClip,
    SetBlendClip,
    SetContacts,
    SetMarker,
)
from statwalk.files.machine_yaml.edit.nested_state import NestState, UnnestState
from statwalk.files.machine_yaml.edit.operation import EditOperation
from statwalk.files.machine_yaml.edit.parameter_names import RenameCollider, RenameParameter
from statwalk.files.machine_yaml.edit.setting_edits import (
    AddProperty,
    MoveProperty,
    SetDefaults,
    SetExpressions,
    SetInitial,
    SetMachine,
    SetProperty,
    SetView,
)
from statwalk.files.machine_yaml.edit.state_edits import AddState, MoveState, RenameState, SetState

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
    "EditOperation",
    "MoveBlendClip",
    "MoveEntry",
    "MoveEvent",
    "MoveLayer",
    "MoveProperty",
    "MoveState",
    "NestState",
    "RenameCollider",
    "RenameEvent",
    "RenameLayer",
    "RenameParameter",
    "RenameState",
    "SetBlendClip",
    "SetCell",
    "SetContacts",
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
    "UnnestState",
]
