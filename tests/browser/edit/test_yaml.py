"""The text of a machine beside its table: each shows what is typed in the other; faults have their line."""

from browser.conftest import Server, until
from browser.edit.conftest import CELL, NAME, machine, type_in_cell
from playwright.sync_api import Page, Route

LINES = "[...document.querySelector('.yaml-editor').shadowRoot.querySelectorAll('.cm-line')]"


def open_text(page: Page) -> None:
    page.get_by_role("button", name="versions").click()
    page.get_by_role("tab", name="YAML").click()
    page.get_by_role("textbox", name="machine.yaml").wait_for()


def type_title(page: Page, title: str) -> None:
    """Types another title at the end of its line."""
    page.locator(".cm-line").filter(has_text="title:").click()
    page.keyboard.press("End")
    page.keyboard.type(title)


def test_the_text_and_the_table_show_each_other(own: Server, table: Page) -> None:
    open_text(table)
    type_title(table, ", again")
    table.keyboard.press("Control+s")
    until(table, "__viewer.version() === window.start + 1")
    assert machine(own)["title"].endswith(", again")
    type_in_cell(table, "STAT at end")
    table.keyboard.press("Enter")
    until(table, "__viewer.version() === window.start + 2")
    text = f"{LINES}.map(line => line.textContent).join('\\n') || ''"
    table.locator(".cm-scroller").evaluate("scroller => scroller.scrollTop = scroller.scrollHeight / 2")
    until(table, f"({text}).includes('STAT at end')")
    until(table, f"document.querySelector('{CELL}').textContent.startsWith('STAT')")


def test_what_is_typed_shows_in_the_table_as_soon_as_you_pause(own: Server, table: Page) -> None:
    """Without ctrl S, and while the text still has the cursor; what is typed next goes on from it."""
    open_text(table)
    table.locator(".cm-line").filter(has_text="STWK:").click()
    table.keyboard.press("End")
    table.keyboard.press("Enter")
    table.keyboard.type("NEW: {motion: stand}")
    table.locator("#table th").filter(has_text="NEW").wait_for()
    table.keyboard.press("Enter")
    table.keyboard.type("NEWER: {motion: stand}")
    table.locator("#table th").filter(has_text="NEWER").wait_for()
    assert {"NEW", "NEWER"} <= machine(own)["table"].keys()


def test_what_is_typed_while_the_server_keeps_the_text_goes_on_from_it(own: Server, table: Page) -> None:
    """The page does not take the text that it has sent itself for a change by another editor."""
    held: list[Route] = []
    kept = f"{own.url}/api/machines/{NAME}"
    table.route(kept, lambda route: held.append(route) if route.request.method == "PUT" else route.fallback())
    open_text(table)
    with table.expect_request(lambda request: request.method == "PUT" and request.url == kept):
        type_title(table, ", one")
        table.keyboard.press("Control+s")
    table.keyboard.type(", two")
    table.unroute(kept)
    held[0].continue_()
    until(table, "__viewer.version() > window.start + 1")
    assert machine(own)["title"].endswith(", one, two")
    assert not table.get_by_text("changed meanwhile").is_visible()


def test_a_fault_stands_at_its_line(own: Server, table: Page) -> None:
    """The fault is told while it is typed, and nothing is kept."""
    open_text(table)
    type_title(table, ": [")
    table.locator(".yaml-bar").filter(has_text="line 3").wait_for()
    table.locator(".cm-lintRange-error, .cm-lint-marker-error").first.wait_for()
    assert machine(own)["version"] == table.evaluate("window.start")
    for _ in range(3):
        table.keyboard.press("Backspace")


def test_a_text_that_is_right_again_loses_the_mark_of_its_fault(table: Page) -> None:
    """A brace that is missing in one line is marked at the next one."""
    until(table, "document.querySelector('#version .count').textContent !== '…'")
    open_text(table)
    table.locator(".cm-line").filter(has_text="STWK:").click()
    table.keyboard.press("End")
    table.keyboard.press("Backspace")
    table.locator(".cm-lint-marker-error").wait_for()
    table.keyboard.type("}")
    table.locator(".cm-lint-marker-error").wait_for(state="detached")
