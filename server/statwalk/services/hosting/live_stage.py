"""A stage with its clock and its viewers. One thread at a time may call it: the stage host holds the lock."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import nullcontext
from functools import partial

from statwalk.character.role import Role
from statwalk.errors import StageError
from statwalk.services.hosting.apply_commands import apply_commands
from statwalk.services.hosting.commands import AddActor, Doer, RemoveActor
from statwalk.services.hosting.log_room import LogRoom
from statwalk.services.hosting.pacing import TickCost
from statwalk.services.hosting.stage_layouts import layouts_of
from statwalk.services.hosting.stage_messages import Post
from statwalk.services.hosting.stage_replies import ClockAct, ClockChange, Posted, StageStatus
from statwalk.services.hosting.stage_services import StageServices
from statwalk.services.hosting.store.committer import Statement
from statwalk.services.hosting.store.kept_keys import KeptKeys
from statwalk.services.hosting.store.kept_stage import KeptStage
from statwalk.services.hosting.store.records import StageIdentity
from statwalk.services.publish.encoder import Encoder
from statwalk.services.publish.outbox import MOST_FACTS, EncodedFrame, FrameForm
from statwalk.services.publish.waiting_facts import WaitingFacts
from statwalk.stage.clock import Clock
from statwalk.stage.stage import Stage

FACTS_SECONDS = 0.005
"""between two looks at the log while facts wait for durability"""
SOON_SECONDS = 1 / 50
"""facts that wait for durability go with the next frame if that is due in so many seconds"""
MANUAL_WAIT_SECONDS = 0.25


class LiveStage:
    """Steps a stage, applies commands to it, and publishes its frames."""

    def __init__(
        self, identity: StageIdentity, stage: Stage, services: StageServices, name: str = ""
    ) -> None:
        self.identity, self.stage, self.services = identity, stage, services
        self.id, self.clock_kind = identity.id, identity.clock
        self.name = name
        self.changed: ClockChange | None = None
        self.clock, self.cost = Clock(stage.rate), TickCost()
        self.encoder = Encoder()
        self.fanout, self.facts_waiting = self.encoder.fanout, WaitingFacts()
        self.kept: KeptStage | None = None
        self.restored: int | None = None
        self.asleep = False
        self.room = LogRoom(services.limits)

    # --- time

    def advance_to(self, now: float) -> float:
        """Takes the steps that are due at `now` (seconds of `services.now`), and publishes the facts that
        waited for durability; returns the seconds until the next call.
        """
        wait = MANUAL_WAIT_SECONDS
        if self.clock_kind == "real":
            late = self.clock.lateness(self.clock.due(now))
            began = self.services.now()
            for _ in late:
                self.tick()
            if late:
                self._pace(began, len(late))
            self.services.measure_ticks(late, self.clock.take_lost())
            wait = self.clock.wait(now)
        if not self.facts_waiting or (wait <= SOON_SECONDS and self.fanout.outboxes):
            return wait  # facts go with the next frame: to send them alone costs every viewer a message more
        self._note()
        self.fanout.publish({}, self._durable_facts())
        return min(wait, FACTS_SECONDS) if self.facts_waiting else wait

    def _pace(self, began: float, ticks: int) -> None:
        """Slows the clock down if the stage takes more than its share of the time."""
        now = self.services.now()
        self.cost.add(now - began, ticks)
        load = self.cost.median() * self.stage.rate * self.clock.speed
        self.clock.pace = self.services.pacing.pace(self.id, load, now)

    def tick(self) -> None:
        """Steps the stage by one tick, and publishes the frame."""
        self.stage.step(1)
        self.show(facts=True)

    def stepping(self, ticks: int) -> Iterator[int]:
        """Steps the stage by `ticks`; yields after each tick."""
        for _ in range(ticks):
            self.tick()
            yield self.stage.tick

    def stepping_to(self, tick: int) -> Iterator[int]:
        """Steps the stage up to a tick; yields after each tick."""
        while self.stage.tick < tick:
            self.tick()
            yield self.stage.tick

    def seeking(self, tick: int) -> Iterator[int]:
        """Computes the state at a tick; yields after each tick it computes. The playhead moves at the end."""
        yield from self.stage.seeking(tick, most=1)
        self.show(facts=False)
        self.announce()

    def pause(self, paused: bool) -> None:
        """Stops or starts the clock."""
        self.clock.due(self.services.now())  # the time until now passed in the old setting
        self.clock.paused = paused
        self.announce()

    def set_speed(self, speed: float) -> None:
        """Makes the clock run faster or slower."""
        self.clock.speed = speed
        self.announce()

    def note_change(self, what: ClockAct, by: Doer) -> None:
        """Notes who acts on the clock, for the status."""
        self.changed = ClockChange(what, by.name, by.viewer, self.stage.tick)

    # --- inputs

    def apply(self, post: Post, roles: Mapping[str, Role]) -> Posted:
        """Applies the commands in order; the first refused command raises, and the later ones do not run.

        `roles`: by machine, the role of each actor to add.

        The oldest inputs are forgotten when the log is full. :raises LimitError: when they cannot be.
        """
        if self.room.make(self.stage):
            self._keep_forgotten()
        self.room.check(self.stage)
        commands = post.commands
        with self.kept.inputs(self.stage, self.clock, post) if self.kept else nullcontext():
            outcomes = tuple(apply_commands(self.stage, commands, roles, self.services.limits.actors))
        self.room.take(len(outcomes))
        if any(isinstance(command, AddActor | RemoveActor) for command in commands):
            self.show(facts=False)
        return Posted(self.stage.tick, self.stage.newest, self.id, outcomes)

    def edit(self, role: Role, text: str) -> bool:
        """Plays another version of a machine.

        Returns False, and changes nothing, if the stage does not play the machine, if the playhead is in the
        past, or if the stage refuses the version (another skeleton).
        """
        if role.name not in self.stage.roles or self.stage.tick < self.stage.head:
            return False
        try:
            with self.kept.changes(self.stage, self.clock, at_once=True) if self.kept else nullcontext():
                self.stage.edit(role, text)
        except StageError:
            return False
        self.show(facts=False)
        return True

    # --- the store

    @property
    def keys(self) -> KeptKeys | None:
        """The idempotency keys; None without a store."""
        return self.kept.keys if self.kept else None

    def keep(self, kept: KeptStage, also: Sequence[Statement] = ()) -> None:
        """Keeps the stage in the store from now on; `also` goes into the same commit."""
        kept.name = self.name
        kept.begin(self.stage, self.clock, also)
        self.kept = kept

    def resume(self, kept: KeptStage, *, paused: bool, speed: float) -> None:
        """Goes on with a stage that was kept."""
        self.kept, self.restored, self.name = kept, self.stage.tick, kept.name
        self.clock.paused, self.clock.speed = paused, speed

    def rename(self, name: str) -> None:
        """Gives the stage another name; `save` keeps it."""
        self.name = name
        if self.kept:
            self.kept.name = name

    def _keep_forgotten(self) -> None:
        if self.kept:
            self.kept.forget(self.stage, self.clock)
        self.announce()

    def save(self) -> None:
        """Keeps the playhead, the clock and new snapshots, if they changed."""
        if self.kept:
            self.kept.save(self.stage, self.clock)

    # --- frames and facts

    def show(self, *, facts: bool) -> None:
        """Publishes the frame at the playhead at once, and (`facts`) the actions and verdicts of its tick as
        soon as it is durable that the stage has got so far: a crash may take back a frame, but no fact.
        """
        if not self.fanout.outboxes:
            return  # without viewers no frame is made
        frame = self.stage.frame
        if facts:
            encode = self.services.encode_fact
            texts = [*map(encode, frame.actions), *map(encode, frame.verdicts)]
            self.facts_waiting.put(frame.tick, texts)
            self._note()
        layouts = layouts_of(self.stage, self.services.catalogue)
        self.encoder.show(frame, self.stage.head, layouts, self._durable_facts())

    def _durable_facts(self) -> list[bytes]:
        """Removes and returns the facts that need not wait; disconnects the viewers if too many wait."""
        durable = self.facts_waiting.take(lambda tick: not self.kept or tick <= self.kept.durable_head)
        if len(self.facts_waiting) > MOST_FACTS:
            self.facts_waiting.drop()
            self.fanout.end("slow", "the disk takes too long to keep what happens")
        return durable

    def _note(self) -> None:
        """Keeps how far the stage is, if facts wait for that."""
        if self.kept and self.facts_waiting:
            self.kept.note(self.stage, self.clock)

    def announce(self) -> None:
        """Sends the status to the viewers."""
        if self.fanout.outboxes:
            self.fanout.tell(self.services.encode_fact(self.status()))

    def taken_frame(self, stage: Stage, form: FrameForm) -> Callable[[], EncodedFrame]:
        """Takes the frame at the playhead of `stage`, the live stage or a copy of it; returns the function
        that encodes it, which may be called while the stage goes on.
        """
        layouts = layouts_of(stage, self.services.catalogue)
        return partial(self.encoder.encode, stage.frame, form, self.stage.head, layouts)

    def status(self) -> StageStatus:
        """Returns the status of the stage; safe to call while another thread holds the lock."""
        stage, clock = self.stage, self.clock
        return StageStatus(
            stage.tick,
            stage.head,
            stage.first,
            clock.paused,
            clock.speed,
            len(self.fanout.outboxes),
            clock.pace,
            self.restored,
            self.services.trouble(),
            self.changed,
        )
