"""What you may do, and links to one stage, on a server with tokens: over HTTP and over the socket."""

from collections.abc import Iterator
from typing import Any

import httpx
import pytest
from serving import PATIENCE, serving, wait_for
from statwalk.services.access.access_file import AccessFile
from statwalk.services.access.authenticator import Authenticator
from statwalk.web.app import create_app
from statwalk.web.settings import Settings
from watcher import Watcher
from websockets.exceptions import ConnectionClosed, InvalidStatus

MAIN = "/api/stages/main"


class Shared:
    """A server with tokens, and a client for each of them."""

    def __init__(self, address: str, file: AccessFile) -> None:
        self.address, self.file = address, file
        self.tokens = {role: file.add(role, role) for role in ("view", "drive", "admin")}

    def rest(self, token: str) -> httpx.Client:
        headers = {"authorization": f"Bearer {token}"}
        return httpx.Client(base_url=f"http://{self.address}", headers=headers, timeout=PATIENCE)

    def link(self, role: str, stage: str = MAIN, **more: Any) -> tuple[str, str]:
        """The address and the token of a new link."""
        with self.rest(self.tokens["drive"]) as rest:
            made = rest.post(f"{stage}/links", json={"role": role, **more}).raise_for_status()
        return made.headers["location"], made.json()["url"].partition("token=")[2]

    def watch(self, token: str, stage: str = MAIN) -> Watcher:
        return Watcher(self.address, stage, additional_headers={"authorization": f"Bearer {token}"})


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shared]:
    file = AccessFile(tmp_path_factory.mktemp("data"))
    with serving(create_app(Settings(authenticator=Authenticator(file)))) as address:
        yield Shared(address, file)


def test_you_are_told_what_you_may_do(shared: Shared) -> None:
    _, link = shared.link("view")
    told = []
    for token in (*shared.tokens.values(), link):
        with shared.rest(token) as rest:
            told.append(rest.get("/api/access").json())
    assert [(one["role"], one["stage"]) for one in told] == [
        ("view", None),
        ("drive", None),
        ("admin", None),
        ("view", "main"),
    ]
    assert all(one["token_needed"] for one in told)


def test_a_link_is_listed_without_its_token(shared: Shared) -> None:
    location, token = shared.link("view", seconds=90)
    with shared.rest(shared.tokens["admin"]) as rest:
        listed = rest.get(f"{MAIN}/links")
    (link,) = (link for link in listed.json() if location.endswith(link["id"]))
    assert (link["role"], link["maker"]) == ("view", "drive")
    assert 80 < link["seconds_left"] <= 90
    assert token not in listed.text


def test_a_link_shows_what_plays_on_its_stage_and_nothing_else(shared: Shared) -> None:
    _, token = shared.link("view")
    with shared.rest(token) as rest:
        machine = rest.get(MAIN).json()["actors"][0]["machine"]
        shown = [f"/api/machines/{machine}", "/api/characters/walker", f"{MAIN}/frame.glb"]
        hidden = ["/api/machines/tentacle", "/api/characters/tentacle", "/api/machines", "/api/stages"]
        assert [rest.get(path).status_code for path in shown] == [200] * 3
        assert [rest.get(path).status_code for path in hidden] == [403] * 4


def test_a_link_makes_no_link(shared: Shared) -> None:
    _, token = shared.link("drive")
    with shared.rest(token) as rest:
        assert rest.post(f"{MAIN}/links", json={}).status_code == 403


@pytest.mark.parametrize("body", [{"role": "admin"}, {"seconds": 0}, {"seconds": 10**9}, {"x": 1}])
def test_a_link_that_may_not_be(shared: Shared, body: dict) -> None:
    with shared.rest(shared.tokens["admin"]) as rest:
        assert rest.post(f"{MAIN}/links", json=body).status_code == 422


