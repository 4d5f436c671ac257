"""R-12: foreign web pages cannot reach the server: every row of the matrix on every route, on static files
and on the socket. The control: without the guard the same requests get through.
"""

import asyncio
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import pytest
from live_routes import SOCKET, Asked, ask, filled, live_routes, unguarded
from statwalk.web.app import create_app
from statwalk.web.same_origin import PAGES
from statwalk.web.security_headers import SECURITY_HEADERS
from statwalk.web.settings import Settings

HOST = ("host", "localhost:8000")
OWN = ("origin", "http://localhost:8000")
STATIC = [("GET", path) for path in ("/", "/index.html", "/assets/a-1.js", "/missing.txt", "/api/missing")]
SAFE = {"GET", "HEAD", "OPTIONS", SOCKET}
Pairs = Sequence[tuple[str, str]]

FOREIGN_HOSTS: dict[str, Pairs] = {
    host: [("host", host)]
    for host in (
        "evil.example",
        "evil.example:8000",
        "127.0.0.1.evil.example",
        "localhost.evil.example",
        "127.0.0.1@evil",
        "127.0.0.1:8000@evil",
        "evil@127.0.0.1",
        "localhost:port",
        "localhost:",
        "localhost:8000:8000",
        "localhost, evil.example",
        "localhost/",
        " localhost",
        "",
        "[::1",
        "::1",
        "[::ffff:127.0.0.1]",
        "0.0.0.0:8000",
        "2130706433",
        "0x7f.1",
    )
} | {
    "no Host": [],
    "two Hosts": [HOST, HOST],
    "two Hosts, one foreign": [HOST, ("host", "evil.example")],
    "X-Forwarded-Host": [("host", "evil.example"), ("x-forwarded-host", "localhost")],
    "Forwarded": [("host", "evil.example"), ("forwarded", "host=localhost")],
}
FOREIGN_ORIGINS: dict[str, Pairs] = {
    origin: [HOST, ("origin", origin)]
    for origin in (
        "https://evil.example",
        "null",
        "http://localhost:9999",
        "http://localhost",
        "https://localhost",
        "http://127.0.0.1:8000",
        "http://localhost.evil.example:8000",
        "http://evil.example/localhost:8000",
        "http://localhost:8000.evil.example",
        "http://localhost:8000@evil.example",
        "http://evil@localhost:8000",
        "http://localhost:8000/",
        "localhost:8000",
        "file://localhost:8000",
        "chrome-extension://localhost:8000",
        "",
    )
} | {"two Origins": [HOST, OWN, OWN]}
FOREIGN_SITES: dict[str, Pairs] = {
    f"{site}, {mode}, {dest}": [
        HOST,
        ("sec-fetch-site", site),
        ("sec-fetch-mode", mode),
        ("sec-fetch-dest", dest),
    ]
    for site in ("cross-site", "same-site")
    for mode, dest in (
        ("no-cors", "image"),
        ("no-cors", "script"),
        ("no-cors", "empty"),
        ("cors", "empty"),
        ("websocket", "websocket"),
        ("navigate", "iframe"),
        ("navigate", "object"),
        ("navigate", "document"),
    )
} | {
    "an unknown site": [HOST, ("sec-fetch-site", "elsewhere")],
    "two sites": [HOST, ("sec-fetch-site", "none"), ("sec-fetch-site", "cross-site")],
    "only the site": [HOST, ("sec-fetch-site", "cross-site")],
}
REFUSED = (
    [pytest.param(421, row, id=f"Host {name!r}") for name, row in FOREIGN_HOSTS.items()]
    + [pytest.param(403, row, id=f"Origin {name!r}") for name, row in FOREIGN_ORIGINS.items()]
    + [pytest.param(403, row, id=name) for name, row in FOREIGN_SITES.items()]
)
PASSED: dict[str, Pairs] = {
    "127.0.0.1": [("host", "127.0.0.1:8000")],
    "localhost": [HOST],
    "LOCALHOST": [("host", "LOCALHOST:8000")],
    "[::1]": [("host", "[::1]:8000")],
    "no port": [("host", "localhost")],
    "own page": [HOST, OWN, ("sec-fetch-site", "same-origin")],
    "own page in capitals": [HOST, ("origin", "HTTP://LOCALHOST:8000")],
    "own page behind TLS": [HOST, ("origin", "https://localhost:8000")],
    "own page behind TLS on its usual port": [("host", "localhost"), ("origin", "https://localhost")],
    "typed by the user": [HOST, ("sec-fetch-site", "none"), ("sec-fetch-mode", "navigate")],
}
BODIES = {
    "a form": "application/x-www-form-urlencoded",
    "a form with files": "multipart/form-data; boundary=x",
    "no type": "",
}


