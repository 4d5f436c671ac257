"""The bodies about stages: opening, describing, moving through time."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from statwalk.services.hosting.commands import ClockKind, StageSetup
from statwalk.services.hosting.stage_replies import ClockAct
from statwalk.services.limits import MOST_ACTORS, MOST_TICKS
from statwalk.web.schemas.actor import ActorView, NewActor
from statwalk.web.schemas.base import Name, RequestModel, ResponseModel, StageName, Tick

LARGEST_SEED = 9 * 10**18
"""below 2**63, and exact as a double: the schema writes its bounds as doubles"""


class NewStage(RequestModel):
    """A stage to open; `rate` in ticks a second; with a manual clock only `step` moves it."""

    seed: Annotated[int, Field(ge=0, le=LARGEST_SEED)] | None = None
    rate: Annotated[int, Field(ge=1, le=240)] = 60
    clock: ClockKind = "real"
    actors: list[NewActor] = Field([], max_length=MOST_ACTORS, fail_fast=True)
    scene: Name | None = None
    """a scene whose actors are on the stage from the beginning; `seed` defaults to the scene's seed"""
    keep_running: bool = False
    """a real-time stage runs also while nobody looks and asks"""
    name: StageName = ""
    """what people call it"""

    def setup(self) -> StageSetup:
        """Returns the setup for the registry."""
        actors = tuple(actor.command() for actor in self.actors)
        running, name = self.keep_running, self.name.strip()
        return StageSetup(self.seed, self.rate, self.clock, actors, self.scene, running, name)


class NewFork(RequestModel):
    """A fork to open, at `tick` (null: the playhead)."""

    tick: Tick | None = None
    name: StageName = ""
    """what people call it"""


class StageNameBody(RequestModel):
    """What people call a stage; empty: nothing."""

    name: StageName


class StepBody(RequestModel):
    """The number of ticks to step forward."""

    ticks: Annotated[int, Field(ge=1, le=MOST_TICKS)] = 1


class SeekBody(RequestModel):
    """The tick to which the playhead moves."""

    tick: Tick


class PauseBody(RequestModel):
    """Whether the clock is paused."""

    paused: bool


class Speed(RequestModel):
    """The speed of the clock; 1 is real time."""

    speed: Annotated[float, Field(gt=0, le=8)]


class ClockChangeView(ResponseModel):
    """The newest act on the clock of a stage, at the playhead `tick`; `moved`: a seek."""

    what: ClockAct
    by: str
    """the name of the viewer or of the person whose token it was, `somebody`, or `a program`"""
    viewer: int | None
    """the number of the viewer who did it; null: a program"""
    tick: int


class OriginView(ResponseModel):
    """Where a fork began; `is_there` is false once the stage that it left is deleted."""

    stage: str
    tick: int
    is_there: bool


class InputView(ResponseModel):
    """An input in words; it counts in `tick`."""

    number: int
    tick: int
    text: str


class StageView(ResponseModel):
    """A stage: `tick` is its playhead, `head` the newest tick, `first` the oldest tick that you
    can seek to.
    """

    id: str
    name: str
    """what people call it; empty: nothing"""
    scene: str | None
    """with which it, or the stage that it left, was opened"""
    machines: list[str]
    """that it plays, or played"""
    made: float | None
    """seconds since 1970; null: an older version made it"""
    origin: OriginView | None
    """null: it is no fork"""
    inputs: int
    """of its own: those that came after it was forked"""
    newest_input: InputView | None
    """of its own; null: there is none"""
    unclaimed: bool
    """an input in the past made it, and no request has named it yet: it is deleted after a minute"""
    changed: ClockChangeView | None
    """null: nobody has touched the clock since the stage was opened or came back"""
    clock: ClockKind
    rate: int
    seed: int
    tick: int
    head: int
    first: int
    seconds: float
    paused: bool
    speed: float
    hash: str
    viewers: int
    restored: Tick | None
    """the tick at which the stage came back when the server started; null: it was opened since then"""
    pace: float
    """the part of the speed at which the stage runs; less than 1 while it takes more time than it may"""
    trouble: str
    """why nothing can be kept now, such as a full disk; empty while everything is kept"""
    asleep: bool
    """nobody looks and nobody asks: its time stands until somebody does"""
    full: bool
    """it has as many viewers as it may have: one more is refused"""
    actors: list[ActorView]
