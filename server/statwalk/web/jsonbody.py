"""JSON from strangers, bounded: what the standard reader lets through and what breaks it is refused with a 400.

Refused: bytes that are not UTF-8, NaN and Infinity, numbers that overflow, integers of more than 20 digits, nesting deeper
than 64, the same name twice in an object, unpaired surrogates.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Coroutine
from typing import Any, NoReturn

from fastapi import Request
from fastapi.routing import APIRoute
from starlette.responses import Response

from statwalk.web.problem import Problem

DEEPEST = 64
LONGEST_INTEGER = 20
STRING = re.compile(r'"(?:[^"\\]|\\.)*"', re.DOTALL)
BRACKET = re.compile(r"[\[\]{}]")


def refuse(why: str) -> NoReturn:
    """Ends the reading with a 400."""
    raise Problem(400, f"the JSON is refused: {why}", field="body")


def read_text(data: bytes | str) -> str:
    """UTF-8 bytes as text."""
    if isinstance(data, str):
        return data
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        refuse(f"byte {error.start} is not UTF-8")


def check_depth(text: str) -> None:
    """Counts brackets outside strings before the recursive reader sees them."""
    depth = 0
    for bracket in BRACKET.finditer(STRING.sub("", text)):
        depth += 1 if bracket[0] in "[{" else -1
        if depth > DEEPEST:
            refuse(f"nested deeper than {DEEPEST}")


def integer(text: str) -> int:
    """An integer of a sensible length."""
    if len(text.lstrip("-")) > LONGEST_INTEGER:
        refuse(f"an integer of more than {LONGEST_INTEGER} digits")
    return int(text)


def finite(text: str) -> float:
    """A number that a double can hold."""
    value = float(text)
    if not math.isfinite(value):
        refuse(f"the number {text[:20]} is too large")
    return value


def no_constant(text: str) -> NoReturn:
    """NaN and the infinities are no JSON."""
    refuse(f"{text} is no JSON number")


def members(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object whose names are all different."""
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        refuse(f"the name {next(name for name in names if names.count(name) > 1)!r} stands twice in an object")
    return found


def parse(data: bytes | str) -> Any:
    """The value that the JSON says.

    :raises Problem: 400, if it is refused.
    """
    text = read_text(data)
    check_depth(text)
    try:
        value = json.loads(text, parse_int=integer, parse_float=finite, parse_constant=no_constant, object_pairs_hook=members)
        json.dumps(value, ensure_ascii=False).encode("utf-8")
    except json.JSONDecodeError as error:
        refuse(f"{error.msg} at line {error.lineno}, column {error.colno}")
    except UnicodeEncodeError:
        refuse("an unpaired surrogate is no Unicode text")
    return value


class BoundedRequest(Request):
    """A request whose JSON is read by `parse`."""

    async def json(self) -> Any:
        """The body, bounded."""
        return parse(await self.body())


class BoundedRoute(APIRoute):
    """A route whose endpoint reads its body through `BoundedRequest`."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """FastAPI's handler, given the bounded request."""
        handle = super().get_route_handler()

        async def bounded(request: Request) -> Response:
            return await handle(BoundedRequest(request.scope, request.receive))

        return bounded
