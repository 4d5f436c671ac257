"""What the routes are given: the catalogue and the registry of the app that they belong to."""

from __future__ import annotations

from fastapi import Request

from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.keeping.registry import Registry


def registry_of(request: Request) -> Registry:
    """The app's stages."""
    registry: Registry = request.app.state.registry
    return registry


def catalogue_of(request: Request) -> Catalogue:
    """The app's machines and characters."""
    return registry_of(request).catalogue


def stage_of(stage_id: str, request: Request) -> HostedStage:
    """The stage that the path names.

    :raises Problem: 404, if there is none.
    """
    return registry_of(request).find(stage_id)
