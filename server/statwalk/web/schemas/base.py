"""The base classes of all bodies and messages, and the types that their members share.

Strict: no number for a text, no text for a number, no unknown member, no NaN.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, Strict, StringConstraints

from statwalk.services.library.model_store import NAME as FILE_NAME

LATEST_TICK = 2**31 - 1
Name = Annotated[str, StringConstraints(min_length=1, max_length=80)]
FILE_NAME_PATTERN = f"^{FILE_NAME.pattern}$"
FileName = Annotated[Name, Field(json_schema_extra={"pattern": FILE_NAME_PATTERN})]
"""a name that becomes a file's; the routes refuse another one in words of their own"""
LINE = r"^[^\u0000-\u001f\u007f-\u009f\u2028\u2029\u202a-\u202e\u2066-\u2069]*$"
"""one line of text, without control characters, and without those that turn the direction of writing"""
LONGEST_STAGE_NAME = 80
LONGEST_VIEWER_NAME = 40
StageName = Annotated[str, StringConstraints(max_length=LONGEST_STAGE_NAME, pattern=LINE)]
"""what people call a stage; empty: nothing"""
ViewerName = Annotated[str, StringConstraints(max_length=LONGEST_VIEWER_NAME, pattern=LINE)]
"""what a viewer calls itself; empty: nothing"""
Coordinate = Annotated[float, Field(ge=-1e6, le=1e6)]
Tick = Annotated[int, Field(ge=0, le=LATEST_TICK)]
ActorId = Annotated[int, Field(ge=0, le=LATEST_TICK)]
Ref = Annotated[str, StringConstraints(max_length=200)] | Annotated[int, Field(ge=-(2**53), le=2**53)] | None
"""a client's name for its message, which the answer repeats; integers up to JavaScript's largest safe one"""
IdempotencyKey = Annotated[str, StringConstraints(max_length=80)]
"""a client's name for a request, by which the server knows a repetition; empty: none"""
VerdictWord = Literal["taken", "waits", "dropped"]
Place = Annotated[tuple[str, str], Strict(False)]
"""the row and the column of a cell, as the machine file writes them"""
Vector = tuple[float, float, float]
Values = Annotated[dict[str, float], BeforeValidator(dict)]
"""numbers by name; pydantic also accepts pairs"""


def _flag(text: object) -> object:
    """Takes no other words for a flag of the query than JSON's."""
    if text not in ("true", "false", True, False):
        raise ValueError("write true or false")
    return text


Flag = Annotated[bool, BeforeValidator(_flag)]
"""in the query, where pydantic would also take yes, on and 1"""


class RequestModel(BaseModel):
    """The base of the bodies and messages that clients send."""

    model_config = ConfigDict(
        strict=True, extra="forbid", allow_inf_nan=False, frozen=True, use_attribute_docstrings=True
    )


class ResponseModel(BaseModel):
    """The base of the bodies and messages that the server sends.

    Build one from keyword arguments, or validate an object with the same attributes.
    """

    model_config = ConfigDict(
        strict=True,
        extra="forbid",
        frozen=True,
        from_attributes=True,
        validate_by_name=True,
        serialize_by_alias=True,
        use_attribute_docstrings=True,
        json_schema_serialization_defaults_required=True,
    )
