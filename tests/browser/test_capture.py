"""Motion capture on the page: a dropped walk is carried over to the watched character and plays; where names
tell no bones, a dialog asks.
"""

from collections.abc import Callable
from pathlib import Path

import captures
import pytest
from browser.axe import LARGE, begin, faults
from browser.conftest import until
from browser.test_import import drop, own
from browser.test_other_character import SHOWN, choose, made
from paths import ASSETS, GLTF, needs_assets
from playwright.sync_api import Page
from serving import wait_for

__all__ = ["made", "own"]
WALK = ASSETS / "bvh" / "cmu_12_01_walk.bvh"
PLAYS = "__viewer.stage() !== 'main' && __viewer.ready && __viewer.state() === arg"
UNKNOWN = {"Hips": "bone_a", "LeftUpLeg": "bone_b", "RightUpLeg": "bone_c"}
"""names of joints that do not tell which bones they are"""
MOVED = (
    "Object.entries(__viewer.joints()).some(([name, at]) => "
    "Math.hypot(...at.map((v, i) => v - arg[name][i])) > 0.2)"
)


def dropped_walk(page: Page) -> dict[str, list[float]]:
    """Drops the captured walk, waits until a joint has moved by 20 cm, and returns where the joints are."""
    drop(page, "cmu walk.bvh", WALK.read_bytes())
    until(page, PLAYS, "CMU-WALK")
    until(page, MOVED, page.evaluate("__viewer.joints()"))
    joints: dict[str, list[float]] = page.evaluate("__viewer.joints()")
    return joints


@needs_assets
def test_a_dropped_walk_plays_on_the_walker(own: Callable[[], set[str]], viewer: Page) -> None:
    joints = dropped_walk(viewer)
    assert joints["Head"][1] > joints["Root"][1] + 0.3 > joints["Left.foot"][1] + 0.6
    assert viewer.evaluate("__viewer.pixels().covered") > 0.02
    assert {name for name in own() if "cmu" in name} == {
        "machines/walker-cmu-walk",
        "characters/walker-cmu-walk",
    }


@needs_assets
def test_the_same_walk_plays_on_a_robot_of_other_size_and_names(
    own: Callable[[], set[str]], made: Callable[[Path], str], viewer: Page
) -> None:
    choose(viewer, made(GLTF / "RobotExpressive.glb"))
    until(viewer, SHOWN)
    joints = dropped_walk(viewer)
    assert joints["Head"][1] > joints["Hips"][1] + 1 > joints["Foot.L"][1] + 1.3
    assert viewer.evaluate("__viewer.pixels().covered") > 0.02
    assert "machines/RobotExpressive-cmu-walk" in own()


def test_the_dialog_asks_for_bones_without_known_names(own: Callable[[], set[str]], viewer: Page) -> None:
    drop(viewer, "odd.bvh", captures.walk(UNKNOWN).encode())
    viewer.get_by_text("Which joint is which bone?").wait_for()
    viewer.get_by_text("arms, spine, head and fingers").click()
    viewer.set_viewport_size(LARGE)
    begin(viewer)
    assert faults(viewer) == []
    for bone, joint in (("hips", "bone_a"), ("left upper leg", "bone_b"), ("right upper leg", "bone_c")):
        viewer.get_by_label(f"{bone}: joint of the capture").fill(joint)
    viewer.get_by_role("button", name="Carry it over").click()
    until(viewer, PLAYS, "ODD")
    assert {name for name in own() if "odd" in name} == {"machines/walker-odd", "characters/walker-odd"}


def test_a_capture_that_is_given_up_leaves_nothing(own: Callable[[], set[str]], viewer: Page) -> None:
    before = own()
    drop(viewer, "given-up.bvh", captures.walk(UNKNOWN).encode())
    viewer.get_by_text("Which joint is which bone?").wait_for()
    with viewer.expect_response(lambda answer: answer.request.method == "DELETE"):
        viewer.keyboard.press("Escape")
    viewer.get_by_role("dialog").wait_for(state="detached")
    wait_for(lambda: own() == before)


def test_what_does_not_move_is_said_and_may_be_mapped(own: Callable[[], set[str]], viewer: Page) -> None:
    names = {"LeftArm": "bone_q", "LeftForeArm": "bone_r", "LeftHand": "bone_s"}
    drop(viewer, "arms.bvh", captures.walk(names).encode())
    until(viewer, PLAYS, "ARMS")
    said = viewer.locator("#notices p", has_text="carried over")
    said.filter(has_text="The capture does not move Left.shoulder, Left.upperarm").wait_for()
    said.filter(has_text="Nothing takes the motion of bone_q, bone_r, bone_s").wait_for()
    said.get_by_role("button", name="change…").click()
    dialog = viewer.get_by_role("dialog")
    dialog.get_by_text("arms, spine, head and fingers").click()
    for bone, joint in (("upper arm", "bone_q"), ("lower arm", "bone_r"), ("hand", "bone_s")):
        dialog.get_by_label(f"left {bone}: joint of the capture", exact=True).fill(joint)
    dialog.get_by_label("add positions to the offsets of joints").check()
    dialog.get_by_label("low-pass filter, Hz").fill("6")
    with (
        viewer.expect_request(lambda request: request.url.endswith("/clips")) as asked,
        viewer.expect_request(lambda request: "position=add" in request.url),
    ):
        dialog.get_by_role("button", name="Carry it over").click()
    wanted = {"LeftUpperArm": "bone_q", "LeftLowerArm": "bone_r", "LeftHand": "bone_s"}
    body = asked.value.post_data_json
    assert (body["bones"], body["low_pass"], body["spikes"]) == (wanted, 6, False)
    until(viewer, "__viewer.ready && new URL(location).searchParams.get('machine') === 'walker-arms-2'")
    viewer.locator("#notices p", has_text="carried over").filter(has_not_text="bone_q").wait_for()


@pytest.mark.parametrize(("name", "said"), [("a.bvh", "line 1"), ("b.trc", "line 1")])
def test_a_broken_capture_says_why_and_changes_nothing(
    own: Callable[[], set[str]], viewer: Page, allowed: list[str], name: str, said: str
) -> None:
    allowed.append("422")
    before = own()
    drop(viewer, name, b"HIERARCHY\nROOT\n" if name == "a.bvh" else b"PathFileType 4\n")
    viewer.get_by_role("alert").filter(has_text="line").wait_for()
    assert own() == before
