"""The teachers' page: eight interpolations of the same keys, with angle, speed and acceleration; you edit the
keys as numbers, and drag them to other times.
"""

from collections.abc import Callable

import pytest
from browser.axe import begin, faults
from browser.conftest import Server, until
from playwright.sync_api import Page
from serving import wait_for

METHODS = (
    "linear, Euler XYZ",
    "linear, quaternion",
    "slerp",
    "squad",
    "B-spline near",
    "B-spline through",
    "NURBS near",
    "NURBS through",
)
QUANTITIES = ("angle_deg", "speed_deg", "acceleration_deg")
INK = """name => {
  const canvas = document.querySelector(`[data-quantity="${name}"] canvas`);
  const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const colours = new Set();
  for (let at = 0; at < data.length; at += 4)
    if (data[at + 3] > 200) colours.add([data[at], data[at + 1], data[at + 2]].map(v => v >> 5).join());
  return colours.size;
}"""
DRAWN = """() => {
  const canvas = document.querySelector('#figures'), copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  return new Promise(done => requestAnimationFrame(() => {
    const flat = copy.getContext('2d');
    flat.drawImage(canvas, 0, 0);
    const { data } = flat.getImageData(0, 0, copy.width, copy.height);
    done(data.filter((v, at) => at % 4 === 3 && v > 0).length);
  }));
}"""


@pytest.fixture
def curves(server: Server, page: Page) -> Page:
    page.goto(f"{server.url}/curves.html")
    until(page, "document.body.dataset.curves === '8'")
    return page


def answered(page: Page, act: Callable[[], None]) -> dict[str, list[dict[str, object]]]:
    """The curves that the server sends after an act."""
    with page.expect_response(lambda answer: answer.url.endswith("/api/curves")) as found:
        act()
    return found.value.json()


def test_every_interpolation_has_a_name_and_every_plot_its_unit(curves: Page) -> None:
    assert curves.locator("#names button").all_inner_texts() == list(METHODS)
    heads = curves.locator("#plots h2").all_inner_texts()
    assert heads == [
        "angle from the first key, °",
        "angular speed, °/s",
        "angular acceleration, °/s²",
    ]


def test_the_plots_and_the_figures_are_drawn(curves: Page) -> None:
    for name in QUANTITIES:
        assert curves.evaluate(INK, name) > 6  # the colours of the curves, of the grid and of the words
    assert curves.evaluate(DRAWN) > 1000


def test_a_hidden_curve_leaves_all_plots_and_has_no_arm(curves: Page) -> None:
    before = [curves.evaluate(INK, name) for name in QUANTITIES]
    drawn = curves.evaluate(DRAWN)
    for name in METHODS[1:]:
        curves.get_by_role("button", name=name, exact=True).click()
    after = [curves.evaluate(INK, name) for name in QUANTITIES]
    assert all(now < then for now, then in zip(after, before, strict=True))
    until(curves, f"(await ({DRAWN})()) < 0.5 * arg", drawn)
    curves.get_by_role("button", name="slerp", exact=True).click()
    until(curves, "document.querySelectorAll('#names button[aria-pressed=true]').length === 2")


def test_an_edited_key_changes_the_curves(curves: Page) -> None:
    answer = answered(curves, lambda: curves.get_by_label("z° of key 2").fill("80"))
    slerp = next(curve for curve in answer["curves"] if curve["interpolation"] == "slerp")
    at = round(0.6 / 3 * 360)
    assert abs(slerp["angle_deg"][at] - 80) < 1e-3


def test_a_dragged_key_moves_in_time_and_stays_between_its_neighbours(curves: Page) -> None:
    box = curves.get_by_label("key 2 at 0.6 s").bounding_box()
    line = curves.locator("#strip .line").bounding_box()
    assert box
    assert line
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def drag(seconds: float) -> None:
        curves.mouse.move(x, y)
        curves.mouse.down()
        curves.mouse.move(x + seconds / 3 * line["width"], y, steps=4)
        curves.mouse.up()

    answered(curves, lambda: drag(0.3))
    assert abs(float(curves.get_by_label("time, s of key 2").input_value()) - 0.9) < 0.02
    x += 0.3 / 3 * line["width"]
    answered(curves, lambda: drag(2.0))
    assert curves.get_by_label("time, s of key 2").input_value() == "1.19"


def test_keys_are_added_and_removed_and_a_fault_is_said(curves: Page) -> None:
    answered(curves, curves.get_by_role("button", name="add a key").click)
    until(curves, "document.querySelectorAll('#strip .diamond').length === 6")
    answered(curves, curves.get_by_label("remove key 6").click)
    curves.get_by_label("time, s of key 3").fill("0.1")
    curves.get_by_role("status").filter(has_text="key 3: times should rise").wait_for()


def test_the_clock_moves_the_figures(curves: Page) -> None:
    before = curves.screenshot(clip=curves.locator(".figures").bounding_box())
    curves.get_by_label("time", exact=True).locator("input").fill("0.2")
    curves.locator("output").filter(has_text="0.60 s").wait_for()
    wait_for(lambda: curves.screenshot(clip=curves.locator(".figures").bounding_box()) != before)


def test_the_page_can_be_read_and_hit(curves: Page) -> None:
    begin(curves)
    assert faults(curves) == []


@pytest.mark.parametrize("width", [390, 1440])
def test_nothing_is_wider_than_the_window(curves: Page, width: int) -> None:
    curves.set_viewport_size({"width": width, "height": 900})
    until(curves, "document.querySelector('.uplot').clientWidth <= innerWidth")
    until(curves, "document.documentElement.scrollWidth <= arg", width)


def test_a_link_shows_the_same_keys_and_curves(curves: Page) -> None:
    curves.context.grant_permissions(["clipboard-read", "clipboard-write"])
    answered(curves, lambda: curves.get_by_label("z° of key 2").fill("-80.5"))
    until(curves, "location.search.includes('-80.5')")
    curves.get_by_role("button", name="slerp", exact=True).click()
    curves.get_by_role("button", name="copy a link").click()
    curves.get_by_role("button", name="copied").wait_for()
    link = curves.evaluate("navigator.clipboard.readText()")
    curves.goto("about:blank")
    curves.goto(link)
    until(curves, "document.body.dataset.curves === '8'")
    assert curves.get_by_label("z° of key 2").input_value() == "-80.5"
    hidden = curves.locator("#names [aria-pressed=false]")
    assert hidden.all_inner_texts() == ["slerp"]


@pytest.mark.parametrize(("width", "height"), [(390, 844), (320, 640)])
def test_a_phone_has_room_for_the_whole_bar(curves: Page, width: int, height: int) -> None:
    curves.set_viewport_size({"width": width, "height": height})
    until(curves, "innerWidth === arg && document.querySelector('.bar').scrollWidth <= arg", width)
