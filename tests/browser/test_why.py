"""Any moment of the timeline tells why; what did not happen tells what would have made it; a state can be
gone to.
"""

from collections.abc import Callable, Iterator

import httpx
import pytest
from browser.conftest import Server, leave, passing, slowed, until
from playwright.sync_api import Page

CLICK_AT = """async tick => {
  const bar = document.querySelector('.scrub');
  while (Number(bar.max) < tick) await new Promise(done => setTimeout(done, 20));
  const box = document.querySelector('#lanes canvas').getBoundingClientRect();
  const at = (tick - Number(bar.min)) / (Number(bar.max) - Number(bar.min));
  return [box.left + at * box.width, box.top + 20];
}"""


@pytest.fixture
def still(server: Server, opened: Callable[[str], Page]) -> Iterator[Page]:
    """A page at a stage that moves only when it is told to: FORWARD in tick 11, JUMP in tick 31, 50 ticks in
    all.
    """
    machine = httpx.get(f"{server.url}/api/machines").json()[0]["name"]
    stage = httpx.post(
        f"{server.url}/api/stages", json={"clock": "manual", "actors": [{"machine": machine}]}
    ).headers["Location"]
    for event, ticks in (("FORWARD", 20), ("JUMP", 30)):
        httpx.post(f"{server.url}{stage}/step", json={"ticks": 10})
        httpx.post(f"{server.url}{stage}/events", json={"event": event})
        httpx.post(f"{server.url}{stage}/step", json={"ticks": ticks - 10})
    page = opened(f"{server.url}/?stage={stage.rsplit('/', 1)[1]}")
    yield page
    leave(page, f"{server.url}{stage}")


def why(page: Page, tick: int) -> None:
    """Clicks on a tick of the timeline and waits for its explanation."""
    page.mouse.click(*page.evaluate(CLICK_AT, tick))
    until(page, "document.querySelector('#why').dataset.tick === String(arg)", tick)


def test_a_click_on_the_timeline_tells_why(still: Page) -> None:
    why(still, 11)
    told = still.locator(".event-why[data-about=FORWARD]").filter(has_text="taken").inner_text()
    assert [part in told for part in ("taken", "STAT/FORWARD", "STAT → STWK")] == [True, True, True]
    until(still, "__viewer.looking() === 11")


def test_a_stay_is_told_without_a_reason(server: Server, still: Page) -> None:
    """A second FORWARD changes nothing: the page says so in the result, and gives no reason."""
    stage, head = still.evaluate("[__viewer.stage(), __viewer.head()]")
    url = f"{server.url}/api/stages/{stage}"
    httpx.post(f"{url}/events", json={"event": "FORWARD"}).raise_for_status()
    httpx.post(f"{url}/step", json={"ticks": 2}).raise_for_status()
    still.locator("#verdict").filter(has_text="stays in STWK").wait_for()
    why(still, head + 1)
    told = still.locator(".event-why[data-about=FORWARD]")
    told.filter(has_text="taken").wait_for()
    rows = dict(zip(told.locator("dt").all_inner_texts(), told.locator("dd").all_inner_texts(), strict=True))
    assert rows["so"] == "stays in STWK"
    assert "because" not in rows


def test_the_cell_is_shown_in_the_table(still: Page) -> None:
    why(still, 11)
    still.locator(".event-why .where").click()
    until(
        still,
        "document.activeElement?.dataset.state === 'STAT' && document.activeElement.dataset.column === "
        "'FORWARD'",
    )


def test_it_follows_the_shown_tick_of_the_past_and_stays_while_the_page_is_live(still: Page) -> None:
    told = still.locator("#why .event-why[data-about=FORWARD]")
    why(still, 11)
    told.wait_for()
    still.get_by_role("button", name="one tick forward").click()
    still.get_by_role("heading", name="why, in tick 12").wait_for()
    told.wait_for(state="detached")
    still.keyboard.press(",")
    still.get_by_role("heading", name="why, in tick 11").wait_for()
    told.wait_for()
    still.keyboard.press("l")
    until(still, "__viewer.looking() === null && __viewer.tick() === 50")
    still.keyboard.press(".")
    until(still, "__viewer.tick() === 51")
    assert still.get_by_role("heading", name="why, in tick 11").is_visible()


