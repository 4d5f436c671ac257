"""The journeys of docs/journeys.md by touch alone, on a tablet: taps, and words from its keyboard."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser.conftest import Server, until
from browser.journeys.test_journeys import DOOR
from paths import GLTF, needs_assets
from playwright.sync_api import Browser, Locator, Page

TABLET = {"width": 1024, "height": 700}


class Fingers:
    """The page, and a user with fingers."""

    def __init__(self, page: Page) -> None:
        self.page = page

    def until(self, condition: str, arg: object = None) -> None:
        until(self.page, condition, arg)

    def tap(self, place: str | Locator) -> None:
        (self.page.locator(place) if isinstance(place, str) else place).tap()

    def button(self, name: str) -> None:
        self.tap(self.page.get_by_role("button", name=name).first)

    def send(self, event: str) -> None:
        """Taps an event's button."""
        self.tap(f"#events [data-event={event}]")

    def word(self, text: str) -> None:
        """Types on the tablet's keyboard, and takes it."""
        self.page.keyboard.type(text)
        self.page.keyboard.press("Enter")

    def add_model(self, path: Path, initial: str) -> None:
        with self.page.expect_file_chooser() as chosen:
            self.button("add your own character")
        chosen.value.set_files(path)
        self.button("Make a machine")
        self.until("__viewer.stage() !== 'main' && __viewer.ready && __viewer.state() === arg", initial)

    def edit_cell(self, state: str, event: str, text: str) -> None:
        """Taps a cell, and writes; returns when the edit is a version."""
        before = self.page.evaluate("__viewer.version()")
        self.tap(f"td[data-state={state}][data-column={event}]")
        field = self.page.locator("#table input").first
        field.fill(text)
        field.press("Enter")
        self.until("__viewer.version() === arg", before + 1)


@pytest.fixture
def fingers(fresh: Server, browser: Browser) -> Iterator[Fingers]:
    context = browser.new_context(viewport=TABLET, has_touch=True, reduced_motion="reduce")
    page = context.new_page()
    page.set_default_timeout(60_000)
    page.goto(fresh.url)
    until(page, "window.__viewer?.ready")
    yield Fingers(page)
    context.close()


def test_the_buttons_of_events_are_whole(fingers: Fingers) -> None:
    row = fingers.page.locator("#events").bounding_box()
    button = fingers.page.locator("#events [data-event=FORWARD]").bounding_box()
    assert row is not None
    assert button is not None
    assert row["y"] <= button["y"]
    assert button["y"] + button["height"] <= row["y"] + row["height"]


def test_make_a_door_that_opens(fingers: Fingers) -> None:
    fingers.add_model(DOOR, "SHUT")
    fingers.edit_cell("OPEN", "END", "OPENED")
    fingers.edit_cell("OPENED", "END", "")
    fingers.send("OPEN")
    fingers.until("__viewer.state() === 'OPENED'")
    fingers.send("CLOSE")
    fingers.until("__viewer.state() === 'SHUT'")


@needs_assets
def test_bring_your_own_model_and_make_it_jump(fingers: Fingers) -> None:
    fingers.add_model(GLTF / "RobotExpressive.glb", "STAT")
    fingers.send("JUMP")
    fingers.until("__viewer.state() === 'JUMP'")


def test_fix_the_printed_table(fingers: Fingers) -> None:
    page = fingers.page
    page.locator("#picker select[title=machine]").select_option("faq-printed")
    page.get_by_label("findings: 2 errors, 5 warnings").wait_for()
    fingers.edit_cell("STAT", "LEFT", "TLFT")
    fingers.edit_cell("WALK", "LEFT", "TLFT")
    fingers.edit_cell("TRGT", "RIGHT", "TRGT")
    page.get_by_label("findings: 5 warnings").wait_for()
    fingers.tap(page.locator("#table th").first)
    fingers.tap(page.get_by_role("menuitem", name="event"))
    fingers.word("JUMP")
    page.locator("th[data-column=JUMP]").wait_for()
    fingers.edit_cell("WALK", "JUMP", "JUMP")
    page.get_by_label("findings: nothing is wrong").wait_for()


@needs_assets
def test_a_walk_and_a_run_blend_on_a_pad(fingers: Fingers) -> None:
    page = fingers.page
    fingers.add_model(GLTF / "RobotExpressive.glb", "STAT")
    fingers.tap("th[data-state=WALK]")
    fingers.tap(page.get_by_role("menuitem", name="clip, loop, markers"))
    page.get_by_label("blend with").select_option("Running")
    fingers.button("see it: go to WALK")
    fingers.until("__viewer.state() === 'WALK'")
    fingers.tap(".blend-pad .ground")
    fingers.until("document.querySelector('#parameters output').textContent === '0.5'")


def look_at(fingers: Fingers, share: float) -> None:
    """Taps the timeline at a share of its width."""
    bar = fingers.page.locator(".scrub")
    box = bar.bounding_box()
    assert box is not None
    bar.tap(position={"x": share * box["width"], "y": box["height"] / 2})
    fingers.until("__viewer.looking() !== null && __viewer.posed() === __viewer.looking()")


def test_compare_two_ideas(fingers: Fingers) -> None:
    fingers.send("CROUCH")
    fingers.until("__viewer.state() === 'CRCH'")
    look_at(fingers, 0.02)
    fingers.send("FORWARD")
    fingers.until("__viewer.stage() !== 'main' && __viewer.ready")
    fingers.button("stage faq-walker")
    fingers.button("ghost of main")
    fingers.button("the first that differs")
    fingers.until("__viewer.posed() === __viewer.looking() && __viewer.ghost() === __viewer.looking()")
    fingers.page.get_by_role("columnheader", name="degrees").wait_for()


def test_send_a_colleague_the_moment_that_goes_wrong(fingers: Fingers) -> None:
    page = fingers.page
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    fingers.send("JUMP")
    page.get_by_text("JUMP: dropped").wait_for()
    look_at(fingers, 0.5)
    fingers.button("find anything")
    page.get_by_role("combobox", name="find a command").wait_for()
    fingers.word("link to this moment")
    page.get_by_text("Copied: a link").wait_for()
    assert f"tick={page.evaluate('__viewer.tick()')}" in page.evaluate("navigator.clipboard.readText()")


def test_find_out_why_it_did_not_jump(fingers: Fingers) -> None:
    page = fingers.page
    fingers.send("JUMP")
    page.get_by_text("JUMP: dropped").wait_for()
    fingers.tap("#verdict[data-tick]")
    page.locator(".event-why[data-about=JUMP] .where", has_text="STAT/JUMP").wait_for()
    fingers.tap(page.locator(".remedies [data-kind=state] button").first)
    fingers.until("__viewer.state() === 'WALK'")
    fingers.send("JUMP")
    fingers.until("__viewer.state() === 'JUMP'")


def test_teach_interpolation(fingers: Fingers) -> None:
    page = fingers.page
    fingers.button("more")
    fingers.tap(page.get_by_role("menuitem", name="curves"))
    page.get_by_role("button", name="far apart").wait_for()
    fingers.until("document.body.dataset.curves === '7'")
    fingers.button("far apart")
    fingers.tap(page.get_by_label("x° of key 2"))
    with page.expect_response(lambda answer: "170" in (answer.request.post_data or "")):
        page.get_by_label("x° of key 2").fill("170")
    fingers.button("linear, Euler XYZ")
    fingers.until("document.querySelectorAll('#names button[aria-pressed=true]').length === 6")
