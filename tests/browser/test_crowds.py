"""Crowds in the page: one draw call for each cast and material; each instance is its actor, to the GPU's last
vertex.
"""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from browser.conftest import Server, controls, leave, until
from many_bones import many_bones
from playwright.sync_api import Page
from statwalk.files.gltf import read_model
from statwalk.files.machine_yaml.new_machine import write_machine

WAYS = ("linear", "dual-quaternion", "rigid", "parts")
MOST_M = 1e-4
OVERHEAD = 8
"""draw calls of ground, shadows, the second side of wings, and what else is no character"""
Opened = Callable[..., Page]


@pytest.fixture
def at_stage(server: Server, page: Page, opened: Callable[[str], Page]) -> Iterator[Opened]:
    """Opens the page at a manual stage of its own, which has made `ticks`; events go to all actors."""
    made: list[str] = []

    def open_at(ticks: int, event: str = "", **setup: Any) -> Page:
        reply = httpx.post(f"{server.url}/api/stages", json={"clock": "manual", **setup}, timeout=60)
        made.append(f"{server.url}{reply.raise_for_status().headers['Location']}")
        if event:
            httpx.post(f"{made[-1]}/events", json={"event": event}).raise_for_status()
        httpx.post(f"{made[-1]}/step", json={"ticks": ticks}, timeout=60).raise_for_status()
        opened(f"{server.url}/?stage={made[-1].rsplit('/', 1)[1]}")
        until(page, "__viewer.posed() === arg", ticks)
        return page

    yield open_at
    leave(page, *made)


MEASURED = """(({difference, ...of}) => typeof difference === 'number'
    && Object.entries(arg).every(([name, value]) => of[name] === value))(__viewer.proved())"""


def proved(page: Page, **of: str | int) -> float:
    """The largest distance between the GPU's vertices and the server's, metres; `of`: actor, tick or way."""
    until(page, MEASURED, of)
    distance: float = page.evaluate("__viewer.proved().difference")
    return distance


def choose_actor(page: Page, actor: int) -> None:
    page.get_by_label("actor", exact=True).select_option(str(actor))


def test_a_swarm_takes_one_call_for_each_material(at_stage: Opened) -> None:
    page = at_stage(60, scene="swarm")
    materials = 4  # black, yellow, eyes, wings
    assert page.evaluate("__viewer.bodies()") == materials
    assert page.evaluate("__viewer.calls()") <= materials + OVERHEAD


def test_both_streams_show_the_same_geese(at_stage: Opened) -> None:
    page = at_stage(60, scene="geese")
    by_gpu = page.evaluate("__viewer.pixels()")
    page.keyboard.press("g")
    until(page, "__viewer.shown() === 'glb'")
    by_server = page.evaluate("__viewer.pixels()")
    assert by_gpu["covered"] == pytest.approx(by_server["covered"], rel=0.01)
    assert by_gpu["box"] == pytest.approx(by_server["box"], abs=0.005)
    assert by_gpu["colour"] == pytest.approx(by_server["colour"], abs=4)


def test_each_instance_is_its_actor(at_stage: Opened) -> None:
    page = at_stage(60, scene="street")
    controls(page).get_by_role("button", name="prove").click()
    for actor in (2, 6, 11):
        choose_actor(page, actor)
        assert proved(page, actor=actor) < MOST_M


POSED = {
    "faq-walker": ("FORWARD", 100),
    "elbow": ("TWIST", 100),
    "biceps": ("BEND", 20),  # the elbow on its way
    "face": ("SMILE", 10),  # half a smile
    "car-face": ("SURPRISE", 10),
}


@pytest.mark.parametrize("machine", POSED)
def test_gpu_and_server_agree_in_all_ways(at_stage: Opened, machine: str) -> None:
    event, ticks = POSED[machine]
    page = at_stage(ticks, event, actors=[{"machine": machine}])
    controls(page).get_by_role("button", name="prove").click()
    for way in WAYS:
        controls(page).get_by_label("way of skinning").select_option(way)
        assert proved(page, way=way) < MOST_M, way
    page.get_by_text("GPU and server differ by at most 0.00").wait_for()


COVERED = """words => {
  const { left, right, top, bottom } = words.getBoundingClientRect();
  const places = [left + 2, (left + right) / 2, right - 2];
  return places.filter(x => !words.contains(document.elementFromPoint(x, (top + bottom) / 2))).length;
}"""


