"""Point parameters in the page: a handle to drag, a character that looks at the pointer; all is logged."""

import json
from collections.abc import Callable

import httpx
import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page
from serving import wait_for


@pytest.fixture
def most_fps() -> int:
    """As often as without a limit: a handle is dragged from where it was drawn last."""
    return 30


def reached(server: Server, viewer: Page) -> dict[str, float]:
    """What the gaze solver of the watched actor did."""
    stage = viewer.evaluate("__viewer.stage()")
    (actor,) = httpx.get(f"{server.url}/api/stages/{stage}").json()["actors"]
    found: dict[str, float] = next(line for line in actor["reached"] if line["solver"] == "gaze")
    return found


def gazes(server: Server, viewer: Page) -> list[float]:
    """The x of all places of `gaze` in the log of the stage."""
    stage = viewer.evaluate("__viewer.stage()")
    lines = httpx.get(f"{server.url}/api/stages/{stage}/log").text.splitlines()
    found = [json.loads(line) for line in lines]
    return [line["value"] for line in found if line.get("parameter") == "gaze.x"]


def test_he_looks_at_the_pointer_on_request(server: Server, opened: Callable[[str], Page]) -> None:
    viewer = opened(f"{server.url}?machine=faq-walker")  # on a stage of his own he stands where he began
    until(viewer, "__viewer.state() === 'STAT'")
    assert reached(server, viewer)["weight"] == 0
    box = viewer.locator("#stage-view").bounding_box()
    assert box
    viewer.get_by_role("button", name="look at the pointer").click()
    viewer.mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 0.3 * box["height"])
    viewer.mouse.move(box["x"] + 0.7 * box["width"], box["y"] + 0.35 * box["height"])
    wait_for(lambda: reached(server, viewer)["weight"] > 0.99)
    wait_for(lambda: reached(server, viewer)["reached"])
    assert gazes(server, viewer)
    viewer.get_by_role("button", name="look at the pointer").click()
    wait_for(lambda: reached(server, viewer)["weight"] == 0)


def pull(page: Page, handle: str, right: float, down: float) -> tuple[float, float]:
    """Moves the pointer by pixels while it holds a handle; returns where the handle was."""
    until(page, "arg in __viewer.handles()", handle)
    x, y = page.evaluate("arg => __viewer.handles()[arg]", handle)
    page.mouse.move(x, y)
    page.mouse.down()
    for part in (0.2, 0.4, 0.6, 0.8, 1):
        page.mouse.move(x + right * part, y + down * part)
    page.mouse.up()
    return x, y


def drag(page: Page, handle: str, right: float, down: float) -> None:
    """Drags a handle by pixels; returns when it was drawn there."""
    x, y = pull(page, handle, right, down)
    until(
        page,
        "__viewer.handles()[arg.handle].every((at, i) => Math.abs(at - arg.place[i]) < 2)",
        {"handle": handle, "place": [x + right, y + down]},
    )


def test_a_dragged_handle_moves_its_point(server: Server, opened: Callable[[str], Page]) -> None:
    viewer = opened(f"{server.url}?machine=faq-walker")
    until(viewer, "__viewer.state() === 'STAT'")
    viewer.get_by_role("button", name="drag gaze").click()
    before = len(gazes(server, viewer))
    drag(viewer, "gaze", -40, 20)
    wait_for(lambda: len(gazes(server, viewer)) > before)
    viewer.get_by_role("button", name="drag gaze").click()
    until(viewer, "!('gaze' in __viewer.handles())")


def test_a_moved_point_is_put_back(server: Server, opened: Callable[[str], Page]) -> None:
    page = opened(f"{server.url}?machine=reach")
    page.keyboard.press("r")
    until(page, "__viewer.state() === 'REACH' && 'right' in __viewer.handles()")
    back = page.get_by_role("button", name="put right back to where it was first")
    assert not back.is_visible()
    place = page.evaluate("__viewer.handles().right")
    drag(page, "right", -60, -40)
    back.click()
    until(page, "__viewer.handles().right.every((at, i) => Math.abs(at - arg[i]) < 2)", place)
    back.wait_for(state="hidden")


def face_of(server: Server, page: Page) -> list[float]:
    """The direction in which the watched actor is asked to look."""
    stage = page.evaluate("__viewer.stage()")
    (actor,) = httpx.get(f"{server.url}/api/stages/{stage}").json()["actors"]
    asked: list[float] = actor["parameters"]["face"]
    return asked


def test_the_handle_of_a_direction_turns_the_head(server: Server, opened: Callable[[str], Page]) -> None:
    page = opened(f"{server.url}?machine=reach")
    page.keyboard.press("r")
    until(page, "__viewer.state() === 'REACH'")
    x, _ = pull(page, "face", 90, -20)
    wait_for(lambda: face_of(server, page)[0] > 0.3)  # the camera stands before him: to its right is +X
    assert sum(number**2 for number in face_of(server, page)) == pytest.approx(1)
    until(page, "__viewer.handles().face[0] > arg + 60", x)


def test_a_hand_follows_its_ball_as_far_as_the_arm_may(server: Server, opened: Callable[[str], Page]) -> None:
    page = opened(f"{server.url}?machine=reach")
    page.keyboard.press("r")
    until(page, "__viewer.state() === 'REACH'")
    drag(page, "left", 60, -90)
    until(page, "__viewer.joints()['Left.hand'][1] > 1.45")
    drag(page, "left", 0, 300)
    until(page, "__viewer.joints()['Left.hand'][1] < 1.1")
    assert (
        page.evaluate("__viewer.joints()['Left.lowerarm'][1]") > 1.05
    )  # the elbow stays where the shoulder lets it
