"""The file of people: who may read it, what is in it, and what is refused."""

import json
import stat
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from statwalk.errors import ConflictError, ContentError, LimitError, UnknownNameError
from statwalk.services.access import access_file
from statwalk.services.access.access_file import AccessFile, Person
from statwalk.services.access.roles import digest_of


def test_a_folder_without_the_file_has_nobody(tmp_path: Path) -> None:
    assert AccessFile(tmp_path / "new").people() == ()


def test_the_file_holds_hashes_that_only_its_owner_can_read(tmp_path: Path) -> None:
    file = AccessFile(tmp_path / "new")
    token = file.add("ada", "drive")
    assert len(token) == 43  # 256 bits
    assert stat.S_IMODE(file.path.stat().st_mode) == 0o600
    assert token not in file.path.read_text()
    assert file.people() == (Person("ada", "drive", digest_of(token)),)


def test_a_change_by_another_process_is_seen_at_once(tmp_path: Path) -> None:
    server, command = AccessFile(tmp_path), AccessFile(tmp_path)
    for name in ("ada", "bob"):
        command.add(name, "view")
    assert [person.name for person in server.people()] == ["ada", "bob"]
    command.revoke("ada")
    assert [person.name for person in server.people()] == ["bob"]


def test_two_that_add_at_once_lose_nobody(tmp_path: Path) -> None:
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda number: AccessFile(tmp_path).add(f"p{number}", "view"), range(24)))
    assert len(AccessFile(tmp_path).people()) == 24


def test_what_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = AccessFile(tmp_path)
    file.add("ada", "view")
    with pytest.raises(ConflictError, match="revoke it first"):
        file.add("ada", "admin")
    with pytest.raises(UnknownNameError):
        file.revoke("bob")
    for name in ("", "a b", "../x", "<b>", "x" * 65):
        with pytest.raises(ContentError):
            file.add(name, "view")
    monkeypatch.setattr(access_file, "MOST_PEOPLE", 1)
    with pytest.raises(LimitError):
        file.add("bob", "view")


WRONG = {
    "no JSON": "{",
    "no object": "[]",
    "no people": "{}",
    "an unknown role": '{"people": [{"name": "a", "role": "root", "digest": "%s"}]}' % ("0" * 64),
    "a token instead of its hash": '{"people": [{"name": "a", "role": "view", "digest": "token"}]}',
    "an unknown member": '{"people": [{"name": "a", "role": "view", "digest": "%s", "x": 1}]}' % ("0" * 64),
    "deep": "[" * 100_000,
}


@pytest.mark.parametrize("text", WRONG.values(), ids=WRONG)
def test_a_file_that_is_no_list_of_people_lets_nobody_in(tmp_path: Path, text: str) -> None:
    file = AccessFile(tmp_path)
    file.add("ada", "admin")
    file.path.write_text(text)
    with pytest.raises(ContentError, match=r"access\.json"):
        file.people()
    assert file.people_or_nobody() == ()


def test_a_file_that_others_may_read_lets_nobody_in(tmp_path: Path) -> None:
    file = AccessFile(tmp_path)
    file.add("ada", "admin")
    file.path.chmod(0o644)
    with pytest.raises(ContentError, match="chmod 600"):
        file.people()
    assert file.people_or_nobody() == ()


def test_an_unfinished_write_of_a_crash_stands_in_no_ones_way(tmp_path: Path) -> None:
    file = AccessFile(tmp_path)
    (tmp_path / "access.new").write_text("half")
    file.add("ada", "view")
    assert json.loads(file.path.read_text())["people"][0]["name"] == "ada"
