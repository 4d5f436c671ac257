"""…/undo, …/redo, …/versions of a machine: back and forth through what it was."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Path, Query, Response

from statwalk.files.machine_yaml.edit.differences import differences
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.services.hosting import machine_edits
from statwalk.services.hosting.machine_edits import once
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken
from statwalk.web.routes.edits import Editor, Versions, answer
from statwalk.web.schemas.machine import EditedMachine
from statwalk.web.schemas.version import (
    CellDifferenceView,
    NameDifferenceView,
    PartDifferenceView,
    VersionDifferencesView,
    VersionText,
    VersionView,
)

router = APIRouter(prefix="/api/machines/{name}", tags=["machines"], route_class=BoundedRoute)
LARGEST_NUMBER = 999_999_999
Number = Annotated[int, Path(ge=1, le=LARGEST_NUMBER)]


@router.post("/undo", response_model=EditedMachine)
def undo(versions: Versions, editor: Editor) -> Response:
    """Makes a new version with the text of the version before the newest; again: the one before that."""
    return answer(versions, editor.name, once(versions, editor, lambda: machine_edits.undo(versions, editor)))


@router.post("/redo", response_model=EditedMachine)
def redo(versions: Versions, editor: Editor) -> Response:
    """Takes an undo back; 409 if nothing was undone, or an edit came after it."""
    return answer(versions, editor.name, once(versions, editor, lambda: machine_edits.redo(versions, editor)))


@router.get("/versions")
def list_versions(name: str, versions: Versions) -> list[VersionView]:
    """Lists the newest versions of a machine, at most 200, oldest first."""
    return [_view(version) for version in versions.of(name)]


@router.get("/versions/{number}")
def get_version(name: str, number: Number, versions: Versions) -> VersionText:
    """Returns a version with its text and its tables."""
    version = versions.version(name, number)
    text = MachineText.of(version.text)
    return VersionText(**dict(_view(version)), text=text.yaml, tables=dict(text.tables))


@router.get("/versions/{number}/differences")
def get_differences(
    name: str,
    number: Number,
    since: Annotated[int, Query(ge=1, le=LARGEST_NUMBER)],
    versions: Versions,
    _: LongWorkToken,
) -> VersionDifferencesView:
    """Returns what a version says otherwise than an older one: cells, states, events, other parts by name."""
    older, newer = versions.version(name, since), versions.version(name, number)
    found = differences(older.text, newer.text)
    return VersionDifferencesView(
        version=number,
        since=since,
        names=[NameDifferenceView.model_validate(difference) for difference in found.names],
        cells=[CellDifferenceView.model_validate(difference) for difference in found.cells],
        parts=[
            PartDifferenceView(part=list(difference.part), before=difference.before, after=difference.after)
            for difference in found.parts
        ],
    )


@router.post("/versions/{number}/restore", response_model=EditedMachine)
def restore(number: Number, versions: Versions, editor: Editor) -> Response:
    """Makes a new version with the text of an older one; an undo takes it back."""
    return answer(
        versions, editor.name, once(versions, editor, lambda: machine_edits.restore(versions, editor, number))
    )


def _view(version: MachineVersion) -> VersionView:
    return VersionView(
        version=version.number,
        at=version.at,
        what=version.what,
        before=version.before,
        after=version.after,
        author=version.author,
    )
