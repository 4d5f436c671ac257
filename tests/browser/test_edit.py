"""Edits the table in place: a text is tried, kept or dropped, and undone; two editors do not overwrite each
other.
"""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page, Route
from statwalk.services.library.load import shipped_machines_folder

NAME = "edited"
CELL = "td[data-state=WALK][data-column=LEFT]"
NEXT_CELL = "td[data-state=WALK][data-column=RIGHT]"
REFUSED_ANSWER = "status of 422"
LAYER = """
layers:
  head:
    mask: [Head]
    initial: REST
    states:
      REST: {motion: none}
      NOD: {motion: crouch}
    table: |
      state | NOD | END
      REST  | NOD |
      NOD   | -   | REST
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The FAQ's walker in a folder that may be written, with a second layer."""
    text = (shipped_machines_folder() / "faq-walker" / "machine.yaml").read_text()
    made = tmp_path_factory.mktemp("own") / NAME
    made.mkdir()
    (made / "machine.yaml").write_text(text.replace("character: walker.glb", "character: faq-walker") + LAYER)
    return made


@pytest.fixture(scope="module")
def playing(folder: Path) -> Iterator[Server]:
    """A server whose main stage plays that machine."""
    running = Server(folder.parent / "data", folder)
    running.start()
    yield running
    running.stop()


@pytest.fixture
def own(playing: Server) -> Iterator[Server]:
    """That server; afterwards the table has its old text."""
    text = machine(playing)["text"]
    yield playing
    now = machine(playing)
    if now["text"] != text:
        url = f"{playing.url}/api/machines/{NAME}"
        httpx.put(url, json={"text": text}, headers={"If-Match": f'"{now["version"]}"'}).raise_for_status()


@pytest.fixture
def table(own: Server, opened: Callable[[str], Page]) -> Page:
    """The page, with the version that it began with."""
    page = opened(own.url)
    page.evaluate("Object.assign(window, {start: __viewer.version(), played: __viewer.played()})")
    return page


def machine(server: Server) -> dict[str, Any]:
    """The machine as the server has it."""
    got: dict[str, Any] = httpx.get(f"{server.url}/api/machines/{NAME}").json()
    return got


def edited(page: Page, times: int = 1) -> None:
    """Waits until the table has changed so many times."""
    until(page, "__viewer.version() === window.start + arg", times)


def type_in_cell(page: Page, text: str) -> None:
    """Opens the cell, types, and waits for the server's answer."""
    page.locator(CELL).click()
    page.keyboard.type(text)
    until(page, "['fine', 'refused'].includes(document.querySelector('#cell-inspector').dataset.trial)")


def test_enter_keeps_what_is_typed(own: Server, folder: Path, table: Page) -> None:
    """The cell changes on the page, on the stage that is played, and in the file, where nothing else
    moves.
    """
    before = (folder / "machine.yaml").read_text().splitlines()
    type_in_cell(table, "TRGT at end")
    table.keyboard.press("Enter")
    edited(table)
    until(table, "__viewer.played() > window.played")
    after = (folder / "machine.yaml").read_text().splitlines()
    assert table.locator(CELL).inner_text() == "TRGT⇥"
    assert [line for line in after if line not in before] == [
        next(line for line in after if line.strip().startswith("WALK  |"))
    ]


def test_what_is_refused_stays_in_the_cell(own: Server, table: Page, allowed: list[str]) -> None:
    allowed.append(REFUSED_ANSWER)
    type_in_cell(table, "TLXT")
    table.keyboard.press("Enter")
    until(table, "document.querySelector('.cell-field').getAttribute('aria-invalid') === 'true'")
    assert table.locator(".cell-field").input_value() == "TLXT"
    assert "did you mean TLFT" in table.locator("#cell-inspector .new").first.inner_text()
    assert machine(own)["version"] == table.evaluate("window.start")


@pytest.mark.parametrize("away", ["Tab", "a click on the picture"])
def test_a_refused_cell_closes_when_it_is_left(table: Page, away: str) -> None:
    type_in_cell(table, "TLXT")
    if away == "Tab":
        table.keyboard.press("Tab")
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


def test_a_busy_server_gets_each_edit_once(own: Server, table: Page) -> None:
    """You type in the next cell before the first one is stored: two edits, no text is lost."""
    first: list[Route] = []

    def hold_the_first(route: Route) -> None:
        first.append(route)
        if len(first) > 1:
            route.continue_()

    table.locator(CELL).click()
    table.keyboard.type("STAT")
    table.route(f"**/api/machines/{NAME}/cells", hold_the_first)
    with table.expect_request(f"**/api/machines/{NAME}/cells"):
        table.keyboard.press("Enter")
    for _ in range(3):
        table.keyboard.press("Enter")
    table.locator(NEXT_CELL).click()
    table.keyboard.type("STAT at end")
    table.keyboard.press("Enter")
    first[0].continue_()
    edited(table, 2)
    rows = {row[0]: row for row in machine(own)["rows"]}
    assert rows["WALK"][2:4] == ["STAT", "STAT at end"]
    assert machine(own)["version"] == table.evaluate("window.start") + 2


