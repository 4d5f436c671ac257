"""/healthz, /readyz, /api/losses and /metrics: whether the server lives and takes requests, what its start
could not bring back, and what it does.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Request, Response
from prometheus_client import CONTENT_TYPE_PLAIN_0_0_4

from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.ticker import Ticker
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.connections import Connections
from statwalk.web.dependencies import CONNECTIONS, ENDING, registry_of
from statwalk.web.errors import Problem
from statwalk.web.long_work import LongWork
from statwalk.web.metrics import Metrics
from statwalk.web.schemas.readiness import HealthView, LossesView, LostStageView, ReadyView
from statwalk.web.upload_limiter import upload_limiter_of

METRICS: dict[int | str, dict[str, Any]] = {200: {"content": {"text/plain": {"schema": {"type": "string"}}}}}
VERSION = version("statwalk")
router = APIRouter(tags=["server"], route_class=BoundedRoute)


@router.get("/healthz")
async def get_health() -> HealthView:
    """Says that the process answers."""
    return HealthView(version=VERSION)


@router.get("/readyz")
async def get_readiness(request: Request) -> ReadyView:
    """Says whether the server takes requests: 503 while it stops, and while stages stand still that should
    not.
    """
    ending = request.scope.get(ENDING)
    if ending is not None and ending.is_set():
        raise Problem(503, "the server stops; use another one, or try again")
    ticker: Ticker | None = getattr(request.app.state, "ticker", None)
    fault = ticker.fault() if ticker else "the thread that steps the stages does not run"
    if fault:
        raise Problem(503, fault)
    return ReadyView()


@router.get("/api/losses")
async def list_losses(registry: Annotated[Registry, Depends(registry_of)]) -> LossesView:
    """Lists what the last start of the server did not bring back."""
    stages = [LostStageView(id=stage, why=why) for stage, why in registry.left.items()]
    return LossesView(stages=stages, other=registry.damage)


@router.get("/metrics", response_class=Response, responses=METRICS)
async def get_metrics(request: Request, registry: Annotated[Registry, Depends(registry_of)]) -> Response:
    """Returns what the server counts, in the text format of Prometheus."""
    metrics: Metrics = request.app.state.metrics
    long_work: LongWork = request.app.state.long_work
    uploads = upload_limiter_of(request)
    children = uploads.children.statistics()
    held = {"long requests": long_work.running, "uploads": uploads.arriving}
    queues = {"long requests": long_work.waiting, "uploads": children.tasks_waiting}
    connections: Connections | None = request.scope.get(CONNECTIONS)
    if connections is not None:
        held["connections"] = connections.count()
        metrics.count_connections(connections)
    text = metrics.text(registry.all(), held, queues)
    return Response(text, media_type=CONTENT_TYPE_PLAIN_0_0_4)
