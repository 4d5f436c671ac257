"""A face on the page: keys of expressions, and sliders of single muscles, move the morph targets (DS9)."""

from collections.abc import Callable, Iterator

import pytest
from browser.conftest import Server, until
from paths import MACHINES
from playwright.sync_api import Page


@pytest.fixture(scope="module", params=["face", "car-face"])
def machine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with Server(tmp_path_factory.mktemp("face") / "data", MACHINES / request.param) as running:
        yield running


@pytest.fixture
def face(machine: Server, opened_wide: Callable[[str], Page]) -> Page:
    return opened_wide(machine.url)


def test_a_key_shows_an_expression_and_another_takes_it_back(face: Page) -> None:
    face.keyboard.press("1")
    until(face, "window.__viewer.weights()['corner.left'] > 0.89")
    once, twice, thrice = face.evaluate(
        "['', '.2', '.3'].map(power => window.__viewer.weights()['corner.left' + power])"
    )
    assert (twice, thrice) == pytest.approx((once**2, once**3), abs=1e-5)
    face.keyboard.press("4")
    until(
        face,
        "window.__viewer.weights()['droop.left'] > 0.99 && window.__viewer.weights()['corner.left'] < 0.01",
    )
    face.keyboard.press("0")
    until(face, "Object.values(window.__viewer.weights()).every(weight => Math.abs(weight) < 0.01)")


def test_a_slider_contracts_one_muscle(face: Page) -> None:
    face.get_by_label("corner_right").fill("0.5")
    until(face, "Math.abs(window.__viewer.weights()['corner.right'] - 0.5) < 1e-4")
    weights = face.evaluate("window.__viewer.weights()")
    assert weights["corner.left"] == pytest.approx(0, abs=1e-4)
    face.get_by_label("corner_right").fill("0")
    until(face, "window.__viewer.weights()['corner.right'] < 1e-3")
