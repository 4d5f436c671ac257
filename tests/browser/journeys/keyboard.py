"""A user without a pointer: Tab, arrows, Enter and the page's keys."""

from typing import ClassVar

import pytest
from browser.journeys.user import Moment, User
from playwright.sync_api import Locator

KEYS = {"JUMP": "Space", "CROUCH": "c", "FORWARD": "ArrowUp", "OPEN": "q", "CLOSE": "e"}
"""the key of each event"""
MOST_KEYS = 60
"""there are about fifty stops on the page, from the list of machines to the timeline"""
NEXT_KEY = """wanted => {
  if (!wanted.isConnected) return null;
  const focused = document.activeElement;
  const at = cell => [cell.parentElement.rowIndex, cell.cellIndex];
  const from = focused.closest('#table :is(td, th)'), to = wanted.closest('#table :is(td, th)');
  if (wanted.contains(focused)) return '';
  if (wanted.matches('[role=menuitem]')) return 'ArrowDown';
  if (!from || !to) return 'Tab';
  const [[row, column], [toRow, toColumn]] = [at(from), at(to)];
  return row < toRow ? 'ArrowDown' : row > toRow ? 'ArrowUp' : column < toColumn ? 'ArrowRight' : 'ArrowLeft';
}"""
"""the key that leads from the focus towards a place: arrows in menus and in the table, else Tab; null: the
page has drawn the place anew
"""


class Keyboard(User):
    """A user who reaches a place by keys."""

    WINDOW: ClassVar = {"viewport": {"width": 960, "height": 600}, "color_scheme": "dark"}

    _is_away = False
    """a part of the page has the keys, not the character"""

    def take(self, place: Locator) -> None:
        self.focus(place)
        self.press("Enter")

    def focus(self, place: Locator) -> None:
        self.bring(place)
        found = place.element_handle()  # kept: to find a place by its name takes longer than to press a key
        for _ in range(MOST_KEYS):
            key = found.evaluate(NEXT_KEY)
            if key is None:
                found = place.element_handle()
                key = found.evaluate(NEXT_KEY)
            if not key:
                self._is_away = True
                return
            self.press(key)
        pytest.fail(f"{place} cannot be reached with keys")

    def send(self, event: str) -> None:
        if self._is_away:
            self.press("Escape")
            self._is_away = False
        self.press(KEYS[event])

    def choose(self, place: Locator, option: str) -> None:
        self.focus(place)
        self.type(option)

    def choose_machine(self, title: str) -> None:
        self.find(title)
        self.bring(self.page.locator("#table"))

    def go_to_curves(self) -> None:
        """A bar of this width has the link in a menu."""
        self.find("curves: the same keys")

    def blend_half_way(self) -> None:
        """Moves the slider of the pad's parameter by five tenths."""
        self.focus(self.page.locator("#parameters input[type=range]").first)
        for _ in range(5):
            self.press("PageUp")

    def _confirm(self) -> None:
        """Presses Enter, with which the dialog gives the keys back to the character by itself."""
        super()._confirm()
        self._is_away = False

    def _open_search(self) -> None:
        self.press("Control+k")

    def _scrub(self, moment: Moment) -> None:
        """Moves the slider of the timeline: to its start, or a little back."""
        self.focus(self.page.get_by_label("history: tick that is shown"))
        self.press("Home" if moment == "start" else "ArrowLeft")
