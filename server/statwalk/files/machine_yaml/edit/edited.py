"""Applies operations to a machine's text; also to a newer text than the one that an editor has read."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from statwalk.errors import ContentError, MachineError
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part, Parts
from statwalk.files.machine_yaml.edit.parts import parts_of
from statwalk.files.machine_yaml.machine_text import MachineText


def edited(text: str, operations: Iterable[EditOperation]) -> str:
    """Returns a machine's whole text (`machine_text`) after operations, one after the other.

    :raises MachineError: when the text cannot be read, or an operation is not possible.
    :raises RefusedEditError: when an operation would delete what is still used.
    """
    parts = MachineText.of(text)
    for operation in operations:
        try:
            parts = operation.apply(parts)
        except MachineError:
            raise
        except ContentError as error:  # of the text as YAML
            raise MachineError(error.message, file=error.file, place=error.place) from None
    return parts.whole()


def conflict(base: str, newest: str, operations: Sequence[EditOperation]) -> Part | None:
    """Returns a part that operations touch, and that two texts say differently; None if there is none.

    Operations that were made for the text `base` may be applied to `newest` if there is none.
    """
    before, after = parts_of(MachineText.of(base)), parts_of(MachineText.of(newest))
    touched = [part for operation in operations for part in operation.touched()]
    deleted = [name for operation in operations if (name := operation.deleted())]
    found = [
        part
        for part in {**before, **after}
        if before.get(part) != after.get(part)
        and (
            any(part[: len(beginning)] == beginning for beginning in touched)
            or any(_speaks_of(name, part, (before, after)) for name in deleted)
        )
    ]
    return min(found, key=lambda part: part[0] != "name", default=None)  # a name says most


def _speaks_of(name: str, part: Part, texts: Iterable[Parts]) -> bool:
    """Whether a part has a name in it, in one of the texts."""
    words = " ".join([*part, *(parts.get(part, "") for parts in texts)])
    return part[0] != "name" and re.search(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", words) is not None
