"""Forks stay, the list of stages names, renames and deletes them, ghosts compare them; the ways back."""

from collections.abc import Callable
from pathlib import Path

import httpx
import pytest
from browser.conftest import Server, leave, until
from browser.test_time import SCRUB
from playwright.sync_api import Page
from serving import wait_for

AT_MAIN = "__viewer.stage() === 'main' && __viewer.ready && __viewer.link() === 'live'"


def fork(page: Page, act: Callable[[], None] | None = None) -> str:
    """Sends an event to the past, by default with a key; returns the stage that this makes."""
    until(page, "__viewer.tick() > 60 && __viewer.state() === 'STAT'")
    until(page, "__viewer.tick() > arg + 10", page.evaluate("__viewer.tick()"))  # he stood in that past, too
    page.evaluate(SCRUB, page.evaluate("__viewer.tick()") - 10)
    until(page, "__viewer.looking() === __viewer.tick()")
    (act or (lambda: page.keyboard.press("c")))()
    until(page, "__viewer.stage() !== 'main' && __viewer.ready && __viewer.link() === 'live'")
    return str(page.evaluate("__viewer.stage()"))


def test_back_leads_from_a_fork_to_its_origin_and_forward_to_the_fork(
    server: Server, viewer: Page, most_fps: int
) -> None:
    made = fork(viewer)
    viewer.go_back()
    until(viewer, AT_MAIN)
    assert viewer.url == f"{server.url}/?fps={most_fps}"
    httpx.get(f"{server.url}/api/stages/{made}").raise_for_status()
    viewer.go_forward()
    until(viewer, "__viewer.stage() === arg && __viewer.ready && __viewer.link() === 'live'", made)


def test_a_fork_gets_a_name_and_a_key_leads_back_to_main(viewer: Page) -> None:
    viewer.keyboard.press("o")
    viewer.get_by_label("name of the fork").fill("Jump earlier")
    viewer.keyboard.press("Enter")
    until(viewer, "document.querySelector('#stages [aria-current=true] b')?.textContent === 'Jump earlier'")
    until(viewer, "__viewer.ready && __viewer.link() === 'live'")
    viewer.keyboard.press("Escape")
    viewer.keyboard.press("h")
    until(viewer, AT_MAIN)


def test_the_last_verdict_stays_at_its_stage(server: Server, opened: Callable[[str], Page]) -> None:
    """The stages stand still, so that the origin has no verdict of its own that would take the place."""
    walker = {"actors": [{"machine": "faq-walker"}], "clock": "manual"}
    made = httpx.post(f"{server.url}/api/stages", json=walker, timeout=60).raise_for_status().json()["id"]
    page = opened(f"{server.url}/?stage={made}")
    page.keyboard.press("o")
    page.get_by_label("name of the fork").press("Enter")
    until(page, "__viewer.stage() !== arg && __viewer.ready", made)
    fork = f"{server.url}/api/stages/{page.evaluate('__viewer.stage()')}"
    httpx.post(f"{fork}/events", json={"event": "FORWARD"}).raise_for_status()
    httpx.post(f"{fork}/step", json={"ticks": 2}).raise_for_status()
    page.locator("#verdict[data-tick]").filter(has_text="FORWARD: STAT → STWK").wait_for()
    assert page.locator("#table td.last, #graph .edge.last").count() == 2
    page.go_back()
    until(page, "__viewer.stage() === arg && __viewer.ready", made)
    assert page.locator("#table td.last, #graph .edge.last, #verdict[data-tick]").count() == 0
    assert page.locator("#verdict").text_content() == ""
    leave(page, fork, f"{server.url}/api/stages/{made}")


def test_who_deletes_the_watched_fork_is_led_to_its_origin(server: Server, viewer: Page) -> None:
    made = fork(viewer)
    viewer.keyboard.press("o")
    viewer.locator("#stages [aria-current=true]").get_by_role("button", name="delete").click()
    viewer.get_by_role("button", name="delete it").click()
    until(viewer, AT_MAIN)
    wait_for(lambda: made not in {stage["id"] for stage in httpx.get(f"{server.url}/api/stages").json()})


