"""DS1, DS3, DS5 and dual quaternions in the page: one arm in four ways, by the GPU and by the server."""

from collections.abc import Callable, Iterator
from typing import Any

import httpx
import pytest
from browser.conftest import Server, controls, leave, until
from playwright.sync_api import Page

WAYS = ("linear", "dual-quaternion", "rigid", "parts")


@pytest.fixture
def arm(server: Server, opened: Callable[[str], Page]) -> Iterator[Page]:
    """The page on a stage of its own, where the arm's forearm is twisted."""
    setup = {"actors": [{"machine": "elbow"}], "clock": "manual"}
    made = httpx.post(f"{server.url}/api/stages", json=setup, timeout=60)
    stage = f"{server.url}{made.raise_for_status().headers['Location']}"
    httpx.post(f"{stage}/events", json={"event": "TWIST"}).raise_for_status()
    httpx.post(f"{stage}/step", json={"ticks": 150}, timeout=60).raise_for_status()
    page = opened(f"{server.url}/?stage={stage.rsplit('/', 1)[1]}")
    until(page, "__viewer.posed() === 150")
    yield page
    leave(page, stage)


def choose(page: Page, way: str) -> None:
    controls(page).get_by_label("way of skinning").select_option(way)


def drawn(page: Page, stream: str) -> Any:
    page.get_by_role("button", name=stream, exact=True).click()
    until(page, "__viewer.shown() === arg", stream)
    return page.evaluate("__viewer.pixels()")


@pytest.mark.parametrize("way", WAYS)
def test_the_gpu_and_the_server_draw_the_same_arm(arm: Page, way: str) -> None:
    choose(arm, way)
    by_gpu, by_server = drawn(arm, "pose"), drawn(arm, "glb")
    assert by_gpu["covered"] == pytest.approx(by_server["covered"], abs=2e-4)
    assert by_gpu["box"] == pytest.approx(by_server["box"], abs=0.005)
    assert by_gpu["colour"] == pytest.approx(by_server["colour"], abs=8)


def test_linear_skin_is_thin_where_it_twists(arm: Page) -> None:
    covered = {}
    for way in WAYS:
        choose(arm, way)
        covered[way] = drawn(arm, "pose")["covered"]
    assert covered["linear"] < 0.95 * covered["dual-quaternion"]
    assert covered["rigid"] == pytest.approx(covered["dual-quaternion"], rel=0.01)


def test_the_wire_follows_the_way(arm: Page) -> None:
    """Wire alone: thinner in linear skin."""
    arm.get_by_role("button", name="wire").click()
    arm.get_by_role("button", name="skin", exact=True).click()
    covered = {}
    for way in ("dual-quaternion", "linear", "dual-quaternion"):
        choose(arm, way)
        covered[way] = arm.evaluate("__viewer.pixels().covered")
    assert covered["linear"] < 0.97 * covered["dual-quaternion"]


def test_without_a_choice_the_characters_own_counts(arm: Page) -> None:
    choose(arm, "linear")
    linear = drawn(arm, "pose")["covered"]
    choose(arm, "")
    assert drawn(arm, "pose")["covered"] == linear
