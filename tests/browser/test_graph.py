"""The state graph: what the mouse lights, zooms and moves, places that stay, arrows made and deleted."""

from collections.abc import Callable, Iterator

import httpx
import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page

ARROW = ".edge[data-from=STUP][data-to=WALK]"
PLACES = """Object.fromEntries([...document.querySelectorAll('#graph .state')]
    .map(state => [state.dataset.state, state.getAttribute('transform')]))"""

SHOWN = """(() => {
  const { matrix } = document.querySelector('#graph .world').transform.baseVal.consolidate();
  return [matrix.a, matrix.e, matrix.f];
})()"""
"""the zoom of the graph, and where its origin stands, pixels"""
LIT = (
    """[...document.querySelectorAll('#graph .edge.lit')].map(({ dataset }) => [dataset.from, dataset.to])"""
)
AT_WALK = """[...document.querySelectorAll('#graph .edge')].map(({ dataset }) => [dataset.from, dataset.to])
    .filter((states) => states.includes('WALK'))"""


@pytest.fixture(scope="module")
def walker(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server whose machine these tests edit."""
    with Server(tmp_path_factory.mktemp("data")) as running:
        yield running


@pytest.fixture
def graph(walker: Server, opened: Callable[[str], Page]) -> Page:
    """The page with the walker's graph."""
    page = opened(walker.url)
    page.wait_for_selector("#graph .state[data-state=WALK]")
    return page


def cell(server: Server, state: str, event: str) -> str | None:
    """Where a cell of the machine leads."""
    found = httpx.get(f"{server.url}/api/machines/faq-walker").json()["table"].get(state, {}).get(event)
    return None if found is None else found["to"]


def newest(server: Server) -> int:
    """The newest version of the machine."""
    return int(httpx.get(f"{server.url}/api/machines/faq-walker").json()["version"])


def middle(page: Page, state: str) -> tuple[float, float]:
    """Where the middle of a state is drawn, pixels."""
    box = page.locator(f"#graph .state[data-state={state}] .box").bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def drag(page: Page, start: tuple[float, float], end: tuple[float, float]) -> None:
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(*end, steps=4)
    page.mouse.up()


def test_the_mouse_lights_zooms_and_moves_the_graph(graph: Page) -> None:
    """The state under the pointer stays there while the wheel zooms; *fit* shows all of the graph again."""
    whole = graph.evaluate(SHOWN)
    graph.mouse.move(*middle(graph, "WALK"))
    until(graph, f"{LIT}.length > 0")
    assert graph.evaluate(LIT) == graph.evaluate(AT_WALK)
    x, y = middle(graph, "WALK")
    graph.mouse.wheel(0, -300)
    until(graph, f"{SHOWN}[0] > 1.5 * arg", whole[0])
    assert middle(graph, "WALK") == pytest.approx((x, y), abs=1)
    canvas = graph.locator("#graph > svg").bounding_box()
    assert canvas is not None
    zoom, *origin = graph.evaluate(SHOWN)
    drag(graph, (canvas["x"] + 6, canvas["y"] + 6), (canvas["x"] + 46, canvas["y"] + 36))
    assert graph.evaluate(SHOWN) == pytest.approx([zoom, origin[0] + 40, origin[1] + 30], abs=0.1)
    assert graph.evaluate(LIT) == []
    graph.get_by_role("button", name="fit the graph").click()
    assert graph.evaluate(SHOWN) == pytest.approx(whole, abs=0.1)


def test_an_arrow_drawn_by_mouse_makes_a_cell(graph: Page, walker: Server) -> None:
    """Without an event, nothing is made."""
    before, box = newest(walker), graph.locator("#graph .state[data-state=STUP] .box").bounding_box()
    assert box is not None
    rim = (box["x"] + box["width"], box["y"] + box["height"] / 2)
    for key in ("Escape", "Enter"):
        drag(graph, rim, middle(graph, "TLFT"))
        graph.get_by_role("combobox", name="STUP to TLFT on").wait_for()
        graph.keyboard.type("RIGHT")
        graph.keyboard.press(key)
    graph.wait_for_selector("#graph .edge[data-from=STUP][data-to=TLFT][aria-pressed=true]")
    assert (cell(walker, "STUP", "RIGHT"), newest(walker)) == ("TLFT", before + 1)


def test_the_keyboard_makes_and_deletes_an_arrow(graph: Page, walker: Server) -> None:
    graph.locator("#graph .state[data-state=STUP]").focus()
    graph.keyboard.press("a")
    for state in ("STAT", "WALK"):
        graph.evaluate(f"document.querySelector('#graph .state[data-state={state}]').focus()")
    graph.keyboard.press("Enter")
    graph.keyboard.type("LEFT")
    graph.keyboard.press("Enter")
    graph.wait_for_selector(f"#graph {ARROW}[aria-pressed=true]")
    assert cell(walker, "STUP", "LEFT") == "WALK"
    graph.locator(f"#graph {ARROW}").focus()
    graph.keyboard.press("Delete")
    until(graph, f"!document.querySelector('#graph {ARROW}')")
    assert cell(walker, "STUP", "LEFT") is None


def test_the_filter_of_a_large_table_chooses_what_the_graph_shows(graph: Page, walker: Server) -> None:
    """Without it, the graph shows the live state and its neighbours, as it does again afterwards."""
    url, version = f"{walker.url}/api/machines/faq-walker", newest(walker)
    added = [{"kind": "add_state", "state": f"SPARE{number}"} for number in range(30)]
    match = {"If-Match": f'"{version}"'}
    httpx.patch(url, json={"operations": added}, headers=match).raise_for_status()
    graph.locator("#graph").get_by_text("of 41 states").wait_for()
    shown = "[...document.querySelectorAll('#graph .state')].map(state => state.dataset.state).join()"
    around = graph.evaluate(shown)
    graph.get_by_role("searchbox", name="filter states and events").fill("RE2 LAND")
    until(graph, f"{shown} === 'LAND,SPARE2,' + [...Array(10).keys()].map(i => 'SPARE2' + i)")
    graph.keyboard.press("Escape")
    until(graph, f"{shown} === arg", around)
    httpx.post(f"{url}/undo", headers={"If-Match": f'"{version + 1}"'}).raise_for_status()
    until(graph, "document.querySelectorAll('#graph .state').length === 11")


def test_a_dragged_state_stays_where_it_is_and_moves_no_other(graph: Page, walker: Server) -> None:
    before, version = graph.evaluate(PLACES), newest(walker)
    x, y = middle(graph, "JUMP")
    drag(graph, (x, y), (x + 30, y + 20))
    until(graph, "window.__viewer.version() > arg", version)
    graph.reload()
    graph.wait_for_selector("#graph .state[data-state=WALK]")
    after = graph.evaluate(PLACES)
    assert after["JUMP"] != before["JUMP"]
    assert {name for name in after if after[name] != before[name]} == {"JUMP"}
    assert httpx.get(f"{walker.url}/api/machines/faq-walker").json()["view"]["base"].keys() == after.keys()


def test_arranging_forgets_the_places_that_the_file_keeps(graph: Page, walker: Server) -> None:
    """The graph is then as a new page lays it out; an undo gives the places back."""
    version = newest(walker)
    x, y = middle(graph, "FLY")
    drag(graph, (x, y), (x + 30, y + 20))
    until(graph, "window.__viewer.version() === arg", version + 1)
    kept = graph.evaluate(PLACES)
    graph.get_by_role("button", name="lay the graph out anew").click()
    until(graph, "window.__viewer.version() === arg", version + 2)
    until(graph, f"JSON.stringify({PLACES}) !== JSON.stringify(arg)", kept)
    arranged = graph.evaluate(PLACES)
    assert httpx.get(f"{walker.url}/api/machines/faq-walker").json()["view"] == {}
    graph.reload()
    graph.wait_for_selector("#graph .state[data-state=WALK]")
    assert graph.evaluate(PLACES) == arranged
    graph.get_by_role("button", name="undo").click()
    until(graph, f"JSON.stringify({PLACES}) === JSON.stringify(arg)", kept)


OVERLAPPING = """[...document.querySelectorAll('#graph .edge:not(.squeezed) text')]
  .map(text => text.getBoundingClientRect())
  .some((a, i, all) => all.slice(i + 1).some(
    b => a.left < b.right && b.left < a.right && a.top + 1 < b.bottom && b.top + 1 < a.bottom))"""


def test_the_labels_of_two_opposite_arrows_do_not_overlap(
    server: Server, opened: Callable[[str], Page]
) -> None:
    page = opened(f"{server.url}?machine=anchor-chain")
    until(page, "document.querySelectorAll('#graph .edge:not(.squeezed) text').length === 2")
    until(page, f"!({OVERLAPPING})")
