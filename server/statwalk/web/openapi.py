"""Extends FastAPI's OpenAPI document with the problem answers and the schemas of the socket's messages."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from fastapi import FastAPI
from pydantic import TypeAdapter
from pydantic.json_schema import JsonSchemaMode

from statwalk.web.errors import MEDIA_TYPE
from statwalk.web.refusals import MEANINGS, refusals
from statwalk.web.schemas.log import LogHeader, LogLine
from statwalk.web.schemas.problem import ProblemView
from statwalk.web.schemas.server_messages import ServerMessage
from statwalk.web.schemas.viewer_messages import ViewerMessage

REFUSALS: dict[int | str, dict[str, Any]] = {"4XX": {"description": "a refusal"}}
"""stands for the refusals of a route until `_list_refusals` names them; FastAPI would describe its own 422"""
PROBLEM = {MEDIA_TYPE: {"schema": {"$ref": "#/components/schemas/ProblemView"}}}
RESPONSES = {
    str(status): {"description": meaning, "content": PROBLEM} for status, meaning in MEANINGS.items()
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
            components["responses"] = RESPONSES
            components["schemas"] |= _schemas()
            _list_refusals(document["paths"])
            _drop_titles([document["paths"], components])
        return document

    return describe


def _list_refusals(paths: dict[str, Any]) -> None:
    """Gives each operation the statuses of its refusals in place of those that stand for them; a header that
    has a refusal of its own (428) is required.
    """
    for path, operations in paths.items():
        for method, operation in operations.items():
            kept = {status: kind for status, kind in operation["responses"].items() if status != "4XX"}
            listed = refusals(method.upper(), path, operation)
            named = {str(status): {"$ref": f"#/components/responses/{status}"} for status in listed}
            operation["responses"] = dict(sorted((kept | named).items()))
            for parameter in operation.get("parameters", ()):
                parameter["required"] |= parameter["name"] == "If-Match"


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
