"""An edit that is sent again with its Idempotency-Key counts once, also after a new start."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import httpx
from serving import PATIENCE, serving
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

MINE = "/api/machines/mine"
MORE = {"operations": [{"kind": "add_state", "state": "MORE"}]}


@contextmanager
def opened(folder: Path) -> Iterator[httpx.Client]:
    """A client of a server in this process that keeps everything in a folder."""
    app = create_app(Settings(main_stage=False, data=folder, kept=folder))
    with serving(app) as address, httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as client:
        yield client


def headers(key: str, version: int = 1) -> dict[str, str]:
    return {"If-Match": str(version), "Idempotency-Key": key}


def add_state(client: httpx.Client, key: str) -> httpx.Response:
    return client.patch(MINE, json=MORE, headers=headers(key))


def versions(client: httpx.Client) -> list[int]:
    return [version["version"] for version in client.get(f"{MINE}/versions").json()]


def test_again_it_gets_the_first_answer_also_after_a_start(tmp_path: Path) -> None:
    with opened(tmp_path) as client:
        client.post("/api/machines", json={"name": "mine"})
        first = add_state(client, "one")
        assert add_state(client, "one").json() == first.json()
    with opened(tmp_path) as later:
        again = add_state(later, "one")
        assert (again.status_code, again.json()["version"]) == (200, 2)
        assert versions(later) == [1, 2]


def test_without_a_key_it_is_refused(tmp_path: Path) -> None:
    """The control."""
    with opened(tmp_path) as client:
        client.post("/api/machines", json={"name": "mine"})
        add_state(client, "")
        assert add_state(client, "").status_code == 412


def test_it_counts_when_the_server_ended_between_the_file_and_its_version(tmp_path: Path) -> None:
    with opened(tmp_path) as client:
        client.post("/api/machines", json={"name": "mine"})
        add_state(client, "one")
    with closing(sqlite3.connect(tmp_path / FILE_NAME)) as database, database:
        database.execute("DELETE FROM versions WHERE number = 2")
    with opened(tmp_path) as later:
        assert add_state(later, "one").status_code == 200
        assert versions(later) == [1, 2]


def test_an_edit_that_came_to_nothing_is_made(tmp_path: Path) -> None:
    with opened(tmp_path) as client:
        client.patch("/api/machines/faq-walker", json=MORE, headers=headers("one"))
    with closing(sqlite3.connect(tmp_path / FILE_NAME)) as database, database:
        database.execute("DELETE FROM versions")
    with opened(tmp_path) as later:
        again = later.patch("/api/machines/faq-walker", json=MORE, headers=headers("one"))
        assert "MORE" in again.json()["table"]


def test_put_undo_redo_and_restore_count_once(tmp_path: Path) -> None:
    with opened(tmp_path) as client:
        made = client.post("/api/machines", json={"name": "mine"}).json()
        text = {"text": made["text"] + "# more\n", "tables": made["tables"]}
        for version, (method, path, body) in enumerate(
            [
                ("PUT", MINE, text),
                ("POST", f"{MINE}/undo", None),
                ("POST", f"{MINE}/redo", None),
                ("POST", f"{MINE}/versions/1/restore", None),
            ],
            start=1,
        ):
            key = headers(f"key {version}", version)
            answers = [client.request(method, path, json=body, headers=key) for _ in range(2)]
            assert [(one.status_code, one.json().get("version")) for one in answers] == [
                (200, version + 1)
            ] * 2


def test_a_key_of_another_edit_is_a_conflict(tmp_path: Path) -> None:
    with opened(tmp_path) as client:
        client.post("/api/machines", json={"name": "mine"})
        add_state(client, "one")
        assert client.post(f"{MINE}/undo", headers=headers("one", 2)).status_code == 409
