"""The replies of a stage host: plain data that can be pickled, so that a host may live in another process."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

from statwalk.machine.travel import Plan
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.limits import ClampedJoint
from statwalk.services.access.roles import AccessRole
from statwalk.services.hosting.commands import ClockKind
from statwalk.stage.state.frame import Action, Verdict
from statwalk.stage.steps.reached import ReachedTarget

Point = tuple[float, float, float]
ClockAct = Literal["paused", "resumed", "speed", "stepped", "moved"]
"""what may be done to the clock of a stage; `moved`: the playhead, by a seek"""


@dataclass(frozen=True)
class ClockChange:
    """The newest act on the clock, at the playhead `tick`; `by`: a name for people; `viewer`: the number of
    the viewer who did it, None: a program.
    """

    what: ClockAct
    by: str
    viewer: int | None
    tick: int


@dataclass(frozen=True)
class StageStatus:
    """The status of a stage: `tick` is its playhead, `head` the newest tick, `first` the oldest tick; `pace`
    is the part of its speed at which it runs, less than 1 while it takes more time than it may.
    """

    tick: int
    head: int
    first: int
    paused: bool
    speed: float
    viewers: int
    pace: float = 1.0
    restored: int | None = None
    """the tick at which the stage came back when the server started; None: it was opened since then"""
    trouble: str = ""
    """why nothing can be kept now, such as a full disk; empty while everything is kept"""
    changed: ClockChange | None = None
    """None: nobody has touched the clock since the stage was opened or came back"""


class Camera(NamedTuple):
    """Where a viewer looks from, and at what: metres from the root of `actor`, None: on the stage."""

    viewer: int
    position: Point
    target: Point
    actor: int | None


@dataclass(frozen=True)
class Presence:
    """A viewer; `tick` None: it watches the present."""

    id: int
    role: AccessRole
    person: str
    """whose token it has; empty without tokens, and for the viewers of a link"""
    name: str = ""
    """as the viewer says"""
    actor: int | None = None
    tick: int | None = None
    follows: int | None = None
    """the viewer whose camera it gets"""


@dataclass(frozen=True)
class Present:
    """All viewers of a stage, in the order in which they came."""

    viewers: tuple[Presence, ...]


@dataclass(frozen=True)
class ActorFacts:
    """An actor at the playhead; `time` in seconds, `position` in metres, `heading` in radians about +Y."""

    id: int
    name: str
    machine: str
    state: str
    states: tuple[str, ...]
    time: float
    position: tuple[float, float, float]
    heading: float
    hash: str
    variables: Mapping[str, float]
    """the free variables of expressions"""
    channels: Mapping[str, float]
    """the channels that expressions set"""
    parameters: Mapping[str, float | tuple[float, ...]]
    """as they are set"""
    clamped: tuple[ClampedJoint, ...]
    """the joints that their limits changed, and by how much"""
    reached: tuple[ReachedTarget, ...]
    """how near the solvers of the machine file came to their targets"""


@dataclass(frozen=True)
class OriginFacts:
    """Where a fork began; `is_there`: the stage that it left is still open."""

    stage: str
    tick: int
    is_there: bool


@dataclass(frozen=True)
class InputFacts:
    """An input in words; it counts in `tick`."""

    number: int
    tick: int
    text: str


@dataclass(frozen=True)
class PlaceInTree:
    """What a stage is among the others; `inputs` are its own, which came after it was forked."""

    name: str
    scene: str | None
    machines: tuple[str, ...]
    """that it plays, or played"""
    made: float | None
    """seconds since 1970; None: not known"""
    origin: OriginFacts | None
    inputs: int
    newest_input: InputFacts | None


@dataclass(frozen=True)
class StageFacts:
    """A stage with its actors."""

    id: str
    clock: ClockKind
    rate: int
    seed: int
    seconds: float
    hash: str
    status: StageStatus
    place: PlaceInTree
    actors: tuple[ActorFacts, ...]
    asleep: bool
    """its time stands until somebody looks or asks"""


@dataclass(frozen=True)
class ActorPose:
    """An actor's pose at the playhead: local transforms, and `world` (J, 4, 4) in the stage's space;
    `position` (3,), `heading` radians.
    """

    tick: int
    state: str
    joints: tuple[str, ...]
    local: Pose
    world: Floats
    position: Floats
    heading: float


@dataclass(frozen=True)
class JointTrack:
    """The joints of an actor at T ticks from `first` on."""

    actor: int
    name: str
    joints: tuple[str, ...]
    first: int
    places: Floats
    """(T, J, 3) metres, on the stage"""
    rotations: Floats
    """(T, J, 4) to the parent"""
    root_positions: Floats
    """(T, 3) metres"""
    headings: Floats
    """(T,) radians about +Y"""


@dataclass(frozen=True)
class JointTracks:
    """The joints of all actors of a stage over a span."""

    actors: tuple[JointTrack, ...]


@dataclass(frozen=True)
class Posted:
    """The commands are in the log of `stage` (the stage, or a fork) and count in the tick after `tick`.

    `seq`: the last entry's number in the log. `outcomes`: for each entry the actor that it added, the plan of
    a travel, or None.
    """

    tick: int
    seq: int
    stage: str
    outcomes: tuple[ActorFacts | Plan | None, ...]


@dataclass(frozen=True)
class EffectsSince:
    """The actions and verdicts after the tick that the message names, up to `tick`."""

    tick: int
    actions: tuple[Action, ...]
    verdicts: tuple[Verdict, ...]


@dataclass(frozen=True)
class StateChange:
    """A layer of an actor enters `state` at `tick`."""

    tick: int
    actor: int
    layer: int
    state: str


@dataclass(frozen=True)
class StateHistory:
    """The changes of state up to `head`, oldest first."""

    head: int
    changes: tuple[StateChange, ...]


@dataclass(frozen=True)
class StageSnapshot:
    """The state at the playhead: `data` as `state_codec.from_bytes` reads it."""

    tick: int
    hash: str
    data: bytes
