"""A viewer of a stage, as the others see it."""

from __future__ import annotations

from statwalk.services.access.roles import AccessRole
from statwalk.web.schemas.base import ResponseModel


class ViewerView(ResponseModel):
    """A viewer: its number, and what it may do."""

    id: int
    name: str
    """as the viewer says; empty: it has not said"""
    person: str
    """whose token it has; empty without tokens, and for the viewers of a link"""
    role: AccessRole
    actor: int | None
    """that it looks at; null: it has not said"""
    tick: int | None
    """that it looks at; null: the present"""
    follows: int | None
    """the viewer whose camera it gets"""
