"""Fingers on a page: one that drags or stays, and two that pinch."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from playwright.sync_api import CDPSession, Locator, Page

Place = tuple[float, float]


def _touch(session: CDPSession, kind: str, places: Iterable[Place]) -> None:
    points = [{"x": x, "y": y, "id": finger} for finger, (x, y) in enumerate(places)]
    session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})


def swipe(page: Page, *paths: list[Place]) -> None:
    """Moves a finger along each path, in pixels, all at the same time; the paths are of one length."""
    session = page.context.new_cdp_session(page)
    for number, places in enumerate(zip(*paths, strict=True)):
        _touch(session, "touchMove" if number else "touchStart", places)
    _touch(session, "touchEnd", [])


@contextmanager
def pressed(page: Page, place: Place) -> Iterator[None]:
    """Keeps a finger on a place."""
    session = page.context.new_cdp_session(page)
    _touch(session, "touchStart", [place])
    yield
    _touch(session, "touchEnd", [])


def line(begin: Place, end: Place, steps: int = 8) -> list[Place]:
    """Returns a straight path."""
    parts = [step / steps for step in range(steps + 1)]
    return [(begin[0] + part * (end[0] - begin[0]), begin[1] + part * (end[1] - begin[1])) for part in parts]


def inside(place: Locator, right: float = 0.5, down: float = 0.5) -> Place:
    """Returns where a share of an element's width and height is, in pixels."""
    box = place.bounding_box()
    assert box is not None
    return box["x"] + right * box["width"], box["y"] + down * box["height"]


def pinched(place: Locator, apart: float) -> tuple[list[Place], list[Place]]:
    """Returns the paths of two fingers in the middle of an element: from 40 pixels apart to `apart`."""
    x, y = inside(place)
    return line((x - 20, y), (x - apart / 2, y)), line((x + 20, y), (x + apart / 2, y))
