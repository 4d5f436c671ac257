"""Signing a browser in, and the cookie that it gets.

tests/reliability/test_r12_tokens.py tries every route.
"""

import asyncio
from pathlib import Path
from typing import Any

import pytest
from live_routes import Asked, ask
from statwalk.services.access.access_file import AccessFile
from statwalk.services.access.authenticator import Authenticator
from statwalk.services.access.roles import EVERYTHING, Grant
from statwalk.web.app import create_app
from statwalk.web.gate import GRANT, sender_of
from statwalk.web.same_origin import OwnNames
from statwalk.web.settings import LOOPBACK, Settings

HOST = ("host", "localhost:8000")
SHARED = OwnNames((*LOOPBACK.hosts, "anim.example"), "https://anim.example:8443")


def signing(folder: Path, names: OwnNames = LOOPBACK) -> tuple[Any, str]:
    """An application with a page, and the token of its start."""
    (folder / "index.html").write_text("<!doctype html><title>page</title>")
    authenticator = Authenticator(AccessFile(folder), with_start_token=True)
    settings = Settings(names=names, main_stage=False, page=folder, authenticator=authenticator)
    return create_app(settings), authenticator.start_token


def get(app: Any, query: str = "", path: str = "/", *headers: tuple[str, str], host: Any = HOST) -> Asked:
    return asyncio.run(ask(app, "GET", path, [host, *headers], query=query))


def test_the_token_moves_from_the_address_to_a_cookie(tmp_path: Path) -> None:
    app, token = signing(tmp_path)
    answer = get(app, f"token={token}")
    assert (answer.status, answer.headers["location"], answer.body) == (303, "/", b"")
    assert answer.headers["set-cookie"] == f"statwalk_8000={token}; HttpOnly; SameSite=Strict; Path=/"
    assert answer.headers["cache-control"] == "no-store"
    assert answer.headers["referrer-policy"] == "no-referrer"
    page = get(app, "", "/", ("cookie", answer.headers["set-cookie"].partition(";")[0]))
    assert (page.status, token in page.text) == (200, False)


def test_over_https_the_cookie_belongs_to_this_host_alone(tmp_path: Path) -> None:
    app, token = signing(tmp_path, SHARED)
    answer = get(app, f"token={token}", host=("host", "anim.example:8443"))
    expected = f"__Host-statwalk_8443={token}; HttpOnly; SameSite=Strict; Path=/; Secure"
    assert answer.headers["set-cookie"] == expected


@pytest.mark.parametrize(
    ("stage", "location"),
    [("abc-1", "/?stage=abc-1"), ("//evil.example", "/"), ("%0d%0aSet-Cookie:x", "/"), ("", "/")],
)
def test_the_stage_stays_in_the_address_and_nothing_else(tmp_path: Path, stage: str, location: str) -> None:
    app, token = signing(tmp_path)
    answer = get(app, f"stage={stage}&token={token}&next=https://evil.example")
    assert answer.headers["location"] == location


@pytest.mark.parametrize("query", ["token=", "token=wrong", "token=%ff", "Token=x", "token"])
def test_a_wrong_token_sets_no_cookie(tmp_path: Path, query: str) -> None:
    answer = get(signing(tmp_path)[0], query)
    assert answer.status == 401
    assert "set-cookie" not in answer.headers


FROM_MAIL = [
    ("sec-fetch-site", "cross-site"),
    ("sec-fetch-mode", "navigate"),
    ("sec-fetch-dest", "document"),
]


def test_what_another_site_links_to_opens_itself_once_more(tmp_path: Path) -> None:
    """The browser left the cookie out, and leaves it out of what a redirect leads to."""
    app, token = signing(tmp_path)
    for query, cookie in ((f"token={token}&stage=abc", True), ("stage=abc", False)):
        answer = get(app, query, "/", *FROM_MAIL)
        assert (answer.status, "set-cookie" in answer.headers) == (200, cookie)
        assert 'content="0;url=/?stage=abc"' in answer.text
        assert token not in answer.text
    again = get(app, "stage=abc", "/", ("sec-fetch-site", "same-origin"), *FROM_MAIL[1:])
    assert again.status == 401  # and not for ever


def test_answers_to_people_with_a_token_are_theirs_alone(tmp_path: Path) -> None:
    app, token = signing(tmp_path)
    answer = get(app, "", "/api/access", ("authorization", f"Bearer {token}"))
    assert answer.headers["cache-control"] == "private, no-cache"


def test_a_server_without_tokens_takes_no_notice_of_one(tmp_path: Path) -> None:
    signing(tmp_path)
    answer = get(create_app(Settings(main_stage=False, page=tmp_path)), "token=x")
    assert (answer.status, "set-cookie" in answer.headers) == (200, False)


@pytest.mark.parametrize(
    ("grant", "sender"), [(Grant("ada", "view", digest="1f"), "1f"), (EVERYTHING, "192.0.2.7")]
)
def test_a_sender_is_a_token_or_without_one_an_address(grant: Grant, sender: str) -> None:
    assert sender_of({"client": ("192.0.2.7", 1), GRANT: grant}) == sender
