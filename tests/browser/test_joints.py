"""The free end of a chain, and handles at joints, dragged with the mouse; joints chosen by a click."""

import math
from collections.abc import Callable
from typing import Any

import httpx
import pytest
from browser.conftest import Server, controls, slowed, until
from playwright.sync_api import Page
from serving import wait_for

Open = Callable[[str], Page]


def opening(server: Server, opened: Open, machine: str) -> Page:
    """The page with one actor of a machine."""
    body = {"clock": "real", "actors": [{"machine": machine}]}
    stage = httpx.post(f"{server.url}/api/stages", json=body, timeout=60).json()["id"]
    return opened(f"{server.url}/?stage={stage}")


def actor(server: Server, page: Page) -> dict[str, Any]:
    stage = page.evaluate("__viewer.stage()")
    (found,) = httpx.get(f"{server.url}/api/stages/{stage}").json()["actors"]
    return found


def dragged(page: Page, handle: str, x: float, y: float, steps: int = 8) -> tuple[float, float]:
    """Drags a handle by (x, y) pixels, and keeps the button down; returns the place of the pointer."""
    until(page, "arg in __viewer.handles()", handle)
    at, now = (math.inf, math.inf), page.evaluate("arg => __viewer.handles()[arg]", handle)
    while math.dist(at, now) > 3:  # it moved while the pointer came
        at = now
        page.mouse.move(*at)
        now = page.evaluate("arg => __viewer.handles()[arg]", handle)
    page.mouse.down()
    for step in range(1, steps + 1):
        page.mouse.move(at[0] + x * step / steps, at[1] + y * step / steps)
    return at[0] + x, at[1] + y


@pytest.fixture
def ship(server: Server, opened: Open) -> Page:
    return opening(server, opened, "anchor-chain")


def test_the_end_of_the_chain_is_dragged_and_falls_when_it_is_let_go(server: Server, ship: Page) -> None:
    before = ship.evaluate("__viewer.joints()")
    x, y = dragged(ship, "anchor", 90, -80)
    wait_for(lambda: actor(server, ship)["reached"][0]["reached"])
    held = ship.evaluate("__viewer.handles().anchor")
    assert abs(held[0] - x) + abs(held[1] - y) < 3
    now = ship.evaluate("__viewer.joints()")
    assert now["Link01"] == before["Link01"]  # the fixed end
    high = now["Crown"][1]
    assert high > before["Crown"][1] + 0.3
    ship.mouse.up()
    until(ship, "__viewer.joints().Crown[1] < arg", high - 0.3)
    assert actor(server, ship)["reached"][0]["weight"] == 0
    until(ship, "Math.abs(__viewer.handles().anchor[0] - arg) > 5", x)  # the handle swings with it


def test_moored_the_ship_is_dragged_and_the_anchor_stays(server: Server, ship: Page) -> None:
    ship.keyboard.press("m")
    wait_for(lambda: actor(server, ship)["reached"][1]["reached"])
    moored = ship.evaluate("__viewer.joints()")
    dragged(ship, "ship", -30, -10)
    until(ship, "Math.abs(__viewer.joints().Ship[0] - arg) > 0.1", moored["Ship"][0])
    now = ship.evaluate("__viewer.joints()")
    assert max(abs(a - b) for a, b in zip(now["Crown"], moored["Crown"], strict=True)) < 5e-3
    ship.mouse.up()


def test_a_handle_turns_its_joint_up_to_its_limit(server: Server, opened: Open) -> None:
    page = opening(server, opened, "joints.hinge")
    slowed(server, page, 0.02)  # the handle moves on while the pointer comes
    dragged(page, "B angle", 60, 10)
    slowed(server, page, 1)
    until(page, "__viewer.state() === 'TRY'")
    page.mouse.move(*dragged_far(page))
    label = page.locator(".joint-value")
    label.wait_for()
    label.filter(has_text="80.0°").wait_for()
    text = page.locator("#joint").text_content() or ""
    assert "R1" in text
    assert "(-80.0° … 80.0°)" in text
    page.mouse.up()
    label.wait_for(state="hidden")
    stage, number = page.evaluate("__viewer.stage()"), actor(server, page)["id"]

    def turn() -> float:
        pose = httpx.get(f"{server.url}/api/stages/{stage}/actors/{number}/pose").json()
        return float(abs(pose["rotation"][pose["names"].index("B")][2]))

    wait_for(lambda: abs(turn() - 0.6428) < 2e-3)  # the sine of half of 80 degrees


