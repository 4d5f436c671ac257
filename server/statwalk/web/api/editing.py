"""PUT /api/machines/{name}, PATCH …/cells, POST …/undo: tables changed while stages play them. Versions keep two editors apart."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from functools import partial
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Header, Request, Response
from pydantic import StringConstraints

from statwalk.files.celltext import LONGEST_CELL, Place, with_cell
from statwalk.files.machinefile import FILE_NAME, SCHEMA_PATH
from statwalk.machine.authored.definition import BASE
from statwalk.web.api.machines import view_machine
from statwalk.web.door import registry_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.editions import Edited, Edition, Editions
from statwalk.web.problem import Problem
from statwalk.web.schemas import Asked, Name

LONGEST_TEXT = 1 << 18
router = APIRouter(prefix="/api", tags=["machines"], route_class=BoundedRoute)


class NewText(Asked):
    """The whole machine file."""

    text: Annotated[str, StringConstraints(min_length=1, max_length=LONGEST_TEXT)]


class NewCell(Asked):
    """What one cell of a table is to say; empty: blank."""

    state: Name
    event: Name
    text: Annotated[str, StringConstraints(max_length=LONGEST_CELL)]
    layer: Name = BASE


def editions_of(request: Request) -> Editions:
    """The app's versions of machines."""
    editions: Editions = registry_of(request).editions
    return editions


def version_of(if_match: Annotated[str | None, Header(alias="If-Match")] = None) -> int:
    """The version that the editor has seen.

    :raises Problem: 428 without one, 422 if it is no number.
    """
    if if_match is None:
        raise Problem(428, "say which version you have changed: If-Match, with the machine's `version` in quotes", field="If-Match")
    text = if_match.strip().strip('"')
    if not text.isascii() or not text.isdigit() or len(text) > 9:
        raise Problem(422, f"{if_match[:40]!r} is no version; it is a whole number, as in GET the machine", field="If-Match")
    return int(text)


Kept = Annotated[Editions, Depends(editions_of)]
Seen = Annotated[int, Depends(version_of)]


def answered(editions: Editions, name: str, edited: Edited, response: Response) -> dict[str, Any]:
    """The machine as it is, or would be, and what the verifier says of it."""
    response.headers["ETag"] = f'"{edited.edition.version}"'
    view = view_machine(editions.catalogue.entry(name), edited.role, edited.edition)
    return view | {"findings": [asdict(finding) for finding in edited.findings]}


def changed(editions: Editions, name: str, seen: int, make: Callable[[str], str], what: str, dry: bool) -> Edited:
    """The machine with a text made of the newest one's."""
    with editions.based_on(name, seen) as newest:
        text = make(newest.text)
        act = editions.checked if dry else editions.change
        return act(name, text, what)


@router.put("/machines/{name}")
def put_machine(name: str, new: NewText, editions: Kept, seen: Seen, response: Response, dry: bool = False) -> dict[str, Any]:
    """Replaces the machine's file: verified first, then in force on all stages at once. `dry`: only what would be said."""
    edited = changed(editions, name, seen, lambda _: new.text, "another text", dry)
    return answered(editions, name, edited, response)


@router.patch("/machines/{name}/cells")
def patch_cell(name: str, new: NewCell, editions: Kept, seen: Seen, response: Response, dry: bool = False) -> dict[str, Any]:
    """Changes one cell of a table, as PUT does the whole; nothing else of the file moves."""
    place, said = Place(new.layer, new.state, new.event), new.text.strip() or "blank"
    make = partial(with_cell, place=place, new=new.text, file=FILE_NAME)
    edited = changed(editions, name, seen, make, f"{new.state}/{new.event}: {said}", dry)
    return answered(editions, name, edited, response)


@router.post("/machines/{name}/undo")
def undo(name: str, editions: Kept, seen: Seen, response: Response) -> dict[str, Any]:
    """The version before the newest, as a new one."""
    with editions.based_on(name, seen):
        return answered(editions, name, editions.undo(name), response)


class EditionView(Asked):
    """A version of a machine; `at` in seconds since 1970."""

    version: int
    at: float
    what: str
    before: int


@router.get("/machines/{name}/versions")
def list_versions(name: str, editions: Kept) -> list[EditionView]:
    """The versions that are remembered, the newest last."""
    return [view_edition(edition) for edition in editions.of(name)]


def view_edition(edition: Edition) -> EditionView:
    """A version without its text."""
    return EditionView(version=edition.version, at=edition.at, what=edition.what, before=edition.before)


@router.get("/schemas/machine.json", response_class=Response)
def get_schema() -> Response:
    """The JSON Schema of machine.yaml, for editors."""
    return Response(SCHEMA_PATH.read_bytes(), media_type="application/schema+json")
