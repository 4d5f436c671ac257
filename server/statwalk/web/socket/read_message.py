"""Reads the messages of a viewer from JSON values."""

from __future__ import annotations

from pydantic import TypeAdapter, ValidationError

from statwalk.web.errors import Problem
from statwalk.web.field_errors import field_errors
from statwalk.web.schemas.base import Ref
from statwalk.web.schemas.viewer_messages import ViewerMessage

MESSAGES: TypeAdapter[ViewerMessage] = TypeAdapter(ViewerMessage)
REFS: TypeAdapter[Ref] = TypeAdapter(Ref)


def ref_of(raw: object) -> Ref:
    """Returns the `ref` of a message, or None if it has none that the answer can repeat."""
    if not isinstance(raw, dict) or "ref" not in raw:
        return None
    try:
        return REFS.validate_python(raw["ref"], strict=True)
    except ValidationError:
        return None


def read(raw: object) -> ViewerMessage:
    """Returns the message that a JSON value describes.

    :raises Problem: 422, naming the field, when the value is no message.
    """
    try:
        return MESSAGES.validate_python(raw)
    except ValidationError as error:
        entries = error.errors(include_url=False, include_input=False)
        places = [{**entry, "loc": ("message", *entry["loc"])} for entry in entries]
        first = field_errors(places, ViewerMessage)[0]
        raise Problem(422, f"{first['field']}: {first['message']}", field=first["field"]) from None
