"""A user of a tablet: taps, and words from its keyboard."""

from typing import ClassVar

from browser.journeys.user import Moment, User
from playwright.sync_api import Locator


class Fingers(User):
    """A user who has neither a mouse nor the keys of the page."""

    WINDOW: ClassVar = {"viewport": {"width": 1024, "height": 700}, "has_touch": True}

    def take(self, place: Locator) -> None:
        place.tap()

    def send(self, event: str) -> None:
        self.take(self.page.locator(f"#events [data-event={event}]"))

    def fill(self, place: Locator, text: str) -> None:
        self.take(place)
        place.fill(text)

    def copy_link(self) -> None:
        self.find("link to this moment")

    def go_to_curves(self) -> None:
        """A tablet has no room for links at the top: they are in a menu."""
        self.take_from_menu(self.page.get_by_role("button", name="more"), "curves")

    def _confirm(self) -> None:
        self.press_button("Make a machine")

    def _write(self, text: str) -> None:
        field = self.page.locator("#table input").first
        field.fill(text)
        field.press("Enter")

    def _scrub(self, moment: Moment) -> None:
        bar, position = self._timeline(moment)
        bar.tap(position=position)
