"""The one table of refusals: which error statuses each operation of the API can answer, and what each means.

`openapi.py` writes it into the document; tests/reliability/test_r10_api.py holds the server to it.
"""

from __future__ import annotations

from typing import Any

MEANINGS = {
    400: "the JSON cannot be read, or the body is empty or ends early",
    401: "the server asks for a token",
    403: "the request comes from another site's page, or your role does not allow it",
    404: "nothing has the name in the path",
    408: "the body takes too long to arrive",
    409: "the stage, the machine or the data folder cannot do it now",
    412: "another editor has changed the machine since the version in If-Match",
    413: "the body is too large",
    415: "the body has another content type",
    421: "the Host is another server's name",
    422: "a field is wrong, a name in the body is unknown, or a file is refused",
    428: "If-Match is missing",
    429: "too many requests: try again later",
    503: "the server is busy or stops, or its disk refuses to write: try again",
    507: "the disk of the data folder is full",
}
EVERY_OPERATION = frozenset({401, 403, 421, 429, 503})
WITHOUT_GET = frozenset({413, 415, 507})
"""the guard looks at the body of any request that can change something, even if the operation needs none; and
what changes is kept
"""
JSON_BODY = frozenset({400, 422})
PATH_PARAMETER = frozenset({404})
CHECKED_PARAMETER = frozenset({422})
"""a parameter that is no plain text: in the query, in a header, or a number in the path"""
NAME_IN_PATH = frozenset({422})
"""a machine or character whose file is read on first use, and refused"""
IF_MATCH = frozenset({409, 412, 428})
MAKES_CHARACTER = frozenset({409})
OF_OPERATION = {
    "PUT /api/characters/{name}": MAKES_CHARACTER | {400, 408},
    "DELETE /api/characters/{name}": frozenset({409}),
    "POST /api/characters/{name}/clips": MAKES_CHARACTER,
    "POST /api/characters/{name}/lod": MAKES_CHARACTER,
    "POST /api/characters/{name}/rig": MAKES_CHARACTER,
    "POST /api/machines": MAKES_CHARACTER,
    "POST /api/machines/{name}/rename": MAKES_CHARACTER,
    "PUT /api/machines/{name}/import.zip": MAKES_CHARACTER | {400, 408},
    "DELETE /api/machines/{name}": frozenset({409}),
    "GET /api/machines/{name}/unused": frozenset({409}),
    "POST /api/stages": frozenset({409}),
    "DELETE /api/stages/{stage_id}": frozenset({409}),
    "GET /api/stages/{stage_id}/links": frozenset({409}),
    "GET /api/stages/{stage_id}/differences": frozenset({409}),
    "GET /api/stages/{stage_id}/facts": frozenset({409, 507}),
    "GET /api/stages/{stage_id}/frame.glb": frozenset({409}),
    "GET /api/stages/{stage_id}/recording.glb": frozenset({409}),
    "GET /api/stages/{stage_id}/actors/{actor_id}/skeleton.svg": frozenset({409}),
    "GET /api/stages/{stage_id}/actors/{actor_id}/why": frozenset({409}),
    "GET /api/stages/{stage_id}/actors/{actor_id}/whynot": frozenset({409}),
}
"""what no parameter and no body tells"""
NOT_OF_OPERATION = {
    "PUT /api/characters/{name}": PATH_PARAMETER,
    "PUT /api/machines/{name}/import.zip": PATH_PARAMETER,
}
"""what a parameter tells wrongly: this name is made, not looked up"""
CHANGES_STAGE = frozenset({409})


def refusals(method: str, path: str, operation: dict[str, Any]) -> list[int]:
    """Returns the error statuses of one operation of an OpenAPI document, sorted."""
    statuses = set(EVERY_OPERATION | OF_OPERATION.get(f"{method} {path}", frozenset()))
    if method != "GET":
        statuses |= WITHOUT_GET
    if "application/json" in operation.get("requestBody", {}).get("content", {}):
        statuses |= JSON_BODY
    if method != "GET" and path.startswith("/api/stages/{stage_id}/"):
        statuses |= CHANGES_STAGE
    for parameter in operation.get("parameters", ()):
        statuses |= _of_parameter(parameter)
    return sorted(statuses - NOT_OF_OPERATION.get(f"{method} {path}", frozenset()))


def _of_parameter(parameter: dict[str, Any]) -> frozenset[int]:
    match parameter:
        case {"in": "header", "name": "If-Match"}:
            return IF_MATCH | CHECKED_PARAMETER
        case {"in": "path", "name": "name"}:
            return PATH_PARAMETER | NAME_IN_PATH
        case {"in": "path", "schema": {"type": "string"}}:
            return PATH_PARAMETER
        case {"in": "path"}:
            return PATH_PARAMETER | CHECKED_PARAMETER
    return CHECKED_PARAMETER
