"""One field of a glTF object, checked: the value, or a ModelError that says where (a JSON pointer) and what would be right.

Everything here is Python ints and comparisons; nothing is allocated by what a file claims.
"""

from __future__ import annotations

from typing import Any

from statwalk.errors import ModelError

Json = dict[str, Any]
LARGEST, LATEST = 1e24, 1e13
"""of any number of a model, and of a key time: splines through them still fit a 32-bit float"""


def integer(entry: Json, key: str, place: str, default: int | None = None, minimum: int = 0) -> int:
    """A whole number of at least `minimum`; without a default it must be there."""
    value = entry.get(key, default)
    if type(value) is not int or value < minimum:
        raise ModelError(f"{key} is {shown(value)}; it must be a whole number of at least {minimum}", place=f"{place}/{key}")
    return value


def numbers(entry: Json, key: str, place: str, count: int, default: list[float] | None = None) -> list[float]:
    """A list of exactly `count` numbers, none beyond 1e24; the default, or none, where the key is missing."""
    values = entry.get(key, default)
    if not isinstance(values, list) or len(values) != count or not all(is_usable(v) for v in values):
        raise ModelError(f"{key} is {shown(values)}; it must be {count} finite numbers up to {LARGEST:g}", place=f"{place}/{key}")
    return values


def is_usable(value: Any) -> bool:
    """Whether the value is a number that can be computed with in 32-bit floats."""
    return type(value) in (int, float) and abs(value) <= LARGEST


def text(entry: Json, key: str, place: str, default: str | None = None) -> str:
    """A string; without a default it must be there."""
    value = entry.get(key, default)
    if not isinstance(value, str):
        raise ModelError(f"{key} is {shown(value)}; it must be a string", place=f"{place}/{key}")
    return value


def label(entry: Json, place: str) -> str:
    """The object's name, or the empty string."""
    return text(entry, "name", place, "")


def mapping(entry: Json, key: str, place: str) -> Json:
    """An object; an empty one where the key is missing."""
    return as_object(entry.get(key, {}), f"{place}/{key}")


def as_object(value: Any, place: str) -> Json:
    """The value, which must be a JSON object."""
    if not isinstance(value, dict):
        raise ModelError(f"this is {shown(value)}; it must be an object", place=place)
    return value


def items(entry: Json, key: str, place: str, *, required: bool = False) -> list[Any]:
    """A list, empty where the key is missing and not required; a required one must have members."""
    value = entry.get(key, [])
    if not isinstance(value, list):
        raise ModelError(f"{key} is {shown(value)}; it must be a list", place=f"{place}/{key}")
    if required and not value:
        raise ModelError(f"{key} is missing or empty; it must have at least one member", place=f"{place}/{key}")
    return value


def objects(entry: Json, key: str, place: str, *, required: bool = False) -> list[Json]:
    """A list of objects."""
    values = items(entry, key, place, required=required)
    if set(map(type, values)) <= {dict}:
        return values
    return [as_object(value, f"{place}/{key}/{row}") for row, value in enumerate(values)]


def one_of(entry: Json, key: str, place: str, allowed: Any, default: Any = None) -> Any:
    """A value among those allowed (a container of strings or ints, never of both kinds)."""
    value = entry.get(key, default)
    if isinstance(value, (dict, list, bool, float)) or value not in allowed:
        raise ModelError(f"{key} is {shown(value)}; it must be one of {', '.join(str(v) for v in allowed)}", place=f"{place}/{key}")
    return value


def reference(entry: Json, key: str, place: str, collection: list[Any], kind: str) -> int | None:
    """An index into a collection, or None where the key is missing."""
    return required_reference(entry, key, place, collection, kind) if key in entry else None


def required_reference(entry: Json, key: str, place: str, collection: list[Any], kind: str) -> int:
    """An index into a collection that must be there."""
    value = entry.get(key)
    if type(value) is int and 0 <= value < len(collection):
        return value
    return index(value, f"{place}/{key}", collection, kind)


def index(value: Any, place: str, collection: list[Any], kind: str) -> int:
    """A value that must be an index into a collection."""
    if type(value) is not int or not 0 <= value < len(collection):
        article = "an" if kind[0] in "aeiou" else "a"
        raise ModelError(f"{shown(value)} is not the index of {article} {kind}; there are {len(collection)}", place=place)
    return value


def indices(values: list[Any], place: str, collection: list[Any], kind: str) -> list[int]:
    """A list whose members must all be indices into a collection."""
    if not set(map(type, values)) <= {int} or (values and not 0 <= min(values) <= max(values) < len(collection)):
        for row, value in enumerate(values):
            index(value, f"{place}/{row}", collection, kind)
    return values


def labels(entries: list[Json], place: str) -> list[str]:
    """The names of all objects, empty where they have none."""
    values = [entry.get("name", "") for entry in entries]
    return values if set(map(type, values)) <= {str} else [label(entry, f"{place}/{row}") for row, entry in enumerate(entries)]


def shown(value: Any) -> str:
    """The value as a message shows it, cut where it is long."""
    whole = "missing" if value is None else repr(value) if isinstance(value, (int, float, str)) else f"a {type(value).__name__}"
    return whole if len(whole) <= 40 else whole[:37] + "..."
