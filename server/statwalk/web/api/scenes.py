"""GET /api/scenes: stages that come furnished; POST /api/stages {"scene": …} opens one."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import APIRouter, Depends

from statwalk.files.scenefile import load_scene_file
from statwalk.web.door import library_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.library import Library

router = APIRouter(prefix="/api/scenes", tags=["stages"], route_class=BoundedRoute)


@router.get("")
def list_scenes(library: Annotated[Library, Depends(library_of)]) -> list[dict[str, Any]]:
    """The scenes, with how many actors stand in each."""
    found = [(name, load_scene_file(folder)) for name, folder in library.scene_folders.items()]
    return [
        {"name": name, "title": file.title or name, "description": file.description, "actors": sum(line.count for line in file.actors)}
        for name, file in found
    ]
