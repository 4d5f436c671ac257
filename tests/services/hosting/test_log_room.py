"""A full log forgets its oldest inputs, in memory and on the disk."""

import sqlite3
from contextlib import AbstractContextManager, suppress
from pathlib import Path

import pytest
from keeping import keeping, what_it_is
from statwalk.errors import LimitError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits

MOST = 40
EVENTS = SendEvent("FORWARD", 1), SendEvent("STOP", 1)


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


def small_logs(folder: Path, catalogue: Catalogue) -> AbstractContextManager[Registry]:
    return keeping(folder, catalogue, Limits(entries=MOST))


def busy(held: Registry, inputs: int = 3 * MOST) -> StageHost:
    host = held.open(StageSetup(clock="manual", actors=(AddActor("faq-walker"),)))
    for number in range(inputs):
        host.handle(ask.Post((EVENTS[number % 2],)))
        host.handle(ask.Step(7))
    return host


def test_a_full_log_forgets_and_says_where_it_begins(tmp_path: Path, catalogue: Catalogue) -> None:
    with small_logs(tmp_path, catalogue) as held:
        host = busy(held)
        status, log = host.handle(ask.Status()), host.handle(ask.Log())
    assert status.first > 0
    assert len(log) - 1 <= MOST


def test_numbers_go_on(tmp_path: Path, catalogue: Catalogue) -> None:
    with small_logs(tmp_path, catalogue) as held:
        assert busy(held).handle(ask.Post((EVENTS[0],))).seq == 3 * MOST + 2  # the first one is the arrival


def test_inputs_that_all_came_within_a_second_are_not_forgotten(tmp_path: Path, catalogue: Catalogue) -> None:
    with small_logs(tmp_path, catalogue) as held:
        host = busy(held, 0)
        for _ in range(MOST - 1):
            host.handle(ask.Post((EVENTS[0],)))
        with pytest.raises(LimitError, match="holds 40 inputs, and no more; let it step"):
            host.handle(ask.Post((EVENTS[0],)))
        host.handle(ask.Step(200))
        host.handle(ask.Post((EVENTS[0],)))


def test_it_comes_back_as_it_was(tmp_path: Path, catalogue: Catalogue) -> None:
    with small_logs(tmp_path, catalogue) as held:
        host = busy(held)
        before = what_it_is(host), host.handle(ask.Status()).first
    with small_logs(tmp_path, catalogue) as held:
        host = held.find(host.id)
        assert (what_it_is(host), host.handle(ask.Status()).first) == before


def test_a_stage_that_came_back_goes_on_and_forgets_more(tmp_path: Path, catalogue: Catalogue) -> None:
    with small_logs(tmp_path / "one", catalogue) as held:
        never_left = gone_on(busy(held))
    with small_logs(tmp_path / "two", catalogue) as held:
        left = busy(held)
    with small_logs(tmp_path / "two", catalogue) as held:
        host = held.find(left.id)
        first = host.handle(ask.Status()).first
        assert gone_on(host) == never_left
        assert host.handle(ask.Status()).first > first


def gone_on(host: StageHost) -> str:
    """The hash of a stage after more inputs."""
    for number in range(2 * MOST):
        host.handle(ask.Post((EVENTS[number % 2],)))
        host.handle(ask.Step(7))
    return host.handle(ask.Describe()).hash


def test_a_crash_just_after_it_forgot_takes_nothing(tmp_path: Path, catalogue: Catalogue) -> None:
    """What it forgot ends later than its playhead was kept the last time."""
    (crashed := tmp_path / "crashed").mkdir()
    with small_logs(tmp_path / "before", catalogue) as held:
        host = busy(held, 0)
        for _ in range(130):  # as the ticker does, which keeps the playhead once a second
            host._live.tick()
        for _ in range(MOST):
            host._live.apply(ask.Post((EVENTS[0],)), {})
        assert host.handle(ask.Status()).first == 120
        before = what_it_is(host)
        assert held.store is not None
        held.store.flush()
        held.store.records.copy(crashed / FILE_NAME)
    with small_logs(crashed, catalogue) as held:
        assert what_it_is(held.find(host.id)) == before


def test_a_log_that_could_not_forget_enough_comes_back(tmp_path: Path, catalogue: Catalogue) -> None:
    """The disk forgets with the memory, also where the input is refused all the same."""
    with small_logs(tmp_path, catalogue) as held:
        host = busy(held, 0)
        for _ in range(3):  # each time the newest snapshot is older than all that comes
            host.handle(ask.Step(200))
            with suppress(LimitError):
                for _ in range(MOST + 1):
                    host.handle(ask.Post((EVENTS[0],)))
        before = what_it_is(host), host.handle(ask.Status()).first
    with small_logs(tmp_path, catalogue) as held:
        host = held.find(host.id)
        assert (what_it_is(host), host.handle(ask.Status()).first) == before


def test_a_fork_of_it_comes_back_too(tmp_path: Path, catalogue: Catalogue) -> None:
    with small_logs(tmp_path, catalogue) as held:
        fork = held.find(busy(held).handle(ask.Fork()))
        before = what_it_is(fork)
    with small_logs(tmp_path, catalogue) as held:
        assert what_it_is(held.find(fork.id)) == before


def test_an_edit_that_was_forgotten_is_still_played(tmp_path: Path) -> None:
    with small_logs(tmp_path, Catalogue()) as held:
        host = busy(held, 1)
        current = held.versions.current("faq-walker")
        text = current.version.text.replace("STAT  | STWK ", "STAT  | CRCH ")
        held.versions.change(current, text, "a walker that crouches")
        for _ in range(3):
            gone_on(host)
        assert not any('"edit"' in line for line in host.handle(ask.Log())[1:])
        before = what_it_is(host)
    with small_logs(tmp_path, Catalogue()) as held:
        assert what_it_is(held.find(host.id)) == before


def test_a_damaged_beginning_keeps_the_stage_away(
    tmp_path: Path, catalogue: Catalogue, caplog: pytest.LogCaptureFixture
) -> None:
    with small_logs(tmp_path, catalogue) as held:
        host = busy(held)
        first = host.handle(ask.Status()).first
    database = sqlite3.connect(tmp_path / FILE_NAME)
    database.execute("UPDATE snapshots SET data = zeroblob(100) WHERE tick = ?", (first,))
    database.commit()
    database.close()
    with small_logs(tmp_path, catalogue) as held:
        assert host.id not in held.stages
    assert "the state at which its log begins is damaged" in caplog.text


def test_a_start_gives_free_space_back_to_the_disk(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = busy(held, 20 * MOST)
        held.close(host.id)
    before = (tmp_path / FILE_NAME).stat().st_size
    for _ in range(2):  # the first start frees the pages, its end cuts the file
        with keeping(tmp_path, catalogue):
            pass
    assert (tmp_path / FILE_NAME).stat().st_size < before / 2
