"""The body that asks for a skeleton and a skin."""

from __future__ import annotations

from statwalk.character.autorig.wish import Facing, SkeletonKind
from statwalk.skin.binding.bind_surface import Weighting
from statwalk.web.schemas.base import FileName, RequestModel


class NewRig(RequestModel):
    """How a character is rigged."""

    skeleton: SkeletonKind = "parts"
    """own: the joints that the file has; human, mammal: a template placed in the mesh; parts: made of the
    mesh alone
    """
    weights: Weighting = "heat"
    """heat: smooth; nearest: each vertex follows one bone"""
    facing: Facing = "+z"
    """where the mesh looks, for templates"""
    character: FileName | None = None
    """the name of the rigged character; by default the uploaded character itself is rigged"""
