"""The bodies about access: what you may do, and links that share a stage."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from statwalk.services.access.roles import AccessRole
from statwalk.web.schemas.base import RequestModel, ResponseModel

LONGEST_SECONDS = 30 * 86_400
DAY_SECONDS = 86_400


class AccessView(ResponseModel):
    """What you may do; `stage` is the only stage that your link shows, null: all stages."""

    token_needed: bool
    """whether the server asks for tokens"""
    name: str
    role: AccessRole
    stage: str | None


class NewLink(RequestModel):
    """A link to a stage; it ends after `seconds`, when you delete it, or when the server stops."""

    role: Literal["view", "drive"] = "view"
    seconds: Annotated[int, Field(ge=1, le=LONGEST_SECONDS)] = DAY_SECONDS


class LinkView(ResponseModel):
    """A link to a stage, without its token."""

    id: str
    role: AccessRole
    maker: str
    seconds_left: float


class MadeLink(LinkView):
    """A new link; `url` is shown once, who has it has the role."""

    url: str
