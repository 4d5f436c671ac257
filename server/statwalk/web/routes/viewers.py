"""GET /api/stages/{id}/viewers: who watches a stage."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends

from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.stage_host import StageHost
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import stage_of
from statwalk.web.schemas.viewer import ViewerView

router = APIRouter(prefix="/api/stages", tags=["stages"], route_class=BoundedRoute)


@router.get("/{stage_id}/viewers")
def list_viewers(host: Annotated[StageHost, Depends(stage_of)]) -> list[ViewerView]:
    """Lists the viewers of a stage, in the order in which they came."""
    return [ViewerView.model_validate(viewer) for viewer in host.handle(ask.Viewers()).viewers]
