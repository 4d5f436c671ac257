"""The cameras: each looks from where its name says and goes with the character; what covers it fades."""

from collections.abc import Callable

import httpx
import pytest
from browser.conftest import Server, controls, mean_colour, slowed, until
from playwright.sync_api import Page

AWAY = """(([x, y, z], [a, b, c]) => [x - a, y - b, z - c].map(m => m / Math.hypot(x - a, y - b, z - c)))(
    __viewer.camera().position, __viewer.camera().target)"""
IN_PICTURE = """(([x, y], { left, right, top, bottom }) => x > left && x < right && y > top && y < bottom)(
    Object.values(__viewer.places())[0], document.querySelector('#stage-view').getBoundingClientRect())"""
BEHIND_THE_WALL = "2.6,1.4,8,0,0.9,0"
"""the camera's place and target, metres from the walker: a wall is between them, not the door"""

FREE = "view=free&camera=0,1.4,4,0,0.9,9"
"""a camera that stays where it is; the walker of `main` stands behind it"""
FAR = "view=free&camera=0,1.4,4,0,0.9,0"
"""a camera in front of a walker who has walked away from where the walker of `main` stands"""


def test_each_camera_looks_from_its_side(server: Server, opened: Callable[[str], Page]) -> None:
    """Front, side and top; a free camera stays and loses the character, the next one finds it again."""
    viewer = opened(f"{server.url}?machine=faq-walker")  # on a stage of his own he has not turned
    until(viewer, "__viewer.state() === 'STAT'")
    for key, axis in (("7", 2), ("8", 0), ("9", 1)):
        viewer.keyboard.press(key)
        until(viewer, f"{AWAY}[{axis}] > 0.99")
    camera = controls(viewer, "camera").get_by_label("camera", exact=True)
    camera.select_option("side")
    until(viewer, f"{AWAY}[0] > 0.99")
    viewer.keyboard.press("0")
    stood = viewer.evaluate("__viewer.camera()")
    viewer.keyboard.down("ArrowUp")
    until(viewer, f"!{IN_PICTURE}")
    assert viewer.evaluate("__viewer.camera()") == stood
    viewer.keyboard.press("6")
    until(viewer, IN_PICTURE)
    viewer.keyboard.up("ArrowUp")
    assert camera.input_value() == "follow"


@pytest.mark.parametrize("most_fps", [30])
def test_a_wall_before_the_character_fades(server: Server, opened: Callable[[str], Page]) -> None:
    """The wall of the playground's door is beige; where it covers the walker, the shirt is seen."""
    made = httpx.post(f"{server.url}/api/stages", json={"scene": "playground"}, timeout=60).raise_for_status()
    address = f"{server.url}/?stage={made.json()['id']}&camera={BEHIND_THE_WALL}"
    page = opened(f"{address}&actor=1")
    until(page, "__viewer.camera().position[2] === 8")
    x, y = page.evaluate("__viewer.circle('Upperback')")
    red, _, blue, _ = mean_colour(
        page, page.screenshot(clip={"x": x - 4, "y": y - 4, "width": 8, "height": 8})
    )
    assert red > 2.2 * blue


@pytest.mark.parametrize("free", [FREE, FAR], ids=["behind", "far away"])
def test_the_character_is_in_sight_after_the_watched_stage_was_deleted(
    server: Server, opened: Callable[[str], Page], allowed: list[str], free: str
) -> None:
    allowed.append("404")
    setup = {"actors": [{"machine": "faq-walker"}], "clock": "manual"}
    made = httpx.post(f"{server.url}/api/stages", json=setup, timeout=60).raise_for_status()
    stage = f"{server.url}{made.headers['Location']}"
    httpx.post(f"{stage}/events", json={"event": "FORWARD"}).raise_for_status()
    httpx.post(f"{stage}/step", json={"ticks": 600}, timeout=60).raise_for_status()
    page = opened(f"{server.url}/?stage={stage.rsplit('/', 1)[1]}&{free}")
    until(page, f"{IN_PICTURE} && Object.values(__viewer.joints())[0][2] > 8")
    httpx.delete(stage).raise_for_status()
    page.get_by_text("is gone: you now watch main").wait_for()
    until(page, f"__viewer.stage() === 'main' && __viewer.ready && {IN_PICTURE}")
    until(page, "__viewer.pixels().covered > 0.01")


HIGHEST = """async () => {
  const seen = [];
  const over = ['LAND', 'CRCH', 'STUP', 'STAT'];
  while (!over.includes(__viewer.state())) {
    if (['JUMP', 'FLY'].includes(__viewer.state())) seen.push([__viewer.state(), __viewer.pixels().box[1]]);
    await new Promise(requestAnimationFrame);
  }
  return seen;
}"""
"""the state and the place of the highest pixel of the character, 0…1 from above, in the frames of a jump"""


def test_the_head_stays_in_the_picture_in_a_jump(server: Server, viewer: Page) -> None:
    viewer.keyboard.down("ArrowUp")
    until(viewer, "__viewer.state() === 'WALK'")
    low = viewer.evaluate("__viewer.pixels().box[1]")
    slowed(server, viewer, 1 / 2)
    try:
        viewer.keyboard.press("Space")
        seen = viewer.evaluate(HIGHEST)
    finally:
        slowed(server, viewer, 1)
    viewer.keyboard.up("ArrowUp")
    assert {state for state, _ in seen} == {"JUMP", "FLY"}
    assert 0.02 < min(top for _, top in seen) < low
