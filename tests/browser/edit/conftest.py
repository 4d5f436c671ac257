"""A machine that may be edited: its folder, its server, and typing in its table."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page
from statwalk.services.library.load import shipped_machines_folder

NAME = "edited"
CELL = "td[data-state=WALK][data-column=LEFT]"
NEXT_CELL = "td[data-state=WALK][data-column=RIGHT]"
LAYER = """
layers:
  head:
    mask: [Head]
    initial: REST
    states:
      REST: {motion: none}
      NOD: {motion: crouch}
    table: |
      state | NOD | END
      REST  | NOD |
      NOD   | -   | REST
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The FAQ's walker in a folder that may be written, with a second layer."""
    text = (shipped_machines_folder() / "faq-walker" / "machine.yaml").read_text()
    made = tmp_path_factory.mktemp("own") / NAME
    made.mkdir()
    (made / "machine.yaml").write_text(text.replace("character: walker.glb", "character: faq-walker") + LAYER)
    return made


@pytest.fixture(scope="module")
def playing(folder: Path) -> Iterator[Server]:
    """A server whose main stage plays that machine."""
    with Server(folder.parent / "data", folder) as running:
        yield running


@pytest.fixture
def own(playing: Server) -> Iterator[Server]:
    """That server; afterwards the table has its old text."""
    text = machine(playing)["text"]
    yield playing
    now = machine(playing)
    if now["text"] != text:
        url = f"{playing.url}/api/machines/{NAME}"
        httpx.put(url, json={"text": text}, headers={"If-Match": f'"{now["version"]}"'}).raise_for_status()


@pytest.fixture
def table(own: Server, page: Page, opened: Callable[[str], Page]) -> Page:
    """The page, with the version that it began with. Playwright intercepts requests from the first
    one: it loses sight of a request that the page sends just while the interception begins.
    """
    page.route(f"**/api/machines/{NAME}", lambda route: route.continue_())
    opened(own.url)
    page.evaluate("Object.assign(window, {start: __viewer.version(), played: __viewer.played()})")
    return page


def machine(server: Server) -> dict[str, Any]:
    """The machine as the server has it."""
    got: dict[str, Any] = httpx.get(f"{server.url}/api/machines/{NAME}").json()
    return got


def type_in_cell(page: Page, text: str) -> None:
    """Opens the cell, types, and waits for the server's answer."""
    page.locator(CELL).click()
    page.keyboard.type(text)
    until(page, "['fine', 'refused'].includes(document.querySelector('#cell-inspector').dataset.trial)")


def inspect(page: Page, cell: str) -> None:
    """Selects a cell, or the head of a row, by the keyboard, and opens the inspector."""
    page.locator(cell).focus()
    page.keyboard.press("Alt+Enter")
    page.locator("#cell h2").wait_for()


def edited(page: Page, times: int = 1) -> None:
    """Waits until the machine has changed so many times."""
    until(page, "__viewer.version() === window.start + arg", times)
