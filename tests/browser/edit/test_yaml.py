"""The text of a machine beside its table: each shows what is typed in the other; faults have their line."""

from browser.conftest import Server, until
from browser.edit.conftest import CELL, machine, type_in_cell
from playwright.sync_api import Page

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


def test_a_fault_stands_at_its_line(own: Server, table: Page) -> None:
    """The fault is told while it is typed, and nothing is kept."""
    open_text(table)
    type_title(table, ": [")
    table.locator(".yaml-bar").filter(has_text="line 3").wait_for()
    table.locator(".cm-lintRange-error, .cm-lint-marker-error").first.wait_for()
    assert machine(own)["version"] == table.evaluate("window.start")
    for _ in range(3):
        table.keyboard.press("Backspace")
