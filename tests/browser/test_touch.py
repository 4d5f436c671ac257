"""What fingers do on a phone: they hold a button, turn and zoom the picture, the graph and the timeline."""

from collections.abc import Callable, Iterator
from typing import Any

import httpx
import pytest
from browser.conftest import Server, leave, until
from browser.test_graph import PLACES, SHOWN
from browser.test_timeline import LENGTH
from browser.touching import inside, line, pinched, pressed, swipe
from playwright.sync_api import Page

MACHINE = "touched"


@pytest.fixture(params=[(390, 844, "dark"), (320, 640, "light")], ids=["phone", "small phone"])
def window(request: pytest.FixtureRequest) -> dict[str, Any]:
    width, height, theme = request.param
    size = {"width": width, "height": height}
    return {"viewport": size, "has_touch": True, "is_mobile": True, "color_scheme": theme}


@pytest.fixture
def phone(server: Server, opened: Callable[[str], Page]) -> Iterator[Page]:
    """A phone that shows a machine which may be edited, on a stage of its own."""
    copy = {"name": MACHINE, "copy_of": "faq-walker"}
    httpx.post(f"{server.url}/api/machines", json=copy, timeout=60).raise_for_status()
    made = httpx.post(f"{server.url}/api/stages", json={"actors": [{"machine": MACHINE}]}, timeout=60)
    stage = made.raise_for_status().json()["id"]
    page = opened(f"{server.url}/?stage={stage}")
    page.locator("#graph .state").first.wait_for()
    yield page
    leave(page, f"{server.url}/api/stages/{stage}", f"{server.url}/api/machines/{MACHINE}")


def test_a_finger_that_stays_on_a_button_holds_its_key(phone: Page) -> None:
    with pressed(phone, inside(phone.locator("[data-event=FORWARD]"))):
        until(phone, "__viewer.state() === 'WALK'")
        begun = phone.evaluate("__viewer.head()")
        until(phone, "__viewer.head() > arg + 90", begun)
        assert phone.evaluate("__viewer.state()") == "WALK"
    until(phone, "__viewer.state() === 'STAT'")


def test_one_finger_turns_the_picture_and_two_bring_it_closer(phone: Page) -> None:
    picture, before = phone.locator("#stage-view"), phone.evaluate("__viewer.camera().position")
    swipe(phone, line(inside(picture, 0.3, 0.8), inside(picture, 0.6, 0.8)))
    until(phone, "Math.hypot(...__viewer.camera().position.map((c, i) => c - arg[i])) > 0.3", before)
    far = "(({ position: p, target }) => Math.hypot(...p.map((c, i) => c - target[i])))(__viewer.camera())"
    before = phone.evaluate(far)
    swipe(phone, *pinched(picture, 140))
    until(phone, f"{far} < 0.8 * arg", before)


def test_two_fingers_zoom_the_graph_and_one_moves_a_state(phone: Page) -> None:
    before, places = phone.evaluate(SHOWN), phone.evaluate(PLACES)
    x, y = inside(phone.locator("#graph .state[data-state=FLY] .box"))
    swipe(phone, line((x, y), (x + 24, y - 16)))
    until(phone, "__viewer.version() === 2")
    after = phone.evaluate(PLACES)
    assert [name for name in after if after[name] != places[name]] == ["FLY"]
    swipe(phone, *pinched(phone.locator("#graph > svg"), 100))
    until(phone, f"{SHOWN}[0] > 1.5 * arg", before[0])


def test_a_finger_draws_an_arrow_from_the_dot_of_a_state(phone: Page) -> None:
    """A tap shows the dot; the arrow asks for its event, which the phone's keyboard types."""
    phone.locator("#graph .state[data-state=STUP]").tap()
    dot = phone.locator("#graph .state[data-state=STUP] .dot")
    until(phone, "getComputedStyle(arg).visibility === 'visible'", dot.element_handle())
    target = inside(phone.locator("#graph .state[data-state=WALK] .box"))
    swipe(phone, line(inside(dot), target))
    phone.get_by_placeholder("STUP to WALK on").wait_for()
    phone.keyboard.type("LEFT")
    phone.keyboard.press("Enter")
    until(phone, "document.querySelector('#graph .edge[data-from=STUP][data-to=WALK]') !== null")
    made = httpx.get(f"{phone.url.split('?')[0]}api/machines/{MACHINE}").json()["table"]["STUP"]["LEFT"]
    assert made["to"] == "WALK"


def test_fingers_zoom_the_timeline_and_select_a_span(phone: Page) -> None:
    lanes = phone.locator("#lanes canvas")
    until(phone, "__viewer.head() > 150")
    phone.get_by_role("button", name="pause", exact=True).tap()
    phone.wait_for_selector("[data-link=paused]")
    whole = phone.evaluate(LENGTH)
    swipe(phone, *pinched(lanes, 120))
    until(phone, f"{LENGTH} < 0.7 * arg", whole)
    phone.get_by_role("button", name="select", exact=True).tap()
    swipe(phone, line(inside(lanes, 0.3), inside(lanes, 0.6)))
    phone.locator("#span").get_by_role("button", name="loop").tap()
    until(phone, "__viewer.looking() !== null")
