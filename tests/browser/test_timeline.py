"""The timeline: zoomed and panned by wheel and keys, folded; a span is selected, looped and saved."""

import json
import re
import struct
from collections.abc import Callable
from pathlib import Path

import httpx
from browser.conftest import Server, leave, until
from playwright.sync_api import Page, Route
from serving import wait_for

LENGTH = "(bar => bar.max - bar.min)(document.querySelector('.scrub'))"

RULER = """() => {
  const canvas = document.querySelector('#lanes canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, 16 * devicePixelRatio);
  return String.fromCharCode(...data.filter((_, k) => k % 4 === 3));
}"""
"""what is drawn of the marks at round seconds, above the lanes"""


def shift_drag(page: Page, begin: float, end: float) -> None:
    """Drags over the lanes with shift, from one share of their width to another."""
    box = page.locator("#lanes canvas").bounding_box()
    assert box is not None
    y = box["y"] + box["height"] / 2
    page.keyboard.down("Shift")
    page.mouse.move(box["x"] + begin * box["width"], y)
    page.mouse.down()
    page.mouse.move(box["x"] + end * box["width"], y, steps=4)
    page.mouse.up()
    page.keyboard.up("Shift")


def test_a_part_of_the_past_is_found_looped_and_saved(
    server: Server, opened: Callable[[str], Page], tmp_path: Path
) -> None:
    walker = {"actors": [{"machine": "faq-walker"}]}  # on a stage of its own, whose past is short
    made = httpx.post(f"{server.url}/api/stages", json=walker, timeout=60).raise_for_status()
    page = opened(f"{server.url}/?stage={made.json()['id']}")
    page.click("[data-event=FORWARD]")
    until(page, "__viewer.head() > 150")
    page.keyboard.press("p")
    page.wait_for_selector("[data-link=paused]")
    whole, ruler = page.evaluate(LENGTH), page.evaluate(RULER)
    page.hover("#lanes")
    page.mouse.wheel(0, -400)
    until(page, f"{LENGTH} < 0.7 * arg", whole)
    until(page, f"({RULER})() !== arg", ruler)
    newest = page.evaluate("document.querySelector('.scrub').max")
    page.keyboard.press("[")
    until(page, "Number(document.querySelector('.scrub').max) < arg", int(newest))
    for _ in range(8):
        page.keyboard.press("-")
    until(page, f"{LENGTH} === __viewer.head()")
    height = page.locator("#lanes").bounding_box()["height"]
    page.keyboard.press("j")
    until(page, "document.querySelector('#lanes').getBoundingClientRect().height < arg", height)
    page.keyboard.press("j")
    shift_drag(page, 0.25, 0.5)
    page.get_by_role("button", name="loop").click()
    begin, end = page.evaluate("[0.25, 0.5].map(part => part * __viewer.head())")
    for _ in range(2):
        until(page, "__viewer.looking() > arg", begin + 0.6 * (end - begin))
        until(page, "__viewer.looking() < arg", begin + 0.4 * (end - begin))
    assert page.evaluate("__viewer.looking()") >= begin - 5
    with page.expect_download() as saving:
        page.get_by_role("link", name="save recording.glb").click()
    saving.value.save_as(tmp_path / "recording.glb")
    data = (tmp_path / "recording.glb").read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    gltf = json.loads(data[20 : 20 + length])
    times = [gltf["accessors"][sampler["input"]] for sampler in gltf["animations"][0]["samplers"]]
    assert abs(max(time["max"][0] for time in times) - (end - begin) / 60) < 0.1
    page.get_by_role("button", name="compare").click()
    page.get_by_role("button", name="keep this span").click()
    page.keyboard.press("Escape")
    shift_drag(page, 0, 0.9)
    page.get_by_role("button", name="compare").click()
    page.locator(".span-comparison .differs").first.wait_for()
    page.locator("#compare-popover .joint-table tbody tr").first.wait_for()
    page.keyboard.press("Escape")
    page.get_by_role("button", name="select nothing").click()
    page.get_by_label("filter the events of the timeline").wait_for()
    page.keyboard.press("l")
    page.keyboard.press("p")
    page.wait_for_selector("[data-link=live]")


