"""A real server in a process of its own, and a real browser that looks at its page.

Playwright's synchronous interface keeps an event loop running; these tests come last (see tests/conftest.py).
"""

import re
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self
from zlib import crc32

import httpx
import pytest
from browser.chromium import launched
from paths import GLTF, ROOT
from playwright.sync_api import Browser, ConsoleMessage, Locator, Page

REPORT_VIOLATIONS = (
    "window.violations = []; addEventListener('securitypolicyviolation', e => "
    "violations.push(e.violatedDirective + ' ' + e.blockedURI))"
)
SIZES = [{"width": 960, "height": 640}, {"width": 1024, "height": 700}, {"width": 1440, "height": 900}]
WIDE = {"width": 1280, "height": 900}


UNTIL = """async arg => {
  const start = performance.now();
  while (!(CONDITION)) {
    if (performance.now() - start > 60000) {
      const v = window.__viewer;
      const where = v ? ` at tick ${v.tick()} in ${v.state()}, line ${v.link()}` : '';
      throw new Error('waited for ' + `CONDITION` + where);
    }
    await new Promise(done => setTimeout(done, 20));
  }
}"""


def until(page: Page, condition: str, arg: object = None) -> None:
    """Waits until `condition` (JavaScript, over `arg`) is true; Playwright's own way needs eval, which the
    page's policy forbids.
    """
    page.evaluate(UNTIL.replace("CONDITION", condition), arg)


@contextmanager
def passing(page: Page, state: str) -> Iterator[None]:
    """Waits, after what a test does, until the watched actor has been in a state, however briefly: a busy
    page skips frames, but knows all changes of state.
    """
    before = page.evaluate("__viewer.head()")
    yield
    has_been = "__viewer.lanes().some(([, last, state]) => state === arg.state && last > arg.before)"
    until(page, has_been, {"state": state, "before": before})


def controls(page: Page, name: str = "look") -> Locator:
    """The controls over the picture that the button of this name opens, open."""
    box = page.locator(f"#{name}-popover")
    if not box.is_visible():
        page.locator("#modes").get_by_role("button", name=name, exact=True).click()
    return box


def expression_value(name: str) -> str:
    """JavaScript for the value that the page shows beside the expression of a channel or a variable."""
    row = (
        "[...document.querySelectorAll('#expressions li')]"
        f".find(row => row.querySelector('b span').textContent === '{name}')"
    )
    return f"Number({row}?.querySelector('output').textContent)"


MEAN_COLOUR = """async bytes => {
  const image = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: 'image/png' }));
  const pen = new OffscreenCanvas(image.width, image.height).getContext('2d');
  pen.drawImage(image, 0, 0);
  const { data } = pen.getImageData(0, 0, image.width, image.height);
  return [0, 1, 2, 3].map(channel => data.filter((_, k) => k % 4 === channel).reduce((a, b) => a + b, 0)
    / (image.width * image.height));
}"""


def mean_colour(page: Page, png: bytes) -> list[float]:
    """The mean red, green, blue and opacity of a picture, 0…255; the page reads it."""
    found: list[float] = page.evaluate(MEAN_COLOUR, list(png))
    return found


def slowed(server: "Server", page: Page, speed: float) -> None:
    """Returns when the page's stage has this speed."""
    stage = page.evaluate("__viewer.stage()")
    httpx.post(f"{server.url}/api/stages/{stage}/speed", json={"speed": speed}).raise_for_status()


def leave(page: Page, *made: str) -> None:
    """Closes the page before it can ask for what is deleted: these addresses."""
    page.goto("about:blank")
    for url in made:
        httpx.delete(url).raise_for_status()


class Server:
    """`statwalk serve` on a port and with a data folder of its own; `start` again after `stop` takes the same
    ones.
    """

    def __init__(self, data: Path, *more: Path | str) -> None:
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.url = f"http://127.0.0.1:{self.port}"
        options = ["--port", str(self.port), "--data", str(data)]
        self.command = [sys.executable, "-m", "statwalk.cli", "serve", *options, *map(str, more)]
        self.link = ""
        self.process: subprocess.Popen[str] | None = None

    def start(self) -> None:
        """Returns when the server has printed its address, which is then its `link`."""
        self.process = subprocess.Popen(
            self.command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=ROOT
        )
        assert self.process.stdout is not None
        printed = []
        for line in self.process.stdout:
            printed.append(line)
            if re.search(rf":{self.port}\b", line):
                self.link = line.split()[1]
                return
        pytest.fail("the server did not start:\n" + "".join(printed))

    def stop(self) -> None:
        self.end(signal.SIGTERM)

    def kill(self) -> None:
        self.end(signal.SIGKILL)

    def end(self, by: signal.Signals) -> None:
        if self.process is None:
            return
        self.process.send_signal(by)
        assert self.process.stdout is not None
        self.process.stdout.close()
        self.process.wait(60)
        self.process = None

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """The server as `statwalk serve` starts it."""
    with Server(tmp_path_factory.mktemp("data")) as running:
        yield running


