"""Ctrl-K finds what has a name, and does it: with the keyboard, with the mouse."""

from collections.abc import Callable

import httpx
import pytest
from browser.conftest import Server, leave, passing, until
from playwright.sync_api import Page


@pytest.fixture
def standing(viewer: Page) -> Page:
    until(viewer, "__viewer.state() === 'STAT'")
    viewer.keyboard.press("Control+k")
    viewer.get_by_role("combobox", name="find a command").wait_for()
    return viewer


def test_some_letters_of_a_state_travel_there(standing: Page) -> None:
    standing.keyboard.type("crch travel")
    with passing(standing, "CRCH"):
        standing.keyboard.press("Enter")


def test_a_joint_is_chosen_with_the_mouse(standing: Page) -> None:
    joint = standing.evaluate("Object.keys(__viewer.joints())[1]")
    standing.keyboard.type(f"{joint} joint")
    standing.locator("#choices").get_by_role("option", name=joint).first.click()
    until(standing, "__viewer.joint() === arg", joint)


def test_escape_leaves_the_palette_and_nothing_happens(standing: Page) -> None:
    standing.keyboard.type("crch travel")
    standing.keyboard.press("Escape")
    until(standing, "!document.querySelector('dialog[open]')")
    assert standing.evaluate("__viewer.state()") == "STAT"


OPENED = {
    "inspect the selected": "#cell:not([hidden])",
    "YAML of": "#drawer[data-shown=text]",
    "versions of the machine": "#drawer[data-shown=versions]",
    "machine: rename": "#machine-menu form",
    "IK rules": "dialog[open].deduce",
    "download the character": "dialog[open].download",
    "findings of the verifier": "#cell-inspector:not([hidden])",
}


@pytest.mark.parametrize("words", OPENED, ids=lambda words: words.split()[0].strip(":"))
def test_what_buttons_and_menus_open_is_found_too(standing: Page, words: str) -> None:
    standing.keyboard.type(words)
    standing.keyboard.press("Enter")
    standing.locator(OPENED[words]).wait_for()


def found(page: Page, words: str) -> None:
    """Finds a command, and runs it."""
    page.keyboard.press("Control+k")
    page.get_by_role("combobox", name="find a command").wait_for()
    page.keyboard.type(words)
    page.keyboard.press("Enter")
    until(page, "!document.querySelector('dialog.chooser[open]')")


def picked(page: Page, name: str, does: str) -> None:
    """Finds what has a name, and picks with the mouse what it does."""
    page.keyboard.press("Control+k")
    page.get_by_role("combobox", name="find a command").wait_for()
    page.keyboard.type(name)
    page.locator("#choices [role=option]").filter(has_text=does).first.click()
    until(page, "!document.querySelector('dialog.chooser[open]')")


def test_a_state_an_event_and_a_clip_are_found_too(standing: Page) -> None:
    """A state and a clip are shown in the inspector, and the state in the graph; an event is sent."""
    standing.keyboard.press("Escape")
    shown = standing.locator("#cell h2")
    picked(standing, "crch", "state: show")
    shown.filter(has_text="CRCH").wait_for()
    standing.wait_for_selector("#graph .state[data-state=CRCH][aria-pressed=true]")
    with passing(standing, "CRCH"):
        picked(standing, "crouch", "event: send")
    picked(standing, "jump-left-2", "clip: show JUMP, which plays it")
    shown.filter(has_text="JUMP").wait_for()


def test_an_actor_a_stage_and_a_scene_are_found_too(server: Server, opened: Callable[[str], Page]) -> None:
    """All three are watched at once."""
    pair = [
        {"machine": "faq-walker", "name": name, "position": [x, 0, 0]} for name, x in (("Ada", 0), ("Bea", 1))
    ]
    ids = [
        httpx.post(f"{server.url}/api/stages", json={"name": name, "actors": pair}, timeout=60).json()["id"]
        for name in ("First", "Rehearsal")
    ]
    page = opened(f"{server.url}/?stage={ids[0]}")
    picked(page, "bea", "actor: watch")
    until(page, "document.querySelector('#picker [aria-label=actor]').value === '2'")
    picked(page, "rehearsal", "stage: watch faq-walker")
    until(page, "__viewer.stage() === arg && __viewer.ready", ids[1])
    picked(page, "geese", "scene: watch")
    until(page, "document.querySelector('#picker select').value === 'scene:geese' && __viewer.ready")
    leave(page, *(f"{server.url}/api/stages/{stage}" for stage in ids))


def test_what_is_done_with_a_span_is_found_too(standing: Page) -> None:
    """Without a span the page says how to select one."""
    standing.keyboard.press("Escape")
    found(standing, "save the span")
    standing.get_by_text("Select a span first").first.wait_for()
    standing.keyboard.press("i")
    until(standing, "__viewer.tick() > arg", standing.evaluate("__viewer.tick()") + 20)
    standing.keyboard.press("k")
    for words in ("save the span", "film strip of"):
        with standing.expect_download() as download:
            found(standing, words)
        assert download.value.suggested_filename.rpartition(".")[2] in ("glb", "png")
    found(standing, "compare the span")
    standing.get_by_role("button", name="keep this span").wait_for()
    standing.keyboard.press("Escape")
    found(standing, "select nothing")
    standing.locator("#span").wait_for(state="hidden")


def test_a_fork_and_a_way_of_skinning_are_found_too(standing: Page) -> None:
    standing.keyboard.press("Escape")
    found(standing, "skinning: dual")
    select = standing.get_by_label("way of skinning")
    until(standing, "arg.value === 'dual-quaternion'", select.element_handle())
    found(standing, "fork the stage")
    until(standing, "__viewer.stage() !== 'main'")
