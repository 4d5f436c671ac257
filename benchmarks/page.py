"""Measures the page in a browser without a graphics card: `python benchmarks/page.py` or `… page.py URL`.

Crowds of bees and of walkers on a stage of their own: the draw calls of one drawing, counted at WebGL; the
drawings in a second while the stage runs; and the processor time that the browser takes for one, which other
programs disturb less. SwiftShader draws on the processor. `URL`: of a running server, as an older one; else
the script starts one.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx
from playwright.sync_api import Browser, Page, sync_playwright

CROWDS = [("swarm.bee", 200), ("swarm.bee", 1000), ("street.walker", 200), ("street.walker", 1000)]
SPACE_M = {"swarm.bee": 0.4, "street.walker": 1.2}
DRAWINGS, MOST_S, PATIENCE_S, OFTEN_MS = 40, 30, 240, 100
SIZE = {"width": 1280, "height": 800}
CHROMIUMS = ("chromium", "chromium-browser", "google-chrome")
COUNT_CALLS = """
window.drawCalls = 0;
for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) {
  const draw = WebGL2RenderingContext.prototype[name];
  WebGL2RenderingContext.prototype[name] = function (...facts) {
    window.drawCalls++;
    return draw.apply(this, facts);
  };
}"""
COUNTS = "[drawCalls, __viewer.stats().drawn, performance.now()]"


def browser_seconds() -> float:
    """Returns the processor time so far of the programs that this one has started (Linux)."""
    parents: dict[int, tuple[int, float]] = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rsplit(")", 1)[1].split()
        except OSError:  # it has ended
            continue
        ticks = int(fields[11]) + int(fields[12])
        parents[int(folder.name)] = int(fields[1]), ticks / os.sysconf("SC_CLK_TCK")
    own = {os.getpid()}
    while more := {process for process, (parent, _) in parents.items() if parent in own} - own:
        own |= more
    return sum(seconds for process, (_, seconds) in parents.items() if process in own)


def crowd(machine: str, count: int) -> list[dict[str, object]]:
    """Returns the actors of a stage, in a square."""
    side = round(count**0.5 + 0.5)
    step = SPACE_M[machine]
    return [
        {
            "machine": machine,
            "position": [step * (k % side - side / 2), 1.0 * ("bee" in machine), step * (k // side)],
        }
        for k in range(count)
    ]


@contextmanager
def served(url: str, *machines: str) -> Iterator[str]:
    """Gives the address of a server of some machines, which runs already if `url` says where."""
    if url:
        yield url
        return
    options = ["--port", "0", "--data", tempfile.mkdtemp()]
    command = [sys.executable, "-m", "statwalk.cli", "serve", *options, *machines]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        assert server.stdout
        found = next(match[0] for line in server.stdout if (match := re.search(r"http://[\d.:]+", line)))
        try:
            yield found
        finally:
            server.terminate()


def wait(page: Page, condition: str) -> None:
    """Waits for a condition of the page, whose policy forbids Playwright's own way."""
    end = time.monotonic() + PATIENCE_S
    while not page.evaluate(condition):
        if time.monotonic() > end:
            raise TimeoutError(condition)
        page.wait_for_timeout(OFTEN_MS)


def measure(browser: Browser, url: str, machine: str, count: int) -> None:
    """Prints a line about one crowd."""
    body = {"actors": crowd(machine, count), "seed": 1}
    stage = httpx.post(f"{url}/api/stages", json=body, timeout=PATIENCE_S).raise_for_status().json()["id"]
    with browser.new_context(viewport=SIZE, reduced_motion="reduce") as context:
        page = context.new_page()
        page.set_default_timeout(1000 * PATIENCE_S)
        page.add_init_script(COUNT_CALLS)
        began = time.monotonic()
        page.goto(f"{url}/?stage={stage}")
        wait(page, "Boolean(window.__viewer && __viewer.ready)")
        ready = time.monotonic() - began
        page.wait_for_timeout(2000)
        calls, drawn, at = page.evaluate(COUNTS)
        spent, drawings, elapsed = browser_seconds(), 0, 0.0
        while drawings < DRAWINGS and elapsed < MOST_S:
            page.wait_for_timeout(OFTEN_MS)
            calls_later, drawn_later, later = page.evaluate(COUNTS)
            drawings, elapsed = drawn_later - drawn, (later - at) / 1000
        spent = browser_seconds() - spent
        count_drawn = max(drawings, 1)
        print(
            f"{count:5} x {machine:14} {(calls_later - calls) / count_drawn:8.1f} draw calls, "
            f"{1000 * spent / count_drawn:8.1f} ms of a processor for a drawing, "
            f"{drawings / elapsed:6.2f} drawings a second, shown after {ready:5.1f} s",
            flush=True,
        )
    httpx.delete(f"{url}/api/stages/{stage}", timeout=PATIENCE_S)


def main(url: str = "") -> None:
    """Measures all crowds."""
    path = next((found for name in CHROMIUMS if (found := shutil.which(name))), None)
    with served(url, "swarm", "street") as address, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=["--enable-unsafe-swiftshader"])
        for machine, count in CROWDS:
            measure(browser, address, machine, count)
        browser.close()


if __name__ == "__main__":
    main(*sys.argv[1:2])
