"""Checks the values that a caller knows, and adds the defaults of the bones (FAQ Q26)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from statwalk.errors import ContentError, UnknownNameError
from statwalk.maths import vector
from statwalk.maths.arrays import Floats
from statwalk.solve.bone_values import DATA, DEFAULT, GIVEN, SHAPES, BoneSet, BoneValue, BoneValues

Known = Mapping[str, Mapping[str, ArrayLike | None]]
"""by bone and quantity; None: not known, although the bones have a default"""
MOST_NUMBERS = 20_000_000
LARGEST = 1e9
_ROTATION_ERROR = 1e-3


def given_values(bones: BoneSet, known: Known) -> BoneValues:
    """Returns the known values and the defaults: LEN, DIR and TR of the bones, where nothing else is given.

    TR has no default where both points that it joins are given, where SP is given and TR is not 0 at rest
    (markers show only the direction of a bone that branches, not its twist), and at a root if any point is
    given.

    :raises UnknownNameError: when a bone or quantity does not exist.
    :raises ContentError: when a value has another shape or other frames than the others, is not finite, or
        is impossible; `place` is `bone.quantity`.
    """
    state = BoneValues(bones)
    unknown = set(_read(state, known))
    _check_frames(state)
    given_points = {key for key in state.values if key[1] in ("SP", "EP")}
    for bone in range(len(bones.names)):
        for name, value in _defaults(bones, bone).items():
            joins = name == "TR" and _is_between_given(bones, bone, given_points)
            if (bone, name) not in state.values and (bone, name) not in unknown and not joins:
                state.values[bone, name] = BoneValue(value, DEFAULT)
    return state


def _read(state: BoneValues, known: Known) -> Iterator[tuple[int, str]]:
    """Puts the known values into `state`; yields the quantities that are said to be unknown."""
    if not isinstance(known, Mapping):
        raise ContentError("known values are written {bone: {quantity: value}}", place="known")
    for bone_name, quantities in known.items():
        if bone_name not in state.bones.names:
            raise UnknownNameError("bone", str(bone_name), state.bones.names)
        if not isinstance(quantities, Mapping):
            raise ContentError("known values are written {quantity: value}", place=bone_name)
        bone = state.bones.names.index(bone_name)
        for name, value in quantities.items():
            if name not in SHAPES and name not in DATA:
                raise UnknownNameError("quantity", str(name), [*SHAPES, *DATA])
            if value is None:
                yield bone, name
                continue
            array = _array(value, name, f"{bone_name}.{name}")
            if name in DATA:
                state.data[bone, name] = array
            else:
                state.put(bone, name, array, GIVEN)


def _check_frames(state: BoneValues) -> None:
    """Refuses values of different numbers of frames; a value without frames holds in all of them."""
    arrays = {key: given.value for key, given in state.values.items()} | state.data
    shapes = SHAPES | DATA
    lead: tuple[int, ...] = ()
    for (bone, name), array in arrays.items():
        own = array.shape[: array.ndim - len(shapes[name])]
        try:
            lead = np.broadcast_shapes(lead, own)
        except ValueError:
            place = f"{state.bones.names[bone]}.{name}"
            raise ContentError(f"{own} frames here, {lead} in the values before", place=place) from None


def _defaults(bones: BoneSet, bone: int) -> dict[str, Floats]:
    values = {
        "LEN": bones.length[bone], "DIR": bones.direction[bone], "TR": bones.translation[bone],
    }  # fmt: skip
    return {name: np.asarray(value) for name, value in values.items() if np.all(np.isfinite(value))}


def _is_between_given(bones: BoneSet, bone: int, points: set[tuple[int, str]]) -> bool:
    parent = int(bones.parent[bone])
    if parent < 0:
        return bool(points)
    return (bone, "SP") in points and ((parent, "EP") in points or bool(np.any(bones.translation[bone])))


def _array(value: Any, name: str, place: str) -> Floats:
    """The value as float64, checked."""
    shape = (SHAPES | DATA)[name]
    try:
        array = np.asarray(value, np.float64)
    except (TypeError, ValueError):
        raise ContentError("numbers are needed here", place=place) from None
    if array.shape[array.ndim - len(shape) :] != shape:
        wanted = " x ".join(map(str, shape)) if shape else "1"
        raise ContentError(f"{wanted} numbers are needed (after any frames), not {array.shape}", place=place)
    if array.size > MOST_NUMBERS:
        raise ContentError(f"more than {MOST_NUMBERS:,} numbers", place=place)
    if not np.all(np.isfinite(array)) or np.any(np.abs(array) > LARGEST):
        raise ContentError(f"numbers must be finite and at most {LARGEST:g}", place=place)
    return _possible(array, name, place)


def _possible(array: Floats, name: str, place: str) -> Floats:
    """The value, a direction at unit length.

    :raises ContentError: when no bone can have the value.
    """
    if name == "LEN" and np.any(array < 0):
        raise ContentError("a length cannot be negative", place=place)
    if name in ("DIR", "bend"):
        if np.any(vector.length(array) == 0):
            raise ContentError("a direction needs a length other than 0", place=place)
        return vector.unit(array)
    if name == "path" and np.any(np.all(array[..., 0, :] == array[..., 1, :], axis=-1)):
        raise ContentError("a path goes from one point to another", place=place)
    if name == "RM":
        product = array @ np.swapaxes(array, -1, -2)
        if np.any(np.abs(product - np.eye(3)) > _ROTATION_ERROR) or np.any(np.linalg.det(array) < 0):
            raise ContentError("this is no rotation matrix (rows at right angles, length 1)", place=place)
    return array
