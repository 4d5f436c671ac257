"""The list of machines with the keyboard: arrow keys move in the open list, Enter chooses."""

from browser.conftest import until
from playwright.sync_api import Page

IS_OPEN = "document.activeElement.matches('#picker select:open')"


def test_arrow_keys_open_the_list_of_machines_and_enter_chooses(viewer: Page) -> None:
    """The list has the focus, and the page keeps its machine, until Enter."""
    machine = viewer.locator("#picker select[title=machine]")
    until(viewer, "document.querySelectorAll('#picker option').length > 1")
    before = machine.evaluate("list => [list.value, list.options[list.selectedIndex + 1].value]")
    machine.focus()
    viewer.keyboard.press("ArrowDown")
    until(viewer, IS_OPEN)
    for key in ("ArrowDown", "ArrowDown", "ArrowUp"):
        viewer.keyboard.press(key)
    tick = viewer.evaluate("__viewer.tick()")
    until(viewer, f"{IS_OPEN} && __viewer.tick() > arg", tick)
    assert [machine.input_value(), viewer.evaluate("__viewer.stage()")] == [before[0], "main"]
    viewer.keyboard.press("Enter")
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready")
    assert machine.input_value() == before[1]
