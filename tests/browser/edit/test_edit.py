"""Edits the table in place: a text is tried, kept or dropped, and undone; no editor overwrites another."""

from pathlib import Path

import httpx
import pytest
from browser.conftest import Server, until
from browser.edit.conftest import CELL, NAME, NEXT_CELL, edited, machine, type_in_cell
from playwright.sync_api import Page, Route


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
    until(table, f"document.querySelector('{CELL}').textContent === 'TRGT⇥≈'")
    assert [line for line in after if line not in before] == [
        next(line for line in after if line.strip().startswith("WALK  |"))
    ]


NOTE_ABSENCE = """(() => {
  const note = () => {
    if (!__viewer.ready) window.gone = true;
    requestAnimationFrame(note);
  };
  window.gone = false;
  note();
})()"""


def test_the_character_stays_in_the_picture_while_its_table_changes(table: Page) -> None:
    table.evaluate(NOTE_ABSENCE)
    type_in_cell(table, "TRGT at end")
    table.keyboard.press("Enter")
    edited(table)
    until(table, "__viewer.played() > window.played")
    tick = table.evaluate("__viewer.posed()")
    until(table, "__viewer.posed() > arg", tick)
    assert not table.evaluate("window.gone")


DRAWN_IN_FRAMES = """async frames => {
  const before = __viewer.stats().drawn;
  for (let frame = 0; frame < frames; frame++) await new Promise(requestAnimationFrame);
  return __viewer.stats().drawn - before;
}"""


@pytest.mark.parametrize("most_fps", [30])
def test_a_software_renderer_lets_an_edit_go_first(table: Page) -> None:
    held: list[Route] = []
    table.route(f"**/api/machines/{NAME}?dry=true", lambda route: held.append(route))
    with table.expect_request(f"**/api/machines/{NAME}?dry=true"):
        table.locator(CELL).click()
        table.keyboard.type("TRGT")
    assert table.evaluate(DRAWN_IN_FRAMES, 20) <= 2  # a picture is at most a second old
    table.route(f"**/api/machines/{NAME}?dry=true", lambda route: route.continue_())
    for route in held:  # a slow page has tried what was typed so far, and tries the rest
        route.continue_()
    until(table, "document.querySelector('#cell-inspector').dataset.trial === 'fine'")
    until(table, "__viewer.stats().drawn > arg", table.evaluate("__viewer.stats().drawn"))


def test_a_trial_that_no_server_answers_refuses_nothing_and_keeps_what_is_typed(
    table: Page, allowed: list[str]
) -> None:
    allowed.append("Failed to load resource")
    table.route(f"**/api/machines/{NAME}?dry=true", lambda route: route.abort())
    table.locator(CELL).click()
    table.keyboard.type("TRGT at end")
    report = table.locator("#cell-inspector")
    report.filter(has_text="The server does not answer.").wait_for()
    assert "Refused" not in report.inner_text()
    table.locator("#stage-view").click(position={"x": 20, "y": 200})
    assert table.locator(".cell-field").input_value() == "TRGT at end"
    table.locator(".cell-field").press("Enter")
    edited(table)


def test_a_busy_server_gets_each_edit_once(own: Server, table: Page) -> None:
    """You type in the next cell before the first one is stored: two edits, no text is lost."""
    first: list[Route] = []

    def hold_the_first(route: Route) -> None:
        if first or route.request.method != "PATCH":
            route.continue_()
        else:
            first.append(route)

    table.locator(CELL).click()
    table.keyboard.type("STAT")
    table.route(f"**/api/machines/{NAME}", hold_the_first)
    with table.expect_request(f"**/api/machines/{NAME}"):
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
    until(table, f"document.querySelector('{CELL}').textContent === 'TLFT≈'")
    assert machine(own)["version"] == table.evaluate("window.start")


def test_a_new_finding_leads_to_its_place(table: Page) -> None:
    """Nothing leads to JUMP any more: that is said before the edit is made, and a click shows the row."""
    table.locator("td[data-state=WALK][data-column=JUMP]").click()
    table.keyboard.press("Delete")
    until(table, "document.querySelector('#cell-inspector .new .where')")
    table.locator("#cell-inspector .new").filter(has_text="JUMP").first.wait_for()


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
    until(table, f"document.querySelector('{CELL}').textContent === 'TRGT≈'")


