"""GET /api/stages/{id}/history: which state every actor was in, and since when."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends

from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.stage_host import StageHost
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, stage_of
from statwalk.web.schemas.state_changes import HistoryView

router = APIRouter(prefix="/api/stages", tags=["stages"], route_class=BoundedRoute)


@router.get("/{stage_id}/history")
def get_history(host: Annotated[StageHost, Depends(stage_of)], token: LongWorkToken) -> HistoryView:
    """Lists the newest changes of state, at most 10,000; the first of each actor is its state on arrival."""
    return HistoryView.model_validate(host.handle(ask.History(), token))
