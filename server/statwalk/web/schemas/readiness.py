"""The bodies about the server itself."""

from __future__ import annotations

from typing import Literal

from statwalk.web.schemas.base import ResponseModel


class HealthView(ResponseModel):
    """The process answers; `version` is the server's."""

    status: Literal["ok"] = "ok"
    version: str


class ReadyView(ResponseModel):
    """The server takes requests, and its stages move."""

    status: Literal["ready"] = "ready"
