"""The data folder: what is damaged, unfinished or unused does no harm and does not stay."""

import os
import time
from pathlib import Path

import pytest
from statwalk.web.keeping.depot import LEFTOVER_SECONDS, Depot, Kept

SHA = {b"one": "7692c3ad3540bb803c020b3aee66cd8887123234ea0c6e7143c0add73ff431ed"}


@pytest.fixture
def depot(tmp_path: Path) -> Depot:
    return Depot(tmp_path)


def keep(depot: Depot, name: str, content: bytes) -> Kept:
    with depot.working() as folder:
        (folder / "model").write_bytes(content)
        return depot.keep(name, folder / "model")


def keep_machine(depot: Depot, name: str, sha256: str) -> None:
    with depot.working() as written:
        (written / "machine.yaml").write_text(f"character: ../../characters/{sha256}.glb")
        depot.keep_machine(name, written)


def test_it_is_made_when_something_is_kept(tmp_path: Path) -> None:
    depot = Depot(tmp_path / "data")
    assert (depot.characters(), depot.machine_folders(), (tmp_path / "data").exists()) == ({}, [], False)
    keep(depot, "a", b"one")
    assert list(depot.characters()) == ["a"]


def test_a_model_is_called_by_its_content(depot: Depot) -> None:
    assert keep(depot, "a", b"one") == Kept("a", SHA[b"one"], 3)
    assert depot.model(SHA[b"one"]).read_bytes() == b"one"


def test_two_names_of_one_content(depot: Depot) -> None:
    first, second = keep(depot, "a", b"one"), keep(depot, "b", b"one")
    depot.forget("a")
    assert list(depot.characters()) == ["b"]
    assert first.sha256 == second.sha256
    depot.forget("b")
    assert list(depot.models.iterdir()) == []


def test_a_model_stays_as_long_as_a_machine_is_made_of_it(depot: Depot) -> None:
    kept = keep(depot, "a", b"one")
    keep_machine(depot, "robot", kept.sha256)
    keep(depot, "a", b"two")
    assert (depot.machines_of(kept.sha256), depot.model(kept.sha256).exists()) == (["robot"], True)
    depot.forget_machine("robot")
    assert not depot.model(kept.sha256).exists()


def test_nothing_unfinished_stays(depot: Depot) -> None:
    keep_machine(depot, "robot", keep(depot, "a", b"one").sha256)
    assert list(depot.unfinished.iterdir()) == []


def test_what_a_killed_server_left_goes_after_an_hour(depot: Depot) -> None:
    for name, age in (("old", LEFTOVER_SECONDS + 60), ("new", 0)):
        (depot.unfinished / name).mkdir(parents=True)
        os.utime(depot.unfinished / name, (time.time() - age,) * 2)
    Depot(depot.folder)
    assert [path.name for path in depot.unfinished.iterdir()] == ["new"]


@pytest.mark.parametrize("record", ["", "{", "[]", '{"sha256": "../x", "bytes": 3}', '{"sha256": null, "bytes": "x"}', '{"bytes": 3}'])
def test_a_damaged_record_is_no_character(depot: Depot, record: str) -> None:
    keep(depot, "a", b"one")
    (depot.names / "a.json").write_text(record)
    assert (depot.find("a"), depot.characters()) == (None, {})


@pytest.mark.parametrize("name", ["..", "../names/a", "a.b", "", "a/b", "a\0b"])
def test_no_name_leads_elsewhere(depot: Depot, name: str) -> None:
    assert depot.find(name) is None
