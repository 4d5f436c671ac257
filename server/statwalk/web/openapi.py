"""Extends FastAPI's OpenAPI document with the problem answers and the schemas of the socket's messages."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from fastapi import FastAPI
from pydantic import TypeAdapter
from pydantic.json_schema import JsonSchemaMode

from statwalk.web.errors import MEDIA_TYPE
from statwalk.web.schemas.log import LogHeader, LogLine
from statwalk.web.schemas.problem import ProblemView
from statwalk.web.schemas.server_messages import ServerMessage
from statwalk.web.schemas.viewer_messages import ViewerMessage

REFUSALS: dict[int | str, dict[str, Any]] = {
    status: {"$ref": "#/components/responses/Problem"} for status in ("4XX", "5XX")
}
"""the responses that every route may give besides its own"""
PROBLEM = {
    "description": "a refusal",
    "content": {MEDIA_TYPE: {"schema": {"$ref": "#/components/schemas/ProblemView"}}},
}
SCHEMAS: dict[str, tuple[Any, JsonSchemaMode]] = {
    "ProblemView": (ProblemView, "serialization"),
    "ServerMessage": (ServerMessage, "serialization"),
    "ViewerMessage": (ViewerMessage, "validation"),
    "LogHeader": (LogHeader, "serialization"),
    "LogLine": (LogLine, "serialization"),
}
"""the schemas that no route names; a message's schema is the union of all its kinds"""


def install(app: FastAPI) -> None:
    """Extends the OpenAPI document of `app`."""
    app.openapi = _describe(app.openapi)  # type: ignore[method-assign]


def _describe(describe_routes: Callable[[], dict[str, Any]]) -> Callable[[], dict[str, Any]]:
    def describe() -> dict[str, Any]:
        document = describe_routes()
        components = document["components"]
        if "responses" not in components:
            components["responses"] = {"Problem": PROBLEM}
            components["schemas"] |= _schemas()
            _drop_titles([document["paths"], components])
        return document

    return describe


def _schemas() -> dict[str, Any]:
    schemas: dict[str, Any] = {}
    for name, (model, mode) in SCHEMAS.items():
        schema = TypeAdapter(model).json_schema(mode=mode, ref_template="#/components/schemas/{model}")
        schemas |= schema.pop("$defs", {}) | {name: schema}
    return schemas


def _drop_titles(value: Any) -> None:
    """Removes the titles, which pydantic only copies from the names of members."""
    for child in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        if isinstance(child, dict) and isinstance(child.get("title"), str):
            del child["title"]
        _drop_titles(child)
