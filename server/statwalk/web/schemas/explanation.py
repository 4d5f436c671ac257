"""The bodies that explain events (why, why not), and the bodies about travel."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from statwalk.web.schemas.base import Name, Place, RequestModel, ResponseModel, Values, VerdictWord


class NewTravel(RequestModel):
    """The state to which an actor travels."""

    state: Name


class StepView(ResponseModel):
    """A step of a travel: in `state`, `event` is sent (END: the end of the motion); `seconds` is
    an estimate.
    """

    state: str
    event: str
    seconds: float


class PlanView(ResponseModel):
    """A path to the state `goal`; the first event counts in the tick after `tick` of `stage`: the stage, or a
    fork if the playhead is in the past. `seconds` is an estimate.
    """

    goal: str
    tick: int
    seconds: float
    steps: list[StepView]
    stage: str


class MovedView(ResponseModel):
    """A joint, and how far a transition moves it."""

    joint: str
    degrees: float
    millimetres: float


class ExplainedView(ResponseModel):
    """The verdict on one event: its cell, the values that the cell's condition read, and the joints that the
    transition moves most.
    """

    event: str
    layer: int
    verdict: VerdictWord
    reason: str
    cell: Place | None
    source: str
    line: int
    values: Values
    other: int
    from_state: str
    to_state: str
    blend_seconds: float | None
    curve: str
    joints: tuple[MovedView, ...]


class WhyView(ResponseModel):
    """The verdicts on all events of an actor in a tick.

    `states`: the state of each layer; `since`: the tick in which the actor entered it.
    """

    tick: int
    actor: int
    states: tuple[str, ...]
    since: tuple[int, ...]
    events: tuple[ExplainedView, ...]


class SendChange(ResponseModel):
    """The event, which the actor did not get, is sent in `tick`."""

    kind: Literal["send"]
    event: str
    tick: int


class MomentChange(ResponseModel):
    """The event is sent in `tick` instead of its own tick."""

    kind: Literal["moment"]
    tick: int


class HoldChange(ResponseModel):
    """The event is held, or it is released first."""

    kind: Literal["hold", "release"]
    event: str


class BufferChange(ResponseModel):
    """The event stays in the queue longer, for `seconds`."""

    kind: Literal["buffer"]
    event: str
    seconds: float


class SetChange(ResponseModel):
    """The parameter has the value `value` from `tick` on."""

    kind: Literal["set"]
    parameter: str
    value: float
    tick: int


class GoChange(ResponseModel):
    """The actor travels to `state` first."""

    kind: Literal["state"]
    state: str
    steps: list[StepView]


class CellChange(ResponseModel):
    """The table has another cell; `text` is the cell as the machine file writes it."""

    kind: Literal["cell"]
    layer: int
    state: str
    event: str
    to: str
    restart: bool
    text: str


ChangeView = Annotated[
    SendChange | MomentChange | HoldChange | BufferChange | SetChange | GoChange | CellChange,
    Field(discriminator="kind"),
]


class RemedyView(ResponseModel):
    """One change that makes the event fire, in words and as data; the server tried it in a fork, where the
    event fired in tick `fires`.
    """

    kind: str
    text: str
    change: ChangeView
    fires: int


class WhyNotView(ResponseModel):
    """Why an event did not fire, and single changes that make it fire; `remedies` is empty if the event
    fired, or if no single change helps. `cut`: the trials that the budget ended, in words; empty if all were
    tried to the end.
    """

    fired: bool
    reason: str
    remedies: tuple[RemedyView, ...]
    cut: str
