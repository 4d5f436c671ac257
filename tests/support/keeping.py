"""Registries that keep their stages in a folder, without a server; and what a stage is, in a few values."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from stages import registry
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.reopen import reopen
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.store.store import Store
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits

LIMITS = Limits()


@contextmanager
def keeping(folder: Path, catalogue: Catalogue, limits: Limits = LIMITS) -> Iterator[Registry]:
    """A registry as a server has it between its start and its end."""
    held = registry(catalogue)
    held.limits = limits
    held.store = Store(folder, catalogue.texts.__getitem__)
    held.versions.store = held.store
    reopen(held, held.main_content())
    try:
        yield held
    finally:
        held.save()
        held.store.close()


def what_it_is(host: StageHost) -> dict[str, Any]:
    """Where a stage is, the hash of its state, and its log."""
    facts = host.handle(ask.Describe())
    log = host.handle(ask.Log())
    status = facts.status
    return {
        "hash": facts.hash,
        "place": (status.tick, status.head, status.paused, status.speed),
        "settings": (facts.id, facts.clock, facts.rate, facts.seed),
        "log": log[1:],
    }
