"""What must hold, whatever happens: notes what was promised, and compares it with what is there."""

from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from simulated.world import World
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_replies import Posted
from statwalk.services.hosting.store.writer import Writer
from statwalk.services.limits import BURST_SECONDS
from statwalk.services.publish.outbox import CREDITS, MOST_FACTS, EncodedFrame
from statwalk.stage.stage import Stage
from statwalk.stage.state.commands import LogEntry, Set

if TYPE_CHECKING:
    from simulated.connection import Connection

MOST_WAITING = 100
"""writes that wait for a slow disk: the product's own bound, and a few inputs of each client"""
MOST_MORE = 8
"""writes that come while the disk refuses: of requests that had begun before"""
CATCH_UP_TICKS = 3
"""a quarter of a second at four ticks a second and double speed, and one"""


class Checker:
    """Notes faults in the world. `stages`: those that a client was told to be open."""

    def __init__(self, world: World, inputs_a_second: float) -> None:
        self.world, self.inputs_a_second = world, inputs_a_second
        self.stages: list[str] = []
        self.counts: Counter[str] = Counter()
        self.frames: dict[tuple[str, int], EncodedFrame] = {}
        """what viewers got since the newest start: a crash may take frames back"""
        self.facts: set[tuple[str, str]] = set()
        """actions and verdicts that viewers got: nothing may take them back"""
        self.may_lose_until = 0.0
        self.ticks_lost = self.most_waiting = 0
        self._acknowledged: dict[str, Posted] = {}
        self._wanted: dict[float, tuple[str, ask.Post]] = {}
        self._gone: set[str] = set()
        self._actors: Counter[str] = Counter()
        self._newest: dict[str, int] = {}
        self._passed: dict[str, list[float]] = {}
        self._waiting_at_trouble: int | None = None

    # --- what clients are told

    def wanted(self, stage: str, post: ask.Post, value: float) -> None:
        self._wanted[value] = stage, post
        self._actors[stage] += any(isinstance(command, AddActor) for command in post.commands)
        self.counts["inputs"] += 1

    def opened(self, stage: str) -> None:
        self.stages.append(stage)

    def acknowledged(self, post: ask.Post, posted: Posted) -> None:
        before = self._acknowledged.setdefault(post.key, posted)
        if (before.stage, before.seq) != (posted.stage, posted.seq):
            self.world.fault(f"{post.key} was answered {before}, and now {posted}")
        self._newest[posted.stage] = max(self._newest.get(posted.stage, 0), posted.tick)
        self.counts["answers"] += 1

    def may_add(self, stage: str, most: int) -> bool:
        return self._actors[stage] + 1 < most

    def newest_tick(self, stage: str) -> int:
        return self._newest.get(stage, 0)

    # --- what viewers are shown

    def told(self, stage: str, fact: object) -> None:
        self.facts.add((stage, repr(fact)))

    def shown(self, stage: str, frame: EncodedFrame) -> None:
        self.frames[stage, frame.tick] = frame
        self._newest[stage] = max(self._newest.get(stage, 0), frame.tick)
        self.counts["frames"] += 1

    def sent(self, connection: "Connection", frame: EncodedFrame) -> None:
        """A frame goes to a viewer: the newest that there is, and few are on their way."""
        newest = connection.host._live.stage.tick
        if newest - frame.tick > CATCH_UP_TICKS + 1:
            self.world.fault(f"tick {frame.tick} is sent, and the stage is at {newest}")
        if len(connection.unacknowledged) > CREDITS:
            self.world.fault(f"{len(connection.unacknowledged)} frames are on their way to one viewer")

    # --- what the server does

    def ticked(self, late: Sequence[float], lost: int) -> None:
        if len(late) > CATCH_UP_TICKS:
            self.world.fault(f"{len(late)} ticks at once")
        if lost and self.world.time > self.may_lose_until:
            self.world.fault(f"{lost} ticks are left out, and nothing was late")
        self.counts["ticks"] += len(late)
        self.ticks_lost += lost

    def input_passed(self, address: str, now: float) -> None:
        """The rate limit let an input pass."""
        times = self._passed.setdefault(address, [])
        times.append(now)
        since = now - 4 * BURST_SECONDS
        while times[0] < since:
            times.pop(0)
        if len(times) > self.inputs_a_second * (5 * BURST_SECONDS) + 1:
            self.world.fault(f"{address} had {len(times)} inputs in {4 * BURST_SECONDS:g} s")

    def dropped(self, stages: Iterable[str]) -> None:
        self._gone.update(stages)

    def ended(self) -> None:
        self.frames.clear()
        self._waiting_at_trouble = None
        self.counts["ends"] += 1

    def looked(self, registry: Registry, connections: "Sequence[Connection]") -> None:
        """Once a second: every queue is bounded."""
        assert registry.store is not None
        lengths = {
            "writes that wait for the disk": (registry.store.writer.length, MOST_WAITING),
            "facts of one viewer": (
                max((len(each.outbox.facts) for each in connections), default=0),
                MOST_FACTS,
            ),
            "facts of one stage": (
                max((len(host._live.facts_waiting) for host in registry.all()), default=0),
                MOST_FACTS,
            ),
        }
        self._check_refused(registry.store.writer)
        self.most_waiting = max(self.most_waiting, registry.store.writer.length)
        for what, (length, most) in lengths.items():
            if length > most:
                self.world.fault(f"{length} {what}; at most {most} are expected")

    def _check_refused(self, writer: Writer) -> None:
        """While the disk refuses, next to nothing more waits for it."""
        if writer.trouble is None:
            self._waiting_at_trouble = None
        elif self._waiting_at_trouble is None:
            self._waiting_at_trouble = writer.length
        elif writer.length > self._waiting_at_trouble + MOST_MORE:
            self.world.fault(f"the disk refuses, and {writer.length} writes wait for it; it began with few")

    def started(self, registry: Registry) -> None:
        """After a start, everything that was acknowledged is there, once, in order."""
        for stage in self.stages:
            if stage not in registry.stages:
                self.world.fault(f"the stage {stage} did not come back")
        of_value: Counter[float] = Counter()
        self._in_open = {
            entry.command.value
            for name in self.stages
            if name in registry.stages
            for entry in registry.stages[name]._live.stage.log
            if isinstance(entry.command, Set)
        }
        for host in registry.all():
            self._check_log(host.id, host._live.stage)
            if host.id not in self.stages:
                of_value.update(self._own_values(host._live.stage))
        for posted in self._acknowledged.values():
            self._check_there(registry, posted)
        for value, times in of_value.items():
            stage, post = self._wanted[value]
            if times > 1:
                self.world.fault(f"{post.key} to the past of {stage} is in {times} forks")

    def _own_values(self, stage: Stage) -> list[float]:
        """The values of inputs that a fork has and its past has not: clients post to no forks, so that each
        is in one fork only.
        """
        values = [command.value for command in map(_command, stage.log) if isinstance(command, Set)]
        return [value for value in values if value not in self._in_open]

    def _check_log(self, name: str, stage: Stage) -> None:
        entries = sorted(stage.log, key=lambda entry: entry.number)
        numbers = [entry.number for entry in entries]
        if len(set(numbers)) != len(numbers):
            self.world.fault(f"two inputs of {name} have one number")
        if name in self.stages and numbers != list(range(1, len(numbers) + 1)):
            self.world.fault(f"numbers of inputs of {name} are missing")
        if any(later.tick < earlier.tick - 1 for earlier, later in pairwise(entries)):
            self.world.fault(f"the inputs of {name} are not in order")
        values = [entry.command.value for entry in entries if isinstance(entry.command, Set)]
        if len(set(values)) != len(values):
            self.world.fault(f"an input of {name} is applied twice")

    def _check_there(self, registry: Registry, posted: Posted) -> None:
        host = registry.stages.get(posted.stage)
        if host is None:
            if posted.stage not in self._gone:
                self.world.fault(f"the fork {posted.stage} did not come back")
            return
        stage = host._live.stage
        if stage.newest < posted.seq or stage.head < posted.tick:
            self.world.fault(
                f"{posted} was acknowledged, and {posted.stage} has {stage.newest} inputs, {stage.head} ticks"
            )

    # --- at the end

    def compare(self, name: str, live: Stage, again: Stage) -> None:
        """`again`: the stage of the same log, at its beginning: it goes through the same states, and raises
        every fact that a viewer got.
        """
        facts: set[str] = set()
        entries = {entry.number: entry for entry in live.log}
        for posted in self._acknowledged.values():
            if posted.stage == name and posted.seq not in entries:
                self.world.fault(f"{posted} was acknowledged, and is not there")
        changed = {entry.tick for entry in entries.values() if not isinstance(entry.command, Set)}
        hashes = {0: again.hash}
        while again.tick < live.head:
            again.step(1)
            hashes[again.tick] = again.hash
            facts.update(map(repr, (*again.effects.actions, *again.effects.verdicts)))
        if hashes[live.tick] != live.hash:
            self.world.fault(f"{name} is another at tick {live.tick} than its log says")
        for (stage, tick), frame in self.frames.items():
            if stage == name and tick not in changed and frame_hash(frame) != hashes.get(tick, ""):
                self.world.fault(f"a frame of tick {tick} of {name} shows another state than its log says")
        for fact in sorted(fact for stage, fact in self.facts if stage == name):
            if fact not in facts:
                self.world.fault(f"{name} has taken back: {fact}")
        self.counts["compared"] += len(hashes)


def _command(entry: LogEntry) -> object:
    return entry.command


def frame_hash(frame: EncodedFrame) -> str:
    """The hash of the state that a frame shows, as its header says it."""
    from statwalk.services.publish.pose_message import HEADER

    return f"{HEADER.unpack_from(frame.data)[4]:016x}"
