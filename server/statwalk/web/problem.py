"""Every error answer: application/problem+json (RFC 9457) that names the field and lists what exists."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from http import HTTPStatus
from typing import Any

import orjson
from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.responses import Response

from statwalk.errors import ContentError, StageError, StatwalkError, UnknownNameError

MEDIA_TYPE = "application/problem+json"


class Problem(HTTPException):
    """A request that is refused: `status`, what is wrong, in which `field`, and the names that would be `known`."""

    def __init__(self, status: int, detail: str, *, field: str = "", known: Iterable[str] | None = None) -> None:
        super().__init__(status_code=status, detail=detail)
        self.field = field
        self.known = None if known is None else list(known)

    def body(self) -> dict[str, Any]:
        """The problem as JSON members."""
        errors = [{"field": self.field, "message": self.detail}] if self.field else []
        return members(self.status_code, self.detail, errors, self.known)


def members(status: int, detail: str, errors: Sequence[dict[str, str]] = (), known: Sequence[str] | None = None) -> dict[str, Any]:
    """The members of a problem: type, title, status, detail, errors and, where names exist, known."""
    title = HTTPStatus(status).phrase
    body: dict[str, Any] = {"type": "about:blank", "title": title, "status": status, "detail": detail, "errors": list(errors)}
    return body if known is None else body | {"known": list(known)}


def answer(body: dict[str, Any], headers: dict[str, str] | None = None) -> Response:
    """The problem as a response; it cannot fail on what a client sent (unpaired surrogates are replaced)."""
    return Response(encoded(body), body["status"], headers, MEDIA_TYPE)


def encoded(body: dict[str, Any]) -> bytes:
    """JSON of a problem, whatever text of the client's it repeats."""
    try:
        return orjson.dumps(body)
    except orjson.JSONEncodeError:
        return orjson.dumps(members(body["status"], "the request holds text that is not Unicode"))


def from_error(error: StatwalkError) -> Problem:
    """The problem that a core error is to the one who sent the request."""
    if isinstance(error, UnknownNameError):
        return Problem(422, str(error), field=error.kind, known=error.known)
    if isinstance(error, StageError):
        return Problem(409, str(error))
    if isinstance(error, ContentError):
        return Problem(422, str(error), field=error.place)
    return Problem(400, str(error))


def field_errors(error: RequestValidationError) -> list[dict[str, str]]:
    """pydantic's findings as (field, message); the field is a dotted path without the leading body/query/path."""
    return [{"field": field_name(found["loc"]), "message": found["msg"]} for found in error.errors()]


def field_name(place: Sequence[str | int]) -> str:
    """`body.actors.0.machine` is called actors.0.machine; the body itself, body."""
    return ".".join(str(part) for part in place[1:]) or str(place[0])


def on_http_error(_: Request, error: Exception) -> Response:
    """Problems of ours, and the router's 404 and 405."""
    if isinstance(error, Problem):
        return answer(error.body(), dict(error.headers or {}))
    assert isinstance(error, HTTPException)
    return answer(members(error.status_code, str(error.detail)), dict(error.headers or {}))


def on_core_error(_: Request, error: Exception) -> Response:
    """An error of the floors below: the client asked for something that is not there."""
    assert isinstance(error, StatwalkError)
    return answer(from_error(error).body())


def on_invalid(_: Request, error: Exception) -> Response:
    """A request that does not fit its model."""
    assert isinstance(error, RequestValidationError)
    errors = field_errors(error)
    return answer(members(422, "; ".join(f"{found['field']}: {found['message']}" for found in errors)[:2_000], errors))


def on_defect(_: Request, __: Exception) -> Response:
    """The last resort: a defect of ours; the server logs it, the client learns no inner detail."""
    return answer(members(500, "the server has a defect; its log says where"))


def install(app: FastAPI) -> None:
    """Makes every error of `app` a problem."""
    app.add_exception_handler(HTTPException, on_http_error)
    app.add_exception_handler(StatwalkError, on_core_error)
    app.add_exception_handler(RequestValidationError, on_invalid)
    app.add_exception_handler(Exception, on_defect)
