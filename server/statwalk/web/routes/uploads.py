"""PUT and DELETE /api/characters/{name}: upload and delete characters."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import anyio
from anyio import CancelScope, CapacityLimiter, to_thread
from fastapi import APIRouter, Depends, Query, Request, Response
from fastapi import Path as PathParameter
from pydantic import StringConstraints
from starlette.requests import ClientDisconnect

from statwalk.files.bvh.bvh_file import Position
from statwalk.files.captures import Reading
from statwalk.files.md2.md2_file import Inbetween
from statwalk.files.scale import LARGEST_SCALE, SMALLEST_SCALE
from statwalk.motion.filter_clip import HIGHEST_CUTOFF, Filter
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.disk import room_on_disk
from statwalk.services.library.model_store import NAME, ModelStore, UploadedCharacter
from statwalk.services.library.upload_sandbox import read_in_child
from statwalk.services.limits import MOST_UPLOADS
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import catalogue_of, token_of
from statwalk.web.errors import Problem
from statwalk.web.schemas.base import FILE_NAME_PATTERN, Flag
from statwalk.web.schemas.character import UploadView
from statwalk.web.security import MODEL
from statwalk.web.upload_limiter import upload_limiter_of

router = APIRouter(prefix="/api/characters", tags=["characters"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]
CHUNK_BYTES = 1 << 20
ARRIVAL_SECONDS = 600.0
MOST_LEFT_OUT = 500
MeshName = Annotated[str, StringConstraints(min_length=1, max_length=200)]
BODY = {
    "requestBody": {
        "required": True,
        "content": {
            kind: {"schema": {"type": "string", "format": "binary", "minLength": 1}} for kind in MODEL.types
        },
    }
}


def model_store_of(catalogue: Catalogue) -> ModelStore:
    """Returns the data folder.

    :raises Problem: 409, when the server has no data folder.
    """
    if catalogue.store is None:
        raise Problem(409, "this server refuses uploads: it has no data folder; start it with one")
    return catalogue.store


def check_name(name: str) -> str:
    """Returns the name of a character or machine in the data folder if it is safe as a file name.

    :raises Problem: 422, when the name is not safe.
    """
    if not NAME.fullmatch(name):
        raise Problem(
            422,
            f"{name[:80]!r} is no name: use 1 to 64 letters (A-Z, a-z), digits, - and _; "
            "begin with a letter or digit",
            field="name",
        )
    return name


def check_result_name(name: str, wanted: str | None, catalogue: Catalogue) -> str:
    """Returns the name under which a character that is made of another is kept.

    :raises Problem: 409, when a character of the server would be replaced; 422, when the name is not safe.
    """
    if wanted is None and name not in catalogue.uploads():
        raise Problem(
            409,
            f"the character {name[:80]!r} belongs to the server and stays as it is; "
            "name the new one: character",
            field="character",
        )
    return name if wanted is None else check_name(wanted)


def check_free(name: str, catalogue: Catalogue, store: ModelStore) -> None:
    """Checks that a character may be uploaded under a name.

    :raises Problem: 409, when the name belongs to a character, machine or scene of the server, or the data
        folder holds too many characters.
    """
    machine = catalogue.entries.get(name)
    if name in catalogue.owners or name in catalogue.scene_folders or (machine and not machine.made):
        raise Problem(
            409,
            f"the name {name!r} belongs to the server; choose another name",
            field="name",
        )
    if store.find(name) is None and len(store.characters()) >= MOST_UPLOADS:
        raise Problem(409, f"the data folder holds {MOST_UPLOADS} characters, and no more; delete one first")


@router.put(
    "/{name}",
    openapi_extra=BODY,
    status_code=200,
    responses={201: {"description": "the name is new", "model": UploadView}},
)
async def put_character(
    name: Annotated[str, PathParameter(json_schema_extra={"pattern": FILE_NAME_PATTERN})],
    request: Request,
    catalogue: CatalogueDep,
    response: Response,
    position: Position = "replace",
    scale: Annotated[float, Query(ge=SMALLEST_SCALE, le=LARGEST_SCALE)] = 1.0,
    low_pass: Annotated[float, Query(ge=0, le=HIGHEST_CUTOFF)] = 0.0,
    spikes: Flag = False,
    inbetween: Inbetween = "linear",
    without: Annotated[list[MeshName] | None, Query(max_length=MOST_LEFT_OUT)] = None,
) -> UploadView:
    """Uploads a character: a .glb, a self-contained .gltf, a zip of a .gltf or of a character file (.yaml)
    with its files, an .md2, a .chunk, a DirectX .x in text form, or a capture (.bvh, .trc), as the raw body.

    Replaces an uploaded character with the same name. The query is for captures: whether BVH position
    channels replace offsets, a scale of all lengths, a low-pass filter in Hz (0: none), and removal of
    spikes. For an .md2: the scale, and whether its vertices go from frame to frame or switch. `without`
    leaves a mesh out: the name of its node, or its own, or `NODE/PRIMITIVE` of one of the `parts`.
    """
    how = Reading(position, scale, Filter(low_pass, spikes), inbetween, tuple(without or ()))
    store = model_store_of(catalogue)
    await to_thread.run_sync(check_free, check_name(name), catalogue, store)
    limiter = upload_limiter_of(request)
    with limiter.place(), room_on_disk():
        return await take(name, request, response, store, limiter.children, how)


async def take(
    name: str,
    request: Request,
    response: Response,
    store: ModelStore,
    children: CapacityLimiter,
    how: Reading | None = None,
) -> UploadView:
    """Receives the body, has a child process read it, and stores it, without blocking the event loop.

    Stops if the client disconnects.
    """
    async with working_folder(store) as folder:
        await receive(request, folder / "upload")
        async with asynccontextmanager(token_of)(request) as token:
            read = partial(read_in_child, folder / "upload", folder / "model.glb", name, token, how)
            facts = await to_thread.run_sync(read, limiter=children)
        replaced = await to_thread.run_sync(store.find, name)
        upload = await to_thread.run_sync(store.keep, name, folder / "model.glb")
    response.status_code = 200 if replaced else 201
    response.headers["Location"] = f"/api/characters/{name}"
    return upload_view(upload, facts)


@asynccontextmanager
async def working_folder(store: ModelStore) -> AsyncIterator[Path]:
    """Yields the folder of `store.working`, which another thread makes and removes."""
    working = store.working()
    folder = await to_thread.run_sync(working.__enter__)
    try:
        yield folder
    finally:
        with CancelScope(shield=True):
            await to_thread.run_sync(working.__exit__, None, None, None)


async def receive(request: Request, file: Path) -> None:
    """Writes the body to a file while it arrives; the guard limits its size.

    :raises Problem: 400, when the body is empty or ends early; 408, when it takes too long.
    """
    written = 0
    try:
        with anyio.fail_after(ARRIVAL_SECONDS):
            async with await anyio.open_file(file, "wb", buffering=CHUNK_BYTES) as output:
                async for chunk in request.stream():
                    written += await output.write(chunk)
    except TimeoutError:
        raise Problem(408, f"the upload took longer than {ARRIVAL_SECONDS:.0f} s", field="body") from None
    except ClientDisconnect:
        raise Problem(400, "the upload ended early", field="body") from None
    if not written:
        raise Problem(400, "the body is empty; send the bytes of a model", field="body")


def upload_view(upload: UploadedCharacter, facts: dict[str, Any]) -> UploadView:
    """Returns the answer to an upload: the stored character, and the facts that the child found."""
    return UploadView(
        name=upload.name,
        sha256=upload.sha256,
        bytes=upload.bytes,
        model=f"/api/characters/{upload.name}/model.glb",
        **facts,
    )


@router.delete("/{name}", status_code=204)
def delete_character(name: str, catalogue: CatalogueDep) -> None:
    """Deletes an uploaded character.

    409 for the character of a machine folder, and while a machine uses the uploaded character.
    """
    if name in catalogue.owners:
        raise Problem(
            409,
            f"the character {name!r} belongs to the server; you can delete only uploaded characters",
            field="name",
        )
    uploads = catalogue.uploads()
    if name not in uploads:
        raise Problem(404, f"no uploaded character is called {name[:80]!r}", field="name", known=uploads)
    store = model_store_of(catalogue)
    with store.lock:
        machines = store.machines_of(uploads[name].sha256)
        if machines:
            raise Problem(
                409,
                f"first delete the machines that use {name!r}: {', '.join(machines)}",
                field="name",
                known=machines,
            )
        with room_on_disk():
            store.forget(name)
