"""Says what is wrong with a field of a request, and what would be right, in place of pydantic's sentences."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

from statwalk.errors import abridged, nearest

WORDS: Mapping[str, str] = MappingProxyType(
    {
        "missing": "is missing",
        "none_required": "must be null",
        "bool_type": "must be true or false",
        "float_type": "must be a number",
        "float_parsing": "must be a number",
        "int_type": "must be a whole number",
        "int_parsing": "must be a whole number",
        "int_from_float": "must be a whole number",
        "string_type": "must be a text",
        "list_type": "must be a list",
        "tuple_type": "must be a list",
        "dict_type": "must be an object",
        "model_type": "must be an object",
        "model_attributes_type": "must be an object",
        "finite_number": "must be a finite number",
        "greater_than": "must be more than {gt:,}",
        "greater_than_equal": "must be at least {ge:,}",
        "less_than": "must be less than {lt:,}",
        "less_than_equal": "must be at most {le:,}",
        "literal_error": "must be {expected}",
        "string_too_short": "must have at least {min_length:,} letters",
        "string_too_long": "may have at most {max_length:,} letters",
        "string_pattern_mismatch": "must match the pattern {pattern}",
        "too_short": "must have at least {min_length:,} entries",
        "too_long": "may have at most {max_length:,} entries",
        "value_error": "{error}",
    }
)
"""by pydantic's type of an error"""


def field_words(entry: Mapping[str, Any], known: Sequence[str] = ()) -> str:
    """Returns the sentence for an error of pydantic; `known`: the members that may stand there."""
    context = entry.get("ctx", {})
    match entry["type"]:
        case "extra_forbidden":
            return f"there is no such member{_instead(str(entry['loc'][-1]), known)}"
        case "union_tag_not_found":
            return f"must have the member {_unquoted(context['discriminator'])}"
        case "union_tag_invalid":
            tags = _unquoted(context["expected_tags"]).split(", ")
            what = f"{context['tag'][:40]!r} is no {_unquoted(context['discriminator'])}"
            return what + _instead(context["tag"], tags)
    if context.get("min_length") == 1 and entry["type"].endswith("too_short"):
        return "must not be empty"
    words = WORDS.get(entry["type"])
    return str(entry["msg"]) if words is None else words.format_map(_whole(context))


def _whole(context: Mapping[str, Any]) -> dict[str, Any]:
    """Writes 8.0 as 8, as a client does."""
    return {
        name: int(value) if isinstance(value, float) and value.is_integer() else value
        for name, value in context.items()
    }


def _unquoted(names: str) -> str:
    return names.replace("'", "")


def _instead(name: str, known: Sequence[str]) -> str:
    """Says what a name could have been: the one most like it, else all."""
    return nearest(name, known) or (f"; there are: {abridged(tuple(known))}" if known else "")
