"""BT1 the tentacle in the page: the keys of the paper, a dragged target, keys that change parameters."""

from collections.abc import Callable, Iterator
from typing import Any

import httpx
import numpy as np
import pytest
from browser.conftest import Server, leave, until
from playwright.sync_api import Page
from serving import wait_for

PLACE = "() => __viewer.handles().target"


@pytest.fixture
def tentacle(server: Server, opened: Callable[[str], Page]) -> Iterator[Page]:
    """The page on a stage of its own with the tentacle."""
    made = httpx.post(f"{server.url}/api/stages", json={"actors": [{"machine": "tentacle"}]}, timeout=60)
    stage = made.raise_for_status().headers["Location"]
    page = opened(f"{server.url}/?stage={stage.rsplit('/', 1)[1]}")
    yield page
    leave(page, f"{server.url}{stage}")


def actor(server: Server, page: Page) -> Any:
    """The facts of the tentacle."""
    stage = page.evaluate("__viewer.stage()")
    (facts,) = httpx.get(f"{server.url}/api/stages/{stage}").json()["actors"]
    return facts


def states(page: Page, *names: str) -> None:
    """Waits until the layers are in these states."""
    until(page, "__viewer.layerStates().join() === arg", ",".join(names))


def pressed(page: Page, name: str) -> bool:
    return page.get_by_role("button", name=name, exact=True).get_attribute("aria-pressed") == "true"


def hold(page: Page, key: str, done: Callable[[], bool]) -> None:
    page.keyboard.down(key)
    wait_for(done)
    page.keyboard.up(key)


def test_p_f_and_i_are_events_of_the_machine(tentacle: Page) -> None:
    states(tentacle, "SWAY", "OFF", "NONE")
    for key, seen in (
        ("p", ("STILL", "OFF", "NONE")),
        ("i", ("POINT", "OFF", "NONE")),
        ("f", ("POINT", "ON", "ROOT")),
        ("3", ("POINT", "ON", "TIP")),
        ("p", ("REACH", "ON", "TIP")),
        ("f", ("REACH", "OFF", "NONE")),
        ("i", ("SWAY", "OFF", "NONE")),
    ):
        tentacle.keyboard.press(key)
        states(tentacle, *seen)


def test_b_r_and_t_change_the_view_alone(server: Server, tentacle: Page) -> None:
    assert tentacle.evaluate("__viewer.overlays()") == 0
    tentacle.keyboard.press("b")
    until(tentacle, "__viewer.overlays() === 1")
    tentacle.keyboard.press("t")
    wait_for(lambda: (pressed(tentacle, "wire"), pressed(tentacle, "skin")) == (True, False))
    tentacle.keyboard.press("t")
    wait_for(lambda: (pressed(tentacle, "wire"), pressed(tentacle, "skin")) == (False, True))
    tentacle.keyboard.press("i")
    until(tentacle, "__viewer.handles().target")
    before = np.array(tentacle.evaluate(PLACE))
    tentacle.keyboard.press("r")  # the target stands still, the view turns
    wait_for(lambda: bool(np.linalg.norm(np.array(tentacle.evaluate(PLACE)) - before) > 20))
    wait_for(lambda: pressed(tentacle, "turntable"))
    tentacle.keyboard.press("r")
    wait_for(lambda: not pressed(tentacle, "turntable"))
    assert actor(server, tentacle)["parameters"]["target"] == [0.85, 0.85, 0.2]


def by_mouse(page: Page, places: list[tuple[float, float]]) -> None:
    page.mouse.move(*places[0])
    page.mouse.down()
    for place in places[1:]:
        page.mouse.move(*place)
    page.mouse.up()


def by_finger(page: Page, places: list[tuple[float, float]]) -> None:
    session = page.context.new_cdp_session(page)
    for kind, place in zip(("touchStart", *("touchMove",) * (len(places) - 1)), places, strict=True):
        points = [{"x": place[0], "y": place[1]}]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


@pytest.mark.parametrize("drag", [by_mouse, by_finger])
def test_the_tip_travels_to_a_dragged_target(
    server: Server, tentacle: Page, drag: Callable[[Page, list[tuple[float, float]]], None]
) -> None:
    tentacle.keyboard.press("i")
    wait_for(lambda: actor(server, tentacle)["reached"][0]["reached"])
    until(tentacle, "'target' in __viewer.handles()")
    x, y = tentacle.evaluate(PLACE)
    drag(tentacle, [(x - 22 * step, y - 4 * step) for step in range(9)])
    until(tentacle, f"({PLACE})().every((at, i) => Math.abs(at - arg[i]) < 2)", [x - 176, y - 32])
    wait_for(lambda: actor(server, tentacle)["parameters"]["target"][0] < 0.5)
    wait_for(lambda: actor(server, tentacle)["reached"][0]["reached"])
    target = actor(server, tentacle)["parameters"]["target"]
    until(tentacle, "Math.hypot(...__viewer.joints().tip.map((c, i) => c - arg[i])) < 1e-3", target)
    tentacle.keyboard.press("i")
    until(tentacle, "!('target' in __viewer.handles())")


def test_arrows_and_pages_move_the_target(server: Server, tentacle: Page) -> None:
    tentacle.keyboard.press("i")
    states(tentacle, "REACH", "OFF", "NONE")
    for key, axis, sign in (
        ("ArrowLeft", 0, -1),
        ("ArrowUp", 1, 1),
        ("PageUp", 2, -1),
        ("PageDown", 2, 1),
        ("ArrowDown", 1, -1),
        ("ArrowRight", 0, 1),
    ):
        before = actor(server, tentacle)["parameters"]["target"][axis]

        def has_moved(axis: int = axis, sign: int = sign, before: float = before) -> bool:
            return bool(sign * (actor(server, tentacle)["parameters"]["target"][axis] - before) > 0.1)

        hold(tentacle, key, has_moved)
    assert tentacle.evaluate("[document.scrollingElement.scrollTop, scrollY]") == [0, 0]


def test_arrows_turn_the_chosen_bones(server: Server, tentacle: Page) -> None:
    assert tentacle.get_by_label("tip_bend").count() == 0
    tentacle.keyboard.press("3")
    states(tentacle, "SWAY", "ON", "TIP")
    hold(tentacle, "ArrowDown", lambda: actor(server, tentacle)["parameters"]["tip_bend"] > 20)
    hold(tentacle, "PageUp", lambda: actor(server, tentacle)["parameters"]["tip_twist"] > 10)
    facts = actor(server, tentacle)["parameters"]
    assert (facts["root_bend"], facts["middle_bend"], facts["tip_side"]) == (0, 0, 0)
    slider = tentacle.get_by_label("tip_bend")
    wait_for(
        lambda: abs(float(slider.input_value()) - actor(server, tentacle)["parameters"]["tip_bend"]) < 1.3
    )
    tentacle.reload()  # the values are the server's
    until(tentacle, "window.__viewer?.ready")
    until(tentacle, "document.querySelector('[aria-label=tip_bend]')?.value > 18")
