"""DS6, DS7, DS8 in the page: two arms driven by the elbow, by the GPU and by the server; their glue."""

from collections.abc import Callable, Iterator
from typing import Any

import httpx
import pytest
from browser.conftest import Server, controls, expression_value, leave, until
from playwright.sync_api import Page

WEIGHT = expression_value("right_biceps.weight")


@pytest.fixture
def stage(server: Server) -> str:
    """A stage of its own, where the arms are bent."""
    setup = {"actors": [{"machine": "biceps"}], "clock": "manual"}
    made = httpx.post(f"{server.url}/api/stages", json=setup, timeout=60)
    address = f"{server.url}{made.raise_for_status().headers['Location']}"
    httpx.post(f"{address}/events", json={"event": "BEND"}).raise_for_status()
    httpx.post(f"{address}/step", json={"ticks": 150}, timeout=60).raise_for_status()
    return address


@pytest.fixture
def arms(stage: str, server: Server, opened: Callable[[str], Page]) -> Iterator[Page]:
    """The page on that stage."""
    page = opened(f"{server.url}/?stage={stage.rsplit('/', 1)[1]}")
    until(page, "__viewer.posed() === 150")
    yield page
    leave(page, stage)


def drawn(page: Page, stream: str) -> Any:
    page.get_by_role("button", name=stream, exact=True).click()
    until(page, "__viewer.shown() === arg", stream)
    return page.evaluate("__viewer.pixels()")


def test_the_gpu_and_the_server_draw_the_same_muscles(arms: Page) -> None:
    by_gpu, by_server = drawn(arms, "pose"), drawn(arms, "glb")
    assert by_gpu["covered"] == pytest.approx(by_server["covered"], abs=2e-4)
    assert by_gpu["box"] == pytest.approx(by_server["box"], abs=0.005)
    assert by_gpu["colour"] == pytest.approx(by_server["colour"], abs=8)


@pytest.mark.parametrize("stream", ["pose", "glb"])
def test_glue_changes_nothing_but_the_colours(arms: Page, stream: str) -> None:
    materials = drawn(arms, stream)
    glue = painted(arms, "glue")
    assert glue["covered"] == pytest.approx(materials["covered"], abs=0.001)
    assert glue["colour"][2] > materials["colour"][2] + 20
    assert painted(arms, "materials")["colour"] == pytest.approx(materials["colour"], abs=3)


def test_glue_is_orange_and_loose_parts_have_none(arms: Page) -> None:
    drawn(arms, "pose")
    glue = painted(arms, "glue")["colour"]
    controls(arms).get_by_label("way of skinning").select_option("parts")
    loose = arms.evaluate("__viewer.pixels()")["colour"]
    assert glue[0] - glue[2] > loose[0] - loose[2] + 1


def painted(page: Page, what: str) -> Any:
    controls(page).get_by_label("what the skin shows").select_option(what)
    return page.evaluate("__viewer.pixels()")


def test_the_page_shows_the_weight_of_the_bulge(arms: Page, stage: str) -> None:
    """At -125 degrees the cubic is 1.7."""
    until(arms, f"Math.abs({WEIGHT} - 0.7) < 0.001")
    httpx.post(f"{stage}/events", json={"event": "STRETCH"}).raise_for_status()
    httpx.post(f"{stage}/step", json={"ticks": 150}, timeout=60).raise_for_status()
    until(arms, f"Math.abs({WEIGHT}) < 0.001")
