"""GET /api/scenes: stages that come furnished; POST /api/stages {"scene": …} opens one."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import APIRouter, Depends

from statwalk.files.scenefile import load_scene_file
from statwalk.web.door import catalogue_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.catalogue import Catalogue

router = APIRouter(prefix="/api/scenes", tags=["stages"], route_class=BoundedRoute)


@router.get("")
def list_scenes(catalogue: Annotated[Catalogue, Depends(catalogue_of)]) -> list[dict[str, Any]]:
    """The scenes, with how many actors stand in each."""
    found = [(name, load_scene_file(folder)) for name, folder in catalogue.scene_folders.items()]
    return [
        {"name": name, "title": file.title or name, "description": file.description, "actors": sum(line.count for line in file.actors)}
        for name, file in found
    ]
