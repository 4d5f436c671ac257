"""The bodies about stages: opening, describing, moving through time."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from statwalk.services.hosting.commands import ClockKind, StageSetup
from statwalk.services.limits import MOST_ACTORS, MOST_TICKS
from statwalk.web.schemas.actor import ActorView, NewActor
from statwalk.web.schemas.base import Name, RequestModel, ResponseModel, Tick

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

    def setup(self) -> StageSetup:
        """Returns the setup for the registry."""
        actors = tuple(actor.command() for actor in self.actors)
        return StageSetup(self.seed, self.rate, self.clock, actors, self.scene, self.keep_running)


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


class StageView(ResponseModel):
    """A stage: `tick` is its playhead, `head` the newest tick, `first` the oldest tick that you
    can seek to.
    """

    id: str
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
    actors: list[ActorView]
