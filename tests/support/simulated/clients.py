"""Clients that post inputs with keys, and send again until they are answered."""

from dataclasses import dataclass
from typing import Any

from simulated.checker import Checker
from simulated.network import Network
from simulated.server import Request, Server
from simulated.world import World
from statwalk.errors import ConflictError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, Command, SendEvent, SetParameter, StageSetup
from statwalk.services.hosting.registry import Registry

MACHINE, PARAMETER, EVENTS = "biceps", "elbow", ("STRETCH", "BEND", "CURL", "SLIDE")
VALUES = 1_024
"""each input sets the parameter to a multiple of 1/1024 of its own, by which it is found in the log"""
MOST_OPEN, MOST_ACTORS = 3, 3
PATIENCE_SECONDS = 1.2
BUSY_SECONDS = 0.4
TEMPORARY = 429, 503, 507
THINK_SECONDS = 5.0
PAST_TICKS = 5


@dataclass(eq=False)
class Wish:
    """What a client wants; `value` is that of its input, 0 if it is none."""

    stage: str
    message: ask.Message[Any] | StageSetup
    asked: float
    value: float = 0.0
    attempts: int = 0
    is_done: bool = False

    def work(self, registry: Registry) -> Any:
        if isinstance(self.message, StageSetup):
            return registry.open(self.message).id
        return registry.find(self.stage).handle(self.message)


class Client:
    """Posts about every three seconds, and now and then moves the clock of a stage."""

    def __init__(self, number: int, world: World, network: Network, server: Server, checker: Checker) -> None:
        self.name, self.number = f"client {number}", number
        self.world, self.network, self.server, self.checker = world, network, server, checker
        self.chance = world.chance(self.name)
        self.open: list[Wish] = []
        self.wishes = 0
        self.is_calm = False
        world.after(self.chance.random(), self.think)

    def think(self) -> None:
        self.world.after(self.chance.expovariate(1 / THINK_SECONDS), self.think)
        if self.checker.stages and len(self.open) < MOST_OPEN:
            self.want(self._wish(self.chance.choice(self.checker.stages)))

    def want(self, wish: Wish) -> None:
        self.open.append(wish)
        self.send(wish)

    def _wish(self, stage: str) -> Wish:
        if not self.is_calm and self.chance.random() < 0.08:
            return Wish(stage, self._move(stage), self.world.time)
        self.wishes += 1
        value = (self.number * 20_000 + self.wishes) / VALUES
        commands: list[Command] = [SetParameter(PARAMETER, value, 1)]
        kind, at = self.chance.random(), None
        if kind < 0.5:
            commands.append(SendEvent(self.chance.choice(EVENTS), 1))
        elif kind < 0.53 and self.checker.may_add(stage, MOST_ACTORS):
            commands.append(AddActor(MACHINE))
        elif kind < 0.57:
            at = max(self.checker.newest_tick(stage) - self.chance.randrange(1, PAST_TICKS), 0)
        post = ask.Post(tuple(commands), at, key=f"{self.number}-{self.wishes}")
        self.checker.wanted(stage, post, value)
        return Wish(stage, post, self.world.time, value)

    def _move(self, stage: str) -> ask.Message[Any]:
        tick = max(self.checker.newest_tick(stage) - self.chance.randrange(PAST_TICKS), 0)
        return self.chance.choice(
            [
                ask.Pause(True),
                *[ask.Pause(False)] * 3,
                *[ask.SetSpeed(self.chance.choice((0.5, 1.0, 2.0)))] * 2,
                ask.Seek(tick),
            ]
        )

    # --- until it is answered

    def send(self, wish: Wish) -> None:
        wish.attempts += 1
        request = Request(
            self.name, wish.stage, wish.value > 0, wish.work, isinstance(wish.message, ask.Seek)
        )
        self.network.send(
            self.name,
            self.server.take,
            request,
            lambda *answer: self.network.send(self.name, self.answered, wish, *answer),
        )
        self.world.after(PATIENCE_SECONDS * self.chance.uniform(1, 1.5), self.again, wish, wish.attempts)

    def again(self, wish: Wish, attempt: int) -> None:
        if not wish.is_done and wish.attempts == attempt:
            self.send(wish)

    def answered(self, wish: Wish, status: int, reply: Any) -> None:
        if status == 200:
            self._accepted(wish, reply)
        elif status in TEMPORARY:
            self.world.after(BUSY_SECONDS, self.again, wish, wish.attempts)
            return
        elif status == 404 or type(reply) is ConflictError:
            self.world.fault(f"{self.name}: {status} for {wish.message}: {reply}")
        if not wish.is_done:
            wish.is_done = True
            self.open.remove(wish)

    def _accepted(self, wish: Wish, reply: Any) -> None:
        if isinstance(wish.message, StageSetup):
            if not wish.is_done:
                self.checker.opened(reply)
        elif isinstance(wish.message, ask.Post):
            self.checker.acknowledged(wish.message, reply)
            self.world.note(
                f"{self.name}: {wish.message.key} is number {reply.seq} of {reply.stage}, tick {reply.tick}"
            )
