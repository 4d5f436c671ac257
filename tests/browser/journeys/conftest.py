"""A user's way through the page from the first click to the goal: counted in clicks and keys, as
docs/journeys.md tells it.
"""

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from browser.conftest import Server, until
from browser.test_import import drop
from paths import ROOT
from playwright.sync_api import Locator, Page

WINDOW = {"width": 1440, "height": 900}
DOCUMENT = ROOT / "docs" / "journeys.md"


class Journey:
    """The page and what the user has done there: a click, a drop, a key or a word is one step."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.steps = 0

    def drop(self, path: Path) -> None:
        self.steps += 1
        drop(self.page, path.name, path.read_bytes())

    def click(self, place: str | Locator) -> None:
        self.steps += 1
        (self.page.locator(place) if isinstance(place, str) else place).click()

    def press(self, key: str) -> None:
        self.steps += 1
        self.page.keyboard.press(key)

    def type(self, text: str) -> None:
        self.steps += 1
        self.page.keyboard.type(text)

    def until(self, condition: str, arg: object = None) -> None:
        until(self.page, condition, arg)

    def edit_cell(self, state: str, event: str, text: str) -> None:
        """Clicks a cell, types, and presses Enter; returns when the edit is a version."""
        before = self.page.evaluate("__viewer.version()")
        self.click(f"td[data-state={state}][data-column={event}]")
        if text:
            self.type(text)
        else:
            self.press("Delete")
        self.press("Enter")
        self.until("__viewer.version() === arg", before + 1)

    def promised(self, heading: str) -> int:
        """Returns how many steps the document says a journey takes."""
        told = re.search(rf"^## {heading}: (\d+) steps$", DOCUMENT.read_text(), re.MULTILINE)
        assert told is not None, f"docs/journeys.md has no journey '{heading}: N steps'"
        return int(told[1])


@pytest.fixture(scope="module")
def fresh(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server with nothing but what is shipped; the journeys of a file leave there what they make."""
    with Server(tmp_path_factory.mktemp("journeys")) as running:
        yield running


@pytest.fixture
def journey(fresh: Server, page: Page, opened: Callable[[str], Page]) -> Journey:
    """A journey that begins at the address that the server prints."""
    page.set_viewport_size(WINDOW)
    return Journey(opened(fresh.url))
