"""Keys and buttons: they change the state, and the pose moves."""

import json
import math
from collections.abc import Callable

import httpx
import pytest
from browser.conftest import Server, leave, passing, until
from playwright.sync_api import Page
from serving import wait_for

FARTHEST = """start => {
  const now = __viewer.joints();
  const way = name => Math.hypot(...start[name].map((value, i) => value - now[name][i]));
  return Math.max(...Object.keys(start).map(way));
}"""


@pytest.fixture
def standing(viewer: Page) -> Page:
    until(viewer, "__viewer.state() === 'STAT'")
    return viewer


def test_a_held_key_makes_it_walk_and_release_stops_it(standing: Page) -> None:
    start = standing.evaluate("__viewer.joints()")
    standing.keyboard.down("ArrowUp")
    until(standing, "__viewer.state() === 'WALK'")
    until(standing, f"({FARTHEST})(arg) > 0.5", start)
    standing.keyboard.up("ArrowUp")
    until(standing, "__viewer.state() === 'STAT'")


def test_the_live_row_and_the_live_state_follow(standing: Page) -> None:
    standing.keyboard.down("ArrowUp")
    until(standing, "document.querySelector('#table tr[aria-current] th')?.textContent === 'WALK'")
    until(standing, "document.querySelector('#graph .live text')?.textContent === 'WALK'")
    until(standing, "document.querySelectorAll('#graph .edge.last').length === 1")
    standing.keyboard.up("ArrowUp")
    until(standing, "__viewer.state() === 'STAT'")


def test_a_button_does_what_its_key_does(standing: Page) -> None:
    button = standing.locator("[data-event=CROUCH]")
    with passing(standing, "CRCH"):
        button.click()
    until(standing, "__viewer.state() === 'STAT'")


def test_markers_of_motions_are_no_buttons(server: Server, opened: Callable[[str], Page]) -> None:
    """A marker that the walk raises has no button; an event that a key sends has one."""
    page = opened(f"{server.url}/?machine=walker-layers")
    made = httpx.get(f"{server.url}/api/machines/walker-layers").json()
    markers = {
        marker["name"] for layer in made["layers"] for state in layer["states"] for marker in state["markers"]
    }
    assert markers & {*made["events"]}
    shown = page.locator("#events [data-event]").evaluate_all("all => all.map(one => one.dataset.event)")
    assert shown == [event for event in made["events"] if event not in {"END", *markers}]
    leave(page, f"{server.url}/api/stages/{page.evaluate('__viewer.stage()')}")


def test_a_page_that_nobody_visited_is_silent_until_sound_is_wanted(standing: Page) -> None:
    """An action of the motion is counted; the browser remembers who asks for sound."""
    standing.keyboard.down("ArrowUp")
    until(standing, "__viewer.state() === 'WALK'")
    standing.keyboard.press("Space")
    standing.locator("#action-counter [data-action=jump]").wait_for()
    standing.keyboard.up("ArrowUp")
    sound = standing.get_by_role("button", name="sound: off")
    assert sound.get_attribute("aria-pressed") == "false"
    sound.click()
    standing.get_by_role("button", name="sound: on", pressed=True).wait_for()
    assert standing.evaluate("localStorage.getItem('statwalk.muted')") == "no"


def test_losing_the_keyboard_lets_the_key_go(standing: Page) -> None:
    standing.keyboard.down("ArrowUp")
    until(standing, "__viewer.state() === 'WALK'")
    standing.evaluate("window.dispatchEvent(new Event('blur'))")
    until(standing, "__viewer.state() === 'STAT'")
    standing.keyboard.up("ArrowUp")


def test_leaving_for_another_machine_lets_the_key_go(server: Server, standing: Page) -> None:
    standing.keyboard.down("ArrowUp")
    until(standing, "__viewer.state() === 'WALK'")
    standing.locator("#picker select").first.select_option("faq-printed")
    until(standing, "__viewer.stage() !== 'main' && __viewer.ready")
    log = f"{server.url}/api/stages/main/log"
    wait_for(lambda: json.loads(httpx.get(log).text.splitlines()[-1]).get("event") == "STOP")
    standing.keyboard.up("ArrowUp")


def test_question_mark_lists_the_keys(viewer: Page) -> None:
    viewer.keyboard.press("?")
    dialog = viewer.get_by_role("dialog")
    dialog.filter(has_text="FORWARD").wait_for()
    viewer.keyboard.press("Escape")
    dialog.wait_for(state="detached")


def test_a_click_walks_some_steps_and_stops(standing: Page) -> None:
    """A tap lasts until the motion has answered: the start of the walk is played to its end."""
    tick, start = standing.evaluate("[__viewer.tick(), Object.values(__viewer.joints())[0]]")
    with passing(standing, "CSTP"):
        standing.click("[data-event=FORWARD]")
    until(standing, "__viewer.state() === 'STAT'")
    lanes = standing.evaluate("__viewer.lanes()")
    assert [state for begin, _, state in lanes if begin > tick] == ["STWK", "WALK", "CSTP", "STAT"]
    assert math.dist(start, standing.evaluate("Object.values(__viewer.joints())[0]")) > 0.8
