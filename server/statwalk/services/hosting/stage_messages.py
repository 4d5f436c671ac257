"""The messages that a stage host handles, each with the type of its reply. Every message can be pickled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

from statwalk.files.skeleton_svg import Side
from statwalk.machine.definition.framing import Framing
from statwalk.services.hosting import stage_replies as replies
from statwalk.services.hosting.commands import PROGRAM, Command, Doer
from statwalk.services.publish.outbox import EncodedFrame, FrameForm, FrameKind
from statwalk.skin.skinning import Skinning
from statwalk.stage.explain import why, whynot

Reply = TypeVar("Reply", covariant=True)


class Message(Generic[Reply]):
    """A message to a stage host, which answers with a `Reply`."""


# --- inputs


@dataclass(frozen=True)
class Post(Message[replies.Posted]):
    """Posts commands at tick `at` (None: the playhead).

    At a past tick the commands go to a new fork; without `forks` the stage refuses them there.

    The first refused command raises, and the later ones do not run; a fork with a refused command is dropped.
    Without `may_fork` commands that need a new fork are refused.

    `key`: an idempotency key; a second message with the key does nothing, and gets the answer of the first,
    as long as the stage has a store.
    """

    commands: tuple[Command, ...]
    at: int | None = None
    forks: bool = True
    may_fork: bool = True
    key: str = ""


@dataclass(frozen=True)
class Edit(Message[bool]):
    """Plays another text of a machine.

    The reply is False, and nothing changes, if the stage does not play the machine, if the playhead is in the
    past, or if the stage refuses the text (another skeleton).
    """

    machine: str
    text: str


# --- time


@dataclass(frozen=True)
class Step(Message[replies.StageStatus]):
    """Steps the stage by `ticks`; viewers see each tick."""

    ticks: int
    by: Doer = PROGRAM


@dataclass(frozen=True)
class StepTo(Message[replies.StageStatus]):
    """Steps the stage up to a tick; viewers see each tick. Nothing happens at or after the tick."""

    tick: int
    by: Doer = PROGRAM


@dataclass(frozen=True)
class Seek(Message[replies.StageStatus]):
    """Moves the playhead to a past tick, for all viewers."""

    tick: int
    by: Doer = PROGRAM


@dataclass(frozen=True)
class Fork(Message[str]):
    """Opens a new stage that continues from a tick (None: the playhead) with the same past;
    replies its id.
    """

    tick: int | None = None
    name: str = ""


@dataclass(frozen=True)
class Rename(Message[replies.StageStatus]):
    """Says what people call the stage; empty: it has no name."""

    name: str


@dataclass(frozen=True)
class Pause(Message[replies.StageStatus]):
    """Stops or starts the clock."""

    paused: bool
    by: Doer = PROGRAM


@dataclass(frozen=True)
class SetSpeed(Message[replies.StageStatus]):
    """Makes the clock run faster or slower; 1 is real time."""

    speed: float
    by: Doer = PROGRAM


@dataclass(frozen=True)
class Close(Message[None]):
    """Disconnects the viewers, and cancels long work."""


# --- facts


@dataclass(frozen=True)
class Status(Message[replies.StageStatus]):
    """Asks for the status of the stage; the host answers at once, even during long work."""


@dataclass(frozen=True)
class Viewers(Message[replies.Present]):
    """Asks for the viewers of the stage; the host answers at once."""


@dataclass(frozen=True)
class Describe(Message[replies.StageFacts]):
    """Asks for the facts of the stage and its actors."""


@dataclass(frozen=True)
class DescribeActors(Message[tuple[replies.ActorFacts, ...]]):
    """Asks for the facts of one actor, or (None) of all actors."""

    actor: int | None = None


@dataclass(frozen=True)
class PoseOf(Message[replies.ActorPose]):
    """Asks for an actor's pose at the playhead."""

    actor: int


@dataclass(frozen=True)
class Machines(Message[tuple[str, ...]]):
    """Asks for the names of the machines that the stage plays, or played."""


@dataclass(frozen=True)
class Effects(Message[replies.EffectsSince]):
    """Asks for the actions and verdicts after the tick `since`; the reply waits until a crash can take none
    of them back, as viewers do.
    """

    since: int


@dataclass(frozen=True)
class History(Message[replies.StateHistory]):
    """Asks for the changes of state of every actor."""


@dataclass(frozen=True)
class Log(Message[tuple[str, ...]]):
    """Asks for the log as JSON lines, as `replay` reads it."""


@dataclass(frozen=True)
class Snapshot(Message[replies.StageSnapshot]):
    """Asks for the state at the playhead, as bytes."""


# --- frames and explanations


@dataclass(frozen=True)
class Frame(Message[EncodedFrame]):
    """Asks for the frame of a tick (None: the playhead) for a viewer."""

    kind: FrameKind
    tick: int | None = None
    skinning: Skinning | None = None
    """of `glb`; None: each character's own"""

    @property
    def form(self) -> FrameForm:
        """Returns the kind and the way of skinning."""
        return FrameForm(self.kind, self.skinning)


@dataclass(frozen=True)
class FrameFile(Message[bytes]):
    """Asks for the frame of a tick (None: the playhead) as a whole .glb; `skinning` None: each one's own."""

    tick: int | None = None
    skinning: Skinning | None = None


@dataclass(frozen=True)
class StickFigures(Message[str]):
    """Asks for an actor at some ticks as stick figures, SVG; without ticks at the playhead."""

    actor: int
    ticks: tuple[int, ...]
    side: Side


@dataclass(frozen=True)
class Recording(Message[bytes]):
    """Asks for the ticks `first` … `last` (None: the playhead) as one .glb; `camera`: see `recorded`."""

    first: int
    last: int | None = None
    camera: tuple[Framing, int | None] | None = None


@dataclass(frozen=True)
class Joints(Message[replies.JointTracks]):
    """Asks for the joints of all actors at the ticks `first` … `last`."""

    first: int
    last: int


@dataclass(frozen=True)
class Why(Message[why.Why]):
    """Asks for the verdict on every event of an actor in a tick."""

    actor: int
    tick: int


@dataclass(frozen=True)
class WhyNot(Message[whynot.WhyNot]):
    """Asks why an event did not fire for an actor in a tick, and which changes would make it fire."""

    actor: int
    event: str
    tick: int
