"""A field that may have one of several types has one error, without pydantic's names of types."""

from typing import Annotated, Any

import pytest
from pydantic import BaseModel, Field, ValidationError
from statwalk.web.field_errors import field_errors

Number = Annotated[float, Field(le=1e9)]


class Body(BaseModel):
    value: Number | Annotated[list[Number], Field(min_length=3, max_length=3)] | bool = 0.0
    rows: str | list[Annotated[str, Field(max_length=5)]] = ""
    counts: dict[str, int] = {}


def said(**body: Any) -> list[dict[str, str]]:
    with pytest.raises(ValidationError) as refused:
        Body(**body)
    return field_errors([{**entry, "loc": ("body", *entry["loc"])} for entry in refused.value.errors()])


def test_several_types_are_one_error() -> None:
    (error,) = said(value=[1, 2])
    assert error["field"] == "value"
    assert "must be a number; or: must have at least 3 entries" in error["message"]


def test_an_item_of_a_list_is_named() -> None:
    assert [error["field"] for error in said(rows=["long enough"])] == ["rows", "rows.0"]


def test_a_field_may_be_called_like_a_type() -> None:
    assert [error["field"] for error in said(counts={"float": "x"})] == ["counts.float"]
