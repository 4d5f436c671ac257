"""The bodies about levels of detail."""

from __future__ import annotations

from statwalk.web.schemas.base import FileName, RequestModel, ResponseModel


class LevelView(ResponseModel):
    """A level of detail."""

    steps: int
    """the collapses of the steps below are made; 0 is the full skin"""
    error: float
    """metres, at most, from the full skin in the poses in which it was measured"""
    vertices: int
    triangles: int


class NewDetail(RequestModel):
    """Whose level of detail is found, and how the result is called."""

    character: FileName | None = None
    """the name of the result; by default the uploaded character itself gets the order"""
