"""The operations that edit a machine's states, cells and events, one model for each kind.

The rest is in `part_operations` and `machine_operations`; docs/edits.md has all of them in one table.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, ClassVar, Literal

from pydantic import Field, StringConstraints

from statwalk.files.machine_yaml.edit import operations as edit
from statwalk.files.machine_yaml.edit.cell_edits import LONGEST_CELL
from statwalk.files.machine_yaml.feet import MOST_SPANS
from statwalk.machine.definition.machine_definition import BASE
from statwalk.web.schemas.base import Name, RequestModel
from statwalk.web.schemas.operation_fields import CellFields, Fields, Point, StateFields, Words

Buffer = Annotated[float, Field(ge=0, le=60)]
ContactSpan = Annotated[list[Annotated[float, Field(ge=0, le=2)]], Field(min_length=2, max_length=2)]
Composite = Annotated[str, StringConstraints(max_length=80)]


class OperationModel(RequestModel):
    """The base of all operations; `of` makes what it means from the members, by their names."""

    of: ClassVar[Callable[..., edit.EditOperation]]

    def operation(self) -> edit.EditOperation:
        """Returns the operation on the machine's text."""
        members = {name: getattr(self, name) for name in type(self).model_fields if name != "kind"}
        return type(self).of(
            **{name: value.given() if isinstance(value, Fields) else value for name, value in members.items()}
        )


class SetCellOperation(OperationModel):
    """Changes a cell: `text` as in the table (empty: blank), and `fields`. `*` as `state` or `event`: the
    default of a column, or of a row.
    """

    of = edit.SetCell
    kind: Literal["set_cell"]
    state: Name
    event: Name
    layer: Name = BASE
    text: Annotated[str, StringConstraints(max_length=LONGEST_CELL)] | None = None
    fields: CellFields = CellFields()


# --- states


class OfState(OperationModel):
    """A state by its full name, as FIGHT.GUARD, and its layer."""

    state: Name
    layer: Name = BASE


class AddStateOperation(OfState):
    """Adds a state with a row of blank cells, before the state `before` or last; without a `motion` its
    character is at rest.
    """

    of = edit.AddState
    kind: Literal["add_state"]
    fields: StateFields = StateFields()
    before: Name | None = None


class SetStateOperation(OfState):
    """Changes members of a state."""

    of = edit.SetState
    kind: Literal["set_state"]
    fields: StateFields


class RenameStateOperation(OfState):
    """Renames a state everywhere; `to` is the name without the composite state around it."""

    of = edit.RenameState
    kind: Literal["rename_state"]
    to: Name


class DeleteStateOperation(OfState):
    """Deletes a state with its row; refused while cells lead to it, unless `also_cells` makes them blank."""

    of = edit.DeleteState
    kind: Literal["delete_state"]
    also_cells: bool = False


class MoveStateOperation(OfState):
    """Moves a state and its row before another state, or (null) to the end."""

    of = edit.MoveState
    kind: Literal["move_state"]
    before: Name | None = None


class NestStateOperation(OfState):
    """Puts a state into the sub-machine `into` (a full name) of the same table; where there is none of this
    name, it is made.
    """

    of = edit.NestState
    kind: Literal["nest_state"]
    into: Name


class UnnestStateOperation(OfState):
    """Takes a state out of its sub-machine, into the table around it; the last state takes the place of the
    sub-machine.
    """

    of = edit.UnnestState
    kind: Literal["unnest_state"]


class SetInitialOperation(OfState):
    """Makes a state the initial one of its layer, or of the machine around it."""

    of = edit.SetInitial
    kind: Literal["set_initial"]


class SetBlendClipOperation(OfState):
    """Puts a clip at a point of a state's blend: a number, or two."""

    of = edit.SetBlendClip
    kind: Literal["set_blend_clip"]
    clip: Words
    at: float | Point


class DeleteBlendClipOperation(OfState):
    """Takes a clip out of a state's blend, with its markers."""

    of = edit.DeleteBlendClip
    kind: Literal["delete_blend_clip"]
    clip: Words


class MoveBlendClipOperation(OfState):
    """Moves a clip of a state's blend before another, or (null) to the end; phases of the state are phases of
    its first clip.
    """

    of = edit.MoveBlendClip
    kind: Literal["move_blend_clip"]
    clip: Words
    before: Words | None = None


class SetMarkerOperation(OfState):
    """Puts a marker at a phase of a state's motion, or of one `clip` of its blend; null takes it away."""

    of = edit.SetMarker
    kind: Literal["set_marker"]
    marker: Name
    phase: Annotated[float, Field(ge=0, le=1)] | None
    clip: Words = ""


class SetContactsOperation(OperationModel):
    """Says in which spans of phase a foot stands in a clip: first 0…1, last up to a lap later; null: as found
    from the clip.
    """

    of = edit.SetContacts
    kind: Literal["set_contacts"]
    clip: Words
    foot: Words
    spans: Annotated[list[ContactSpan], Field(max_length=MOST_SPANS)] | None


# --- events


class AddEventOperation(OperationModel):
    """Adds an event: a column of blank cells in the table of a layer, or of a `composite` state; `buffer` in
    seconds.
    """

    of = edit.AddEvent
    kind: Literal["add_event"]
    event: Name
    layer: Name = BASE
    composite: Composite = ""
    before: Name | None = None
    buffer: Buffer | None = None


class SetEventOperation(OperationModel):
    """Changes the buffer of an event, seconds; null: as the defaults say."""

    of = edit.SetEvent
    kind: Literal["set_event"]
    event: Name
    buffer: Buffer | None


class RenameEventOperation(OperationModel):
    """Renames an event, or a marker, everywhere; keys follow."""

    of = edit.RenameEvent
    kind: Literal["rename_event"]
    event: Name
    to: Name


class DeleteEventOperation(OperationModel):
    """Deletes an event; refused while cells or keys have it, unless `also_cells` deletes these too."""

    of = edit.DeleteEvent
    kind: Literal["delete_event"]
    event: Name
    also_cells: bool = False


class MoveEventOperation(OperationModel):
    """Moves a column before another, or (null) to the end."""

    of = edit.MoveEvent
    kind: Literal["move_event"]
    event: Name
    layer: Name = BASE
    composite: Composite = ""
    before: Name | None = None
