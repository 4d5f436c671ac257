"""The ASGI application: the routes, the state they share, and the guard around them."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import partial
from typing import Any
from weakref import WeakKeyDictionary

from anyio import CapacityLimiter, to_thread
from fastapi import Depends, FastAPI
from starlette.types import ASGIApp

from statwalk.services.access.authenticator import Authenticator
from statwalk.services.hosting.file_watch import FileWatch
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.reopen import reopen
from statwalk.services.hosting.store.store import Store
from statwalk.services.hosting.ticker import Ticker
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.model_store import ModelStore
from statwalk.services.library.role_reference import reference_to
from statwalk.services.work.workers import Workers
from statwalk.web import errors, openapi, page
from statwalk.web.dependencies import shown_to_link
from statwalk.web.long_work import LongWork
from statwalk.web.metrics import Metrics
from statwalk.web.rate_limits import RateGuard, RateLimits
from statwalk.web.request_log import RequestLog
from statwalk.web.routes import (
    actors,
    captures,
    characters,
    curves,
    deduce,
    details,
    differences,
    downloads,
    edits,
    explain,
    facts,
    health,
    history,
    links,
    machine_zips,
    machines,
    new_machines,
    rigs,
    scenes,
    stages,
    uploads,
    versions,
    viewers,
)
from statwalk.web.security import Guard
from statwalk.web.settings import Settings
from statwalk.web.socket import messages, stream

MOST_PAST_WORK = 4
"""how many threads compute past ticks for viewers at once"""
DESCRIPTION = "Animates characters from state tables. Errors are application/problem+json (RFC 9457)."
ROUTES = (
    characters,
    downloads,
    deduce,
    uploads,
    versions,
    machine_zips,
    machines,
    new_machines,
    edits,
    stages,
    scenes,
    facts,
    history,
    differences,
    links,
    viewers,
    actors,
    captures,
    details,
    rigs,
    explain,
    curves,
    health,
    stream,
)


def create_app(settings: Settings | None = None) -> ASGIApp:
    """Returns the server as an ASGI application; it reads machine files now, and models on first use.

    :raises ContentError: when a machine folder is refused, or the database is no database of statwalk.
    :raises ConflictError: when another server keeps its stages in the same data folder.
    :raises StorageError: when the data folder cannot be written.
    """
    settings = settings or Settings()
    app = _routes(settings)
    return RequestLog(Guard(app, settings.names, settings.authenticator), app.state.metrics)


def _routes(settings: Settings) -> FastAPI:
    """Returns the application inside the guard."""
    catalogue = Catalogue(settings.folders, ModelStore(settings.data) if settings.data else None)
    store = Store(settings.kept, catalogue.texts.__getitem__) if settings.kept else None
    if catalogue.store and settings.kept == settings.data:  # which no other server uses
        catalogue.store.sweep(0)
    registry = Registry(catalogue, messages.fact, settings.limits, store=store)
    app = FastAPI(
        title="statwalk",
        description=DESCRIPTION,
        openapi_url="/api/openapi.json",
        # both documentation pages load scripts from another server, which our content security policy forbids
        docs_url=None,
        redoc_url=None,
        lifespan=lifespan,
    )
    app.state.metrics = Metrics()
    registry.measure_ticks = app.state.metrics.measure_ticks
    app.state.rates = RateLimits(settings.limits, proxied=settings.proxied)
    app.state.registry = registry
    app.state.names, app.state.authenticator = settings.names, settings.authenticator
    app.state.long_work = LongWork()
    app.state.past_limiter = CapacityLimiter(MOST_PAST_WORK)
    app.state.input_limiters = WeakKeyDictionary()
    app.state.file_watch = FileWatch(registry.versions) if settings.watch else None
    for route in ROUTES:
        app.include_router(route.router, responses=openapi.REFUSALS, dependencies=[Depends(shown_to_link)])
    app.add_middleware(RateGuard, rates=app.state.rates, registry=registry)
    errors.install(app)
    openapi.install(app)
    page.install(app, settings.page)
    reopen(registry, registry.main_content(settings.scene))
    if settings.main_stage:
        registry.open_main(settings.scene)
    return app


def openapi_document() -> dict[str, Any]:
    """Returns the OpenAPI document of `/api/openapi.json` without starting a server."""
    return _routes(Settings(folders=(), main_stage=False)).openapi()


@asynccontextmanager
async def lifespan(app: FastAPI) -> AsyncIterator[None]:
    """Runs the ticker and the housekeeping while the server runs."""
    registry: Registry = app.state.registry
    ticker = app.state.ticker = Ticker(registry.all)
    registry.wake = ticker.wake
    ticker.start()
    workers = app.state.workers = Workers(partial(reference_to, registry.catalogue))
    registry.work = workers.do
    housekeeping = asyncio.ensure_future(_housekeeping(app, registry, workers))
    try:
        yield
    finally:
        housekeeping.cancel()
        workers.close()
        ticker.stop()
        registry.save()
        if registry.store:
            registry.store.close()


async def _housekeeping(app: FastAPI, registry: Registry, workers: Workers) -> None:
    """Once a second: sends each stage's status to its viewers, disconnects viewers that do not acknowledge
    frames or whose access has ended, closes idle stages, ends idle workers, keeps how far each stage is, and
    reads saved machine files.
    """
    authenticator: Authenticator | None = app.state.authenticator
    watch: FileWatch | None = app.state.file_watch
    while True:
        await asyncio.sleep(1.0)
        now = registry.now()
        for host in registry.all():
            host.look_after_viewers(now)
        registry.drop_idle(now)
        workers.end_idle(time.monotonic())
        if authenticator:
            authenticator.disconnect_ended(time.monotonic(), registry.stages)
        await to_thread.run_sync(registry.save)
        if watch:
            await to_thread.run_sync(watch.look)
