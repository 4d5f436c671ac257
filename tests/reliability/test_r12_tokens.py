"""R-12 with tokens: on every route, for static files and the socket, only a token that counts lets a request
in, and only as far as its role goes. The control: without an authenticator the same requests get through.
"""

import asyncio
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from live_routes import SOCKET, Asked, ask, filled, live_routes
from statwalk.services.access.access_file import AccessFile
from statwalk.services.access.authenticator import Authenticator
from statwalk.services.access.roles import ACCESS_ROLES, AccessRole, digest_of
from statwalk.web.app import create_app
from statwalk.web.needed_roles import NEEDED_ROLES, NO_ROLE, need_of
from statwalk.web.settings import Settings

HOST = ("host", "localhost:8000")
OWN = ("origin", "http://localhost:8000")
STATIC = [("GET", path) for path in ("/", "/index.html", "/assets/a-1.js", "/missing.txt", "/api/missing")]
OPEN = {operation.split()[1] for operation in NO_ROLE}
Pairs = Sequence[tuple[str, str]]
Request = tuple[str, str]


class Served:
    """An application with tokens, and one of each role."""

    def __init__(self, folder: Path) -> None:
        page = folder / "page"
        (page / "assets").mkdir(parents=True)
        (page / "index.html").write_text("<!doctype html><title>page</title>")
        (page / "assets" / "a-1.js").write_text("export {};")
        file = AccessFile(folder)
        self.tokens = {role: file.add(f"a-{role}", role) for role in ACCESS_ROLES}
        self.authenticator = Authenticator(file, with_start_token=True)
        settings = Settings(main_stage=False, page=page, authenticator=self.authenticator)
        self.app: Any = create_app(settings)
        self.open: Any = create_app(Settings(main_stage=False, page=page))
        self.templates = live_routes(self.app)
        names = [(method, filled(path, "nobody", "nobody")) for method, path in self.templates]
        self.requests: list[Request] = names + STATIC

    def link(self, role: AccessRole, stage: str = "nobody", seconds: float = 60.0) -> str:
        now = time.monotonic()
        maker = self.authenticator.grant_of(self.tokens["admin"], now)
        assert maker
        return self.authenticator.links.make(stage, role, seconds, maker, now)[1]


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Served:
    return Served(tmp_path_factory.mktemp("served"))


def all_answers(app: Any, requests: Sequence[Request], headers: Pairs) -> dict[Request, Asked]:
    async def run() -> dict[Request, Asked]:
        return {request: await ask(app, *request, headers) for request in requests}

    return asyncio.run(run())


def bearer(token: str) -> Pairs:
    return [HOST, ("authorization", f"Bearer {token}")]


def cookie(token: str, name: str = "statwalk_8000") -> Pairs:
    return [HOST, ("cookie", f"other=1; {name}={token}")]


def refused(served: Served) -> dict[str, Pairs]:
    """Requests without a token that counts."""
    token = served.authenticator.start_token
    flipped = token[:-1] + ("A" if token[-1] != "A" else "B")
    return {
        "nothing": [HOST],
        "own page": [HOST, OWN],
        "an empty token": bearer(""),
        "another token": bearer("x" * len(token)),
        "one letter wrong": bearer(flipped),
        "one letter more": bearer(token + "A"),
        "one letter less": bearer(token[:-1]),
        "not ASCII": bearer("\xe9" * 43),
        "64 kilobytes": bearer("x" * 65_000),
        "another scheme": [HOST, ("authorization", f"Basic {token}")],
        "the cookie of another port": cookie(token, "statwalk_8001"),
        "a cookie of another name": cookie(token, "__Host-statwalk_8000"),
        "a wrong cookie": [*cookie(flipped), OWN],
        "a wrong header beside a good cookie": [*cookie(token), ("authorization", "Bearer x")],
        "a link whose time is over": bearer(served.link("drive", seconds=0.0)),
        "the hash instead of the token": bearer(digest_of(token)),
    }


def test_without_a_token_no_route_answers(served: Served) -> None:
    for name, headers in refused(served).items():
        asked = [request for request in served.requests if request[1] not in OPEN]
        answers = all_answers(served.app, asked, headers)
        assert {found.status for found in answers.values()} == {401}, name
        assert len({found.body for found in answers.values()}) == 1, name
        for found in answers.values():
            assert found.headers["content-type"] == "application/problem+json"
            assert found.headers["www-authenticate"].startswith("Bearer")
            assert "set-cookie" not in found.headers


def test_control_without_an_authenticator_the_same_requests_get_through(served: Served) -> None:
    for row, (name, headers) in enumerate(refused(served).items()):
        through = all_answers(served.open, served.requests[row % 4 :: 4], headers)
        assert 401 not in {found.status for found in through.values()}, name


