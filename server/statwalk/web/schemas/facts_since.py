"""The body about what happened on a stage."""

from __future__ import annotations

from statwalk.web.schemas.base import ResponseModel
from statwalk.web.schemas.server_messages import ActionMessage, VerdictMessage


class FactsView(ResponseModel):
    """All actions and verdicts after the tick that was asked for, up to `tick`; oldest first."""

    tick: int
    actions: tuple[ActionMessage, ...]
    verdicts: tuple[VerdictMessage, ...]
