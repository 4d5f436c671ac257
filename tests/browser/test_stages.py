"""The stages that the page opens: it closes a stage that it leaves for another, and keeps it in a reload."""

from collections.abc import Callable

import httpx
from browser.conftest import Server, leave, until
from playwright.sync_api import Page
from serving import wait_for

CHOOSE = """names => {
  const list = document.querySelector('#picker select');
  for (const name of names) {
    list.value = name;
    list.dispatchEvent(new Event('change'));
  }
}"""
MACHINES = ["faq-printed", "walker-layers", "faq-printed", "walker-layers", "faq-printed"]


def stages(server: Server) -> set[str]:
    return {stage["id"] for stage in httpx.get(f"{server.url}/api/stages").json()}


def choose(page: Page, *machines: str) -> None:
    """Chooses machines without waiting, and waits for the last one."""
    until(page, "document.querySelectorAll('#picker option').length > 1")
    before = page.evaluate("__viewer.stage()")
    page.evaluate(CHOOSE, machines)
    until(page, "__viewer.stage() !== arg && __viewer.ready", before)
    until(page, "__viewer.ready && document.querySelector('#picker select').value === arg", machines[-1])


def test_quick_changes_leave_one_stage(server: Server, viewer: Page) -> None:
    before = stages(server)
    choose(viewer, *MACHINES)
    wait_for(lambda: stages(server) - before == {viewer.evaluate("__viewer.stage()")})


def test_slow_changes_leave_one_stage(server: Server, viewer: Page) -> None:
    before = stages(server)
    for machine in MACHINES:
        choose(viewer, machine)
    wait_for(lambda: stages(server) - before == {viewer.evaluate("__viewer.stage()")})


IS_READY = "window.__viewer?.ready && document.querySelector('#picker select').value === 'faq-printed'"


def test_a_reloaded_page_keeps_its_stage_and_still_closes_it(server: Server, viewer: Page) -> None:
    before = stages(server)
    choose(viewer, "faq-printed")
    stage = viewer.evaluate("__viewer.stage()")
    viewer.reload()
    until(viewer, IS_READY)
    assert viewer.evaluate("__viewer.stage()") == stage
    choose(viewer, "walker-layers")
    wait_for(lambda: stages(server) - before == {viewer.evaluate("__viewer.stage()")})


def test_a_reloaded_page_whose_stage_was_closed_has_its_machine_again(server: Server, viewer: Page) -> None:
    choose(viewer, "faq-printed")
    stage = f"{server.url}/api/stages/{viewer.evaluate('__viewer.stage()')}"
    leave(viewer, stage)
    viewer.go_back()
    until(viewer, IS_READY)


def test_a_stage_of_the_address_stays(server: Server, opened: Callable[[str], Page]) -> None:
    actors = [{"machine": "faq-printed"}]
    made = httpx.post(
        f"{server.url}/api/stages", json={"actors": actors, "clock": "real"}, timeout=60
    ).json()["id"]
    page = opened(f"{server.url}/?stage={made}")
    choose(page, "walker-layers")
    page.goto("about:blank")
    assert made in stages(server)


def test_a_stage_that_somebody_else_watches_stays(server: Server, viewer: Page) -> None:
    choose(viewer, "faq-printed")
    stage = viewer.evaluate("__viewer.stage()")
    other = viewer.context.new_page()
    other.goto(viewer.url)
    until(other, "window.__viewer?.ready")
    until(viewer, "__viewer.viewers() === 2")
    choose(viewer, "walker-layers")
    assert stage in stages(server)
    assert other.evaluate("__viewer.stage()") == stage


def test_another_machine_in_the_glb_stream_shows_its_own_state_and_all_of_itself(viewer: Page) -> None:
    """Not the state of the actor that was watched before."""
    viewer.keyboard.press("g")
    until(viewer, "__viewer.shown() === 'glb'")
    choose(viewer, "scene:geese")
    until(viewer, "__viewer.state() === 'FLY'")
    choose(viewer, "faq-printed")
    until(viewer, "__viewer.shown() === 'glb' && __viewer.state() === 'STAT'")
    left, top, right, bottom = viewer.evaluate("__viewer.pixels()")["box"]
    assert min(left, top) > 0.01
    assert max(right, bottom) < 0.99
