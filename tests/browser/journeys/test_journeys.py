"""The journeys of docs/journeys.md, each with as many steps as it says there."""

from browser.conftest import until
from browser.journeys.conftest import Journey
from paths import GLTF, needs_assets
from statwalk.services.library.load import shipped_machines_folder

DOOR = shipped_machines_folder() / "playground" / "door" / "door.glb"
MACHINE = "#picker select[title=machine]"


def choose(journey: Journey, machine: str) -> None:
    journey.steps += 2
    journey.page.locator(MACHINE).select_option(machine)
    journey.until(f"__viewer.ready && document.querySelector('{MACHINE}').value === arg", machine)


def make(journey: Journey, initial: str) -> None:
    """Takes what the dialog proposes."""
    journey.page.get_by_role("button", name="Make a machine").wait_for()
    journey.press("Enter")
    journey.until("__viewer.stage() !== 'main' && __viewer.ready && __viewer.state() === arg", initial)


def test_make_a_door_that_opens(journey: Journey) -> None:
    journey.drop(DOOR)
    make(journey, "SHUT")
    journey.edit_cell("OPEN", "END", "OPENED")
    journey.edit_cell("OPENED", "END", "")
    journey.click(journey.page.get_by_role("button", name="OPEN Q"))
    journey.until("__viewer.state() === 'OPENED'")
    journey.click(journey.page.get_by_role("button", name="CLOSE E"))
    journey.until("__viewer.state() === 'SHUT'")
    assert journey.steps == journey.promised("Make a door that opens")


@needs_assets
def test_bring_your_own_model_and_make_it_jump(journey: Journey) -> None:
    journey.drop(GLTF / "RobotExpressive.glb")
    make(journey, "STAT")
    journey.press("Space")
    journey.until("__viewer.state() === 'JUMP'")
    assert journey.steps == journey.promised("Bring your own model and make it jump")


def test_fix_the_printed_table(journey: Journey) -> None:
    choose(journey, "faq-printed")
    page = journey.page
    page.get_by_label("findings: 2 errors, 5 warnings").wait_for()
    journey.edit_cell("STAT", "LEFT", "TLFT")
    journey.edit_cell("WALK", "LEFT", "TLFT")
    journey.edit_cell("TRGT", "RIGHT", "TRGT")
    page.get_by_label("findings: 5 warnings").wait_for()
    journey.click(page.locator("#table th").first)
    journey.click(page.get_by_role("menuitem", name="event"))
    journey.type("JUMP")
    journey.press("Enter")
    page.locator("th[data-column=JUMP]").wait_for()
    journey.edit_cell("WALK", "JUMP", "JUMP")
    page.get_by_label("findings: nothing is wrong").wait_for()
    assert journey.steps == journey.promised("Fix the printed table")


@needs_assets
def test_a_walk_and_a_run_blend_on_a_pad(journey: Journey) -> None:
    page = journey.page
    journey.drop(GLTF / "RobotExpressive.glb")
    make(journey, "STAT")
    journey.click("th[data-state=WALK]")
    journey.click(page.get_by_role("menuitem", name="clip, loop, markers"))
    journey.steps += 2
    page.get_by_label("blend with").select_option("Running")
    journey.click(page.get_by_role("button", name="see it: go to WALK"))
    journey.until("__viewer.state() === 'WALK'")
    journey.click(page.locator(".blend-pad .ground"))
    journey.until("document.querySelector('#parameters output').textContent === '0.5'")
    assert journey.steps == journey.promised("Blend a walk and a run on a pad")


def look_at(journey: Journey, share: float) -> None:
    """Clicks the timeline at a share of its width."""
    journey.steps += 1
    bar = journey.page.locator(".scrub")
    box = bar.bounding_box()
    assert box is not None
    bar.click(position={"x": share * box["width"], "y": box["height"] / 2})
    journey.until("__viewer.looking() !== null && __viewer.posed() === __viewer.looking()")


def test_compare_two_ideas(journey: Journey) -> None:
    page = journey.page
    journey.press("c")
    journey.until("__viewer.state() === 'CRCH'")
    look_at(journey, 0.02)
    journey.press("ArrowUp")
    journey.until("__viewer.stage() !== 'main' && __viewer.ready")
    journey.click(page.get_by_role("button", name="stage faq-walker"))
    journey.click(page.get_by_role("button", name="ghost of main"))
    journey.click(page.get_by_role("button", name="the first that differs"))
    journey.until("__viewer.posed() === __viewer.looking() && __viewer.ghost() === __viewer.looking()")
    page.get_by_role("columnheader", name="degrees").wait_for()
    assert journey.steps == journey.promised("Compare two ideas")


def test_send_a_colleague_the_moment_that_goes_wrong(journey: Journey) -> None:
    page = journey.page
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    journey.press("Space")
    page.get_by_text("JUMP: dropped").wait_for()
    look_at(journey, 0.5)
    journey.press("y")
    page.get_by_text("Copied: a link").wait_for()
    colleague = page.context.new_page()
    colleague.goto(page.evaluate("navigator.clipboard.readText()"))
    until(colleague, "window.__viewer?.ready && __viewer.looking() === arg", page.evaluate("__viewer.tick()"))
    assert journey.steps == journey.promised("Send a colleague the moment that goes wrong")


def test_find_out_why_it_did_not_jump(journey: Journey) -> None:
    page = journey.page
    journey.press("Space")
    page.get_by_text("JUMP: dropped").wait_for()
    journey.click("#verdict[data-tick]")
    page.locator(".event-why[data-about=JUMP] .where", has_text="STAT/JUMP").wait_for()
    journey.click(page.locator(".remedies [data-kind=state] button").first)
    journey.until("__viewer.state() === 'WALK'")
    journey.press("Space")
    journey.until("__viewer.state() === 'JUMP'")
    assert journey.steps == journey.promised("Find out why it did not jump")


def test_teach_interpolation(journey: Journey) -> None:
    page = journey.page
    journey.click(page.get_by_role("link", name="curves"))
    page.get_by_role("button", name="far apart").wait_for()
    journey.until("document.body.dataset.curves === '7'")
    journey.click(page.get_by_role("button", name="far apart"))
    journey.click(page.get_by_label("x° of key 2"))
    page.keyboard.press("Control+a")
    with page.expect_response(lambda answer: "170" in (answer.request.post_data or "")) as found:
        journey.type("170")
    speeds = {curve["interpolation"]: curve["speed_deg"] for curve in found.value.json()["curves"]}
    assert max(speeds["slerp"]) - min(speeds["slerp"]) < 1
    assert max(speeds["euler linear"]) - min(speeds["euler linear"]) > 20
    journey.click(page.get_by_role("button", name="linear, Euler XYZ"))
    journey.until("document.querySelectorAll('#names button[aria-pressed=true]').length === 6")
    assert journey.steps == journey.promised("Teach interpolation")
