"""The journeys of docs/journeys.md, each with as many steps as it says there."""

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
