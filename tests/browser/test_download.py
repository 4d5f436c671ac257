"""Downloads the watched character in another format, and drops it on the page again."""

from pathlib import Path

import numpy as np
from browser.axe import TWO_FRAMES
from browser.conftest import until
from browser.test_import import drop, own  # noqa: F401 - a fixture
from playwright.sync_api import Page, Route
from statwalk.files.bvh import read_bvh
from statwalk.files.chunk import read_chunk_file


def downloaded(viewer: Page, words: str) -> Path:
    with viewer.expect_download() as waiting:
        viewer.get_by_role("link", name=words).click()
    return Path(waiting.value.path())


def test_formats_that_come_late_are_not_shown_for_another_character(viewer: Page) -> None:
    late: list[Route] = []
    viewer.route("**/formats", lambda route: late.append(route), times=1)
    with viewer.expect_request("**/formats"):
        viewer.get_by_role("button", name="download…").click()
    viewer.keyboard.press("Escape")
    viewer.get_by_label("machine", exact=True).first.select_option("gearbox")
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready")
    viewer.get_by_role("button", name="download…").click()
    links = viewer.get_by_role("dialog").get_by_role("link")
    links.first.wait_for()
    with viewer.expect_response(late[0].request.url):
        late[0].continue_()
    viewer.evaluate(TWO_FRAMES)
    assert {link.get_attribute("href").split("/")[-2] for link in links.all()} == {"gearbox"}


def test_a_downloaded_character_comes_back_by_dropping(viewer: Page, own: object) -> None:  # noqa: F811
    viewer.get_by_role("button", name="download…").click()
    viewer.get_by_label("first clip").select_option("walk")
    walk = read_bvh(downloaded(viewer, "BVH").read_bytes(), "walk")
    assert np.ptp(walk.clips["walk"].sample([0, 0.2]).rotation, 0).max() > 0.1
    rows = viewer.get_by_role("listitem")
    assert "cannot hold" in rows.filter(has_text="BVH").inner_text()
    assert "holds everything" in rows.filter(has_text="chunk").inner_text()
    data = downloaded(viewer, "chunk").read_bytes()
    assert "walk" in read_chunk_file(data, "x").clips
    viewer.keyboard.press("Escape")
    drop(viewer, "mine.chunk", data)
    viewer.get_by_label("walk", exact=True).wait_for()
    viewer.keyboard.press("Enter")
    until(viewer, "__viewer.stage() !== 'main' && __viewer.ready")
    assert viewer.evaluate("__viewer.pixels().covered") > 0.02
