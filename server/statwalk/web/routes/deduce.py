"""POST /api/deduce: the twelve rules of inverse kinematics (IK1 to IK12)."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from fastapi import APIRouter, Depends

from statwalk.character.bone_sets import bone_set_of
from statwalk.character.deduce import Deduction, deduce, sketch
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files.deduce_yaml import ANGLES, read_deduce
from statwalk.files.faq.skeleton_text import SHIPPED, shipped_skeleton
from statwalk.services.library.catalogue import Catalogue
from statwalk.solve.bone_values import BoneSet, BoneValue
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import catalogue_of
from statwalk.web.errors import Problem
from statwalk.web.schemas.deduction import (
    DeducedBoneView,
    DeductionView,
    FoundView,
    KnownBody,
    NewDeduction,
)

router = APIRouter(prefix="/api/deduce", tags=["characters"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]


@router.post("")
def deduce_bones(body: NewDeduction, catalogue: CatalogueDep) -> DeductionView:
    """Finds the angles, matrices and points of bones that follow from the known ones, each with the rule that
    found it.

    422 if known values contradict each other.
    """
    return _view(_answer(body, catalogue))


def _answer(body: NewDeduction, catalogue: Catalogue) -> Deduction:
    if [body.file, body.character, body.skeleton, body.bones].count(None) != 3:
        raise Problem(422, "one of `file`, `character`, `skeleton` and `bones` is needed", field="bones")
    if body.file is not None:
        return read_deduce(body.file).answer()
    bones = _bones(body, catalogue)
    known = {name: _known(values) for name, values in body.known.items()}
    try:
        return deduce(bones, known, body.expressions)
    except ContentError as error:
        field = "expressions" if error.place.startswith("line") else f"known.{error.place}"
        raise Problem(422, str(error), field=field) from None


def _bones(body: NewDeduction, catalogue: Catalogue) -> BoneSet:
    if body.character is not None:
        return bone_set_of(catalogue.character(body.character))
    if body.skeleton is not None:
        names = sorted(path.stem for path in SHIPPED.glob("*.txt"))
        if body.skeleton not in names:
            raise UnknownNameError("skeleton", body.skeleton, names)
        return bone_set_of(shipped_skeleton(body.skeleton))
    return bone_set_of({name: row.model_dump() for name, row in (body.bones or {}).items()})


def _known(values: KnownBody) -> dict[str, Any]:
    """The members that a client has sent."""
    known = {name: getattr(values, name) for name in values.model_fields_set}
    if ANGLES in known:
        angles = known.pop(ANGLES)
        known["RA"] = None if angles is None else np.radians(angles)
    return known


def _view(found: Deduction) -> DeductionView:
    points = sketch(found)
    bones = [
        DeducedBoneView(
            name=name,
            parent=int(found.bones.parent[bone]),
            values={
                (ANGLES if quantity == "RA" else quantity): _found(entry, quantity)
                for quantity, entry in found[name].items()
            },
            unknown=[
                ANGLES if quantity == "RA" else quantity for owner, quantity in found.unknown if owner == name
            ],
            start=tuple(points[bone, 0].tolist()),
            end=tuple(points[bone, 1].tolist()),
        )
        for bone, name in enumerate(found.bones.names)
    ]
    variables = {name: float(np.ravel(entry.value)[0]) for name, entry in found.variables.items()}
    return DeductionView(bones=bones, variables=variables)


def _found(entry: BoneValue, quantity: str) -> FoundView:
    value = np.degrees(entry.value) if quantity == "RA" else entry.value
    return FoundView(value=np.ravel(value).tolist(), source=entry.source)
