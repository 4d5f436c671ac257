"""The server of the simulation: the product's registry, store, ticker and rates on a simulated process, put
together as web/app.py does.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

from simulated.checker import Checker
from simulated.connection import Connection
from simulated.disk import Disk
from simulated.process import Process
from simulated.world import World
from statwalk.errors import StatwalkError
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.reopen import reopen
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.store.store import Store
from statwalk.services.hosting.store.writer import Writer
from statwalk.services.hosting.ticker import Ticker
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits
from statwalk.web.errors import Problem, from_error
from statwalk.web.rate_limits import RateLimits

LIMITS = Limits(requests=12, inputs=6, stages=24)
HOUSEKEEPING_SECONDS = 1.0
LOOP_SECONDS = 0.0001
Work = Callable[[Registry], Any]
Answer = Callable[[int, Any], None]
"""is told the status, and the reply or the error"""


class Request(NamedTuple):
    """What a client asks: `work` with the registry, about a stage if it names one."""

    address: str
    stage: str
    is_input: bool
    work: Work
    is_seek: bool = False


class Server:
    """One data folder, and one process after another. `is_up`: it takes requests."""

    def __init__(self, world: World, disk: Disk, catalogue: Catalogue, checker: Checker) -> None:
        self.world, self.disk, self.catalogue, self.checker = world, disk, catalogue, checker
        self.ids = world.chance("ids")
        self.cpu, self.slow_until, self.slow_seconds = world.chance("cpu"), 0.0, 0.0
        self.is_up = False
        self.boots = 0
        self.connections: list[Connection] = []
        self.boot()

    def now(self) -> float:
        """The clock that the server is given; a planted fault gives it another one."""
        return self.process.now()

    # --- start and end

    def boot(self) -> None:
        self.boots += 1
        self.process = self.disk.process = Process(self.world)
        self.store: Store | None = None
        self.process.start(self._boot, "boot")

    def _boot(self) -> None:
        try:
            self._open()
        except StatwalkError as error:
            self.world.note(f"the server does not start: {error}")
            self.crash()
            return
        self.is_up = True
        self.checker.started(self.registry)
        self.world.note(f"start {self.boots}, with {len(self.registry.stages)} stages")
        self._tick()
        self._keep_house()

    def _open(self) -> None:
        process = self.process
        open_writer = partial(Writer, open_database=self.disk.open, threads=process)
        self.store = Store(self.disk.folder, self.catalogue.texts.__getitem__, open_writer)
        registry = self.registry = Registry(
            self.catalogue,
            lambda fact: fact,  # type: ignore[arg-type, return-value] - viewers here read facts as they are
            LIMITS,
            store=self.store,
            now=lambda: self.now(),
            new_id=lambda: f"{self.ids.getrandbits(32):08x}",
        )
        registry.measure_ticks = self.checker.ticked
        self.rates = RateLimits(LIMITS, registry.now)
        self.ticker = Ticker(registry.all, registry.now)
        registry.wake = self._wake
        reopen(registry, registry.main_content())

    def crash(self, *, without_power: bool = False) -> None:
        """Ends the process wherever it is, and starts another one soon."""
        self.is_up = False
        self.world.after(0.0, self._end, without_power)

    def _end(self, without_power: bool) -> None:
        self.process.kill()
        if self.store:
            self.store._lock.release()
        self.disk.killed(without_power=without_power)
        for connection in self.connections:
            connection.cut()
        self.connections.clear()
        self.checker.ended()  # no frame of this process can arrive any more
        self.world.after(self.ids.uniform(0.1, 1.0), self.boot)

    # --- what runs by itself

    def _wake(self) -> None:
        self.process.after(0.0, self._round)

    def _tick(self) -> None:
        self.process.after(self._round(), self._tick)

    def _round(self) -> float:
        wait = self.ticker.round()
        if self.ticker.failing:
            self.world.fault("a stage failed in its step")
        return wait

    def computes(self) -> None:
        """A tick is computed: on a slow computer that takes its time."""
        if self.world.time < self.slow_until:
            self.world.spend(self.cpu.uniform(0.0, self.slow_seconds))

    def _keep_house(self) -> None:
        now, registry = self.registry.now(), self.registry
        for host in registry.all():
            host._live.stage.before_tick = self.computes
            host.look_after_viewers(now)
        before = set(registry.stages)
        registry.drop_idle(now)
        self.checker.dropped(before - set(registry.stages))
        registry.save()
        self.checker.looked(registry, self.connections)
        self.process.after(HOUSEKEEPING_SECONDS, self._keep_house)

    # --- requests

    def take(self, request: Request, answer: Answer) -> None:
        """A request has arrived; `answer` is called when it is answered."""
        if not self.is_up:
            return  # nobody listens
        self.process.after(0.0, self._take, request, answer)

    def _take(self, request: Request, answer: Answer) -> None:
        try:
            stage = request.stage if request.stage in self.registry.stages else ""
            self.rates.request(request.address, stage)
            if request.is_input:
                self.rates.input(request.address, stage)
                self.checker.input_passed(request.address, self.process.now())
        except Problem as problem:
            answer(problem.status_code, problem)
            return
        self.process.start(partial(self._work, request, answer), "request")

    def _work(self, request: Request, answer: Answer) -> None:
        if request.is_seek:
            self._sought(request.stage)
        try:
            reply = request.work(self.registry)
        except StatwalkError as error:
            answer(from_error(error).status_code, error)
        else:
            answer(200, reply)

    # --- viewers

    def connect(self, stage: str, connection: Connection) -> None:
        """A viewer has arrived."""
        if self.is_up:
            self.process.after(0.0, self._connect, stage, connection)

    def _connect(self, stage: str, connection: Connection) -> None:
        host = self.registry.stages.get(stage)
        if host is None:
            self.world.fault(f"the stage {stage} of a viewer is gone")
            return
        self.connections.append(connection)
        connection.serve(host, self)

    def _sought(self, stage: str) -> None:
        """The playhead of a stage has moved."""
        for connection in self.connections:
            connection.seeks += connection.host.id == stage

    def call_soon_threadsafe(self, callback: Callable[..., object], /, *arguments: Any) -> None:
        """The event loop: afterwards the connections send what they have."""
        self.process.after(LOOP_SECONDS, self._call, callback, arguments)

    def _call(self, callback: Callable[..., object], arguments: Sequence[Any]) -> None:
        callback(*arguments)
        for connection in list(self.connections):
            connection.pump()

    def left(self, connection: Connection, host: StageHost) -> None:
        if connection in self.connections:
            self.connections.remove(connection)
            host.leave(connection.outbox)
