"""The form of a state's motion: a blend becomes one clip, and the clips of a blend have markers."""

from typing import Any

import httpx
from browser.conftest import Server
from browser.edit.conftest import edited, inspect, machine
from playwright.sync_api import Page
from serving import wait_for


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


def test_another_clip_of_a_blend_comes_first(own: Server, table: Page) -> None:
    first, second, *others = state(own, "CSTP")["clips"]
    inspect(table, "th[data-state=CSTP]")
    table.locator("#cell").get_by_role("button", name=f"move {second} up").click()
    edited(table)
    assert state(own, "CSTP")["clips"] == [second, first, *others]


def test_a_marker_of_a_blended_clip_comes_and_gets_another_name(own: Server, table: Page) -> None:
    """The other name counts in all clips; the folded markers stay open."""
    inspect(table, "th[data-state=CSTP]")
    summary = table.locator("#cell summary").filter(has_text="markers of come-to-stop-right-6")
    summary.click()
    markers = table.locator("#cell .markers[open]")
    markers.get_by_label("new").fill("touch 1.5")
    markers.locator(".field-error").filter(has_text="a phase from 0 to 1").wait_for()
    markers.get_by_label("new").fill("touch 0.01")
    table.keyboard.press("Enter")
    edited(table)
    name = markers.get_by_role("group", name="marker closed").get_by_label("marker")
    name.fill("feet together")
    markers.locator(".field-error").filter(has_text="is no name").wait_for()
    name.fill("together")
    table.keyboard.press("Enter")
    edited(table, 2)
    summary.filter(has_text="touch, lift, together").wait_for()
    clips = state(own, "CSTP")["clip_markers"]
    assert {marker["name"]: marker["phase"] for marker in clips["come-to-stop-right-6"]} == {
        "touch": 0.01,
        "lift": 0.08,
        "together": 0.455,
    }
    assert "closed:" not in machine(own)["text"]


def test_a_ground_speed_moves_the_actor_at_once(own: Server, table: Page, allowed: list[str]) -> None:
    allowed.append("422")  # the console says what was refused

    def ahead() -> float:
        place: float = httpx.get(f"{own.url}/api/stages/main").json()["actors"][0]["position"][2]
        return place

    inspect(table, "th[data-state=STAT]")
    field = table.locator("#cell").get_by_label("ground speed")
    field.fill("fast")
    table.keyboard.press("Enter")
    table.locator("#cell .field-error").filter(has_text="a number, or blank").wait_for()
    field.fill("found")
    table.keyboard.press("Enter")
    table.locator("#cell .field-error").filter(has_text="the ground runs under no foot of stand").wait_for()
    field.fill("0.5, 1.5")
    table.keyboard.press("Enter")
    edited(table)
    assert state(own, "STAT")["ground_speed"] == [0.5, 1.5]
    start = ahead()
    wait_for(lambda: ahead() > start + 0.5)
    field.fill("")
    table.keyboard.press("Enter")
    edited(table, 2)
    assert state(own, "STAT")["ground_speed"] is None


def test_a_clip_is_put_into_a_blend_and_taken_out(own: Server, table: Page) -> None:
    """It gets a place between the others, which the pad shows; a blend keeps two clips."""
    before = state(own, "TLFT")
    inspect(table, "th[data-state=TLFT]")
    form = table.locator("#cell")
    assert form.get_by_role("button", name="take").count() == 0
    form.get_by_label("one more").select_option("stand")
    edited(table)
    assert state(own, "TLFT")["clips"] == [*before["clips"], "stand"]
    table.locator(".blend-pad [data-clip=stand]").wait_for()
    form.get_by_label("stand", exact=True).fill("0.7")
    table.keyboard.press("Enter")
    edited(table, 2)
    assert state(own, "TLFT")["points"]["stand"] == [0.7]
    form.get_by_role("button", name="take stand out").click()
    edited(table, 3)
    assert state(own, "TLFT") == before
    form.get_by_role("button", name="take").first.wait_for(state="detached")
