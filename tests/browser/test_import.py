"""Imports a character: a dropped file becomes a machine and walks; a broken file is refused with a reason and
changes nothing.
"""

import base64
from collections.abc import Callable, Iterator
from pathlib import Path

import httpx
import pytest
from browser.conftest import Server, passing, until
from browser.edit.conftest import inspect
from md2_models import md2
from paths import GLTF, MACHINES, needs_assets
from playwright.sync_api import Page, Route
from serving import wait_for

DROP = """([name, base64]) => {
  const bytes = Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
  const carried = new DataTransfer();
  carried.items.add(new File([bytes], name));
  const options = { dataTransfer: carried, bubbles: true, cancelable: true };
  for (const type of ['dragover', 'drop'])
    document.body.dispatchEvent(new DragEvent(type, options));
}"""
ROBOT = GLTF / "RobotExpressive.glb"
DOOR = MACHINES / "playground" / "door" / "door.glb"
HOLD, PRESS = (
    "ArrowUp:    {hold: FORWARD, release: STOP}",
    "ArrowUp:    {press: FORWARD}\n  Escape:     {press: STOP}",
)
HOSTILE = "<img src=x onerror=\"document.title='owned'\">.glb"


def drop(page: Page, name: str, content: bytes) -> None:
    page.evaluate(DROP, [name, base64.b64encode(content).decode()])


@pytest.fixture
def own(server: Server, page: Page) -> Iterator[Callable[[], set[str]]]:
    """Returns the names of the server's machines and characters; removes new ones afterwards."""

    def names() -> set[str]:
        return {
            f"{kind}/{one['name']}"
            for kind in ("machines", "characters")
            for one in httpx.get(f"{server.url}/api/{kind}").json()
        }

    before = names()
    yield names
    page.goto("about:blank")  # before it can ask for what is deleted
    for stage in httpx.get(f"{server.url}/api/stages").json():
        if stage["id"] != "main":
            httpx.delete(f"{server.url}/api/stages/{stage['id']}")
    for name in sorted(names() - before, reverse=True):
        httpx.delete(f"{server.url}/api/{name}").raise_for_status()


@needs_assets
def test_a_dropped_robot_walks(own: Callable[[], set[str]], viewer: Page) -> None:
    drop(viewer, "Robot Expressive.glb", ROBOT.read_bytes())
    viewer.get_by_label("Walking", exact=True).wait_for()
    assert viewer.get_by_label("Walking", exact=True).input_value() == "WALK"
    viewer.keyboard.press("Enter")
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready && __viewer.state() === 'STAT'")
    assert viewer.evaluate("__viewer.pixels().covered") > 0.02
    start = viewer.evaluate("__viewer.joints()")
    viewer.keyboard.down("ArrowUp")
    until(viewer, "__viewer.state() === 'WALK'")
    ahead = "Object.entries(__viewer.joints()).every(([name, at]) => at[2] > arg[name][2] + 2)"
    until(viewer, ahead, start)  # its clip walks on the spot
    viewer.keyboard.up("ArrowUp")
    until(viewer, "__viewer.state() === 'STAT'")
    inspect(viewer, "th[data-state=WALK]")
    viewer.locator("#cell .hint").filter(has_text="found: 5.08 m/s").wait_for()
    assert {"machines/Robot-Expressive", "characters/Robot-Expressive"} <= own()


@needs_assets
def test_states_can_be_renamed_and_are_checked_in_place(
    own: Callable[[], set[str]], viewer: Page, allowed: list[str]
) -> None:
    allowed.append("422")
    chosen: Path = ROBOT
    with viewer.expect_file_chooser() as choosing:
        viewer.get_by_role("button", name="add your own character").click()
    choosing.value.set_files(chosen)
    viewer.get_by_label("Dance", exact=True).fill("WALK")
    viewer.get_by_role("button", name="Make a machine").click()
    viewer.locator("[aria-invalid]").wait_for()
    viewer.locator(".map-row:has([aria-invalid]) .map-says").filter(has_text="already").wait_for()
    viewer.get_by_label("Dance", exact=True).fill("no name")
    viewer.keyboard.press("Enter")
    viewer.locator(".map-row:has([aria-invalid]) .map-says").filter(has_text="no name").wait_for()
    assert viewer.locator("[aria-invalid]").count() == 1
    viewer.locator("[aria-invalid]").fill("DISCO")
    viewer.get_by_label("Dance", exact=True).fill("WALTZ")
    viewer.keyboard.press("Enter")
    until(viewer, "document.querySelector('#table')?.textContent.includes('WALTZ')")