@pytest.mark.parametrize("event", ["RIGHT", "LEFT"])
def test_another_editors_change_is_not_overwritten(
    own: Server, table: Page, allowed: list[str], event: str
) -> None:
    """The page has not heard of the change. Of another cell: both are kept. Of the same cell: the page says
    so and keeps your text; Enter then keeps it.
    """
    allowed.append("status of 412")
    table.locator(CELL).click()
    table.locator(".cell-field").fill("STAT")
    until(
        table, "document.querySelector('#cell-inspector').dataset.trial === 'fine'"
    )  # no trial is on its way any more
    table.route(f"**/api/machines/{NAME}", lambda route: held.append(route), times=1)
    cell, held = {"state": "WALK", "event": event, "text": "CSTP"}, list[Route]()
    seen = {"If-Match": f'"{machine(own)["version"]}"'}
    with table.expect_request(f"**/api/machines/{NAME}"):
        httpx.patch(f"{own.url}/api/machines/{NAME}/cells", json=cell, headers=seen).raise_for_status()
    table.keyboard.press("Enter")  # before the page hears of the change
    if event == "LEFT":
        told = "document.querySelector('#cell-inspector .trial').textContent"
        until(table, f"{told}.startsWith('Another editor was faster')")
        assert table.locator(".cell-field").input_value() == "STAT"
        table.keyboard.press("Enter")
    held[0].continue_()
    edited(table, 2)
    rows = {row[0]: row for row in machine(own)["rows"]}
    assert rows["WALK"][2:4] == (["STAT", "CSTP"] if event == "RIGHT" else ["STAT", "TRGT"])


def test_undone_edits_come_back(own: Server, table: Page) -> None:
    """Three quick undos and three redos: one version each, and none is refused."""
    text = machine(own)["text"]
    for number, cell in enumerate((CELL, NEXT_CELL, "td[data-state=STWK][data-column=LEFT]")):
        table.locator(cell).click()
        table.keyboard.type("TRGT at end")
        table.keyboard.press("Enter")
        edited(table, number + 1)
    kept = machine(own)["text"]
    for _ in range(3):
        table.keyboard.press("Control+z")
    edited(table, 6)
    assert machine(own)["text"] == text
    for _ in range(3):
        table.keyboard.press("Control+Shift+z")
    edited(table, 9)
    assert machine(own)["text"] == kept


def test_a_version_is_restored_from_the_list(own: Server, table: Page) -> None:
    """The list says what a version changed; "restore" makes an older one the newest."""
    text = machine(own)["text"]
    type_in_cell(table, "STAT")
    table.keyboard.press("Enter")
    edited(table)
    table.get_by_role("button", name="versions").click()
    until(
        table, "document.querySelector('#versions .version-row b').textContent === 'v' + __viewer.version()"
    )
    row = table.locator("#versions li").first
    row.locator(".version-row").click()
    row.get_by_role("button", name="WALK, LEFT").wait_for()
    assert row.locator("ins").inner_text().startswith("STAT")
    table.get_by_role("button", name="restore").first.click()
    edited(table, 2)
    assert machine(own)["text"] == text


def test_an_edit_waits_for_a_server_that_starts_again(own: Server, table: Page, allowed: list[str]) -> None:
    """You keep a text while the server is away: it is sent when the server is back."""
    allowed += ["ERR_CONNECTION_REFUSED", "Failed to load", "WebSocket"]
    table.locator(CELL).click()
    own.stop()
    table.keyboard.type("STAT")
    table.keyboard.press("Enter")
    table.locator("#version .what").filter(has_text="1 edit waits").wait_for()
    own.start()
    until(table, f"document.querySelector('{CELL}').textContent.startsWith('STAT')")
    rows = {row[0]: row for row in machine(own)["rows"]}
    assert rows["WALK"][2] == "STAT"


def test_an_edit_does_not_stop_the_motion(own: Server, table: Page) -> None:
    """The actor is in the same state before and after, and has not begun it again."""
    table.keyboard.down("ArrowUp")
    until(table, "__viewer.state() === 'WALK' && __viewer.lanes().at(-1)?.[2] === 'WALK'")
    walking = table.evaluate("__viewer.lanes().length")
    type_in_cell(table, "TRGT")
    table.keyboard.press("Enter")
    edited(table)
    until(table, "__viewer.played() > window.played && __viewer.ready")
    until(table, "__viewer.lanes().at(-1)?.[2] === 'WALK'")
    assert table.evaluate("__viewer.lanes().length") == walking
    table.keyboard.up("ArrowUp")


def test_a_layer_has_its_own_table_and_graph(table: Page) -> None:
    table.get_by_role("tab", name="head").click()
    until(table, "document.querySelector('#table tr[aria-current] th')?.textContent === 'REST'")
    until(table, "document.querySelector('#graph .live text')?.textContent === 'REST'")
    table.locator("[data-event=NOD]").click()
    table.wait_for_selector("#graph .edge[data-from=REST][data-to=NOD][data-fired=NOD]", state="attached")
