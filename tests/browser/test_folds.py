"""Sub-machines are folded to one line of the table and one box of the graph."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page

MACHINE = """
semantics: 1
character: faq-walker
initial: STAND
states:
  STAND: {motion: stand, loop: true}
  GO:
    machine:
      initial: START
      states:
        START: {motion: start-walk}
        WALK: {motion: walk, loop: true}
      table: |
        state | END
        START | WALK
        WALK  |
table: |
  state | FORWARD | STOP
  STAND | GO      |
  GO    |         | STAND
keys:
  ArrowUp: {press: FORWARD}
  ArrowDown: {press: STOP}
"""
STATES = "[...document.querySelectorAll('#graph .state')].map(state => state.dataset.state).sort().join()"
ROWS = "[...document.querySelectorAll('#table tbody th')].map(head => head.innerText.trim()).join()"


@pytest.fixture(scope="module")
def nested(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    folder: Path = tmp_path_factory.mktemp("own") / "nested"
    folder.mkdir()
    (folder / "machine.yaml").write_text(MACHINE)
    with Server(folder.parent / "data", folder) as running:
        yield running


@pytest.fixture
def walks(nested: Server, opened: Callable[[str], Page]) -> Page:
    """The page with the machine, which walks: its state is in the sub-machine."""
    page = opened(nested.url)
    page.wait_for_selector("#graph .state[data-state='GO.WALK']")
    page.keyboard.press("ArrowUp")
    until(page, "__viewer.state() === 'GO.WALK'")
    return page


def test_the_table_has_one_line_for_a_folded_sub_machine(walks: Page) -> None:
    walks.locator("#table .fold").click()
    until(walks, f"{ROWS} === 'STAND,GO, 2 states'")
    walks.wait_for_selector("#table tr.outer[aria-current]")
    assert walks.evaluate("document.activeElement.dataset.fold") == "GO"


def test_the_graph_has_one_box_for_a_folded_sub_machine(walks: Page) -> None:
    walks.locator("#graph").hover()
    walks.get_by_role("button", name="fold all sub-machines").click()
    until(walks, f"{STATES} === 'GO,STAND'")
    walks.wait_for_selector("#graph .state.folded.live[data-state=GO]")
    walks.wait_for_selector("#graph .edge[data-from=GO][data-to=STAND]")
    walks.locator("#graph .state.folded").dblclick()
    until(walks, f"{STATES} === 'GO.START,GO.WALK,STAND'")


def test_a_reloaded_page_has_it_folded_still(walks: Page) -> None:
    walks.locator("#table .fold").click()
    until(walks, f"{STATES} === 'GO,STAND'")
    walks.reload()
    until(walks, f"window.__viewer?.ready && {STATES} === 'GO,STAND'")
