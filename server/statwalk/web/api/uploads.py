"""PUT and DELETE /api/characters/{name}: characters that users bring along."""

from __future__ import annotations

import errno
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import anyio
from anyio import CancelScope, CapacityLimiter, to_thread
from fastapi import APIRouter, Depends, Request, Response
from starlette.requests import ClientDisconnect

from statwalk.files.faqnames import MEANINGS, proposed
from statwalk.web.door import catalogue_of
from statwalk.web.guard import MODEL
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.depot import NAME, Depot, Kept
from statwalk.web.keeping.parsing import read_in_child
from statwalk.web.problem import Problem
from statwalk.web.settings import MOST_UPLOADS

router = APIRouter(prefix="/api/characters", tags=["characters"], route_class=BoundedRoute)
Shelf = Annotated[Catalogue, Depends(catalogue_of)]
MOST_AT_ONCE = 8
MOST_CHILDREN = 2
CHUNK_BYTES = 1 << 20
ARRIVAL_SECONDS = 600.0
BODY = {"requestBody": {"required": True, "content": {kind: {"schema": {"type": "string", "format": "binary"}} for kind in MODEL.types}}}


class Desk:
    """How many uploads there may be at once, and how many of them are read; one for the server."""

    def __init__(self) -> None:
        self.arriving = 0
        self.children = CapacityLimiter(MOST_CHILDREN)

    @contextmanager
    def place(self) -> Iterator[None]:
        """A place for one upload.

        :raises Problem: 503, if all are taken.
        """
        if self.arriving >= MOST_AT_ONCE:
            raise Problem(503, f"{MOST_AT_ONCE} uploads are on their way already; try again")
        self.arriving += 1
        try:
            yield
        finally:
            self.arriving -= 1


def desk_of(request: Request) -> Desk:
    """The app's desk."""
    state = request.app.state
    if not hasattr(state, "desk"):
        state.desk = Desk()
    desk: Desk = state.desk
    return desk


def depot_of(catalogue: Catalogue) -> Depot:
    """The data folder.

    :raises Problem: 409, if the server has none.
    """
    if catalogue.depot is None:
        raise Problem(409, "this server keeps no uploads: it was started without a data folder")
    return catalogue.depot


@contextmanager
def room_on_disk() -> Iterator[None]:
    """Turns a full disk into a 507."""
    try:
        yield
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EDQUOT):
            raise Problem(507, "the disk of the data folder is full") from None
        raise


def check_name(name: str) -> str:
    """A name for something in the data folder; nothing in it can lead elsewhere.

    :raises Problem: 422, if it cannot be one.
    """
    if not NAME.fullmatch(name):
        raise Problem(422, "a name has 1 to 64 letters a-z, digits, - and _, and begins with a letter or digit", field="name")
    return name


def check_free(name: str, catalogue: Catalogue, depot: Depot) -> None:
    """409 where the name belongs to a character that came with a machine folder, or there are too many uploads."""
    if name in catalogue.owners:
        raise Problem(409, f"the character {name!r} belongs to a machine folder of the server; choose another name", field="name")
    if depot.find(name) is None and len(depot.characters()) >= MOST_UPLOADS:
        raise Problem(409, f"the data folder holds {MOST_UPLOADS} characters, which is the most it may; delete one")


@router.put("/{name}", openapi_extra=BODY, status_code=200, responses={201: {"description": "it is new"}})
async def put_character(name: str, request: Request, catalogue: Shelf, response: Response) -> dict[str, Any]:
    """Takes a .glb, a self-contained .gltf, or a zip of a .gltf with its files, as the raw body. Replaces one of that name."""
    depot = depot_of(catalogue)
    await to_thread.run_sync(check_free, check_name(name), catalogue, depot)
    desk = desk_of(request)
    with desk.place(), room_on_disk():
        return await take(name, request, response, depot, desk.children)


async def take(name: str, request: Request, response: Response, depot: Depot, children: CapacityLimiter) -> dict[str, Any]:
    """Receives the body, has it read, keeps it; nothing of it is done on the event loop."""
    async with working(depot) as folder:
        await receive(request, folder / "upload")
        read = partial(read_in_child, folder / "upload", folder / "model.glb", name)
        facts = await to_thread.run_sync(read, limiter=children)
        former = await to_thread.run_sync(depot.find, name)
        kept = await to_thread.run_sync(depot.keep, name, folder / "model.glb")
    response.status_code = 200 if former else 201
    response.headers["Location"] = f"/api/characters/{name}"
    return view(kept) | facts


@asynccontextmanager
async def working(depot: Depot) -> AsyncIterator[Path]:
    """`depot.working`, made and cleared away by another thread."""
    opened = depot.working()
    folder = await to_thread.run_sync(opened.__enter__)
    try:
        yield folder
    finally:
        with CancelScope(shield=True):
            await to_thread.run_sync(opened.__exit__, None, None, None)


async def receive(request: Request, file: Path) -> None:
    """The body, as it comes, into a file; the door counts its bytes.

    :raises Problem: 400, if it ends early, or there is none; 408, if it takes too long.
    """
    taken = 0
    try:
        with anyio.fail_after(ARRIVAL_SECONDS):
            async with await anyio.open_file(file, "wb", buffering=CHUNK_BYTES) as opened:
                async for chunk in request.stream():
                    taken += await opened.write(chunk)
    except TimeoutError:
        raise Problem(408, f"the upload took more than {ARRIVAL_SECONDS:.0f} s", field="body") from None
    except ClientDisconnect:
        raise Problem(400, "the upload ended early", field="body") from None
    if not taken:
        raise Problem(400, "there is no body; it must be the model's bytes", field="body")


def view(kept: Kept) -> dict[str, Any]:
    """An uploaded character."""
    return {
        "name": kept.name,
        "uploaded": True,
        "sha256": kept.sha256,
        "bytes": kept.bytes,
        "model": f"/api/characters/{kept.name}/model.glb",
    }


@router.delete("/{name}", status_code=204)
def delete_character(name: str, catalogue: Shelf) -> None:
    """Deletes an uploaded character. 409 for one that came with a machine folder, and while a machine is made of it."""
    if name in catalogue.owners:
        raise Problem(409, f"the character {name!r} belongs to a machine folder of the server", field="name")
    kept = catalogue.uploads().get(name)
    if kept is None:
        raise Problem(404, f"there is no character {name[:80]!r}", field="name", known=catalogue.uploads())
    depot = depot_of(catalogue)
    with depot.lock:
        machines = depot.machines_of(kept.sha256)
        if machines:
            raise Problem(409, f"delete the machines that are made of it first: {', '.join(machines)}", field="name", known=machines)
        depot.forget(name)


@router.get("/{name}/mapping")
def get_mapping(name: str, catalogue: Shelf) -> dict[str, Any]:
    """The states that the clips propose to be; change them and post them to /api/machines."""
    clips = catalogue.character(name).clips
    return {"character": name, "mapping": proposed(clips), "meanings": MEANINGS}
