"""Light and background of the picture: chosen by the keyboard, kept for the next visit, and reset; pictures
and film strips are saved.
"""

import struct
from collections.abc import Callable

import httpx
from browser.conftest import Server, controls, leave, mean_colour, until
from playwright.sync_api import Page
from serving import wait_for

BRIGHTNESS = "__viewer.pixels().colour.reduce((a, b) => a + b)"


def corner(page: Page) -> list[float]:
    """The colour of the picture where nothing is but the background."""
    box = page.locator("#stage-view").bounding_box()
    assert box is not None
    clip = {"x": box["x"] + box["width"] - 12, "y": box["y"] + 6, "width": 6, "height": 6}
    return mean_colour(page, page.screenshot(clip=clip))


def test_light_and_background_are_chosen_kept_and_reset(viewer: Page) -> None:
    page = viewer
    first, plain = page.evaluate(BRIGHTNESS), corner(page)
    page.keyboard.press("v")
    until(page, "document.activeElement?.type === 'range'")
    page.keyboard.press("End")
    until(page, f"{BRIGHTNESS} > 1.2 * arg", first)
    page.get_by_label("background", exact=True).select_option("colour")
    page.get_by_label("colour", exact=True).fill("#ff0000")
    page.keyboard.press("Escape")
    page.locator("#scene").wait_for(state="hidden")
    assert corner(page)[:3] == [255, 0, 0]
    page.reload()
    until(page, "window.__viewer?.ready")
    assert corner(page)[:3] == [255, 0, 0]
    assert page.evaluate(BRIGHTNESS) > 1.2 * first
    controls(page).get_by_role("button", name="picture").click()
    page.get_by_role("button", name="reset", exact=True).click()
    page.keyboard.press("Escape")
    assert corner(page) == plain
    assert page.evaluate("localStorage.getItem('statwalk.scene')") is not None


def saved(page: Page, save: Callable[[], object]) -> tuple[tuple[int, int], list[float]]:
    """Returns width and height, and the mean colour, of the PNG that `save` makes the page save."""
    with page.expect_download() as saving:
        save()
    data = saving.value.path().read_bytes()
    width, height = struct.unpack_from(">II", data, 16)
    return (width, height), mean_colour(page, data)


def test_a_picture_and_a_film_strip_are_saved(viewer: Page) -> None:
    """With the background of the page, or transparent: then only character and shadow are in it."""
    page = viewer
    box = page.locator("#stage-view").bounding_box()
    assert box is not None
    (width, height), colour = saved(page, lambda: page.keyboard.press("n"))
    assert (width, height) == (int(box["width"]), int(box["height"]))
    assert colour[3] == 255
    page.keyboard.press("v")
    page.get_by_label("transparent", exact=True).check()
    _, colour = saved(page, page.get_by_role("button", name="save PNG").click)
    assert 5 < colour[3] < 128
    page.keyboard.press("Escape")
    until(page, "__viewer.head() > 60")
    page.keyboard.press("k")
    (wide, high), colour = saved(page, page.get_by_role("button", name="film strip").click)
    assert wide % 8 == 0
    assert wide > 2 * width
    assert high > height
    assert colour[3] > 20  # the line of seconds has 12 of it
    until(page, "__viewer.looking() === null")


def bright(page: Page, joint: str, wide: int, high: int) -> float:
    """How bright the page's picture is at a joint and below it."""
    x, y = page.evaluate("arg => __viewer.circle(arg)", joint)
    clip = {"x": x - wide / 2, "y": y, "width": wide, "height": high}
    return sum(mean_colour(page, page.screenshot(clip=clip))[:3])


def test_exposure_shadow_and_a_gradient_change_the_picture(
    server: Server, page: Page, opened: Callable[[str], Page]
) -> None:
    """The character is brighter or dark; ground without a shadow is brighter; a gradient ends darker."""
    standing = {"clock": "manual", "actors": [{"machine": "faq-walker"}]}
    made = httpx.post(f"{server.url}/api/stages", json=standing, timeout=60).raise_for_status()
    page.emulate_media(color_scheme="light")  # on dark ground a shadow is hard to measure
    opened(f"{server.url}/?stage={made.json()['id']}")
    page.keyboard.press("v")
    shin, ground = ("Right.lowerleg", 12, 20), ("Left.foot", 80, 30)
    leg, shaded = bright(page, *shin), bright(page, *ground)
    exposure = page.get_by_label("exposure", exact=True)
    exposure.press("End")
    wait_for(lambda: bright(page, *shin) > 1.2 * leg)
    exposure.press("Home")
    wait_for(lambda: bright(page, *shin) < 0.5 * leg)
    page.get_by_role("button", name="reset", exact=True).click()
    wait_for(lambda: bright(page, *shin) == leg)
    page.get_by_label("shadow", exact=True).uncheck()
    wait_for(lambda: bright(page, *ground) > shaded + 20)
    page.get_by_label("background", exact=True).select_option("gradient")
    page.get_by_label("colour", exact=True).fill("#00ff00")
    red, green, blue, _ = corner(page)
    assert (red, blue) == (0, 0)
    assert 115 < green < 200
    leave(page, f"{server.url}{made.headers['Location']}")
