"""`statwalk.edit`: the operations of the API on a machine's text, without a server."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from pydantic import ValidationError

from statwalk.errors import ContentError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.web.field_errors import field_errors
from statwalk.web.schemas.machine_operations import NewOperations


def edit(text: str, operations: Iterable[Mapping[str, Any]]) -> str:
    """Returns a machine file's text after operations, as `PATCH /api/machines/{name}` takes them:
    `statwalk.edit(text, [{"kind": "rename_state", "state": "WALK", "to": "STROLL"}])`.

    A machine whose table is in a .csv file: `machine_text.MachineText` says how both are one text.

    :raises ContentError: when an operation is unknown or not possible, or the text is no machine afterwards.
    :raises RefusedEditError: when an operation would delete what is still used.
    """
    try:
        checked = NewOperations.model_validate({"operations": [dict(operation) for operation in operations]})
    except ValidationError as error:
        places = [{**entry, "loc": ("body", *entry["loc"])} for entry in error.errors()]
        first = field_errors(places, NewOperations)[0]
        raise ContentError(first["message"], place=first["field"]) from None
    after = edited(text, [operation.operation() for operation in checked.operations])
    read_machine(after)
    return after
