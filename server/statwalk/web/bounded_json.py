"""Parses JSON from clients within bounds; text that Python's parser should not accept or cannot survive gets
a 400.

Refused: bytes that are not UTF-8, NaN and Infinity, numbers that overflow, integers of more than 20 digits,
nesting deeper than 64, the same name twice in an object, more than 1,000 names in an object, more values than
the route allows, unpaired surrogates. The time to parse is linear in the length of the text.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Coroutine
from typing import Any, NoReturn

from anyio import to_thread
from fastapi import Request
from fastapi.routing import APIRoute
from starlette.responses import Response

from statwalk.services.limits import MOST_ACTORS
from statwalk.web.errors import Problem

DEEPEST = 64
LONGEST_INTEGER = 20
MOST_VALUES = 4_000
"""in one text: pydantic takes time for each"""
MOST_NAMES = 1_000
"""in one object: pydantic makes an error of each unknown name"""
VALUES_OF_AN_ACTOR = 9
"""one for the actor itself, and one for each value in it"""
LARGEST_EXACT = 2**53
"""larger doubles are not all whole numbers as they were written"""
LARGE_BYTES = 16 << 10
"""longer texts are parsed in another thread; shorter ones take at most 4 ms, and most less than a
thread costs
"""
BYTE_ORDER_MARK = "\ufeff"
STRING = re.compile(r'"(?:[^"\\]++|\\.)*+"?', re.DOTALL)
"""possessive, with an optional closing quote: the matcher never backtracks, even in an unclosed string"""
BRACKET = re.compile(r"[\[\]{}]")


def _refuse(reason: str) -> NoReturn:
    raise Problem(400, f"the JSON is refused: {reason}", field="body")


def _read_text(data: bytes | str) -> str:
    """Decodes UTF-8.

    :raises Problem: 400, when the bytes are not UTF-8.
    """
    if isinstance(data, str):
        return data
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        _refuse(f"byte {error.start} is not UTF-8")


def _check_size(text: str, most_values: int) -> None:
    """Counts the commas and brackets outside strings before Python's parser, which recurses, sees them.

    :raises Problem: 400, when the JSON has more than `most_values` values, or is nested deeper than
        `DEEPEST`.
    """
    if len(text) <= min(DEEPEST, most_values):
        return  # each value, and each level, takes a character
    marks, depth = STRING.sub("", text), 0
    if 1 + marks.count(",") + marks.count("[") + marks.count("{") > most_values:
        _refuse(f"more than {most_values:,} values")
    for bracket in BRACKET.finditer(marks):
        depth += 1 if bracket[0] in "[{" else -1
        if depth > DEEPEST:
            _refuse(f"nested deeper than {DEEPEST}")


def _integer(text: str) -> int:
    """Parses an integer; Python's time to parse one grows with the square of its length.

    :raises Problem: 400, when it has more than `LONGEST_INTEGER` digits.
    """
    if len(text.lstrip("-")) > LONGEST_INTEGER:
        _refuse(f"an integer of more than {LONGEST_INTEGER} digits")
    return int(text)


def finite(text: str) -> float:
    """Parses a number; a whole one is an integer however it is written, as JSON Schema says: 30.0 and 3e1.

    :raises Problem: 400, when a double cannot hold it.
    """
    value = float(text)
    if not math.isfinite(value):
        _refuse(f"the number {text[:20]} is too large")
    return int(value) if abs(value) <= LARGEST_EXACT and value.is_integer() else value


def _no_constant(text: str) -> NoReturn:
    """Refuses NaN, Infinity and -Infinity."""
    _refuse(f"{text} is no JSON number")


def members(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Returns an object from its members.

    :raises Problem: 400, when two members have the same name, or there are more than `MOST_NAMES`.
    """
    if len(pairs) > MOST_NAMES:
        _refuse(f"more than {MOST_NAMES:,} names in an object")
    values: dict[str, Any] = {}
    for name, value in pairs:
        if name in values:
            _refuse(f"the name {name[:80]!r} stands twice in an object")
        values[name] = value
    return values


DECODER = json.JSONDecoder(
    parse_int=_integer, parse_float=finite, parse_constant=_no_constant, object_pairs_hook=members
)


def parse(data: bytes | str, most_values: int = MOST_VALUES) -> Any:
    """Parses JSON of at most `most_values` values, nested values included.

    :raises Problem: 400, when the JSON is refused.
    """
    text = _read_text(data)
    if text.startswith(BYTE_ORDER_MARK):
        _refuse("it begins with a byte order mark; leave that out")
    _check_size(text, most_values)
    try:
        value = DECODER.decode(text)
        if r"\u" in text:  # UTF-8 itself has no surrogates
            json.dumps(value, ensure_ascii=False).encode("utf-8")
    except json.JSONDecodeError as error:
        _refuse(f"{error.msg} at line {error.lineno}, column {error.colno}")
    except UnicodeEncodeError:
        _refuse("an unpaired surrogate is no Unicode text")
    return value


async def parse_aside(data: bytes | str, most_values: int = MOST_VALUES) -> Any:
    """Parses JSON without blocking the event loop: a large text is parsed in another thread.

    :raises Problem: 400, when the JSON is refused.
    """
    if len(data) <= LARGE_BYTES:
        return parse(data, most_values)
    return await to_thread.run_sync(parse, data, most_values)


class BoundedRequest(Request):
    """A request whose JSON body is parsed by `parse`."""

    most_values = MOST_VALUES

    async def json(self) -> Any:
        """Parses the body.

        :raises Problem: 400, when the JSON is refused.
        """
        return await parse_aside(await self.body(), self.most_values)


class RoomyRequest(BoundedRequest):
    """A request whose JSON body may have as many values as a full stage needs."""

    most_values = VALUES_OF_AN_ACTOR * MOST_ACTORS + MOST_VALUES


class BoundedRoute(APIRoute):
    """A route that reads its body through `BoundedRequest`."""

    request_kind: type[BoundedRequest] = BoundedRequest

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Returns FastAPI's handler, called with a request of `request_kind`."""
        handle = super().get_route_handler()

        async def bounded(request: Request) -> Response:
            return await handle(self.request_kind(request.scope, request.receive))

        return bounded


class RoomyRoute(BoundedRoute):
    """A route that reads its body through `RoomyRequest`."""

    request_kind = RoomyRequest
