"""Tables of 76 and of 300 states: their heads stay in sight, a filter finds rows, the graph draws a part."""

from collections.abc import Callable, Iterator

import httpx
import pytest
from browser.conftest import Server, leave, until
from playwright.sync_api import Page

NAME = "large"
GRAPH = "[...document.querySelectorAll('#graph .state')].map(state => state.dataset.state).join()"
ROWS = "[...document.querySelectorAll('#table tbody th')].map(head => head.dataset.state).join()"
HEADS = """() => ['thead th', 'tbody th', 'thead th + th', 'tbody td'].map(part => {
  const seen = document.querySelector('#table').getBoundingClientRect();
  const { left, top } = document.querySelector(`#table ${part}`).getBoundingClientRect();
  return [left - seen.left, top - seen.top].map(Math.round);
})"""
"""where the corner, the head of a row and of a column, and a cell stand in the table's room, pixels"""


def machine_text(character: str, states: int, events: int) -> str:
    """A machine file with this line about its character; each state leads to the three after it."""
    names = [f"S{k:03}" for k in range(states)]
    rows = [["state", *(f"EVENT{event:02}" for event in range(events))]] + [
        [name, *(names[(k + 1 + event % 3) % states] for event in range(events))]
        for k, name in enumerate(names)
    ]
    return "\n".join(
        [
            character,
            "initial: S000",
            "states:",
            *(f"  {name}: {{motion: stand, loop: true}}" for name in names),
            "table: |",
            *("  " + " | ".join(row) for row in rows),
            "",
        ]
    )


@pytest.fixture(params=["76 x 12"])
def large(server: Server, opened: Callable[[str], Page], request: pytest.FixtureRequest) -> Iterator[Page]:
    """The page with a machine of so many states and events."""
    states, events = map(int, request.param.split(" x "))
    url = f"{server.url}/api/machines"
    httpx.post(url, json={"name": NAME, "copy_of": "faq-walker"}, timeout=60).raise_for_status()
    made = httpx.get(f"{url}/{NAME}").json()
    character = next(line for line in made["text"].splitlines() if line.startswith("character: "))
    seen, text = {"If-Match": f'"{made["version"]}"'}, {"text": machine_text(character, states, events)}
    httpx.put(f"{url}/{NAME}", json=text, headers=seen, timeout=60).raise_for_status()
    page = opened(f"{server.url}/?machine={NAME}")
    page.locator("#graph").get_by_text(f"of {states} states").wait_for()
    yield page
    stage = page.evaluate("__viewer.stage()")
    leave(page, f"{server.url}/api/stages/{stage}", f"{url}/{NAME}")


def test_the_heads_of_a_large_table_stay_while_it_scrolls(large: Page) -> None:
    """Down and to the right by the wheel; the cells go, and the last row can be read."""
    before = large.evaluate(HEADS)
    large.hover("#table tbody td")
    large.mouse.wheel(250, 0)
    until(large, "document.querySelector('#table').scrollLeft > 200")
    large.mouse.wheel(0, 100)
    until(large, "document.querySelector('#table').scrollTop >= 100")
    corner, row, column, cell = large.evaluate(HEADS)
    assert corner == before[0]
    assert row[0] == before[1][0]
    assert column == [before[2][0] - 250, before[2][1]]
    assert cell == [before[3][0] - 250, before[3][1] - 100]
    large.mouse.wheel(0, 9000)
    large.locator("#table th[data-state=S075]").wait_for()
    until(
        large,
        "document.querySelector('#table th[data-state=S075]').getBoundingClientRect().bottom < innerHeight",
    )
    assert large.evaluate(HEADS)[0] == before[0]


def test_the_filter_of_a_large_table_chooses_its_rows_and_what_the_graph_shows(large: Page) -> None:
    """Without it the graph shows the live state and its neighbours, as it does again afterwards."""
    around = "S000,S001,S002,S003,S073,S074,S075"
    assert large.evaluate(GRAPH) == around
    large.get_by_role("searchbox", name="filter states and events").click()
    large.keyboard.type("S03 EVENT11")
    until(large, f"{GRAPH} === 'S030' + [...Array(9)].map((_, i) => ',S03' + (i + 1)).join('')")
    assert large.evaluate(ROWS) == large.evaluate(GRAPH)
    heads = large.locator("#table thead th[data-column]")
    assert heads.all_inner_texts() == ["EVENT11"]
    large.keyboard.press("Escape")
    until(large, f"{GRAPH} === arg", around)


@pytest.mark.parametrize("large", ["300 x 40"], indirect=True)
def test_the_last_of_300_rows_is_found_and_edited(server: Server, large: Page) -> None:
    version = large.evaluate("__viewer.version()")
    large.get_by_role("searchbox", name="filter states and events").click()
    large.keyboard.type("S29")
    until(large, f"{ROWS}.split(',').length === 10")
    large.keyboard.press("Escape")
    large.hover("#table tbody td")
    large.mouse.wheel(0, 90000)
    cell = large.locator("td[data-state=S299][data-column=EVENT01]")
    cell.click()
    large.keyboard.press("Control+a")
    large.keyboard.type("S150 at end")
    large.keyboard.press("Enter")
    until(large, "__viewer.version() === arg + 1", version)
    cell.filter(has_text="S150⇥").wait_for()
    row = httpx.get(f"{server.url}/api/machines/{NAME}").json()["rows"][-1]
    assert (row[0], row[2]) == ("S299", "S150 at end")
