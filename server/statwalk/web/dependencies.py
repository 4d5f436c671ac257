"""The FastAPI dependencies of the routes: the registry, the catalogue, the stage of the path, the token."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Annotated

from anyio import to_thread
from fastapi import Depends, Header, Request
from starlette.requests import HTTPConnection

from statwalk.services.access.authenticator import Authenticator
from statwalk.services.access.roles import EVERYTHING, Grant
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import Doer
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.library.catalogue import Catalogue
from statwalk.web.errors import Problem
from statwalk.web.gate import GRANT, beyond
from statwalk.web.long_work import LongWork

ENDING = "statwalk.ending"
"""the key in the ASGI scope of the event that is set when the server stops"""
CONNECTIONS = "statwalk.connections"
"""the key in the ASGI scope of the server's connections"""


def registry_in(request: Request) -> Registry:
    """Returns the app's registry of stages."""
    registry: Registry = request.app.state.registry
    return registry


# dependencies that are coroutines need no thread, which short requests might have to wait for
async def registry_of(request: Request) -> Registry:
    """Returns the app's registry of stages."""
    return registry_in(request)


async def catalogue_of(request: Request) -> Catalogue:
    """Returns the app's catalogue of machines and characters."""
    return registry_in(request).catalogue


def authenticator_of(request: Request) -> Authenticator | None:
    """Returns what knows the server's tokens; None if it asks for none."""
    authenticator: Authenticator | None = request.app.state.authenticator
    return authenticator


def grant_of(connection: HTTPConnection) -> Grant:
    """Returns what the sender of a request, or the viewer of a socket, may do."""
    grant: Grant = connection.scope.get(GRANT, EVERYTHING)
    return grant


async def shown_to_link(connection: HTTPConnection) -> None:
    """Checks that a link to a stage shows only the machines and characters that play there.

    :raises Problem: 403, when another one is asked for.
    """
    stage, name = grant_of(connection).stage, connection.path_params.get("name")
    if stage is not None and name is not None:
        registry: Registry = connection.app.state.registry
        if name not in await to_thread.run_sync(_playing, registry, stage):
            raise Problem(403, beyond(stage))


def _playing(registry: Registry, stage: str) -> set[str]:
    """Returns the names of the machines on a stage and of their characters."""
    machines = {actor.machine for actor in registry.find(stage).handle(ask.DescribeActors())}
    entries = registry.catalogue.entries
    return machines | {entries[machine].character for machine in machines if machine in entries}


async def stage_of(stage_id: str, request: Request) -> StageHost:
    """Returns the host of the stage that the path names.

    :raises UnknownNameError: when no stage has this id.
    """
    return registry_in(request).find(stage_id)


ViewerNumber = Annotated[
    int,
    Header(
        alias="Statwalk-Viewer", ge=0, le=2**53, description="your number in the hello of the socket; 0: none"
    ),
]


async def doer_of(stage_id: str, request: Request, viewer: ViewerNumber = 0) -> Doer:
    """Returns who acts on the stage of the path: the viewer that the request names, or who sends it.

    :raises UnknownNameError: when no stage has this id.
    """
    return registry_in(request).find(stage_id).audience.doer(viewer, grant_of(request))


DoerDep = Annotated[Doer, Depends(doer_of)]


@asynccontextmanager
async def _watched(request: Request) -> AsyncIterator[tuple[CancelToken, asyncio.Future[None]]]:
    """Yields the token of a request, and a future that is done when the client disconnects."""
    token = CancelToken(request.scope.get(ENDING))
    watch = asyncio.ensure_future(_cancel_when_gone(request, token))
    try:
        yield token, watch
    finally:
        watch.cancel()


async def token_of(request: Request) -> AsyncIterator[CancelToken]:
    """Yields the token of a request, cancelled when the client disconnects; read the request's
    body before.
    """
    async with _watched(request) as (token, _):
        yield token


async def _long_work_token_of(request: Request) -> AsyncIterator[CancelToken]:
    """Yields the token of a long request, as soon as the request may run.

    :raises Problem: 503, when too many long requests wait already.
    :raises CancelledError: when the client disconnects before the request may run.
    """
    long_work: LongWork = request.app.state.long_work
    about = request.path_params.get("stage_id", "")
    async with _watched(request) as (token, disconnected), long_work.place(disconnected, about):
        token.expire_after(registry_in(request).limits.work_seconds)
        yield token


LongWorkToken = Annotated[CancelToken, Depends(_long_work_token_of, scope="function")]
"""its place is free before the answer is sent, so that a client that reads slowly blocks no place"""


async def _cancel_when_gone(request: Request, token: CancelToken) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass
    token.cancel()
