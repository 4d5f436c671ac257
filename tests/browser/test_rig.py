"""A dropped mesh without a skin: the page offers a skeleton, and the mesh bends."""

import pytest
from browser.axe import LARGE, begin, faults
from browser.conftest import until
from browser.test_import import drop, own
from paths import ROOT
from playwright.sync_api import Page
from rig_shapes import cylinder, mesh, stripped
from statwalk.services.library.load import load

__all__ = ["own"]
WALKER = ROOT / "machines" / "faq-walker" / "walker.glb"


@pytest.mark.usefixtures("own")
def test_a_dropped_statue_gets_a_skeleton_and_bends(viewer: Page) -> None:
    """Also without one of its meshes, which was hidden when the machine was made."""
    viewer.set_default_timeout(60_000)
    drop(viewer, "Statue.glb", stripped(load(WALKER)).model_glb)
    viewer.locator("dialog .look-canvas").wait_for()
    viewer.locator(".look-contents summary", has_text="mesh").wait_for()
    viewer.get_by_label("it is", exact=True).select_option("human")
    viewer.get_by_role("button", name="Rig it").click()
    viewer.get_by_label("Bend", exact=True).wait_for()
    viewer.get_by_text("5 meshes").click()
    viewer.locator(".look-contents").get_by_role("checkbox").first.uncheck()
    viewer.get_by_role("button", name="Make a machine").click()
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready")
    assert viewer.evaluate("__viewer.bodies()") == 4
    joints = viewer.evaluate("__viewer.joints()")
    assert {"Hips", "LeftUpperArm", "RightFoot"} <= joints.keys()
    start = joints["LeftHand"]
    until(viewer, "Math.hypot(...__viewer.joints().LeftHand.map((v, i) => v - arg[i])) > 0.02", start)


@pytest.mark.usefixtures("own")
def test_what_does_not_fit_is_said_in_the_form(viewer: Page, allowed: list[str]) -> None:
    allowed.append("422")
    viewer.set_default_timeout(60_000)
    drop(viewer, "post.glb", mesh(*cylinder()).model_glb)
    viewer.get_by_label("it is", exact=True).select_option("mammal")
    viewer.get_by_role("button", name="Rig it").click()
    viewer.get_by_role("alert").filter(has_text="legs must be apart").wait_for()
    viewer.set_viewport_size(LARGE)
    begin(viewer)
    assert faults(viewer) == []
    viewer.get_by_label("it is", exact=True).select_option("parts")
    viewer.get_by_role("button", name="Rig it").click()
    viewer.get_by_label("Bend", exact=True).wait_for()
    viewer.keyboard.press("Escape")
