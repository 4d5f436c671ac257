"""The form of a state's motion: a blend becomes one clip."""

from typing import Any

from browser.conftest import Server
from browser.edit.conftest import edited, inspect, machine
from playwright.sync_api import Page


def state(server: Server, name: str) -> dict[str, Any]:
    found: dict[str, Any] = next(state for state in machine(server)["states"] if state["name"] == name)
    return found


def test_a_blend_becomes_one_clip_and_a_blend_again(own: Server, table: Page) -> None:
    """The clip keeps the markers that it had in the blend."""
    before = state(own, "CSTP")
    inspect(table, "th[data-state=CSTP]")
    table.locator("#cell").get_by_label("one clip").select_option("come-to-stop-right-1")
    edited(table)
    clip = state(own, "CSTP")
    assert (clip["over"], clip["motion"]) == ([], "come-to-stop-right-1")
    assert [(marker["name"], marker["phase"]) for marker in clip["markers"]] == [
        ("touch", 0.414),
        ("lift", 0.535),
        ("closed", 0.872),
    ]
    table.locator("#cell").get_by_label("blend with").wait_for()
    table.get_by_role("button", name="undo").click()
    edited(table, 2)
    table.locator("#cell").get_by_label("one clip").wait_for()
    assert state(own, "CSTP") == before
