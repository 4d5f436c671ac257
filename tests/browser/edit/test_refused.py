"""A text that is refused stays in its cell while you are there, and is not kept."""

import pytest
from browser.conftest import Server, until
from browser.edit.conftest import NEXT_CELL, machine, type_in_cell
from playwright.sync_api import Page

REFUSED_ANSWER = "status of 422"


def test_what_is_refused_stays_in_the_cell(own: Server, table: Page, allowed: list[str]) -> None:
    allowed.append(REFUSED_ANSWER)
    type_in_cell(table, "TLXT")
    table.keyboard.press("Enter")
    until(table, "document.querySelector('.cell-field').getAttribute('aria-invalid') === 'true'")
    assert table.locator(".cell-field").input_value() == "TLXT"
    table.locator("#cell-inspector .new").filter(has_text="did you mean TLFT").first.wait_for()
    assert machine(own)["version"] == table.evaluate("window.start")


@pytest.mark.parametrize("away", ["Shift+Tab", "a click on the picture"])
def test_a_refused_cell_closes_when_it_is_left(table: Page, away: str) -> None:
    type_in_cell(table, "TLXT")
    if away == "Shift+Tab":
        table.keyboard.press(away)
    else:
        table.locator("canvas").first.click()
    until(table, "document.querySelector('.cell-field').hidden")
    table.locator("#notices p").filter(has_text="“TLXT” is not kept").first.wait_for()


def test_a_refused_cell_can_be_left(own: Server, table: Page, allowed: list[str]) -> None:
    """Another cell is edited at once, and a notice says what is not kept, and why."""
    allowed.append(REFUSED_ANSWER)
    type_in_cell(table, "TLXT")
    table.keyboard.press("Enter")
    until(table, "document.querySelector('.cell-field').getAttribute('aria-invalid') === 'true'")
    table.locator(NEXT_CELL).click()
    until(table, "document.querySelector('.cell-field').getAttribute('aria-label') === 'WALK, RIGHT'")
    notice = table.locator("#notices p").filter(has_text="did you mean TLFT").first
    notice.wait_for()
    assert notice.inner_text().startswith("WALK, LEFT: “TLXT” is not kept.")
    assert table.locator(".cell-field").input_value() == "TRGT"
    assert machine(own)["version"] == table.evaluate("window.start")


def test_tab_leads_to_the_report(table: Page) -> None:
    """The text stays in its cell while you read on; Escape gives it up."""
    type_in_cell(table, "TLXT")
    table.keyboard.press("Tab")
    until(table, "document.activeElement.id === 'cell-inspector'")
    assert table.locator(".cell-field").input_value() == "TLXT"
    table.keyboard.press("Escape")
    until(table, "document.querySelector('.cell-field').hidden")


def test_a_refuted_property_leads_to_its_line_of_the_file(table: Page) -> None:
    table.locator("td[data-state=STAT][data-column=JUMP]").click()
    table.keyboard.type("JUMP")
    refuted = table.locator("#cell-inspector .new").filter(has_text="JUMP only after WALK")
    refuted.get_by_role("button", name="line").click()
    table.locator(".cm-activeLine").filter(has_text="JUMP only after WALK").wait_for()


def test_escape_hides_the_findings(table: Page) -> None:
    table.get_by_role("button", name="findings").click()
    report = table.locator("#cell-inspector .findings")
    report.wait_for()
    table.keyboard.press("Escape")
    report.wait_for(state="hidden")
