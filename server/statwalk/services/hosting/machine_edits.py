"""Edits a machine by operations, and goes back and forth through its versions.

Operations count for the newest version, also if an editor has read an older one, as long as nobody has
changed what they touch.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from statwalk.character.role import Role
from statwalk.errors import ConflictError, StatwalkError, VersionConflictError
from statwalk.files.machine_yaml.edit.edited import conflict, edited
from statwalk.files.machine_yaml.edit.operation import EditOperation
from statwalk.files.machine_yaml.machine_file import FILE_NAME, machine_of
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.hosting.edit_keys import EditKey
from statwalk.services.hosting.machine_versions import CurrentMachine, Edited, MachineVersions, Step
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.services.library.measuring import findings_of

MOST_TRIES = 8
"""how often operations are verified again, if others edit the machine meanwhile"""
LONGEST_WHAT = 200


class EditRequest(NamedTuple):
    """Who edits a machine, which version they have read, and what cancels the edit."""

    name: str
    seen: int
    author: str = ""
    token: CancelToken = NEVER
    key: EditKey | None = None


def once(versions: MachineVersions, request: EditRequest, edit: Callable[[], Edited]) -> Edited:
    """Makes an edit, or returns what it made already, if it came before with the same key.

    :raises BusyError: when an edit with this key is under way.
    :raises ConflictError: when the key belongs to another edit.
    """
    with versions.keys.reserved(request.name, request.key):
        version = versions.keys.earlier(request.name, request.key, versions.of(request.name))
        return edit() if version is None else _as_made(versions, request, version)


def _as_made(versions: MachineVersions, request: EditRequest, version: MachineVersion) -> Edited:
    """What the edit answered that made a version."""
    entry, newest, _ = versions.current(request.name)
    file = machine_of(version.text, entry.folder, FILE_NAME)
    role = Role.build(newest.name, newest.character, file.definition, file.root_joint)
    return Edited(version, file, role, list(findings_of(role, token=request.token)))


def change(versions: MachineVersions, request: EditRequest, operations: Sequence[EditOperation]) -> Edited:
    """Applies operations to the newest version of a machine, and makes that a version.

    :raises UnknownNameError: when no machine has this name.
    :raises VersionConflictError: when another editor has changed what the operations touch.
    :raises ContentError: when an operation is not possible.
    :raises RefusedEditError: when the verifier finds new errors.
    """
    for last in range(MOST_TRIES - 1, -1, -1):
        current, text = _applied(versions, request, operations)
        try:
            return versions.change(
                current,
                text,
                what(operations),
                author=request.author,
                token=request.token,
                key=request.key,
            )
        except VersionConflictError:  # another edit came while this one was verified: again on top of it
            if not last:
                raise
    raise AssertionError


def trial(versions: MachineVersions, request: EditRequest, operations: Sequence[EditOperation]) -> Edited:
    """Returns what `change` would make, without making it; raises the same."""
    current, text = _applied(versions, request, operations)
    return versions.checked(current, text, what(operations), token=request.token)


def what(operations: Sequence[EditOperation]) -> str:
    """Returns in a few words what operations do."""
    words = "; ".join(map(str, operations))
    return words if len(words) <= LONGEST_WHAT else f"{words[:LONGEST_WHAT]}…"


def _applied(
    versions: MachineVersions, request: EditRequest, operations: Sequence[EditOperation]
) -> tuple[CurrentMachine, str]:
    """The machine as it is, and its text after the operations."""
    current = versions.current(request.name)
    newest = current.version
    if request.seen != newest.number:
        _check_apart(versions, request, newest, operations)
    return current, edited(newest.text, operations)


def _check_apart(
    versions: MachineVersions,
    request: EditRequest,
    newest: MachineVersion,
    operations: Sequence[EditOperation],
) -> None:
    """:raises VersionConflictError: when other edits since `request.seen` touch the same."""
    name, seen = request.name, request.seen
    kept = {version.number: version for version in versions.of(name)}
    if seen not in kept:
        raise VersionConflictError(
            f"{name} is at version {newest.number}, and version {seen} is not kept; read it again",
            field="version",
        )
    if conflict(kept[seen].text, newest.text, operations) is None or _is_made(newest.text, operations):
        return
    other = next(
        version
        for number, version in kept.items()
        if number > seen and conflict(kept[seen].text, version.text, operations)
    )
    part = conflict(kept[seen].text, other.text, operations) or ()
    by = f" by {other.author}" if other.author else ""
    raise VersionConflictError(
        f"version {other.number}{by} ({other.what}) has changed the same since version {seen}: "
        f"{'/'.join(part)}; {name} is at version {newest.number} now, read it again",
        field="/".join(part),
    )


def _is_made(text: str, operations: Sequence[EditOperation]) -> bool:
    """Whether a text says already what operations would make of it: a request that came twice."""
    try:
        return edited(text, operations) == text
    except StatwalkError:
        return False


# --- back and forth


def undo(versions: MachineVersions, request: EditRequest) -> Edited:
    """Makes a version with the text before the newest one; the next undo goes back further.

    :raises VersionConflictError: when `request.seen` is not the newest version.
    :raises ConflictError: when there is nothing to undo.
    """
    current = versions.based_on(request.name, request.seen)
    target = _step(versions, request.name, current.version.before, "undo")
    step = Step(target.before, current.version.number)
    return _back_to(versions, request, current, target, step)


def redo(versions: MachineVersions, request: EditRequest) -> Edited:
    """Makes a version with the text that the last undo took away; the next redo goes on.

    :raises VersionConflictError: when `request.seen` is not the newest version.
    :raises ConflictError: when there is nothing to redo: nothing was undone, or another edit came after it.
    """
    current = versions.based_on(request.name, request.seen)
    target = _step(versions, request.name, current.version.after, "redo")
    return _back_to(versions, request, current, target, Step(target.before, target.after))


def restore(versions: MachineVersions, request: EditRequest, number: int) -> Edited:
    """Makes a version with the text of an older one, as an edit that can be undone.

    :raises UnknownNameError: when the version is not kept.
    :raises VersionConflictError: when `request.seen` is not the newest version.
    """
    target = versions.version(request.name, number)
    current = versions.based_on(request.name, request.seen)
    return _back_to(versions, request, current, target, None)


def _step(versions: MachineVersions, name: str, number: int, way: str) -> MachineVersion:
    target = next((version for version in versions.of(name) if version.number == number), None)
    if target is None:
        raise ConflictError(f"there is nothing to {way} in {name}")
    return target


def _back_to(
    versions: MachineVersions,
    request: EditRequest,
    current: CurrentMachine,
    target: MachineVersion,
    step: Step | None,
) -> Edited:
    return versions.change(
        current,
        target.text,
        f"back to version {target.number}",
        step=step,
        author=request.author,
        token=request.token,
        key=request.key,
    )
