"""The state graph: what the mouse lights, zooms and moves, places that stay, arrows made and deleted."""

import re
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


def test_a_clicked_arrow_shows_its_cell_which_gets_another_blend(graph: Page, walker: Server) -> None:
    """The arrow is selected, and stays so after the edit."""
    arrow = graph.locator("#graph .edge[data-from=CRCH][data-to=STUP]")
    place = arrow.locator("path").first.evaluate(
        """path => {
          const { x, y } = path.getPointAtLength(path.getTotalLength() / 2);
          const { a, d, e, f } = path.getScreenCTM();
          return [a * x + e, d * y + f];
        }"""
    )
    graph.mouse.click(*place)
    until(graph, "document.querySelector('#graph .edge[aria-pressed=true]')?.dataset.from === 'CRCH'")
    graph.get_by_role("button", name="inspect").click()
    graph.locator("#cell h2").filter(has_text="CRCH END").wait_for()
    before = newest(walker)
    graph.get_by_label("blend, s").fill("0.35")
    graph.keyboard.press("Enter")
    until(graph, "__viewer.version() > arg", before)
    found = httpx.get(f"{walker.url}/api/machines/faq-walker").json()["table"]["CRCH"]["END"]
    assert (found["blend"], found["to"]) == (0.35, "STUP")
    assert arrow.get_attribute("aria-pressed") == "true"


FOCUSED = "(({ state, from, to }) => state ?? `${from} ${to}`)(document.activeElement.dataset)"


def test_the_keyboard_goes_from_state_to_state_and_along_the_arrows(graph: Page) -> None:
    """An arrow key leads to a state in its direction; N and P go round the arrows that leave a state."""
    graph.locator("#graph .state[data-state=WALK]").focus()
    here, found = middle(graph, "WALK"), {}
    for key, axis, sign in (
        ("ArrowUp", 1, -1),
        ("ArrowDown", 1, 1),
        ("ArrowLeft", 0, -1),
        ("ArrowRight", 0, 1),
    ):
        graph.keyboard.press(key)
        found[key] = graph.evaluate(FOCUSED)
        away = sign * (middle(graph, found[key])[axis] - here[axis])
        assert found[key] == "WALK" or away > 0
        graph.locator("#graph .state[data-state=WALK]").focus()
    assert len(set(found.values()) - {"WALK"}) > 1
    around = []
    for key in "nnnnnp":
        graph.keyboard.press(key)
        around.append(graph.evaluate(FOCUSED))
    leaving = [f"WALK {state}" for state in ("TLFT", "TRGT", "CSTP", "JUMP")]
    assert around == [*leaving, leaving[0], leaving[-1]]
    graph.keyboard.press("ArrowRight")
    assert graph.evaluate(FOCUSED) == "JUMP"


PRESS_TOGETHER = """keys => keys.forEach(key => document.activeElement.dispatchEvent(
  new KeyboardEvent('keydown', { key, shiftKey: true, bubbles: true, cancelable: true })))"""
"""presses keys without a pause between them, which on a slow machine would end the edit"""


def test_the_keyboard_moves_a_state_in_one_edit(graph: Page, walker: Server) -> None:
    before, version = graph.evaluate(PLACES), newest(walker)
    graph.locator("#graph .state[data-state=LAND]").focus()
    graph.evaluate(PRESS_TOGETHER, ["ArrowRight", "ArrowRight", "ArrowRight", "ArrowDown"])
    until(graph, "__viewer.version() > arg", version)
    after = graph.evaluate(PLACES)
    assert {name for name in after if after[name] != before[name]} == {"LAND"}
    (x, y), (to_x, to_y) = (map(float, re.findall(r"[-\d.]+", places["LAND"])) for places in (before, after))
    assert (to_x - x, to_y - y) == pytest.approx((24, 8), abs=0.1)
    assert newest(walker) == version + 1
    assert graph.evaluate("__viewer.state()") == "STAT"  # no key reached the character


def test_keys_and_buttons_zoom_the_graph(graph: Page) -> None:
    """The middle stays where it is; 0 shows all of the graph again."""
    whole = graph.evaluate(SHOWN)
    graph.locator("#graph .state[data-state=WALK]").focus()
    zoomed = []
    for key in "++-":
        graph.keyboard.press(key)
        zoomed.append(graph.evaluate(SHOWN)[0] / whole[0])
    assert zoomed == pytest.approx([1.25, 1.25**2, 1.25], rel=0.01)
    graph.keyboard.press("0")
    assert graph.evaluate(SHOWN) == pytest.approx(whole, abs=0.1)
    graph.get_by_role("button", name="zoom out").click()
    assert graph.evaluate(SHOWN)[0] == pytest.approx(whole[0] / 1.25, rel=0.01)
    graph.get_by_role("button", name="zoom in").click()
    assert graph.evaluate(SHOWN) == pytest.approx(whole, abs=0.5)


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
