"""Uses the page for some minutes and prints what its memory holds.

`python benchmarks/page_memory.py --minutes 20`

A round walks, jumps, scrubs time, forks, goes back, edits a cell and undoes it, opens the text, the plot of
a joint and the look at a model, visits another machine and comes back. After each round, garbage is
collected, and the script prints the JavaScript heap, what the graphics hold, DOM nodes and listeners; then
errors of the console. Each round makes two versions of the table and a fork. The stages that nobody watches
any more are deleted: a server holds no more than 64. The list of versions gets rows. Chromium without a
graphics card, with a server of its own.
"""

from __future__ import annotations

import argparse
import shutil
import time

import httpx
from page import CHROMIUMS, SIZE, served, wait
from playwright.sync_api import CDPSession, Page, sync_playwright
from statwalk.services.library.load import shipped_machines_folder

OWN, OTHER = "memory-walker", "faq-printed"
MACHINE = "#picker select[title=machine]"
CELL = "td[data-state=WALK][data-column=CROUCH]"
WALK_S, CRAWL_S = 2, 1
MODEL = shipped_machines_folder() / "playground" / "door" / "door.glb"


def walk_and_jump(page: Page) -> None:
    """Walks, jumps out of the walk, and stops."""
    page.keyboard.down("ArrowUp")
    wait(page, "__viewer.state() === 'WALK'")
    page.wait_for_timeout(1000 * WALK_S)
    page.keyboard.press("Space")
    page.wait_for_timeout(1000 * WALK_S)
    page.keyboard.up("ArrowUp")
    wait(page, "__viewer.state() === 'STAT'")


def fork_with_ghost(page: Page) -> None:
    """Scrubs back, does something else there, compares, and goes back to the stage before."""
    before = page.evaluate("__viewer.stage()")
    bar = page.locator(".scrub")
    box = bar.bounding_box()
    assert box is not None
    for part in (0.8, 0.5, 0.7):
        bar.click(position={"x": part * box["width"], "y": box["height"] / 2})
        page.wait_for_timeout(300)
    page.keyboard.press("c")
    wait(page, f"__viewer.stage() !== '{before}' && __viewer.ready")
    page.keyboard.press("x")
    page.wait_for_timeout(1000 * CRAWL_S)
    page.keyboard.press("x")
    page.go_back()
    wait(page, f"__viewer.stage() === '{before}' && __viewer.ready")


def edit_and_undo(page: Page) -> None:
    """Edits a cell, and takes it back."""
    version = page.evaluate("__viewer.version()")
    page.click(CELL)
    page.keyboard.type("CRCH")
    page.keyboard.press("Enter")
    wait(page, f"__viewer.version() > {version}")
    page.keyboard.press("Control+z")
    wait(page, f"__viewer.version() > {version + 1}")


def choose(page: Page, machine: str) -> None:
    """Watches a stage of the machine."""
    before = page.evaluate("__viewer.stage()")
    page.locator(MACHINE).select_option(machine)
    wait(page, f"__viewer.ready && __viewer.stage() !== '{before}'")


def visit_another(page: Page) -> None:
    """Shows another machine, and the first again."""
    for machine in (OTHER, OWN):
        choose(page, machine)
        page.wait_for_timeout(1000 * CRAWL_S)


def open_panels(page: Page) -> None:
    """Reads the file's text, finds a joint, plots it, and looks at a dropped model; closes all of it."""
    page.get_by_role("button", name="versions").click()
    page.get_by_role("tab", name="YAML").click()
    page.locator(".yaml-editor .cm-line").first.wait_for()
    page.locator("#drawer-tabs").get_by_label("close").click()
    page.keyboard.press("Control+k")
    page.keyboard.type("head joint show")
    page.keyboard.press("Enter")
    page.locator("#joint").get_by_role("button", name="plot").click()
    page.wait_for_timeout(1000 * CRAWL_S)
    page.keyboard.press("Escape")
    with page.expect_file_chooser() as chosen:
        page.get_by_role("button", name="add your own character").first.click()
    chosen.value.set_files(MODEL)
    page.get_by_role("button", name="Make a machine").wait_for()
    page.keyboard.press("Escape")


def delete_unwatched(url: str) -> None:
    """Deletes what the round has left behind."""
    for stage in httpx.get(f"{url}/api/stages", timeout=60).raise_for_status().json():
        if stage["id"] != "main" and not stage["viewers"]:
            httpx.delete(f"{url}/api/stages/{stage['id']}", timeout=60).raise_for_status()


ROUND = (walk_and_jump, fork_with_ghost, edit_and_undo, open_panels, visit_another)


def megabytes(page: Page, devtools: CDPSession) -> str:
    """Returns what the page holds after garbage was collected."""
    for _ in range(2):
        devtools.send("HeapProfiler.collectGarbage")
    counts = devtools.send("Memory.getDOMCounters")
    heap = devtools.send("Runtime.getHeapUsage")["usedSize"] / 1e6
    held = page.evaluate("__viewer.held()")
    return (
        f"{heap:6.1f} MB  {counts['nodes']:6d} nodes  {counts['jsEventListeners']:5d} listeners  "
        f"{held['geometries']:3d} geometries  {held['textures']:3d} textures  {held['objects']:3d} objects"
    )


def use(page: Page, url: str, devtools: CDPSession, minutes: float) -> None:
    """Plays rounds for `minutes`, and prints a line after each."""
    start, number = time.monotonic(), 0
    while time.monotonic() - start < 60 * minutes:
        for act in ROUND:
            act(page)
        delete_unwatched(url)
        number += 1
        print(
            f"{(time.monotonic() - start) / 60:5.1f} min  round {number:3d}  {megabytes(page, devtools)}",
            flush=True,
        )


def main(minutes: float) -> None:
    """Prints a line for each round, and what went wrong."""
    path = next(found for name in CHROMIUMS if (found := shutil.which(name)))
    with served("") as url, sync_playwright() as playwright:
        httpx.post(
            f"{url}/api/machines", json={"name": OWN, "copy_of": "faq-walker"}, timeout=60
        ).raise_for_status()
        browser = playwright.chromium.launch(executable_path=path, args=["--enable-unsafe-swiftshader"])
        page = browser.new_page(viewport=SIZE, reduced_motion="reduce")
        errors: list[str] = []
        page.on("console", lambda message: errors.extend([message.text] * (message.type == "error")))
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto(url)
        wait(page, "window.__viewer?.ready ?? false")
        choose(page, OWN)
        use(page, url, page.context.new_cdp_session(page), minutes)
        print(f"{len(errors)} errors in the console", *errors, sep="\n")
        browser.close()


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--minutes", type=float, default=20.0)
    main(options.parse_args().minutes)
