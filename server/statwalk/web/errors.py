"""Turns every error into application/problem+json (RFC 9457) that names the field and lists the
known names.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from http import HTTPStatus
from types import MappingProxyType
from typing import Any

import orjson
from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.responses import Response

from statwalk.errors import (
    BusyError,
    CancelledError,
    ConflictError,
    ContentError,
    LimitError,
    OverdueError,
    RefusedEditError,
    StageError,
    StatwalkError,
    StorageError,
    UnknownNameError,
    VersionConflictError,
)
from statwalk.web.allowed_methods import allowed_methods
from statwalk.web.field_errors import field_errors
from statwalk.web.request_log import note_limit
from statwalk.web.schemas.finding import finding_views

MOST_ERRORS = 20
"""how many errors an answer lists"""
LONGEST_FIELD, LONGEST_MESSAGE, LONGEST_DETAIL = 200, 500, 2_000
"""letters: an answer quotes names of the request, which may be long"""
MOST_KNOWN = 2_000
"""names that an answer lists"""
LARGEST_PROBLEM_BYTES = 128 << 10
MEDIA_TYPE = "application/problem+json"
NO_ADDRESS = "nothing has the address {!r}; /api/openapi.json lists the operations, and / is the page"


class Problem(HTTPException):
    """Refuses a request: the HTTP `status`, what is wrong (`detail`) in which `field`, the `known` names that
    would be right, `more` members and `headers` of the answer. `limit` names the limit that was reached.
    """

    def __init__(
        self,
        status: int,
        detail: str,
        *,
        field: str = "",
        known: Iterable[str] | None = None,
        more: Mapping[str, Any] = MappingProxyType({}),
        headers: Mapping[str, str] | None = None,
        limit: str = "",
    ) -> None:
        super().__init__(status_code=status, detail=detail, headers=headers)
        self.field, self.more, self.limit = field, more, limit
        self.known = None if known is None else list(known)

    def body(self) -> dict[str, Any]:
        """Returns the members of the problem."""
        errors = [{"field": self.field, "message": self.detail}] if self.field else []
        return members(self.status_code, self.detail, errors, self.known) | dict(self.more)


def members(
    status: int, detail: str, errors: Sequence[dict[str, str]] = (), known: Sequence[str] | None = None
) -> dict[str, Any]:
    """Returns the members of a problem: type, title, status, detail, errors and, unless None, known."""
    title = HTTPStatus(status).phrase
    body: dict[str, Any] = {
        "type": "about:blank",
        "title": title,
        "status": status,
        "detail": detail,
        "errors": list(errors),
    }
    return body if known is None else body | {"known": list(known)}


def answer(body: dict[str, Any], headers: dict[str, str] | None = None) -> Response:
    """Returns a problem as a response, even if it quotes a client's text that is not Unicode."""
    return Response(_encoded(body), body["status"], headers, MEDIA_TYPE)


def _encoded(body: dict[str, Any]) -> bytes:
    """Encodes a problem within `LARGEST_PROBLEM_BYTES`: one that quotes too much is left with its detail.

    JSON cannot hold an unpaired surrogate: a problem that quotes one gets another detail.
    """
    short = _shortened(body)
    try:
        data = orjson.dumps(short)
        return (
            data
            if len(data) <= LARGEST_PROBLEM_BYTES
            else orjson.dumps(members(short["status"], short["detail"], short["errors"]))
        )
    except orjson.JSONEncodeError:
        return orjson.dumps(members(body["status"], "the request holds text that is not Unicode"))


def _shortened(body: dict[str, Any]) -> dict[str, Any]:
    """Returns a problem with short texts, and short lists of errors and known names."""
    short = body | {
        "detail": body["detail"][:LONGEST_DETAIL],
        "errors": [
            {"field": entry["field"][:LONGEST_FIELD], "message": entry["message"][:LONGEST_MESSAGE]}
            for entry in body["errors"][:MOST_ERRORS]
        ],
    }
    return short | {"known": body["known"][:MOST_KNOWN]} if "known" in body else short


