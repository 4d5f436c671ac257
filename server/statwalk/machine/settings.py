"""The values that users give to parameters: numbers, or lists for points, directions and rotations."""

from __future__ import annotations

from collections.abc import Sequence

from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.compile.machine import Machine
from statwalk.machine.definition.parameter_definition import fitting


def parameter_indices(machine: Machine, name: str) -> tuple[int, ...]:
    """Returns the indices of the numbers that store a parameter: one, or the components of a vector.

    :raises UnknownNameError: when the machine has no parameter of that name; the error lists the parameters.
    """
    parameters = machine.parameters
    indices = tuple(k for k, part in enumerate(parameters) if name in (part.name, part.vector))
    if not indices:
        names = dict.fromkeys(part.vector or part.name for part in parameters)
        raise UnknownNameError("parameter", name, names)
    return indices


def values_of(machine: Machine, numbers: Sequence[float]) -> dict[str, float | tuple[float, ...]]:
    """Returns the values of all parameters by name, from the numbers (P,) that store them."""
    values: dict[str, float | tuple[float, ...]] = {}
    for part, number in zip(machine.parameters, numbers, strict=True):
        before = values.get(part.vector, ())
        values[part.vector or part.name] = (
            (*before, number) if part.vector and isinstance(before, tuple) else number
        )
    return values


def settings(
    machine: Machine, name: str, value: float | Sequence[float], now: Sequence[float]
) -> list[tuple[str, float]]:
    """Returns name and value of each number that stores a parameter; `now` (P,): the numbers of all
    parameters before.

    :raises UnknownNameError: when the machine has no parameter of that name.
    :raises StageError: when the value is out of range, or does not fit the kind of the parameter.
    """
    indices = parameter_indices(machine, name)
    parts = [machine.parameters[index] for index in indices]
    kind = "number" if parts[0].vector not in ("", name) else parts[0].kind
    try:
        numbers = fitting(name, kind, value)
    except ValueError as error:
        raise StageError(str(error)) from None
    for part, number in zip(parts, numbers, strict=True):
        if not part.minimum <= number <= part.maximum:
            raise StageError(f"{part.name} must lie in {part.minimum} … {part.maximum}, not at {number}")
    if kind == "rotation" and parts[0].smooth:
        numbers = _nearer_sign(numbers, [now[index] for index in indices])
    return [(part.name, number) for part, number in zip(parts, numbers, strict=True)]


def _nearer_sign(rotation: Sequence[float], now: Sequence[float]) -> tuple[float, ...]:
    """A rotation x y z w, or the same one with the other sign: a spring leads from `now` the short way."""
    is_far = sum(new * old for new, old in zip(rotation, now, strict=True)) < 0
    return tuple(-number if is_far else number for number in rotation)
