"""The page while the server is slow, stands still or cannot keep anything: it says so, and then goes on."""

import os
import shutil
import signal
import subprocess
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import httpx
import pytest
from browser.conftest import Server, leave, until
from damaging import damaged
from playwright.sync_api import Page

Open = Callable[[str], Page]
WORD = "document.querySelector('#status .word').textContent"
DISK = 'mount -t tmpfs -o size=16m tmpfs "$0" && exec "$@"'
"""runs a program that alone sees a small disk at the first path"""
OWN_DISK = ["unshare", "--map-root-user", "--mount", "sh", "-c", DISK]
BLOCK = bytes(4096)


def can_mount(folder: Path) -> bool:
    """Whether this user may give a program a disk of its own (Linux, with namespaces for users)."""
    if shutil.which("unshare") is None:
        return False
    return subprocess.run([*OWN_DISK, str(folder), "true"], capture_output=True).returncode == 0


class SmallDisk(Server):
    """A server whose data folder is a disk of 16 MiB."""

    def __init__(self, data: Path) -> None:
        super().__init__(data)
        self.command = [*OWN_DISK, str(data), *self.command]
        self.data = data

    @property
    def filler(self) -> Path:
        """A file on the server's disk, as it looks from outside."""
        assert self.process is not None
        return Path(f"/proc/{self.process.pid}/root{self.data}/filler")

    def fill(self) -> None:
        """Fills the disk to the last block."""
        with self.filler.open("ab", buffering=0) as file, suppress(OSError):
            while True:
                file.write(BLOCK)

    def make_room(self) -> None:
        self.filler.unlink()


def post_until(url: str, status: int) -> httpx.Response:
    """Posts events until one is answered so."""
    while True:
        answer = httpx.post(f"{url}/api/stages/main/events", json={"event": "FORWARD"}, timeout=30)
        if answer.status_code == status:
            return answer


def test_a_full_disk_is_shown_and_forgotten_when_there_is_room(
    tmp_path: Path, opened: Callable[[str], Page]
) -> None:
    if not can_mount(tmp_path):
        pytest.skip("no disk of its own can be mounted here")
    with SmallDisk(tmp_path) as server:
        page = opened(server.url)
        until(page, f"{WORD} === 'live'")
        server.fill()
        assert "the disk is full" in post_until(server.url, 507).json()["detail"]
        until(page, f"{WORD} === 'not kept'")
        page.get_by_text("Nothing is kept now: the disk is full").wait_for()
        until(page, "document.querySelector('#status .link').title.includes('make room')")
        shown = page.evaluate("__viewer.posed()")
        until(page, "__viewer.posed() > arg + 10", shown)  # the stage goes on
        server.make_room()
        until(page, f"{WORD} === 'live'")
        page.get_by_text("Everything is kept again").wait_for()
        post_until(server.url, 202)
        leave(page)


def test_a_stage_over_its_share_is_called_slow_until_it_fits(
    tmp_path: Path, opened: Callable[[str], Page]
) -> None:
    with Server(tmp_path, "--limit", "tick_share=0.003") as server:
        page = opened(server.url)
        until(page, f"{WORD} === 'slow'")
        until(page, "document.querySelector('#status .link').title.includes('Fewer actors help')")
        httpx.post(f"{server.url}/api/stages/main/speed", json={"speed": 0.005}).raise_for_status()
        until(page, f"{WORD} === 'live'")
        leave(page)


def test_a_server_that_stands_still_is_noticed(server: Server, viewer: Page) -> None:
    until(viewer, f"{WORD} === 'live'")
    assert server.process is not None
    os.kill(server.process.pid, signal.SIGSTOP)
    try:
        until(viewer, f"{WORD} === 'no answer'")
    finally:
        os.kill(server.process.pid, signal.SIGCONT)
    until(viewer, f"{WORD} === 'live'")
    shown = viewer.evaluate("__viewer.posed()")
    until(viewer, "__viewer.posed() > arg + 10", shown)


def test_the_list_says_what_a_start_did_not_bring_back(tmp_path: Path, page: Page) -> None:
    with Server(tmp_path) as first:
        body = {"clock": "manual", "actors": [{"machine": "elbow"}]}
        stage = httpx.post(f"{first.url}/api/stages", json=body).json()["id"]
    damaged(tmp_path, f"DELETE FROM commands WHERE stage = '{stage}'")
    with Server(tmp_path) as again:
        assert [lost["id"] for lost in httpx.get(f"{again.url}/api/losses").json()["stages"]] == [stage]
        page.goto(
            f"{again.url}?fps=6"
        )  # the notice stands for some seconds, from before the character is drawn
        page.get_by_text("did not bring all back. The list of stages (O) says what").wait_for()
        until(page, "window.__viewer?.ready")
        page.keyboard.press("o")
        said = page.locator("#losses")
        said.get_by_text(f"{stage} is kept, and did not come back").wait_for()
        leave(page)
