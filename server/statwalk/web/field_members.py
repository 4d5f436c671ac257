"""The members that a request may have, by the place in it: for the refusal of one that it may not have."""

from __future__ import annotations

from collections.abc import Sequence
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel


def members_at(kind: Any, place: Sequence[str | int]) -> list[str]:
    """Returns the names of the members that the type `kind` has at a place; an empty list if the place holds
    no model. The place is pydantic's: it names the kind of each operation or message that it goes through.
    """
    kinds = _each(kind)
    for part in place:
        # of several kinds pydantic names one as a part of the place, before its members
        named = [found for found in kinds if len(kinds) > 1 and _is_named(found, part)]
        kinds = named or [within for found in kinds for within in _within(found, part)]
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


def _is_named(kind: Any, part: str | int) -> bool:
    """Whether a member says that this is the kind, as `kind` of an operation and `type` of a message do."""
    fields = kind.model_fields.values() if _is_model(kind) else ()
    literals = [field.annotation for field in fields if get_origin(field.annotation) is Literal]
    return any(part in get_args(literal) for literal in literals)


def _within(kind: Any, part: str | int) -> list[Any]:
    """The types of what a part of a place leads to."""
    if _is_model(kind):
        for name, field in kind.model_fields.items():
            if part in (name, field.alias):
                return _each(field.annotation)
        return []
    return _each(get_args(kind)[-1]) if get_args(kind) else []
