"""Viewers that acknowledge frames, stall, leave, and come back."""

from typing import Any

from simulated.checker import Checker
from simulated.connection import Connection
from simulated.network import Network
from simulated.server import Server
from simulated.world import World
from statwalk.services.publish.outbox import EncodedFrame
from statwalk.stage.state.frame import Action, Verdict

SILENCE_SECONDS = 2.0
"""without any message, after which a viewer takes its connection for broken: a status comes every second"""
LOOK_SECONDS = 0.5


class Viewer:
    """`shown_tick`: of the newest frame that it got; None: none on this connection."""

    def __init__(self, number: int, world: World, network: Network, server: Server, checker: Checker) -> None:
        self.name, self.number = f"viewer {number}", number
        self.world, self.network, self.server, self.checker = world, network, server, checker
        self.chance = world.chance(self.name)
        self.connection: Connection | None = None
        self.stage = ""
        self.shown_tick: int | None = None
        self.heard = self.stalled_until = 0.0
        self._seeks = 0
        self._held_back: EncodedFrame | None = None
        world.after(self.chance.random(), self.look)

    def look(self) -> None:
        """Twice a second: connects, or gives a silent connection up."""
        self.world.after(LOOK_SECONDS, self.look)
        if self.connection and self.world.time - self.heard > SILENCE_SECONDS and not self.is_stalled:
            connection, self.connection = self.connection, None
            if hasattr(connection, "server"):
                connection.hang_up()
        if self.connection is None and self.checker.stages:
            self.stage = self.checker.stages[self.number % len(self.checker.stages)]
            self.connection = Connection(self.network, self)
            self.heard, self.shown_tick, self._seeks = self.world.time, None, 0
            self.network.send(self.name, self.server.connect, self.stage, self.connection)

    @property
    def is_stalled(self) -> bool:
        return self.world.time < self.stalled_until

    def stall(self, seconds: float) -> None:
        """Reads nothing, or reads and acknowledges nothing."""
        self.stalled_until = self.world.time + seconds
        if self.connection and self.chance.random() < 0.5:
            self.connection.is_blocked = True
        self.world.after(seconds, self._go_on, self.connection)

    def _go_on(self, connection: Connection | None) -> None:
        self.heard = self.world.time
        if connection and connection is self.connection and hasattr(connection, "server"):
            connection.is_blocked = False
            if self._held_back:
                connection.acknowledge(self._held_back.tick)
            self.server.process.after(0.0, connection.pump)

    # --- what arrives

    def told(self, connection: Connection, fact: Any) -> None:
        if connection is self.connection:
            self.heard = self.world.time
            if isinstance(fact, Action | Verdict):
                self.checker.told(self.stage, fact)

    def shown(self, connection: Connection, frame: EncodedFrame, seeks: int) -> None:
        if connection is not self.connection:
            return
        self.heard = self.world.time
        if self.shown_tick is not None and frame.tick < self.shown_tick and seeks == self._seeks:
            self.world.fault(f"{self.name} got tick {frame.tick} after tick {self.shown_tick}")
        self.shown_tick, self._seeks, self._held_back = frame.tick, seeks, frame
        self.checker.shown(self.stage, frame)
        if not self.is_stalled:
            self.world.after(self.chance.uniform(0.0, 0.02), connection.acknowledge, frame.tick)

    def ended(self, connection: Connection, why: Any) -> None:
        if connection is self.connection:
            self.world.note(f"{self.name}: the connection has ended ({why})")
            self.connection = None
