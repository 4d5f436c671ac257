"""Each refusal of a request says what would be right."""

from typing import Annotated, Any, Literal

import pytest
from pydantic import BeforeValidator, Field, ValidationError
from statwalk.web.field_errors import field_errors
from statwalk.web.schemas.base import RequestModel


def _even(number: object) -> object:
    if number == 3:
        raise ValueError("write an even number")
    return number


class Body(RequestModel):
    speed: Annotated[float, Field(ge=0, lt=8)] = 1.0
    ticks: int = 1
    clock: Literal["real", "manual"] = "real"
    name: Annotated[str, Field(min_length=2, max_length=4)] = "main"
    place: Annotated[str, Field(pattern="^[a-z]$")] = "a"
    even: Annotated[int, BeforeValidator(_even)] = 2
    seed: int


def said(model: type[RequestModel], body: object) -> str:
    """The field and the message of the one error."""
    with pytest.raises(ValidationError) as refused:
        model.model_validate(body)
    entries = [{**entry, "loc": ("body", *entry["loc"])} for entry in refused.value.errors()]
    (error,) = field_errors(entries, model)
    return f"{error['field']}: {error['message']}"


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ({}, "seed: is missing"),
        ({"sped": 1}, "sped: there is no such member; did you mean speed?"),
        (
            {"xyz": 1},
            "xyz: there is no such member; there are: speed, ticks, clock, name, place, even, seed",
        ),
        ({"speed": "1"}, "speed: must be a number"),
        ({"speed": -1}, "speed: must be at least 0"),
        ({"speed": 8}, "speed: must be less than 8"),
        ({"speed": float("inf")}, "speed: must be a finite number"),
        ({"ticks": 1.5}, "ticks: must be a whole number"),
        ({"ticks": None}, "ticks: must be a whole number"),
        ({"clock": "fast"}, "clock: must be 'real' or 'manual'"),
        ({"name": 5}, "name: must be a text"),
        ({"name": "x"}, "name: must have at least 2 letters"),
        ({"place": "A"}, "place: must match the pattern ^[a-z]$"),
        ({"name": "xxxxx"}, "name: may have at most 4 letters"),
        ({"even": 3}, "even: write an even number"),
    ],
)
def test_what_would_be_right(body: dict[str, Any], message: str) -> None:
    assert said(Body, {"seed": 1} | body if body else body) == message


class Lists(RequestModel):
    rows: Annotated[tuple[int, ...], Field(min_length=1, max_length=2)] = (1,)
    flag: bool = False
    text: Annotated[str, Field(min_length=1)] = "x"


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ({"rows": {}}, "rows: must be a list"),
        ({"rows": ()}, "rows: must not be empty"),
        ({"rows": (1, 2, 3)}, "rows: may have at most 2 entries"),
        ({"flag": 1}, "flag: must be true or false"),
        ({"text": ""}, "text: must not be empty"),
        ([], "body: must be an object"),
    ],
)
def test_lists_and_flags(body: object, message: str) -> None:
    assert said(Lists, body) == message
