"""Checks one field of a glTF object: returns its value, or raises a ModelError with the place (a JSON
pointer) and what would be right.

Only Python ints and comparisons are used; no size that a file claims leads to an allocation.
"""

from __future__ import annotations

from typing import Any

from statwalk.errors import ModelError

Json = dict[str, Any]
LARGEST, LATEST = 1e24, 1e13
"""limits of a model's numbers and of key times: splines through the numbers still fit a 32-bit float"""


def integer(entry: Json, key: str, place: str, default: int | None = None, minimum: int = 0) -> int:
    """Returns a whole number of at least `minimum`; without a default the field is required."""
    value = entry.get(key, default)
    if type(value) is not int or value < minimum:
        raise ModelError(
            f"{key} is {shown(value)}; it must be a whole number of at least {minimum}",
            place=f"{place}/{key}",
        )
    return value


def numbers(entry: Json, key: str, place: str, count: int, default: list[float] | None = None) -> list[float]:
    """Returns a list of exactly `count` numbers up to ±1e24; without a default the field is required."""
    values = entry.get(key, default)
    if not isinstance(values, list) or len(values) != count or not all(_is_usable(v) for v in values):
        raise ModelError(
            f"{key} is {shown(values)}; it must be {count} finite numbers up to {LARGEST:g}",
            place=f"{place}/{key}",
        )
    return values


def _is_usable(value: Any) -> bool:
    """Returns whether the value is a number that 32-bit floats can compute with."""
    return type(value) in (int, float) and abs(value) <= LARGEST


def text(entry: Json, key: str, place: str, default: str | None = None) -> str:
    """Returns a string; without a default the field is required."""
    value = entry.get(key, default)
    if not isinstance(value, str):
        raise ModelError(f"{key} is {shown(value)}; it must be a string", place=f"{place}/{key}")
    return value


def label(entry: Json, place: str) -> str:
    """Returns the object's name; empty if it has none."""
    return text(entry, "name", place, "")


def mapping(entry: Json, key: str, place: str) -> Json:
    """Returns an object; empty if the key is missing."""
    return as_object(entry.get(key, {}), f"{place}/{key}")


def as_object(value: Any, place: str) -> Json:
    """Returns the value, which must be a JSON object."""
    if not isinstance(value, dict):
        raise ModelError(f"this is {shown(value)}; it must be an object", place=place)
    return value


def items(entry: Json, key: str, place: str, *, required: bool = False) -> list[Any]:
    """Returns a list; empty if the key is missing. A required list must have at least one member."""
    value = entry.get(key, [])
    if not isinstance(value, list):
        raise ModelError(f"{key} is {shown(value)}; it must be a list", place=f"{place}/{key}")
    if required and not value:
        raise ModelError(
            f"{key} is missing or empty; it must have at least one member", place=f"{place}/{key}"
        )
    return value


def objects(entry: Json, key: str, place: str, *, required: bool = False) -> list[Json]:
    """Returns a list of objects."""
    values = items(entry, key, place, required=required)
    if set(map(type, values)) <= {dict}:
        return values
    return [as_object(value, f"{place}/{key}/{row}") for row, value in enumerate(values)]


def one_of(entry: Json, key: str, place: str, allowed: Any, default: Any = None) -> Any:
    """Returns a value of the `allowed` container, which holds strings or ints, never both."""
    value = entry.get(key, default)
    if isinstance(value, (dict, list, bool, float)) or value not in allowed:
        raise ModelError(
            f"{key} is {shown(value)}; it must be one of {', '.join(str(v) for v in allowed)}",
            place=f"{place}/{key}",
        )
    return value


def reference(entry: Json, key: str, place: str, collection: list[Any], kind: str) -> int | None:
    """Returns an index into a collection; None if the key is missing."""
    return required_reference(entry, key, place, collection, kind) if key in entry else None


def required_reference(entry: Json, key: str, place: str, collection: list[Any], kind: str) -> int:
    """Returns a required index into a collection."""
    value = entry.get(key)
    if type(value) is int and 0 <= value < len(collection):
        return value
    return index(value, f"{place}/{key}", collection, kind)


def index(value: Any, place: str, collection: list[Any], kind: str) -> int:
    """Returns a value that must be an index into a collection."""
    if type(value) is not int or not 0 <= value < len(collection):
        article = "an" if kind[0] in "aeiou" else "a"
        raise ModelError(
            f"{shown(value)} is not the index of {article} {kind}; there are {len(collection)}", place=place
        )
    return value


def indices(values: list[Any], place: str, collection: list[Any], kind: str) -> list[int]:
    """Returns a list whose members must all be indices into a collection."""
    if not set(map(type, values)) <= {int} or (
        values and not 0 <= min(values) <= max(values) < len(collection)
    ):
        for row, value in enumerate(values):
            index(value, f"{place}/{row}", collection, kind)
    return values


def labels(entries: list[Json], place: str) -> list[str]:
    """Returns the names of all objects; empty for objects without a name."""
    values = [entry.get("name", "") for entry in entries]
    return (
        values
        if set(map(type, values)) <= {str}
        else [label(entry, f"{place}/{row}") for row, entry in enumerate(entries)]
    )


def shown(value: Any) -> str:
    """Returns the value as a message shows it; a long one is cut."""
    full_text = (
        "missing"
        if value is None
        else repr(value)
        if isinstance(value, (int, float, str))
        else f"a {type(value).__name__}"
    )
    return full_text if len(full_text) <= 40 else full_text[:37] + "..."
