"""Five users, each with a server and a window of their own."""

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from browser.conftest import Server
from browser.journeys.fingers import Fingers
from browser.journeys.keyboard import Keyboard
from browser.journeys.mouse import Mouse
from browser.journeys.thumbs import Thumbs, ThumbsOnASmallPhone
from browser.journeys.user import User
from playwright.sync_api import Page


@pytest.fixture(
    scope="module",
    params=[Mouse, Keyboard, Fingers, Thumbs, ThumbsOnASmallPhone],
    ids=lambda kind: kind.__name__,
)
def kind(request: pytest.FixtureRequest) -> type[User]:
    """Names the kind of user; pytest runs all journeys of one kind before it begins with the next kind."""
    chosen: type[User] = request.param
    return chosen


@pytest.fixture(scope="module")
def fresh(kind: type[User], tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server with nothing but what is shipped; the journeys of a user leave there what they make."""
    with Server(tmp_path_factory.mktemp("journeys")) as running:
        yield running


@pytest.fixture
def window(kind: type[User]) -> dict[str, Any]:
    return kind.WINDOW


@pytest.fixture
def user(kind: type[User], fresh: Server, opened: Callable[[str], Page]) -> User:
    """A user at the address that the server prints."""
    return kind(opened(fresh.url))
