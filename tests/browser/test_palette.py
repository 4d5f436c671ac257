"""Ctrl-K finds what has a name, and does it: with the keyboard, with the mouse."""

import pytest
from browser.conftest import until
from playwright.sync_api import Page


@pytest.fixture
def standing(viewer: Page) -> Page:
    until(viewer, "__viewer.state() === 'STAT'")
    viewer.keyboard.press("Control+k")
    viewer.get_by_role("combobox", name="find a command").wait_for()
    return viewer


def test_some_letters_of_a_state_travel_there(standing: Page) -> None:
    standing.keyboard.type("crch travel")
    standing.keyboard.press("Enter")
    until(standing, "__viewer.state() === 'CRCH'")


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
