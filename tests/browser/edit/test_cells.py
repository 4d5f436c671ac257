"""Cells of the table: a double click opens one where it is; what one person types, another one sees; an edit
leaves the graph as it is, and what is said of it moves nothing.
"""

import re

import pytest
from browser.conftest import Server, until
from browser.edit.conftest import CELL, NEXT_CELL, edited, machine, type_in_cell
from browser.test_dropped_look import TWO_FRAMES
from browser.test_graph import PLACES
from playwright.sync_api import Page

LAST_IN_SIGHT = """() => {
  const { left, right, bottom } = document.querySelector('#table').getBoundingClientRect();
  const seen = [...document.querySelectorAll('#table td')].filter(cell => {
    const at = cell.getBoundingClientRect();
    return at.right <= right && at.top + 6 < bottom;
  });
  const { left: x, top: y } = seen.at(-1).getBoundingClientRect();
  return [`${seen.at(-1).dataset.state}, ${seen.at(-1).dataset.column}`, x + 5, y + 5];
}"""
"""the lowest cell that is seen of the table, and a place in it, pixels"""
UNDER = "([x, y]) => document.elementFromPoint(x, y).ariaLabel"


def test_a_double_click_opens_a_cell_where_it_is(table: Page) -> None:
    """What comes below the table with the first click does not move the cell away from the pointer."""
    name, *at = table.evaluate(LAST_IN_SIGHT)
    table.mouse.click(*at)
    table.locator("#cell-inspector .cell-says").wait_for()
    table.evaluate(TWO_FRAMES)
    table.mouse.down(click_count=2)
    table.mouse.up(click_count=2)
    table.evaluate(TWO_FRAMES)
    assert table.locator(".cell-field").is_visible()
    assert table.evaluate(UNDER, at) == name


def test_an_unknown_state_is_told_while_it_is_typed(table: Page) -> None:
    type_in_cell(table, "Q")
    table.locator("#cell-inspector .new").filter(has_text="Q is no state").first.wait_for()
    table.keyboard.press("Escape")


def test_the_graph_stays_while_a_cell_gets_another_text(table: Page) -> None:
    """The new arrow comes, and no state moves."""
    table.wait_for_selector("#graph .state[data-state=WALK]")
    before = table.evaluate(PLACES)
    assert len(before) == 11
    type_in_cell(table, "STWK")
    table.keyboard.press("Enter")
    edited(table)
    table.wait_for_selector("#graph .edge[data-from=WALK][data-to=STWK]", state="attached")
    assert table.evaluate(PLACES) == before


def test_two_people_type_into_two_cells_at_once(own: Server, table: Page) -> None:
    """Both edits are kept, and both pages show both."""
    other = table.context.new_page()
    other.goto(f"{own.url}?fps=6")
    until(other, "window.__viewer?.ready")
    type_in_cell(table, "TRGT at end")
    other.locator(NEXT_CELL).click()
    other.keyboard.type("STAT at end")
    table.keyboard.press("Enter")
    other.keyboard.press("Enter")
    edited(table, 2)
    for page in (table, other):
        for cell, text in ((CELL, "TRGT⇥≈"), (NEXT_CELL, "STAT⇥≈")):
            until(page, f"document.querySelector('{cell}').textContent === arg", text)
    rows = {row[0]: row for row in machine(own)["rows"]}
    assert rows["WALK"][2:4] == ["TRGT at end", "STAT at end"]


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (1280, 800), (1024, 700)])
def test_what_is_said_of_an_edit_moves_nothing(table: Page, width: int, height: int) -> None:
    table.set_viewport_size({"width": width, "height": height})
    until(table, "innerWidth === arg", width)
    boxes = [table.locator(part) for part in ("#graph", "#version", "#table")]
    before = [box.bounding_box() for box in boxes]
    table.locator("td[data-state=WALK][data-column=JUMP]").focus()
    table.keyboard.press("Delete")
    table.keyboard.press("Enter")
    edited(table)
    table.get_by_role("button", name=re.compile("findings: .* warnings")).wait_for()
    assert [box.bounding_box() for box in boxes] == before
    assert table.locator("#version").evaluate("bar => bar.scrollWidth <= bar.clientWidth")
