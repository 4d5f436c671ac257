"""Databases with another bit, or without their end: each stage must be what it was, or be reported."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from keeping import keeping, what_it_is
from statwalk.errors import ContentError, StorageError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.services.library.catalogue import Catalogue

STAGES = 3
EDITED = "biceps"
"""the machine that is edited, which plays on no stage"""
REPORTED, WHOLE = "reported", "whole"
CUT_SHARE = 0.1
"""of the damages that take the end of the file away, instead of flipping a bit"""


def kept(folder: Path, catalogue: Catalogue) -> dict[str, Any]:
    """Makes a folder with a few stages, each with inputs, keys and a past; returns what they are."""
    with keeping(folder, catalogue) as held:
        for number in range(STAGES):
            host = held.open(StageSetup(seed=number, clock="manual", actors=(AddActor("elbow"),)))
            for event in ("TWIST", "BEND", "STRETCH"):
                host.handle(ask.Post((SendEvent(event, 1),), key=f"{event} {number}"))
                host.handle(ask.Step(400))
            host.handle(ask.Seek(700 + number))
        current = held.versions.current(EDITED)
        held.versions.change(current, current.version.text + "\n# a remark\n", "a remark")
        return _all(held)


def _all(held: Registry) -> dict[str, Any]:
    """What all stages are, with the answers that their keys stand for, and the versions of the machine that
    was edited.
    """
    found: dict[str, Any] = {EDITED: (None, held.versions.of(EDITED))}
    for host in held.all():
        keys = host._live.keys
        found[host.id] = what_it_is(host), dict(keys.answers) if keys else {}
    return found


def damaged(data: bytes, seed: int) -> bytes:
    """Returns the file with another bit, or shorter; `seed` says which."""
    chance = random.Random(seed)
    if chance.random() < CUT_SHARE:
        return data[: chance.randrange(len(data))]
    changed = bytearray(data)
    changed[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def outcome(folder: Path, before: dict[str, Any], catalogue: Catalogue) -> tuple[str, list[str]]:
    """Opens a folder that was damaged; returns whether that was reported, and the stages that are silently
    not what they were.
    """
    try:
        with keeping(folder, catalogue) as held:
            now, left, damage = _all(held), set(held.left), held.damage
    except (ContentError, StorageError):
        return REPORTED, []
    if damage:  # it is reported what is damaged beside stages
        now, before = ({name: what for name, (what, _) in found.items()} for found in (now, before))
    # damage may have given the stage that is reported another name
    wrong = [
        name for name, was in before.items() if now.get(name, None if left else "gone") not in (was, None)
    ]
    wrong += [name for name in now if name not in before]
    return REPORTED if left or damage else WHOLE, wrong


def outcomes(folder: Path, seeds: range, catalogue: Catalogue) -> Iterator[tuple[int, str, list[str]]]:
    """Yields by seed what became of a damage."""
    before = kept(folder / "whole", catalogue)
    data = (folder / "whole" / FILE_NAME).read_bytes()
    copy = folder / "damaged"
    copy.mkdir()
    for seed in seeds:
        for old in copy.iterdir():
            old.unlink()
        (copy / FILE_NAME).write_bytes(damaged(data, seed))
        yield (seed, *outcome(copy, before, catalogue))
