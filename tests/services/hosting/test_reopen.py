"""After a start, every kept stage is where it was, with its log and the edits of its machines."""

import shutil
import sqlite3
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from damaging import damaged, emptied
from keeping import keeping, what_it_is
from old_formats import to_format_1, to_format_2, to_format_3, to_format_4
from planted import planted
from stages import registry
from statwalk.errors import BusyError, ConflictError, UnknownNameError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.store import kept_keys
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.services.hosting.store.read_records import KeptRecords
from statwalk.services.hosting.store.records import MAIN
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.load import shipped_machines_folder
from statwalk.stage.history import state_codec

WALKER = AddActor("faq-walker")
FORWARD, JUMP = SendEvent("FORWARD", 1), SendEvent("JUMP", 1)


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


def walked(held: Registry) -> StageHost:
    """A stage with a past of twenty seconds, and an input that waits."""
    host = held.open(StageSetup(seed=7, rate=50, clock="manual", actors=(WALKER,)))
    host.handle(ask.Post((FORWARD,), key="walk"))
    host.handle(ask.Step(1010))
    host.handle(ask.Post((AddActor("faq-walker", (1.0, 0.0, 0.0)), JUMP)))
    return host


CHANGES: dict[str, Callable[[StageHost], object]] = {
    "as it was": lambda _: None,
    "in the past": lambda host: host.handle(ask.Seek(31)),
    "paused": lambda host: host.handle(ask.Pause(True)),
    "at half speed": lambda host: host.handle(ask.SetSpeed(0.5)),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_stage_comes_back_where_it_was(tmp_path: Path, catalogue: Catalogue, change: str) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        CHANGES[change](host)
        before = what_it_is(host)
    with keeping(tmp_path, catalogue) as held:
        assert what_it_is(held.find(host.id)) == before


def test_a_stage_that_came_back_goes_on_like_one_that_never_left(
    tmp_path: Path, catalogue: Catalogue
) -> None:
    with keeping(tmp_path, catalogue) as held:
        kept = walked(held).id
    never_left = walked(registry(catalogue))
    with keeping(tmp_path, catalogue) as held:
        hashes = [
            host.handle(ask.Step(120)) and what_it_is(host)["hash"] for host in (held.find(kept), never_left)
        ]
    assert hashes[0] == hashes[1]


def test_its_status_says_at_which_tick_it_came_back(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        assert host.handle(ask.Status()).restored is None
    with keeping(tmp_path, catalogue) as held:
        assert held.find(host.id).handle(ask.Status()).restored == 1010


def test_a_fork_comes_back_with_its_past(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        fork = held.find(walked(held).handle(ask.Post((JUMP,), at=100)).stage)
        before = what_it_is(fork)
    with keeping(tmp_path, catalogue) as held:
        assert what_it_is(held.find(fork.id)) == before


def test_a_closed_stage_does_not_come_back(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        held.close(host.id)
        host.handle(ask.Status())
    with keeping(tmp_path, catalogue) as held:
        assert held.all() == []


def test_a_command_after_the_newest_note_counts(tmp_path: Path, catalogue: Catalogue) -> None:
    """As after a crash: the commands are kept at once, how far the stage is only now and then."""
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        host._live.kept = None  # nothing more is noted
        host.handle(ask.Step(30))
        host.handle(ask.Post((FORWARD,)))
        before = what_it_is(host)
    with keeping(tmp_path, catalogue) as held:
        assert what_it_is(held.find(host.id)) == before


def test_main_goes_on_under_another_name_if_the_server_opens_something_else(
    tmp_path: Path, catalogue: Catalogue
) -> None:
    with keeping(tmp_path, catalogue) as held:
        before = what_it_is(held.open_main())
    catalogue.default = "elbow"
    with keeping(tmp_path, catalogue) as held:
        (kept,) = held.all()
        assert kept.id != MAIN
        assert what_it_is(kept)["log"] == before["log"]
    catalogue.default = "faq-walker"


# --- damage


def test_a_stage_whose_speed_is_gone_does_not_come_back(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        host = held.open(StageSetup(clock="manual", actors=(AddActor("elbow"),)))
    emptied(tmp_path, "stages", "speed")
    with keeping(tmp_path, Catalogue()) as held:
        assert "the row that says what it is is damaged" in held.left[host.id]


def test_why_a_stage_did_not_come_back_names_no_folder(tmp_path: Path) -> None:
    mine = Path(shutil.copytree(shipped_machines_folder() / "elbow", tmp_path / "mine"))
    with keeping(tmp_path, Catalogue([mine])) as held:
        host = held.open(StageSetup(clock="manual", actors=(AddActor("mine"),)))
    (mine / "elbow.glb").write_bytes(b"nonsense")
    with keeping(tmp_path, Catalogue([mine])) as held:
        assert "did not come back: elbow.glb, byte 0: this is no glTF" in held.left[host.id]


DAMAGES = {
    "a line of its log": "UPDATE commands SET line = replace(line, 'FORWARD', 'STOP')",
    "a line that is gone": "DELETE FROM commands WHERE place = 2",
    "the text of its machine": "UPDATE roles SET text = replace(text, 'WALK', 'WELK')",
    "the end of its log": "DELETE FROM commands WHERE place = 4",
    "where its log ends": "UPDATE ends SET entries = 3",
    "its seed": "UPDATE stages SET seed = seed + 1",
    "its speed": "UPDATE stages SET speed = 8.0",
    "the hash of its state": "UPDATE stages SET hash = 'f' || hash",
    "its own row": "DELETE FROM stages",
    "the answer to a request": "UPDATE keys SET seq = seq + 1",
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_stage_is_not_shown_and_the_others_are(
    tmp_path: Path, catalogue: Catalogue, damage: str, caplog: pytest.LogCaptureFixture
) -> None:
    with keeping(tmp_path, catalogue) as held:
        bad, good = walked(held), held.open(StageSetup())
    damaged(
        tmp_path,
        f"{DAMAGES[damage]} {'AND' if 'WHERE' in DAMAGES[damage] else 'WHERE'} "
        f"{'id' if 'stages' in DAMAGES[damage] else 'stage'} = '{bad.id}'",
    )
    with keeping(tmp_path, catalogue) as held:
        assert [host.id for host in held.all()] == [good.id]
    assert f"the stage {bad.id} is not brought back" in caplog.text


def test_a_main_that_cannot_come_back_makes_room_for_a_new_one(tmp_path: Path, catalogue: Catalogue) -> None:
    """Its record stays, under another id."""
    with keeping(tmp_path, catalogue) as held:
        held.open_main()
    damaged(tmp_path, "UPDATE stages SET hash = 'f' || hash")
    with keeping(tmp_path, catalogue) as held:
        assert held.open_main().handle(ask.Status()).restored is None
        assert held.store is not None
        assert len(held.store.records.ids()) == 2


def test_a_damaged_snapshot_is_made_again_from_the_log(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        before = what_it_is(host)
    damaged(tmp_path, "UPDATE snapshots SET data = zeroblob(100)")
    with keeping(tmp_path, catalogue) as held:
        assert what_it_is(held.find(host.id)) == before


FORMATS = {1: to_format_1, 2: to_format_2, 3: to_format_3, 4: to_format_4}


@pytest.mark.parametrize("old", FORMATS)
def test_a_database_of_an_older_format_is_brought_up_to_date(
    tmp_path: Path, catalogue: Catalogue, old: int
) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        before, posted = what_it_is(host), host.handle(ask.Post((FORWARD,), key="once"))
    FORMATS[old](tmp_path / FILE_NAME)
    with keeping(tmp_path, catalogue) as held:
        host = held.find(host.id)
        again = host.handle(ask.Post((FORWARD,), key="once"))
        assert (again.seq, what_it_is(host)["hash"]) == (posted.seq, before["hash"])
        assert KeptRecords(tmp_path / FILE_NAME).damaged_snapshots(host.id) == []


def test_what_was_damaged_before_an_upgrade_is_found_after_it(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
    to_format_2(tmp_path / FILE_NAME)
    connection = sqlite3.connect(tmp_path / FILE_NAME)
    connection.execute("UPDATE roles SET text = replace(text, 'JUMP', 'JUMQ') WHERE stage = ?", (host.id,))
    connection.commit()
    connection.close()
    with keeping(tmp_path, catalogue) as held:
        assert "the text of faq-walker is damaged" in held.left[host.id]


# --- another engine


def raised_engine(monkeypatch: pytest.MonkeyPatch) -> None:
    """A version of statwalk whose engine has the next number."""
    monkeypatch.setattr(state_codec, "ENGINE", state_codec.ENGINE + 1)


def test_a_stage_that_the_next_engine_plays_alike_comes_back(
    tmp_path: Path, catalogue: Catalogue, monkeypatch: pytest.MonkeyPatch
) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        before = what_it_is(host)
    raised_engine(monkeypatch)
    with keeping(tmp_path, catalogue) as held:
        after = what_it_is(held.find(host.id))
    assert after == before


def test_a_stage_that_the_next_engine_plays_otherwise_is_refused_and_kept(
    tmp_path: Path, catalogue: Catalogue, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only the first ticks differ: the newest snapshot would hide it, if another engine took it over."""
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        before = what_it_is(host)
    with monkeypatch.context() as newer, planted("nudge", until=10):
        raised_engine(newer)
        with keeping(tmp_path, catalogue) as held, pytest.raises(UnknownNameError) as unknown:
            held.find(host.id)
    with keeping(tmp_path, catalogue) as held:  # the version that made it
        assert what_it_is(held.find(host.id)) == before
    assert f". {host.id} is kept, and did not come back: its log leads to another state" in str(unknown.value)
    assert "open it with the version that made it" in str(unknown.value)


# --- idempotency keys


def test_a_request_that_is_sent_again_counts_once(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        first = host.handle(ask.Post((FORWARD,), key="a"))
        assert host.handle(ask.Post((FORWARD,), key="a")).seq == first.seq
        before = what_it_is(host)
    with keeping(tmp_path, catalogue) as held:
        back = held.find(host.id)
        assert back.handle(ask.Post((FORWARD,), key="a")).seq == first.seq
        assert what_it_is(back) == before


def test_a_request_to_the_past_that_is_sent_again_makes_one_fork(
    tmp_path: Path, catalogue: Catalogue
) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        forks = {host.handle(ask.Post((JUMP,), at=100, key="b")).stage for _ in range(2)}
        assert len(forks) == 1
        assert len(held.all()) == 2


def test_an_input_to_the_past_and_its_key_are_one_commit(tmp_path: Path, catalogue: Catalogue) -> None:
    """A crash between two commits would leave the fork without its key: sent again, it would fork again."""
    with keeping(tmp_path, catalogue) as held:
        host, store = walked(held), held.store
        assert store is not None
        before = store.writer.put(())
        host.handle(ask.Post((JUMP,), at=100, key="b"))
        assert store.writer.put(()) == before + 2


def test_of_two_copies_of_a_request_one_waits(tmp_path: Path, catalogue: Catalogue) -> None:
    """The first is on its way to a fork, which may take long."""
    with keeping(tmp_path, catalogue) as held:
        host, post = walked(held), ask.Post((JUMP,), at=100, key="b")
        assert host._live.keys is not None
        with host._live.keys.reserved(post), pytest.raises(BusyError, match="under way"):
            host.handle(post)
        fork = host.handle(post).stage
        assert host.handle(post).stage == fork


def test_the_oldest_keys_are_forgotten_first_after_a_start_too(
    tmp_path: Path, catalogue: Catalogue, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(kept_keys, "MOST_KEYS", 2)
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        first, second = (host.handle(ask.Post((FORWARD,), key=key)).seq for key in ("z", "a"))
    with keeping(tmp_path, catalogue) as held:
        back = held.find(host.id)
        back.handle(ask.Post((FORWARD,), key="m"))
        assert back.handle(ask.Post((FORWARD,), key="a")).seq == second
        assert back.handle(ask.Post((FORWARD,), key="z")).seq > first


def test_a_key_of_another_request_is_refused(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = walked(held)
        post = ask.Post((FORWARD,), key="c")
        host.handle(post)
        with pytest.raises(ConflictError, match="belongs to another request"):
            host.handle(replace(post, commands=(JUMP,)))
