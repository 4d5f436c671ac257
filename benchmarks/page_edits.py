"""Measures edits of a table of 300 states and 40 events in the page: `python benchmarks/page_edits.py` or
`… page_edits.py URL`.

The longest time between two frames while a cell's text is typed and tried, and while Enter keeps it; with the
stage paused, and while it plays (then SwiftShader draws on the processor, too). `URL`: of a running server
that shows such a machine, as an older one; else the script starts one.
"""

from __future__ import annotations

import random
import shutil
import sys
import tempfile
from pathlib import Path

import httpx
from page import CHROMIUMS, SIZE, served, wait
from playwright.sync_api import Browser, Page, sync_playwright

STATES, EVENTS, EDITS, FILLED = 300, 40, 6, 0.8
NOTE_FRAMES = """
window.gaps = [];
let last = performance.now();
(function note(now) {
  gaps.push(now - last);
  last = now;
  requestAnimationFrame(note);
})(last);"""
LONGEST = "Math.round(Math.max(...gaps.splice(0)))"


def machine_text() -> str:
    """Returns a machine file whose cells lead to states at random."""
    chance = random.Random(7)
    states, events = [f"S{k:03}" for k in range(STATES)], [f"EVENT{k:02}" for k in range(EVENTS)]

    def cells() -> list[str]:
        return [chance.choice(states) if chance.random() < FILLED else "" for _ in events]

    rows = [["state", *events], *([state, *cells()] for state in states)]
    lines = [
        "title: A large table",
        "character: faq-walker",
        f"initial: {states[0]}",
        "defaults: {when: now, blend: 0.2}",
        "states:",
        *(f"  {state}: {{motion: stand, loop: true}}" for state in states),
        "table: |",
        *("  " + " | ".join(row) for row in rows),
    ]
    return "\n".join(lines) + "\n"


def edit(page: Page, row: int) -> tuple[int, int]:
    """Edits a cell; returns the longest milliseconds between two frames while it is tried, and kept."""
    before = page.evaluate("__viewer.version()")
    page.evaluate(LONGEST)
    page.locator(f"td[data-state=S{row:03}][data-column=EVENT03]").click()
    page.keyboard.press("Control+a")
    page.keyboard.type(f"S{(row + 50) % STATES:03}")
    wait(page, "document.querySelector('#cell-inspector').dataset.trial === 'fine'")
    tried = page.evaluate(LONGEST)
    page.keyboard.press("Enter")
    wait(page, f"__viewer.version() > {before}")
    page.wait_for_timeout(600)
    kept = page.evaluate(LONGEST)
    page.keyboard.press("Escape")
    return tried, kept


def measure(browser: Browser, url: str, first_row: int, *, paused: bool) -> None:
    """Prints two lines about edits of some rows."""
    page = browser.new_page(viewport=SIZE, reduced_motion="reduce")
    page.goto(url)
    wait(page, "Boolean(window.__viewer && __viewer.ready)")
    httpx.post(f"{url}/api/stages/main/pause", json={"paused": paused}).raise_for_status()
    page.wait_for_timeout(2000)
    page.evaluate(NOTE_FRAMES)
    page.wait_for_timeout(500)
    gaps = [edit(page, first_row + k) for k in range(EDITS)]
    page.close()
    print("the stage is paused" if paused else "the stage plays, drawn by the processor")
    for words, each in zip(("tried", "kept"), zip(*gaps, strict=True), strict=True):
        print(f"  {words}: longest ms between two frames, by edit: {', '.join(map(str, each))}", flush=True)


def main(url: str = "") -> None:
    """Measures with the stage paused, and while it plays."""
    folder = Path(tempfile.mkdtemp()) / "large"
    folder.mkdir()
    (folder / "machine.yaml").write_text(machine_text())
    path = next((found for name in CHROMIUMS if (found := shutil.which(name))), None)
    with served(url, str(folder)) as address, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=["--enable-unsafe-swiftshader"])
        measure(browser, address, 3, paused=True)
        measure(browser, address, 3 + EDITS, paused=False)
        browser.close()


if __name__ == "__main__":
    main(*sys.argv[1:2])
