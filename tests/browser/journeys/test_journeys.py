"""The journeys of docs/journeys.md, for three users: with a mouse in as many steps as it says there."""

from browser.conftest import passing, until
from browser.journeys.user import User
from paths import GLTF, needs_assets
from statwalk.services.library.load import shipped_machines_folder

DOOR = shipped_machines_folder() / "playground" / "door" / "door.glb"
ROBOT = GLTF / "RobotExpressive.glb"


def test_make_a_door_that_opens(user: User) -> None:
    user.add_model(DOOR, "SHUT")
    user.edit_cell("OPEN", "END", "OPENED")
    user.edit_cell("OPENED", "END", "")
    user.send("OPEN")
    user.until("__viewer.state() === 'OPENED'")
    user.send("CLOSE")
    user.until("__viewer.state() === 'SHUT'")
    user.arrived("Make a door that opens")


@needs_assets
def test_bring_your_own_model_and_make_it_jump(user: User) -> None:
    user.add_model(ROBOT, "STAT")
    with passing(user.page, "JUMP"):
        user.send("JUMP")
    user.arrived("Bring your own model and make it jump")


def test_fix_the_printed_table(user: User) -> None:
    page = user.page
    user.choose_machine("The table as printed")
    user.until("__viewer.ready && document.querySelector('#picker [title=machine]').value === 'faq-printed'")
    page.get_by_label("findings: 2 errors, 5 warnings").wait_for()
    user.edit_cell("STAT", "LEFT", "TLFT")
    user.edit_cell("WALK", "LEFT", "TLFT")
    user.edit_cell("TRGT", "RIGHT", "TRGT")
    page.get_by_label("findings: 5 warnings").wait_for()
    user.take_from_menu(page.locator("#table th").first, "event")
    user.type("JUMP")
    user.press("Enter")
    page.locator("th[data-column=JUMP]").wait_for()
    user.edit_cell("WALK", "JUMP", "JUMP")
    page.get_by_label("findings: nothing is wrong").wait_for()
    user.arrived("Fix the printed table")


@needs_assets
def test_a_walk_and_a_run_blend_on_a_pad(user: User) -> None:
    page = user.page
    user.add_model(ROBOT, "STAT")
    user.take_from_menu(page.locator("th[data-state=WALK]"), "clip, blend, markers")
    user.choose(page.get_by_label("blend with"), "Running")
    user.press_button("see it: go to WALK")
    user.until("__viewer.state() === 'WALK'")
    user.blend_half_way()
    user.until("document.querySelector('#parameters output').textContent === '0.5'")
    user.arrived("Blend a walk and a run on a pad")


def test_compare_two_ideas(user: User) -> None:
    with passing(user.page, "CRCH"):
        user.send("CROUCH")
    user.look_back("start")
    user.send("FORWARD")
    user.until("__viewer.stage() !== 'main' && __viewer.ready")
    user.open_stages()
    user.press_button("ghost of main")
    user.page.get_by_role("columnheader", name="degrees").wait_for()
    user.press_button("the first that differs")
    user.until("__viewer.posed() === __viewer.looking() && __viewer.ghost() === __viewer.looking()")
    user.arrived("Compare two ideas")


def test_send_a_colleague_the_moment_that_goes_wrong(user: User) -> None:
    page = user.page
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    user.send("JUMP")
    page.get_by_text("JUMP: dropped").wait_for()
    user.look_back("middle")
    user.copy_link()
    page.get_by_text("Copied: a link").wait_for()
    link, tick = page.evaluate("navigator.clipboard.readText()"), page.evaluate("__viewer.tick()")
    assert f"tick={tick}" in link
    colleague = page.context.new_page()
    colleague.goto(link)
    until(colleague, "window.__viewer?.ready && __viewer.looking() === arg", tick)
    user.arrived("Send a colleague the moment that goes wrong")


def test_find_out_why_it_did_not_jump(user: User) -> None:
    page = user.page
    user.send("JUMP")
    page.get_by_text("JUMP: dropped").wait_for()
    user.take(page.locator("#verdict[data-tick]"))
    page.locator(".event-why[data-about=JUMP] .where", has_text="STAT/JUMP").wait_for()
    user.take(page.locator(".remedies [data-kind=state] button").first)
    user.until("__viewer.state() === 'WALK'")
    with passing(user.page, "JUMP"):
        user.send("JUMP")
    user.arrived("Find out why it did not jump")


def test_teach_interpolation(user: User) -> None:
    page = user.page
    user.go_to_curves()
    page.get_by_role("button", name="far apart").wait_for()
    user.until("document.body.dataset.curves === '8'")
    user.press_button("far apart")
    with page.expect_response(lambda answer: "170" in (answer.request.post_data or "")) as found:
        user.fill(page.get_by_label("x° of key 2"), "170")
    speeds = {curve["interpolation"]: curve["speed_deg"] for curve in found.value.json()["curves"]}
    assert max(speeds["slerp"]) - min(speeds["slerp"]) < 1
    assert max(speeds["euler linear"]) - min(speeds["euler linear"]) > 20
    user.press_button("linear, Euler XYZ")
    user.until("document.querySelectorAll('#names button[aria-pressed=true]').length === 7")
    user.arrived("Teach interpolation")
