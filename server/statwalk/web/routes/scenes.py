"""GET /api/scenes: the scenes; POST /api/stages {"scene": …} opens one."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends

from statwalk.files.scene import load_scene_file
from statwalk.services.library.catalogue import Catalogue
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import catalogue_of
from statwalk.web.schemas.scene import SceneView

router = APIRouter(prefix="/api/scenes", tags=["stages"], route_class=BoundedRoute)


@router.get("")
def list_scenes(catalogue: Annotated[Catalogue, Depends(catalogue_of)]) -> list[SceneView]:
    """Lists the scenes with their numbers of actors."""
    files = [(name, load_scene_file(folder)) for name, folder in catalogue.scene_folders.items()]
    return [
        SceneView(
            name=name,
            title=file.title or name,
            description=file.description,
            actors=sum(line.count for line in file.actors),
        )
        for name, file in files
    ]
