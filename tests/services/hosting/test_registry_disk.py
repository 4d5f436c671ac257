"""While the disk refuses, no more writes wait for it than did before."""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from commanded_disk import CommandedDisk, kept_on_disk
from serving import wait_for
from statwalk.errors import StorageError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost

SETUP = StageSetup(clock="manual", actors=(AddActor("elbow"),))


class Refused(NamedTuple):
    """A registry whose disk refuses, and a stage in it; `before`: the writes until now."""

    held: Registry
    host: StageHost
    disk: CommandedDisk
    before: int


@pytest.fixture
def refused(tmp_path: Path) -> Iterator[Refused]:
    with kept_on_disk(tmp_path) as (held, disk):
        host = held.open(SETUP)
        disk.refuses = True
        before = disk.writes()
        wait_for(lambda: disk.store.writer.trouble is not None)
        yield Refused(held, host, disk, before)


def test_playheads_do_not_pile_up(refused: Refused) -> None:
    for _ in range(5):
        refused.host._live.stage.step(1)
        refused.held.save()
    assert refused.disk.writes() == refused.before + 1


def test_new_stages_do_not_pile_up(refused: Refused) -> None:
    with pytest.raises(StorageError, match="refuses"):
        refused.held.open(SETUP)
    assert (refused.disk.writes(), len(refused.held.stages)) == (refused.before + 1, 1)


def test_inputs_do_not_pile_up(refused: Refused) -> None:
    with pytest.raises(StorageError, match="refuses"):
        refused.host.handle(ask.Post((SendEvent("BEND", 1),)))
    assert refused.disk.writes() == refused.before + 1
