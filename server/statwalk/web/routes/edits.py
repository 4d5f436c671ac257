"""PUT and PATCH /api/machines/{name}: edit a machine while stages play it.

If-Match names the version that an editor has read: operations count as long as nobody has changed what they
touch since then, a whole text only if nobody has changed anything.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Header, Request, Response
from pydantic.json_schema import SkipJsonSchema

from statwalk.errors import ContentError, RefusedEditError
from statwalk.files.machine_yaml.edit import operations as edit
from statwalk.files.machine_yaml.machine_file import SCHEMA_PATH
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.services.hosting import machine_edits
from statwalk.services.hosting.edit_keys import EditKey
from statwalk.services.hosting.machine_edits import EditRequest
from statwalk.services.hosting.machine_versions import Edited, MachineVersions
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, grant_of, registry_in
from statwalk.web.errors import Problem, from_error
from statwalk.web.routes.machines import encoded, machine_members
from statwalk.web.schemas.base import Flag, IdempotencyKey, RequestModel
from statwalk.web.schemas.finding import FindingView, finding_views
from statwalk.web.schemas.machine import EditedMachine, NewCell, NewExpressions, NewText, RefusedTrial
from statwalk.web.schemas.machine_operations import NewOperations
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


Key = Annotated[IdempotencyKey, Header(alias="Idempotency-Key")]


def _editor(
    name: str, request: Request, seen: SeenVersion, token: LongWorkToken, key: Key = ""
) -> EditRequest:
    """Returns who edits which machine, what cancels it, and the key of the request without its body."""
    return EditRequest(
        name,
        seen,
        grant_of(request).name,
        token,
        EditKey.of(key, request.method, request.url.path, seen),
    )


def bearing(editor: EditRequest, body: RequestModel) -> EditRequest:
    """Returns an editor whose key stands for the body, too."""
    key = editor.key and EditKey.of(editor.key.key, editor.key.request, body.model_dump_json())
    return editor._replace(key=key)


Editor = Annotated[EditRequest, Depends(_editor)]


def answer(versions: MachineVersions, name: str, edited: Edited) -> Response:
    """Returns the machine after the edit with the verifier's findings, and its version as the ETag."""
    members = machine_members(versions.catalogue.entry(name), edited.role, edited.version)
    view = EditedMachine(**members, findings=finding_views(edited.findings))
    return encoded(view, {"ETag": f'"{edited.version.number}"'})


def _answered(act: Callable[[], Response], dry: bool) -> Response:
    """Returns the answer to an edit; a refusal of a dry run is an answer, not an error."""
    try:
        return act()
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


def _operate(
    versions: MachineVersions,
    editor: EditRequest,
    operations: Sequence[edit.EditOperation],
    dry: bool,
) -> Response:
    if dry:
        return _answered(
            lambda: answer(versions, editor.name, machine_edits.trial(versions, editor, operations)), dry
        )
    edited = machine_edits.once(versions, editor, lambda: machine_edits.change(versions, editor, operations))
    return answer(versions, editor.name, edited)


@router.put("/machines/{name}", response_model=EditedMachine | RefusedTrial)
def put_machine(new: NewText, versions: Versions, editor: Editor, dry: Flag = False) -> Response:
    """Replaces the machine's text: verifies it, then plays it on all stages at once.

    `dry`: only verifies, and changes nothing.
    """
    if dry:
        return _answered(lambda: answer(versions, editor.name, _replaced(new, versions, editor, dry)), dry)
    editor = bearing(editor, new)
    edited = machine_edits.once(versions, editor, lambda: _replaced(new, versions, editor, dry))
    return answer(versions, editor.name, edited)


def _replaced(new: NewText, versions: MachineVersions, editor: EditRequest, dry: bool) -> Edited:
    current = versions.based_on(editor.name, editor.seen)
    tables = MachineText.of(current.version.text).tables if new.tables is None else new.tables
    text, what, author = MachineText(new.text, tables).whole(), "another text", editor.author
    if dry:
        return versions.checked(current, text, what, author=author, token=editor.token)
    return versions.change(current, text, what, author=author, token=editor.token, key=editor.key)


@router.patch("/machines/{name}", response_model=EditedMachine | RefusedTrial)
def patch_machine(new: NewOperations, versions: Versions, editor: Editor, dry: Flag = False) -> Response:
    """Applies operations in their order, as one version; the rest of the file stays as it is. Like PUT
    otherwise, but the version in If-Match may be older: 412 only if another editor has changed what the
    operations touch.

    `dry`: only verifies, and changes nothing.
    """
    return _operate(
        versions, bearing(editor, new), [operation.operation() for operation in new.operations], dry
    )


@router.patch("/machines/{name}/cells", response_model=EditedMachine | RefusedTrial)
def patch_cell(new: NewCell, versions: Versions, editor: Editor, dry: Flag = False) -> Response:
    """Changes the text of one cell: the operation `set_cell`.

    `dry`: only verifies, and changes nothing.
    """
    return _operate(
        versions, bearing(editor, new), [edit.SetCell(new.state, new.event, new.text, layer=new.layer)], dry
    )


@router.patch("/machines/{name}/expressions", response_model=EditedMachine | RefusedTrial)
def patch_expressions(new: NewExpressions, versions: Versions, editor: Editor, dry: Flag = False) -> Response:
    """Replaces the machine's expressions: the operation `set_expressions`.

    `dry`: only verifies, and changes nothing.
    """
    return _operate(versions, bearing(editor, new), [edit.SetExpressions(new.text)], dry)


@router.get("/schemas/machine.json", response_class=Response, responses=SCHEMA)
def get_schema() -> Response:
    """Returns the JSON Schema of machine.yaml, for text editors."""
    return Response(SCHEMA_PATH.read_bytes(), media_type="application/schema+json")
