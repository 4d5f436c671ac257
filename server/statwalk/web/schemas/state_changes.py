"""The bodies about past states of actors."""

from __future__ import annotations

from statwalk.web.schemas.base import ResponseModel


class StateChangeView(ResponseModel):
    """A layer of an actor enters `state` at `tick`."""

    tick: int
    actor: int
    layer: int
    state: str


class HistoryView(ResponseModel):
    """The changes of state up to `head`, oldest first."""

    head: int
    changes: tuple[StateChangeView, ...]