def test_a_viewer_looks_and_does_not_drive(shared: Shared) -> None:
    for token in (shared.tokens["view"], shared.link("view")[1]):
        with shared.watch(token) as viewer, shared.rest(token) as rest:
            viewer.frame()
            viewer.say(type="event", event="FORWARD", ref=1)
            error = viewer.text("error")
            assert (error["status"], error["ref"]) == (403, 1)
            assert "you may only look" in error["detail"]
            viewer.say(type="set", parameter="x", value=1.0, ref=2)
            assert viewer.text("error")["status"] == 403
            assert rest.post(f"{MAIN}/events", json={"event": "FORWARD"}).status_code == 403
            viewer.say(type="look", tick=0)
            assert viewer.frame_at(0).tick == 0


def test_a_driver_drives(shared: Shared) -> None:
    for token in (shared.tokens["drive"], shared.link("drive")[1]):
        with shared.watch(token) as viewer:
            viewer.say(type="event", event="FORWARD", ref=1)
            assert viewer.text("accepted")["ref"] == 1


def closed_with(viewer: Watcher) -> int:
    with pytest.raises(ConnectionClosed) as closed:
        viewer.text("nothing")
    assert closed.value.rcvd is not None
    return closed.value.rcvd.code


def test_a_revoked_link_ends_its_sockets_at_once(shared: Shared) -> None:
    location, token = shared.link("drive")
    with shared.watch(token) as viewer, shared.rest(shared.tokens["admin"]) as rest:
        viewer.frame()
        assert rest.delete(location).status_code == 204
        assert closed_with(viewer) == 4001
        assert rest.delete(location).status_code == 404
    with pytest.raises(InvalidStatus) as refused:
        shared.watch(token)
    assert refused.value.response.status_code == 401


def test_a_link_ends_by_itself(shared: Shared) -> None:
    _, token = shared.link("view", seconds=4)
    with shared.watch(token) as viewer:
        assert closed_with(viewer) == 4001


def test_who_is_revoked_on_the_command_line_is_out(shared: Shared) -> None:
    token = AccessFile(shared.file.path.parent).add("gone", "drive")
    with shared.watch(token) as viewer, shared.rest(token) as rest:
        viewer.frame()
        assert rest.get(MAIN).status_code == 200
        AccessFile(shared.file.path.parent).revoke("gone")
        assert rest.get(MAIN).status_code == 401
        assert closed_with(viewer) == 4001


def test_a_link_to_a_closed_stage_is_no_link(shared: Shared) -> None:
    with shared.rest(shared.tokens["drive"]) as rest:
        stage = rest.post("/api/stages", json={"clock": "manual"}).headers["location"]
        _, token = shared.link("view", stage)
        rest.delete(stage)
    with shared.rest(token) as rest:
        wait_for(lambda: rest.get("/api/access").status_code == 401)


def test_without_tokens_there_are_no_links(address: str, rest: httpx.Client) -> None:
    assert rest.get("/api/access").json() == {
        "token_needed": False,
        "name": "",
        "role": "admin",
        "stage": None,
    }
    assert rest.post(f"{MAIN}/links", json={}).status_code == 409


def test_viewers_see_roles_and_whose_token_it_is(shared: Shared) -> None:
    """Who may only look says a name too; the viewer of a link is no person."""
    _, link = shared.link("drive")
    with shared.watch(shared.tokens["view"]) as looker, shared.watch(link):
        looker.say(type="name", name="Lou")
        looker.say(type="ping", ref=1)
        assert looker.text("pong")["ref"] == 1
        with shared.rest(shared.tokens["view"]) as rest:
            seen = rest.get(f"{MAIN}/viewers").json()
    assert [(one["name"], one["person"], one["role"]) for one in seen] == [
        ("Lou", "view", "view"),
        ("", "", "drive"),
    ]


def test_a_person_without_a_viewer_is_told_by_name(shared: Shared) -> None:
    with shared.rest(shared.tokens["drive"]) as rest:
        changed = rest.post(f"{MAIN}/speed", json={"speed": 1}).json()["changed"]
    assert (changed["by"], changed["viewer"]) == ("drive", None)
