"""Another character takes the place of the one that is shown, also if its file names no material, or cannot
be loaded.
"""

from collections.abc import Callable, Iterator
from pathlib import Path

import httpx
import pytest
from browser.conftest import Server, until
from paths import GLTF, needs_assets
from playwright.sync_api import Page

SHOWN = (
    "__viewer.stage() !== 'main' && __viewer.ready && __viewer.posed() >= 0 && __viewer.pixels().covered "
    "> 0.005"
)
MOST_COLOUR = 14
PATIENCE = 60.0


@pytest.fixture
def made(server: Server, page: Page) -> Iterator[Callable[[Path], str]]:
    """Makes a machine of a model file and returns its name; afterwards the machine and its stage are gone."""
    names: list[str] = []

    def make(file: Path) -> str:
        names.append(file.stem)
        character = f"{server.url}/api/characters/{file.stem}"
        content = {"content": file.read_bytes(), "headers": {"Content-Type": "application/octet-stream"}}
        httpx.put(character, timeout=PATIENCE, **content).raise_for_status()
        states = httpx.get(f"{character}/mapping").json()["mapping"]
        machine = {"name": file.stem, "character": file.stem, "mapping": states}
        httpx.post(f"{server.url}/api/machines", json=machine, timeout=PATIENCE).raise_for_status()
        return file.stem

    yield make
    page.goto("about:blank")  # before it can ask for what is deleted
    for stage in httpx.get(f"{server.url}/api/stages").json():
        if stage["id"] != "main":
            httpx.delete(f"{server.url}/api/stages/{stage['id']}")
    for path in (f"{kind}/{name}" for name in names for kind in ("machines", "characters")):
        httpx.delete(f"{server.url}/api/{path}", timeout=PATIENCE).raise_for_status()


def choose(page: Page, machine: str) -> None:
    """Opens the page anew, so that it lists `machine`, and chooses it there."""
    page.reload()
    until(page, "window.__viewer?.ready")
    page.get_by_label("machine", exact=True).first.select_option(machine)


@needs_assets
@pytest.mark.parametrize("file", ["SimpleSkin.gltf", "AnimatedTriangle.gltf"])
def test_a_model_without_materials_is_drawn(made: Callable[[Path], str], viewer: Page, file: str) -> None:
    """Where the walker stood nothing of its orange shirt is left: the model is grey."""
    choose(viewer, made(GLTF / file))
    until(viewer, SHOWN)
    colour = viewer.evaluate("__viewer.pixels().colour")
    until(viewer, "document.querySelector('#loading').textContent === ''")
    assert max(colour) - min(colour) < 40


@needs_assets
def test_server_and_gpu_give_it_the_same_material(made: Callable[[Path], str], viewer: Page) -> None:
    choose(viewer, made(GLTF / "SimpleSkin.gltf"))
    until(viewer, SHOWN)
    by_gpu = viewer.evaluate("__viewer.pixels().colour")
    viewer.keyboard.press("g")
    until(viewer, "__viewer.shown() === 'glb' && __viewer.pixels().covered > 0.005")
    by_server = viewer.evaluate("__viewer.pixels().colour")
    assert max(abs(a - b) for a, b in zip(by_gpu, by_server, strict=True)) < MOST_COLOUR