def test_a_key_tapped_in_the_past_makes_one_fork_with_its_release(server: Server, viewer: Page) -> None:
    made = fork(viewer)
    address = f"{server.url}/api/stages/{made}"
    wait_for(lambda: "release CROUCH" in httpx.get(address).json()["newest_input"]["text"])
    stages = httpx.get(f"{server.url}/api/stages").json()
    assert [stage["id"] for stage in stages if stage["origin"]] == [made]


def test_a_click_in_the_past_walks_on_the_fork_and_stops(viewer: Page) -> None:
    fork(viewer, lambda: viewer.click("[data-event=FORWARD]"))
    until(viewer, "__viewer.lanes().some(([, , state]) => state === 'CSTP') && __viewer.state() === 'STAT'")
    assert {"STWK", "WALK", "CSTP"} <= {state for _, _, state in viewer.evaluate("__viewer.lanes()")}


@pytest.mark.parametrize("press", ["key", "button"])
def test_a_press_that_began_live_ends_live_while_the_past_is_looked_at(
    server: Server, viewer: Page, press: str
) -> None:
    until(viewer, "__viewer.tick() > 60 && __viewer.state() === 'STAT'")
    if press == "key":
        viewer.keyboard.down("ArrowUp")
    else:
        viewer.hover("[data-event=FORWARD]")
        viewer.mouse.down()
    until(viewer, "['STWK', 'WALK'].includes(__viewer.state())")
    viewer.evaluate(SCRUB, viewer.evaluate("__viewer.tick()") - 20)
    until(viewer, "__viewer.looking() === __viewer.tick()")
    if press == "key":
        viewer.keyboard.up("ArrowUp")
    else:
        viewer.mouse.up()
    newest = f"{server.url}/api/stages/main"
    wait_for(lambda: httpx.get(newest).json()["newest_input"]["text"].startswith("STOP "))
    assert viewer.evaluate("__viewer.stage()") == "main"
    assert viewer.evaluate("__viewer.looking()") is not None


def test_the_ghost_of_the_origin_stands_at_the_same_tick_and_is_compared_by_joint(viewer: Page) -> None:
    fork(viewer)
    until(viewer, "__viewer.tick() > arg + 10", viewer.evaluate("__viewer.tick()"))  # he crouches visibly
    viewer.keyboard.press("x")
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=paused]")
    until(viewer, "__viewer.ghost() === __viewer.tick()")
    viewer.keyboard.press("o")
    until(viewer, "document.querySelectorAll('#difference tbody tr').length > 3")
    viewer.keyboard.press("Escape")
    viewer.keyboard.press("x")
    until(viewer, "__viewer.ghost() === -1")


def test_a_ghost_is_outside_the_picture_at_the_shown_tick_alone(
    server: Server, opened: Callable[[str], Page]
) -> None:
    """Its first frame is the newest of its stage, where it has walked out of the picture."""
    walker = {"actors": [{"machine": "faq-walker"}], "clock": "manual"}
    made = httpx.post(f"{server.url}/api/stages", json=walker, timeout=60).raise_for_status().json()["id"]
    origin = f"{server.url}/api/stages/{made}"
    httpx.post(f"{origin}/events", json={"event": "FORWARD"}).raise_for_status()
    httpx.post(f"{origin}/step", json={"ticks": 600}, timeout=60).raise_for_status()
    other = httpx.post(f"{origin}/fork", json={"tick": 1}, timeout=60).raise_for_status().json()["id"]
    page = opened(f"{server.url}/?stage={other}")
    told = page.get_by_text("The ghost is outside the picture")
    for _ in range(2):  # the second time its model is there before its frames
        page.keyboard.press("x")
        until(page, "__viewer.ghost() === 1")
        assert told.count() == 0
        page.keyboard.press("x")
        until(page, "__viewer.ghost() === -1")
    page.keyboard.press("x")
    fork = f"{server.url}/api/stages/{other}"
    httpx.post(f"{fork}/events", json={"event": "STOP"}).raise_for_status()
    httpx.post(f"{fork}/step", json={"ticks": 500}, timeout=60).raise_for_status()
    until(page, "__viewer.tick() > 500 && __viewer.ghost() === __viewer.tick()")
    told.first.wait_for()
    leave(page, fork, origin)


