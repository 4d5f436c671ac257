"""Applies operations to a machine's text; also to a newer text than the one that an editor has read."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from statwalk.errors import ContentError, MachineError
from statwalk.files.machine_yaml.edit.operation import Operation, Part, Parts
from statwalk.files.machine_yaml.edit.parts import parts_of
from statwalk.files.machine_yaml.machine_text import MachineText


def edited(text: str, operations: Iterable[Operation]) -> str:
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


def conflict(base: str, newest: str, operations: Sequence[Operation]) -> Part | None:
    """Returns a part that operations touch, and that two texts say differently; None if there is none.

    Operations that were made for the text `base` may be applied to `newest` if there is none.
    """
    before, after = parts_of(MachineText.of(base)), parts_of(MachineText.of(newest))
    for operation in operations:
        for parts in (before, after):
            for touched in operation.touched(parts):
                if (part := _difference(before, after, touched)) is not None:
                    return part
    return None


def _difference(before: Parts, after: Parts, touched: Part) -> Part | None:
    """A part whose name begins like `touched`, and that differs."""
    size = len(touched)
    names = {name: None for name in (*before, *after) if name[:size] == touched}
    return next((name for name in names if before.get(name) != after.get(name)), None)