def dragged_far(page: Page) -> tuple[float, float]:
    """A place far on the other side of the limit."""
    box = page.locator("#stage-view").bounding_box()
    assert box
    return box["x"] + 0.8 * box["width"], box["y"] + 0.95 * box["height"]


def test_a_joint_without_a_handle_is_tried(server: Server, viewer: Page) -> None:
    viewer.keyboard.press("3")  # bones
    viewer.keyboard.press("p")
    wait_for(lambda: viewer.evaluate("__viewer.stats().hz") == 0)
    before = viewer.evaluate("__viewer.hash()")
    viewer.mouse.click(*viewer.evaluate("__viewer.circle('Right.hand')"))
    until(viewer, "__viewer.joint() === 'Right.hand'")
    dragged(viewer, "joint", -40, -60)
    trial = viewer.locator("#trial")
    trial.wait_for()
    wait_for(lambda: trial.text_content() == "trial: Right.hand reaches")
    viewer.mouse.move(*dragged_far(viewer))
    wait_for(lambda: "cm away" in (trial.text_content() or ""))
    viewer.mouse.up()
    assert viewer.evaluate("__viewer.hash()") == before  # nothing on the stage has changed
    viewer.keyboard.press("p")


def test_a_click_chooses_a_joint_and_another_beside_all_chooses_none(server: Server, opened: Open) -> None:
    page = opening(server, opened, "joints.spherical")
    page.keyboard.press("3")  # bones
    box = page.locator("#stage-view").bounding_box()
    assert box
    at = page.evaluate("__viewer.circle('A')")
    page.mouse.click(*at)
    until(page, "__viewer.joint() === 'A'")
    until(page, "document.querySelector('#joint').textContent.includes('no limits')")
    until(page, "!('B swing' in __viewer.handles())")
    page.mouse.click(*page.evaluate("__viewer.circle('B')"))  # its handles, which may lie on it, are hidden
    until(page, "__viewer.joint() === 'B'")
    until(page, "'B swing' in __viewer.handles()")
    x, y, z = page.evaluate("__viewer.joints().B")
    page.keyboard.press("f")
    until(page, "Math.hypot(...__viewer.camera().target.map((at, i) => at - arg[i])) < 0.005", [x, y, z])
    panel = page.locator("#joint")
    panel.get_by_text(f"at {x:.3f} {y:.3f} {z:.3f} m").wait_for()
    panel.get_by_role("button", name="plot").click()
    until(page, "document.querySelector('.joint-plot .uplot canvas')?.width > 150")
    panel.get_by_role("button", name="path").click()
    assert controls(page).get_by_label("path of a joint").input_value() == "B"
    page.keyboard.press("Escape")
    page.mouse.click(box["x"] + 5, box["y"] + 0.5 * box["height"])
    until(page, "__viewer.joint() === ''")
    until(page, "'B swing' in __viewer.handles()")


LINE = """() => {
  const canvas = document.querySelector('.joint-plot canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const colour = getComputedStyle(document.querySelector('.joint-plot p b')).color.match(/\\d+/g);
  return data.filter((_, k) => k % 4 === 0 && colour.every((v, i) => Math.abs(data[k + i] - v) < 40)).length;
}"""
"""how many pixels of the plot have the colour of its first line"""


def test_a_joint_of_a_walker_is_plotted_and_its_path_is_drawn(viewer: Page) -> None:
    """The line through the latest places stays in the paused picture until it is turned off."""
    viewer.keyboard.press("3")  # bones
    viewer.mouse.click(*viewer.evaluate("__viewer.circle('Left.hand')"))
    until(viewer, "__viewer.joint() === 'Left.hand'")
    panel = viewer.locator("#joint")
    for name in ("plot", "path"):
        panel.get_by_role("button", name=name).click()
    viewer.keyboard.down("ArrowUp")
    away = "Math.hypot(...__viewer.joints().Head.map((at, i) => at - arg[i])) > 1"
    until(viewer, away, viewer.evaluate("__viewer.joints().Head"))
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=paused]")
    viewer.keyboard.up("ArrowUp")
    until(viewer, "__viewer.posed() === __viewer.head()")
    until(viewer, f"({LINE})() > 100")
    x, y = viewer.evaluate("__viewer.circle('Left.hand')")
    clip = {"x": x - 60, "y": y - 60, "width": 120, "height": 90}
    drawn = viewer.screenshot(clip=clip)
    assert viewer.screenshot(clip=clip) == drawn
    panel.get_by_role("button", name="path").click()
    wait_for(lambda: viewer.screenshot(clip=clip) != drawn)
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=live]")
