"""RD2, RD3: the weights of a bone and the normals over the skin, and tetrahedra in three ways, in both
streams.
"""

from collections.abc import Callable, Iterator

import pytest
from browser.conftest import Server, controls, until
from playwright.sync_api import Page


@pytest.fixture(params=["pose", "glb"])
def still(server: Server, opened: Callable[[str], Page], request: pytest.FixtureRequest) -> Iterator[Page]:
    """The paused page in one of the streams; on a stage of his own the walker has not turned."""
    viewer = opened(f"{server.url}?machine=faq-walker")
    until(viewer, "__viewer.state() === 'STAT'")
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=paused]")
    until(viewer, "__viewer.posed() === __viewer.head()")
    if request.param == "glb":
        viewer.keyboard.press("g")
        until(viewer, "__viewer.shown() === 'glb'")
    yield viewer
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=live]")


def shown(page: Page, what: str) -> dict:
    controls(page).get_by_label("what the skin shows").select_option(what)
    return page.evaluate("__viewer.pixels()")


def test_weights_are_red_where_the_bone_moves_all(still: Page) -> None:
    """The spine moves much of the body, a hand little; nothing but the colours changes."""
    materials = still.evaluate("__viewer.pixels()")
    weights = shown(still, "weights")
    bones = still.get_by_label("bone whose weights are shown")
    reds = {}
    for bone in ("Left.hand", "Upperback"):
        bones.select_option(bone)
        reds[bone] = still.evaluate("__viewer.pixels().colour[0]")
    back = shown(still, "materials")
    assert weights["covered"] == pytest.approx(materials["covered"], abs=0.001)
    assert reds["Upperback"] > reds["Left.hand"] + 15
    assert back["colour"] == pytest.approx(materials["colour"], abs=3)
    bones.wait_for(state="hidden")


def test_normals_are_colours_and_lines(still: Page) -> None:
    materials = still.evaluate("__viewer.pixels()")
    normals = shown(still, "normals")
    assert normals["covered"] > 1.03 * materials["covered"]  # the lines stand out
    assert normals["colour"][2] > 150  # what looks at the viewer is blue
    assert shown(still, "materials")["covered"] == pytest.approx(materials["covered"], abs=0.001)


def test_tetrahedra_are_shaded_wire_or_textured(still: Page) -> None:
    before, pictures = still.evaluate("__viewer.stats().drawn"), set()
    still.get_by_role("button", name="tetra").click()  # shaded
    for solid in ("shaded", "wireframe", "textured"):
        controls(still).get_by_label("tetrahedra", exact=True).select_option(solid)
        until(still, "__viewer.stats().drawn > arg", before)
        pictures.add(still.locator("#stage-view").screenshot())
        before = still.evaluate("__viewer.stats().drawn")
    assert len(pictures) == 3
    still.get_by_role("button", name="tetra").click()
    controls(still).get_by_label("tetrahedra", exact=True).wait_for(state="hidden")


def test_tetrahedra_stay_on_the_character_in_both_streams(viewer: Page) -> None:
    """While it walks away; the overlay's joints are where the drawn frame has them."""
    viewer.get_by_role("button", name="tetra").click()
    viewer.keyboard.press("g")
    viewer.keyboard.down("ArrowUp")
    until(viewer, "__viewer.shown() === 'glb' && __viewer.joints()['Head'][2] > 1")
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=paused]")
    until(viewer, "__viewer.posed() === __viewer.head()")
    by_server, [left, top, right, bottom] = viewer.evaluate("[__viewer.joints(), __viewer.pixels().box]")
    at = viewer.evaluate("__viewer.circle('Head')")
    box = viewer.locator("#stage-view").bounding_box()
    assert box is not None
    x, y = (at[0] - box["x"]) / box["width"], (at[1] - box["y"]) / box["height"]
    assert left < x < right
    assert top - 0.02 < y < bottom
    viewer.keyboard.press("g")
    until(viewer, "__viewer.shown() === 'pose'")
    by_browser = viewer.evaluate("__viewer.joints()")
    viewer.keyboard.up("ArrowUp")
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=live]")
    assert all(by_server[name] == pytest.approx(by_browser[name], abs=1e-4) for name in by_browser)
