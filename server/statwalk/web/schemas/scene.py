"""The bodies about scenes."""

from __future__ import annotations

from statwalk.web.schemas.base import ResponseModel


class SceneView(ResponseModel):
    """A scene: a stage to open with its actors; `actors` is their number."""

    name: str
    title: str
    description: str
    actors: int