PAST = """(() => {
  const canvas = document.querySelector('#lanes canvas');
  const row = y => canvas.getContext('2d')
    .getImageData(0, y * devicePixelRatio, 0.8 * canvas.width, 1).data;
  const colours = new Set(new Uint32Array(row(19).buffer));
  return [colours.size > 1, row(39).some((value, k) => k % 4 === 3 && value > 0)].join();
})()"""
"""whether the lane has states of several colours, and marks of events, left of the playhead at its end"""


def test_the_past_of_a_stage_that_stands_still_is_drawn_when_it_is_known(
    server: Server, page: Page, opened: Callable[[str], Page]
) -> None:
    """Also when the page goes to it again; each answer comes after the lane was drawn without it."""
    walker = {"actors": [{"machine": "faq-walker"}], "clock": "manual"}
    made = httpx.post(f"{server.url}/api/stages", json=walker, timeout=60).raise_for_status()
    stage = f"{server.url}{made.headers['Location']}"
    for ticks in (20, 60):
        httpx.post(f"{stage}/step", json={"ticks": ticks}).raise_for_status()
        httpx.post(f"{stage}/events", json={"event": "FORWARD"}).raise_for_status()
    held: list[Route] = []
    page.route(re.compile(rf"{stage}/(history|log)\b"), lambda route: held.append(route))

    def shows_the_past() -> None:
        until(page, "document.querySelector('.scrub').value === '80'")
        for drawn in ("false,false", "true,false"):
            until(page, f"{PAST} === arg", drawn)
            wait_for(lambda: page.evaluate("true") and held)
            held.pop().continue_()
        until(page, f"{PAST} === 'true,true'")

    opened(f"{server.url}/?stage={made.json()['id']}")
    shows_the_past()
    page.keyboard.press("h")
    until(page, "__viewer.stage() === 'main' && __viewer.ready")
    page.go_back()
    shows_the_past()
    leave(page, stage)


LANES = "document.querySelector('#lanes canvas').toDataURL()"
DRAWN = f"""(({{ width, height }}) => {{
  const blank = Object.assign(document.createElement('canvas'), {{ width, height }});
  return {LANES} !== blank.toDataURL();
}})(document.querySelector('#lanes canvas'))"""


def test_a_lane_is_folded_by_its_name_and_events_are_filtered(
    server: Server, page: Page, opened: Callable[[str], Page]
) -> None:
    """The filter takes the key n, which would make the character nod."""
    layers = {"actors": [{"machine": "walker-layers"}], "clock": "manual"}
    made = httpx.post(f"{server.url}/api/stages", json=layers, timeout=60).raise_for_status()
    stage = f"{server.url}{made.headers['Location']}"
    for event in ("GO", "NOD"):
        httpx.post(f"{stage}/events", json={"event": event}).raise_for_status()
        httpx.post(f"{stage}/step", json={"ticks": 40}).raise_for_status()
    inputs = httpx.get(stage).json()["inputs"]
    with page.expect_response(re.compile(r"/log\b")):
        opened(f"{server.url}/?stage={made.json()['id']}")
    until(page, "__viewer.lanes().length > 1")
    names = page.get_by_role("group", name="lanes")
    head = names.get_by_role("button", name="head")
    until(page, "document.querySelectorAll('.lane-names [aria-expanded=false]').length === 3")
    low = page.locator("#lanes").bounding_box()["height"]
    head.click()
    until(page, "document.querySelector('#lanes').getBoundingClientRect().height > arg + 10", low)
    assert head.get_attribute("aria-expanded") == "true"
    until(page, DRAWN)
    both = page.evaluate(LANES)
    page.get_by_label("filter the events of the timeline").click()
    page.keyboard.press("n")
    until(page, f"{LANES} !== arg", both)
    nod = page.evaluate(LANES)
    page.keyboard.press("x")
    until(page, f"!arg.includes({LANES})", [both, nod])
    for _ in "nx":
        page.keyboard.press("Backspace")
    until(page, f"{LANES} === arg", both)
    assert httpx.get(stage).json()["inputs"] == inputs
    head.click()
    until(page, "document.querySelector('#lanes').getBoundingClientRect().height === arg", low)
    leave(page, stage)
