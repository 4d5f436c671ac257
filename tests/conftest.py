"""One order for all tests: those of a real browser come last, since Playwright keeps an event loop running."""

import pytest


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    items.sort(key=lambda item: "browser" in item.path.parts)
