"""POST /api/characters/{name}/rig: gives a mesh a skeleton and a skin."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Request, Response

from statwalk.character.autorig.wish import RigWish
from statwalk.services.cancel import CancelToken
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.rig_sandbox import rig_in_child
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import catalogue_of
from statwalk.web.routes.remade import remade
from statwalk.web.schemas.character import UploadView
from statwalk.web.schemas.rig import NewRig

router = APIRouter(prefix="/api/characters", tags=["characters"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]


@router.post("/{name}/rig", status_code=201)
async def rig_character(
    name: str, new: NewRig, request: Request, catalogue: CatalogueDep, response: Response
) -> UploadView:
    """Gives a character a skeleton and a skin, and keeps the result as an uploaded character: this one, or a
    new one called `character`.

    A child process does the work; it is killed if the client disconnects.
    """
    wish = RigWish(new.skeleton, new.weights, new.facing)

    def rig(model: Path, out: Path, result: str, token: CancelToken) -> dict[str, Any]:
        return rig_in_child(model, out, result, wish, token)

    return await remade(name, new.character, rig, request, catalogue, response)
