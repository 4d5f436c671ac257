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
    RefusedEditError,
    StageError,
    StatwalkError,
    UnknownNameError,
    VersionConflictError,
)
from statwalk.web.schemas.finding import finding_views

MOST_ERRORS = 20
"""how many errors an answer lists"""
LONGEST_FIELD = 200
MEDIA_TYPE = "application/problem+json"


class Problem(HTTPException):
    """Refuses a request: the HTTP `status`, what is wrong (`detail`) in which `field`, the `known` names that
    would be right, and `more` members of the answer.
    """

    def __init__(
        self,
        status: int,
        detail: str,
        *,
        field: str = "",
        known: Iterable[str] | None = None,
        more: Mapping[str, Any] = MappingProxyType({}),
    ) -> None:
        super().__init__(status_code=status, detail=detail)
        self.field, self.more = field, more
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
    """Encodes a problem. JSON cannot hold an unpaired surrogate: a problem that quotes one gets
    another detail.
    """
    try:
        return orjson.dumps(body)
    except orjson.JSONEncodeError:
        return orjson.dumps(members(body["status"], "the request holds text that is not Unicode"))


NAMED_BY_PATH = {"stage": "stage_id", "actor": "actor_id", "machine": "name", "character": "name"}
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
        case ConflictError(field=field):
            return Problem(409, str(error), field=field)
        case StageError():
            return Problem(409, str(error))
        case BusyError() | CancelledError():
            return Problem(503, str(error))
        case ContentError(place=place):
            return Problem(422, str(error), field=place)
    return Problem(400, str(error))


def _field_errors(error: RequestValidationError) -> list[dict[str, str]]:
    entries = error.errors()[:MOST_ERRORS]
    return [{"field": field_name(entry["loc"])[:LONGEST_FIELD], "message": entry["msg"]} for entry in entries]


def field_name(place: Sequence[str | int]) -> str:
    """Returns pydantic's place as a dotted name: `body.actors.0.machine` is actors.0.machine; the
    body is body.
    """
    return ".".join(str(part) for part in place[1:]) or str(place[0])


def _on_http_error(_: Request, error: Exception) -> Response:
    """Answers a `Problem`, and the router's 404 and 405."""
    if isinstance(error, Problem):
        return answer(error.body(), dict(error.headers or {}))
    assert isinstance(error, HTTPException)
    return answer(members(error.status_code, str(error.detail)), dict(error.headers or {}))


def _on_domain_error(request: Request, error: Exception) -> Response:
    assert isinstance(error, StatwalkError)
    return answer(from_error(error, request.path_params).body())


def _on_invalid(_: Request, error: Exception) -> Response:
    """A request that does not fit its model."""
    assert isinstance(error, RequestValidationError)
    errors, more = _field_errors(error), len(error.errors()) - MOST_ERRORS
    detail = "; ".join(f"{entry['field']}: {entry['message']}" for entry in errors)[:2_000]
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
