"""One simulation: a seed decides everything that happens in it."""

import logging
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from unittest.mock import patch

from simulated.checker import Checker
from simulated.clients import MACHINE, Client, Wish
from simulated.disk import Disk
from simulated.network import Network
from simulated.server import LIMITS, Server
from simulated.viewers import Viewer
from simulated.weather import RECOVERY_SECONDS, Weather
from simulated.world import World
from statwalk.services.hosting.commands import AddActor, StageSetup
from statwalk.services.library.catalogue import Catalogue
from statwalk.stage.history.log_codec import load
from statwalk.stage.replay import at_beginning

MEMORY = Path("/dev/shm")
RATES = 1, 1, 1, 2, 4
"""ticks a second: slow stages, so that ten minutes have few ticks and many inputs between two of them"""


@cache
def catalogue() -> Catalogue:
    found = Catalogue()
    found.role(MACHINE)
    return found


@dataclass(frozen=True)
class Outcome:
    """`faults`: empty if everything held. `counts`: what happened how often."""

    seed: int
    seconds: float
    faults: tuple[str, ...]
    trace: tuple[str, ...]
    counts: Counter[str]
    most_waiting: int
    fingerprint: str

    @property
    def report(self) -> str:
        """What happened last, and the command that repeats it."""
        command = f"python benchmarks/reliability.py simulation --seeds 1 --first {self.seed} --minutes"
        return "\n".join(
            (*self.trace, f"seed {self.seed}: {self.faults[0]}", f"{command} {self.seconds / 60:g}")
        )


@contextmanager
def folder() -> Iterator[Path]:
    """A data folder in memory, where the system has one."""
    with tempfile.TemporaryDirectory(dir=MEMORY if MEMORY.is_dir() else None) as name:
        yield Path(name)


def simulate(seed: int, minutes: float) -> Outcome:
    """Runs a server, three clients and three viewers through storms for some simulated minutes."""
    world = World(seed)
    store_log = logging.getLogger("statwalk")
    was, store_log.disabled = store_log.disabled, True
    logging.disable(logging.CRITICAL)
    try:
        with folder() as data, patch.object(time, "time", lambda: world.wall):
            return _Simulation(world, data, minutes * 60.0).run()
    finally:
        store_log.disabled = was
        logging.disable(logging.NOTSET)


class _Simulation:
    def __init__(self, world: World, data: Path, seconds: float) -> None:
        self.world, self.seconds = world, seconds
        self.chance = world.chance("stages")
        self.checker = Checker(world, LIMITS.inputs)
        self.disk, self.network = Disk(world, data), Network(world)
        self.server = Server(world, self.disk, catalogue(), self.checker)
        parts = world, self.network, self.server, self.checker
        self.clients = [Client(number, *parts) for number in range(3)]
        self.viewers = [Viewer(number, *parts) for number in range(3)]
        for _ in range(self.chance.randint(1, 2)):
            rate = self.chance.choice(RATES)
            setup = StageSetup(rate=rate, clock="real", actors=(AddActor(MACHINE),))
            self.clients[0].want(Wish("", setup, 0.0))
        self.weather = Weather(
            world,
            self.server,
            self.disk,
            self.network,
            self.clients,
            self.viewers,
            self.checker,
            seconds,
            self._is_well,
        )

    def run(self) -> Outcome:
        self.world.run(self.seconds)
        if not self.world.faults:
            self._compare()
        self.server.process.kill()
        if self.server.store:
            self.server.store._lock.release()
        self.disk.killed(without_power=False)
        counts = self.checker.counts
        counts["events"] = self.world.events
        fingerprint = (
            f"{sorted(counts.items())} {self.final}" if not self.world.faults else "".join(self.world.trace)
        )
        faults, trace = tuple(self.world.faults), tuple(self.world.trace)
        most = self.checker.most_waiting
        return Outcome(self.world.seed, self.seconds, faults, trace, counts, most, fingerprint)

    def _is_well(self) -> None:
        """Some seconds after the last fault: every input is answered, every viewer sees the present."""
        world = self.world
        for client in self.clients:
            for wish in client.open:
                if world.time - wish.asked > RECOVERY_SECONDS:
                    world.fault(
                        f"{client.name} waits since {wish.asked:.3f} s for an answer to {wish.message}"
                    )
        for viewer in self.viewers:
            host = self.server.registry.stages.get(viewer.stage)
            if host is None or viewer.connection is None or viewer.shown_tick is None:
                world.fault(f"{viewer.name} sees nothing of {viewer.stage or 'a stage'}")
                continue
            live = host._live
            if abs(live.stage.tick - viewer.shown_tick) > 1 + live.stage.rate * live.clock.speed:
                world.fault(
                    f"{viewer.name} sees tick {viewer.shown_tick}, and the stage is at {live.stage.tick}"
                )
        self.checker.counts["calms"] += 1

    def _compare(self) -> None:
        role_of = catalogue().role
        stages = {host.id: host._live.stage for host in self.server.registry.all()}
        for name in self.checker.stages:
            live = stages[name]
            again = at_beginning(load(live.dump()), lambda key, _text="": role_of(key))
            self.checker.compare(name, live, again)

    @property
    def final(self) -> str:
        return " ".join(f"{host.id} {host._live.stage.hash}" for host in self.server.registry.all())
