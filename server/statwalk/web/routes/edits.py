"""PUT /api/machines/{name}, PATCH …/cells, POST …/undo: edit a machine while stages play it.

If-Match names the version that an editor has read, so that no editor overwrites the edit of another.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Header, Request, Response
from pydantic.json_schema import SkipJsonSchema

from statwalk.errors import ContentError, RefusedEditError
from statwalk.files.machine_yaml.cell_text import CellPlace, with_cell
from statwalk.files.machine_yaml.expression_text import with_expressions
from statwalk.files.machine_yaml.machine_file import FILE_NAME, SCHEMA_PATH
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting.machine_versions import CurrentMachine, Edited, MachineVersions
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, registry_in
from statwalk.web.errors import Problem, from_error
from statwalk.web.routes.machines import encoded, machine_members
from statwalk.web.schemas.base import Flag
from statwalk.web.schemas.finding import FindingView, finding_views
from statwalk.web.schemas.machine import (
    EditedMachine,
    NewCell,
    NewExpressions,
    NewText,
    RefusedTrial,
    VersionView,
)
from statwalk.web.schemas.problem import FieldError

SCHEMA: dict[int | str, dict[str, Any]] = {
    200: {"content": {"application/schema+json": {"schema": {"type": "object"}}}}
}
router = APIRouter(prefix="/api", tags=["machines"], route_class=BoundedRoute)


def _versions_of(request: Request) -> MachineVersions:
    versions: MachineVersions = registry_in(request).versions
    return versions


IfMatch = Annotated[
    str | SkipJsonSchema[None],
    Header(alias="If-Match", json_schema_extra={"pattern": '^ *"?[0-9]{1,9}"? *$'}),
]


def _version_of(if_match: IfMatch = None) -> int:
    """Returns the version that the editor has read.

    :raises Problem: 428, when the header is missing; 422, when it is no number.
    """
    if if_match is None:
        raise Problem(
            428,
            'name the version that you change, as in If-Match: "3"; the machine has it as `version`',
            field="If-Match",
        )
    text = if_match.strip().strip('"')
    if not text.isascii() or not text.isdigit() or len(text) > 9:
        raise Problem(
            422,
            f"{if_match[:40]!r} is no version; a version is a whole number, the machine's `version`",
            field="If-Match",
        )
    return int(text)


Versions = Annotated[MachineVersions, Depends(_versions_of)]
SeenVersion = Annotated[int, Depends(_version_of)]


def _answer(versions: MachineVersions, name: str, edited: Edited) -> Response:
    """Returns the machine after the edit with the verifier's findings, and its version as the ETag."""
    members = machine_members(versions.catalogue.entry(name), edited.role, edited.version)
    view = EditedMachine(**members, findings=finding_views(edited.findings))
    return encoded(view, {"ETag": f'"{edited.version.number}"'})


def _edit(
    versions: MachineVersions, current: CurrentMachine, text: str, what: str, dry: bool, token: CancelToken
) -> Edited:
    act = versions.checked if dry else versions.change
    return act(current, text, what, checkpoint=token.check)


def _answered(edit: Callable[[], Response], dry: bool) -> Response:
    """Returns the answer to an edit; a refusal of a dry run is an answer, not an error."""
    try:
        return edit()
    except (ContentError, RefusedEditError) as error:
        if not dry:
            raise
        problem = from_error(error).body()
        trial = RefusedTrial(
            detail=problem["detail"],
            errors=[FieldError(**entry) for entry in problem["errors"]],
            findings=[FindingView(**finding) for finding in problem.get("findings", ())],
        )
        return encoded(trial)


@router.put("/machines/{name}", response_model=EditedMachine | RefusedTrial)
def put_machine(
    name: str,
    new: NewText,
    versions: Versions,
    seen: SeenVersion,
    token: LongWorkToken,
    dry: Flag = False,
) -> Response:
    """Replaces the machine's text: verifies it, then plays it on all stages at once.

    `dry`: only verifies, and changes nothing.
    """
    current = versions.based_on(name, seen)

    def edit() -> Response:
        edited = _edit(versions, current, new.text, "another text", dry, token)
        return _answer(versions, name, edited)

    return _answered(edit, dry)


@router.patch("/machines/{name}/cells", response_model=EditedMachine | RefusedTrial)
def patch_cell(
    name: str,
    new: NewCell,
    versions: Versions,
    seen: SeenVersion,
    token: LongWorkToken,
    dry: Flag = False,
) -> Response:
    """Changes one cell of a table, and leaves the rest of the file as it is; like PUT otherwise.

    `dry`: only verifies, and changes nothing.
    """
    place, new_text = CellPlace(new.layer, new.state, new.event), new.text.strip() or "blank"
    current = versions.based_on(name, seen)

    def edit() -> Response:
        text = with_cell(current.version.text, place=place, new=new.text, file=FILE_NAME)
        edited = _edit(versions, current, text, f"{new.state}/{new.event}: {new_text}", dry, token)
        return _answer(versions, name, edited)

    return _answered(edit, dry)


@router.patch("/machines/{name}/expressions", response_model=EditedMachine | RefusedTrial)
def patch_expressions(
    name: str,
    new: NewExpressions,
    versions: Versions,
    seen: SeenVersion,
    token: LongWorkToken,
    dry: Flag = False,
) -> Response:
    """Replaces the machine's expressions, and leaves the rest of the file as it is; like PUT otherwise.

    `dry`: only verifies, and changes nothing.
    """
    current = versions.based_on(name, seen)

    def edit() -> Response:
        text = with_expressions(current.version.text, new.text, FILE_NAME)
        return _answer(versions, name, _edit(versions, current, text, "expressions", dry, token))

    return _answered(edit, dry)


@router.post("/machines/{name}/undo", response_model=EditedMachine)
def undo(name: str, versions: Versions, seen: SeenVersion, token: LongWorkToken) -> Response:
    """Makes a new version with the text of the version before the newest."""
    edited = versions.undo(versions.based_on(name, seen), token.check)
    return _answer(versions, name, edited)


@router.get("/machines/{name}/versions")
def list_versions(name: str, versions: Versions) -> list[VersionView]:
    """Lists the newest versions of a machine, at most 200, oldest first."""
    return [_view_version(version) for version in versions.of(name)]


def _view_version(version: MachineVersion) -> VersionView:
    return VersionView(version=version.number, at=version.at, what=version.what, before=version.before)


@router.get("/schemas/machine.json", response_class=Response, responses=SCHEMA)
def get_schema() -> Response:
    """Returns the JSON Schema of machine.yaml, for text editors."""
    return Response(SCHEMA_PATH.read_bytes(), media_type="application/schema+json")
