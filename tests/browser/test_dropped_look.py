"""A dropped model is looked at before it has a machine: its clips play, its meshes hide, its face changes."""

import re
from collections.abc import Callable

import pygltflib
from browser.conftest import until
from browser.test_download import downloaded
from browser.test_import import ROBOT, drop, own
from paths import GLTF, needs_assets
from playwright.sync_api import Locator, Page

__all__ = ["own"]
KNIGHT = GLTF / "KayKit_Knight.glb"
TIME = "Number(document.querySelector('.look-controls input[type=range]').value)"
LENGTH = "Number(document.querySelector('.look-controls input[type=range]').max)"
LONGEST_STEP = f"""async frames => {{
  const steps = [];
  for (let before = {TIME}; steps.length < frames; before = {TIME}) {{
    await new Promise(requestAnimationFrame);
    steps.push({TIME} - before);
  }}
  return Math.max(...steps);
}}"""
"""the longest step of the clip's time within some frames, seconds; a frame lasts 0.1 s at most"""
DRAWN_ALONE = "__viewer.pixels() && __viewer.detail().triangles"
"""the triangles of a picture of the characters alone"""
TWO_FRAMES = "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"


def playing(page: Page) -> list[str]:
    buttons = page.locator(".look-play button[aria-pressed=true]")
    names: list[str] = buttons.evaluate_all("all => all.map(one => one.ariaLabel.replace('play ', ''))")
    return sorted(names)


def check_clips(page: Page, controls: Locator) -> None:
    """Alone, a clip ends the others; without a loop it stays at its end; its speed is chosen."""
    page.get_by_role("button", name="play Dance").click()
    page.get_by_role("button", name="play Wave").click()
    assert playing(page) == ["Wave"]
    controls.get_by_label("solo").uncheck()
    page.get_by_role("button", name="play Dance").click()
    assert playing(page) == ["Dance", "Wave"]
    speed = controls.get_by_label("speed of the clips")
    speed.select_option("0.1×")
    assert 0 < page.evaluate(LONGEST_STEP, 12) < 0.0101
    speed.select_option("2×")
    controls.get_by_label("loop").uncheck()
    until(page, f"{LENGTH} - {TIME} < 1e-6")
    assert page.evaluate(LONGEST_STEP, 3) == 0
    controls.get_by_label("loop").check()
    until(page, f"{TIME} > 0.1 && {TIME} < {LENGTH} / 2")


def picture(page: Page) -> bytes:
    page.evaluate(TWO_FRAMES)
    return page.locator(".look-canvas").screenshot()


def check_contents(page: Page) -> None:
    """A morph target and a mesh change the picture, which else stands still."""
    seen = picture(page)
    assert picture(page) == seen
    page.get_by_text("morph targets").click()
    page.get_by_role("slider", name="Surprised").press("End")
    surprised = picture(page)
    assert surprised != seen
    page.get_by_text("meshes").click()
    page.get_by_role("checkbox", name="Head_4").uncheck()
    assert picture(page) != surprised


@needs_assets
def test_a_dropped_model_is_looked_at_before_it_has_a_machine(
    own: Callable[[], set[str]],
    viewer: Page,
) -> None:
    drop(viewer, "robot.glb", ROBOT.read_bytes())
    controls = viewer.locator(".look-controls")
    controls.wait_for()
    check_clips(viewer, controls)
    controls.get_by_role("button", name="pause").click()
    controls.get_by_label("time in the clip").press("Home")
    until(viewer, f"{TIME} === 0")
    check_contents(viewer)
    assert "machines/robot" not in own()
    viewer.keyboard.press("Escape")
    until(viewer, "!document.querySelector('dialog[open]')")


@needs_assets
def test_what_a_dropped_model_holds_can_be_read(own: Callable[[], set[str]], viewer: Page) -> None:
    """Also what was wrong with it; its joints can be drawn over the picture."""
    drop(viewer, "man.glb", (GLTF / "CesiumMan.glb").read_bytes())
    held = viewer.locator(".look-contents")
    held.locator("summary").filter(has_text="1 mesh").wait_for()
    for summary in held.locator("summary").all():
        summary.click()
    note, mesh, joints, material, texture = held.locator("details").all_inner_texts()
    assert note.startswith("1 note\nskin weights did not sum to 1 and were normalised: 210 of 3273")
    assert mesh == "1 mesh, 4,672 triangles\nCesium_Man\n4,672 triangles"
    assert joints.split("\n")[:4] == ["22 joints", "node 0", "  node 21", "    node 2"]
    assert joints.count("\n") == 22
    assert material == "1 material\nCesium_Man-effect baseColor"
    assert texture == "1 texture\nimage/jpeg · 1024 × 1024 · 210 kB"
    shows = viewer.locator(".look-controls").get_by_label("joints")
    seen = picture(viewer)
    shows.check()
    assert picture(viewer) != seen
    shows.uncheck()
    assert picture(viewer) == seen


def triangles_at(model: bytes) -> dict[str, int]:
    """The triangles at each node of a .glb by its name, read by pygltflib."""
    read = pygltflib.GLTF2().load_from_bytes(model)
    return {
        node.name: sum(read.accessors[one.indices].count // 3 for one in read.meshes[node.mesh].primitives)
        for node in read.nodes
        if node.mesh is not None
    }


@needs_assets
def test_hidden_meshes_stay_away_from_the_machine_and_its_files(
    own: Callable[[], set[str]], viewer: Page, allowed: list[str]
) -> None:
    """Also after a name that the server refused, and another choice of meshes."""
    allowed.append("422")
    drop(viewer, "knight.glb", KNIGHT.read_bytes())
    viewer.get_by_text("15 meshes").click()
    hidden = ("1H_Sword", "Round_Shield")
    for weapon in (*hidden, "2H_Sword"):
        viewer.get_by_role("checkbox", name=re.compile(f"^{weapon} ")).uncheck()
    viewer.get_by_label("name", exact=True).fill("no name")
    viewer.get_by_role("button", name="Make a machine").click()
    viewer.get_by_role("alert").filter(has_text="no name").wait_for()
    viewer.get_by_role("checkbox", name="2H_Sword").check()
    viewer.get_by_label("name", exact=True).fill("knight")
    viewer.get_by_role("button", name="Make a machine").click()
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready")
    left = {name: count for name, count in triangles_at(KNIGHT.read_bytes()).items() if name not in hidden}
    assert viewer.evaluate(DRAWN_ALONE) == sum(left.values())
    viewer.get_by_role("button", name="download…").click()
    assert triangles_at(downloaded(viewer, "glTF binary").read_bytes()) == left
    assert "machines/knight" in own()
