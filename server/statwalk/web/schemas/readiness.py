"""The bodies about the server itself."""

from __future__ import annotations

from typing import Literal

from statwalk.web.schemas.base import ResponseModel


class HealthView(ResponseModel):
    """The process answers; `version` is the server's."""

    status: Literal["ok"] = "ok"
    version: str


class LostStageView(ResponseModel):
    """A stage that the last start of the server did not bring back, and why; its record is kept."""

    id: str
    why: str


class LossesView(ResponseModel):
    """What the last start of the server did not bring back: stages, and other things, in words."""

    stages: list[LostStageView]
    other: list[str]


class ReadyView(ResponseModel):
    """The server takes requests, and its stages move."""

    status: Literal["ready"] = "ready"
