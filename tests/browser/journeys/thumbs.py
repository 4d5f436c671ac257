"""A user of a phone, at night: taps, and shows one panel at a time."""

from pathlib import Path
from typing import ClassVar

from browser.journeys.fingers import Fingers
from playwright.sync_api import Locator


class Thumbs(Fingers):
    """A user who brings a panel to the front before a tap into it."""

    WINDOW: ClassVar = {
        "viewport": {"width": 390, "height": 844},
        "has_touch": True,
        "is_mobile": True,
        "color_scheme": "dark",
    }

    def take(self, place: Locator) -> None:
        self.bring(place)
        super().take(place)

    def choose_machine(self, title: str) -> None:
        """Looks at the machine's table."""
        super().choose_machine(title)
        self.bring(self.page.locator("#table"))

    def _open_search(self) -> None:
        self._take_from_the_bar("find anything")

    def _open_file(self, path: Path) -> None:
        with self.page.expect_file_chooser() as chosen:
            self._take_from_the_bar("add your own")
        chosen.value.set_files(path)

    def _take_from_the_bar(self, item: str) -> None:
        """Takes what a narrow bar has in its menu."""
        self.take_from_menu(self.page.get_by_role("button", name="more"), item)


class ThumbsOnASmallPhone(Thumbs):
    """A user of the smallest phone, by day."""

    WINDOW: ClassVar = {"viewport": {"width": 320, "height": 640}, "has_touch": True, "is_mobile": True}

    def open_stages(self) -> None:
        """The bar has no room for the stage's name."""
        self.find("stages and forks")
