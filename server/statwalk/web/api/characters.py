"""GET /api/characters: what can be animated."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import APIRouter, Depends, Response

from statwalk.web.door import catalogue_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.depot import Kept

router = APIRouter(prefix="/api/characters", tags=["characters"], route_class=BoundedRoute)
Shelf = Annotated[Catalogue, Depends(catalogue_of)]


@router.get("")
def list_characters(catalogue: Shelf) -> list[dict[str, Any]]:
    """The characters, and the machine that each was found with (or, for one that was uploaded, the first that was made of it)."""
    found = [{"name": name, "machine": machine, "uploaded": False} for name, machine in catalogue.owners.items()]
    return [*found, *(view_upload(kept, catalogue) for kept in catalogue.uploads().values())]


def view_upload(kept: Kept, catalogue: Catalogue) -> dict[str, Any]:
    """An uploaded character in the list; `machines` are those made of this very content."""
    made = [entry for entry in catalogue.entries.values() if entry.made]
    machines = [entry.name for entry in made if entry.file.character_path.stem == kept.sha256]
    facts = {"name": kept.name, "machine": machines[0] if machines else None, "uploaded": True}
    return facts | {"sha256": kept.sha256, "bytes": kept.bytes, "machines": machines}


@router.get("/{name}")
def get_character(name: str, catalogue: Shelf) -> dict[str, Any]:
    """Joints (parents first), clips, skins and what was repaired when the file was read."""
    character = catalogue.character(name)
    skeleton = character.skeleton
    return {
        "name": name,
        "joints": [
            {"name": joint, "parent": int(parent), "node": int(node)}
            for joint, parent, node in zip(skeleton.names, skeleton.parent, character.node_index, strict=True)
        ],
        "clips": [{"name": clip.name, "duration": float(clip.duration)} for clip in character.clips.values()],
        "skins": len(character.skins),
        "parts": [
            {"node": part.node, "mesh": part.mesh, "primitive": part.primitive, "vertices": len(part.positions)} for part in character.parts
        ],
        "notes": list(character.notes),
        "model": f"/api/characters/{name}/model.glb",
    }


@router.get("/{name}/model.glb", response_class=Response, responses={200: {"content": {"model/gltf-binary": {}}}})
def get_model(name: str, catalogue: Shelf) -> Response:
    """The model, as any glTF viewer opens it."""
    return Response(catalogue.character(name).model_glb, media_type="model/gltf-binary", headers={"Cache-Control": "no-cache"})
