"""The state graph as an editor: labels, keys, places that stay, arrows made and deleted."""

from collections.abc import Callable, Iterator

import httpx
import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page

ARROW = ".edge[data-from=STUP][data-to=WALK]"
PLACES = """Object.fromEntries([...document.querySelectorAll('#graph .state')]
    .map(state => [state.dataset.state, state.getAttribute('transform')]))"""


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
    box = graph.locator("#graph .state[data-state=JUMP] .box").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    graph.mouse.move(x, y)
    graph.mouse.down()
    graph.mouse.move(x + 30, y + 20, steps=3)
    graph.mouse.up()
    until(graph, "window.__viewer.version() > arg", version)
    graph.reload()
    graph.wait_for_selector("#graph .state[data-state=WALK]")
    after = graph.evaluate(PLACES)
    assert after["JUMP"] != before["JUMP"]
    assert {name for name in after if after[name] != before[name]} == {"JUMP"}
    assert httpx.get(f"{walker.url}/api/machines/faq-walker").json()["view"]["base"].keys() == after.keys()
