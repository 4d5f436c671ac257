"""The answers about machines, which may have megabytes."""

from typing import get_type_hints

from fastapi import Response
from fastapi.routing import APIRoute
from statwalk.web.routes import edits, machines, versions


def test_a_machine_is_encoded_by_the_thread_of_its_route() -> None:
    """What a route returns as a model, FastAPI encodes in the event loop, and no frame is sent meanwhile."""
    names = {
        route.name
        for route in (*edits.router.routes, *versions.router.routes, *machines.router.routes)
        if isinstance(route, APIRoute) and route.response_model is not None
        if get_type_hints(route.endpoint)["return"] is Response
    }
    assert names == {
        "put_machine",
        "patch_cell",
        "patch_expressions",
        "patch_machine",
        "undo",
        "redo",
        "restore",
        "get_machine",
    }
