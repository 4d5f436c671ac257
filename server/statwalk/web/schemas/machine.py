"""The bodies about machines: lists, descriptions, new machines, edits, versions."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from statwalk.files.machine_yaml.edit.cell_edits import LONGEST_CELL
from statwalk.machine.definition.machine_definition import BASE
from statwalk.web.schemas.base import FileName, Name, RequestModel, ResponseModel
from statwalk.web.schemas.finding import FindingView
from statwalk.web.schemas.problem import FieldError
from statwalk.web.schemas.table import (
    CellView,
    ColliderView,
    DefaultsView,
    EdgeView,
    GroundView,
    KeyView,
    LayerView,
    ParameterView,
    SenseView,
    StateView,
)

LONGEST_TEXT = 1 << 18
MOST_TABLES = 32
Table = Annotated[str, StringConstraints(max_length=LONGEST_TEXT)]
NewState = Annotated[str, StringConstraints(max_length=80)]


class NewName(RequestModel):
    """Another name for a machine."""

    to: FileName


class NewMachine(RequestModel):
    """A machine to make: a copy of the machine `copy_of`, or from a character, or from nothing: then it has
    a simple skeleton. `mapping` gives a state for each clip (a clip without a state is left out), by default
    the proposed mapping; `empty`: one state only. `root`: the joint that moves the character through the
    world.
    """

    name: FileName
    character: Name | None = None
    copy_of: Name | None = None
    empty: bool = False
    mapping: Annotated[dict[str, NewState | None], Field(max_length=1_000)] | None = None
    root: Annotated[str, StringConstraints(max_length=200)] = ""


class NewText(RequestModel):
    """The whole text of a machine file; `tables`: its .csv tables by the names of their files, if they change
    too.
    """

    text: Annotated[str, StringConstraints(min_length=1, max_length=LONGEST_TEXT)]
    tables: Annotated[dict[Name, Table], Field(max_length=MOST_TABLES)] | None = None


class NewCell(RequestModel):
    """A new text for one cell of a table; an empty text makes the cell blank."""

    state: Name
    event: Name
    text: Annotated[str, StringConstraints(max_length=LONGEST_CELL)]
    layer: Name = BASE


class NewExpressions(RequestModel):
    """New expressions for a machine, a line each; blank: none."""

    text: Annotated[str, StringConstraints(max_length=LONGEST_TEXT)]


class MachineSummary(ResponseModel):
    """A machine in the list; `scene` is the scene whose folder holds it, or empty."""

    name: str
    title: str
    description: str
    character: str
    scene: str
    states: list[str]
    events: list[str]


class FreedomView(ResponseModel):
    """A degree of freedom of a joint: degrees if it is an angle, else metres; null: not limited."""

    name: str
    is_angle: bool
    minimum: float | None
    maximum: float | None


class LimitView(ResponseModel):
    """The limits of a joint. `type` and `symbol` are empty for limits of each axis; `frame` x y z w turns Y
    into the joint's axis; `rest`: translation x y z and rotation x y z w of the rest pose; `pitch`: metres a
    turn of a helical joint, else 0.
    """

    joint: str
    type: str
    form: str
    symbol: str
    shape: Literal["free", "hinge", "cone", "range", "axes"]
    frame: list[float]
    rest: list[float]
    pitch: float
    freedoms: list[FreedomView]


class ExpressionView(ResponseModel):
    """An expression: the line of its file, what it sets, the formula, and whose file it is."""

    line: int
    name: str
    formula: str
    source: Literal["machine", "character"]


class SolverView(ResponseModel):
    """A solver of the machine file: its chain from `start` to `end`, the joint that stays (`anchor`), the
    parameters of its target and its pole (null: none), the `space` of both, and its weight: a number 0…1, a
    parameter or a channel, or one of them by state of the base; `grab`: while the page drags its handle, the
    weight is 1.
    """

    name: str
    solver: str
    start: str
    end: str
    anchor: str
    target: str
    pole: str | None
    space: Literal["stage", "model"]
    weight: float | str | dict[str, float | str]
    grab: bool


class ChainView(ResponseModel):
    """A chain that hangs under gravity, from `start` to `end`, and its anchors."""

    name: str
    start: str
    end: str
    anchors: list[str]


class MachineView(ResponseModel):
    """A machine; `states`, `table`, `rows` and `edges` belong to its base, the first layer."""

    name: str
    title: str
    description: str
    character: str
    scene: str
    version: int
    """counts the edits, from 1"""
    saved: Literal["file", "memory"]
    """where edits are kept: in machine.yaml, or by the server, in its data folder if it has one"""
    initial: str
    idle: str | None
    fallback: str
    """the state of an actor whose own state is gone; empty: the initial state"""
    foot_lock: float | str
    """how much planted feet stay where they stand, 0…1, or the parameter that says so"""
    defaults: DefaultsView
    properties: list[str]
    """what must be true of the table; the findings say what is proved"""
    states: list[StateView]
    events: list[str]
    table: dict[str, dict[str, CellView]]
    rows: list[list[str]]
    edges: list[EdgeView]
    keys: dict[str, KeyView]
    parameters: list[ParameterView]
    variables: list[str]
    senses: dict[str, SenseView]
    colliders: dict[str, ColliderView]
    ground: list[GroundView]
    limits: list[LimitView]
    solvers: list[SolverView]
    chains: list[ChainView]
    layers: list[LayerView]
    expressions: list[ExpressionView]
    """assignments to channels and variables, in the order in which they run"""
    expression_text: str
    """the machine's own expressions as the file has them, with comments"""
    text: str
    """the machine file"""
    tables: dict[str, str]
    """its .csv tables, by the names of their files"""
    view: dict[str, dict[str, tuple[float, float]]]
    """by layer, where states stand in the graph, if the file says so"""
    undo: int
    """the version that an undo brings back; 0: none"""
    redo: int
    """the version that a redo brings back; 0: none"""


class EditedMachine(MachineView):
    """The machine after an edit, or after a dry run, with the verifier's findings."""

    result: Literal["accepted"] = "accepted"
    findings: list[FindingView]


class RefusedTrial(ResponseModel):
    """The answer to a dry run whose text would be refused: what is wrong in words, the places, and the
    findings that the text would add (none if it cannot be read).
    """

    result: Literal["refused"] = "refused"
    detail: str
    errors: list[FieldError]
    findings: list[FindingView]
