"""Names the fields of a request that does not fit its model. Where a field may have one of several types,
pydantic reports one error for each type, with the type in the place; here the field has one error.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from statwalk.web.field_members import members_at
from statwalk.web.field_words import field_words

Place = tuple[str | int, ...]
TYPE = re.compile(r"constrained-\w+|(?:list|tuple|dict|set|frozenset|function-\w+)\[.*\]")
"""parts of a place that are types of pydantic, and no names"""
PLAIN = frozenset({"bool", "int", "float", "str"})
"""types that a field might also be called: they are types beside one of TYPE"""


def field_errors(entries: Sequence[Mapping[str, Any]], kind: Any = None) -> list[dict[str, str]]:
    """Returns `field` and `message` of each field that pydantic's errors name, in their order. The first part
    of a place says where the value of the type `kind` came from: `body`, `query` …
    """
    types = _beside_types([entry["loc"] for entry in entries])
    messages: dict[str, list[str]] = {}
    for entry in entries:
        said = messages.setdefault(field_name(_without_types(entry["loc"], types)), [])
        words = field_words(entry, members_at(kind, entry["loc"][1:-1]))
        if words not in said:
            said.append(words)
    return [{"field": field, "message": "; or: ".join(said)} for field, said in messages.items()]


def field_name(place: Sequence[str | int]) -> str:
    """Returns pydantic's place as a dotted name: `body.actors.0.machine` is actors.0.machine; the
    body is body.
    """
    return ".".join(str(part) for part in place[1:]) or str(place[0])


def _beside_types(places: Iterable[Place]) -> set[Place]:
    """The places of fields that may have one of several types."""
    return {
        place[:index] for place in places for index, part in enumerate(place) if TYPE.fullmatch(str(part))
    }


def _without_types(place: Place, types: set[Place]) -> Place:
    return tuple(
        part
        for index, part in enumerate(place)
        if place[:index] not in types or not (TYPE.fullmatch(str(part)) or part in PLAIN)
    )
