"""Expressions on the page: each line with its value; edited, and refused with line and reason."""

from collections.abc import Callable, Iterator
from shutil import copytree

import pytest
from browser.axe import begin, faults
from browser.conftest import Server, expression_value, until
from paths import MACHINES
from playwright.sync_api import Page


@pytest.fixture(scope="module")
def gearbox(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server with a gearbox of its own: its machine is edited."""
    folder = tmp_path_factory.mktemp("gears")
    copytree(MACHINES / "gearbox", folder / "box")
    with Server(folder / "data", folder / "box") as running:
        yield running


@pytest.fixture
def panel(gearbox: Server, opened_wide: Callable[[str], Page]) -> Page:
    return opened_wide(gearbox.url)


def test_channels_and_variables_have_values_that_move(panel: Page) -> None:
    until(panel, f"{expression_value('radius_a')} === 10")
    until(panel, f"{expression_value('gear_a.rotate_z')} > 0")
    first = panel.evaluate(expression_value("gear_a.rotate_z"))
    until(panel, f"{expression_value('gear_a.rotate_z')} > arg", first)
    assert abs(first % 10) < 1e-6


def test_a_wrong_line_is_named_and_nothing_changes(panel: Page, allowed: list[str]) -> None:
    allowed.append("422")
    panel.get_by_role("button", name="edit", exact=True).click()
    text = panel.get_by_role("textbox", name="expressions")
    before = text.input_value()
    text.fill("radius_a = 10\ngear_a.rotate_z = pase * frameid")
    panel.get_by_role("button", name="keep").click()
    panel.get_by_role("alert").filter(has_text="line 2: no variable is called 'pase'").wait_for()
    begin(panel)
    assert faults(panel) == []
    chosen = "e => e.value.slice(e.selectionStart, e.selectionEnd)"
    assert text.evaluate(chosen) == "gear_a.rotate_z = pase * frameid"
    panel.get_by_role("button", name="cancel").click()
    panel.get_by_role("button", name="edit", exact=True).click()
    assert panel.get_by_role("textbox", name="expressions").input_value() == before


def test_a_kept_line_counts_at_once(panel: Page) -> None:
    panel.get_by_role("button", name="edit", exact=True).click()
    text = panel.get_by_role("textbox", name="expressions")
    text.fill(text.input_value().replace("radius_a = 10 ", "radius_a = 12 "))
    panel.get_by_role("button", name="keep").click()
    until(panel, f"{expression_value('radius_a')} === 12")
    until(panel, "document.querySelector('#expressions form').hidden")
