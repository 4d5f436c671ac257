"""Levels of detail: /api/characters/{name}/levels lists them, POST …/lod finds them, …/lod.glb is a coarser
model.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request, Response

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.gltf.detailed_model import lod
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.detail_sandbox import detail_in_child
from statwalk.skin.detail.coarser import coarser_faces, faces_of
from statwalk.skin.primitive import TRIANGLES
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import catalogue_of
from statwalk.web.routes.remade import remade
from statwalk.web.schemas.character import UploadView
from statwalk.web.schemas.detail import LevelView, NewDetail

router = APIRouter(prefix="/api/characters", tags=["characters"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]


@router.get("/{name}/levels")
def list_levels(name: str, catalogue: CatalogueDep) -> list[LevelView]:
    """Lists the levels of detail that the model holds, the full skin first; empty if it holds none."""
    character = catalogue.character(name)
    stored = ((0, 0.0), *character.levels) if character.levels else ()
    return [_level(character, steps, error) for steps, error in stored]


def _level(character: Character, steps: int, error: float) -> LevelView:
    triangles, gone = 0, 0
    for part in character.parts:
        if part.collapses is not None and steps:
            triangles += len(coarser_faces(part, steps))
            gone += part.collapses.count(steps)
        elif part.mode == TRIANGLES:
            triangles += len(faces_of(part))
    vertices = sum(len(part.positions) for part in character.parts) - gone
    return LevelView(steps=steps, error=error, vertices=vertices, triangles=triangles)


@router.get(
    "/{name}/lod.glb", response_class=Response, responses={200: {"content": {"model/gltf-binary": {}}}}
)
def get_coarser_model(
    name: str,
    catalogue: CatalogueDep,
    error: Annotated[float | None, Query(ge=0, le=1e6)] = None,
    vertices: Annotated[int | None, Query(ge=1, le=10**9)] = None,
    share: Annotated[float | None, Query(gt=0, le=1)] = None,
) -> Response:
    """Returns a coarser model: at most `error` metres from the full skin, or with at most so many `vertices`,
    or at most a `share` of them.
    """
    character = catalogue.character(name)
    if not character.levels:
        raise ContentError(f"{name} has no level of detail; POST /api/characters/{name}/lod finds it")
    coarse = lod(character, error, vertices=vertices, share=share)
    headers = {"Cache-Control": "no-cache"}
    return Response(coarse.model_glb, media_type="model/gltf-binary", headers=headers)


@router.post("/{name}/lod", status_code=201)
async def find_detail(
    name: str, new: NewDetail, request: Request, catalogue: CatalogueDep, response: Response
) -> UploadView:
    """Finds the order in which the vertices of a character collapse, and keeps the result as an uploaded
    character: this one, or a new one called `character`.

    A child process does the work; it is killed if the client disconnects.
    """
    return await remade(name, new.character, detail_in_child, request, catalogue, response)
