"""One order for all tests: those of a real browser come last, since Playwright keeps an event loop running;
the file that compiles everything for other processors comes first, so that no worker waits for it at the end.

What did not run is said.
"""

import gc
import os
import tempfile
from collections import Counter

import pytest

LONGEST = "test_targets.py"
os.environ["XDG_DATA_HOME"] = tempfile.mkdtemp(prefix="statwalk-tests-")
"""a data folder for this run: tests read and write nothing in the data folder of the person who runs them"""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    items.sort(key=lambda item: ("browser" in item.path.parts, item.path.name != LONGEST))


def pytest_collection_finish() -> None:
    """Keeps the loaded modules and tests out of garbage collections: each took 0.3 s longer."""
    gc.freeze()


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """A line for each reason why tests were left out, so that nobody takes them for passed."""
    reports = terminalreporter.getreports("skipped")
    for reason, count in Counter(report.longrepr[2].removeprefix("Skipped: ") for report in reports).items():
        terminalreporter.write_line(
            f"{count} {'test' if count == 1 else 'tests'} did not run: {reason}", yellow=True
        )