EXPLAINS_11 = "window.__viewer?.ready && (({ hidden, dataset }) => !hidden && dataset.tick === '11')(why)"


def test_a_copied_link_leads_to_the_explained_tick_and_back_opens_it_again(still: Page) -> None:
    """Also while the page shows another tick."""
    still.context.grant_permissions(["clipboard-read", "clipboard-write"])
    why(still, 11)
    still.keyboard.press("l")
    until(still, "__viewer.looking() === null && __viewer.tick() === 50")
    still.keyboard.press("y")
    still.get_by_text("Copied: a link to tick 11,").wait_for()
    other = still.context.new_page()
    other.goto(still.evaluate("navigator.clipboard.readText()"))
    until(other, f"{EXPLAINS_11} && __viewer.posed() === 11")
    until(still, "location.search.includes('why=11') && !location.search.includes('tick=')")
    still.keyboard.press("h")
    until(still, "__viewer.stage() === 'main' && __viewer.ready && why.hidden")
    still.go_back()
    until(still, f"__viewer.stage() !== 'main' && {EXPLAINS_11} && __viewer.looking() === null")
    still.go_forward()
    until(still, "__viewer.stage() === 'main' && __viewer.ready && why.hidden")


def test_escape_closes_it(still: Page) -> None:
    why(still, 11)
    still.locator("#why [aria-label^=close]").focus()
    still.keyboard.press("Escape")
    until(still, "document.querySelector('#why').hidden")


def test_why_not_proposes_what_helps_and_the_cell_takes_it(still: Page) -> None:
    """JUMP does nothing in STAT; the remedy that changes the cell is put into it, and tried. The table
    declares that JUMP comes only after WALK, so the trial is refused.
    """
    why(still, 5)
    still.locator(".why-not select").select_option("JUMP")
    until(still, "document.querySelector('.remedies [data-kind=cell] button')")
    still.locator(".remedies [data-kind=cell] button").first.click()
    until(still, "document.querySelector('.cell-field').value.startsWith('JUMP')")
    until(still, "document.querySelector('.cell-field').ariaInvalid === 'true'")
    still.locator("#cell-inspector").filter(has_text="only after WALK").wait_for()
    still.keyboard.press("Escape")


@pytest.fixture
def unhurried(server: Server, viewer: Page) -> Iterator[Page]:
    """A walker who stands, and whose ways last eight times as long, so that a busy page shows them."""
    until(viewer, "__viewer.state() === 'STAT'")
    slowed(server, viewer, 1 / 8)
    yield viewer
    slowed(server, viewer, 1)


def test_a_travel_shows_its_route(server: Server, unhurried: Page) -> None:
    with passing(unhurried, "JUMP"):
        unhurried.locator("#table th[data-state=JUMP] .go").click()
        until(unhurried, "!document.querySelector('#route').hidden")
        unhurried.locator("#route").filter(has_text="JUMP").wait_for()
        slowed(server, unhurried, 1)
    until(unhurried, "document.querySelector('#route').hidden")


def test_the_way_can_be_cancelled(unhurried: Page) -> None:
    unhurried.locator("#table th[data-state=LAND] .go").click()
    until(unhurried, "!document.querySelector('#route').hidden")
    unhurried.get_by_role("button", name="cancel", exact=True).click()
    until(unhurried, "document.querySelector('#route').hidden")


def test_lanes_tell_taken_from_waiting_and_dropped(still: Page) -> None:
    """What this page has not seen itself it asks for; the states are there, and the clock stands still."""
    until(still, "__viewer.lanes().map(([, , state]) => state).join() === 'STAT,STWK'")
