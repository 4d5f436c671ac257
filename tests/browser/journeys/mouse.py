"""A user with a mouse and a keyboard, who takes as many steps as the document says."""

from pathlib import Path

from browser.journeys.keyboard import KEYS
from browser.journeys.user import Moment, User
from browser.test_import import drop
from playwright.sync_api import Locator

CLICKED_EVENTS = ("OPEN", "CLOSE")
"""events that the user clicks, because the user does not know their keys"""


class Mouse(User):
    """A user whose clicks and drops are steps, too."""

    def take(self, place: Locator) -> None:
        self.steps += 1
        place.click()

    def send(self, event: str) -> None:
        if event in CLICKED_EVENTS:
            self.press_button(f"{event} {KEYS[event].upper()}")
        else:
            self.press(KEYS[event])

    def arrived(self, journey: str) -> None:
        promised = self._promised(journey)
        assert self.steps == promised, f"{journey}: {self.steps} steps, docs/journeys.md says {promised}"

    def _open_file(self, path: Path) -> None:
        self.steps += 1
        drop(self.page, path.name, path.read_bytes())

    def _scrub(self, moment: Moment) -> None:
        bar, position = self._timeline(moment)
        self.steps += 1
        bar.click(position=position)
