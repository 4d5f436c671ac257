"""The data folder: what is damaged, unfinished or unused does no harm and does not stay."""

import errno
import os
import time
from contextlib import suppress
from pathlib import Path

import pytest
import tiny_model
from refusing_files import RefusingFiles
from statwalk.errors import ContentError
from statwalk.services.library.model_store import LEFTOVER_SECONDS, ModelStore, UploadedCharacter
from statwalk.services.library.upload_sandbox import checked_beside

SHA = {b"one": "7692c3ad3540bb803c020b3aee66cd8887123234ea0c6e7143c0add73ff431ed"}


@pytest.fixture
def store(tmp_path: Path) -> ModelStore:
    return ModelStore(tmp_path)


def keep(store: ModelStore, name: str, content: bytes) -> UploadedCharacter:
    with store.working() as folder:
        (folder / "model").write_bytes(content)
        return store.keep(name, folder / "model")


def keep_machine(store: ModelStore, name: str, sha256: str) -> None:
    with store.working() as written:
        (written / "machine.yaml").write_text(f"character: ../../characters/{sha256}.glb")
        store.keep_machine(name, written)


def test_it_is_made_when_something_is_kept(tmp_path: Path) -> None:
    store = ModelStore(tmp_path / "data")
    assert (store.characters(), store.machine_folders(), (tmp_path / "data").exists()) == ({}, [], False)
    keep(store, "a", b"one")
    assert list(store.characters()) == ["a"]


def test_a_model_is_called_by_its_content(store: ModelStore) -> None:
    assert keep(store, "a", b"one") == UploadedCharacter("a", SHA[b"one"], 3)
    assert store.model(SHA[b"one"]).read_bytes() == b"one"


def test_two_names_of_one_content(store: ModelStore) -> None:
    first, second = keep(store, "a", b"one"), keep(store, "b", b"one")
    store.forget("a")
    assert list(store.characters()) == ["b"]
    assert first.sha256 == second.sha256
    store.forget("b")
    assert list(store.models.iterdir()) == []


def test_a_model_stays_as_long_as_a_machine_is_made_of_it(store: ModelStore) -> None:
    kept = keep(store, "a", b"one")
    keep_machine(store, "robot", kept.sha256)
    keep(store, "a", b"two")
    assert (store.machines_of(kept.sha256), store.model(kept.sha256).exists()) == (["robot"], True)
    store.forget_machine("robot")
    assert not store.model(kept.sha256).exists()


def test_nothing_unfinished_stays(store: ModelStore) -> None:
    keep_machine(store, "robot", keep(store, "a", b"one").sha256)
    assert list(store.unfinished.iterdir()) == []


def test_what_a_killed_server_left_goes_after_an_hour(store: ModelStore) -> None:
    for name, age in (("old", LEFTOVER_SECONDS + 60), ("new", 0)):
        (store.unfinished / name).mkdir(parents=True)
        os.utime(store.unfinished / name, (time.time() - age,) * 2)
    ModelStore(store.folder)
    assert [path.name for path in store.unfinished.iterdir()] == ["new"]


@pytest.mark.parametrize(
    "record",
    ["", "{", "[]", '{"sha256": "../x", "bytes": 3}', '{"sha256": null, "bytes": "x"}', '{"bytes": 3}'],
)
def test_a_damaged_record_is_no_character(store: ModelStore, record: str) -> None:
    keep(store, "a", b"one")
    (store.names / "a.json").write_text(record)
    assert (store.find("a"), store.characters()) == (None, {})


@pytest.mark.parametrize("name", ["..", "../names/a", "a.b", "", "a/b", "a\0b"])
def test_no_name_leads_elsewhere(store: ModelStore, name: str) -> None:
    assert store.find(name) is None


def test_what_goes_while_old_files_are_swept_does_not_matter(store: ModelStore) -> None:
    store.unfinished.mkdir(parents=True)
    (store.unfinished / "gone").symlink_to("nowhere")  # listed, and not there when it is looked at
    store.sweep(0)


def test_a_model_that_was_deleted_is_told_in_words(store: ModelStore) -> None:
    kept = keep(store, "a", b"one")
    store.forget("a")
    with pytest.raises(ContentError, match="deleted while the server worked on it"):
        store.character(kept.sha256)


def test_an_archive_that_is_gone_or_damaged_is_made_again(store: ModelStore) -> None:
    kept = keep(store, "a", tiny_model.model())
    archive = checked_beside(store.model(kept.sha256))
    assert not archive.exists()
    assert store.character(kept.sha256).skeleton.names == ("hip", "knee", "skin")
    archive.write_bytes(b"no archive")
    assert store.character(kept.sha256).skeleton.names == ("hip", "knee", "skin")


def test_the_archive_goes_with_its_model(store: ModelStore) -> None:
    kept = keep(store, "a", tiny_model.model())
    store.character(kept.sha256)
    store.forget("a")
    assert list(store.models.iterdir()) == []


@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EIO], ids=errno.errorcode.__getitem__)
def test_a_disk_that_refuses_leaves_the_old_character_or_the_new_one(
    store: ModelStore, monkeypatch: pytest.MonkeyPatch, code: int
) -> None:
    old, files = keep(store, "a", b"one"), RefusingFiles(monkeypatch, store.folder)
    for nth in range(100):
        files.refuse(code, nth)
        with suppress(OSError):
            keep(store, "a", b"two")
        files.work()
        if not files.refused:
            break
        assert [store.model(found.sha256).read_bytes() for found in store.characters().values()] in (
            [b"one"],
            [b"two"],
        )
        assert list(store.unfinished.iterdir()) == []
    assert nth > 3
    assert not store.model(old.sha256).exists()
