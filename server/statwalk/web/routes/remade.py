"""Keeps what a child process makes of a character as an uploaded character."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import asynccontextmanager
from functools import partial
from pathlib import Path
from typing import Any

from anyio import to_thread
from fastapi import Request, Response

from statwalk.services.cancel import CancelToken
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.disk import room_on_disk
from statwalk.web.dependencies import token_of
from statwalk.web.routes.uploads import (
    check_free,
    check_result_name,
    model_store_of,
    upload_view,
    working_folder,
)
from statwalk.web.schemas.character import UploadView
from statwalk.web.upload_limiter import upload_limiter_of

InChild = Callable[[Path, Path, str, CancelToken], dict[str, Any]]
"""gets the model, the file to write, the name of the result, and a token that cancels"""


async def remade(
    name: str,
    wanted: str | None,
    in_child: InChild,
    request: Request,
    catalogue: Catalogue,
    response: Response,
) -> UploadView:
    """Has a child make a new model of a character, and keeps it under the `wanted` name, or under its own.

    :raises Problem: when the name is taken, or no place is free.
    """
    store = model_store_of(catalogue)
    result = check_result_name(name, wanted, catalogue)
    await to_thread.run_sync(check_free, result, catalogue, store)
    model = await to_thread.run_sync(catalogue.model_glb, name)
    limiter = upload_limiter_of(request)
    with limiter.place(), room_on_disk():
        async with working_folder(store) as folder:
            await to_thread.run_sync(Path.write_bytes, folder / "source.glb", model)
            async with asynccontextmanager(token_of)(request) as token:
                work = partial(in_child, folder / "source.glb", folder / "model.glb", result, token)
                facts = await to_thread.run_sync(work, limiter=limiter.children)
            upload = await to_thread.run_sync(store.keep, result, folder / "model.glb")
    response.headers["Location"] = f"/api/characters/{result}"
    return upload_view(upload, facts)
