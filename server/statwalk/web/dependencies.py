"""The FastAPI dependencies of the routes: the registry, the catalogue, the stage of the path, the token."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Annotated

from fastapi import Depends, Request

from statwalk.services.cancel import CancelToken
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.library.catalogue import Catalogue
from statwalk.web.long_work import LongWork

ENDING = "statwalk.ending"
"""the key in the ASGI scope of the event that is set when the server stops"""


def registry_of(request: Request) -> Registry:
    """Returns the app's registry of stages."""
    registry: Registry = request.app.state.registry
    return registry


def catalogue_of(request: Request) -> Catalogue:
    """Returns the app's catalogue of machines and characters."""
    return registry_of(request).catalogue


def stage_of(stage_id: str, request: Request) -> StageHost:
    """Returns the host of the stage that the path names.

    :raises UnknownNameError: when no stage has this id.
    """
    return registry_of(request).find(stage_id)


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
    async with _watched(request) as (token, disconnected), long_work.place(disconnected):
        yield token


LongWorkToken = Annotated[CancelToken, Depends(_long_work_token_of, scope="function")]
"""its place is free before the answer is sent, so that a client that reads slowly blocks no place"""


async def _cancel_when_gone(request: Request, token: CancelToken) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass
    token.cancel()
