"""The application: the routes, what they share, and the door around everything."""

from __future__ import annotations

import asyncio
import threading
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from anyio import to_thread
from fastapi import FastAPI
from starlette.types import ASGIApp

from statwalk.maths.kernels.choose import kernels
from statwalk.web import page, problem
from statwalk.web.api import actors, characters, editing, explain, history, machines, making, scenes, stages, uploads
from statwalk.web.guard import Guard
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.depot import Depot
from statwalk.web.keeping.registry import Registry
from statwalk.web.keeping.watching import Watch
from statwalk.web.schemas import ProblemView
from statwalk.web.settings import Settings
from statwalk.web.streaming import messages, stream
from statwalk.web.streaming.pacer import Pacer

DESCRIPTION = "Animates characters from state tables. Errors are application/problem+json (RFC 9457)."
ROOMS = tuple(room.router for room in (characters, uploads, machines, making, editing, stages, scenes, history, actors, explain, stream))


def create_app(settings: Settings | None = None) -> ASGIApp:
    """The server as an ASGI application; machine files are read now, models when they are first needed.

    :raises ContentError: if a machine folder must be refused.
    """
    return Guard(rooms(settings or Settings()), (settings or Settings()).hosts)


def rooms(settings: Settings) -> FastAPI:
    """The application inside the door."""
    registry = Registry(Catalogue(settings.folders, Depot(settings.data) if settings.data else None), settings)
    errors: dict[int | str, dict[str, Any]] = {
        status: {"model": ProblemView, "content": {problem.MEDIA_TYPE: {}}} for status in (400, 404, 409, 413, 415, 422)
    }
    app = FastAPI(
        title="statwalk",
        description=DESCRIPTION,
        openapi_url="/api/openapi.json",
        docs_url=None,  # both documentation pages fetch their scripts from a foreign server, which the page's policy forbids
        redoc_url=None,
        lifespan=lifespan,
    )
    app.state.registry = registry
    for room in ROOMS:
        app.include_router(room, responses=errors)
    problem.install(app)
    page.install(app, settings.page)
    if settings.main_stage:
        registry.open_main()
    return app


@asynccontextmanager
async def lifespan(app: FastAPI) -> AsyncIterator[None]:
    """While the server runs: the pacer's thread, and once a second the housekeeping."""
    registry: Registry = app.state.registry
    pacer = Pacer(registry.all)
    registry.wake = pacer.wake
    pacer.start()
    threading.Thread(target=kernels, name="kernels").start()  # so that nobody waits for them who asks for vertices
    housekeeper = asyncio.ensure_future(keep_house(registry, Watch(registry.editions) if registry.settings.watch else None))
    try:
        yield
    finally:
        housekeeper.cancel()
        pacer.stop()


async def keep_house(registry: Registry, watch: Watch | None) -> None:
    """Tells viewers where their stage is, cuts off those that do not acknowledge, lets go of stages that nobody uses, follows files."""
    while True:
        await asyncio.sleep(1.0)
        for hosted in registry.all():
            hosted.broadcast.cut_overdue(time.monotonic())
            if hosted.broadcast.mailboxes:
                hosted.broadcast.tell(messages.status(hosted.status()))
        registry.drop_idle()
        if watch:
            await to_thread.run_sync(watch.look)