def test_escape_drops_what_is_typed(own: Server, table: Page) -> None:
    type_in_cell(table, "STAT")
    table.keyboard.press("Escape")
    until(table, "document.querySelector('.cell-field').hidden")
    assert table.locator(CELL).inner_text() == "TLFT"
    assert machine(own)["version"] == table.evaluate("window.start")


def test_a_new_finding_leads_to_its_place(table: Page) -> None:
    """Nothing leads to JUMP any more: that is said before the edit is made, and a click shows the row."""
    table.locator("td[data-state=WALK][data-column=JUMP]").click()
    table.keyboard.press("Delete")
    until(table, "document.querySelector('#cell-inspector .new .where')")
    assert "JUMP" in table.locator("#cell-inspector .new").first.inner_text()


def test_undo_goes_back(own: Server, table: Page) -> None:
    text = machine(own)["text"]
    type_in_cell(table, "STAT")
    table.keyboard.press("Enter")
    edited(table)
    table.keyboard.press("Control+z")
    edited(table, 2)
    assert machine(own)["text"] == text


def test_the_keyboard_alone_edits(own: Server, table: Page) -> None:
    """From a cell the arrows lead to the next one; typing starts there, Tab takes the completion."""
    table.locator("td[data-state=WALK][data-column=FORWARD]").focus()
    table.keyboard.press("ArrowRight")
    until(table, f"document.activeElement === document.querySelector('{CELL}')")
    table.keyboard.type("trg")
    until(table, "!document.querySelector('.suggestions').hidden")
    table.keyboard.press("Tab")
    table.keyboard.press("Enter")
    edited(table)
    assert table.locator(CELL).inner_text() == "TRGT"


def test_another_editors_change_is_not_overwritten(own: Server, table: Page, allowed: list[str]) -> None:
    """The page has not heard of the change: it says so, shows the change, and keeps your text; Enter then
    keeps both.
    """
    allowed.append("status of 412")
    table.locator(CELL).click()
    table.evaluate("document.querySelector('.cell-field').value = 'STAT'")
    until(
        table, "document.querySelector('#cell-inspector').dataset.trial === 'fine'"
    )  # no trial is on its way any more
    cell, held = {"state": "WALK", "event": "RIGHT", "text": "STAT"}, list[Route]()
    seen = {"If-Match": f'"{machine(own)["version"]}"'}
    table.route(f"**/api/machines/{NAME}", lambda route: held.append(route), times=1)
    with table.expect_request(f"**/api/machines/{NAME}"):
        httpx.patch(f"{own.url}/api/machines/{NAME}/cells", json=cell, headers=seen).raise_for_status()
    with table.expect_response(lambda answer: answer.status == 412):  # before the page hears of the change
        table.keyboard.press("Enter")
    held[0].continue_()
    until(
        table,
        "document.querySelector('#cell-inspector .trial').textContent.startsWith('Another editor was "
        "faster')",
    )
    assert table.locator(".cell-field").input_value() == "STAT"
    table.keyboard.press("Enter")
    edited(table, 2)
    rows = {row[0]: row for row in machine(own)["rows"]}
    assert rows["WALK"][2:4] == ["STAT", "STAT"]


def test_an_edit_does_not_stop_the_motion(own: Server, table: Page) -> None:
    """The actor is in the same state before and after, and has not begun it again."""
    table.keyboard.down("ArrowUp")
    until(table, "__viewer.state() === 'WALK'")
    walking = table.evaluate("__viewer.lanes().length")
    type_in_cell(table, "TRGT")
    table.keyboard.press("Enter")
    edited(table)
    until(table, "__viewer.played() > window.played && __viewer.ready")
    assert table.evaluate("__viewer.lanes().length") == walking
    table.keyboard.up("ArrowUp")


def test_a_layer_has_its_own_table_and_graph(table: Page) -> None:
    table.get_by_role("tab", name="head").click()
    until(table, "document.querySelector('#table tr[aria-current] th')?.textContent === 'REST'")
    until(table, "document.querySelector('#graph .live text')?.textContent === 'REST'")
    table.locator("[data-event=NOD]").click()
    until(table, "__viewer.layerStates()[1] === 'NOD'")