@pytest.fixture(scope="module")
def guarded(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """The application with a page; nothing is on its stages, so that no answer takes long."""
    page: Path = tmp_path_factory.mktemp("page")
    (page / "assets").mkdir()
    (page / "index.html").write_text("<!doctype html><title>page</title>")
    (page / "assets" / "a-1.js").write_text("export {};")
    return create_app(Settings(folders=(), main_stage=False, page=page))


@pytest.fixture(scope="module")
def routes(guarded: Any) -> list[tuple[str, str]]:
    """Every route, with names that do not exist: what is not refused ends quickly."""
    found = live_routes(guarded)
    assert len(found) > 45
    assert {method for method, _ in found} >= {"GET", "POST", "PUT", "PATCH", "DELETE", SOCKET}
    return [(method, filled(path, "nobody", "nobody")) for method, path in found] + STATIC


def all_answers(
    app: Any, requests: Iterable[tuple[str, str]], headers: Pairs, body: bytes = b""
) -> dict[tuple[str, str], Asked]:
    async def run() -> dict[tuple[str, str], Asked]:
        return {request: await ask(app, *request, headers, body) for request in requests}

    return asyncio.run(run())


def opens_a_page(request: tuple[str, str], headers: Pairs) -> bool:
    """The one thing that another site may do: a link that opens the page."""
    wanted = {("sec-fetch-mode", "navigate"), ("sec-fetch-dest", "document")}
    return request[0] == "GET" and request[1] in PAGES and wanted <= set(headers)


def with_status(answers: dict[tuple[str, str], Asked], *statuses: int) -> set[tuple[str, str]]:
    return {request for request, answer in answers.items() if answer.status in statuses}


def wrong(answers: dict[tuple[str, str], Asked], *right: int) -> dict[tuple[str, str], int]:
    return {request: answer.status for request, answer in answers.items() if answer.status not in right}


def test_the_matrix_has_sixty_rows() -> None:
    assert len(REFUSED) + len(PASSED) + len(BODIES) >= 60


@pytest.mark.parametrize(("status", "headers"), REFUSED)
def test_no_route_answers(guarded: Any, routes: list[tuple[str, str]], status: int, headers: Pairs) -> None:
    requests = [request for request in routes if not opens_a_page(request, headers)]
    answers = all_answers(guarded, requests, headers)
    assert wrong(answers, status) == {}
    assert len({answer.body for answer in answers.values()}) == 1  # it says nothing about what is there
    third = sum(map(len, dict(headers).values())) % 3  # so that the rows together try all routes
    through = all_answers(unguarded(guarded), requests[third::3], headers)
    assert with_status(through, 400, 401, 403, 421) == set()


@pytest.mark.parametrize("headers", PASSED.values(), ids=PASSED)
def test_every_route_answers_its_own_page_and_programs(
    guarded: Any, routes: list[tuple[str, str]], headers: Pairs
) -> None:
    answers = all_answers(guarded, routes, headers)
    assert with_status(answers, 400, 401, 403, 421, 500) == set()


@pytest.mark.parametrize("path", sorted(PAGES - {"/curves.html"}))
@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_a_link_on_another_site_opens_the_page(guarded: Any, path: str, site: str) -> None:
    headers = FOREIGN_SITES[f"{site}, navigate, document"]
    answers = all_answers(guarded, [("GET", path), ("POST", path), ("HEAD", path)], headers)
    assert [answer.status for answer in answers.values()] == [200, 403, 403]


@pytest.mark.parametrize("kind", BODIES.values(), ids=BODIES)
def test_no_route_takes_what_a_form_can_send(guarded: Any, routes: list[tuple[str, str]], kind: str) -> None:
    changing = [request for request in routes if request[0] not in SAFE]
    headers = [HOST, ("content-type", kind), ("content-length", "2")]
    assert wrong(all_answers(guarded, changing, headers, b"{}"), 415) == {}


def test_only_an_upload_takes_plain_text(guarded: Any, routes: list[tuple[str, str]]) -> None:
    changing = [request for request in routes if request[0] not in (*SAFE, "PUT")]
    headers = [HOST, ("content-type", "text/plain"), ("content-length", "2")]
    assert wrong(all_answers(guarded, changing, headers, b"{}"), 415) == {}


@pytest.mark.parametrize(
    "target", ["@google.com", "http://evil.example", "//evil.example", "//[evil.example", "*"]
)
def test_a_target_that_is_no_path_is_refused(
    guarded: Any, routes: list[tuple[str, str]], target: str
) -> None:
    odd = [(method, target + (path if target != "*" else "")) for method, path in routes]
    assert wrong(all_answers(guarded, odd, [HOST]), 400) == {}


def test_no_preflight_is_granted(guarded: Any, routes: list[tuple[str, str]]) -> None:
    asked = [("access-control-request-method", "DELETE"), ("origin", "https://evil.example")]
    answers = all_answers(guarded, [("OPTIONS", path) for _, path in routes], [HOST, *asked])
    assert wrong(answers, 403) == {}


@pytest.mark.parametrize(
    "headers", [PASSED["own page"], FOREIGN_HOSTS["evil.example"]], ids=["answered", "refused"]
)
def test_every_answer_has_the_security_headers(
    guarded: Any, routes: list[tuple[str, str]], headers: Pairs
) -> None:
    """Also those of 404 and 405, of static files, and of a refused upgrade; none has a header of CORS."""
    odd = [("TRACE", path) for _, path in routes] + [("OPTIONS", path) for _, path in routes]
    answers = all_answers(guarded, [*routes, *odd], headers)
    assert {
        request for request, found in answers.items() if not found.headers.items() >= SECURITY_HEADERS.items()
    } == set()
    assert {
        name for found in answers.values() for name in found.headers if name.startswith("access-control")
    } == set()
    bare = all_answers(unguarded(guarded), routes, headers)
    assert not any(found.headers.keys() & SECURITY_HEADERS.keys() for found in bare.values())


def test_what_the_headers_promise() -> None:
    policy = SECURITY_HEADERS["content-security-policy"]
    assert "frame-ancestors 'none'" in policy
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy
    assert SECURITY_HEADERS["cross-origin-resource-policy"] == "same-origin"
