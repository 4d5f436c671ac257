"""A registry of stages, and a stage in it."""

from collections.abc import Iterator

import pytest
from stages import registry
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.library.catalogue import Catalogue


@pytest.fixture(scope="module")
def held() -> Registry:
    return registry(Catalogue())


@pytest.fixture
def host(held: Registry) -> Iterator[StageHost]:
    """A walker that was sent forward ten ticks ago."""
    host = held.open(StageSetup(clock="manual", actors=(AddActor("faq-walker"),)))
    host.handle(ask.Post((SendEvent("FORWARD", 1),)))
    host.handle(ask.Step(10))
    yield host
    for other in held.all():
        held.close(other.id)
