"""What the API accepts and answers. Strict: no number for a text, no text for a number, no unknown member, no NaN."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, StringConstraints

from statwalk.web.settings import MOST_ACTORS, MOST_TICKS

LATEST_TICK = 2**31 - 1
Name = Annotated[str, StringConstraints(min_length=1, max_length=80)]
Coordinate = Annotated[float, Field(ge=-1e6, le=1e6)]
Tick = Annotated[int, Field(ge=0, le=LATEST_TICK)]
ActorId = Annotated[int, Field(ge=0, le=LATEST_TICK)]
Kind = Literal["press", "hold", "release"]
Clock = Literal["real", "manual"]


class Asked(BaseModel):
    """The base of everything that comes in."""

    model_config = ConfigDict(strict=True, extra="forbid", allow_inf_nan=False, frozen=True)


class NewActor(Asked):
    """An actor to add; `position` metres, `heading_deg` the turn about y in degrees."""

    machine: Name
    name: Name | None = None
    position: Annotated[list[Coordinate], Field(min_length=3, max_length=3)] = [0.0, 0.0, 0.0]
    heading_deg: Coordinate = 0.0


class NewStage(Asked):
    """A stage to open; `rate` ticks a second; with a manual clock it moves only when asked to."""

    seed: Annotated[int, Field(ge=0, lt=2**63)] | None = None
    rate: Annotated[int, Field(ge=1, le=240)] = 60
    clock: Clock = "real"
    actors: Annotated[list[NewActor], Field(max_length=MOST_ACTORS)] = []
    scene: Name | None = None
    """a scene whose actors stand there from the beginning; `seed` is the scene's, unless one is given"""


class NewEvent(Asked):
    """An event for one actor, or for all of the stage."""

    event: Name
    actor: ActorId | None = None
    kind: Kind = "press"


class NewParameter(Asked):
    """A parameter's value for one actor, or for all of the stage."""

    parameter: Name
    value: Coordinate
    actor: ActorId | None = None


class Step(Asked):
    """So many ticks forward."""

    ticks: Annotated[int, Field(ge=1, le=MOST_TICKS)] = 1


class Seek(Asked):
    """To this tick."""

    tick: Tick


class Pause(Asked):
    """Whether the clock stands still."""

    paused: bool


class Speed(Asked):
    """How fast the clock runs; 1 is real time."""

    speed: Annotated[float, Field(gt=0, le=8)]


class Ack(Asked):
    """The viewer has this frame."""

    type: Literal["ack"]
    tick: Tick


class PostEvent(NewEvent):
    """An event, at the tick the viewer looks at, or at `tick` where it is said; in the past it makes a fork."""

    type: Literal["event"]
    ref: str | int | None = None
    tick: Tick | None = None


class PostParameter(NewParameter):
    """A parameter's value."""

    type: Literal["set"]
    ref: str | int | None = None


class Look(Seek):
    """Shows this viewer alone a tick of the past."""

    type: Literal["look"]


class Live(Asked):
    """Back to the present."""

    type: Literal["live"]


class ChooseFrames(Asked):
    """The kind of frame from now on."""

    type: Literal["frames"]
    frames: Literal["pose", "glb"]


class Ping(Asked):
    """Answered with a pong, to measure the way there and back."""

    type: Literal["ping"]
    ref: str | int | None = None


Message = Annotated[Ack | PostEvent | PostParameter | Look | Live | ChooseFrames | Ping, Field(discriminator="type")]


class ActorView(BaseModel):
    """An actor as it is at the stage's playhead."""

    id: int
    name: str
    machine: str
    state: str
    states: list[str]
    time: float
    position: list[float]
    heading_deg: float
    hash: str


class StageView(BaseModel):
    """A stage: `tick` is its playhead, `head` the newest tick, `first` the oldest one can go back to."""

    id: str
    clock: Clock
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
    actors: list[ActorView]


class Accepted(BaseModel):
    """An input was logged: it counts in the tick after `tick`; `seq` is its place in the log; `stage` a new one if it forked."""

    tick: int
    seq: int
    stage: str


class Pose(BaseModel):
    """An actor's pose: local transforms per joint, world matrices (J,4,4) row by row, the root's place on the stage."""

    tick: int
    state: str
    names: list[str]
    translation: list[list[float]]
    rotation: list[list[float]]
    scale: list[list[float]]
    weights: list[float]
    world: list[list[list[float]]]
    root: dict[str, Any]


class ProblemView(BaseModel):
    """An error: RFC 9457, with the fields that are wrong and the names that exist."""

    type: str
    title: str
    status: int
    detail: str
    errors: list[dict[str, str]]
    known: list[str] | None = None