NAMED_BY_PATH = {
    "stage": "stage_id",
    "actor": "actor_id",
    "machine": "name",
    "character": "name",
    "link": "link_id",
    "version": "number",
}
"""for each kind of name, the path parameter that holds the name"""


def from_error(error: StatwalkError, path: Mapping[str, Any] = MappingProxyType({})) -> Problem:
    """Returns the problem for an error of the packages below; `path`: the parameters of the request's path.

    An unknown name in the path is a 404; in the body it is a 422.
    """
    match error:
        case UnknownNameError(kind=kind, name=name, known=known):
            in_path = kind in NAMED_BY_PATH and str(path.get(NAMED_BY_PATH[kind])) == name
            return Problem(404 if in_path else 422, str(error), field=kind, known=known)
        case RefusedEditError(field=field, findings=findings):
            more = {"findings": [view.model_dump() for view in finding_views(findings)]} if findings else {}
            return Problem(422, str(error), field=field, more=more)
        case VersionConflictError():
            return Problem(412, str(error), field="If-Match")  # the header that names the version
        case LimitError(field=field, limit=limit):
            return Problem(409, str(error), field=field, limit=limit)
        case ConflictError() | StageError():
            return Problem(409, str(error), field=getattr(error, "field", ""))
        case OverdueError():
            return Problem(503, str(error), limit="work_seconds")
        case StorageError(is_full=True):
            return Problem(507, str(error))
        case BusyError() | CancelledError() | StorageError():
            return Problem(503, str(error))
        case ContentError(place=place):
            return Problem(422, str(error.without_folder()), field=place)
    return Problem(400, str(error))


def _on_http_error(request: Request, error: Exception) -> Response:
    """Answers a `Problem`, and the router's 404 and 405."""
    if isinstance(error, Problem):
        note_limit(request.scope, error.limit)
        return answer(error.body(), dict(error.headers or {}))
    assert isinstance(error, HTTPException)
    if error.status_code in (404, 405) and (methods := allowed_methods(request)):
        return _on_other_method(request.method, ", ".join(methods))
    if error.status_code == 404:
        return answer(members(404, NO_ADDRESS.format(request.url.path[:80])))
    return answer(members(error.status_code, str(error.detail)), dict(error.headers or {}))


def _on_other_method(method: str, allowed: str) -> Response:
    """Answers a method that an address does not have, and OPTIONS."""
    if method == "OPTIONS":
        return Response(status_code=204, headers={"Allow": allowed})
    return answer(members(405, f"this address answers to {allowed}"), {"Allow": allowed})


def _on_domain_error(request: Request, error: Exception) -> Response:
    assert isinstance(error, StatwalkError)
    return _on_http_error(request, from_error(error, request.path_params))


def _on_invalid(request: Request, error: Exception) -> Response:
    """A request that does not fit its model."""
    assert isinstance(error, RequestValidationError)
    body = getattr(request.scope.get("route"), "body_field", None)
    every = field_errors(error.errors(), body.field_info.annotation if body else None)
    errors, more = every[:MOST_ERRORS], len(every) - MOST_ERRORS
    detail = "; ".join(f"{entry['field'][:LONGEST_FIELD]}: {entry['message']}" for entry in errors)
    detail = detail[: LONGEST_DETAIL - 100]  # leaves room for the number of the others
    return answer(members(422, f"{detail}; and {more} more" if more > 0 else detail, errors))


def _on_defect(_: Request, __: Exception) -> Response:
    """Answers a defect of the server: the log has the traceback, the client gets no detail."""
    return answer(members(500, "the server has a defect; its log says where"))


def install(app: FastAPI) -> None:
    """Has `app` answer every error with a problem."""
    app.add_exception_handler(HTTPException, _on_http_error)
    app.add_exception_handler(StatwalkError, _on_domain_error)
    app.add_exception_handler(RequestValidationError, _on_invalid)
    app.add_exception_handler(Exception, _on_defect)
