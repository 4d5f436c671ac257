"""The members that a request may have, by the place in it: for the refusal of one that it may not have."""

from __future__ import annotations

from collections.abc import Sequence
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel


def members_at(kind: Any, place: Sequence[str | int]) -> list[str]:
    """Returns the names of the members at a place of a value of the type `kind`; none where it is no model.
    A place is one of pydantic's, with the kinds of operations and messages that it goes through.
    """
    kinds = _each(kind)
    for part in place:
        kinds = [within for found in kinds for within in _within(found, part)]
    return [
        field.alias or name
        for model in kinds
        if _is_model(model)
        for name, field in model.model_fields.items()
    ]


def _each(kind: Any) -> list[Any]:
    """The types of which a value has one."""
    if get_origin(kind) is Annotated:
        return _each(get_args(kind)[0])
    if get_origin(kind) in (Union, UnionType):
        return [one for part in get_args(kind) for one in _each(part)]
    return [kind]


def _is_model(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, BaseModel)


def _within(kind: Any, part: str | int) -> list[Any]:
    """The types of what a part of a place leads to."""
    if _is_model(kind):
        for name, field in kind.model_fields.items():
            if part in (name, field.alias):
                return _each(field.annotation)
            if get_origin(field.annotation) is Literal and part in get_args(field.annotation):
                return [kind]  # pydantic names the kind of an operation as a part of the place
        return []
    return _each(get_args(kind)[-1]) if get_args(kind) else []