TREE = """() => [...document.querySelectorAll('#stages li')].map(row => [
  row.querySelector('b').textContent,
  row.querySelector('b').getBoundingClientRect().left,
  row.querySelector('.stage-row span').textContent,
  getComputedStyle(row.querySelector('.stage-span')).backgroundImage.match(/[\\d.e-]+(?=%)/g).map(Number),
])"""
"""each row's name, where it begins, pixels, its words, and from where to where its bar goes, percent"""


def test_the_list_of_stages_is_a_tree_over_time(server: Server, opened: Callable[[str], Page]) -> None:
    """A fork stands below its origin, moved in, earlier ones first; its bar begins where it left."""
    walker = {"actors": [{"machine": "faq-walker"}], "clock": "manual", "name": "Play"}
    ids = {"Play": httpx.post(f"{server.url}/api/stages", json=walker, timeout=60).json()["id"]}
    for name, origin, tick in (("Late", "Play", 30), ("Early", "Play", 10), ("Inner", "Early", 20)):
        stage = f"{server.url}/api/stages/{ids[origin]}"
        httpx.post(f"{stage}/step", json={"ticks": 40}, timeout=60).raise_for_status()
        made = httpx.post(f"{stage}/fork", json={"tick": tick, "name": name}, timeout=60).json()
        ids[name] = made["id"]
    httpx.post(f"{server.url}/api/stages/{ids['Inner']}/events", json={"event": "FORWARD"}).raise_for_status()
    page = opened(f"{server.url}/?stage={ids['Inner']}")
    page.keyboard.press("o")
    page.locator("#stages li").filter(has_text="Inner").wait_for()
    rows = {name: more for name, *more in page.evaluate(TREE) if name in ids}
    assert list(rows) == ["Play", "Early", "Inner", "Late"]
    left = rows["Play"][0]
    step = rows["Early"][0] - left
    assert step > 8
    assert [place - left for place, *_ in rows.values()] == pytest.approx([0, step, 2 * step, step], abs=0.5)
    assert [words for _, words, _ in rows.values()] == [
        "1 input, the newest: faq-walker 1 added",
        "left Play at tick 10 · no input",
        "left Early at tick 20 · 1 input, the newest: FORWARD to faq-walker 1",
        "left Play at tick 30 · no input",
    ]
    tick = rows["Late"][2][0] / 30
    bars = [at / tick for _, _, (begin, _, end, _) in rows.values() for at in (begin, end)]
    assert bars == pytest.approx([0, 80, 10, 50, 20, 20, 30, 30], abs=0.01)
    leave(page, *(f"{server.url}/api/stages/{stage}" for stage in ids.values()))


def test_the_list_of_stages_says_which_one_sleeps_and_renames_it(
    tmp_path: Path, opened: Callable[[str], Page]
) -> None:
    """Who goes to the stage wakes it."""
    with Server(tmp_path, "--limit", "rest_seconds=0.2") as server:
        walker = {"actors": [{"machine": "faq-walker"}], "name": "Rehearsal"}
        made = httpx.post(f"{server.url}/api/stages", json=walker, timeout=60).raise_for_status().json()["id"]
        page = opened(server.url)
        page.keyboard.press("o")
        rows = page.locator("#stages li")
        rows.filter(has_text="Rehearsal").filter(has_text="asleep · no viewer").wait_for()
        page.get_by_role("button", name="rename Rehearsal").click()
        page.keyboard.type("Premiere")
        page.keyboard.press("Enter")
        rows.filter(has_text="Premiere").get_by_title("watch it").click()
        until(page, "__viewer.stage() === arg && __viewer.ready", made)
        page.get_by_role("button", name="stage Premiere").wait_for()
        rows.filter(has_text="Premiere").filter(has_text="runs · 1 viewer").wait_for()
        leave(page)