def test_a_token_in_the_address_counts_only_at_the_page(served: Served) -> None:
    query = f"token={served.authenticator.start_token}"
    for method, path in served.requests:
        if path not in ("/", "/index.html", *OPEN):
            assert asyncio.run(ask(served.app, method, path, [HOST], query=query)).status == 401


def test_every_route_answers_an_admin(served: Served) -> None:
    for headers in (
        bearer(served.tokens["admin"]),
        bearer(served.authenticator.start_token),
        [*cookie(served.tokens["admin"]), OWN],
    ):
        answers = all_answers(served.app, served.requests, headers)
        assert {name for name, found in answers.items() if found.status in (401, 403, 421, 500)} == set()


def test_a_token_helps_no_foreign_page(served: Served) -> None:
    """A browser adds the cookie to what another port of this host asks for."""
    evil = [*cookie(served.tokens["admin"]), ("origin", "http://localhost:9999")]
    site = [*cookie(served.tokens["admin"]), ("sec-fetch-site", "same-site")]
    host = [("host", "evil.example"), ("authorization", f"Bearer {served.tokens['admin']}")]
    for headers, status in ((evil, 403), (site, 403), (host, 421)):
        answers = all_answers(served.app, served.requests, headers)
        assert {found.status for found in answers.values()} == {status}


def test_a_socket_with_a_cookie_needs_an_origin(served: Served) -> None:
    (path,) = (path for method, path in served.requests if method == SOCKET)
    token = served.tokens["view"]
    answers = [
        asyncio.run(ask(served.app, SOCKET, path, headers)).status
        for headers in (cookie(token), [*cookie(token), OWN], bearer(token))
    ]
    assert answers == [403, 404, 404]  # 404: it looks for the stage, and there is none


# --- the table of roles


def test_every_route_has_its_row(served: Served) -> None:
    live = {f"{method} {path}" for method, path in served.templates} - {"GET /"}
    assert live - NEEDED_ROLES.keys() == set()
    assert NEEDED_ROLES.keys() - live <= {*NO_ROLE, "GET /metrics"}


def test_a_request_gets_the_need_of_its_route(served: Served) -> None:
    for method, path in served.templates:
        if path != "/":
            need = need_of(method, filled(path))
            assert need.role == NEEDED_ROLES[f"{method} {path}"]
            assert need.stage == ("main" if "{stage_id}" in path else None)


def level(role: AccessRole | None) -> int:
    return -1 if role is None else ACCESS_ROLES.index(role)


@pytest.mark.parametrize("role", ACCESS_ROLES)
def test_no_role_reaches_further(served: Served, role: AccessRole) -> None:
    answers = all_answers(served.app, served.requests, bearer(served.tokens[role]))
    wanted = {request for request in served.requests if level(need_of(*request).role) > level(role)}
    assert {request for request, found in answers.items() if found.status == 403} == wanted
    assert {found.status for found in answers.values()} & {401, 421, 500} == set()
    assert all("you may only" in answers[request].text for request in wanted)


def test_what_changes_something_needs_more_than_looking() -> None:
    """Three requests with a body only compute."""
    computing = {"POST /api/characters/{name}/solve", "POST /api/curves", "POST /api/deduce"}
    looking = {row for row, role in NEEDED_ROLES.items() if role in ("view", None)}
    assert {row for row in looking if not row.startswith(("GET ", SOCKET))} == computing


def test_unknown_addresses_need_the_most() -> None:
    assert need_of("GET", "/api/new").role == "admin"
    assert need_of("POST", "/anything").role == "admin"
    assert need_of("GET", "/assets/a-1.js").role == "view"


def test_health_is_open_and_only_to_look(served: Served) -> None:
    for row in NO_ROLE:
        method, path = row.split()
        assert asyncio.run(ask(served.app, method, path, [HOST])).status != 401
        assert asyncio.run(ask(served.app, "POST", path, [HOST])).status == 401


# --- links to one stage


def test_a_link_reaches_its_stage_and_what_plays_there(served: Served) -> None:
    answers = all_answers(served.app, served.requests, bearer(served.link("drive", "nobody")))
    reached = {request for request, found in answers.items() if found.status != 403}
    changing = {path for method, path in reached if method not in ("GET", SOCKET)}
    assert all(path.startswith("/api/stages/nobody/") for path in changing)
    kept = {("GET", "/api/machines"), ("GET", "/api/stages"), ("DELETE", "/api/stages/nobody")}
    assert kept & reached == set()
    assert {("GET", "/"), ("GET", "/api/stages/nobody"), ("POST", "/api/stages/nobody/events")} <= reached


def test_a_link_reaches_no_other_stage(served: Served) -> None:
    of_a_stage = [request for request in served.requests if "/stages/nobody" in request[1]]
    assert len(of_a_stage) > 20
    answers = all_answers(served.app, of_a_stage, bearer(served.link("drive", "other")))
    assert {found.status for found in answers.values()} == {403}
