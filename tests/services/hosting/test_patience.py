"""Which stage a new one replaces when the server is full."""

import pickle
from collections.abc import Callable

import pytest
from statwalk.errors import LimitError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, RemoveActor, SendEvent, StageSetup
from statwalk.services.hosting.patience import MANUAL_PATIENCE
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits
from statwalk.services.publish.outbox import Outbox

WALKER = StageSetup(actors=(AddActor("faq-walker"),))
LIMITS = Limits(stages=4)


class Server:
    """A registry whose time passes on request, with `main` and two replaceable stages."""

    def __init__(self, catalogue: Catalogue) -> None:
        self.time = 0.0
        self.registry = Registry(catalogue, pickle.dumps, LIMITS, now=lambda: self.time)
        self.main = self.registry.open_main()
        self.older, self.newer = self.registry.open(WALKER), self.registry.open(WALKER)

    def opens_another(self, seconds: float = LIMITS.rest_seconds + 1) -> list[StageHost]:
        """Opens one stage more than there is room for, after some time; returns those that have gone."""
        before = self.registry.all()
        self.time += seconds
        self.registry.open(WALKER)
        return [host for host in before if host not in self.registry.all()]


@pytest.fixture
def server() -> Server:
    return Server(Catalogue())


def test_the_stage_that_was_idle_for_longest_makes_room(server: Server) -> None:
    server.registry.open(WALKER)
    server.time = 1.0
    server.older.handle(ask.Status())
    assert server.opens_another() == [server.newer]


def walk(host: StageHost) -> None:
    host.handle(ask.Post((SendEvent("FORWARD"),)))


def add_later(host: StageHost) -> None:
    host.handle(ask.Step(1))
    host.handle(ask.Post((AddActor("faq-walker"),)))


def remove(host: StageHost) -> None:
    host.handle(ask.Post((RemoveActor(1),)))


def watch(host: StageHost) -> None:
    host.join(Outbox("pose"))


@pytest.mark.anyio
@pytest.mark.parametrize(
    "use",
    [
        walk,
        add_later,
        remove,
        lambda host: host.handle(ask.Rename("mine")),
        lambda host: host.handle(ask.Fork(None)),
        watch,
    ],
)
async def test_a_stage_that_somebody_misses_stays(server: Server, use: Callable[[StageHost], object]) -> None:
    """Its input, its name, its fork or its viewer would be lost; another one goes, though idle for less."""
    use(server.older)
    if len(server.registry.all()) < LIMITS.stages:
        server.registry.open(WALKER)
    server.time = 1.0
    server.newer.handle(ask.Status())
    last = server.registry.all()[-1]
    last.handle(ask.Rename("mine"))
    assert server.opens_another() == [server.newer]


def test_a_fork_stays_though_nothing_happened_in_it(server: Server) -> None:
    server.registry.close(server.older.id)
    empty = server.registry.open(StageSetup())
    empty.handle(ask.Fork(None))
    server.registry.close(empty.id)
    server.time = 1.0
    server.newer.handle(ask.Status())
    server.registry.open(WALKER).handle(ask.Rename("mine"))
    assert server.opens_another() == [server.newer]


def test_a_fork_that_is_refused_replaces_no_stage(server: Server) -> None:
    server.registry.limits = Limits(stages=6)
    forward_at_0 = ask.Post((SendEvent("FORWARD"),), 0)
    server.older.handle(ask.Step(3))
    for _ in range(3):
        server.older.handle(forward_at_0)
    server.time += LIMITS.rest_seconds + 1
    with pytest.raises(LimitError, match="forks that nobody uses"):
        server.older.handle(forward_at_0)
    assert server.newer in server.registry.all()


def test_a_stage_that_is_awake_stays(server: Server) -> None:
    server.registry.open(WALKER)
    with pytest.raises(LimitError):
        server.opens_another(LIMITS.rest_seconds - 1)


def test_a_stage_that_is_to_keep_running_stays(server: Server) -> None:
    for host in (server.older, server.newer):
        server.registry.close(host.id)
    for _ in range(LIMITS.stages - 1):
        server.registry.open(StageSetup(actors=WALKER.actors, keep_running=True))
    with pytest.raises(LimitError):
        server.opens_another(1e9)


def test_a_clock_of_a_client_stands_for_an_hour_before_its_stage_makes_room(server: Server) -> None:
    for host in (server.older, server.newer):
        server.registry.close(host.id)
    manual = [server.registry.open(StageSetup(clock="manual")) for _ in range(LIMITS.stages - 1)]
    patience = LIMITS.idle_seconds * MANUAL_PATIENCE
    with pytest.raises(LimitError):
        server.opens_another(patience - 1)
    assert server.opens_another(2) == manual[:1]
