"""The ASGI application: the routes, the state they share, and the guard around them."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from anyio import CapacityLimiter, to_thread
from fastapi import FastAPI
from starlette.types import ASGIApp

from statwalk.services.hosting.file_watch import FileWatch
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.ticker import Ticker
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.model_store import ModelStore
from statwalk.web import errors, openapi, page
from statwalk.web.long_work import LongWork
from statwalk.web.routes import (
    actors,
    captures,
    characters,
    edits,
    explain,
    history,
    machines,
    new_machines,
    scenes,
    stages,
    uploads,
)
from statwalk.web.security import Guard
from statwalk.web.settings import Settings
from statwalk.web.socket import messages, stream

MOST_PAST_WORK = 4
"""how many threads compute past ticks for viewers at once"""
DESCRIPTION = "Animates characters from state tables. Errors are application/problem+json (RFC 9457)."
ROUTES = (
    characters,
    uploads,
    machines,
    new_machines,
    edits,
    stages,
    scenes,
    history,
    actors,
    captures,
    explain,
    stream,
)


def create_app(settings: Settings | None = None) -> ASGIApp:
    """Returns the server as an ASGI application; it reads machine files now, and models on first use.

    :raises ContentError: when a machine folder is refused.
    """
    return Guard(_routes(settings or Settings()), (settings or Settings()).hosts)


def _routes(settings: Settings) -> FastAPI:
    """Returns the application inside the guard."""
    catalogue = Catalogue(settings.folders, ModelStore(settings.data) if settings.data else None)
    registry = Registry(catalogue, messages.fact, settings.limits)
    app = FastAPI(
        title="statwalk",
        description=DESCRIPTION,
        openapi_url="/api/openapi.json",
        # both documentation pages load scripts from another server, which our content security policy forbids
        docs_url=None,
        redoc_url=None,
        lifespan=lifespan,
    )
    app.state.registry = registry
    app.state.long_work = LongWork()
    app.state.past_limiter = CapacityLimiter(MOST_PAST_WORK)
    app.state.file_watch = FileWatch(registry.versions) if settings.watch else None
    for route in ROUTES:
        app.include_router(route.router, responses=openapi.REFUSALS)
    errors.install(app)
    openapi.install(app)
    page.install(app, settings.page)
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
    ticker = Ticker(registry.all)
    registry.wake = ticker.wake
    ticker.start()
    housekeeping = asyncio.ensure_future(_housekeeping(registry, app.state.file_watch))
    try:
        yield
    finally:
        housekeeping.cancel()
        ticker.stop()


async def _housekeeping(registry: Registry, watch: FileWatch | None) -> None:
    """Once a second: sends each stage's status to its viewers, disconnects viewers that do not acknowledge
    frames, closes idle stages, and reads saved machine files.
    """
    while True:
        await asyncio.sleep(1.0)
        now = time.monotonic()
        for host in registry.all():
            host.look_after_viewers(now)
        registry.drop_idle(now)
        if watch:
            await to_thread.run_sync(watch.look)
