"""Faults of the disk, the network, the clocks and the computer: storms of them, and calm in between."""

from collections.abc import Callable

from simulated.checker import Checker
from simulated.clients import Client
from simulated.disk import Disk
from simulated.network import Network
from simulated.server import Server
from simulated.viewers import Viewer
from simulated.world import World

FIRST_STORM = 3.0
STORM_SECONDS, CALM_SECONDS = (8.0, 35.0), (8.0, 25.0)
RECOVERY_SECONDS = 5.0
"""after the last fault, until everything is answered and shown again"""
FAULTS_OF_A_STORM = 2, 7
HOURS = 3600.0


class Weather:
    """Makes storms until `until`, and has `calm` called when all must be well again."""

    def __init__(
        self,
        world: World,
        server: Server,
        disk: Disk,
        network: Network,
        clients: list[Client],
        viewers: list[Viewer],
        checker: Checker,
        until: float,
        calm: Callable[[], None],
    ) -> None:
        self.world, self.server, self.disk, self.network, self.until = world, server, disk, network, until
        self.clients, self.viewers, self.checker, self.calm = clients, viewers, checker, calm
        self.chance = world.chance("weather")
        self.faults = (
            self.crash, self.crash, self.power_cut, self.full, self.broken, self.landing,
            self.landing_and_power_cut, self.slow_disk_and_crash, self.slow_disk, self.bad_network,
            self.cut_off, self.stopped, self.asleep, self.wall_jump, self.stall, self.slow_computer,
        )  # fmt: skip
        world.after(FIRST_STORM, self.storm)

    def storm(self) -> None:
        left = self.until - RECOVERY_SECONDS - 1.0 - self.world.time
        seconds = min(self.chance.uniform(*STORM_SECONDS), left)
        if seconds < STORM_SECONDS[0]:
            return
        self.end = self.world.time + seconds
        for client in self.clients:
            client.is_calm = False
        for _ in range(self.chance.randint(*FAULTS_OF_A_STORM)):
            self.world.after(self.chance.uniform(0.0, seconds - 4.0), self.chance.choice(self.faults))
        self.world.after(seconds, self.clear)

    def clear(self) -> None:
        """The last fault is over."""
        self.world.note("calm")
        for client in self.clients:
            client.is_calm = True
        self.world.after(RECOVERY_SECONDS, self.calm)
        self.world.after(RECOVERY_SECONDS + self.chance.uniform(*CALM_SECONDS), self.storm)

    def _seconds(self, most: float) -> float:
        """How long a fault lasts: at most until two seconds before the storm's end."""
        seconds = self.chance.uniform(0.5, most)
        return max(0.0, min(seconds, self.end - 2.0 - self.world.time))

    # --- the faults

    def crash(self) -> None:
        if self.server.is_up:
            self.world.note("kill -9")
            self.server.crash()

    def power_cut(self) -> None:
        if self.server.is_up:
            self.world.note("the power is cut")
            self.server.crash(without_power=True)

    def full(self) -> None:
        seconds = self._seconds(30.0)
        self.disk.full_until = self.world.time + seconds
        self.world.note(f"the disk is full for {seconds:.1f} s")

    def broken(self) -> None:
        seconds = self._seconds(10.0)
        self.disk.broken_until = self.world.time + seconds
        self.world.note(f"the disk gives errors for {seconds:.1f} s")

    def landing(self) -> None:
        self.disk.is_landing = True

    def landing_and_power_cut(self) -> None:
        self.disk.is_landing = True
        self.world.after(self._seconds(3.0), self.power_cut)

    def slow_disk(self) -> None:
        seconds = self._seconds(20.0)
        self.disk.slow_until, self.disk.slow_seconds = (
            self.world.time + seconds,
            self.chance.uniform(0.05, 2.0),
        )
        self.world.note(f"the disk is slow for {seconds:.1f} s")

    def slow_disk_and_crash(self) -> None:
        self.slow_disk()
        self.world.after(self._seconds(6.0), self.crash)

    def bad_network(self) -> None:
        seconds = self._seconds(30.0)
        self.network.bad_until = self.world.time + seconds
        self.world.note(f"the network is bad for {seconds:.1f} s")

    def cut_off(self) -> None:
        seconds, name = self._seconds(20.0), self.chance.choice([*self.clients, *self.viewers]).name
        self.network.cut_until[name] = self.world.time + seconds
        self.world.note(f"{name} is cut off for {seconds:.1f} s")

    def stopped(self) -> None:
        self._freeze("SIGSTOP", is_counted=True)

    def asleep(self) -> None:
        self._freeze("the computer sleeps", is_counted=False)

    def _freeze(self, how: str, *, is_counted: bool) -> None:
        seconds = self._seconds(20.0)
        self.world.note(f"{how} for {seconds:.1f} s")
        self._lose(seconds)
        self.server.process.freeze(seconds, is_counted=is_counted)

    def wall_jump(self) -> None:
        seconds = self.chance.uniform(-24 * HOURS, 24 * HOURS)
        self.world.wall_offset += seconds
        self.world.note(f"the time of day jumps by {seconds / HOURS:.1f} h")

    def stall(self) -> None:
        seconds, viewer = self._seconds(20.0), self.chance.choice(self.viewers)
        viewer.stall(seconds)
        self.world.note(f"{viewer.name} stalls for {seconds:.1f} s")

    def slow_computer(self) -> None:
        seconds = self._seconds(10.0)
        self.server.slow_until, self.server.slow_seconds = (
            self.world.time + seconds,
            self.chance.uniform(0.01, 1.5),
        )
        self._lose(seconds)
        self.world.note(f"the computer is slow for {seconds:.1f} s")

    def _lose(self, seconds: float) -> None:
        """Ticks may be left out until a little after the fault."""
        self.checker.may_lose_until = max(self.checker.may_lose_until, self.world.time + seconds + 3.0)
