"""GET …/export.zip, PUT …/import.zip: a machine as one file, and back."""

from __future__ import annotations

import hashlib
from contextlib import asynccontextmanager
from functools import partial
from pathlib import Path
from typing import Annotated

from anyio import to_thread
from fastapi import APIRouter, Depends, Request, Response
from fastapi import Path as PathParameter

from statwalk.services.cancel import CancelToken
from statwalk.services.hosting.registry import Registry
from statwalk.services.library import made_machines
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.disk import room_on_disk
from statwalk.services.library.made_keys import MadeKey, NewPlace, made_by
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, catalogue_of, registry_of, token_of
from statwalk.web.routes.edits import Key
from statwalk.web.routes.machines import encoded, machine_members
from statwalk.web.routes.new_machines import check_free_machine
from statwalk.web.routes.uploads import check_name, model_store_of, receive, working_folder
from statwalk.web.schemas.base import FILE_NAME_PATTERN
from statwalk.web.schemas.machine import MachineView
from statwalk.web.upload_limiter import upload_limiter_of

ZIP = "application/zip"
BODY = {
    "content": {
        kind: {"schema": {"type": "string", "format": "binary", "minLength": 1}}
        for kind in (ZIP, "application/octet-stream")
    },
    "required": True,
}
router = APIRouter(prefix="/api/machines/{name}", tags=["machines"], route_class=BoundedRoute)


@router.get("/export.zip", response_class=Response, responses={200: {"content": {ZIP: {}}}})
def export_machine(
    name: str, catalogue: Annotated[Catalogue, Depends(catalogue_of)], _: LongWorkToken
) -> Response:
    """Returns the newest version of a machine with its tables and its character, as a zip; `statwalk serve`
    plays the unpacked folder.
    """
    entry = catalogue.entry(name)
    headers = {"Content-Disposition": f'attachment; filename="{entry.folder.name}.zip"'}
    return Response(made_machines.pack(entry, catalogue.store), headers=headers, media_type=ZIP)


@router.put("/import.zip", status_code=201, response_model=MachineView, openapi_extra={"requestBody": BODY})
async def import_machine(
    name: Annotated[str, PathParameter(json_schema_extra={"pattern": FILE_NAME_PATTERN})],
    request: Request,
    registry: Annotated[Registry, Depends(registry_of)],
    key: Key = "",
) -> Response:
    """Makes a machine of a zip, as `export.zip` gives it, or of a folder with a machine.yaml and a model.

    409 if the name is taken.
    """
    catalogue = registry.catalogue
    store = model_store_of(catalogue)
    check_name(name)
    if not key:
        await to_thread.run_sync(check_free_machine, name, catalogue, store)
    limiter = upload_limiter_of(request)
    with limiter.place(), room_on_disk():
        async with working_folder(store) as folder:
            await receive(request, folder / "upload")
            async with asynccontextmanager(token_of)(request) as token:
                made = partial(_made, name, key, folder / "upload", registry, token)
                present = await to_thread.run_sync(made, limiter=limiter.children)
    members = await to_thread.run_sync(registry.versions.current, present)
    view = await to_thread.run_sync(lambda: encoded(MachineView(**machine_members(*members))))
    view.status_code = 201
    view.headers["Location"] = f"/api/machines/{present}"
    return view


def _made(name: str, key: str, upload: Path, registry: Registry, token: CancelToken) -> str:
    """Makes the machine of an uploaded zip, unless the same request has made it; returns its name."""
    catalogue = registry.catalogue
    store = model_store_of(catalogue)
    with upload.open("rb") as file:
        made = MadeKey.of(key, "import", name, hashlib.file_digest(file, "sha256").hexdigest())
    present = made_by(made, store.machine_folders())
    if present is None:
        check_free_machine(name, catalogue, store)
        registry.versions.forget(name)  # that a server left behind which was killed
        place = NewPlace(name, store, made)
        catalogue.adopt(*made_machines.unpack(place, upload, catalogue, token))
    return present or name
