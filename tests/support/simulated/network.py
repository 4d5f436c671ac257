"""A network that delays, loses, repeats and overtakes messages, and cuts connections."""

from collections.abc import Callable
from typing import Any

from simulated.world import World

QUICK_SECONDS = 0.002, 0.08
SLOW_SECONDS = 2.5
LATEST_REPEAT = 40.0
"""seconds after which a repeated message may still arrive"""
LOST, REPEATED = 0.2, 0.2
"""the parts of messages in bad weather"""


class Network:
    """Carries messages of which each is for itself; between `bad_from` and `bad_until` badly."""

    def __init__(self, world: World) -> None:
        self.world, self.chance = world, world.chance("network")
        self.bad_until = 0.0
        self.lost = self.repeated = 0
        self.cut_until: dict[str, float] = {}

    def is_cut(self, name: str) -> bool:
        return self.world.time < self.cut_until.get(name, 0.0)

    def seconds(self) -> float:
        longest = SLOW_SECONDS if self.world.time < self.bad_until else QUICK_SECONDS[1]
        return self.chance.uniform(QUICK_SECONDS[0], longest)

    def send(self, name: str, arrive: Callable[..., object], *arguments: Any) -> None:
        """Carries a message to or from the client of that name; it may arrive never, or twice."""
        is_bad = self.world.time < self.bad_until
        if self.is_cut(name) or (is_bad and self.chance.random() < LOST):
            self.lost += 1
            return
        self.world.after(self.seconds(), arrive, *arguments)
        if is_bad and self.chance.random() < REPEATED:
            self.repeated += 1
            self.world.after(self.chance.uniform(0.0, LATEST_REPEAT), arrive, *arguments)


class Pipe:
    """One direction of a connection: messages arrive in order, until it is cut."""

    def __init__(self, network: Network, name: str) -> None:
        self.network, self.name = network, name
        self.is_cut, self._latest = False, 0.0

    def send(self, arrive: Callable[..., object], *arguments: Any) -> None:
        world = self.network.world
        if self.network.is_cut(self.name):
            self.is_cut = True
        self._latest = max(self._latest, world.time + self.network.seconds())
        world.after(self._latest - world.time, self._arrive, arrive, arguments)

    def _arrive(self, arrive: Callable[..., object], arguments: tuple[Any, ...]) -> None:
        if not self.is_cut:
            arrive(*arguments)
