"""Level of detail in a model's extras: a viewer that does not know it draws the full skin.

    meshes/N/primitives/M/extras.statwalk   {"collapses": {"vertices": 12, "onto": 13, "steps": 14}}
    extras.statwalk                         {"levels": [[1673, 0.0045], …]}

The three numbers are accessors of whole numbers, one for each collapse, first to last; a level is a number of
steps, and the error in metres.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.accessors import Accessors
from statwalk.files.gltf.builder import Builder, index_array
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.formats import INDICES
from statwalk.skin.collapses import Collapses, DetailLevel, fault, level_fault
from statwalk.skin.primitive import TRIANGLES, Primitive

KEY = "statwalk"
ARRAYS = ("vertices", "onto", "steps")
Detail = tuple[tuple[Primitive, ...], tuple[DetailLevel, ...]]


def level_words(levels: Sequence[DetailLevel]) -> list[list[float]]:
    """Returns the levels as extras hold them."""
    return [[level.steps, level.error] for level in levels]


def collapse_extras(builder: Builder, part: Primitive) -> Json:
    """Adds the arrays of a primitive's collapses; returns its extras, empty without collapses."""
    if part.collapses is None or not len(part.collapses.vertices):
        return {}
    steps = int(part.collapses.steps[-1]) + 1
    numbers = {"vertices": len(part.positions), "onto": len(part.positions), "steps": steps}
    rows = {
        name: builder.array(index_array(getattr(part.collapses, name), largest))
        for name, largest in numbers.items()
    }
    return {KEY: {"collapses": rows}}


def with_detail_of(document: Document, accessors: Accessors, parts: tuple[Primitive, ...]) -> Detail:
    """Returns the parts with the collapses that their document holds, and the levels. If anything in them is
    wrong all are left out, with a note: the full skin is still right.
    """
    try:
        levels = _levels(document.root)
        if not levels:
            return parts, ()
        collapses = {
            (part.mesh, part.primitive): _collapses(document, accessors, part)
            for part in parts
            if part.mode == TRIANGLES
        }
    except ModelError as error:
        document.note(f"the level of detail in extras.{KEY} is left out: {str(error)[:500]}")
        return parts, ()
    return tuple(
        replace(part, collapses=collapses.get((part.mesh, part.primitive))) for part in parts
    ), levels


def _said(entry: Json, key: str, place: str) -> tuple[object, str]:
    """What an object's extras say under a key, None if nothing; and the place."""
    extras = entry.get("extras")
    own = extras.get(KEY) if isinstance(extras, dict) else None
    return own.get(key) if isinstance(own, dict) else None, f"{place}/extras/{KEY}/{key}"


def _levels(root: Json) -> tuple[DetailLevel, ...]:
    values, place = _said(root, "levels", "")
    if values is None:
        return ()
    if not isinstance(values, list) or not all(map(_is_level, values)):
        raise ModelError("levels are pairs of a number of steps and an error in metres", place=place)
    levels = tuple(DetailLevel(steps, float(error)) for steps, error in values)
    wrong = level_fault(levels)
    if wrong:
        raise ModelError(wrong, place=place)
    return levels


def _is_level(value: object) -> bool:
    if not isinstance(value, list) or len(value) != 2 or type(value[0]) is not int:
        return False
    is_number = type(value[1]) in (int, float)
    return 0 < value[0] < 1 << 32 and is_number and 0 <= value[1] <= check.LARGEST


def _collapses(document: Document, accessors: Accessors, part: Primitive) -> Collapses | None:
    """The collapses of a primitive; None if it has none.

    :raises ModelError: when they are wrong.
    """
    place = f"/meshes/{part.mesh}/primitives/{part.primitive}"
    entry: Json = document["meshes"][part.mesh]["primitives"][part.primitive]
    value, place = _said(entry, "collapses", place)
    if value is None:
        return None
    rows = check.as_object(value, place)
    arrays = []
    for name in ARRAYS:
        row = check.required_reference(rows, name, place, document["accessors"], "accessor")
        values = accessors.read(row, INDICES, f"{place}/{name}")
        if len(values) > len(part.positions):
            raise ModelError("it has more elements than the primitive has vertices", place=f"{place}/{name}")
        arrays.append(values.astype(np.uint32))
    collapses = Collapses(*arrays)
    wrong = fault(collapses, len(part.positions))
    if wrong:
        raise ModelError(wrong, place=place)
    return collapses
