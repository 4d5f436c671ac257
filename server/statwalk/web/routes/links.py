"""/api/access, /api/stages/{id}/links: what you may do, and links that share a stage."""

from __future__ import annotations

import time
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response

from statwalk.services.access.authenticator import Authenticator
from statwalk.services.access.roles import Grant
from statwalk.services.access.share_links import ShareLink
from statwalk.services.hosting.stage_host import StageHost
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import authenticator_of, grant_of, stage_of
from statwalk.web.errors import Problem
from statwalk.web.same_origin import OwnNames
from statwalk.web.schemas.share_link import AccessView, LinkView, MadeLink, NewLink

router = APIRouter(prefix="/api", tags=["access"], route_class=BoundedRoute)
GrantDep = Annotated[Grant, Depends(grant_of)]
HostDep = Annotated[StageHost, Depends(stage_of)]


def _tokens(authenticator: Annotated[Authenticator | None, Depends(authenticator_of)]) -> Authenticator:
    """Returns what knows the tokens.

    :raises Problem: 409, when the server asks for none.
    """
    if authenticator is None:
        raise Problem(409, "this server asks for no token, so that a link would allow nothing more")
    return authenticator


TokensDep = Annotated[Authenticator, Depends(_tokens)]


def _view(link: ShareLink, now: float) -> dict[str, object]:
    return {
        "id": link.id,
        "role": link.role,
        "maker": link.maker.name,
        "seconds_left": max(0.0, round(link.until - now, 1)),
    }


@router.get("/access")
async def get_access(
    grant: GrantDep, authenticator: Annotated[Authenticator | None, Depends(authenticator_of)]
) -> AccessView:
    """Returns what you may do."""
    return AccessView(
        token_needed=authenticator is not None, name=grant.name, role=grant.role, stage=grant.stage
    )


@router.post("/stages/{stage_id}/links", status_code=201)
async def make_link(
    host: HostDep, new: NewLink, grant: GrantDep, tokens: TokensDep, request: Request, response: Response
) -> MadeLink:
    """Makes a link to a stage; it ends at the latest with the server or with your own access."""
    now, names = time.monotonic(), request.app.state.names
    link, token = tokens.links.make(host.id, new.role, new.seconds, grant, now)
    response.headers["Location"] = f"/api/stages/{host.id}/links/{link.id}"
    return MadeLink.model_validate(_view(link, now) | {"url": _url(names, request, host.id, token)})


def _url(names: OwnNames, request: Request, stage: str, token: str) -> str:
    base = names.public_url or f"http://{request.headers['host']}"
    return f"{base}/?stage={stage}&token={token}"


@router.get("/stages/{stage_id}/links")
async def list_links(host: HostDep, tokens: TokensDep) -> list[LinkView]:
    """Lists the links to a stage, without their tokens."""
    now = time.monotonic()
    return [
        LinkView.model_validate(_view(link, now)) for link in tokens.links.of_stage(host.id, now).values()
    ]


@router.delete("/stages/{stage_id}/links/{link_id}", status_code=204)
async def revoke_link(host: HostDep, link_id: str, tokens: TokensDep) -> None:
    """Ends a link, and disconnects its viewers."""
    now = time.monotonic()
    tokens.links.revoke(host.id, link_id, now)
    tokens.disconnect_ended(now)
