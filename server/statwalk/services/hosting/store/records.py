"""What the store keeps: of a stage, and of a machine that was edited. Plain data."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from statwalk.services.hosting.commands import ClockKind

MAIN = "main"


@dataclass(frozen=True)
class Origin:
    """Where a fork began: the stage that it left, the tick, and the number of the newest input before its
    own.
    """

    stage: str
    tick: int
    number: int


@dataclass(frozen=True)
class StageIdentity:
    """What never changes of a stage; `opened`: the scene or machine that it, or the stage that it left, was
    opened with; `made`: in seconds since 1970, 0 by a version that did not note it.
    """

    id: str
    opened: str
    seed: int
    rate: int
    clock: ClockKind
    keep_running: bool = False
    """it goes on though nobody watches it"""
    made: float = 0.0
    origin: Origin | None = None
    """None: it is no fork"""

    def forked(self, stage_id: str, tick: int, number: int, made: float) -> StageIdentity:
        """Returns what a fork at a tick is; `number`: of the newest input before its own."""
        origin = Origin(self.id, tick, number)
        return StageIdentity(
            stage_id, self.opened, self.seed, self.rate, self.clock, made=made, origin=origin
        )

    @property
    def stays_awake(self) -> bool:
        """Whether it goes on while nobody uses it."""
        return self.id == MAIN or self.keep_running

    @property
    def may_sleep(self) -> bool:
        """Whether its time may stand while nobody uses it."""
        return self.clock == "real" and not self.stays_awake


class Note(NamedTuple):
    """What changes of a stage without commands; `hash` is that of its state at `tick`."""

    tick: int
    head: int
    hash: str
    paused: bool
    speed: float
    name: str = ""
    """what people call the stage"""


class KeptBeginning(NamedTuple):
    """Where a stage begins whose past was forgotten; `number`: of the newest command that was forgotten."""

    tick: int
    number: int


class KeptRole(NamedTuple):
    """The text of a machine as a stage plays it, and the hash of its model."""

    text: str
    model: bytes


class KeptKey(NamedTuple):
    """The answer to a request with an idempotency key; `request`: a hash of the request, and `stage`: the
    stage that took it, which may be a fork.
    """

    request: bytes
    tick: int
    seq: int
    stage: str


@dataclass(frozen=True)
class StageRecord:
    """A stage as it was kept; `lines` is its log, `chain` the hash of the log."""

    identity: StageIdentity
    note: Note
    beginning: KeptBeginning | None
    roles: Mapping[str, KeptRole]
    lines: tuple[str, ...]
    chain: bytes
    snapshots: Mapping[int, bytes]
    keys: Mapping[str, KeptKey]


@dataclass(frozen=True)
class MachineVersion:
    """A version of a machine; `at` in seconds since 1970, `what` says in a few words what the
    edit changed.
    """

    number: int
    at: float
    what: str
    text: str
    before: int = 0
    """the version that an undo brings back; 0: there is none"""
    after: int = 0
    """the version that a redo brings back; 0: there is none"""
    author: str = ""
    """the name of who made it, if the server asks for tokens"""


def chained(before: bytes, line: str) -> bytes:
    """Returns the hash of a line and of all lines before it, whose hash is `before`."""
    return hashlib.blake2b(before + line.encode(), digest_size=16).digest()


def machine_keys(machine: str) -> str:
    """Returns what stands in the place of a stage with the keys of a machine's edits; no stage's id has a
    space.
    """
    return f"machine {machine}"


Value = str | int | float | bytes


def row_digest(*values: Value) -> bytes:
    """Returns a hash of all values of a row, its key too, by which a flipped bit is found."""
    digest = hashlib.blake2b(digest_size=16)
    for value in values:
        data = value if isinstance(value, bytes) else repr(value).encode()
        digest.update(b"%d:" % len(data))
        digest.update(data)
    return digest.digest()


def sealed(*values: Value) -> tuple[Value, ...]:
    """Returns a row with its hash."""
    return (*values, row_digest(*values))


def stage_row(identity: StageIdentity, note: Note) -> tuple[Value, ...]:
    """Returns the row of a stage, with its hash; the values are those that SQLite gives back."""
    origin = identity.origin or Origin("", 0, 0)
    return sealed(
        identity.id,
        identity.opened,
        identity.seed,
        identity.rate,
        identity.clock,
        note.tick,
        note.head,
        note.hash,
        int(note.paused),
        float(note.speed),
        int(identity.keep_running),
        note.name,
        origin.stage,
        origin.tick,
        origin.number,
        float(identity.made),
    )


def version_row(machine: str, version: MachineVersion) -> tuple[Value, ...]:
    """Returns the row of a version of a machine, with its hash."""
    about = version.before, version.after, version.author
    return sealed(machine, version.number, float(version.at), version.what, version.text, *about)
