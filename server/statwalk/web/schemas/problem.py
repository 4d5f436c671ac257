"""The body of every error: a problem of RFC 9457."""

from __future__ import annotations

from typing import Any

from pydantic import ConfigDict, Field
from pydantic.json_schema import SkipJsonSchema

from statwalk.web.schemas.base import ResponseModel
from statwalk.web.schemas.finding import FindingView


def _is_none(value: Any) -> bool:
    return value is None


class FieldError(ResponseModel):
    """A wrong member of the request, or a wrong place in a file, and what is wrong with it."""

    field: str
    message: str


class ProblemView(ResponseModel):
    """An error: the wrong fields, the `known` names if a name is unknown, and the verifier's `findings` if an
    edit is refused.
    """

    model_config = ConfigDict(json_schema_serialization_defaults_required=False)

    type: str
    title: str
    status: int
    detail: str
    errors: list[FieldError]
    known: list[str] | SkipJsonSchema[None] = Field(default=None, exclude_if=_is_none)
    findings: list[FindingView] | SkipJsonSchema[None] = Field(default=None, exclude_if=_is_none)