def test_a_broken_file_says_why_and_changes_nothing(
    own: Callable[[], set[str]], viewer: Page, allowed: list[str]
) -> None:
    allowed.append("422")
    before, stage = own(), viewer.evaluate("__viewer.stage()")
    drop(viewer, HOSTILE, b"glTF\x02\0\0\0 this is none")
    viewer.get_by_role("alert").filter(has_text="byte").wait_for()
    assert viewer.locator("img").count() == 0
    assert own() == before
    viewer.keyboard.press("Escape")
    viewer.get_by_role("dialog").wait_for(state="detached")
    assert viewer.evaluate("[__viewer.stage(), __viewer.state()]") == [stage, "STAT"]


def test_escape_cancels_an_import_and_is_no_stop_for_the_character(
    server: Server, own: Callable[[], set[str]], opened: Callable[[str], Page]
) -> None:
    """In this machine Escape is a key of STOP. The import leaves nothing behind."""
    machines = f"{server.url}/api/machines"
    httpx.post(machines, json={"name": "escaping", "copy_of": "faq-walker"}, timeout=60).raise_for_status()
    made = httpx.get(f"{machines}/escaping").json()
    text, seen = made["text"].replace(HOLD, PRESS), {"If-Match": f'"{made["version"]}"'}
    httpx.put(f"{machines}/escaping", json={"text": text}, headers=seen).raise_for_status()
    before, page = own(), opened(f"{server.url}/?machine=escaping")
    page.keyboard.press("ArrowUp")
    until(page, "__viewer.state() === 'WALK'")
    drop(page, "mine.glb", DOOR.read_bytes())
    page.get_by_role("button", name="Make a machine").wait_for()
    with page.expect_response(lambda answer: answer.request.method == "DELETE"):
        page.keyboard.press("Escape")
    until(page, "__viewer.posed() > arg + 20", page.evaluate("__viewer.head()"))
    assert page.evaluate("__viewer.lanes().at(-1)[2]") == "WALK"
    assert own() == before
    page.keyboard.press("Escape")
    until(page, "__viewer.state() === 'STAT'")


def test_a_page_that_is_left_takes_its_import_along(own: Callable[[], set[str]], viewer: Page) -> None:
    before = own()
    drop(viewer, "left.glb", DOOR.read_bytes())
    viewer.get_by_role("button", name="Make a machine").wait_for()
    assert own() - before == {"characters/left"}
    viewer.goto("about:blank")
    wait_for(lambda: own() == before)


def test_enter_cancels_nothing_while_the_server_reads(own: Callable[[], set[str]], viewer: Page) -> None:
    held: list[Route] = []
    viewer.route("**/api/characters/hasty", lambda route: held.append(route), times=1)
    with viewer.expect_request("**/api/characters/hasty"):
        drop(viewer, "hasty.glb", DOOR.read_bytes())
    viewer.locator("dialog.import[open]").wait_for()
    viewer.keyboard.press("Enter")
    held[0].continue_()
    viewer.get_by_role("button", name="Make a machine").wait_for()
    viewer.keyboard.press("Escape")


@pytest.mark.parametrize("inbetween", ["blended", "switched"])
def test_a_dropped_md2_plays_its_frames(own: Callable[[], set[str]], viewer: Page, inbetween: str) -> None:
    """A cycle of three frames: between two of them the picture is neither's, unless they are switched."""
    drop(viewer, f"{inbetween}.md2", md2())
    viewer.get_by_role("button", name="Make a machine").wait_for()
    assert viewer.get_by_label("pain1", exact=True).input_value() == "PAIN1"
    viewer.get_by_label("switch from frame to frame").set_checked(inbetween == "switched")
    viewer.get_by_role("button", name="Make a machine").click()
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready && __viewer.state() === 'STAT'")
    assert viewer.evaluate("__viewer.pixels().covered") > 0.005
    stage = f"{viewer.url.split('?')[0].rstrip('/')}/api/stages/{viewer.evaluate('__viewer.stage()')}"
    with passing(viewer, "JUMP"):
        viewer.keyboard.press("Space")
    until(viewer, "__viewer.state() === 'STAT'")

    def weights() -> list[float]:
        return sorted(set(httpx.get(f"{stage}/actors/1/pose").json()["weights"]))

    if inbetween == "switched":  # once the blend from JUMP is over
        wait_for(lambda: weights() in ([0], [0, 1]))
    assert {f"machines/{inbetween}", f"characters/{inbetween}"} <= own()
