"""The replies of a stage host: plain data that can be pickled, so that a host may live in another process."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from statwalk.machine.travel import Plan
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.limits import ClampedJoint
from statwalk.services.hosting.commands import ClockKind
from statwalk.stage.state.frame import Action, Verdict
from statwalk.stage.steps.reached import ReachedTarget


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
class StageFacts:
    """A stage with its actors."""

    id: str
    clock: ClockKind
    rate: int
    seed: int
    seconds: float
    hash: str
    status: StageStatus
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
