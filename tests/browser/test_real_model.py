"""A machine that `statwalk new` made from a model somebody else drew: it is shown, and walks."""

from collections.abc import Callable

from browser.conftest import Server, until
from paths import needs_assets
from playwright.sync_api import Page

pytestmark = needs_assets


def test_a_machine_made_from_a_real_model_walks(robot_server: Server, opened: Callable[[str], Page]) -> None:
    page = opened(robot_server.url)
    assert page.evaluate("__viewer.pixels().covered") > 0.02
    first = page.evaluate("[__viewer.state(), __viewer.joints()]")
    page.locator("[data-event=FORWARD]").hover()
    page.mouse.down()
    until(page, "__viewer.state().toLowerCase().startsWith('walk')")
    until(
        page,
        "Object.entries(__viewer.joints()).some(([name, at]) => Math.hypot(...at.map((v, i) => v - "
        "arg[name][i])) > 0.2)",
        first[1],
    )
    page.mouse.up()
    until(page, "__viewer.state() === arg", first[0])