def test_the_box_of_controls_does_not_cover_what_prove_says(at_stage: Opened) -> None:
    page = at_stage(1, actors=[{"machine": "faq-walker"}])
    controls(page).get_by_role("button", name="prove").click()
    words = page.get_by_text("GPU and server differ by at most 0.00")
    words.wait_for()
    assert words.evaluate(COVERED) == 0


WEIGHTS = "JSON.stringify(__viewer.weights())"


@pytest.mark.parametrize(("machine", "event"), [("face", "GRIN"), ("car-face", "ANGER"), ("biceps", "CURL")])
def test_gpu_and_server_agree_while_weights_move(
    server: Server, at_stage: Opened, machine: str, event: str
) -> None:
    page = at_stage(1, event, actors=[{"machine": machine}])
    controls(page).get_by_role("button", name="prove").click()
    stage = f"{server.url}/api/stages/{page.evaluate('__viewer.stage()')}"
    weights = set()
    for tick in range(4, 20, 3):
        httpx.post(f"{stage}/step", json={"ticks": 3}).raise_for_status()
        assert proved(page, tick=tick) < MOST_M
        weights.add(page.evaluate(WEIGHTS))
    assert len(weights) == 6


@pytest.mark.parametrize("stream", ["pose", "glb"])
def test_a_click_chooses_the_actor(at_stage: Opened, stream: str) -> None:
    two = [{"machine": "faq-walker", "position": [x, 0, 0]} for x in (0, 1.5)]
    page = at_stage(10, actors=two)
    page.get_by_role("button", name=stream, exact=True).click()
    until(page, "__viewer.shown() === arg", stream)
    shown = page.get_by_label("actor", exact=True)
    for actor in ("2", "1"):
        page.mouse.click(*page.evaluate(f"__viewer.places()['{actor}']"))
        until(page, "document.querySelector('#picker [aria-label=actor]').value === arg", actor)
    page.mouse.click(*page.evaluate("[document.querySelector('#stage-view').clientWidth - 20, 200]"))
    assert shown.input_value() == "1"


PICK = """name => {
  const list = document.querySelector('#picker select');
  list.value = name;
  list.dispatchEvent(new Event('change'));
}"""


def change_to(page: Page, machine: str) -> Any:
    """Changes to another machine or scene; returns what the GPU holds then."""
    stage = page.evaluate("__viewer.stage()")
    page.evaluate(PICK, machine)
    until(page, "__viewer.stage() !== arg && __viewer.ready", stage)
    before = page.evaluate("__viewer.stats().drawn")
    until(page, "__viewer.stats().drawn > arg + 2", before)
    return page.evaluate("__viewer.held()")


def test_nothing_of_an_old_scene_survives(viewer: Page) -> None:
    until(viewer, "document.querySelectorAll('#picker option').length > 1")
    alone = change_to(viewer, "elbow")
    change_to(viewer, "scene:swarm")
    viewer.get_by_role("button", name="wire").click()
    viewer.get_by_role("button", name="wire").click()
    change_to(viewer, "elbow")
    until(viewer, "JSON.stringify(__viewer.held()) === JSON.stringify(arg)", alone)


@pytest.fixture(scope="module")
def many_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server with models whose vertices follow eight and twelve bones."""
    folder = tmp_path_factory.mktemp("bones")
    for count in (8, 12):
        model = read_model(many_bones(count), f"{count}-bones")
        write_machine(model, Path(folder / f"{count}-bones.glb"), folder / f"{count}-bones")
    with Server(folder / "data", *(folder / f"{count}-bones" for count in (8, 12))) as running:
        yield running


def test_eight_bones_for_a_vertex_are_blended(many_server: Server, opened: Callable[[str], Page]) -> None:
    page = opened(many_server.url)
    controls(page).get_by_role("button", name="prove").click()
    for way in WAYS:
        controls(page).get_by_label("way of skinning").select_option(way)
        assert proved(page, way=way) < MOST_M, way


def test_more_bones_for_a_vertex_are_left_to_the_server(
    many_server: Server, opened: Callable[[str], Page]
) -> None:
    actors = {"actors": [{"machine": "12-bones"}]}
    stage = httpx.post(f"{many_server.url}/api/stages", json=actors, timeout=60).json()["id"]
    page = opened(f"{many_server.url}/?stage={stage}")
    until(page, "__viewer.shown() === 'glb'")
    assert page.evaluate("__viewer.pixels().covered") > 0.001