@pytest.fixture(autouse=True)
def tidy(server: Server) -> Iterator[None]:
    """Closes the stages that a test leaves behind, after its page: they would step beside all others; on
    `main` time goes on, and who walks there stops, so that every test begins with a walker who stands.
    """
    yield
    if server.process is not None:
        for stage in httpx.get(f"{server.url}/api/stages").json():
            if stage["id"] == "main":
                httpx.post(f"{server.url}/api/stages/main/pause", json={"paused": False})
                if any(actor["state"] != "STAT" for actor in stage["actors"]):
                    httpx.post(f"{server.url}/api/stages/main/events", json={"event": "STOP"})
            else:
                httpx.delete(f"{server.url}/api/stages/{stage['id']}")


@pytest.fixture(scope="session")
def robot_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server whose first machine was made from a real model by `statwalk new`."""
    folder = tmp_path_factory.mktemp("made") / "robot"
    made = [sys.executable, "-m", "statwalk.cli", "new", str(GLTF / "RobotExpressive.glb"), str(folder)]
    subprocess.run(made, check=True, capture_output=True, cwd=ROOT)
    with Server(folder.parent / "data", folder) as running:
        yield running


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    with launched() as chromium:
        yield chromium


@pytest.fixture
def allowed() -> list[str]:
    """Parts of console errors that a test expects; it adds to the list."""
    return []


@pytest.fixture
def window(request: pytest.FixtureRequest) -> dict[str, Any]:
    """The size and theme of a page's window: each of the six pairs is seen by about a sixth of the tests."""
    pair = crc32(request.node.name.encode())
    return {"viewport": SIZES[pair // 2 % len(SIZES)], "color_scheme": ("light", "dark")[pair % 2]}


@pytest.fixture
def page(browser: Browser, allowed: list[str], window: dict[str, Any]) -> Iterator[Page]:
    """A page of its own, in whose life nothing went wrong: no error, no dialog, no breach of the content
    security policy.
    """
    context = browser.new_context(**window, reduced_motion="reduce")
    shown = context.new_page()
    shown.set_default_timeout(60_000)
    shown.add_init_script(REPORT_VIOLATIONS)
    wrong: list[str] = []

    def heard(message: ConsoleMessage) -> None:
        if message.type == "error" and not any(part in message.text for part in allowed):
            wrong.append(f"{message.text} {message.location.get('url', '')}")

    shown.on("console", heard)
    shown.on("pageerror", lambda error: wrong.append(str(error)))
    shown.on("dialog", lambda dialog: (wrong.append(f"dialog {dialog.message}"), dialog.dismiss()))
    yield shown
    wrong += shown.evaluate("window.violations ?? []")
    context.close()
    assert wrong == []


@pytest.fixture
def most_fps() -> int:
    """How often an opened page draws in a second. Few tests look at drawings; without a graphics card each
    takes the time of the processors for which server, page and tests wait.
    """
    return 6


@pytest.fixture
def opened(page: Page, most_fps: int) -> Callable[[str], Page]:
    """Opens an address and waits until the character was drawn."""

    def open_at(url: str) -> Page:
        page.goto(f"{url}{'&' if '?' in url else '?'}fps={most_fps}")
        until(page, "window.__viewer?.ready")
        return page

    return open_at


@pytest.fixture
def opened_wide(page: Page, opened: Callable[[str], Page]) -> Callable[[str], Page]:
    """Opens an address in a window where the sliders and expressions of a machine are seen at once."""

    def open_at(url: str) -> Page:
        page.set_viewport_size(WIDE)
        return opened(url)

    return open_at


@pytest.fixture
def viewer(server: Server, opened: Callable[[str], Page]) -> Page:
    """The page as it opens, with its character."""
    return opened(server.url)
