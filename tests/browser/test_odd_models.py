"""Models that are legal and unusual are shown: points, lines, bones alone, no clips, a .gltf with its files.
Nothing of an old scene survives, and a model that fails says so in its place.
"""

import base64
import re
from collections.abc import Callable, Iterator

import httpx
import odd_models
import pytest
from browser.conftest import Server, leave, until
from paths import GLTF, MACHINES, needs_assets
from playwright.sync_api import Page
from statwalk.files.gltf import read_model
from statwalk.files.machine_yaml.new_machine import write_machine

DROP = """files => {
  const carried = new DataTransfer();
  for (const [name, base64] of files)
    carried.items.add(new File([Uint8Array.from(atob(base64), letter => letter.charCodeAt(0))], name));
  const options = { dataTransfer: carried, bubbles: true, cancelable: true };
  for (const type of ['dragover', 'drop']) document.body.dispatchEvent(new DragEvent(type, options));
}"""
COVERED = "__viewer.pixels().covered"
SHARED = [GLTF / f"{name}.gltf" for name in ("AnimatedTriangle", "SimpleSkin")]
Shown = Callable[[str], Page]


@pytest.fixture(scope="module")
def odd_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server with a machine for each odd model, as `statwalk new` makes it."""
    folder = tmp_path_factory.mktemp("odd")
    models = {f"ring-{mode}": odd_models.drawn(mode) for mode in range(4)}
    models |= {
        "red-ring": odd_models.drawn(odd_models.LINE_LOOP, [1, 0, 0]),
        "bones": odd_models.bare_bones(),
    }
    models |= {path.stem: path.read_bytes() for path in SHARED if path.is_file()}
    for name, data in models.items():
        write_machine(read_model(data, name), folder / f"{name}.glb", folder / name)
    with Server(folder / "data", *(folder / name for name in models)) as running:
        yield running


@pytest.fixture
def shown(odd_server: Server, opened: Callable[[str], Page]) -> Shown:
    """Opens the page at a stage of its own with one of the odd models."""

    def show(name: str) -> Page:
        actors = {"actors": [{"machine": name}]}
        stage = httpx.post(f"{odd_server.url}/api/stages", json=actors, timeout=60).json()["id"]
        return opened(f"{odd_server.url}/?stage={stage}")

    return show


def in_glb_stream(page: Page) -> None:
    page.keyboard.press("g")
    until(page, "__viewer.frames() === 'glb' && __viewer.shown() === 'glb'")


@pytest.mark.parametrize("mode", range(4), ids=["points", "lines", "loop", "strip"])
def test_points_and_lines_are_drawn_in_both_streams(shown: Shown, mode: int) -> None:
    page = shown(f"ring-{mode}")
    by_browser = page.evaluate("__viewer.pixels()")
    in_glb_stream(page)
    by_server = page.evaluate("__viewer.pixels()")
    assert by_browser["covered"] > 0.001
    assert by_server["covered"] == pytest.approx(by_browser["covered"], rel=0.02)
    # drawn in the page's ink: glTF's white would be invisible in the light theme
    if page.evaluate("matchMedia('(prefers-color-scheme: dark)').matches"):
        assert min(by_browser["colour"]) > 150
    else:
        assert max(by_browser["colour"]) < 100
    page.keyboard.press("1")
    until(page, f"{COVERED} === 0")


def test_lines_keep_the_colour_of_their_material(shown: Shown) -> None:
    page = shown("red-ring")
    colours = [page.evaluate("__viewer.pixels().colour")]
    in_glb_stream(page)
    colours.append(page.evaluate("__viewer.pixels().colour"))
    for red, green, blue in colours:
        assert red > 150 > 60 > max(green, blue)


def test_bones_without_a_mesh_are_drawn_as_bones(shown: Shown) -> None:
    page = shown("bones")
    until(page, "__viewer.state() === 'STAT' && __viewer.overlays() === 1")
    left, top = page.evaluate("__viewer.circle('foot')")
    box = page.locator("#stage-view").bounding_box()
    assert box is not None
    assert 0 < left - box["x"] < box["width"]
    assert 0 < top - box["y"] < box["height"]


@needs_assets
@pytest.mark.parametrize("name", ["AnimatedTriangle", "SimpleSkin"])
def test_models_without_materials_are_drawn_alike(shown: Shown, name: str) -> None:
    page = shown(name)
    page.keyboard.press("p")
    page.wait_for_selector("[data-link=paused]")
    until(page, "__viewer.posed() === __viewer.head()")
    by_browser = page.evaluate("__viewer.pixels()")
    in_glb_stream(page)
    by_server = page.evaluate("__viewer.pixels()")
    assert by_browser["covered"] > 0.02
    assert by_server["covered"] == pytest.approx(by_browser["covered"], abs=0.004)
    assert by_server["colour"] == pytest.approx(by_browser["colour"], abs=14)


@pytest.fixture
def no_models(page: Page, allowed: list[str]) -> None:
    """The network loses every model."""
    allowed.append("Failed to load resource")
    page.route(re.compile(r"/model\.glb"), lambda route: route.abort())


def test_a_model_that_fails_says_so_in_its_place(no_models: None, viewer: Page) -> None:
    viewer.get_by_text("The model of faq-walker cannot be loaded").wait_for()
    until(viewer, f"{COVERED} > 0.005")
    until(viewer, "document.querySelector('#loading').textContent === ''")


def test_nothing_of_an_old_scene_survives_a_new_one(viewer: Page, server: Server, allowed: list[str]) -> None:
    allowed.append("Failed to load resource")
    assert viewer.evaluate("'Head' in __viewer.joints()") is True
    viewer.route(re.compile(r"/model\.glb"), lambda route: route.abort())
    viewer.get_by_role("combobox", name="machine").select_option("tree")
    viewer.get_by_text("cannot be loaded").wait_for()
    until(viewer, "__viewer.ready && __viewer.stage() !== 'main'")
    until(viewer, "!('Head' in __viewer.joints()) && __viewer.bodies() === 0")
    leave(viewer, f"{server.url}/api/stages/{viewer.evaluate('__viewer.stage()')}")


def drop(page: Page, files: dict[str, bytes]) -> None:
    """Drops the files one by one: their folders are lost."""
    named = [[path.rsplit("/")[-1], base64.b64encode(data).decode()] for path, data in files.items()]
    page.evaluate(DROP, named)


def test_a_gltf_with_its_files_is_dropped_together(server: Server, viewer: Page) -> None:
    drop(viewer, odd_models.picture_files())
    viewer.get_by_role("button", name="Leave it as it is").click()  # without a skeleton
    viewer.get_by_role("heading", name="A model without animations").wait_for()
    viewer.get_by_role("button", name="Make a machine").click()
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready && __viewer.state() === 'STAT'")
    red, green, blue = viewer.evaluate("__viewer.pixels().colour")
    assert red > 120 > 60 > max(green, blue)
    made = f"stages/{viewer.evaluate('__viewer.stage()')}", "machines/panel", "characters/panel"
    leave(viewer, *(f"{server.url}/api/{one}" for one in made))


def test_a_gltf_alone_says_what_it_needs(viewer: Page) -> None:
    files = odd_models.picture_files()
    drop(viewer, {"panel.gltf": files["panel.gltf"]})
    viewer.get_by_role("alert").filter(has_text="panel.gltf needs panel.bin").wait_for()


def test_a_character_file_is_dropped_with_its_texts(server: Server, viewer: Page) -> None:
    """The FAQ's mammal: a skeleton table, and a text of key frames for each clip."""
    texts = {path.name: path.read_bytes() for path in (MACHINES / "faq-printed").glob("*.txt")}
    drop(viewer, {**texts, "mammal.yaml": (MACHINES / "faq-printed" / "character.yaml").read_bytes()})
    viewer.get_by_label("start-walk", exact=True).wait_for()
    viewer.get_by_role("button", name="Make a machine").click()
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready && !('Jaw' in __viewer.joints())")
    assert viewer.evaluate("'Lowerback' in __viewer.joints()")
    assert viewer.evaluate(COVERED) > 0.005
    made = f"stages/{viewer.evaluate('__viewer.stage()')}", "machines/mammal", "characters/mammal"
    leave(viewer, *(f"{server.url}/api/{one}" for one in made))
