"""A server that holds as many stages as it may, and a stage with as many viewers: the page says so."""

from collections.abc import Callable, Iterator
from pathlib import Path

import httpx
import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page


@pytest.fixture
def full(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """Has `main`, and two stages in which somebody has walked."""
    limits = ["--limit", "stages=3", "--limit", "rest_seconds=0.2"]
    with Server(tmp_path_factory.mktemp("full"), *limits) as running:
        for _ in range(2):
            made = httpx.post(
                f"{running.url}/api/stages", json={"actors": [{"machine": "faq-walker"}]}, timeout=60
            )
            event = httpx.post(
                f"{running.url}/api/stages/{made.json()['id']}/events", json={"event": "FORWARD"}
            )
            event.raise_for_status()
        yield running


def test_a_link_shows_main_and_what_nobody_uses_can_be_cleared_away(
    full: Server, opened: Callable[[str], Page], allowed: list[str]
) -> None:
    allowed.append("409")
    link = f"{full.url}/?machine=tentacle"
    page = opened(link)
    page.locator("#notices p", has_text="the server holds 3 stages, and no more").wait_for()
    assert page.evaluate("__viewer.stage()") == "main"
    page.keyboard.press("o")
    page.get_by_role("button", name="delete them …").click()
    page.get_by_text("Delete faq-walker, faq-walker for good, with 4 inputs?").wait_for()
    page.get_by_role("button", name="delete them", exact=True).click()
    page.get_by_text("Asleep and without a name").wait_for(state="detached")
    opened(link)
    until(page, "__viewer.stage() !== 'main' && __viewer.ready")


def test_a_stage_with_as_many_viewers_as_it_may_have_says_so_and_shows_itself_when_one_leaves(
    tmp_path: Path, opened: Callable[[str], Page], allowed: list[str]
) -> None:
    allowed.append("WebSocket connection to")
    with Server(tmp_path, "--limit", "viewers=1") as small:
        first = opened(small.url)
        second = first.context.new_page()
        second.goto(f"{small.url}?fps=6")
        second.get_by_text("full, trying again").wait_for()
        second.locator("#notices p", has_text="as many viewers as it may have").wait_for()
        first.goto("about:blank")
        until(second, "window.__viewer?.ready && __viewer.link() === 'live'")
