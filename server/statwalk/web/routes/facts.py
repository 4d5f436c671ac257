"""GET /api/stages/{id}/facts: the actions and verdicts that a client has missed."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends

from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.stage_host import StageHost
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, stage_of
from statwalk.web.schemas.base import Tick
from statwalk.web.schemas.facts_since import FactsView

router = APIRouter(prefix="/api/stages", tags=["stages"], route_class=BoundedRoute)


@router.get("/{stage_id}/facts")
def get_facts(
    host: Annotated[StageHost, Depends(stage_of)], token: LongWorkToken, since: Tick = 0
) -> FactsView:
    """Lists the actions and verdicts after tick `since`; 409 if the stage has forgotten some of them."""
    return FactsView.model_validate(host.handle(ask.Effects(since), token))
