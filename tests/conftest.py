"""One order for all tests: the file that compiles everything for other processors comes first, so that no
worker waits for it at the end. Files that open a browser are spread among the others: two browsers at once
are no faster than one after the other, but one beside other tests is.

What did not run is said.
"""

import os
import tempfile
from collections import Counter

import pytest

LONGEST = "maths/test_targets.py"
os.environ["XDG_DATA_HOME"] = tempfile.mkdtemp(prefix="statwalk-tests-")
"""a data folder for this run: tests read and write nothing in the data folder of the person who runs them"""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    files = dict.fromkeys(item.path for item in items)
    places = {}
    for opens_a_browser in (False, True):
        group = [file for file in files if ("browser" in file.parts) == opens_a_browser]
        places |= {file: number / len(group) for number, file in enumerate(group)}
    items.sort(key=lambda item: (not item.path.match(LONGEST), places[item.path]))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """A line for each reason why tests were left out, so that nobody takes them for passed."""
    reports = terminalreporter.getreports("skipped")
    for reason, count in Counter(report.longrepr[2].removeprefix("Skipped: ") for report in reports).items():
        terminalreporter.write_line(
            f"{count} {'test' if count == 1 else 'tests'} did not run: {reason}", yellow=True
        )
